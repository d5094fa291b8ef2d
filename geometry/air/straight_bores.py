"""Straight round bores at the ports of a solid, cut off where they are longer than the flow at their mouths needs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from geometry.air.mesh import Point, face_at, inner_point
from geometry.ground.typed import Array

if TYPE_CHECKING:
    import cadquery
    from OCP.gp import gp_Dir, gp_Pnt


#: Length of a bore that stays between its end and its mouth, in radii. What is not plane at the mouth falls by 6 per
#: radius at least, and its energy by the square of that.
KEPT_RADII = 2.0
#: Shortest piece that is cut off, in radii.
_WORTH_CUTTING = 0.5
#: Places and contents that agree within this part of a radius, or of themselves, are the same.
_SAME = 1e-4
#: Distance below which a point lies on a face, mm, as for :func:`geometry.air.mesh.face_at`.
_NEAR = 1e-6


@dataclass(frozen=True)
class StraightBore:
    """A straight round bore beyond a port."""

    radius: float
    """Radius, mm."""
    length: float
    """Length, mm; 0 where nothing is."""


@dataclass(frozen=True)
class Shortened:
    """A solid without the far ends of its bores."""

    solid: cadquery.Shape
    """The cell without its bores, mm."""
    points: dict[str, Point]
    """A point on every face that was named, mm."""
    bores: tuple[StraightBore, ...]
    """The bore that was cut off at each port, in order."""


def shortened(solid: cadquery.Shape, points: Mapping[str, Point], ports: Sequence[str]) -> Shortened:
    """A solid whose straight round bores end :data:`KEPT_RADII` before their mouths.

    A bore that has no mouth, a straight tube with a port at either end, stays as it is.

    Args:
        solid: one closed solid, mm.
        points: name -> a point on its flat face, mm.
        ports: which of them end a tube, in order.

    Raises:
        MeshError: a point lies on no flat face, or on several.
    """
    solids = solid.Solids()
    moved, bores = dict(points), []
    if len(solids) != 1:
        return Shortened(solid, moved, tuple(StraightBore(1.0, 0.0) for _ in ports))
    left = solids[0]
    for name in ports:
        faces = {each: face_at(left, each, point) for each, point in moved.items()}
        end = faces.pop(name)
        radius, free = _round_bore(left, end, faces, [each for each in ports if each != name])
        length = free - KEPT_RADII * radius
        cut = _cut(left, end, radius, length) if length > _WORTH_CUTTING * radius else None
        kept = None if cut is None else _points_on(cut, faces, moved)
        if cut is None or kept is None:
            bores.append(StraightBore(radius, 0.0))
            continue
        bores.append(StraightBore(radius, length))
        left = cut
        x, y, z = (np.array(points[name]) - length * _normal(end)).tolist()
        moved = {**kept, name: (x, y, z)}
    return Shortened(left, moved, tuple(bores))


def _round_bore(
    solid: cadquery.Solid, end: cadquery.Face, others: Mapping[str, cadquery.Face], ports: Sequence[str]
) -> tuple[float, float]:
    """Radius and undisturbed length of the round bore that a flat face ends, mm; length 0 where there is none.

    The face is a disc, or what mirror planes leave of one, and all walls beside it are one cylinder that ends at a
    mouth.
    """
    from OCP.BRepAdaptor import BRepAdaptor_Surface

    place, normal = _vector(end.Center()), _normal(end)
    edges = {edge.hashCode() for edge in end.Edges()}
    walls = [
        face
        for face in solid.Faces()
        if face.hashCode() != end.hashCode() and edges & {edge.hashCode() for edge in face.Edges()}
    ]
    known = {face.hashCode() for face in others.values()}
    round_walls = [face for face in walls if face.geomType() == "CYLINDER"]
    radius = math.sqrt(end.Area() / math.pi)
    if not round_walls or any(
        face.geomType() != "CYLINDER" and not (face.geomType() == "PLANE" and face.hashCode() in known)
        for face in walls
    ):
        return radius, 0.0
    cylinders = [BRepAdaptor_Surface(face.wrapped).Cylinder() for face in round_walls]
    radius = cylinders[0].Radius()
    axis, origin = (_point(part) for part in (cylinders[0].Axis().Direction(), cylinders[0].Location()))
    fraction = end.Area() / (math.pi * radius**2)
    coaxial = all(
        abs(each.Radius() - radius) < _SAME * radius
        and np.linalg.norm(np.cross(_point(each.Location()) - origin, axis)) < _SAME * radius
        for each in cylinders
    )
    along = np.linalg.norm(np.cross(axis, normal)) < _SAME
    if not coaxial or not along or min(abs(fraction - part) for part in (1, 0.5, 0.25)) > _SAME:
        return radius, 0.0
    # The bore is free as far as the nearest place where its wall ends.
    far_ends = {edge.hashCode() for name in ports for edge in others[name].Edges()}
    if any(edge.hashCode() in far_ends for face in round_walls for edge in face.Edges()):
        return radius, 0.0
    depths = [
        min(depth)
        for face in round_walls
        for edge in face.Edges()
        for depth in [[float((place - _vector(edge.positionAt(t))) @ normal) for t in np.linspace(0, 1, 33)]]
        if not _lies_along(edge, normal) and max(depth) > _SAME * radius
    ]
    return radius, min(depths, default=0.0)


def _lies_along(edge: cadquery.Edge, normal: Array) -> bool:
    """True where an edge is a straight line along the bore: a seam, or a line where a mirror plane cuts the wall."""
    across = np.cross(_vector(edge.tangentAt(0)), normal)
    return edge.geomType() == "LINE" and float(np.linalg.norm(across)) < _SAME


def _cut(solid: cadquery.Solid, end: cadquery.Face, radius: float, length: float) -> cadquery.Solid | None:
    """The solid without the last piece of a bore; None where more than that would go."""
    import cadquery as cq

    normal = _normal(end)
    centre = _axis_point(end, radius)
    beyond, wide = 0.1 * radius, 1.05 * radius
    start = centre - length * normal
    tool = cq.Solid.makeCylinder(wide, length + beyond, cq.Vector(*start), cq.Vector(*normal))
    left, gone = solid.cut(tool).Solids(), solid.intersect(tool).Solids()
    if len(left) != 1 or len(gone) != 1 or not left[0].isValid():
        return None
    return left[0] if abs(gone[0].Volume() / (end.Area() * length) - 1) < _SAME else None


def _points_on(
    solid: cadquery.Solid, faces: Mapping[str, cadquery.Face], points: Mapping[str, Point]
) -> dict[str, Point] | None:
    """Points on what a cut leaves of faces: a mirror plane's may have been on the piece that went.

    None where a face went, or was cut into several.
    """
    import cadquery as cq

    found = {}
    for name, face in faces.items():
        place, normal = _vector(face.Center()), _normal(face)
        left = [
            each
            for each in solid.Faces()
            if each.geomType() == "PLANE"
            and abs(_normal(each) @ normal - 1) < _SAME
            and abs((_vector(each.Center()) - place) @ normal) < _NEAR
            and each.distance(face) < _NEAR
        ]
        if len(left) != 1:
            return None
        there = left[0].distance(cq.Vertex.makeVertex(*points[name])) < _NEAR
        found[name] = points[name] if there else inner_point(left[0])
    return found


def _axis_point(end: cadquery.Face, radius: float) -> Array:
    """Point at which the axis of a bore meets its end: the centre of the arc that bounds it."""
    arcs = [edge for edge in end.Edges() if edge.geomType() == "CIRCLE" and abs(edge.radius() - radius) < 1e-3 * radius]
    return _vector(arcs[0].arcCenter())


def _normal(face: cadquery.Face) -> Array:
    return _vector(face.normalAt())


def _vector(value: cadquery.Array) -> Array:
    return np.array(value.toTuple())


def _point(value: gp_Pnt | gp_Dir) -> Array:
    return np.array([value.X(), value.Y(), value.Z()])
