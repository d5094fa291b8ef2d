"""Points of a layout of places that are dragged, alone or as a row, and where the parts of an array then are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out, point_axes
from geometry.layout.placement import MicrophonePlacement, PointPlacement
from studies.panels.designing import Dragged

#: Digits behind the point of a place that was dragged, mm, and of the nearest one that is allowed.
_DIGITS, _FINE = 1, 2
#: Largest angle between a row and a step of it, degrees.
_STRAIGHT = 20.0
#: Rounds in which a place is moved out of shells and within reach of its neighbours.
_ROUNDS = 100
#: Halvings of the way to a place that is not allowed.
_HALVINGS = 14
#: Points of the course of a tube in a picture.
_COURSE = 16


def moved_places(design: ArrayDesign, index: int, by: Array, whole_row: bool) -> Dragged:
    """Design of places with a point moved, or with all points of its row, or as far as is allowed.

    Args:
        design: design at the beginning of the drag, whose layout is one of places.
        index: of the point, from 0.
        by: way in plan, (2,) float64, mm.
        whole_row: True if the points that lie on one row with the point are moved with it.
    """
    row = row_of(design, index) if whole_row else range(index, index + 1)
    axes = point_axes(design)[row.start : row.stop]
    aimed = np.round(axes + by, _DIGITS)
    refused = _refusal(design, row, aimed)
    if not refused:
        return _placed(design, row, aimed)
    if len(row) == 1:
        near = np.round(_nearest_place(design, index, aimed[0]), _FINE)[None]
        if not _refusal(design, row, near):
            return _placed(design, row, near, refused)
    good, bad = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (good + bad) / 2
        allowed = not _refusal(design, row, np.round(axes + middle * by, _FINE))
        good, bad = (middle, bad) if allowed else (good, middle)
    return (
        _placed(design, row, np.round(axes + good * by, _FINE), refused) if good else Dragged(design, refused=refused)
    )


def row_of(design: ArrayDesign, index: int) -> range:
    """Indices of the points that lie on one straight row with a point, along its line."""
    first = 0
    for line in design.lines:
        if index < first + line.points:
            break
        first += line.points
    axes = point_axes(design)[first : first + line.points]
    steps, place = np.diff(axes, axis=0), index - first
    found = range(index, index + 1)
    for own in (place, place - 1):
        if not 0 <= own < len(steps):
            continue
        aligned = [_is_along(step, steps[own]) for step in steps]
        low = high = own
        while low > 0 and aligned[low - 1]:
            low -= 1
        while high + 1 < len(steps) and aligned[high + 1]:
            high += 1
        if high - low + 2 > len(found):
            found = range(first + low, first + high + 2)
    return found


def _is_along(step: Array, other: Array) -> bool:
    """True if two steps lead in nearly the same direction."""
    return float(step @ other) >= math.cos(math.radians(_STRAIGHT)) * float(
        np.linalg.norm(step) * np.linalg.norm(other)
    )


def _values(row: Sequence[int], places: Array) -> dict[str, float]:
    return {
        f"layout.places.{k}.{name}": float(value) + 0.0
        for k, place in zip(row, places, strict=True)
        for name, value in zip("xy", place, strict=True)
    }


def _placed(design: ArrayDesign, row: Sequence[int], places: Array, refused: str = "") -> Dragged:
    values = _values(row, places)
    return Dragged(design.with_values(values), values, refused)


def _refusal(design: ArrayDesign, row: Sequence[int], places: Array) -> str:
    """Reason why points cannot stand at some places; empty where they can."""
    others = np.delete(point_axes(design), list(row), axis=0)
    numbers = np.delete(np.arange(design.point_count), list(row)) + 1
    least = design.resonator.outer_diameter
    for k, place in zip(row, places, strict=True):
        apart = np.linalg.norm(others - place, axis=1)
        if len(apart) and apart.min() < least - 1e-9:
            other = numbers[int(np.argmin(apart))]
            return f"point {k + 1} would be {apart.min():.4g} mm from point {other}; shells touch at {least:g} mm"
    try:
        design.with_values(_values(row, places))
    except Refusal as error:
        return str(error)
    return ""


def _nearest_place(design: ArrayDesign, index: int, aimed: Array) -> Array:
    """Place near another one that is out of all shells and within reach of the tubes of the point."""
    axes, least = point_axes(design), design.resonator.outer_diameter
    most = np.full(len(axes), np.inf)
    first = 0
    for line in design.lines:
        for number, tube in enumerate(design.segments_of(line), first):
            if index in (number, number + 1):
                most[number if index == number + 1 else number + 1] = design.resonator.cavity_diameter + tube.length
        first += line.points
    room, place = 2 * 10.0**-_FINE, aimed.copy()
    for _ in range(_ROUNDS):
        still = True
        for k, axis in enumerate(axes):
            way = place - axis
            apart = float(np.linalg.norm(way))
            wanted = min(max(apart, least + room), most[k] - room)
            if k != index and apart > 0 and abs(wanted - apart) > 1e-9:
                place, still = axis + way * wanted / apart, False
        if still:
            break
    return place


def parts_in_space(design: ArrayDesign, shift: Array) -> dict[str, Any]:
    """Places of the parts of an array for a picture that follows a drag, mm.

    Args:
        design: the array.
        shift: (3,) float64, mm, added to all places.

    Returns:
        ``points`` and ``microphones``: for each its origin and its normal in space, six numbers, a point's at the
        floor of its cavity and a microphone's at that of its chamber; ``tubes``: for each the points of its course.
    """
    layout = lay_out(design)
    floor = design.resonator.port_axis_height - design.microphone.chamber_height / 2

    def stands(part: PointPlacement | MicrophonePlacement, height: float = 0.0) -> list[float]:
        frame = layout.frame(part)
        return [round(float(each), 4) for each in (*(frame.at(0.0, 0.0, height) + shift), *frame.axes[2])]

    tubes = []
    for tube in layout.tubes:
        shown = tube.course[np.linspace(0, len(tube.course) - 1, min(_COURSE, len(tube.course))).round().astype(int)]
        tubes.append(np.round(shown + shift, 3).tolist())
    return {
        "points": [stands(point) for point in layout.points],
        "microphones": {each.name: stands(each, floor) for each in layout.microphones},
        "tubes": tubes,
    }
