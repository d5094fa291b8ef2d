"""An array wound on a cylinder: where its plan lies in space, and tubes that follow the surface.

The plan is unrolled at the height of the ports: x runs around the cylinder, y along it. Shells are rigid, so a
tube leaves them along their tangents and bends between them along one circular arc.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind
from geometry.ground.typed import Array
from geometry.plan.crossing import zero_crossing
from geometry.schema.array_fields import StatedArray

#: Chords per arc.
_CHORDS = 64

#: Three directions, each of unit length, as rows.
Axes = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
#: Axes of a part that lies flat: x, y and the normal, as rows.
FLAT: Axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True)
class Frame:
    """A place in space: origin (mm) and the unit vectors of its own x, y and z."""

    origin: tuple[float, float, float]
    """Place of its origin, mm."""
    axes: Axes = FLAT
    """Unit vectors of its x, y and z."""

    def at(self, x: float, y: float, z: float) -> Array:
        """The point with the coordinates x, y, z in the frame, all mm: (3,) float64."""
        return np.asarray(self.origin) + np.array([x, y, z]) @ np.asarray(self.axes)

    def seen(self, points: Array) -> Array:
        """Coordinates in the frame, (n, 3) float64, mm, of points (n, 3) float64 in space, mm."""
        return np.asarray((points - np.asarray(self.origin)) @ np.asarray(self.axes).T)


class Surface(Protocol):
    """A surface on which the parts of an array stand, looked up by their places in the plan."""

    def frame(self, x: float, y: float) -> Frame:
        """The place of a part whose axis meets the floors of the cavities at (x, y) of the plan, mm."""

    def outwards(self, point: Array) -> Array:
        """Unit vector away from the surface at a point (3,) in space, mm: (3,) float64."""


@dataclass(frozen=True)
class Plane:
    """The flat sheet: plan and space are the same."""

    def frame(self, x: float, y: float) -> Frame:
        """The place of a part whose axis meets the floors of the cavities at (x, y) of the plan, mm."""
        return Frame((x, y, 0.0))

    def mapped(self, path: Array) -> Array:
        """Points in space, (n, 3) mm, of a path (n, 3), mm, in plan: x, y and height above the cavities' floors."""
        return path

    def outwards(self, point: Array) -> Array:
        """Unit vector away from the surface at a point (3,) in space, mm: (3,) float64."""
        return np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Cylinder:
    """A cylinder along y; the plan's (0, 0) lies on top of it."""

    floor_radius: float
    """Radius of the cylinder that touches the floors of the cavities, mm."""
    port_radius: float
    """Radius of the cylinder through the axes of the ports, at which the plan is unrolled, mm."""

    def frame(self, x: float, y: float) -> Frame:
        """The place of a part whose axis meets the surface at (x, y) of the plan, mm; z points away from it."""
        turn = x / self.port_radius
        cos, sin = math.cos(turn), math.sin(turn)
        origin = (self.floor_radius * sin, y, self.floor_radius * (cos - 1))
        return Frame(origin, ((cos, 0.0, -sin), (0.0, 1.0, 0.0), (sin, 0.0, cos)))

    def mapped(self, path: Array) -> Array:
        """Points in space, (n, 3) mm, of a path (n, 3), mm, in plan: x, y and height above the cavities' floors."""
        return np.array([self.frame(x, y).at(0.0, 0.0, z) for x, y, z in path])

    def outwards(self, point: Array) -> Array:
        """Unit vector away from the surface at a point (3,) in space, mm: (3,) float64."""
        away = np.array([point[0], 0.0, point[2] + self.floor_radius])
        return np.asarray(away / np.linalg.norm(away))

    def wound(
        self,
        first: tuple[float, float],
        second: tuple[float, float],
        inner: tuple[float, float],
        outer: tuple[float, float],
    ) -> Array:
        """The path in space of a tube straight around the cylinder.

        Args:
            first: where the axis of the first housing meets the plan, mm.
            second: the same for the second; of the same y.
            inner: radii of the two cavities, mm.
            outer: radii of the two housings, mm.

        Returns:
            (n, 3) float64, mm, from cavity wall to cavity wall.
        """
        towards = math.copysign(1.0, second[0] - first[0])
        start, end = self.frame(*first), self.frame(*second)
        height, reach = self.port_radius - self.floor_radius, max(outer)
        turn = abs(second[0] - first[0]) / self.port_radius
        radius = wound_radius(turn, outer, self.port_radius)
        x, z = towards * np.array(start.axes[0]), np.array(start.axes[2])
        turns = np.linspace(0, turn, _CHORDS + 1)
        centre = start.at(towards * reach, 0.0, height) - radius * z
        arc = centre + radius * (np.outer(np.cos(turns), z) + np.outer(np.sin(turns), x))
        return np.vstack([start.at(towards * inner[0], 0.0, height), arc, end.at(-towards * inner[1], 0.0, height)])


def surface_of(design: StatedArray) -> Plane | Cylinder:
    """The surface that the shells of a design stand on."""
    if design.layout.kind != "cylinder" or design.layout.diameter is None:
        return Plane()
    floor = design.layout.diameter / 2 + design.resonator.floor_thickness
    return Cylinder(floor, floor + design.resonator.port_axis_height)


def wound_radius(turn: float, outer: tuple[float, float], radius: float) -> float:
    """Radius of the arc between two housings (outside radii, mm) on a cylinder of that radius through the ports.

    The tangents of both axes meet ``radius`` tan(turn / 2) from each; the arc begins where the wider housing ends.
    """
    return radius - max(outer) / math.tan(turn / 2)


def wound_length(turn: float, inner: tuple[float, float], outer: tuple[float, float], radius: float) -> float:
    """Length of a tube from cavity wall to cavity wall around a cylinder, mm; arguments as for :func:`wound_turn`."""
    return 2 * max(outer) - sum(inner) + turn * wound_radius(turn, outer, radius)


def wound_turn(length: float, inner: tuple[float, float], outer: tuple[float, float], radius: float) -> float:
    """Angle between two housings on a cylinder whose tube has a given length, radians.

    Args:
        length: from cavity wall to cavity wall, mm.
        inner: radii of the two cavities, mm.
        outer: radii of the two housings, mm.
        radius: from the cylinder's axis to those of the ports, mm.

    Raises:
        Refusal: the tube does not reach between the walls, or goes more than half around the cylinder.
    """
    low, high = 2 * math.atan(max(outer) / radius), math.pi
    shortest, longest = (wound_length(turn, inner, outer, radius) for turn in (low, high))
    allowed = f"between {shortest:.4g} and {longest:.4g} mm"
    check_range("length", length, shortest, longest, "mm", kind=Kind.CONFLICT, allowed=allowed)
    return zero_crossing(lambda turn: wound_length(turn, inner, outer, radius) - length, low, high)
