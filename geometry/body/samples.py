"""A body as evenly spaced places with smooth normals: projection onto it, curvature, connection and distances."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, diags_array
from scipy.spatial import cKDTree

from geometry.body.reading import Body, Corners
from geometry.ground.extras import check_extras
from geometry.ground.typed import Array

#: Slivers within this distance of the body are taken out before facets are divided, mm.
_SLIVERS = 0.01
#: Neighbours over which a place is projected, and their reach in edges of the facets.
_NEIGHBOURS, _REACH = 12, 1.2
#: Difference of two unit normals from which they belong to two sides of a thin body: 120 degrees apart.
_OTHER_SIDE = math.sqrt(3)


@dataclass(frozen=True)
class Samples:
    """Corners of small facets of a body."""

    places: Array
    """(n, 3) float64, mm."""
    normals: Array
    """Outwards, smoothed over some facets, (n, 3) float64."""
    triangles: Corners
    """Corners of each small facet, (m, 3) int64."""
    faces: NDArray[np.int64]
    """Number of the face of the body at each, from 1, (n,) int64."""
    neighbours: csr_array
    """Ones for pairs that an edge joins, (n, n)."""
    edge: float
    """Longest edge of the facets, mm."""

    @cached_property
    def areas(self) -> Array:
        """Area that each place stands for, (n,) float64, mm^2."""
        a, b, c = (self.places[self.triangles[:, k]] for k in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6
        return np.asarray(np.bincount(self.triangles.ravel(), np.repeat(area, 3), len(self.places)), np.float64)

    def lifted(self, height: float) -> Samples:
        """The surface at a height above the body, mm; within its radius where it is hollow."""
        return replace(self, places=self.places + height * self.normals)

    @cached_property
    def tree(self) -> cKDTree:
        """Places, to look up the nearest."""
        return cKDTree(self.places)

    def projected(self, points: Array) -> tuple[Array, Array]:
        """Places on the smooth surface near points (n, 3), mm, and its normals there; both (n, 3) float64.

        The surface is that of weighted means of the nearest samples and their normals (Alexa et al. 2004).
        """
        apart, near = map(np.asarray, self.tree.query(points, k=_NEIGHBOURS))
        reach = np.maximum(_REACH * self.edge, apart[:, :1])
        same_side = np.einsum("nkc,nc->nk", self.normals[near], self.normals[near[:, 0]]) > 0
        weight = np.exp(-((apart / reach) ** 2)) * same_side
        weight /= weight.sum(axis=1, keepdims=True)
        normal = np.einsum("nk,nkc->nc", weight, self.normals[near])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
        mean = np.einsum("nk,nkc->nc", weight, self.places[near])
        return points - np.einsum("nc,nc->n", points - mean, normal)[:, None] * normal, normal

    def bend(self, radius: float) -> Array:
        """Largest curvature between each place and those up to a radius around it, (n,) float64, 1/mm.

        By the change of the normal over the chord, of pairs that are 0.4 to 1 radii apart: what a rigid disc of that
        radius meets. The other side of a thin body does not count.
        """
        least = max(0.4 * radius, 0.8 * self.edge)
        pairs = self.tree.query_pairs(max(radius, 2.2 * self.edge), output_type="ndarray")
        i, j = pairs.T
        chord = np.linalg.norm(self.places[i] - self.places[j], axis=1)
        change = np.linalg.norm(self.normals[i] - self.normals[j], axis=1)
        far = (chord >= least) & (change < _OTHER_SIDE)
        bend = np.zeros(len(self.places))
        bent = change[far] / chord[far]
        np.maximum.at(bend, i[far], bent)
        np.maximum.at(bend, j[far], bent)
        return bend


def samples_of(body: Body, edge: float) -> Samples:
    """Corners of a body's facets after these are divided to edges of at most a length, mm.

    Raises:
        MissingExtra: manifold3d is not installed.
    """
    check_extras("dividing the facets of a body", "cad")
    import manifold3d

    mesh = manifold3d.Mesh64(
        np.array(body.vertices, np.float64, order="C"),
        np.array(body.triangles, np.uint64, order="C"),
        face_id=np.array(body.faces, np.uint64),
    )
    fine = manifold3d.Manifold(mesh).simplify(_SLIVERS).refine_to_length(edge).to_mesh64()
    places = np.asarray(fine.vert_properties, np.float64)[:, :3]
    triangles = np.asarray(fine.tri_verts, np.int64)
    numbers = np.asarray(fine.face_id, np.int64)
    count = len(places)
    a, b, c = (places[triangles[:, k]] for k in range(3))
    facets = np.cross(b - a, c - a)
    normals = np.zeros((count, 3))
    for k in range(3):
        np.add.at(normals, triangles[:, k], facets)
    joined = _joined(triangles, count)
    faces = np.zeros(count, np.int64)
    for k in range(3):
        faces[triangles[:, k]] = numbers
    return Samples(places, _smooth(normals, joined), triangles, faces, joined, edge)


def _joined(triangles: Corners, count: int) -> csr_array:
    ends = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    ends = np.unique(np.sort(ends, axis=1), axis=0)
    i, j = np.concatenate([ends, ends[:, ::-1]]).T
    return csr_array((np.ones(len(i)), (i, j)), shape=(count, count))


def _smooth(normals: Array, joined: csr_array, rounds: int = 4) -> Array:
    """Unit normals, each the mean of itself and its neighbours some rounds over."""
    unit = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    mean = diags_array(1 / np.maximum(joined.sum(axis=1), 1)) @ joined
    for _ in range(rounds):
        unit = unit + mean @ unit
        unit /= np.maximum(np.linalg.norm(unit, axis=1, keepdims=True), 1e-300)
    return np.asarray(unit)
