"""Fixes of a design that cannot be built as it is laid out: the nearest one that can, by one change or two."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design, value_of
from geometry.ground.refusal import Text
from geometry.layout.overlaps import OverlapError, refuse_overlaps
from geometry.layout.placement import ArrayLayout
from geometry.schema.field_errors import DesignError

#: Lengths that part bodies where they grow, and how far they are tried.
_APART = ("layout.diameter", "layout.palm", "layout.spread", "microphone_tube.length", "tube.length")
_GROWTH, _STEPS = 1.1, 14
#: Fractions of the half of a straight tube that are tried for the walls at its ends.
_WALLS = (0.95, 0.8, 0.6, 0.4)


def refuse_unbuildable(design: DesignLike, layout: ArrayLayout | None = None, unless: Text = "") -> None:
    """Refuse a design that cannot be built as it is laid out, with a change that fixes it.

    Args:
        design: the array.
        layout: layout of the array, if you have it already.
        unless: pieces of a text on what else can be done, such as how the design is drawn all the same.

    Raises:
        OverlapError: see :func:`geometry.layout.overlaps.overlaps`.
    """
    design = resolve_design(design)
    try:
        refuse_overlaps(design, layout)
    except OverlapError as error:
        fix = fix_for(design)
        pieces = (unless,) if isinstance(unless, str) else unless
        remedy = (fix, "; " if fix and unless else "", *pieces)
        raise OverlapError.of(error, others=error.others, remedy=remedy) from None


def fix_for(design: DesignLike) -> str:
    """The change of a design after which it can be built, in words; empty where none of those tried does it.

    Tried in turn, each by laying the changed design out: tubes that lie straight at the stated pitch, with thinner
    walls where these are in the way; straight tubes at their own pitch; a larger cylinder, palm or spread, longer
    tubes; thinner walls.
    """
    return fix_values(design)[0]


def fix_values(design: DesignLike) -> tuple[str, dict[str, Any]]:
    """The change of :func:`fix_for` in words and as values by dotted name; an empty text and no values where none of
    those tried does it.
    """
    design = resolve_design(design)
    return next(((words, values) for words, values in _changes(design) if _can_be_built(design, values)), ("", {}))


def _changes(design: ArrayDesign) -> Iterator[tuple[str, dict[str, Any]]]:
    """Changes in words and as values by dotted name."""
    cavity, wall, pitch = design.resonator.cavity_diameter, design.resonator.wall_thickness, design.layout.pitch
    if pitch is not None:
        straight = round(pitch - cavity, 6)
        change = f"set tube.length = {straight:g} mm (layout.pitch - resonator.cavity_diameter)"
        lengths = {"tube.length": straight}
        yield change, lengths
        for fraction in _WALLS:
            thin = round(fraction * straight / 2, 3)
            if thin < wall:
                yield (
                    f"{change} and resonator.wall_thickness below half of it, such as {thin:g} mm",
                    {**lengths, **_walls(design, thin)},
                )
        graded = any(len(design.inner_tubes_of(line)) > 1 for line in design.lines)
        own = "" if graded else f", or {cavity + design.tube.length:g} mm"
        yield (
            f"leave out layout.pitch{own}: the tubes then lie straight",
            {"layout.pitch": None},
        )
    for name in _APART:
        now = _number(design, name)
        for step in range(1, _STEPS + 1 if now is not None else 0):
            larger = float(f"{(now or 0.0) * _GROWTH**step:.3g}")
            yield f"set {name} = {larger:g} in place of {now:g}", {name: larger}
    for fraction in (0.8, 0.6, 0.4):
        thin = round(fraction * wall, 3)
        yield f"set resonator.wall_thickness = {thin:g} mm in place of {wall:g} mm", _walls(design, thin)


def _walls(design: ArrayDesign, thickness: float) -> dict[str, Any]:
    """Thinner walls of the shells, and a membrane that they carry."""
    return {
        "resonator.wall_thickness": thickness,
        "membrane.rim_width": min(design.membrane.rim_width, thickness),
    }


def _number(design: ArrayDesign, name: str) -> float | None:
    value = value_of(design, name)
    return value if isinstance(value, (int, float)) else None


def _can_be_built(design: ArrayDesign, values: dict[str, Any]) -> bool:
    try:
        changed = design.with_values(values)
        refuse_overlaps(changed)
    except DesignError:
        return False
    return True
