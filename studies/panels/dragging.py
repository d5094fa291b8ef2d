"""A part of an array is dragged in its picture, or a size of it typed there: fields that follow, as far as allowed."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import value_of
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out, place_housings, point_axes
from geometry.layout.size import array_size
from geometry.plan import hand
from studies.panels.designing import Dragged, nearest_valid
from studies.panels.dragged_places import moved_places

#: Sizes that can be typed, as :func:`resized` takes them, each with its axis in space.
SIZES: dict[str, int | None] = {"x": 0, "y": 1, "z": 2, "pitch": None}
#: Steps towards the value that puts a part where it was dragged.
_STEPS = 8
#: A place that is met, mm.
_MET = 1e-6
#: Fraction of a field by which it is changed to see what moves.
_TRIAL = 1e-3
#: Fraction of a value by which the next one is refused.
_BEYOND = 0.01
#: Significant digits of a length that follows a drag.
_DIGITS = 3
#: Defaults of fields that move points.
_DEFAULTS = {"layout.palm": hand.PALM, "layout.spread": hand.SPREAD}
#: Layouts on a grid: of a drag along its rows or across them, only that part counts.
_GRIDS = ("serpentine", "cylinder", "area")
_POINT = re.compile(r"point (\d{1,4})")
_MICROPHONE = re.compile(r"microphone (.+)")
_TUBE = re.compile(r"tube (\d{1,4}) of line (\d{1,4})")

#: Place or size of a design that is measured, (n,) float64, mm.
Measure = Callable[[ArrayDesign], Array]


def dragged(design: ArrayDesign, part: str, by: Array, at: Array, whole_row: bool = False) -> Dragged:
    """Design whose part lies where it was dragged, or as near as the design's rules allow.

    One field follows a drag: the one that moves the part most nearly in its direction. Points that have places of
    their own are moved themselves.

    Args:
        design: design at the beginning of the drag.
        part: "point 3", "microphone A" or "tube 2 of line 1", as the parts of a model are grouped.
        by: way of the pointer in space, (3,) float64, mm.
        at: place in space at which the part was taken, (3,) float64, mm.
        whole_row: True if all points of a row are moved, where every point has a place of its own.

    Raises:
        Refusal: the design has no such part, or no field moves it.
    """
    if design.layout.frozen is not None:
        remedy = "change the pitch or the regions of the surface, and fit again"
        raise Refusal("stands where it was fitted to the body", kind=Kind.UNSUITABLE, field=part, remedy=remedy)
    if found := _POINT.fullmatch(part):
        index = _within(int(found[1]), design.point_count, part)
        if design.layout.kind == "places":
            return moved_places(design, index, by[:2], whole_row)
        return _moved_point(design, part, index, by)
    if found := _MICROPHONE.fullmatch(part):
        check_choice("microphone", found[1], design.microphones)
        return _moved_microphone(design, found[1], by)
    if found := _TUBE.fullmatch(part):
        line = _within(int(found[2]), len(design.lines), part)
        segment = _within(int(found[1]), design.lines[line].points + 1, part)
        return _pulled_tube(design, line, segment, by, at)
    raise Refusal(kind=Kind.OUT_OF_RANGE, field="part", value=part, allowed="a point, a microphone or a tube")


def resized(design: ArrayDesign, size: str, value: float) -> Dragged:
    """Design with a size of the whole array, or its pitch, as it was typed, or the nearest that is allowed.

    Args:
        design: the design.
        size: one of ``SIZES``.
        value: mm.

    Raises:
        Refusal: no field changes that size.
    """
    check_choice("size", size, SIZES)
    if design.layout.frozen is not None:
        remedy = "change the pitch or the regions of the surface, and fit again"
        raise Refusal("follows from the body", kind=Kind.UNSUITABLE, field=size, remedy=remedy)
    axis = SIZES[size]
    if axis is None and design.lines[0].points < 2:
        raise Refusal("needs two points on the first line", kind=Kind.UNSUITABLE, field=size)
    measure = _measure_of(size)
    fields = ["resonator.cavity_height"] if axis == 2 else list(_spacing(design))
    return _moved(design, size, fields, measure, np.array([value]) - measure(design), exact=True)


def size_of(design: ArrayDesign, size: str) -> float:
    """A size that can be typed, mm."""
    return float(_measure_of(size)(design)[0])


def _measure_of(size: str) -> Measure:
    axis = SIZES[size]
    return _first_pitch if axis is None else _extent(axis)


def _within(number: int, count: int, part: str) -> int:
    """Index of a part by its number."""
    if not 1 <= number <= count:
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="part", value=part, allowed=f"a number from 1 to {count}")
    return number - 1


# -- points ---------------------------------------------------------------------------------------------
def _moved_point(design: ArrayDesign, part: str, index: int, by: Array) -> Dragged:
    """The spacing follows a point. The point at which a layout begins never moves, so the farthest one is held."""
    housings = place_housings(design)
    way = np.asarray(housings.frame(housings.points[index]).axes)[:2] @ by
    axes = point_axes(design)
    fields = list(_spacing(design))
    if len(axes) == 1 or np.linalg.norm(axes[index]) > _MET:
        return _moved(design, part, fields, lambda changed: point_axes(changed)[index], way)
    far = int(np.argmax(np.linalg.norm(axes - axes[index], axis=1)))
    found = _moved(design, part, fields, _between(far, index), way)
    return replace(found, anchor=far)


def _between(start: int, end: int) -> Measure:
    """Way in plan from one point to another, by their indices."""

    def seen(changed: ArrayDesign) -> Array:
        axes = point_axes(changed)
        return np.asarray(axes[end] - axes[start])

    return seen


def _spacing(design: ArrayDesign) -> Iterator[str]:
    """Fields that move the points of a layout."""
    if design.layout.pitch is not None:
        yield "layout.pitch"
    else:
        names = (name for line in range(len(design.lines)) for name in design.tube_fields_of(line)[1:-1])
        yield from (_length_of(name) for name in dict.fromkeys(names))
    if design.layout.kind == "hand":
        yield from ("layout.palm", "layout.spread")


def _length_of(tube: str) -> str:
    """Field of the length of a tube, by a name of ``tube_fields_of``."""
    return tube if ".lengths." in tube else f"{tube}.length"


def _extent(axis: int) -> Measure:
    """Extent of the array along an axis."""
    return lambda design: np.array([array_size(design, lay_out(design))[axis]])


def _first_pitch(design: ArrayDesign) -> Array:
    """Distance of the first two points."""
    return np.array([np.linalg.norm(_between(0, 1)(design))])


# -- microphones and tubes ------------------------------------------------------------------------------
def _moved_microphone(design: ArrayDesign, name: str, by: Array) -> Dragged:
    """A microphone goes to the side to which it was dragged; on its own side, the length of its tube follows."""
    housings = place_housings(design)
    microphone = next(each for each in housings.microphones if each.name == name)
    way = np.asarray(housings.frame(microphone).axes)[:2] @ by
    stated, seen = design.layout.microphone_side, _side_of(design, np.array(microphone.position))
    side = _side_of(design, np.array(microphone.position) + way)
    far = (
        float(np.linalg.norm(way)) > design.resonator.outer_diameter / 2
    )  # housings below may lie beside the shells too
    if len(design.lines) == 1 and side != (seen if stated == "ends" else stated) and (far or side != seen):
        return _at_side(design, name, side)
    line = next(index for index, each in enumerate(design.lines) if name in each.between)
    end = design.lines[line].between.index(name)
    return _moved_end(design, line, end, way)


def _at_side(design: ArrayDesign, name: str, side: str) -> Dragged:
    """Microphones at a side of the array; straight on from the ends of the line where that is at the same side."""
    for stated in ("ends", side):
        values = {"layout.microphone_side": stated, "layout.depth": None}
        try:
            changed = design.with_values(values)
            places = {each.name: each.position for each in place_housings(changed).microphones}
        except Refusal as error:
            if stated == side:
                return Dragged(design, refused=str(error))
            continue
        if stated == side or _side_of(changed, np.array(places[name])) == side:
            return Dragged(changed, {"layout.microphone_side": stated})
    raise AssertionError("the side itself is the last that is tried")


def _side_of(design: ArrayDesign, place: Array) -> str:
    """Side of the shells at which a place in plan lies; "below" within their box."""
    axes, edge = point_axes(design), design.resonator.outer_diameter / 2
    low, high = axes.min(axis=0) - edge, axes.max(axis=0) + edge
    beyond = {
        **{"left": low[0] - place[0], "right": place[0] - high[0]},
        **{"front": low[1] - place[1], "back": place[1] - high[1]},
    }
    side = max(beyond, key=lambda each: beyond[each])
    return side if beyond[side] > 0 else "below"


def _moved_end(design: ArrayDesign, line: int, end: int, way: Array) -> Dragged:
    """The tube to a microphone follows it, seen from the point at that end of the line."""
    name = design.lines[line].between[end]
    first = sum(each.points for each in design.lines[:line])
    last = first + design.lines[line].points - 1

    def seen(changed: ArrayDesign) -> Array:
        housings = place_housings(changed)
        place = next(each.position for each in housings.microphones if each.name == name)
        return np.array(place) - np.array(housings.points[last if end else first].position)

    stated = _length_of(design.tube_fields_of(line)[-end])
    return _moved(design, f"microphone {name}", [stated], seen, way)


def _pulled_tube(design: ArrayDesign, line: int, segment: int, by: Array, at: Array) -> Dragged:
    """The length of a tube follows the end of it that was taken, or the middle of its arc where it is bowed."""
    count = design.lines[line].points
    if segment in (0, count):
        return _moved_end(design, line, int(segment == count), by[:2])
    part, fields = f"tube {segment + 1} of line {line + 1}", [_length_of(design.tube_fields_of(line)[segment])]
    if design.layout.pitch is not None or design.layout.kind == "places":

        def middle(changed: ArrayDesign) -> Array:
            tubes = lay_out(changed).tubes
            course = next(each.course for each in tubes if (each.line, each.segment) == (line, segment))
            return np.asarray(course[len(course) // 2])

        return _moved(design, part, fields, middle, by)
    first = sum(each.points for each in design.lines[:line]) + segment - 1
    housings = place_housings(design)
    frames = [housings.frame(housings.points[k]) for k in (first, first + 1)]
    apart = [float(np.linalg.norm(np.array(frame.origin) - at)) for frame in frames]
    other, taken = (first + 1, first) if apart[0] < apart[1] else (first, first + 1)
    way = np.asarray(frames[taken - first].axes)[:2] @ by
    return replace(_moved(design, part, fields, _between(other, taken), way), anchor=other)


# -- the value that does it -----------------------------------------------------------------------------
def _moved(
    design: ArrayDesign, part: str, fields: Iterable[str], measure: Measure, way: Array, exact: bool = False
) -> Dragged:
    """Design after the one of some fields that best moves what is measured as asked for."""
    start = measure(design)
    if len(way) > 1 and design.layout.kind in _GRIDS:
        way = _along_grid(way)
    best: tuple[float, str, Array] | None = None
    for name in fields:
        speed = _speed(design, name, measure, start)
        if float(np.linalg.norm(speed)) < _MET:
            continue
        # A size is changed by the field that changes least for it, a place by the one that aims best.
        fit = abs(float(speed[0])) if len(way) == 1 else abs(float(way @ speed)) / float(np.linalg.norm(speed))
        if best is None or fit > best[0] * (1 + _TRIAL):
            best = (fit, name, speed)
    if best is None:
        raise Refusal("is not moved by the length of a tube or a pitch", kind=Kind.UNSUITABLE, field=part)
    _, name, speed = best
    ahead = speed / np.linalg.norm(speed)
    if len(way) > 1 and design.layout.kind in _GRIDS and abs(way @ ahead) > _TRIAL * np.linalg.norm(way):
        ahead = way / np.linalg.norm(way)
    value = _value_for(
        _stated(design, name), name, lambda each: float(ahead @ (measure(each) - start)), float(way @ ahead)
    )
    return _at_value(design, name, round(value, 6) if exact else float(f"{value:.{_DIGITS}g}"))


def _along_grid(way: Array) -> Array:
    """The larger part of a way: along the rows or across them, or upwards."""
    return np.where(np.arange(len(way)) == int(np.argmax(np.abs(way))), way, 0.0)


def _stated(design: ArrayDesign, name: str) -> ArrayDesign:
    """The same design with a field stated that has its default."""
    return design if value_of(design, name) is not None else design.with_values({name: _DEFAULTS[name]})


def _speed(design: ArrayDesign, name: str, measure: Measure, start: Array) -> Array:
    """How far what is measured moves for each unit of a field."""
    now = value_of(_stated(design, name), name)
    for trial in (1 + _TRIAL, 1 - _TRIAL):
        try:
            moved = measure(design.with_values({name: trial * now}))
        except Refusal:  # the field is at an end of its range
            continue
        return np.asarray((moved - start) / ((trial - 1) * now))
    return np.zeros_like(start)


def _value_for(design: ArrayDesign, name: str, reach: Callable[[ArrayDesign], float], wanted: float) -> float:
    """Value of a field at which something reaches so far; beyond what is allowed, the first that is refused."""
    value, reached = float(value_of(design, name)), reach(design)
    trial = (1 + _TRIAL) * value
    try:
        slope = (reach(design.with_values({name: trial})) - reached) / (trial - value)
    except Refusal:
        trial = (1 - _TRIAL) * value
        slope = (reach(design.with_values({name: trial})) - reached) / (trial - value)
    for _ in range(_STEPS):
        if abs(wanted - reached) < _MET or slope == 0:
            break
        following = value + (wanted - reached) / slope
        try:
            further = reach(design.with_values({name: following}))
        except Refusal:
            return following
        slope = (further - reached) / (following - value)
        value, reached = following, further
    return value


def _at_value(design: ArrayDesign, name: str, value: float) -> Dragged:
    """Design with a value of a field, or with the nearest one that is allowed."""
    try:
        return Dragged(design.with_values({name: value}), {name: value})
    except Refusal as error:
        nearest = nearest_valid(_stated(design, name), name, value)
        if nearest is None:
            return Dragged(design, refused=str(error))
        return Dragged(
            design.with_values({name: nearest}), {name: nearest}, _limit(design, name, nearest, value, error)
        )


def _limit(design: ArrayDesign, name: str, nearest: float, value: float, error: Refusal) -> str:
    """Reason why a field ends where it does; far beyond that end, others may come first."""
    try:
        design.with_values({name: nearest + math.copysign(max(_BEYOND * abs(nearest), _MET), value - nearest)})
    except Refusal as near:
        return str(near)
    return str(error)
