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
from geometry.solids.arc_chain import arc_ends

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
    from OCP.GeomFill import GeomFill_Trihedron
    from OCP.Standard import Standard_ConstructionError, Standard_Failure, Standard_NullObject

    if tightest_bend(points) <= outer:
        raise unsuitable(name, f"bends to a radius of {tightest_bend(points):.3g} mm, below its own {outer:g} mm")
    start, along = cq.Vector(*points[0]), cq.Vector(*(points[1] - points[0]))
    circles = [cq.Wire.makeCircle(radius, start, along) for radius in (outer, inner)]
    section = cq.Face.makeFromWires(circles[0], circles[1:])
    path = _wire(points).wrapped
    # The default frame fails along some twisted curves; the section is round, so any frame gives the same sleeve.
    for frame in (None, GeomFill_Trihedron.GeomFill_IsDiscreteTrihedron, GeomFill_Trihedron.GeomFill_IsFrenet):
        try:
            pipe = BRepOffsetAPI_MakePipe(path, section.wrapped, *(() if frame is None else (frame, False)))
            return geometry.solids.one_solid(cq.Shape.cast(pipe.Shape()), name)
        except (Standard_ConstructionError, Standard_NullObject, Standard_Failure) as error:
            failed = error
    raise unsuitable(name, f"cannot be drawn along its course: {failed}")


def _wire(points: Array) -> cq.Wire:
    """Lines and arcs along the points, each tangent to the one before.

    Where the points lie on none, arcs between two lines follow them, see :func:`geometry.solids.arc_chain.arc_ends`. A
    spline would do for the eye, but its pipe takes the kernel a minute to divide into facets, and some cannot be drawn.
    """
    import cadquery as cq

    pieces = _pieces(points)
    if pieces is None:
        ends = [points[1], *arc_ends(points), points[-1]]
        runs = [(end, 0 < k < len(ends) - 1) for k, end in enumerate(ends)]
    else:
        runs = [(points[last], not is_line) for _, last, is_line in pieces]
    edges: list[cq.Edge] = []
    place, along = cq.Vector(*points[0]), cq.Vector(*(points[1] - points[0])).normalized()
    for end, is_arc in runs:
        target = cq.Vector(*end)
        # Without a kink: the path's own numbers are rounded.
        if is_arc:
            edges.append(cq.Edge.makeTangentArc(place, along, target))
        else:
            edges.append(cq.Edge.makeLine(place, place + along * (target - place).Length))
        place, along = edges[-1].endPoint(), edges[-1].tangentAt(1).normalized()
    return cq.Wire.assembleEdges(edges)


def _pieces(points: Array) -> list[tuple[int, int, bool]] | None:
    """First and last index of each line and arc of a polyline, and whether it is a line; None for other curves."""
    pieces, first, end = [], 0, len(points) - 1
    while first < end:
        last = next(each for each in range(end, first, -1) if _is_straight(points[first : each + 1]))
        # One step alone is a line at an end, elsewhere the beginning of an arc.
        if first == 0 or last == end or last > first + 1:
            pieces.append((first, last, True))
        else:
            last = next((each for each in range(end, first + 3, -1) if _is_arc(points[first : each + 1])), first)
            if last == first:
                return None
            pieces.append((first, last, False))
        first = last
    return pieces


def _is_straight(points: Array) -> bool:
    along = _normalised(points[-1] - points[0])
    off = np.cross(points - points[0], along)
    return float(np.abs(off).max()) <= 2 * _ON_ARC


def _is_arc(points: Array) -> bool:
    """True where points lie on the circle through the first, the middle and the last of them."""
    a, b, c = points[0], points[len(points) // 2], points[-1]
    normal = np.cross(b - a, c - a)
    square = float(normal @ normal)
    if square < 1e-18:
        return False
    across = np.cross(normal, b - a) * float((c - a) @ (c - a)) - np.cross(normal, c - a) * float((b - a) @ (b - a))
    centre = a + across / (2 * square)
    radii = np.linalg.norm(points - centre, axis=1)
    flat = np.abs((points - a) @ normal) / np.sqrt(square)
    return bool(np.ptp(radii) <= 2 * _ON_ARC * max(1.0, float(radii[0])) and flat.max() <= 2 * _ON_ARC)


def _normalised(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))
