"""Ratios of responses, also where both are so small that they underflow to zero."""

from __future__ import annotations

import numpy as np

from geometry.ground.typed import ComplexArray

INAUDIBLE = 1e-100
"""Size of a transfer function below which no microphone receives anything: -2000 dB, as across a long array of narrow
tubes at 500 Hz. Its digits are those of rounding, or zero."""


def audible_ratio(values: ComplexArray, reference: ComplexArray) -> ComplexArray:
    """Responses over reference responses; 1 where either is inaudible.

    Args:
        values: complex128 of any shape.
        reference: complex128 whose shape broadcasts with that of the values.

    Returns:
        Complex128 ratios, all of them finite.
    """
    values, reference = np.broadcast_arrays(values, reference)
    heard = (np.abs(values) > INAUDIBLE) & (np.abs(reference) > INAUDIBLE)
    return np.divide(values, reference, out=np.ones(values.shape, np.complex128), where=heard)
