"""Orthogonal matrices as products of Householder reflections: half the numbers, and none of them is ever subtracted.

With q_1 ... q_n the orthonormal directions of a point, the reflections H_k = I - v_k v_k^T, |v_k|^2 = 2, of the QR
decomposition of (q_1 ... q_n) turn a frame x into q_k^T x, one coordinate after the other, up to signs (Golub and Van
Loan 2013, section 5.2). v_k has n - k + 1 numbers.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LARGEST = 32767
"""Largest number of 16 bits."""


def reflections(directions: Array) -> NDArray[np.float32]:
    """Reflections that turn a vector into its coordinates along some directions, in single precision.

    Each is rounded before the next is sought, which then makes up for what rounding did.

    Args:
        directions: (n, n) float64, orthonormal columns.

    Returns:
        (n (n + 1) / 2 - 1,): the vectors of all n - 1 reflections, one after the other.
    """
    left, vectors = np.array(directions, np.float64), []
    for stage in range(len(left) - 1):
        vectors.append(_reflection(left[stage:, stage]).astype(np.float32))
        _reflect(left[stage:, stage:], vectors[-1].astype(np.float64))
    return np.concatenate(vectors)


def reflections_of_16_bits(directions: Array) -> tuple[NDArray[np.int16], NDArray[np.float32]]:
    """Reflections of :func:`reflections` as 16-bit numbers and two factors for each.

    The first number of a vector is 1 or more and by far its largest: it is held apart, so that the others need not be
    as coarse, and such that every reflection stays one, whatever rounding did to its direction.

    Args:
        directions: (n, n) float64, orthonormal columns.

    Returns:
        (n (n - 1) / 2,): what follows the first number of each vector; and (n - 1, 2): what these are to be multiplied
        by, and the first number.
    """
    left, held, factors = np.array(directions, np.float64), [], []
    for stage in range(len(left) - 1):
        rest = _reflection(left[stage:, stage])[1:]
        step = float(np.float32(max(np.abs(rest).max(), np.finfo(np.float32).tiny) / LARGEST))
        held.append(np.rint(rest / step).clip(-LARGEST, LARGEST))
        first = np.sqrt(2.0 - (step**2) * (held[-1] ** 2).sum())
        factors.append((step, first))
        _reflect(left[stage:, stage:], np.concatenate([[first], step * held[-1]]))
    return np.concatenate(held).astype(np.int16), np.array(factors, np.float32)


def _reflection(column: Array) -> Array:
    """Vector of the reflection that turns a column into its first axis; its first number is 1 or more."""
    vector = column * (np.sign(column[0]) or 1.0)
    # Away from the axis, so that nothing cancels.
    vector[0] += np.linalg.norm(column)
    return np.asarray(vector * (np.sqrt(2) / np.linalg.norm(vector)))


def _reflect(columns: Array, vector: Array) -> None:
    columns -= np.outer(vector, vector @ columns)
