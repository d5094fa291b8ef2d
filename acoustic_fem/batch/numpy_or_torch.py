"""NumPy or torch: what both offer under different names, chosen by the arrays that are given."""

from __future__ import annotations

from types import ModuleType

import numpy as np

from geometry.ground.typed import NumpyOrTorch

#: A NumPy array or a torch tensor; all arrays of one call are of one kind.


def namespace(array: NumpyOrTorch) -> ModuleType:
    """``numpy`` or ``torch``, whichever the array, of any shape, belongs to."""
    if isinstance(array, np.ndarray):
        return np
    import torch

    return torch


def largest(values: NumpyOrTorch) -> float:
    """Largest magnitude of an array, outside any graph of torch."""
    return float(abs(values if isinstance(values, np.ndarray) else values.detach()).max())


def inverse(values: NumpyOrTorch) -> NumpyOrTorch:
    """Inverse of every value, same shape as the values: torch divides complex numbers faster than it inverts them."""
    return 1 / values if isinstance(values, np.ndarray) else values.new_ones(()) / values


def joined(real: NumpyOrTorch, imag: NumpyOrTorch) -> NumpyOrTorch:
    """One complex array of a real and an imaginary part, of their broadcast shape."""
    if isinstance(real, np.ndarray):
        result = np.empty(real.shape, dtype=np.complex128)
        result.real, result.imag = real, imag
        return result
    return namespace(real).complex(real, imag)
