"""Shapes of the air cavity that are no plain cylinder: a box under a round collar, a cylinder with a bowl as floor.

The membrane always spans a circle of the cavity's diameter. A box lies wholly inside that circle and ends below it
in a round collar, so that nothing overhangs when the shell is printed. Its first side looks along x. Lengths in mm.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from geometry.ground.refusal import Kind, Refusal

if TYPE_CHECKING:
    import cadquery


#: Furthest that the corners of a box reach from the axis, in radii of the cavity: the ledge beyond carries the collar.
WIDEST_BOX = 0.95
#: Reach of the box that is drawn when no size is given, in radii.
USUAL_BOX = 0.9
#: Steepest run of a bowl's wall at a port, degrees from upright: flatter walls make a groove of the bore.
FLATTEST_PORT_WALL = 50.0


@dataclass(frozen=True, order=True)
class Box:
    """A box with rounded upright edges, below a round collar of the cavity's diameter."""

    length: float
    """Side along x, mm."""
    width: float
    """Side along y, mm."""
    corner_radius: float
    """Radius of the upright edges, mm."""
    collar_height: float
    """Height of the round collar above the box, mm."""

    @property
    def reach(self) -> float:
        """Distance of the corners from the axis, mm."""
        r = self.corner_radius
        return math.hypot(self.length / 2 - r, self.width / 2 - r) + r

    @property
    def area(self) -> float:
        """Area of the floor, mm^2."""
        return self.length * self.width - (4 - math.pi) * self.corner_radius**2

    def volume(self, radius: float, height: float) -> float:
        """Volume of the cavity of that radius and height (mm), mm^3."""
        return self.area * (height - self.collar_height) + math.pi * radius**2 * self.collar_height

    def wall_distance(self, radius: float, height: float, angle: float) -> float:
        """Distance from the axis to the wall, mm, with a radius and at a height in mm and an angle in degrees."""
        del radius, height  # the same at every height below the collar
        x, y = (abs(part(math.radians(angle))) for part in (math.cos, math.sin))
        a, b, r = self.length / 2, self.width / 2, self.corner_radius
        if a * y <= (b - r) * x:
            return a / x
        if b * x <= (a - r) * y:
            return b / y
        along, across = (a - r) * x + (b - r) * y, (a - r) * y - (b - r) * x
        return along + math.sqrt(r**2 - across**2)

    def draw(self, radius: float, height: float, top: float) -> cadquery.Solid:
        """The cavity of that radius and height as a solid, its collar carried on to the height ``top``; all mm."""
        import cadquery as cq

        below = height - self.collar_height
        sides = cq.Workplane().box(self.length, self.width, below, centered=(True, True, False))
        box = sides.edges("|Z").fillet(self.corner_radius).val()
        collar = cq.Solid.makeCylinder(radius, top - below, cq.Vector(0, 0, below))
        return _one(box.fuse(collar))


@dataclass(frozen=True, order=True)
class Dome:
    """A cylinder whose floor is a bowl, part of a sphere; a hemisphere where its depth is the cavity's radius."""

    depth: float
    """Depth of the bowl, mm."""

    def sphere_radius(self, radius: float) -> float:
        """Radius of the sphere of the bowl, mm, under an opening of that radius (mm)."""
        return (radius**2 + self.depth**2) / (2 * self.depth)

    def volume(self, radius: float, height: float) -> float:
        """Volume of the cavity of that radius and height (mm), mm^3."""
        bowl = math.pi / 6 * self.depth * (3 * radius**2 + self.depth**2)
        return bowl + math.pi * radius**2 * (height - self.depth)

    def wall_distance(self, radius: float, height: float, angle: float) -> float:
        """Distance from the axis to the wall, mm, with a radius and at a height in mm and an angle in degrees."""
        del angle
        if height >= self.depth:
            return radius
        return math.sqrt(height * (2 * self.sphere_radius(radius) - height))

    def lowest_port(self, radius: float) -> float:
        """Height above which the wall of a cavity of that radius, mm, is steep enough for a port, mm."""
        return self.sphere_radius(radius) * (1 - math.sin(math.radians(FLATTEST_PORT_WALL)))

    def draw(self, radius: float, height: float, top: float) -> cadquery.Solid:
        """The cavity of that radius and height as a solid, carried on to the height ``top``; all mm."""
        import cadquery as cq

        del height
        sphere = self.sphere_radius(radius)
        half = math.atan2(radius, sphere - self.depth) / 2
        middle = (sphere * math.sin(half), sphere * (1 - math.cos(half)))
        side = cq.Workplane("XZ").lineTo(0, top).lineTo(radius, top)
        if top > self.depth + 1e-9:
            side = side.lineTo(radius, self.depth)
        profile = side.threePointArc(middle, (0, 0)).close()
        return _one(profile.revolve(360, (0, 0, 0), (0, 1, 0)).val())


def draw_cavity(shape: Box | Dome | None, radius: float, height: float, top: float | None = None) -> cadquery.Solid:
    """The air of a cavity, its floor at z = 0, its axis z.

    Args:
        shape: None for a plain cylinder.
        radius: of the opening under the membrane, mm.
        height: from the lowest place of the floor to the membrane, mm.
        top: height at which the drawing ends, mm, where it must reach through the seat.
    """
    import cadquery as cq

    top = height if top is None else top
    return cq.Solid.makeCylinder(radius, top) if shape is None else shape.draw(radius, height, top)


def wall_distance(shape: Box | Dome | None, radius: float, height: float, angle: float) -> float:
    """Distance from the axis to the wall of a cavity of a radius, at a height, all mm, and at an angle in degrees."""
    return radius if shape is None else shape.wall_distance(radius, height, angle)


def separation(distance: float, turn: float, rise: float) -> float:
    """Distance of two rays from the axis that differ by ``turn`` degrees and ``rise`` mm, from that distance on, mm."""
    return math.hypot(2 * distance * math.sin(math.radians(turn) / 2), rise)


def web(first: tuple[float, float], second: tuple[float, float], turn: float, rise: float = 0.0) -> float:
    """Least material between two round holes whose axes are rays from one axis, mm; not above 0 where they meet.

    Exact for holes at one height, where the nearest sides of both and their axes lie in a plane, unless they are nearly
    opposite and their ends nearest, and for parallel ones; else the distance of the axes less both radii, which is
    on the safe side.

    Args:
        first: where on its axis the hole begins, mm, and its radius.
        second: the same of the other.
        turn: angle between the axes, degrees.
        rise: difference of their heights, mm.
    """
    (start, radius), (other_start, other_radius) = first, second
    apart = separation(min(start, other_start), turn, rise) - radius - other_radius
    angle = math.radians(abs((turn + 180) % 360 - 180))
    if rise or not angle:
        return apart
    # The first axis runs along x, the second one above it.
    along = (math.cos(angle), math.sin(angle))
    dx = other_start * along[0] + other_radius * along[1] - start
    dy = other_start * along[1] - other_radius * along[0] - radius
    across = dx * along[1] - dy * along[0]  # of the corner of the first from the side of the second
    if across > 0 and dy < 0:
        return min(apart, 0.0)
    ahead = -(dx * along[0] + dy * along[1])
    return min(abs(dy) if dx >= 0 else math.hypot(dx, dy), abs(across) if ahead >= 0 else math.hypot(dx, dy))


def _one(shape: cadquery.Shape) -> cadquery.Solid:
    solids = shape.Solids()
    if len(solids) != 1 or not solids[0].isValid():
        raise Refusal(f"the cavity is drawn as {len(solids)} solids instead of one valid solid", kind=Kind.NO_RESULT)
    return solids[0]
