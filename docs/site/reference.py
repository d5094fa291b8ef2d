"""Pages of the reference, written when the site is built: Python names from the faces, verbs from the command line."""

from __future__ import annotations

import importlib
import re
import textwrap
from functools import cache
from pathlib import Path
from typing import Any

from make_architecture import Room, read_rooms
from numpy.typing import ArrayLike
from public_names import PACKAGES, Face, definition, entries, faces, kind_of, value_of
from sphinx.application import Sphinx
from sphinx.errors import PycodeError
from sphinx.pycode import ModuleAnalyzer
from sphinx.util import logging
from sphinx.util.typing import stringify_annotation

from studies.cli.verbs import VERBS, command_of

FOLDER = Path(__file__).parents[1] / "reference" / "made"
_LOG = logging.getLogger(__name__)


def setup(app: Sphinx) -> dict[str, bool]:
    """Write the pages before Sphinx looks for sources."""
    app.connect("config-inited", lambda *_: write_pages())
    app.connect("autodoc-skip-member", _skipped)
    app.connect("autodoc-process-docstring", _as_written, priority=100)  # before napoleon
    app.connect("autodoc-process-signature", _with_short_types)
    app.connect("autodoc-process-docstring", _with_colons, priority=900)  # after it
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write_pages(folder: Path = FOLDER) -> None:
    """Write a page of every face and one of all verbs; files whose text is the same stay as they are."""
    pages = {"verbs": verbs_page(), **{face.path: face_page(face) for face in faces()}}
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.rst"):
        if old.stem not in pages:
            old.unlink()
    for name, text in pages.items():
        path = folder / f"{name}.rst"
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


def face_page(face: Face) -> str:
    """Everything that a package or a room hands on; what a room of it documents is a line with a link."""
    words = (importlib.import_module(face.path).__doc__ or "").strip()
    is_package = face.path in PACKAGES
    parts = [_title(face.path, "="), re.sub(r"\n*^Stands on: .*$", "", words, flags=re.MULTILINE), ""]
    if is_package:
        rooms = [other.path for other in faces() if other.path.startswith(f"{face.path}.")]
        parts += ["Rooms:", "", *(f"- :doc:`{room} <{room}>`: {_first_line(room)}" for room in rooms), ""]
        parts += [".. toctree::", "   :hidden:", "", *(f"   {room}" for room in rooms), ""]
    known = entries()
    elsewhere = [name for name in face.names if known[f"{face.path}.{name}"] != f"{face.path}.{name}"]
    if elsewhere:
        parts += ["Handed on from rooms:", ""]
        for name in sorted(elsewhere, key=str.lower):
            parts += [f"- :py:obj:`{face.path}.{name} <{known[f'{face.path}.{name}']}>`"]
        parts.append("")
    for name, module in face.names.items():
        if name not in elsewhere:
            parts += _entry(face, name, module)
    if (room := _rooms().get(face.path)) is not None:
        parts += [_title("Modules", "-"), "For who changes the program; they may move without notice.", ""]
        parts += [f"- ``{name}``: {_plain(sentence)}" for name, sentence in room.modules]
    return "\n".join(parts) + "\n"


@cache
def _rooms() -> dict[str, Room]:
    return {room.path: room for room in read_rooms()}


def _first_line(path: str) -> str:
    words = (importlib.import_module(path).__doc__ or "").strip()
    return " ".join(words.split("\n\n")[0].split())


def _title(text: str, line: str) -> str:
    return f"{text}\n{line * len(text)}\n"


def _entry(face: Face, name: str, module: str) -> list[str]:
    """The lines of one public name."""
    value = value_of(face, name)
    kind = kind_of(value)
    if kind in ("class", "function"):
        return [f".. auto{kind}:: {face.path}.{name}", ""]
    words = comment_of(module, name)
    if not words:
        _LOG.warning("%s.%s says nothing: a comment above it that begins with #:", *definition(module, name))
    lines = [f".. py:data:: {face.path}.{name}"]
    if len(shown := repr(value)) <= 100 and " at 0x" not in shown:
        lines.append(f"   :value: {shown}")
    return [*lines, "", textwrap.indent(words, "   "), ""]


@cache
def _comments(module: str) -> dict[tuple[str, str], list[str]]:
    try:
        return ModuleAnalyzer.for_module(module).find_attr_docs()
    except PycodeError:
        return {}


def comment_of(module: str, name: str) -> str:
    """The comment of a constant, those that begin with ``#:``."""
    return "\n".join(_comments(definition(module, name)[0]).get(("", name), []))


def _skipped(app: Sphinx, what: str, name: str, value: object, skip: bool, options: object) -> bool | None:
    """Leave out what pydantic adds to its models."""
    return True if name.startswith("model_") else None


#: Stands for a colon while napoleon reads, which takes what is before the first one for a type.
_COLON = "\N{BULLET}\N{BULLET}"
_LITERAL = re.compile(r"(``.*?``|:\w+:`[^`]*`)", re.DOTALL)


def _as_written(app: Sphinx, what: str, name: str, value: object, options: object, lines: list[str]) -> None:
    """Docstrings are words with formulas: bars and stars in them are signs, and no colon begins a type."""
    parts = _LITERAL.split("\n".join(lines))
    parts[::2] = [re.sub(r"([|*])", r"\\\1", part) for part in parts[::2]]
    text = "".join(parts)
    lines[:] = (text.replace(":", _COLON) if what in ("attribute", "property") else text).split("\n")


def _with_colons(app: Sphinx, what: str, name: str, value: object, options: object, lines: list[str]) -> None:
    lines[:] = [line.replace(_COLON, ":") for line in lines]


#: NumPy's types as evaluated -> as written in the sources.
_TYPES = (
    (
        re.compile(
            r"~?numpy\.ndarray\[~?(?:builtins\.)?tuple\[~?typing\.Any, \.\.\.\], ~?numpy\.dtype\[~?numpy\.(\w+)\]\]"
        ),
        r"NDArray[\1]",
    ),
    (re.compile(re.escape(stringify_annotation(ArrayLike, "smart"))), "ArrayLike"),
)


def _with_short_types(
    app: Sphinx, what: str, name: str, value: object, options: object, signature: str | None, returns: str | None
) -> tuple[str | None, str | None]:
    texts = [signature, returns]
    for long, short in _TYPES:
        texts = [None if text is None else long.sub(short, text) for text in texts]
    return texts[0], texts[1]


def verbs_page() -> str:
    """All verbs with their arguments and options, in the order of work."""
    parts = [_title("Verbs of the command line", "=")]
    parts.append(
        "One verb per job. ``acoustic-fem VERB --help`` says the same in the terminal. Exit codes: 0; 1 with one line "
        "on stderr for what was refused; 2 for a wrong command line; 3 for a marginal design of ``check``. Each "
        "is one call of :doc:`studies <studies>`.\n"
    )
    for name in VERBS:
        verb = command_of(name)
        parts += [f".. _verb-{name}:", "", _title(name, "-"), _usage(name, verb), "", _words(verb.help or ""), ""]
        parts += _parameters(verb)
    return "\n".join(parts) + "\n"


def _usage(name: str, verb: Any) -> str:
    words = [each.metavar or f"[{each.name.upper()}]" for each in verb.params if each.param_type_name == "argument"]
    return f".. code-block:: sh\n\n   acoustic-fem {' '.join([name, *words])} [options]\n"


def _words(text: str) -> str:
    """Help in Rich's markup as reStructuredText."""
    text = re.sub(
        r"\[bold\](.*?)\[/bold\]", lambda found: f"\n\n.. code-block:: sh\n\n   {found[1]}\n\n", text, flags=re.S
    )
    return "\n".join(line if line.startswith(("..", "   ")) else _plain(line) for line in text.split("\n"))


def _plain(text: str) -> str:
    text = text.replace(r"\[", "[")  # brackets that the terminal shall not take for its markup
    return re.sub(r"([*`|\\])", r"\\\1", text).replace("[/bold]", "").replace("_ ", r"\_ ")


def _parameters(verb: Any) -> list[str]:
    lines = []
    for each in verb.params:
        if each.name == "help":
            continue
        names = ", ".join([*each.opts, *each.secondary_opts]) if each.param_type_name == "option" else ""
        title = f"``{names or each.metavar or each.name}``"
        value = each.metavar if names and each.metavar else ""
        if value:
            title += f" ``{value}``"
        notes = ["required"] if each.required else []
        shown = each.show_default if isinstance(each.show_default, str) else None
        if shown:
            notes.append(f"default: {shown}")
        elif each.show_default and each.default not in (None, ()) and not callable(each.default):
            default = ("yes" if each.default else "no") if isinstance(each.default, bool) else each.default
            notes.append(f"default: ``{default}``")
        lines += [
            title,
            f"   {_plain(' '.join((each.help or '').split()))} {'(' + '; '.join(notes) + ')' if notes else ''}",
            "",
        ]
    return lines
