"""Rules of stated places and of the side at which the microphones lie."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from geometry.ground.refusal import Kind, Refusal, counted
from geometry.plan import sides, tube_descent
from geometry.plan.routing import directions, routed_path
from geometry.schema.array_fields import PointPlace, StatedArray
from geometry.schema.field_errors import conflict
from geometry.schema.part_fields import Tube

#: Kinds of layouts whose microphones may lie at each side.
_WITH_SIDES = {
    **dict.fromkeys(("left", "right"), ("serpentine", "places")),
    **dict.fromkeys(("front", "back"), ("serpentine", "cylinder", "places")),
    "below": ("serpentine", "places"),
}


def places_rules(design: StatedArray) -> Iterator[Refusal]:
    """Each point of a layout of places has one, within reach of the tube before it."""
    layout = design.layout
    if layout.kind != "places":
        if layout.places:
            problem = f"goes with layout.kind = 'places', not {layout.kind!r}"
            yield conflict("layout.places", problem=problem)
        return
    if len(layout.places) != design.point_count:
        yield conflict(
            "layout.places",
            problem=f"has {counted(len(layout.places), 'place')} for {counted(design.point_count, 'point')}",
            remedy="give one for each point, in the order of the lines",
        )
        return
    if layout.pitch is not None:
        problem = "is not allowed for layout.kind = 'places', which states where each point is"
        yield conflict("layout.pitch", layout.pitch, problem=problem)
        return
    places, first = layout.places, 0
    for line in design.lines:
        own = places[first : first + line.points]
        for number, (tube, (one, other)) in enumerate(
            zip(design.segments_of(line), pairwise(own), strict=True), first + 1
        ):
            if problem := _step(design, tube, one, other):
                yield conflict(f"layout.places.{number}", problem=problem)
                return
        first += line.points


def _step(design: StatedArray, tube: Tube, one: PointPlace, other: PointPlace) -> str:
    """Why a tube does not lead from one place to the next; empty where it does."""
    resonator = design.resonator
    apart = math.hypot(other.x - one.x, other.y - one.y)
    least, most = resonator.outer_diameter, resonator.cavity_diameter + tube.length
    if not least - 1e-9 <= apart <= most + 1e-9:
        return (
            f"is {apart:.4g} mm from the point before it; it must be between {least:g} mm, where shells touch, and "
            f"{most:g} mm, where the tube is straight"
        )
    if one.angle is None and other.angle is None:
        return ""
    starts = (np.array([one.x, one.y]), np.array([other.x, other.y]))
    leaving, arriving = directions(starts, one.angle, other.angle)
    try:
        routed_path((starts[0], leaving), (starts[1], arriving), resonator.cavity_diameter / 2, least / 2, tube.length)
    except Refusal as error:
        return f"needs a tube of {error.allowed} to lie in the stated directions; it is {tube.length:g} mm long"
    return ""


def side_rules(design: StatedArray) -> Iterator[Refusal]:
    """Microphones at a side need a layout whose line ends there, or room below."""
    layout, field = design.layout, "layout.microphone_side"
    side = layout.microphone_side
    if side != "below" and layout.depth is not None:
        problem = f"goes with layout.microphone_side = 'below', not {side!r}"
        yield conflict("layout.depth", layout.depth, problem=problem)
        return
    if side == "ends":
        return
    if layout.kind not in _WITH_SIDES[side]:
        problem = f"goes with layout.kind = {' or '.join(map(repr, _WITH_SIDES[side]))}, not {layout.kind!r}"
        yield conflict(field, side, problem=problem, unit="")
        return
    if len(design.lines) > 1:
        problem = f"needs two microphones on one line; the design has {len(design.lines)} lines"
        yield conflict(field, side, problem=problem, unit="", remedy="use 'ends'")
        return
    if side == "below":
        yield from _below(design)
    elif layout.kind == "serpentine":
        yield from _both_ends_there(design)
    elif layout.kind == "cylinder" and sides.grid_of_line(design)[1] > 1:
        problem = "needs all points of a cylinder in one row around it"
        remedy = f"set layout.columns = {design.point_count}, or use 'ends'"
        yield conflict(field, side, problem=problem, unit="", remedy=remedy)


def _both_ends_there(design: StatedArray) -> Iterator[Refusal]:
    """A line that runs to and fro ends where it began after an even number of full passes."""
    if not sides.has_turned_rows(design):
        return
    columns, rows = sides.grid_of_line(design)
    side = design.layout.microphone_side
    passes, words = (columns, "columns") if side in ("front", "back") else (rows, "rows")
    if passes % 2 or columns * rows != design.point_count:
        yield conflict(
            "layout.microphone_side",
            side,
            problem=(
                f"needs an even number of full {words}, so that both ends of the line lie there; the layout has "
                f"{design.point_count} points in {rows} rows of {columns}"
            ),
            unit="",
            remedy="change layout.columns, or use 'below'",
        )


def _below(design: StatedArray) -> Iterator[Refusal]:
    """Housings are under the shells, and tubes bend in two quarter circles on their way down."""
    least = tube_descent.usual_depth(design)
    if design.layout.depth is not None and design.layout.depth < least - 1e-9:
        allowed = f"at least {math.ceil(100 * least - 1e-6) / 100:g} mm for the housings to pass below the shells"
        yield conflict("layout.depth", design.layout.depth, allowed)
    if design.shell.feet:
        yield Refusal(
            "must be 0 for layout.microphone_side = 'below', where feet would stand on the housings",
            kind=Kind.CONFLICT,
            field="shell.feet",
            value=design.shell.feet,
        )
