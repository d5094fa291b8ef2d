"""Clipping of one channel: where it reaches the limit of its format, or is cut flat below it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array

#: Consecutive equal samples at an extreme that may be a flat top.
FLAT = 8
#: Steps of the values by which a rounded crest falls, on either side, within the length of its flat part: a parabola
#: by up to 13 of them. A cut one falls by more.
ROUNDED = 16.0
#: Largest step, as a share of the channel's range, that rounding alone can have made where finer ones occur elsewhere.
COARSEST = 0.01


def first_clipped(values: Array, limit: float | None = None) -> int | None:
    """Index of the first sample that is clipped; None where none is.

    Args:
        values: (n_sample,) finite, of any scale.
        limit: as of :func:`clipped_samples`.
    """
    found = clipped_samples(values, limit)
    return int(found.argmax()) if found.any() else None


def clipped_samples(values: Array, limit: float | None = None) -> NDArray[np.bool_]:
    """Samples that are clipped.

    Clipped are all samples that reach the limit, and tops that are cut flat at whatever level: runs of at least
    :data:`FLAT` equal samples at the highest or the lowest value. A slow crest that is rounded to the steps of a format
    has such runs too, but falls off gently on a side; so does a quiet signal of few steps. Runs at the first or the
    last sample say nothing: half of their shape is unknown.

    Args:
        values: (n_sample,) finite, of any scale.
        limit: largest value of the format, in the unit of the values; None where there is none or it is not known.

    Returns:
        (n_sample,) bool.
    """
    found = np.zeros(len(values), bool) if limit is None else np.abs(values) >= limit
    for upright in (values, -values):
        for begin, end in _flat_tops(upright):
            found[begin:end] = True
    return found


def _flat_tops(values: Array) -> list[tuple[int, int]]:
    """Begins and ends of the runs at the highest value that were cut."""
    top = values.max()
    edges = np.flatnonzero(np.diff(np.concatenate([[False], values == top, [False]])))
    inner = ((begin, end) for begin, end in edges.reshape(-1, 2).tolist() if begin > 0 and end < len(values))
    runs = [(begin, end) for begin, end in inner if end - begin >= FLAT]
    if not runs:
        return []
    levels = np.unique(values)
    steps = np.diff(levels)
    # Numbers of few digits, and floating-point numbers, have finer steps near zero than at the top.
    step = max(float(steps.min()), min(float(steps[-1]), COARSEST * float(np.ptp(levels))))
    return [(begin, end) for begin, end in runs if _fall(values, begin, end) > ROUNDED * step]


def _fall(values: Array, begin: int, end: int) -> float:
    """Lesser of the two falls of the values within the length of a run before it and behind it."""
    length = end - begin
    sides = values[max(begin - length, 0) : begin], values[end : end + length]
    return float(values[begin] - max(side.min() for side in sides))
