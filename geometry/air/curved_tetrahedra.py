"""Second-order tetrahedra: shape functions, Jacobians, volume, and elements that would lock a pressure."""

from __future__ import annotations

import itertools
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array

_CORNERS = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
#: Corners at both ends of the edges whose middles are the nodes 4 to 9 of a tetrahedron.
EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))


def split_wall_corners(
    nodes: Array, tetrahedra: NDArray[np.int64], triangles: Mapping[str, NDArray[np.int64]]
) -> tuple[Array, NDArray[np.int64]]:
    """Split tetrahedra with three or more faces on the boundary at their centre.

    The pressure at their common corner belongs to no free velocity and would be locked: the element's
    volume would drop out of the compliance.

    Args:
        nodes: (n_node, 3) float64, in any unit.
        tetrahedra: (n_tetrahedron, 10) int64: corners, then the middles of :data:`EDGES`.
        triangles: corner nodes of the boundary by name, (n_triangle, 3) int64 each.

    Returns:
        Nodes (n_node + n_new, 3) float64 and tetrahedra (n_tetrahedron + n_more, 10) int64.
    """
    boundary = {tuple(sorted(t)) for part in triangles.values() for t in part.tolist()}
    opposite = ((1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2))
    corners = tetrahedra[:, :4]
    # Only elements with four boundary corners can have three boundary faces: a cheap first sieve.
    on_boundary = np.zeros(len(nodes), dtype=bool)
    on_boundary[np.concatenate([part.ravel() for part in triangles.values()])] = True
    candidates = np.flatnonzero(on_boundary[corners].all(axis=1))
    locked = [
        e
        for e in candidates.tolist()
        if sum(tuple(sorted(int(corners[e, k]) for k in face)) in boundary for face in opposite) >= 3
    ]
    if not locked:
        return nodes, tetrahedra
    new_nodes, new_elements = [nodes], []
    count = len(nodes)
    for e in locked:
        element = tetrahedra[e]
        centre = np.full(3, 0.25)
        inner = [centre] + [(centre + corner) / 2 for corner in _CORNERS]
        new_nodes.append(_shape_functions(np.array(inner)) @ nodes[element])
        middle, to_corner = count, [count + 1 + k for k in range(4)]
        count += 5
        edge = {frozenset(pair): int(element[4 + k]) for k, pair in enumerate(EDGES)}
        for k in range(4):
            vertices = [middle if i == k else int(element[i]) for i in range(4)]
            mid_nodes = [to_corner[b if a == k else a] if k in (a, b) else edge[frozenset((a, b))] for a, b in EDGES]
            new_elements.append(vertices + mid_nodes)
    kept = np.delete(tetrahedra, locked, axis=0)
    return np.concatenate(new_nodes), np.concatenate([kept, np.array(new_elements, dtype=np.int64)])


def _shape_functions(points: Array) -> Array:
    """Quadratic shape functions at reference points (n, 3): (n, 10)."""
    corner = np.column_stack([1 - points.sum(axis=1), points])
    at_corners = corner * (2 * corner - 1)
    at_edges = np.column_stack([4 * corner[:, a] * corner[:, b] for a, b in EDGES])
    return np.column_stack([at_corners, at_edges])


def _shape_gradients(point: Array) -> Array:
    """Gradients of the quadratic shape functions at one reference point: (3, 10)."""
    corner = np.array([1 - point.sum(), *point])
    slopes = np.vstack([-np.ones(3), np.eye(3)])
    at_corners = (4 * corner - 1)[:, None] * slopes
    at_edges = [4 * (corner[a] * slopes[b] + corner[b] * slopes[a]) for a, b in EDGES]
    return np.vstack([at_corners, at_edges]).T


def jacobians(nodes: Array, tetrahedra: NDArray[np.int64], points: Array) -> Array:
    """Jacobian determinants of curved elements.

    Args:
        nodes: (n_node, 3) float64, in any unit.
        tetrahedra: (n_tetrahedron, 10) int64.
        points: (n, 3) float64, places in the reference element.

    Returns:
        (n, n_tetrahedron) float64, in the cube of the nodes' unit.
    """
    places = nodes[tetrahedra]
    columns = [np.einsum("ka,ean->ken", _shape_gradients(point), places) for point in points]
    return np.stack([np.einsum("en,en->e", np.cross(x, y), z) for x, y, z in columns])


def _barycentric(*rows: tuple[float, float, float, float]) -> Array:
    """Reference points (n, 3) of all permutations of barycentric coordinates."""
    return np.array(sorted({order for row in rows for order in itertools.permutations(row)}))[:, 1:]


#: A rule of four equal weights, exact for the volume's cubic; and the points of the rule of order 4 by which the
#: solvers integrate (Keast 1986). They take the Jacobian's magnitude there: where it is negative the divergence
#: theorem is lost and admittances come out wrong without a word.
VOLUME_RULE = _barycentric((0.5854101966249685, *3 * (0.1381966011250105,)))
SOLVER_RULE = _barycentric(
    (0.25,) * 4, (11 / 14, *3 * (1 / 14,)), 2 * (0.3994035761667992,) + 2 * (0.1005964238332008,)
)


def curved_volume(nodes: Array, tetrahedra: NDArray[np.int64]) -> float:
    """Volume of all elements, in the cube of the nodes' unit.

    Args:
        nodes: (n_node, 3) float64.
        tetrahedra: (n_tetrahedron, 10) int64.
    """
    return float(jacobians(nodes, tetrahedra, VOLUME_RULE).sum() / 24)
