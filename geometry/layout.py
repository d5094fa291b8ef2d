"""Where every resonator, tube and microphone lies."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from geometry import ring
from geometry.design import ArrayDesign, Tube
from geometry.overlaps import overlaps
from geometry.routing import bow_angle, bowed_path, drawn_path, path_length, unit

#: Directions are rounded to 1e-6 degrees: places closer than this are one, mm.
_SAME_PLACE = 1e-4


@dataclass(frozen=True)
class PointPlacement:
    """One sensing point. Lengths mm, angles degrees from +x, anticlockwise seen from above."""

    number: int
    """From 1, counted through all lines in order."""
    line: int
    """Index of its line in the design."""
    place: int
    """Index along its line, from 0 at the line's first microphone."""
    position: tuple[float, float]
    """Axis of the cavity."""
    port_angles: tuple[float, float]
    """Directions of the tubes towards the previous and the next node of the line."""


@dataclass(frozen=True)
class MicrophonePort:
    """Where one end of a line enters a microphone chamber."""

    line: int
    end: Literal[0, 1]
    """0: the line's first microphone, 1: its second."""
    angle: float


@dataclass(frozen=True)
class MicrophonePlacement:
    """One microphone chamber and the line ends it joins, in order of (line, end)."""

    name: str
    position: tuple[float, float]
    ports: tuple[MicrophonePort, ...]


@dataclass(frozen=True)
class TubePlacement:
    """A routed tube from one cavity wall to the next.

    ``segment`` k runs before point k of its line; 0 and n_points are the microphone tubes.
    """

    line: int
    segment: int
    tube: Tube
    path: NDArray[np.float64]
    """(n, 3) float64, mm, along the axis of the bore."""
    schematic: bool = False
    """The path is drawn to show what is joined; its length is not the tube's."""

    @property
    def label(self) -> str:
        """Name in notes: tubes of a line count from 1 at its first microphone."""
        return f"tube {self.segment + 1} of line {self.line + 1}"


@dataclass(frozen=True)
class ArrayLayout:
    """The whole array. ``notes`` says what is drawn but could not be built as drawn."""

    points: tuple[PointPlacement, ...]
    microphones: tuple[MicrophonePlacement, ...]
    tubes: tuple[TubePlacement, ...]
    notes: tuple[str, ...]


def place(design: ArrayDesign) -> ArrayLayout:
    """Lay out a design in plan.

    ``serpentine``: rows of ``columns`` points, every second row backwards; lines are blocks above each
    other. Where the pitch is shorter than a straight tube, tubes bow out along one circular arc of exactly
    their length: in rows towards +y, at the turns outwards. The microphone of a single line end lies
    straight out at its tube's length. A microphone that joins several ends cannot lie at its tubes' length
    from all of them: it is drawn beside the blocks and noted.

    ``ring``: the lines are the sides of a polygon at their true length, the microphones its corners (see
    :func:`geometry.ring.corners`). Microphone tubes lie straight, other tubes bow outwards.

    Overlaps of shells, housings and tubes are measured and noted by name.
    """
    runs = _ring_runs(design) if design.layout.kind == "ring" else _serpentine_runs(design)
    ends = [end for run in runs for end in run.ends]
    if design.layout.kind == "ring":
        microphones = _ring_microphones(design, ends)
    else:
        microphones = _serpentine_microphones(design, ends, np.vstack([run.positions for run in runs]))
    points, tubes = _points_and_tubes(design, runs, {m.name: m for m in microphones})
    layout = ArrayLayout(tuple(points), tuple(microphones), tuple(tubes), ())
    return replace(layout, notes=(*_schematic_notes(design, layout), *overlaps(design, layout)))


# -- lines ------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class _End:
    """An end of a line: its last point and the direction from there to the microphone, degrees."""

    line: int
    end: Literal[0, 1]
    microphone: str
    point: NDArray[np.float64]
    direction: float
    distance: float
    """From the axis of the point to the axis of the chamber if the tube lies straight, mm."""

    @property
    def target(self) -> NDArray[np.float64]:
        """Axis of the chamber at the end of a straight tube, (2,) float64."""
        return self.point + self.distance * unit(self.direction)


@dataclass(frozen=True)
class _Run:
    """The points of one line in plan and the side (+1 left, -1 right) to which each tube bows."""

    positions: NDArray[np.float64]
    sides: tuple[int, ...]
    ends: tuple[_End, _End]


def _run(
    design: ArrayDesign, line: int, positions: NDArray[np.float64], sides: tuple[int, ...], out: tuple[float, float]
) -> _Run:
    microphones = design.lines[line].between
    reach = design.microphone_reach_of(design.lines[line])
    first = _End(line, 0, microphones[0], positions[0], out[0], reach)
    last = _End(line, 1, microphones[1], positions[-1], out[1], reach)
    return _Run(positions, sides, (first, last))


def _serpentine_runs(design: ArrayDesign) -> list[_Run]:
    runs, bottom = [], 0.0
    for index, line in enumerate(design.lines):
        pitch, columns = design.pitch_of(line), min(design.layout.columns, line.points)
        place = np.arange(line.points)
        row, column = place // columns, place % columns
        column = np.where(row % 2 == 0, column, columns - 1 - column)
        positions = np.column_stack([column, row]) * pitch + [0.0, bottom]
        sides = []
        for k in range(1, line.points):
            backwards = row[k - 1] % 2 == 1
            turn = row[k] != row[k - 1]
            sides.append((1 if backwards else -1) if turn else (-1 if backwards else 1))
        if line.points == 1:
            out = (180.0, 0.0)
        else:
            out = (
                _bearing(positions[1], positions[0]),
                _bearing(positions[-2], positions[-1]),
            )
        runs.append(_run(design, index, positions, tuple(sides), out))
        bottom = float(positions[-1, 1]) + pitch + design.resonator.outer_diameter
    return runs


def _ring_runs(design: ArrayDesign) -> list[_Run]:
    # Lines join neighbouring corners only (a rule of the design), so every line is a side.
    corners = dict(zip(design.microphones, ring.corners(ring.side_lengths(design)), strict=True))
    runs = []
    for index, line in enumerate(design.lines):
        start, end = (corners[name] for name in line.between)
        direction = _bearing(start, end)
        middle, along = (start + end) / 2, (end - start) / np.linalg.norm(end - start)
        steps = (np.arange(line.points) - (line.points - 1) / 2) * design.pitch_of(line)
        positions = middle + np.outer(steps, along)
        outward = float(middle @ unit(direction + 90)) > 0
        sides = (1 if outward else -1,) * (line.points - 1)
        runs.append(_run(design, index, positions, sides, ((direction + 180) % 360, direction)))
    return runs


# -- microphones --------------------------------------------------------------------------------------
def _ring_microphones(design: ArrayDesign, ends: list[_End]) -> list[MicrophonePlacement]:
    microphones = []
    for name in design.microphones:
        own = [end for end in ends if end.microphone == name]
        ports = tuple(MicrophonePort(e.line, e.end, _tidy(e.direction + 180)) for e in own)
        microphones.append(MicrophonePlacement(name, _pair(own[0].target), ports))
    return microphones


def _serpentine_microphones(
    design: ArrayDesign, ends: list[_End], points: NDArray[np.float64]
) -> list[MicrophonePlacement]:
    housing = design.microphone.chamber_diameter / 2 + design.microphone.wall_thickness
    joined = {name: [end for end in ends if end.microphone == name] for name in design.microphones}
    middle = (points[:, 0].min() + points[:, 0].max()) / 2
    # Beside the blocks and beyond every chamber that lies at its tube's length.
    beyond = max(end.distance for end in ends) + 4 * housing
    sides: dict[int, list[tuple[float, str]]] = {-1: [], 1: []}
    for name, own in joined.items():
        if len(own) > 1:
            mean = np.mean([end.target for end in own], axis=0)
            sides[1 if mean[0] > middle + 1e-9 else -1].append((float(mean[1]), name))
    drawn = {}
    for side, column in sides.items():
        edge = points[:, 0].max() if side > 0 else points[:, 0].min()
        heights = _spread([height for height, _ in sorted(column)], 4 * housing)
        for height, (_, name) in zip(heights, sorted(column), strict=True):
            drawn[name] = np.array([edge + side * beyond, height])
    microphones = []
    for name, own in joined.items():
        if name in drawn:
            position = drawn[name]
            angles = _equally_spaced([_bearing(position, end.point) for end in own])
        else:
            position = own[0].target
            angles = [own[0].direction + 180]
        ports = tuple(MicrophonePort(e.line, e.end, _tidy(angle)) for e, angle in zip(own, angles, strict=True))
        microphones.append(MicrophonePlacement(name, _pair(position), ports))
    return microphones


def _spread(values: list[float], least: float) -> list[float]:
    """Sorted values moved apart to at least ``least`` with their mean kept."""
    moved: list[float] = []
    for value in values:
        moved.append(max(value, moved[-1] + least) if moved else value)
    shift = (sum(values) - sum(moved)) / len(values) if values else 0.0
    return [value + shift for value in moved]


def _equally_spaced(bearings: list[float]) -> list[float]:
    """Directions at equal angles, dealt out so that each is as close as possible to its bearing (degrees)."""
    count = len(bearings)
    ranking = sorted(range(count), key=lambda k: (bearings[k], k))
    best: tuple[float, list[float]] = (math.inf, [])
    for shift in range(count):
        slots = [0.0] * count
        for rank, k in enumerate(ranking):
            slots[k] = 360 * ((rank + shift) % count) / count
        left = [math.radians(b - s) for b, s in zip(bearings, slots, strict=True)]
        offset = math.atan2(sum(map(math.sin, left)), sum(map(math.cos, left)))
        cost = -sum(math.cos(x - offset) for x in left)
        if cost < best[0] - 1e-9:
            best = (cost, [slot + math.degrees(offset) for slot in slots])
    return best[1]


# -- points and tubes ---------------------------------------------------------------------------------
def _points_and_tubes(
    design: ArrayDesign, runs: list[_Run], microphones: dict[str, MicrophonePlacement]
) -> tuple[list[PointPlacement], list[TubePlacement]]:
    cavity, outer = design.resonator.cavity_diameter / 2, design.resonator.outer_diameter / 2
    points: list[PointPlacement] = []
    tubes: list[TubePlacement] = []
    for index, (line, run) in enumerate(zip(design.lines, runs, strict=True)):
        tube, first, last = design.tube_of(line), *run.ends
        backward, forward = [first.direction], []
        paths = []
        for start, end, side in zip(run.positions[:-1], run.positions[1:], run.sides, strict=True):
            bow = bow_angle(tube.length, float(np.linalg.norm(end - start)), cavity, outer)
            direction = _bearing(start, end)
            forward.append(direction + side * bow)
            backward.append(direction + 180 - side * bow)
            paths.append(bowed_path(start, end, bow, side, cavity, outer))
        forward.append(last.direction)
        for place_, position in enumerate(run.positions):
            angles = (_tidy(backward[place_]), _tidy(forward[place_]))
            points.append(PointPlacement(len(points) + 1, index, place_, _pair(position), angles))
        tubes.append(_microphone_tube(design, first, microphones[first.microphone], runs))
        tubes += [TubePlacement(index, k + 1, tube, _at_port_height(design, path)) for k, path in enumerate(paths)]
        tubes.append(_microphone_tube(design, last, microphones[last.microphone], runs))
    return points, tubes


def _microphone_tube(
    design: ArrayDesign, end: _End, microphone: MicrophonePlacement, runs: list[_Run]
) -> TubePlacement:
    """The tube of a line's end, always drawn from the line's first microphone towards its second."""
    line = design.lines[end.line]
    tube = design.microphone_tube_of(line)
    cavity, chamber = design.resonator.cavity_diameter / 2, design.microphone.chamber_diameter / 2
    centre = np.array(microphone.position)
    if np.linalg.norm(centre - end.target) < _SAME_PLACE:
        out = unit(end.direction)
        plan = np.array([end.point + cavity * out, end.target - chamber * out])
        path = _at_port_height(design, plan)
        schematic = abs(path_length(path) - tube.length) > 1e-6
    else:
        port = next(port for port in microphone.ports if (port.line, port.end) == (end.line, end.end))
        plan = drawn_path(
            end.point,
            end.direction,
            (cavity, design.resonator.outer_diameter / 2),
            centre,
            port.angle,
            (chamber, chamber + design.microphone.wall_thickness),
        )
        path, schematic = _at_port_height(design, plan), True
        others = np.vstack([run.positions for run in runs])
        others = others[np.linalg.norm(others - end.point, axis=1) > 1e-6]
        gaps = np.linalg.norm(plan[:, None] - others[None], axis=2)
        if gaps.size and gaps.min() < design.resonator.outer_diameter / 2 + tube.outer_diameter:
            # Lead it over the membranes, so that the picture shows which ends are joined.
            resonator = design.resonator
            lift = resonator.cavity_height - resonator.port_axis_height + design.membrane.thickness
            s = np.linspace(0, 1, len(plan) - 2)
            path[1:-1, 2] += (lift + 2 * tube.outer_diameter) * np.minimum(1, 4 * np.sin(np.pi * s) ** 2)
    if end.end == 0:
        path = path[::-1].copy()
    return TubePlacement(end.line, 0 if end.end == 0 else line.points, tube, path, schematic)


def _schematic_notes(design: ArrayDesign, layout: ArrayLayout) -> list[str]:
    notes = []
    for microphone in layout.microphones:
        drawn = []
        for port in microphone.ports:
            segment = 0 if port.end == 0 else design.lines[port.line].points
            tube = next(t for t in layout.tubes if (t.line, t.segment) == (port.line, segment))
            if tube.schematic:
                drawn.append(f"{tube.label} is {tube.tube.length:g} mm, drawn {path_length(tube.path):.1f} mm")
        if drawn:
            ends = f"{len(microphone.ports)} line end" + ("s" if len(microphone.ports) > 1 else "")
            notes.append(f"microphone {microphone.name} joins {ends} and is drawn schematically: {'; '.join(drawn)}")
    if notes:
        count = sum(tube.schematic for tube in layout.tubes)
        notes.insert(0, f"simulated study: not buildable as drawn; {count} microphone tubes are drawn schematically")
    return notes


def _at_port_height(design: ArrayDesign, plan: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.column_stack([plan, np.full(len(plan), design.resonator.port_axis_height)])


def _bearing(start: NDArray[np.float64], end: NDArray[np.float64]) -> float:
    return _tidy(math.degrees(math.atan2(end[1] - start[1], end[0] - start[0])))


def _tidy(angle: float) -> float:
    """The angle in [0, 360), free of rounding noise, so that equal cells and parts are seen to be equal."""
    return round(round(angle, 6) % 360.0, 6)


def _pair(position: NDArray[np.float64]) -> tuple[float, float]:
    return (round(float(position[0]), 9) + 0.0, round(float(position[1]), 9) + 0.0)
