"""The region of a body by its nearest points: the area of each point's cell and the distances in it."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from geometry.body.samples import Samples
from geometry.ground.typed import Array
from geometry.surface.regions import Mask
from geometry.surface.spread import arc_length

#: Points that are compared for each place, and distances that are kept of each cell.
_CANDIDATES, _KEPT = 8, 21
#: Digits of areas and distances, mm.
_DIGITS = 4


def cells_of(
    samples: Samples, region: Mask, points: Array, normals: Array, radius: float
) -> tuple[list[dict[str, Any]], Array]:
    """Cells of the points of an array, as a file of places holds them, and the place that is furthest from them.

    Distances are arcs to the rim of a membrane, and zero on it.

    Args:
        samples: the body at the height of the membranes.
        region: samples where points may be, (n_sample,) bool.
        points: middles of the membranes, (n, 3) float64, mm.
        normals: outwards, (n, 3) float64.
        radius: of a membrane, mm.

    Returns:
        Values of :class:`geometry.schema.frozen_fields.FrozenCell`, one for each point; and a place, (3,) float64, mm.
    """
    places, area = samples.places[region], samples.areas[region]
    near = cKDTree(points).query(places, k=min(_CANDIDATES, len(points)))[1].reshape(len(places), -1)
    arcs = arc_length(places[:, None], samples.normals[region][:, None], points[near], normals[near])
    nearest = arcs.argmin(axis=1)
    away = np.maximum(arcs[np.arange(len(places)), nearest] - radius, 0.0)
    own = near[np.arange(len(places)), nearest]
    cells = [_cell(away[own == point], area[own == point]) for point in range(len(points))]
    return cells, np.asarray(places[int(away.argmax())])


def _cell(away: Array, area: Array) -> dict[str, Any]:
    """One cell, from the distances of its places, mm, and the area of each, mm^2."""
    if not len(away):
        return {"area": 0.0, "distances": [0.0, 0.0]}
    order = np.argsort(away, kind="stable")
    behind, ascending = np.cumsum(area[order]), away[order]
    steps = np.linspace(0, behind[-1], _KEPT)
    kept = np.interp(steps, np.append(0.0, behind), np.append(ascending[0], ascending))
    return {"area": round(float(behind[-1]), _DIGITS), "distances": kept.round(_DIGITS).tolist()}
