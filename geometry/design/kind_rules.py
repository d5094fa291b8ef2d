"""Rules of kinds and patterns: what a line names exists, once for each place, and every kind can be built."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from geometry.ground.refusal import counted
from geometry.schema.array_fields import Line, StatedArray
from geometry.schema.field_errors import nearest
from geometry.schema.kinds import PointKind

#: So that dotted names and the formulas of studies can hold them.
_KIND_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
#: Fields of the stated parts that a kind has of its own.
_OWN_FIELDS = {"cavity_height": "resonator.cavity_height", "membrane_thickness": "membrane.thickness"}
#: Layouts that lay tubes of different lengths in one line.
_GRADED_LAYOUTS = ("serpentine", "ring", "area")

Rule = Callable[["StatedArray"], Iterable[str]]


def pattern_rules(design: StatedArray) -> Iterator[str]:
    """Names of kinds are names; a pattern fits its line and its layout."""
    for table in ("point_kinds", "tube_kinds"):
        for name in getattr(design, table):
            if not _KIND_NAME.fullmatch(name):
                yield f"{table}: {name!r} must be a name of letters, digits and _ that starts with a letter"
    for number, line in enumerate(design.lines):
        if line.pattern is not None:
            yield from _pattern(design, f"lines.{number}", line)


def _pattern(design: StatedArray, field: str, line: Line) -> Iterator[str]:
    pattern = line.pattern
    assert pattern is not None
    if pattern.points is None and pattern.tubes is None:
        yield f"{field}.pattern must give points, tubes or both"
    if pattern.points is not None:
        yield from _names(f"{field}.pattern.points", pattern.points, design.point_kinds, "point_kinds")
        yield from _length(f"{field}.pattern.points", pattern.points, pattern.entries(line.points), line, "point")
    if pattern.tubes is not None:
        yield from _names(f"{field}.pattern.tubes", pattern.tubes, design.tube_kinds, "tube_kinds")
        yield from _length(f"{field}.pattern.tubes", pattern.tubes, pattern.entries(line.points - 1), line, "tube")
        if line.tube is not None:
            yield f"{field}.tube must not be given beside {field}.pattern.tubes, which names every tube of the line"
        if design.layout.kind not in _GRADED_LAYOUTS:
            yield (
                f"{field}.pattern.tubes must not be given for layout.kind = {design.layout.kind!r}, which lays tubes "
                f"of one length; those that take others: {', '.join(_GRADED_LAYOUTS)}"
            )


def _names(field: str, names: Sequence[str], known: Mapping[str, object], table: str) -> Iterator[str]:
    for place, name in enumerate(names):
        if name not in known:
            hint = "; " + (nearest(name, list(known)) or "none is given")
            yield f"{field}.{place} = {name!r} must be the name of a kind under [{table}.NAME]{hint}"


def _length(field: str, names: Sequence[str], needed: int, line: Line, what: str) -> Iterator[str]:
    if len(names) != needed:
        places = line.points if what == "point" else line.points - 1
        half = ", the first half and the middle" if line.pattern is not None and line.pattern.mirrored else ""
        yield (
            f"{field} has {counted(len(names), 'name')}; it must have {needed}, for {counted(places, what)} "
            f"{'' if what == 'point' else 'between points '}of the line{half}"
        )


def kind_rules(design: StatedArray, rules: Sequence[Rule]) -> Iterator[str]:
    """What the rules of an array say of one whose points are all of one kind, for each kind that is stated.

    Args:
        design: the array.
        rules: of the shell and the membrane.
    """
    for name, kind in design.point_kinds.items():
        alike = design.of_kind(name)
        for rule in rules:
            for message in rule(alike):
                yield _said_of(name, kind, message)


def _said_of(name: str, kind: PointKind, message: str) -> str:
    """A message on the stated parts, said of the kind that stands in their place."""
    said = message
    for own, stated in _OWN_FIELDS.items():
        if getattr(kind, own) is not None:
            said = said.replace(stated, f"point_kinds.{name}.{own}")
    return said if said.startswith("point_kinds.") else f"point_kinds.{name}: {said}"
