"""NumPy or torch: what both offer under different names, chosen by the arrays that are given."""

from __future__ import annotations

from types import ModuleType
from typing import Any, TypeAlias

import numpy as np

#: A NumPy array or a torch tensor; all arrays of one call are of one kind.
Array: TypeAlias = Any


def namespace(array: Array) -> ModuleType:
    """``numpy`` or ``torch``, whichever the array, of any shape, belongs to."""
    if isinstance(array, np.ndarray):
        return np
    import torch

    return torch


def largest(values: Array) -> float:
    """Largest magnitude of an array, outside any graph of torch."""
    return float(abs(values if isinstance(values, np.ndarray) else values.detach()).max())


def inverse(values: Array) -> Array:
    """Inverse of every value, same shape as the values: torch divides complex numbers faster than it inverts them."""
    return 1 / values if isinstance(values, np.ndarray) else values.new_ones(()) / values


def joined(real: Array, imag: Array) -> Array:
    """One complex array of a real and an imaginary part, of their broadcast shape."""
    if isinstance(real, np.ndarray):
        result = np.empty(real.shape, dtype=np.complex128)
        result.real, result.imag = real, imag
        return result
    return namespace(real).complex(real, imag)
