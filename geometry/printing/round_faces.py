"""Distance of whole cylinders or cones about parallel axes, in closed form: a mold has hundreds of pairs. In mm."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cadquery as cq
import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_Cone, GeomAbs_Cylinder

from geometry.ground.typed import Array

#: A distance and the pairs of places at which two faces are that close.
Stretches = tuple[float, list[tuple[cq.Vector, cq.Vector]]]

#: Axes are one within this distance, mm, and this sine of an angle.
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class RoundFace:
    """A whole cylinder or cone: nothing is cut out of it."""

    off: Array
    """Direction off the axis, (3,) float64."""
    foot: Array
    """Place on the axis, (3,) float64, mm."""
    axis: Array
    """Direction of the axis, (3,) float64."""
    ends: Array
    """Radius, and height above the place, of both ends, (2, 2) float64, mm."""


def round_face(face: cq.Face) -> RoundFace | None:
    """The generator of a face; None where it is not a whole cylinder or cone."""
    surface = BRepAdaptor_Surface(face.wrapped)
    kind = surface.GetType()
    if kind not in (GeomAbs_Cylinder, GeomAbs_Cone):
        return None
    turn = surface.LastUParameter() - surface.FirstUParameter()
    if turn < 2 * math.pi - 1e-6 or len(face.Edges()) > 3:  # two circles and the seam
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
    return RoundFace(off, foot, unit, np.array(ends))


def round_distance(one: RoundFace, two: RoundFace) -> Stretches | None:
    """Smallest distance of two faces; None where their axes are not parallel, or where one may be in the other.

    The distance of two surfaces of revolution about one axis is that of their generators, two straight stretches in
    a half plane. If their axes are apart by more than both radii, it is that of the generators on the sides that face
    each other. Where the stretches are parallel, the closest places are given at both ends of what they have in common.
    """
    between = two.foot - one.foot
    across = between - (between @ one.axis) * one.axis
    apart = float(np.linalg.norm(across))
    if np.linalg.norm(np.cross(one.axis, two.axis)) > _SAME:
        return None
    shift, sense = float(between @ one.axis), math.copysign(1.0, float(one.axis @ two.axis))
    radii, heights = two.ends[:, 0], shift + sense * two.ends[:, 1]
    off = one.off
    if apart > _SAME:
        if apart <= one.ends[:, 0].max() + radii.max():
            return None
        off, radii = across / apart, apart - radii
    ends = one.ends, np.column_stack([radii, heights])
    tried = [(end, _nearest(end, ends[1])) for end in ends[0]] + [(_nearest(end, ends[0]), end) for end in ends[1]]
    lengths = [math.dist(a, b) for a, b in tried]
    if _cross(*ends):
        return 0.0, []
    least = min(lengths)
    near = [pair for pair, length in zip(tried, lengths, strict=True) if length <= least + _SAME]
    return least, [(_place(a, off, one), _place(b, off, one)) for a, b in near]


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


def _place(at: Array, off: Array, face: RoundFace) -> cq.Vector:
    return cq.Vector(*(face.foot + at[0] * off + at[1] * face.axis).tolist())
