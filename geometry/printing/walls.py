"""Thinnest walls and narrowest gaps of a part: seen by rays on its facets, measured between its faces, mm."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any

import cadquery as cq
import numpy as np
from numpy.typing import NDArray
from OCP.BRepClass3d import BRepClass3d_SolidClassifier
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.TopAbs import TopAbs_IN, TopAbs_OUT
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator

from geometry.printing.overhangs import Skin, Spot, inside
from geometry.printing.round_faces import Stretches, round_distance, round_face
from geometry.solids.measure import Tessellation

#: Facets that face each other within this angle (degrees) have a wall between them; others meet in an edge.
_OPPOSED = 15.0
#: Faces have a wall between them where their normals are this close to the line of their shortest distance (degrees):
#: webs between bores that diverge by up to 80 degrees count, edges of 90 degrees that are broken by a chamfer do not.
_FACING = 40.0
#: Where walls and gaps are probed: this many places per face of the solid.
_PROBES = 40
#: The middle of that line may be this share of its length beyond the surface.
_OUTSIDE = 0.1
#: Distances below this are contact.
_CONTACT = 1e-6

Pair = tuple[int, int]


class Faces:
    """Faces of a part, made ready once for its walls and its gaps.

    Args:
        solid: the part, one valid solid.
        facets: of the solid; their ``faces`` count its faces.
    """

    def __init__(self, solid: cq.Shape, facets: Tessellation) -> None:
        self.faces, self.skin, self.deviation = solid.Faces(), Skin(facets), facets.deviation
        self.material = BRepClass3d_SolidClassifier(solid.wrapped)
        self.joined = _joined(self.faces)
        self.round_faces = [round_face(face) for face in self.faces]
        order = np.argsort(self.skin.faces, kind="stable")
        ends = np.searchsorted(self.skin.faces[order], np.arange(1, len(self.faces)))
        self.sides = [_Side(self.skin, own) for own in np.split(order, ends)]
        self.locator = _locator(self.skin)


def thinnest_wall(faces: Faces) -> Spot:
    """Smallest distance through the material between faces that face each other.

    Rays go inwards from 40 places of every face. A first hit counts where its facet faces the start within 15
    degrees. If faces share no corner and might be closer than that, their smallest distance is measured on the
    solid; it counts where both faces look along it within 40 degrees. Infinite when nothing is opposed.
    """
    return _narrowest(faces, -1.0)


def narrowest_gap(faces: Faces) -> Spot:
    """Smallest distance through air between different faces that face each other, as :func:`thinnest_wall`.

    A bore faces only itself: it is a hole, not a gap.
    """
    return _narrowest(faces, 1.0)


def _narrowest(part: Faces, sense: float) -> Spot:
    seen = _seen(part, sense)
    bound = min((spot.value for spot in seen.values()), default=math.inf)
    sides = part.sides
    best, measured = Spot(math.inf, None), set()
    for apart, pair in _near(sides, bound + 2 * part.deviation, part.deviation):
        if pair in part.joined:
            continue
        if apart < best.value:
            first, second = pair
            if not sides[first].may_face(sides[second], sense):
                continue
            found = _between(part, pair, sense, best.value)
            if found is None:
                continue  # where they are closest they do not face each other: what rays saw of them stands
            best = min(best, found, key=_value)
        measured.add(pair)
    return min([best, *(spot for pair, spot in seen.items() if pair not in measured)], key=_value)


def _value(spot: Spot) -> float:
    return spot.value


# -- faces ----------------------------------------------------------------------------------------------------
class _Side:
    """Position and direction of one face, from its facets."""

    def __init__(self, skin: Skin, own: NDArray[np.int_]) -> None:
        self.corners = skin.corners[own].reshape(-1, 3)
        self.normals = np.unique(np.round(skin.normals[own], 2), axis=0)
        self.flat = len(self.normals) == 1
        self.low = self.corners.min(axis=0, initial=math.inf)
        self.high = self.corners.max(axis=0, initial=-math.inf)

    def may_face(self, other: _Side, sense: float) -> bool:
        """True where any places of two faces could look at each other; sense -1 through material, 1 through air."""
        if (self.normals @ other.normals.T).min() > 0.05 - _cosine(2 * _FACING):
            return False
        return all(
            not one.flat or (sense * (two.corners - one.corners[0]) @ one.normals[0]).max() > 0
            for one, two in ((self, other), (other, self))
        )


def _near(sides: list[_Side], within: float, margin: float) -> list[tuple[float, Pair]]:
    """Pairs of faces whose boxes, wider by a margin, are closer than that: distance and pair, the closest first."""
    low, high = np.array([side.low for side in sides]) - margin, np.array([side.high for side in sides]) + margin
    found: list[tuple[float, Pair]] = []
    for i in range(len(sides) - 1):
        apart = np.linalg.norm(np.maximum(np.maximum(low[i + 1 :] - high[i], low[i] - high[i + 1 :]), 0.0), axis=1)
        found += [(float(apart[k]), (i, i + 1 + k)) for k in np.flatnonzero(apart < within).tolist()]
    return sorted(found)


def _joined(faces: list[cq.Face]) -> set[Pair]:
    """Pairs of faces that share a corner; those that share an edge share the corners at its ends."""
    owners: dict[Any, list[int]] = {}
    for index, face in enumerate(faces):
        for corner in set(face.Vertices()):
            owners.setdefault(corner, []).append(index)
    return {pair for indices in owners.values() for pair in combinations(sorted(set(indices)), 2)}


def _between(part: Faces, pair: Pair, sense: float, least: float) -> Spot | None:
    """The smallest distance of two faces where they face each other there; sense -1 through material, 1 through air."""
    first, second = (part.faces[index] for index in pair)
    one, two = (part.round_faces[index] for index in pair)
    in_closed_form = None if one is None or two is None else round_distance(one, two)
    value, stretches = in_closed_form or _distance(first, second)
    if value < _CONTACT:
        return None
    for start, end in stretches:
        along = (end - start) * (sense / value)
        if min(first.normalAt(start).dot(along), -second.normalAt(end).dot(along)) < _cosine(_FACING):
            continue
        middle = (start + end) / 2
        # On the surface is well: across the end of a fin the shortest way runs along it, between the mouths of two
        # bores in a round wall just outside.
        if value < least:  # else whatever lies between does not matter, and to ask takes longest
            part.material.Perform(middle.toPnt(), _OUTSIDE * value)
        if value >= least or part.material.State() != (TopAbs_OUT if sense < 0 else TopAbs_IN):
            return Spot(value, middle.toTuple())
    return None


def _distance(first: cq.Face, second: cq.Face) -> Stretches:
    measured = BRepExtrema_DistShapeShape(first.wrapped, second.wrapped)
    ends = range(1, measured.NbSolution() + 1)
    return measured.Value(), [
        (cq.Vector(measured.PointOnShape1(k)), cq.Vector(measured.PointOnShape2(k))) for k in ends
    ]


def _cosine(degrees: float) -> float:
    return math.cos(math.radians(degrees))


# -- rays -----------------------------------------------------------------------------------------------------
def _seen(part: Faces, sense: float) -> dict[Pair, Spot]:
    """Faces that see each other along rays, first the one with the lower number, and the shortest of their rays."""
    random = np.random.default_rng(0)
    skin, locator = part.skin, part.locator
    reach = float(np.linalg.norm(np.ptp(skin.vertices, axis=0))) + 1.0
    shortest: dict[Pair, Spot] = {}
    t, sub, cell, hit, inner = mutable(0.0), mutable(0), mutable(0), [0.0] * 3, [0.0] * 3
    order = np.argsort(skin.faces, kind="stable")
    for own in np.split(order, np.flatnonzero(np.diff(skin.faces[order])) + 1):
        face = int(skin.faces[own[0]])
        chosen = random.choice(own, _PROBES, p=skin.areas[own] / skin.areas[own].sum())
        starts = inside(skin.corners[chosen], random)
        rays = sense * skin.normals[chosen]
        begins, ends = (starts + 1e-6 * rays).tolist(), (starts + reach * rays).tolist()
        for k in range(_PROBES):
            if not locator.IntersectWithLine(begins[k], ends[k], 0.0, t, hit, inner, sub, cell):
                continue
            other = int(skin.faces[int(cell)])
            if (sense > 0 and other == face) or -sense * float(skin.normals[int(cell)] @ rays[k]) <= _cosine(_OPPOSED):
                continue
            pair, apart = (min(face, other), max(face, other)), math.dist(starts[k], hit)
            if pair not in shortest or apart < shortest[pair].value:
                x, y, z = ((starts[k] + hit) / 2).tolist()
                shortest[pair] = Spot(apart, (x, y, z))
    return shortest


def _locator(skin: Skin) -> Any:  # its stubs know no references
    points, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(skin.vertices), deep=True))
    offsets = np.arange(0, 3 * len(skin.triangles) + 1, 3, dtype=np.int64)
    connections = np.ascontiguousarray(skin.triangles.reshape(-1), dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(connections, deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    return locator
