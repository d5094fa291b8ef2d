"""Classes that read files, in the reference: their fields with type, range, unit and words, as the models declare them.

autodoc would show the signature that pydantic makes, which is its own machinery.
"""

from __future__ import annotations

import re
import types
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from fields import allowed, default
from public_names import definition, entries
from pydantic import BaseModel
from pydantic.fields import FieldInfo
from sphinx.application import Sphinx

from geometry.schema.declared_fields import declared_field, section_of


def setup(app: Sphinx) -> dict[str, bool]:
    """Put the fields in place of the signature."""
    app.connect("autodoc-process-signature", _without_signature, priority=400)  # the first that answers is heard
    app.connect("autodoc-process-docstring", _with_fields, priority=950)  # after those that read the docstring
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def is_model(value: object) -> bool:
    """Whether it is a class whose fields a file states."""
    return isinstance(value, type) and issubclass(value, BaseModel)


def field_lines(model: type[BaseModel]) -> list[str]:
    """reStructuredText: an entry for each of its own fields, and where those are that it has from others."""
    own = [name for name in model.model_fields if name in model.__annotations__]
    lines: list[str] = []
    for base in model.__mro__[1:]:
        if not is_model(base) or not (theirs := [name for name in base.__annotations__ if name in model.model_fields]):
            continue
        entry = _entry_of(base)
        links = (f":py:obj:`{name} <{entry}.{name}>`" if entry else f"``{name}``" for name in theirs)
        lines += [f"Fields of :py:obj:`{entry or base.__name__}`: {', '.join(links)}.", ""]
    for name in own:
        lines += _field(name, model.model_fields[name])
    return lines


def _field(name: str, info: FieldInfo) -> list[str]:
    field = declared_field(name, info)
    lines = [f".. py:attribute:: {name}", f"   :type: {type_in_words(info.annotation)}"]
    if default(field) and not field.required and field.kind != "a table":
        lines.append(f"   :value: {field.default!r}")
    notes = [field.description]
    if not field.choices and field.kind != "true or false":
        notes.append(allowed(field) if field.allowed else field.unit)
    if field.kind == "a number" and not field.unit:
        notes.append("a ratio")
    if field.required:
        notes.append("required")
    section, _ = section_of(info.annotation)
    if section is not None and _entry_of(section) is None:
        notes.append("its fields: :doc:`/design-file`")
    words = re.sub(r"([|*])", r"\\\1", "; ".join(filter(None, notes)))
    return [*lines, "", f"   {words[:1].upper()}{words[1:]}.", ""]


def type_in_words(annotation: Any) -> str:
    """An annotation without what pydantic adds to it; classes of ours by the names of their entries."""
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return type_in_words(inner[0])
    if origin in (Union, types.UnionType):
        return " | ".join(type_in_words(each) for each in inner)
    if origin is Literal:
        return f"Literal[{', '.join(map(repr, inner))}]"
    if origin is not None:
        return f"{origin.__name__}[{', '.join('...' if each is ... else type_in_words(each) for each in inner)}]"
    if annotation is type(None):
        return "None"
    return _entry_of(annotation) or annotation.__name__


def _entry_of(value: type) -> str | None:
    """The public name under which a class has its entry; None for one that no face hands on."""
    for name, entry in entries().items():
        if name == entry and name.rpartition(".")[2] == value.__name__:
            face, _, last = name.rpartition(".")
            if definition(face, last)[0] == value.__module__:
                return entry
    return None


def _without_signature(
    app: Sphinx, what: str, name: str, value: object, options: object, signature: str | None, returns: str | None
) -> tuple[str, str] | None:
    return ("", "") if what == "class" and is_model(value) else None


def _with_fields(app: Sphinx, what: str, name: str, value: Any, options: object, lines: list[str]) -> None:
    if what == "class" and is_model(value):
        lines += ["", *field_lines(value)]
