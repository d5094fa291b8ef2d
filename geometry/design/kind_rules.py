"""Rules of kinds and patterns: what a line names exists, once for each place, and every kind can be built."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from geometry.ground.refusal import Kind, Refusal, counted
from geometry.schema.array_fields import Line, StatedArray
from geometry.schema.field_errors import conflict, nearest
from geometry.schema.kinds import PointKind

#: So that dotted names and the formulas of studies can hold them.
_KIND_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
#: Fields of the stated parts that a kind has of its own.
_OWN_FIELDS = {
    "cavity_height": "resonator.cavity_height",
    "membrane_thickness": "membrane.thickness",
    "leak_diameter": "resonator.leak_diameter",
}
#: Layouts that lay tubes of different lengths in one line.
GRADED_LAYOUTS = ("serpentine", "ring", "area", "places", "surface")

Rule = Callable[["StatedArray"], Iterable[Refusal]]


def pattern_rules(design: StatedArray) -> Iterator[Refusal]:
    """Names of kinds are names; a pattern fits its line and its layout."""
    for table in ("point_kinds", "tube_kinds"):
        for name in getattr(design, table):
            if not _KIND_NAME.fullmatch(name):
                allowed = "a name of letters, digits and _, starting with a letter"
                yield Refusal(kind=Kind.OUT_OF_RANGE, field=table, value=name, allowed=allowed)
    for number, line in enumerate(design.lines):
        if line.pattern is not None:
            yield from _pattern(design, f"lines.{number}", line)


def _pattern(design: StatedArray, field: str, line: Line) -> Iterator[Refusal]:
    pattern = line.pattern
    assert pattern is not None
    if pattern.points is None and pattern.tubes is None:
        yield Refusal(kind=Kind.MISSING, field=f"{field}.pattern", allowed="given as points, tubes or both")
    if pattern.points is not None:
        yield from _names(f"{field}.pattern.points", pattern.points, design.point_kinds, "point_kinds")
        yield from _length(f"{field}.pattern.points", pattern.points, pattern.entries(line.points), line, "point")
    if pattern.tubes is not None:
        yield from _names(f"{field}.pattern.tubes", pattern.tubes, design.tube_kinds, "tube_kinds")
        yield from _length(f"{field}.pattern.tubes", pattern.tubes, pattern.entries(line.points - 1), line, "tube")
        if line.tube is not None:
            problem = f"is not allowed beside {field}.pattern.tubes, which names every tube of the line"
            yield conflict(f"{field}.tube", problem=problem)
        if design.layout.kind not in GRADED_LAYOUTS:
            yield conflict(
                f"{field}.pattern.tubes",
                problem=f"is not allowed for layout.kind = {design.layout.kind!r}, whose tubes have one length",
                remedy=f"choose a layout.kind of: {', '.join(GRADED_LAYOUTS)}",
            )


def _names(field: str, names: Sequence[str], known: Mapping[str, object], table: str) -> Iterator[Refusal]:
    for place, name in enumerate(names):
        if name not in known:
            yield Refusal(
                kind=Kind.UNKNOWN,
                field=f"{field}.{place}",
                value=name,
                allowed=f"the name of a kind under [{table}.NAME]",
                remedy=nearest(name, list(known)) or "none is given",
            )


def _length(field: str, names: Sequence[str], needed: int, line: Line, what: str) -> Iterator[Refusal]:
    if len(names) != needed:
        places = line.points if what == "point" else line.points - 1
        half = ", the first half and the middle" if line.pattern is not None and line.pattern.mirrored else ""
        among = "" if what == "point" else "between points "
        yield conflict(
            field,
            problem=f"has {counted(len(names), 'name')} for {counted(places, what)} {among}of the line",
            remedy=f"give {needed}{half}",
        )


def kind_rules(design: StatedArray, rules: Sequence[Rule]) -> Iterator[Refusal]:
    """Problems of an array whose points are all of one kind, for each kind that the design states.

    Args:
        design: the array.
        rules: of the shell and the membrane.
    """
    for name, kind in design.point_kinds.items():
        alike = design.of_kind(name)
        for rule in rules:
            for problem in rule(alike):
                yield _of_kind(name, kind, problem)


def _of_kind(name: str, kind: PointKind, problem: Refusal) -> Refusal:
    """A problem of the stated parts as one of the kind that stands in their place."""
    facts = problem.facts()
    for own, stated in _OWN_FIELDS.items():
        if getattr(kind, own) is not None:
            for fact in ("field", "problem", "allowed"):
                facts[fact] = facts[fact].replace(stated, f"point_kinds.{name}.{own}")
    if not facts["field"].startswith("point_kinds."):
        facts["remedy"] = f"the shell is that of point_kinds.{name}"
    return Refusal(**facts)
