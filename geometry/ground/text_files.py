"""Text files that a user gives, read with one line for whatever is wrong with them."""

from __future__ import annotations

import json
import os
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from geometry.ground.file_checks import read_bytes
from geometry.ground.refusal import Kind, Refusal

UTF_8 = "utf-8-sig"
"""Encoding of our texts: UTF-8, with or without a byte order mark."""
LARGEST_TEXT = 1_000_000
"""Most bytes of a text; a design of a hundred lines has ten thousand."""
_DEEPEST = 32  # levels of lists and tables in a file, and parts of a dotted key; designs and studies have five
#: Most parts of all dotted keys of a file together: our largest designs have a few hundred.
_MOST_PARTS = 50_000
#: What no text of a file may hold: controls but for tab and line ends, marks that turn the line, halves of a letter.
_UNSEEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")
#: Pieces of TOML by which dotted keys are found: remarks, texts, dots, what no dotted key goes across, and the quotes
#: of a text without an end.
_PIECES = re.compile(
    r"""\#[^\n]*|"{3}(?:[^"\\]|\\.|"{1,2}(?!"))*+"{3,5}|'{3}(?:[^']|'{1,2}(?!'))*+'{3,5}|(?P<open>"{3}|'{3})"""
    r"""|"(?:[^"\\\n]|\\[^\n])*+"|'[^'\n]*+'|(?P<dot>\.)|(?P<end>[\n=,{}\[\]"'])""",
    re.DOTALL,
)


def read_text(path: str | os.PathLike[str], what: str, refusal: type[Refusal]) -> str:
    """The text of a file in UTF-8, with or without a byte order mark.

    Args:
        path: the file.
        what: such as ``a design file``, for messages.
        refusal: class of the errors.

    Raises:
        Refusal: of that class: no ordinary file that can be read, too large, or not in UTF-8.
    """
    content = read_bytes(path, what, refusal, LARGEST_TEXT)
    if encoding_of(content) != UTF_8:
        problem = f"is a text in UTF-16; {what} must be in UTF-8"
        raise refusal(problem, kind=Kind.UNREADABLE, file=path, remedy="save it as UTF-8")
    try:
        return content.decode(UTF_8)
    except UnicodeDecodeError as error:
        problem = f"byte {error.start} is not UTF-8; {what} must be a text in UTF-8"
        raise refusal(problem, kind=Kind.UNREADABLE, file=path, remedy="save it as UTF-8") from None


def encoding_of(beginning: bytes) -> str:
    """Encoding of a text that begins with an ASCII character: UTF-16, with or without a byte order mark, or UTF-8.

    Args:
        beginning: the first two bytes of its file, or more.
    """
    first, second = (*beginning[:2], 1, 1)[:2]
    if beginning[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return "utf-16"
    if bool(first) != bool(second):
        return "utf-16-le" if first else "utf-16-be"
    return UTF_8


def read_toml(path: str | os.PathLike[str], what: str, refusal: type[Refusal]) -> dict[str, Any]:
    """The table that a TOML file holds; arguments as for :func:`read_text`.

    Raises:
        Refusal: of that class: the file cannot be read, or is not TOML.
    """
    return parse_toml(read_text(path, what, refusal), str(Path(path)), refusal)


def parse_toml(text: str, source: str, refusal: type[Refusal]) -> dict[str, Any]:
    """The table that a TOML text holds.

    Args:
        text: the text.
        source: name of the file it comes from, put before the message.
        refusal: class of the errors.

    Raises:
        Refusal: of that class: it is not TOML, is nested too deeply, or holds a control character.
    """
    _check_dotted_keys(text, source, refusal)
    table: dict[str, Any] = _parsed(tomllib.loads, text, "TOML", source, refusal)
    return table


def parse_json(text: str | bytes, source: str, refusal: type[Refusal]) -> Any:
    """Value of a JSON text; arguments as for :func:`parse_toml`.

    Raises:
        Refusal: of that class: it is not JSON, is nested too deeply, or holds a control character.
    """
    return _parsed(json.loads, text, "JSON", source, refusal)


def _parsed(parse: Callable[[Any], Any], text: object, what: str, source: str, refusal: type[Refusal]) -> Any:
    try:
        value = parse(text)
    except RecursionError:
        raise _too_deep(source, refusal) from None
    except ValueError as error:  # errors of the parser, numbers with too many digits, and bytes that are no UTF-8
        raise refusal(f"is not {what}: {error}", kind=Kind.UNREADABLE, file=source) from None
    _check_plain(value, source, refusal)
    return value


def _check_dotted_keys(text: str, source: str, refusal: type[Refusal]) -> None:
    """Refuse a key of very many parts before it is parsed: the parser takes memory by the square of their number."""
    if text.count(".") <= _MOST_PARTS and all(line.count(".") < _DEEPEST for line in text.split("\n")):
        return
    parts, total = 1, 0
    for piece in _PIECES.finditer(text):
        if piece["open"]:  # up to the end of the file: the parser says so
            return
        if piece["end"]:
            parts = 1
        elif piece["dot"]:
            parts, total = parts + 1, total + 1
            if parts > _DEEPEST:
                line = text.count("\n", 0, piece.start()) + 1
                problem = f"has a key of more than {_DEEPEST} parts in line {line}"
                raise refusal(problem, kind=Kind.UNREADABLE, file=source)
            if total > _MOST_PARTS:
                problem = f"has dotted keys of more than {_MOST_PARTS} parts together"
                raise refusal(problem, kind=Kind.UNREADABLE, file=source)


def _check_plain(value: Any, source: str, refusal: type[Refusal]) -> None:
    """Refuse what no file of ours can mean and no code of ours should meet: depth or integers without end, controls."""
    level = [("", value)]
    for _ in range(_DEEPEST + 1):
        inner: list[tuple[str, Any]] = []
        for place, each in level:
            if isinstance(each, dict):
                for key, within in each.items():
                    inner.append((f"{place}.{key}" if place else key, within))
                    if _UNSEEN.search(key):
                        raise _hidden(source, place, key, refusal)
            elif isinstance(each, list):
                inner += [(f"{place}.{index}", within) for index, within in enumerate(each)]
            elif isinstance(each, str):
                if _UNSEEN.search(each):
                    raise _hidden(source, place, each, refusal)
            elif isinstance(each, int) and not -(2**63) <= each < 2**63:
                problem = "has an integer of more than 64 bits"
                raise refusal(problem, kind=Kind.UNREADABLE, file=source, field=place)
        if not inner:
            return
        level = inner
    raise _too_deep(source, refusal)


def _hidden(source: str, place: str, text: str, refusal: type[Refusal]) -> Refusal:
    allowed = "a text without control characters"
    return refusal(kind=Kind.UNREADABLE, file=source, field=place, value=text, allowed=allowed)


def _too_deep(source: str, refusal: type[Refusal]) -> Refusal:
    return refusal(f"has lists or tables more than {_DEEPEST} levels deep", kind=Kind.UNREADABLE, file=source)
