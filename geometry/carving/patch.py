"""The part of a body under an array: its facets up to a smooth edge, and the layer between two heights above it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, diags_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from geometry.body.samples import Samples
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

if TYPE_CHECKING:
    import manifold3d

Corners = NDArray[np.int64]

#: Rounds in which the edge is smoothed, and the least distance of a corner from it, in edges of the facets.
_SMOOTH, _LEAST = 6, 0.15
#: Reach of the mean of normals, in edges of the facets.
_NORMALS = 1.5


@dataclass(frozen=True)
class Patch:
    """Facets of a part of a surface."""

    places: Array
    """Corners, (n, 3) float64, mm."""
    normals: Array
    """Outwards, (n, 3) float64."""
    triangles: Corners
    """Corners of each facet, (m, 3) int64."""

    def layer(self, low: float, high: float) -> manifold3d.Manifold:
        """The closed space between two heights above the patch, mm.

        Raises:
            Refusal: it folds, because the body is hollow with a radius below the height.
        """
        import manifold3d

        below, above = (self.places + height * self.normals for height in (low, high))
        edges = [np.roll(places[self.triangles], -1, axis=1) - places[self.triangles] for places in (below, above)]
        # Above the middle of a hollow its edges are turned round.
        folded = (np.einsum("nkc,nkc->nk", *edges) <= 0).any(axis=1)
        if folded.any():
            x, y, z = self.places[self.triangles[folded]].reshape(-1, 3).mean(axis=0)
            raise Refusal(
                f"folds {high:.3g} mm above the body around ({x:.1f}, {y:.1f}, {z:.1f}) mm, where it is hollow",
                kind=Kind.CONFLICT,
                field="surface.region",
                remedy="leave the hollow out of the region",
            )
        count = len(self.places)
        directed = self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        _, first, often = np.unique(np.sort(directed, axis=1), axis=0, return_index=True, return_counts=True)
        start, end = directed[first[often == 1]].T
        walls = [
            np.column_stack([start, end, end + count]),
            np.column_stack([start, end + count, start + count]),
        ]
        facets = np.vstack([self.triangles[:, ::-1], self.triangles + count, *walls])
        mesh = manifold3d.Mesh64(np.vstack([below, above]), np.array(facets, np.uint64, order="C"))
        return manifold3d.Manifold(mesh)


def patch_under(ground: Samples, places: Array, normals: Array, reach: Array, hole: float) -> Patch:
    """The part of a body within reach of places, without small holes.

    Args:
        ground: samples of the body.
        places: on the body, (n, 3) float64, mm.
        normals: of the body there, (n, 3) float64.
        reach: how far the patch reaches around each, (n,) float64, mm.
        hole: area below which a hole is filled, mm^2.

    Raises:
        Refusal: the places do not hang together.
    """
    inside = np.full(len(ground.places), -np.inf)
    for own in np.unique(reach):
        # With the normals as further coordinates, the other side of a thin body is out of reach.
        side = 0.5 * own
        tree = cKDTree(np.hstack([places[reach == own], side * normals[reach == own]]))
        apart = tree.query(np.hstack([ground.places, side * ground.normals]))[0]
        inside = np.maximum(inside, own - apart)
    mean = diags_array(1 / np.maximum(ground.neighbours.sum(axis=1), 1)) @ ground.neighbours
    for _ in range(_SMOOTH):
        inside = (inside + mean @ inside) / 2
    inside = np.where(_holes(ground, inside <= 0, hole), np.abs(inside) + ground.edge, inside)
    pieces, _ = connected_components(ground.neighbours[inside > 0][:, inside > 0], directed=False)
    if pieces != 1:
        problem = f"would be in {pieces} pieces, because microphones stand far from the points"
        raise Refusal(problem, kind=Kind.CONFLICT, field="surface.microphones", remedy="place them nearer")
    least = _LEAST * ground.edge
    return _clipped(ground, np.where(np.abs(inside) < least, np.where(inside < 0, -least, least), inside))


def _holes(ground: Samples, outside: NDArray[np.bool_], area: float) -> NDArray[np.bool_]:
    """Samples of connected parts of those outside whose area is below a limit, (n,) bool."""
    count, label = connected_components(ground.neighbours[outside][:, outside], directed=False)
    sizes = np.bincount(label, ground.areas[outside], minlength=count)
    found = np.zeros(len(outside), bool)
    found[outside] = sizes[label] < area
    return found


def _clipped(ground: Samples, inside: Array) -> Patch:
    """Facets where a function of the samples is positive, cut along its zero line."""
    triangles = ground.triangles
    positive = inside > 0
    count = positive[triangles].sum(axis=1)
    crossing = triangles[(count == 1) | (count == 2)]
    # Turned so that the corner that is alone on its side is the first.
    signs = positive[crossing]
    alone = np.where(signs.sum(axis=1) == 1, np.argmax(signs, axis=1), np.argmin(signs, axis=1))
    turned = np.take_along_axis(crossing, (alone[:, None] + np.arange(3)) % 3, axis=1)
    edges = np.sort(np.vstack([turned[:, [0, 1]], turned[:, [0, 2]]]), axis=1)
    unique, place = np.unique(edges, axis=0, return_inverse=True)
    i, j = unique.T
    fraction = (inside[i] / (inside[i] - inside[j]))[:, None]
    places = np.vstack([ground.places, (1 - fraction) * ground.places[i] + fraction * ground.places[j]])
    normals = np.vstack([ground.normals, (1 - fraction) * ground.normals[i] + fraction * ground.normals[j]])
    first, second = (len(ground.places) + place.reshape(2, -1)).astype(np.int64)
    tip = positive[turned[:, 0]]
    a, b, c = turned.T
    facets = np.vstack(
        [
            triangles[count == 3],
            np.column_stack([a, first, second])[tip],
            np.column_stack([first, b, c])[~tip],
            np.column_stack([first, c, second])[~tip],
        ]
    )
    used, facets = np.unique(facets, return_inverse=True)
    return Patch(places[used], _smooth_normals(ground, places[used], normals[used]), facets.reshape(-1, 3))


def _smooth_normals(ground: Samples, places: Array, normals: Array) -> Array:
    """Means of the normals within some edges of each place (n, 3), by area and distance; (n, 3) float64.

    They change little over a short way, so that a layer along them does not fold where facets are narrow.
    """
    reach = _NORMALS * ground.edge
    near = cKDTree(places).sparse_distance_matrix(ground.tree, 2.5 * reach, output_type="coo_matrix")
    same_side = np.einsum("nc,nc->n", normals[near.row], ground.normals[near.col]) > 0
    weight = ground.areas[near.col] * np.exp(-((near.data / reach) ** 2)) * same_side
    mean = coo_array((weight, (near.row, near.col)), shape=(len(places), len(ground.places))).tocsr() @ ground.normals
    return np.asarray(mean / np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-12))
