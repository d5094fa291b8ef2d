"""Distance of two whole cylinders or cones about one axis, in closed form: a mold has hundreds of such pairs. In mm."""

from __future__ import annotations

import math

import cadquery as cq
import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_Cone, GeomAbs_Cylinder

from geometry.ground.typed import Array

#: A distance and the pairs of places at which two faces are that close.
Stretches = tuple[float, list[tuple[cq.Vector, cq.Vector]]]

#: Axes are one within this distance, mm, and this sine of an angle.
_SAME = 1e-9


def coaxial_distance(first: cq.Face, second: cq.Face) -> Stretches | None:
    """Smallest distance of two faces; None where they are not whole cylinders or cones about one axis.

    The distance of two surfaces of revolution about one axis is that of their generators, two straight stretches in
    a half plane. Where those are parallel, the closest places are given at both ends of what they have in common.
    """
    one, two = _generator(first), _generator(second)
    if one is None or two is None:
        return None
    axis, foot, unit = one[0], one[1], one[2]
    if np.linalg.norm(np.cross(unit, two[2])) > _SAME or np.linalg.norm(np.cross(two[1] - foot, unit)) > _SAME:
        return None
    shift, sense = float((two[1] - foot) @ unit), math.copysign(1.0, float(unit @ two[2]))
    ends = one[3], np.column_stack([two[3][:, 0], shift + sense * two[3][:, 1]])
    tried = [(end, _nearest(end, ends[1])) for end in ends[0]] + [(_nearest(end, ends[0]), end) for end in ends[1]]
    lengths = [float(np.linalg.norm(a - b)) for a, b in tried]
    if _cross(*ends):
        return 0.0, []
    least = min(lengths)
    near = [pair for pair, length in zip(tried, lengths, strict=True) if length <= least + _SAME]
    return least, [(_place(a, axis, foot, unit), _place(b, axis, foot, unit)) for a, b in near]


def _generator(face: cq.Face) -> tuple[Array, Array, Array, Array] | None:
    """A direction off the axis, a point of it, its direction, and (radius, height) of both ends; None if not whole."""
    surface = BRepAdaptor_Surface(face.wrapped)
    kind = surface.GetType()
    if kind not in (GeomAbs_Cylinder, GeomAbs_Cone):
        return None
    turn = surface.LastUParameter() - surface.FirstUParameter()
    if turn < 2 * math.pi - 1e-6 or len(face.Edges()) > 3:  # two circles and the seam: nothing is cut out of it
        return None
    body = surface.Cylinder() if kind == GeomAbs_Cylinder else surface.Cone()
    position = body.Position()
    foot, unit, off = (
        np.array(each.Coord()) for each in (body.Location(), position.Direction(), position.XDirection())
    )
    ends = []
    for along in (surface.FirstVParameter(), surface.LastVParameter()):
        to = np.array(surface.Value(surface.FirstUParameter(), along).Coord()) - foot
        ends.append((float(np.linalg.norm(to - (to @ unit) * unit)), float(to @ unit)))
    return off, foot, unit, np.array(ends)


def _nearest(point: Array, ends: Array) -> Array:
    """Place of the stretch (2, 2) that is nearest a point (2,)."""
    along = ends[1] - ends[0]
    fraction = min(max(float((point - ends[0]) @ along) / max(float(along @ along), 1e-30), 0.0), 1.0)
    return np.asarray(ends[0] + fraction * along)


def _cross(one: Array, two: Array) -> bool:
    """True where two stretches (2, 2) cross."""
    return _apart(one, two) and _apart(two, one)


def _apart(line: Array, ends: Array) -> bool:
    """True where two places (2, 2) lie on different sides of a line through two others."""
    sides = [np.linalg.det(np.array([line[1] - line[0], end - line[0]])) for end in ends]
    return bool(sides[0] * sides[1] < 0)


def _place(at: Array, off: Array, foot: Array, unit: Array) -> cq.Vector:
    return cq.Vector(*(foot + at[0] * off + at[1] * unit).tolist())
