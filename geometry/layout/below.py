"""Microphones below the shells: where each tube goes down between them, and where its chamber lies."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind
from geometry.ground.typed import Array
from geometry.layout.lines_in_plan import End, Run
from geometry.plan.routing import bearing, unit
from geometry.plan.tube_descent import Descent, depth_of, reach_of
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import SOCKET_COVER, Tube

#: Steps of the directions that are tried, degrees, and of the distances from the wall to the upright piece, mm.
_DIRECTIONS, _AZIMUTHS, _STEP = 5.0, 15.0, 0.25
#: Room between a tube and what it passes, mm.
_ROOM = 0.05
#: What a millimetre costs where parts would overlap, and where they reach beyond the shells.
_OVERLAP, _BEYOND = 100.0, 10.0


def led_below(design: ArrayDesign, runs: Sequence[Run]) -> list[Run]:
    """The lines with tubes that lead their ends to microphones below the shells.

    Each tube goes down where it reaches least beyond the shells and passes them, and its chamber lies in the direction
    in which it is under the shells and clear of the others.

    Raises:
        DesignError: the tubes are too short to go down and into the chambers.
    """
    plan = _Plan(design, np.vstack([run.positions for run in runs]))
    for run in runs:
        plan.add_tubes(run.positions)
    down = [[plan.way_down(end, _beside(run, end)) for end in run.ends] for run in runs]
    led = []
    for run, ways in zip(runs, down, strict=True):
        first, last = (plan.led(end, *way) for end, way in zip(run.ends, ways, strict=True))
        led.append(replace(run, ends=(first, last)))
    return led


def _beside(run: Run, end: End) -> float | None:
    """Direction from the end of a line to its next point, degrees; None where there is none."""
    if len(run.positions) == 1:
        return None
    neighbour = run.positions[1] if end.end == 0 else run.positions[-2]
    return bearing(end.point, neighbour)


class _Plan:
    """Shells, tubes and chambers in plan, as they are placed one after the other."""

    def __init__(self, design: ArrayDesign, points: Array) -> None:
        self.design, self.points = design, points
        self.depth = depth_of(design)
        self.cavity, self.shell = design.resonator.cavity_diameter / 2, design.resonator.outer_diameter / 2
        self.low, self.high = points.min(axis=0) - self.shell, points.max(axis=0) + self.shell
        microphone = design.microphone
        self.chamber, self.wall = microphone.chamber_diameter / 2, microphone.wall_thickness
        length, width = (side / 2 + microphone.board_gap + self.wall for side in microphone.board_size)
        self.seat = (max(length, self.chamber + self.wall), max(width, self.chamber + self.wall))
        self.feet: list[Array] = []
        self.housings: list[Array] = []
        self.tubes: list[tuple[Array, Array]] = []

    def add_tubes(self, positions: Array) -> None:
        """Note the tubes of a line, as straight from axis to axis."""
        self.tubes += list(pairwise(positions))

    def way_down(self, end: End, neighbour: float | None) -> tuple[float, float]:
        """Direction, degrees, and distance from the shell's axis, mm, at which a tube goes down.

        Args:
            end: of a line.
            neighbour: direction of the other tube of its shell, degrees.
        """
        radius, tube = self._radius(end), self._tube(end).outer_diameter / 2
        # Sockets side by side: the chord between the axes where they begin is wider than both and a wall.
        chord = (tube + self.design.printing.glue_gap + SOCKET_COVER) / (self.cavity + self.design.printing.port_lip)
        apart = 2 * math.degrees(math.asin(min(chord, 1.0)))
        others = self.points[np.linalg.norm(self.points - end.point, axis=1) > 1e-6]
        tubes = [ends for ends in self.tubes if not _ends_at(ends, end)]
        directions = np.arange(0.0, 360.0, _DIRECTIONS)
        turn = np.abs((directions - (neighbour or 0.0) + 180) % 360 - 180) if neighbour is not None else 180.0
        extra = np.arange(0.0, self.shell + _STEP, _STEP)
        runs = self.shell + radius + extra
        towards = np.column_stack([np.cos(np.radians(directions)), np.sin(np.radians(directions))])
        feet = end.point + towards[:, None] * runs[None, :, None]
        lack = _lack(others, feet, self.shell + tube + _ROOM)
        lack = lack + 0.01 * np.broadcast_to(np.maximum(apart - turn, 0.0), len(directions))[:, None]
        for each in self.feet:
            lack = lack + _lack(each[None], feet, 2 * tube + _ROOM)
        for first, last in tubes:
            lack = lack + np.maximum(2 * tube + _ROOM - _off(feet, first, last), 0.0)
        # Else the shortest, and straight on if it can be.
        straight = np.broadcast_to(1e-5 * (180.0 - turn), len(directions))
        cost = _OVERLAP * lack + _BEYOND * self._beyond(feet, tube, tube) + 0.1 * extra + straight[:, None]
        # The first of equal ones, whatever the rounding.
        row, column = np.unravel_index(int(np.argmax(cost <= cost.min() + 1e-9)), cost.shape)
        found = float(directions[row]), float(runs[column])
        self.feet.append(end.point + found[1] * unit(found[0]))
        return found

    def led(self, end: End, direction: float, run: float) -> End:
        """An end of a line whose tube goes down there, and into a chamber below the shells.

        Raises:
            DesignError: the tube is too short for that.
        """
        tube, radius = self._tube(end), self._radius(end)
        reach = reach_of(tube.length, run, radius, self.depth, (self.cavity, self.chamber))
        least = radius + self.wall + self.chamber
        if reach < least - 1e-9:
            longer = math.ceil(10 * (tube.length + least - reach)) / 10
            raise DesignError(
                kind=Kind.CONFLICT,
                file=self.design.name,
                field="microphone_tube.length",
                value=tube.length,
                unit="mm",
                allowed=f"at least {longer:g} mm to lead {self.depth:.3g} mm down to a microphone below the shells",
            )
        azimuth = self._way_in(end.point + run * unit(direction), reach, tube.outer_diameter / 2)
        way = Descent(end.point, direction, radius, self.depth, run, azimuth, reach)
        self.housings.append(way.chamber)
        return replace(end, direction=direction, descent=way)

    def _tube(self, end: End) -> Tube:
        return self.design.end_tube_of(self.design.lines[end.line], end.end)

    def _radius(self, end: End) -> float:
        """Radius of the quarter circles, mm: the smallest, but for rounding, which must not break the limit."""
        return min(
            max(self._tube(end).smallest_bend_radius, self._tube(end).outer_diameter / 2) * 1.001, self.depth / 2
        )

    def _way_in(self, foot: Array, reach: float, tube: float) -> float:
        """Azimuth in which the tube runs to its chamber, degrees."""
        long, short = self.seat
        around = math.hypot(long, short)
        azimuths = np.arange(0.0, 360.0, _AZIMUTHS)
        chambers = foot + reach * np.column_stack([np.cos(np.radians(azimuths)), np.sin(np.radians(azimuths))])
        upright, lengthwise = azimuths % 90 == 0, azimuths % 180 == 0
        along, across = (
            np.where(upright, np.where(lengthwise, one, other), around) for one, other in ((long, short), (short, long))
        )
        cost = _BEYOND * self._beyond(chambers, along, across) + 0.5 * ~upright
        for each in self.housings:
            cost = cost + _OVERLAP * _lack(each[None], chambers, 2 * around)
        for each in self.feet:
            cost = cost + _OVERLAP * _lack(each[None], chambers, around + tube)
        cost = cost + 0.01 * np.linalg.norm(chambers - (self.low + self.high) / 2, axis=-1)
        return float(azimuths[int(np.argmax(cost <= cost.min() + 1e-9))])

    def _beyond(self, places: Array, along: float | Array, across: float | Array) -> Array:
        """Lengths by which a part of that half size, at places (..., 2), reaches beyond the shells, mm."""
        half = np.stack(np.broadcast_arrays(along, across), axis=-1)
        below, above = self.low - (places - half), places + half - self.high
        return np.asarray((np.maximum(below, 0) + np.maximum(above, 0)).sum(axis=-1))


def _lack(others: Array, places: Array, least: float) -> Array:
    """Lengths by which the nearest of other places (n, 2) is nearer than allowed to places (..., 2), mm."""
    if not len(others):
        return np.zeros(places.shape[:-1])
    nearest = np.linalg.norm(places[..., None, :] - others, axis=-1).min(axis=-1)
    return np.asarray(np.maximum(least - nearest, 0.0))


def _off(places: Array, start: Array, end: Array) -> Array:
    """Distances of places (..., 2) from a straight tube in plan, mm."""
    along = end - start
    fraction = np.clip((places - start) @ along / float(along @ along), 0.0, 1.0)
    return np.asarray(np.linalg.norm(places - start - fraction[..., None] * along, axis=-1))


def _ends_at(tube: tuple[Array, Array], end: End) -> bool:
    """True for a tube that ends in the same shell."""
    return any(float(np.linalg.norm(each - end.point)) < 1e-6 for each in tube)
