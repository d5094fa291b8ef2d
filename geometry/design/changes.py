"""Changed copies of a design as plain dictionaries, by dotted names; no rule of a design is known here."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from geometry.ground.refusal import Kind
from geometry.schema.field_errors import DERIVED_FROM, UnknownField, nearest


def changed(data: Mapping[str, Any], values: Mapping[str, Any], name: str) -> dict[str, Any]:
    """Plain values of a design with some of them changed by dotted name.

    Args:
        data: tables as dictionaries, tuples or lists of tables.
        values: new values, for example ``{"tube.inner_diameter": 0.5, "lines.0.points": 6}``; a whole
            table is given as a mapping or a section, and None takes an optional field back to its default.
        name: of the design, for messages.

    Raises:
        UnknownField: no such field.
    """
    copy = dict(data)
    for field, value in values.items():
        _set(copy, field, value.model_dump() if isinstance(value, BaseModel) else value, name)
    return copy


def check_name(data: Any, name: str, source: str) -> None:
    """Refuse a dotted name at which nothing can be set.

    Args:
        data: tables as dictionaries, tuples or lists of tables.
        name: for example ``lines.0.points``.
        source: name of the design, for messages.

    Raises:
        UnknownField: no such field; the message lists those that can be set.
    """
    steps = name.split(".")
    place = data
    for depth, step in enumerate(steps):
        if place is None:
            table = ".".join(steps[:depth])
            remedy = f"give the whole table, not {name} alone"
            raise UnknownField("is not given", kind=Kind.MISSING, file=source, field=table, remedy=remedy)
        free = steps[:depth] in (["materials"], ["point_kinds"], ["tube_kinds"])  # keys are the user's own
        known = keys_of(place)
        if step not in known and not (free and depth == len(steps) - 1):
            raise UnknownField.of_name(name, source, nearest(step, known))
        place = place[int(step)] if isinstance(place, (list, tuple)) else place.get(step)


def _set(data: dict[str, Any], name: str, value: Any, source: str) -> None:
    """Put a value at a dotted name of a design; the tables that hold it are copied, all others are left as they are."""
    check_name(data, name, source)
    *tables, last = name.split(".")
    place: Any = data
    for step in tables:
        key = int(step) if isinstance(place, list) else step
        place[key] = dict(place[key]) if isinstance(place[key], dict) else list(place[key])
        place = place[key]
    if isinstance(place, list):
        place[int(last)] = value
        return
    for derived, (given, _) in DERIVED_FROM.items():
        if last == given:
            place.pop(derived, None)
    place[last] = value


def keys_of(place: Any) -> list[str]:
    """Names that may follow in a dotted name: indices of a list, keys of a table and what may stand in their place."""
    if isinstance(place, (list, tuple)):
        return [str(index) for index in range(len(place))]
    if not isinstance(place, dict):
        return []
    return [*place, *(given for derived, (given, _) in DERIVED_FROM.items() if derived in place)]


def as_lists(value: Any) -> Any:
    """A copy of plain values with every tuple as a list."""
    if isinstance(value, dict):
        return {key: as_lists(entry) for key, entry in value.items()}
    return [as_lists(entry) for entry in value] if isinstance(value, (list, tuple)) else value
