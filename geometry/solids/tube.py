"""Tubes as solids along their routed path: the spring as the smooth sleeve that its turns fill, and the sheath."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import geometry
from geometry.ground.argument_checks import unsuitable
from geometry.ground.typed import Array
from geometry.plan.routing import path_length, tightest_bend, trimmed
from geometry.schema.part_fields import Tube

if TYPE_CHECKING:
    import cadquery as cq

#: Points within this distance of a circle lie on it, mm.
_ON_ARC = 1e-6


@dataclass(frozen=True)
class TubePiece:
    """A piece of tube in its own coordinates, mm: it begins at the origin along +x and first bends towards +y.

    Equal pieces have equal paths, wherever they lie.
    """

    tube: Tube
    """The tube that it is cut from."""
    path: tuple[tuple[float, float, float], ...]
    """Points of the axis of the bore, mm, without the lips of the ports on which the piece stops."""

    @property
    def name(self) -> str:
        """Name of the piece: bore x outside and cut length, mm; of a bent one to which radius."""
        points = np.array(self.path)
        radius = tightest_bend(points)
        bent = "" if np.isinf(radius) else f"-bent-{radius:.3g}"
        # A polyline is a little shorter than its arc: three digits hide that.
        return f"{self.tube.inner_diameter:g}x{self.tube.outer_diameter:g}-{path_length(points):.3g}{bent}"


def piece_of(tube: Tube, course: Array, lip: float) -> tuple[TubePiece, Array]:
    """The piece of tube to cut for a routed path, and where it lies.

    Args:
        tube: its diameters.
        course: (n, 3) float64, mm, in space, from cavity wall to cavity wall.
        lip: of the ports, on which the piece stops, mm.

    Returns:
        The piece and the (4, 4) float64 matrix that moves it into place.
    """
    points = trimmed(course, lip)
    along = _normalised(points[1] - points[0])
    bends = np.cross(points - points[0], along)
    far = int(np.argmax(np.linalg.norm(bends, axis=1)))
    if np.linalg.norm(bends[far]) > 1e-6:
        normal = _normalised(np.cross(along, points[far] - points[0]))
    else:
        upwards = np.array([0.0, 0.0, 1.0]) if abs(along[2]) < 0.9 else np.array([1.0, 0.0, 0.0])
        normal = _normalised(upwards - (upwards @ along) * along)
    axes = np.array([along, np.cross(normal, along), normal])
    local = np.round((points - points[0]) @ axes.T, 6) + 0.0
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = axes.T, points[0]
    return TubePiece(tube, tuple((float(x), float(y), float(z)) for x, y, z in local)), matrix


def build_tube(piece: TubePiece) -> tuple[cq.Workplane, cq.Workplane]:
    """Draw the spring and the sheath of a piece of tube.

    Raises:
        Refusal: the drawn tube is not one valid solid, as where it bends more tightly than it is wide.
    """
    tube, points = piece.tube, np.array(piece.path)
    spring = tube.spring_outer_diameter / 2
    return (
        _sleeve(points, tube.inner_diameter / 2, spring, f"spring {piece.name}"),
        _sleeve(points, spring, tube.outer_diameter / 2, f"sheath {piece.name}"),
    )


def _sleeve(points: Array, inner: float, outer: float, name: str) -> cq.Workplane:
    """A round sleeve along an axis that begins at the origin along +x, radii in mm."""
    import cadquery as cq
    from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipe

    if tightest_bend(points) <= outer:
        raise unsuitable(name, f"bends to a radius of {tightest_bend(points):.3g} mm, below its own {outer:g} mm")
    start, along = cq.Vector(*points[0]), cq.Vector(*(points[1] - points[0]))
    circles = [cq.Wire.makeCircle(radius, start, along) for radius in (outer, inner)]
    section = cq.Face.makeFromWires(circles[0], circles[1:])
    pipe = BRepOffsetAPI_MakePipe(_wire(points).wrapped, section.wrapped)
    return geometry.solids.one_solid(cq.Shape.cast(pipe.Shape()), name)


def _wire(points: Array) -> cq.Wire:
    """Straight, or a line, an arc through the points between and a line; a spline where they lie on no arc."""
    import cadquery as cq

    if np.isinf(tightest_bend(points)):
        return cq.Wire.assembleEdges([cq.Edge.makeLine(cq.Vector(*points[0]), cq.Vector(*points[-1]))])
    bend = points[1:-1]
    first, last, end = (cq.Vector(*point) for point in (bend[0], bend[-1], points[-1]))
    arc = cq.Edge.makeTangentArc(first, cq.Vector(*(points[1] - points[0])), last)
    centre = np.array(arc.arcCenter().toTuple())
    radii = np.linalg.norm(bend - centre, axis=1)
    if np.ptp(radii) > 2 * _ON_ARC * max(1.0, float(radii[0])):
        tangents = [cq.Vector(*(points[1] - points[0])), cq.Vector(*(points[-1] - points[-2]))]
        arc = cq.Edge.makeSpline([cq.Vector(*point) for point in bend[::4]], tangents=tangents)
    # Without a kink: the path's own numbers are rounded.
    end = last + arc.tangentAt(1).normalized() * (end - last).Length
    return cq.Wire.assembleEdges([cq.Edge.makeLine(cq.Vector(*points[0]), first), arc, cq.Edge.makeLine(last, end)])


def _normalised(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))
