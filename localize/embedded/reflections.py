"""Orthogonal matrices as products of Householder reflections: half the numbers, and none of them is ever subtracted.

With q_1 ... q_n the orthonormal directions of a point, the reflections H_k = I - v_k v_k^T, |v_k|^2 = 2, of the QR
decomposition of (q_1 ... q_n) turn a frame x into q_k^T x, one coordinate after the other, up to signs (Golub and Van
Loan 2013, section 5.2). v_k has n - k + 1 numbers. Four at a time read the frame and write it once: with
c_jk = v_j^T v_k their products with it are a_j = v_j^T x - sum_(k<j) c_jk a_k.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array

BLOCK = 4
"""Number of reflections that are done at once."""
LARGEST = 32767
"""Largest number of 16 bits."""
LONGEST = 16
"""Length of a vector of 16 bits, in units of the largest number: its product with the longest frame then stays one of
32 bits. Only vectors of more than 256 numbers, of five microphones, can be longer."""
_COUPLED = np.tril_indices(BLOCK, -1)


@dataclass(frozen=True, eq=False)
class Reflections:
    """Reflections of one orthogonal matrix, :data:`BLOCK` by :data:`BLOCK`."""

    numbers: NDArray[np.float32] | NDArray[np.int16]
    """Vectors of the blocks one after the other, those of a block number by number, (n_number,) float32; in 16 bits,
    int16, in units of their steps, and without the first number of each."""
    couplings: NDArray[np.float32]
    """c_21, c_31, c_32, c_41, c_42 and c_43 of every block, one after the other; (6 n_block,) float32."""
    steps: NDArray[np.float32] | None
    """Step and first number of each reflection, (2, n_reflection) float32, of 16 bits; None in single precision."""


def reflections(directions: Array, in_16_bits: bool = False) -> Reflections:
    """Reflections that turn a vector into its coordinates along some directions.

    Each is rounded before the next is sought, which then makes up for what rounding did. The first number of a vector
    is 1 or more and by far its largest: in 16 bits it is held apart, so that the others need not be as coarse, and such
    that every reflection stays one.

    Args:
        directions: (n, n) float64, orthonormal columns, n even.
        in_16_bits: whether numbers are rounded to 16 bits instead of to single precision.
    """
    left = np.array(directions, np.float64)
    size = len(left)
    vectors, units, steps = np.zeros((size + BLOCK, size)), np.ones(size + BLOCK), np.zeros((2, size + BLOCK))
    for stage in range(size - 1):
        vector = _reflection(left[stage:, stage])
        if in_16_bits:
            largest = max(np.abs(vector[1:]).max(), np.linalg.norm(vector[1:]) / LONGEST, np.finfo(np.float32).tiny)
            units[stage] = np.float32(largest / LARGEST)
            vector[1:] = units[stage] * np.rint(vector[1:] / units[stage]).clip(-LARGEST, LARGEST)
            vector[0] = np.sqrt(2.0 - (vector[1:] ** 2).sum())
            steps[:, stage] = units[stage], vector[0]
        else:
            vector = vector.astype(np.float32).astype(np.float64)
        left[stage:, stage:] -= np.outer(vector, vector @ left[stage:, stage:])
        vectors[stage, stage:] = vector
    numbers, couplings = [], []
    for stage in range(0, size, BLOCK):
        block = vectors[stage : stage + BLOCK]
        couplings.append((block @ block.T)[_COUPLED])
        held = block[:, stage:] / units[stage : stage + BLOCK, None]
        if in_16_bits:
            np.fill_diagonal(held, 0.0)
        numbers.append(held.T.ravel())
    held = np.concatenate(numbers)
    count = -(-size // BLOCK) * BLOCK
    return Reflections(
        np.rint(held).astype(np.int16) if in_16_bits else held.astype(np.float32),
        np.concatenate(couplings).astype(np.float32),
        steps[:, :count].astype(np.float32) if in_16_bits else None,
    )


def _reflection(column: Array) -> Array:
    """Vector of the reflection that turns a column into its first axis; its first number is 1 or more."""
    vector = column * (np.sign(column[0]) or 1.0)
    # Away from the axis, so that nothing cancels.
    vector[0] += np.linalg.norm(column)
    return np.asarray(vector * (np.sqrt(2) / np.linalg.norm(vector)))
