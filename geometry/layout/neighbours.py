"""Pairs of places that lie close together."""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array


def near_pairs(first: Array, second: Array, reach: float) -> NDArray[np.intp]:
    """Places of two sets at most ``reach`` apart, found among those of the neighbouring cells of a grid.

    The trees of SciPy take longer to load than a layout takes to check.

    Args:
        first: (n, 3) float64, mm.
        second: (m, 3) float64, mm.
        reach: distance, mm, above 0.

    Returns:
        (n_pair, 2) indices into the first and the second set.
    """
    corner = np.minimum(first.min(axis=0), second.min(axis=0)) - 2 * reach
    cell, others = (((places - corner) / reach).astype(np.intp) for places in (first, second))
    _, rows, layers = np.maximum(cell.max(axis=0), others.max(axis=0)) + 2
    # cells that follow each other along the last axis have consecutive numbers
    strides = np.array([rows * layers, layers, 1])
    number = others @ strides
    order = np.argsort(number)
    found = []
    for shift in product((-1, 0, 1), repeat=2):
        middle = cell @ strides + np.dot(shift, strides[:2])
        low = np.searchsorted(number, middle - 1, sorter=order)
        count = np.searchsorted(number, middle + 1, "right", sorter=order) - low
        i = np.repeat(np.arange(len(first)), count)
        j = order[np.arange(len(i)) + np.repeat(low + count - np.cumsum(count), count)]
        near = np.square(first[i] - second[j]).sum(axis=1) <= reach**2
        found.append(np.column_stack([i[near], j[near]]))
    return np.concatenate(found)
