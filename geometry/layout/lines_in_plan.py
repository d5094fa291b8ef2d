"""Positions of each line's points in plan, and directions of its ends, for each kind of layout."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array
from geometry.plan import ring
from geometry.plan.area import area_positions, outside_at
from geometry.plan.cylinder import Cylinder, Plane, wound_turn
from geometry.plan.hand import finger_positions, meeting_at
from geometry.plan.routing import bearing, unit
from geometry.plan.sides import SIDES, has_turned_rows, turned_to
from geometry.plan.tube_descent import Descent


@dataclass(frozen=True)
class End:
    """An end of a line: its last point and the way from there to the microphone."""

    line: int
    """Index of the line in the design."""
    end: Literal[0, 1]
    """End of the line: 0 at its first microphone, 1 at its second."""
    microphone: str
    """Name of the microphone."""
    point: Array
    """Axis of the last point in plan, (2,) float64, mm."""
    direction: float
    """Direction from the point to the microphone, degrees."""
    distance: float
    """Distance of the axes of point and chamber if the tube lies straight, mm."""
    descent: Descent | None = None
    """Course of a tube that leads below the shells; None where the tube is in their plane."""

    @property
    def target(self) -> Array:
        """Axis of the chamber at the end of the tube, (2,) float64, mm."""
        if self.descent is not None:
            return self.descent.chamber
        return self.point + self.distance * unit(self.direction)

    @property
    def arrival(self) -> float:
        """Direction of the tube from the axis of the chamber, degrees."""
        return (self.direction if self.descent is None else self.descent.azimuth) + 180


@dataclass(frozen=True)
class Run:
    """The points of one line in plan, the sides to which its tubes bow, and its ends."""

    positions: Array
    """Axes of the points in plan, (n_point, 2) float64, mm."""
    sides: tuple[int, ...]
    """Side to which each tube between two points bows: +1 left, -1 right."""
    ends: tuple[End, End]
    """The first and the second end."""
    angles: tuple[float | None, ...] = ()
    """Direction in which the line runs straight through each point, degrees; None where its tubes follow their own;
    empty where no point has one.
    """

    def is_bowed(self, place: int) -> bool:
        """True where no direction is stated for the tube after a point: it is straight, or one arc."""
        return not self.angles or self.angles[place] is self.angles[place + 1] is None


def run_of(
    design: ArrayDesign,
    line: int,
    positions: Array,
    sides: tuple[int, ...],
    out: tuple[float, float],
    surface: Plane | Cylinder,
) -> Run:
    """A line whose microphone tubes lie straight.

    Args:
        design: the array.
        line: index of the line.
        positions: axes of its points in plan, (n_point, 2) float64, mm.
        sides: to which its tubes bow, +1 left, -1 right.
        out: directions in which its two ends point, degrees.
        surface: what the shells stand on.
    """
    microphones = design.lines[line].between
    ends = []
    for end in (0, 1):
        around, along = _microphone_reach(design, line, end, surface)
        reach = around if out[end] in (0.0, 180.0) else along
        ends.append(End(line, end, microphones[end], positions[-end], out[end], reach))
    return Run(positions, sides, (ends[0], ends[1]))


def serpentine_runs(design: ArrayDesign, surface: Plane | Cylinder) -> list[Run]:
    """Rows of ``columns`` points, every second row backwards; lines are blocks above each other.

    On a cylinder x runs around it: the pitch along the rows is then that of tubes wound between the shells. Where
    microphones lie at a side, the rows are turned so that both ends of the line are there.
    """
    runs, bottom, side = [], 0.0, SIDES.get(design.layout.microphone_side)
    for index, line in enumerate(design.lines):
        pitch, columns = design.pitch_of(line), min(design.layout.columns, line.points)
        turned = side is not None and has_turned_rows(design)
        columns = -(-line.points // columns) if turned and side in (90.0, 270.0) else columns
        place = np.arange(line.points)
        row, column = place // columns, place % columns
        column = np.where(row % 2 == 0, column, columns - 1 - column)
        # A wound array lies on both sides of the top of its cylinder.
        middle = (columns - 1) / 2 if isinstance(surface, Cylinder) else 0.0
        if len(set(design.steps_of(line))) > 1:
            positions = _walked(design.steps_of(line), row) + np.array([0.0, bottom])
        else:
            around = _pitch_around(design, index, surface)
            positions = np.column_stack([(column - middle) * around, row * pitch + bottom])
        sides = []
        for k in range(1, line.points):
            backwards = row[k - 1] % 2 == 1
            turn = row[k] != row[k - 1]
            sides.append((1 if backwards else -1) if turn else (-1 if backwards else 1))
        if side is not None:
            positions, out = (turned_to(positions, side) if turned else positions), (side, side)
        elif line.points == 1:
            out = (180.0, 0.0)
        else:
            out = (bearing(positions[1], positions[0]), bearing(positions[-2], positions[-1]))
        runs.append(run_of(design, index, positions, tuple(sides), out, surface))
        bottom = float(positions[-1, 1]) + pitch + design.resonator.outer_diameter
    return runs


def _walked(steps: tuple[float, ...], row: NDArray[np.int_]) -> Array:
    """Axes of points at these distances from each other, (n_point, 2) float64, mm: along the rows and up between them.

    Rows of tubes of different lengths do not lie point above point: each begins above the end of the one before.
    """
    moves = [
        (0.0, step) if row[k] != row[k - 1] else (step if row[k] % 2 == 0 else -step, 0.0)
        for k, step in enumerate(steps, start=1)
    ]
    return np.cumsum(np.array([(0.0, 0.0), *moves]), axis=0)


def ring_runs(design: ArrayDesign, surface: Plane | Cylinder) -> list[Run]:
    """The sides of the polygon whose corners are the microphones."""
    # Lines join neighbouring corners only (a rule of the design), so every line is a side.
    corners = dict(zip(design.microphones, ring.corners(ring.side_lengths(design)), strict=True))
    runs = []
    for index, line in enumerate(design.lines):
        start, end = (corners[name] for name in line.between)
        direction = bearing(start, end)
        middle, along = (start + end) / 2, (end - start) / np.linalg.norm(end - start)
        if len(set(design.steps_of(line))) > 1:
            along_side = np.cumsum([0.0, *design.steps_of(line)]) - design.span_of(line) / 2
        else:
            from_middle = np.arange(line.points) - (line.points - 1) / 2
            along_side = np.asarray(from_middle * design.pitch_of(line), np.float64)
        first, last = (design.microphone_reach_of(line, end) for end in (0, 1))
        positions = middle + np.outer(along_side + (first - last) / 2, along)
        outward = float(middle @ unit(direction + 90)) > 0
        sides = (1 if outward else -1,) * (line.points - 1)
        runs.append(run_of(design, index, positions, sides, ((direction + 180) % 360, direction), surface))
    return runs


def _pitch_around(design: ArrayDesign, line: int, surface: Plane | Cylinder) -> float:
    """Distance of neighbours in a row of a serpentine, in the plan, mm."""
    resonator = design.resonator
    if not isinstance(surface, Cylinder):
        return design.pitch_of(design.lines[line])
    inner, outer = resonator.cavity_diameter / 2, resonator.outer_diameter / 2
    length, radius = design.tube_of(design.lines[line]).length, surface.port_radius
    return radius * wound_turn(length, (inner, inner), (outer, outer), radius)


def _microphone_reach(design: ArrayDesign, line: int, end: int, surface: Plane | Cylinder) -> tuple[float, float]:
    """Distances from an end of a line to its microphone in plan: along x and in every other direction, mm."""
    straight = design.microphone_reach_of(design.lines[line], end)
    if not isinstance(surface, Cylinder):
        return straight, straight
    inner = (design.resonator.cavity_diameter / 2, design.microphone.chamber_diameter / 2)
    outer = (design.resonator.outer_diameter / 2, inner[1] + design.microphone.wall_thickness)
    length, radius = design.end_tube_of(design.lines[line], end).length, surface.port_radius
    return radius * wound_turn(length, inner, outer, radius), straight


def area_runs(design: ArrayDesign, surface: Plane | Cylinder) -> list[Run]:
    """The lines of an area. Their tubes lie straight; a microphone that joins two lines lies where their tubes meet."""
    positions = area_positions(design)
    runs = []
    for index, (line, points) in enumerate(zip(design.lines, positions, strict=True)):
        out = [bearing(points[1], points[0]), bearing(points[-2], points[-1])] if len(points) > 1 else [180.0, 0.0]
        for end, name in enumerate(line.between):
            place = outside_at(design, positions, name)
            if place is not None:
                out[end] = bearing(points[-end], place)
        runs.append(run_of(design, index, points, (1,) * (len(points) - 1), (out[0], out[1]), surface))
    return runs


def hand_runs(design: ArrayDesign, surface: Plane | Cylinder) -> list[Run]:
    """The lines of a glove. The tube of a line's end points on along its finger, away from the point before.

    Where two ends of one microphone can both be reached with straight tubes, the microphone lies where they meet,
    on the side of the wrist.
    """
    columns, positions = design.layout.columns, finger_positions(design)
    out = []
    for points in positions:
        wrist = [bearing(point, np.zeros(2)) for point in (points[0], points[-1])]
        upwards = len(points) > 1 and np.linalg.norm(points[-1]) > np.linalg.norm(points[-2]) + 1e-9
        out.append([wrist[0], (wrist[1] + 180) % 360 if upwards else wrist[1]])
    for name in design.microphones:
        meeting = meeting_at(design, positions, name)
        for index, line in enumerate(design.lines):
            if meeting is not None and name in line.between:
                end = line.between.index(name)
                out[index][end] = bearing(positions[index][-end], meeting)
    runs = []
    for index, points in enumerate(positions):
        # Outwards over the fingertips, towards the wrist between the roots of the fingers.
        sides = tuple(-1 if k % columns == 0 and (k // columns) % 2 == 0 else 1 for k in range(1, len(points)))
        runs.append(run_of(design, index, points, sides, (out[index][0], out[index][1]), surface))
    return runs


def place_runs(design: ArrayDesign, surface: Plane | Cylinder) -> list[Run]:
    """Lines over points wherever the design states them; tubes that are longer than straight bow to the left."""
    runs, before, side = [], 0, SIDES.get(design.layout.microphone_side)
    for index, line in enumerate(design.lines):
        places = design.layout.places[before : before + line.points]
        positions, angles = np.array([(p.x, p.y) for p in places]), tuple(place.angle for place in places)
        first = bearing(positions[1], positions[0]) if line.points > 1 else 180.0
        last = bearing(positions[-2], positions[-1]) if line.points > 1 else 0.0
        out = (
            first if angles[0] is None else (angles[0] + 180) % 360,
            last if angles[-1] is None else angles[-1] % 360,
        )
        run = run_of(design, index, positions, (1,) * (line.points - 1), out if side is None else (side, side), surface)
        runs.append(replace(run, angles=angles))
        before += line.points
    return runs
