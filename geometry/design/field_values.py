"""Values of a design by the dotted names of its fields, as a form and a comparison list them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from pydantic import BaseModel

from geometry.design.array_design import ArrayDesign
from geometry.design.changes import as_lists
from geometry.schema.declared_fields import DesignField, fields_of

#: Tables whose entries have names of the user's own.
_NAMED_BY_USER = ("materials", "point_kinds", "tube_kinds")


def field_values(design: ArrayDesign) -> dict[str, Any]:
    """Values of all fields of a design by dotted name, in the order of its file.

    Sections that the design does not give are left out. Values are numbers, texts, truth values and lists, as JSON can
    hold them, and None for a field that may be left without a value.
    """
    return {name: as_lists(value) for name, value in _values(design, "")}


def declared_at(name: str) -> DesignField:
    """Declaration of the field of a dotted name that :func:`field_values` lists."""
    return _declared()[_general(name.split("."))]


def place_in_file(name: str) -> tuple[tuple[int, str], ...]:
    """Key that sorts dotted names as a design file lists them: by table, by number or name of an entry, by field."""
    steps, order = name.split("."), list(_declared())
    key: list[tuple[int, str]] = []
    for depth, step in enumerate(steps):
        general = _general(steps[: depth + 1])
        key.append(
            (int(step), "") if step.isdecimal() else (order.index(general), "") if general in order else (0, step)
        )
    return tuple(key)


def _general(steps: list[str]) -> str:
    """Name under which a field is declared, with ``*`` for indices and for names of the user's own."""
    own = {1} if steps[0] in _NAMED_BY_USER else set()
    return ".".join("*" if step.isdecimal() or place in own else step for place, step in enumerate(steps))


def _values(section: BaseModel, prefix: str) -> Iterator[tuple[str, Any]]:
    """Dotted names and plain values below a section; sections that are not given are left out."""
    for key in type(section).model_fields:
        value, name = getattr(section, key), prefix + key
        if isinstance(value, BaseModel):
            yield from _values(value, f"{name}.")
        elif isinstance(value, Mapping):
            for own, entry in value.items():
                yield from _values(entry, f"{name}.{own}.")
        elif isinstance(value, tuple) and value and isinstance(value[0], BaseModel):
            for number, entry in enumerate(value):
                yield from _values(entry, f"{name}.{number}.")
        elif value not in (None, ()) or declared_at(name).kind != "a table":
            yield name, value


@lru_cache(maxsize=1)
def _declared() -> dict[str, DesignField]:
    return {field.name: field for field in fields_of(ArrayDesign)}
