"""Plan of the base plate of a flat array: where seats, saddles, numbers, holes and cuts are. Lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import FOOT_EDGE
from geometry.ground.typed import Array
from geometry.layout.placement import ArrayLayout, TubePlacement
from geometry.schema.field_errors import conflict
from geometry.schema.ports import foot_directions, largest_gap
from geometry.schema.print_processes import process_of
from geometry.solids.base_plate import (
    DEPTH,
    HEAD,
    RIM,
    Across,
    BasePlate,
    Corner,
    Cut,
    Mark,
    Saddle,
    Seat,
)
from geometry.solids.stroke_font import strokes, text_size

#: Free room between what stands on a plate, around its marks, and at both sides of a cut.
_FREE = 0.8
#: Length of a saddle where the design states none.
_SADDLE = 3.0
#: Free room beside a dovetail, and between a mark and the edge of the plate.
_BESIDE = 0.5
#: Least thickness of the plate under the lowest seat.
_UNDER = 0.6
#: Steps in which places of marks and cuts are tried, degrees and mm.
_TURN, _STEP = 15.0, 0.5
#: Least distance of a dovetail from the ends of a cut, and free edge of the printer at either side of a piece.
_END, _EDGE = 4.0, 3.0


@dataclass(frozen=True)
class _Box:
    """Room that something takes in plan."""

    name: str
    low: Corner
    high: Corner

    def meets(self, low: Corner, high: Corner) -> bool:
        return self.low[0] < high[0] and low[0] < self.high[0] and self.low[1] < high[1] and low[1] < self.high[1]


def plan_base(design: ArrayDesign, layout: ArrayLayout) -> BasePlate:
    """Plan the base plate of a design.

    Raises:
        Refusal: a microphone stands lower than the plate, a saddle or a number has no room, microphones are drawn
            schematically, or no cut divides the plate into pieces for the printer; each by the name of its field.
    """
    base, resonator = design.base, design.resonator
    top = base.seat_depth - resonator.floor_thickness
    bottom = -resonator.floor_thickness - base.thickness
    for tube in layout.tubes:
        if tube.schematic:
            problem = f"a plate has a seat for every microphone, but the place of that of {tube.label} is only drawn"
            raise conflict("base.kind", base.kind, problem=problem)
    seats = (*_shell_seats(design, layout), *_housing_seats(design, layout, bottom, top))
    saddles = tuple(saddle for tube in layout.tubes if (saddle := _saddle(design, tube)) is not None)
    names = [f"shell {p.number}" for p in layout.points] + [f"microphone {m.name}" for m in layout.microphones]
    taken = [*(_seat_box(seat, base.fit, name) for seat, name in zip(seats, names, strict=True))]
    for saddle in saddles:
        box = _saddle_box(saddle)
        for other in taken:
            if _hits(other, seats, names, saddle, base.fit):
                problem = f"the saddle of {saddle.name} lies over that of {other.name}"
                raise conflict("base.saddle_length", saddle.length, problem=problem, remedy="make it shorter")
        taken.append(box)
    low = (min(box.low[0] for box in taken) - base.border, min(box.low[1] for box in taken) - base.border)
    high = (max(box.high[0] for box in taken) + base.border, max(box.high[1] for box in taken) + base.border)
    holes, slots = _mounts(design, low, high)
    radius = base.screw_diameter / 2
    taken += [_Box("hole", (x - radius, y - radius), (x + radius, y + radius)) for x, y in holes]
    taken += [_Box("slot", *corners) for corners in slots]
    marks = tuple(_marks(design, layout, seats, taken, (low, high)))
    cuts = _cuts(design, low, high, taken)
    return BasePlate(
        low, high, bottom, top, base.fit, seats, saddles, marks, holes, base.screw_diameter, slots, cuts
    )  # fmt: skip


# -- seats ----------------------------------------------------------------------------------------------------
def _shell_seats(design: ArrayDesign, layout: ArrayLayout) -> Iterator[Seat]:
    features, resonator = design.shell, design.resonator
    outer, half = resonator.outer_diameter / 2, features.foot_hole / 2 + FOOT_EDGE
    bottom = -resonator.floor_thickness
    for point in layout.points:
        seat = Seat(point.position, outer, bottom, bottom + design.base.seat_depth)
        if features.feet:
            ports, turn = point.turned
            feet = tuple(angle + turn for angle in foot_directions([port.angle for port in ports], features.feet))
            reach = outer + features.foot_length - half
            seat = Seat(seat.place, outer, bottom, seat.top, feet, reach, half, features.foot_hole)
        yield seat


def _housing_seats(design: ArrayDesign, layout: ArrayLayout, bottom: float, top: float) -> Iterator[Seat]:
    microphone = design.microphone
    under = design.resonator.port_axis_height - microphone.chamber_height / 2 - microphone.wall_thickness
    if under < bottom + _UNDER:
        least = design.base.thickness + bottom + _UNDER - under
        allowed = f"at least {least:.4g} mm, because microphone housings stand {top - under:.4g} mm deep in the plate"
        raise conflict("base.thickness", design.base.thickness, allowed)
    radius = microphone.chamber_diameter / 2 + microphone.wall_thickness
    for placed in layout.microphones:
        yield Seat(placed.position, radius, under, under + design.base.seat_depth)


def _seat_box(seat: Seat, fit: float, name: str) -> _Box:
    reach = seat.radius + fit + RIM
    if seat.feet:
        reach = max(reach, seat.foot_reach + seat.foot_half + fit)
    x, y = seat.place
    return _Box(name, (x - reach, y - reach), (x + reach, y + reach))


# -- saddles --------------------------------------------------------------------------------------------------
def _saddle(design: ArrayDesign, tube: TubePlacement) -> Saddle | None:
    """Saddle beside one of the shells that a tube joins: that with the lower x or y, so that cuts find room."""
    base, course = design.base, tube.course
    to_microphone = tube.segment in (0, design.lines[tube.line].points)
    backwards = tuple(np.round(course[-1, :2], 3)) < tuple(np.round(course[0, :2], 3))
    if tube.segment == 0 or (backwards and not to_microphone):
        course = course[::-1]
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(course, axis=0), axis=1))])
    wall = design.resonator.wall_thickness + base.fit + RIM
    other = design.microphone.wall_thickness + base.fit + RIM if to_microphone else wall
    room = float(lengths[-1]) - wall - other
    length = base.saddle_length or _SADDLE
    if length > room - 2 * _FREE + 1e-9:
        if base.saddle_length is None:
            return None
        allowed = f"at most {max(room - 2 * _FREE, 0):.4g} mm, the free length of {tube.label}"
        raise conflict("base.saddle_length", length, allowed)
    middle = wall + _FREE + length / 2
    here = _at(course, lengths, middle)
    ahead = _at(course, lengths, middle + length / 2) - _at(course, lengths, middle - length / 2)
    angle = math.degrees(math.atan2(ahead[1], ahead[0]))
    return Saddle(
        tube.label,
        (float(here[0]), float(here[1])),
        angle,
        tube.tube.outer_diameter / 2 + design.printing.glue_gap + _bow(course, lengths, middle, length),
        float(here[2]),
        length,
    )


def _at(course: Array, lengths: Array, along: float) -> Array:
    """Place of a course, (3,) float64, mm, at a length along it, mm."""
    return np.array([np.interp(along, lengths, course[:, k]) for k in range(3)])


def _bow(course: Array, lengths: Array, middle: float, length: float) -> float:
    """Most that a course leaves the straight line through a saddle, mm."""
    places = np.array([_at(course, lengths, middle + part * length / 2) for part in np.linspace(-1, 1, 9)])
    chord = (places[-1] - places[0]) / np.linalg.norm(places[-1] - places[0])
    to = places - places[4]
    return float(np.linalg.norm(to - np.outer(to @ chord, chord), axis=1).max())


def _saddle_box(saddle: Saddle) -> _Box:
    corners = _corners(saddle)
    (x0, y0), (x1, y1) = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    return _Box(saddle.name, (x0, y0), (x1, y1))


def _corners(saddle: Saddle) -> Array:
    """Corners of a saddle in plan, (4, 2) float64, mm."""
    turn = math.radians(saddle.angle)
    along, beside = np.array([math.cos(turn), math.sin(turn)]), np.array([-math.sin(turn), math.cos(turn)])
    half, width = saddle.length / 2, saddle.radius + RIM
    return np.array(
        [saddle.place + a * half * along + b * width * beside for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1))]
    )


def _hits(other: _Box, seats: Sequence[Seat], names: Sequence[str], saddle: Saddle, fit: float) -> bool:
    """True where a saddle lies over a seat, or its box over that of another saddle."""
    box = _saddle_box(saddle)
    if not other.meets(box.low, box.high):
        return False
    if other.name not in names:
        return True
    seat = seats[names.index(other.name)]
    corners = _corners(saddle)
    edges = np.vstack([np.linspace(a, b, 9) for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)])
    to = edges - np.array(seat.place)
    if np.linalg.norm(to, axis=1).min() < seat.radius + fit:
        return True
    arms = [np.array([math.cos(math.radians(a)), math.sin(math.radians(a))]) for a in seat.feet]
    return any(
        float(np.linalg.norm(to - np.clip(to @ arm, 0, seat.foot_reach)[:, None] * arm, axis=1).min())
        < seat.foot_half + fit
        for arm in arms
    )


# -- mounts, marks --------------------------------------------------------------------------------------------
def _mounts(
    design: ArrayDesign, low: Corner, high: Corner
) -> tuple[tuple[Corner, ...], tuple[tuple[Corner, Corner], ...]]:
    base, half = design.base, design.base.border / 2
    (x0, y0), (x1, y1) = low, high
    if base.mount == "screws":
        if base.screw_diameter > base.border - 2 * RIM:
            allowed = f"at most {base.border - 2 * RIM:g} mm, base.border ({base.border:g} mm) less two edges"
            raise conflict("base.screw_diameter", base.screw_diameter, allowed)
        return tuple((x, y) for y in (y0 + half, y1 - half) for x in (x0 + half, x1 - half)), ()
    if base.mount == "strap":
        middle, wide = (y0 + y1) / 2, base.strap_width / 2
        if 2 * wide > y1 - y0 - 4 * RIM:
            raise conflict("base.strap_width", base.strap_width, f"at most {y1 - y0 - 4 * RIM:.4g} mm on this plate")
        ends = ((x0 + half / 2, x0 + half), (x1 - half, x1 - half / 2))
        return (), tuple(((a, middle - wide), (b, middle + wide)) for a, b in ends)
    return (), ()


def _marks(
    design: ArrayDesign, layout: ArrayLayout, seats: Sequence[Seat], taken: list[_Box], plate: tuple[Corner, Corner]
) -> Iterator[Mark]:
    """Numbers of points beside their shells, names of microphones beside their housings; adds them to what is taken."""
    height = design.base.label_height
    named = [(str(p.number), list(p.port_angles)) for p in layout.points]
    named += [(m.name.upper(), [port.angle for port in m.ports]) for m in layout.microphones]
    for (text, ports), seat in zip(named, seats, strict=True):
        try:
            list(map(strokes, text))
        except KeyError:
            continue  # a name with a letter that has no strokes stays on the drawings
        width, tall = text_size([text], height)
        first, _ = largest_gap(ports)
        free = _free_place(seat, design.base.fit, first, (width, tall), taken, plate)
        if free is None:
            problem = f"there is no room for the number {text} beside its place"
            raise conflict("base.label_height", height, problem=problem, remedy="make the numbers smaller")
        low, high = (free[0] - width / 2, free[1] - tall / 2), (free[0] + width / 2, free[1] + tall / 2)
        taken.append(_Box(f"number {text}", low, high))
        yield Mark(text, free, height)


def _free_place(
    seat: Seat, fit: float, first: float, size: Corner, taken: Sequence[_Box], plate: tuple[Corner, Corner]
) -> Corner | None:
    """Middle of the nearest free box of a size beside a seat, the direction of its widest gap first."""
    half = (size[0] / 2 + _FREE / 2, size[1] / 2 + _FREE / 2)
    turns = [side * step * _TURN for step in range(13) for side in (1, -1)]
    for further in (0.0, 2.0, 4.0):
        for turn in turns:
            angle = math.radians(first + turn)
            reach = seat.radius + fit + RIM + further
            reach += abs(half[0] * math.cos(angle)) + abs(half[1] * math.sin(angle))
            x, y = seat.place[0] + reach * math.cos(angle), seat.place[1] + reach * math.sin(angle)
            low, high = (x - half[0], y - half[1]), (x + half[0], y + half[1])
            within = all(plate[0][k] + _BESIDE < low[k] and high[k] < plate[1][k] - _BESIDE for k in range(2))
            if within and not any(_meets(box, low, high) for box in taken):
                return x, y
    return None


def _meets(box: _Box, low: Corner, high: Corner) -> bool:
    """True where a box meets what is taken: round seats by their circle."""
    if not box.meets(low, high):
        return False
    if not box.name.startswith(("shell ", "microphone ")):
        return True
    middle, reach = ((box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2), (box.high[0] - box.low[0]) / 2
    nearest = [min(max(middle[k], low[k]), high[k]) for k in range(2)]
    return math.dist(nearest, middle) < reach


# -- cuts -----------------------------------------------------------------------------------------------------
def _cuts(design: ArrayDesign, low: Corner, high: Corner, taken: Sequence[_Box]) -> tuple[Cut, ...]:
    """Cuts that divide the plate into pieces that the printer has room for."""
    width, depth, _ = process_of(design.printing).build_volume
    rooms = (width - 2 * _EDGE, depth - 2 * _EDGE)
    if high[0] - low[0] > rooms[0] and high[0] - low[0] <= rooms[1] and high[1] - low[1] <= rooms[0]:
        return ()  # it is turned on the plate of the printer
    cuts: list[Cut] = []
    ways: tuple[tuple[Across, int], ...] = (("x", 0), ("y", 1))
    for across, k in ways:
        start = low[k]
        crossing = [cut.at for cut in cuts if cut.across != across]
        while high[k] - start > rooms[k]:
            cut = _cut(across, k, start, rooms[k], (low, high), taken, crossing)
            if cut is None:
                problem = (
                    f"no straight cut across {across} within {rooms[k]:g} mm of {start:.4g} mm leaves seats and tubes "
                    "whole"
                )
                raise conflict("base.kind", design.base.kind, problem=problem, remedy="take a printer with more room")
            cuts.append(cut)
            start = cut.at
    return tuple(cuts)


def _cut(
    across: Across,
    k: int,
    start: float,
    room: float,
    box: tuple[Corner, Corner],
    taken: Sequence[_Box],
    crossing: Sequence[float],
) -> Cut | None:
    """The farthest cut with two dovetails or more that touches nothing; a piece ends with its dovetails."""
    far = min(start + room - DEPTH, box[1][k] - DEPTH - _END)
    for at in np.arange(far, start + _END, -_STEP).tolist():
        if any(each.low[k] < at + _FREE and at - _FREE < each.high[k] for each in taken):
            continue
        beside = [each for each in taken if each.low[k] < at + DEPTH + _FREE and at < each.high[k]]
        tabs: list[float] = []
        need = HEAD / 2 + _BESIDE
        ends = box[0][1 - k] + _END, box[1][1 - k] - _END
        for middle in (*ends, *np.arange(*ends, _STEP).tolist()):
            clear = all(middle + need < each.low[1 - k] or each.high[1 - k] < middle - need for each in beside)
            apart = all(abs(middle - other) > 2 * HEAD for other in (*tabs, *crossing))
            if clear and apart:
                tabs.append(middle)
        if len(tabs) >= 2:
            return Cut(across, at, tuple(tabs))
    return None
