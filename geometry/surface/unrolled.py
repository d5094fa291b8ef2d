"""The plan of an array on a body: places whose distances from their neighbours are those along the surface."""

from __future__ import annotations

import numpy as np
from scipy.sparse.csgraph import shortest_path

from geometry.ground.typed import Array
from geometry.surface.spread import arc_lengths

#: Rounds of the majorization, and neighbours within so many spacings that count for the stretch.
_ROUNDS, _NEIGHBOURS = 200, 1.6


def unrolled(places: Array, normals: Array, spacing: float) -> Array:
    """Places in a plan, (n, 2) float64, mm, from their mean: unrolled so that neighbours keep their distance.

    Distances are arcs between near places and their sums beyond; the plan minimises their squared relative errors,
    near ones first, by majorization (de Leeuw 1977) from classical scaling (Torgerson 1952).

    Args:
        places: (n, 3) float64, mm.
        normals: outwards, (n, 3) float64.
        spacing: usual distance of neighbours, mm.
    """
    arcs = arc_lengths(places, normals)
    reach = 2.2 * spacing
    while True:
        joined = np.where(arcs <= reach, arcs, 0.0)
        far = shortest_path(joined, directed=False)
        if np.isfinite(far).all():
            break
        reach *= 1.3
    square = -0.5 * far**2
    square = square - square.mean(axis=0) - square.mean(axis=1)[:, None] + square.mean()
    values, vectors = np.linalg.eigh(square)
    plan = vectors[:, -1:-3:-1] * np.sqrt(np.maximum(values[-1:-3:-1], 0))
    weight = 1 / np.maximum(far, 0.2 * spacing) ** 4
    np.fill_diagonal(weight, 0.0)
    laplace = np.diag(weight.sum(axis=1)) - weight
    solve = np.linalg.pinv(laplace)
    for _ in range(_ROUNDS):
        apart = np.linalg.norm(plan[:, None] - plan[None], axis=-1)
        ratio = np.where(apart > 1e-9, weight * far / np.maximum(apart, 1e-9), 0.0)
        new = solve @ ((np.diag(ratio.sum(axis=1)) - ratio) @ plan)
        still = np.abs(new - plan).max() < 1e-6 * spacing
        plan = new
        if still:
            break
    if _handedness(plan, places, normals) < 0:
        plan = plan * np.array([1.0, -1.0])
    return np.asarray(plan - plan.mean(axis=0))


def stretch_of(plan: Array, places: Array, normals: Array, spacing: float) -> tuple[float, float]:
    """Root mean square and largest of what distances between neighbours are off in a plan, as fractions.

    Args:
        plan: (n, 2) float64, mm.
        places: of the same parts in space, (n, 3) float64, mm.
        normals: outwards, (n, 3) float64.
        spacing: usual distance of neighbours, mm.
    """
    arcs = arc_lengths(places, normals)
    near = (arcs < _NEIGHBOURS * spacing) & ~np.eye(len(arcs), dtype=bool)
    if not near.any():
        return 0.0, 0.0
    apart = np.linalg.norm(plan[:, None] - plan[None], axis=-1)
    off = np.abs(apart[near] / arcs[near] - 1)
    return float(np.sqrt(np.mean(off**2))), float(off.max())


def _handedness(plan: Array, places: Array, normals: Array) -> float:
    """Positive where the plan is seen from outside: by the sense of each place's two nearest neighbours."""
    apart = np.linalg.norm(places[:, None] - places[None], axis=-1)
    nearest = np.argsort(apart, axis=1)[:, 1:3]
    first, second = nearest.T
    a, b = places[first] - places, places[second] - places
    space = np.einsum("nc,nc->n", np.cross(a, b), normals)
    p, q = plan[first] - plan, plan[second] - plan
    return float(np.sum(np.sign(space) * np.sign(p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0])))
