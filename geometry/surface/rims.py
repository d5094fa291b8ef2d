"""Flat parts on a bent body: how high they must stand, and the gap that is left under their rims."""

from __future__ import annotations

import math

import numpy as np

from geometry.body.samples import Samples
from geometry.ground.typed import Array
from geometry.surface.tubes import directions, turned

#: Places around a rim, and the height below which a part is not raised, mm.
_PLACES, _LEAST_LIFT = 24, 0.01


def lifted_over(ground: Samples, at: Array, normals: Array, radius: float, below: float, base: float) -> Array:
    """Places raised where the body is hollow and would come closer to the rim of a flat floor than a base.

    Args:
        ground: samples of the body.
        at: places above the middles of the floors, (n, 3) float64, mm.
        normals: axes of the parts, (n, 3) float64.
        radius: of the floors, mm.
        below: distance from each place down to where its floor would be at the base, mm.
        base: least distance of the floors from the body, mm.
    """
    heights = _rim_heights(ground, at - below * normals, normals, radius)
    lift = np.maximum(base - heights.min(axis=0), 0.0)
    return np.asarray(at + np.where(lift > _LEAST_LIFT, lift, 0.0)[:, None] * normals)


def widest_gap(ground: Samples, middles: Array, normals: Array, radius: float) -> float:
    """Largest gap that the bend of a body leaves under flat discs, mm.

    It is how much further from the body one place of a disc is than another: the rim on a round body, the middle in a
    hollow.

    Args:
        ground: samples of the body.
        middles: of the discs, (n, 3) float64, mm.
        normals: of the discs, (n, 3) float64.
        radius: of the discs, mm.
    """
    foot, own = ground.projected(middles)
    heights = np.vstack([_rim_heights(ground, middles, normals, radius), np.einsum("nc,nc->n", middles - foot, own)])
    return float(np.ptp(heights, axis=0).max())


def _rim_heights(ground: Samples, middles: Array, normals: Array, radius: float) -> Array:
    """Heights above a body of places around the rims of discs, (k, n) float64, mm."""
    across = directions(middles, normals, middles + np.roll(normals, 1, axis=1))
    heights = []
    for angle in np.linspace(0, 2 * math.pi, _PLACES, endpoint=False):
        rim = middles + radius * turned(across, normals, np.full(len(middles), angle))
        foot, own = ground.projected(rim)
        heights.append(np.einsum("nc,nc->n", rim - foot, own))
    return np.array(heights)
