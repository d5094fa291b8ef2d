"""Tubes to microphones below the shells: out of the wall, down in a quarter circle, and level again to the chamber."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.routing import unit
from geometry.schema.array_fields import StatedArray

#: Chords per quarter circle.
_CHORDS = 32
#: Room between the floor of a shell and a housing below it, mm.
CLEARANCE = 0.3


@dataclass(frozen=True)
class Descent:
    """Course of one tube from a shell down to a chamber, mm.

    It leaves the shell level, turns down in a quarter circle, is upright, turns in another quarter circle into the
    azimuth of its last piece, and ends level in the chamber.
    """

    point: Array
    """Axis of the shell in plan, (2,) float64, mm."""
    direction: float
    """Direction in which it leaves the shell, degrees."""
    radius: float
    """Radius of both quarter circles, mm."""
    depth: float
    """Height from its end to its beginning, mm; at least two radii."""
    run: float
    """Distance from the shell's axis to the upright piece, mm."""
    azimuth: float
    """Direction of the last piece, degrees."""
    reach: float
    """Distance from the upright piece to the axis of the chamber, mm."""

    @property
    def foot(self) -> Array:
        """Place of the upright piece in plan, (2,) float64, mm."""
        return self.point + self.run * unit(self.direction)

    @property
    def chamber(self) -> Array:
        """Axis of the chamber in plan, (2,) float64, mm."""
        return self.foot + self.reach * unit(self.azimuth)

    def path(self, cavity_radius: float, chamber_radius: float, height: float) -> Array:
        """Axis of the bore from the wall of the cavity to that of the chamber.

        Args:
            cavity_radius: of the shell, mm.
            chamber_radius: of the microphone's chamber, mm.
            height: of the shell's ports, mm.

        Returns:
            (n, 3) float64, mm: x, y and height above the floors of the cavities.
        """
        turn = np.linspace(0, math.pi / 2, _CHORDS + 1)
        radius, low = self.radius, height - self.depth
        out = np.column_stack([self.run - radius + radius * np.sin(turn), height - radius + radius * np.cos(turn)])
        back = np.column_stack([radius - radius * np.cos(turn), low + radius - radius * np.sin(turn)])
        # Chords as short as those of the arcs, by which a check of overlaps knows how far an arc lies from its chord.
        count = math.ceil((self.depth - 2 * radius) / (radius * float(turn[1])))
        fall = np.linspace(height - radius, low + radius, count + 1)[1:-1]
        if not count:
            back = back[1:]
        pieces = [
            _upright(self.point, self.direction, np.array([[cavity_radius, height]])),
            _upright(self.point, self.direction, out),
            _upright(self.foot, self.azimuth, np.column_stack([np.zeros(len(fall)), fall])),
            _upright(self.foot, self.azimuth, back),
            _upright(self.foot, self.azimuth, np.array([[self.reach - chamber_radius, low]])),
        ]
        return np.vstack(pieces)


def reach_of(length: float, run: float, radius: float, depth: float, inner: tuple[float, float]) -> float:
    """Distance from the upright piece to the chamber's axis at which a descent has a given length, mm.

    Args:
        length: of the bore from wall to wall, mm.
        run: from the shell's axis to the upright piece, mm.
        radius: of the quarter circles, mm.
        depth: of the descent, mm.
        inner: radii of the cavity and of the chamber, mm.
    """
    level = run - radius - inner[0]
    return length - level - math.pi * radius - (depth - 2 * radius) + radius + inner[1]


def usual_depth(design: StatedArray) -> float:
    """Depth at which the housings of the microphones are close under the shells and no tube bends too far, mm."""
    resonator, microphone = design.resonator, design.microphone
    above = microphone.chamber_height / 2 + microphone.sound_hole_length + microphone.package_height
    close = resonator.port_axis_height + resonator.floor_thickness + CLEARANCE + above
    return max(close, *(2 * design.microphone_tube_of(line).smallest_bend_radius for line in design.lines))


def depth_of(design: StatedArray) -> float:
    """Distance of the microphones' ports below those of the shells, mm; 0 where they are level."""
    if design.layout.microphone_side != "below":
        return 0.0
    return design.layout.depth or usual_depth(design)


def _upright(origin: Array, azimuth: float, points: Array) -> Array:
    """Points in space of places along an azimuth and their heights, (n, 2) float64, mm: (n, 3)."""
    return np.column_stack([origin + np.outer(points[:, 0], unit(azimuth)), points[:, 1]])
