"""Polynomials in the shape of a cell and the layers in its air: the same code for NumPy arrays and torch tensors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array, NumpyOrTorch

#: A NumPy array or a torch tensor; all arrays of one call are of one kind.


@dataclass(frozen=True, eq=False)
class ShapePolynomial:
    """Two real polynomials over ratios of lengths and a layer's number.

    Sum over m, n of c_mn x^p_m v^n. The number is that of :func:`layer_number` or its root.
    """

    powers: NDArray[np.int64]
    """Powers p_m of the ratios in each term, (n_term, n_ratio) int64."""
    real: Array
    """Coefficients of the first, (n_term, n_layer) float64, in the unit of what is fitted."""
    imag: Array
    """Coefficients of the second, (n_term, n_layer) float64, in the same unit."""

    def __call__(self, ratios: Sequence[NumpyOrTorch], layer: NumpyOrTorch) -> tuple[NumpyOrTorch, NumpyOrTorch]:
        """Values of both, float64, of the broadcast shape.

        Args:
            ratios: as many as ``powers`` has columns, each of a shape that broadcasts with that of ``layer``, float64.
            layer: the layer's number, float64.
        """
        terms = [_term(ratios, powers) for powers in self.powers]
        return _series(terms, self.real, layer), _series(terms, self.imag, layer)


def layer_number(square: NumpyOrTorch) -> NumpyOrTorch:
    """sqrt(1 + s^2/4) - 1 of the square of a shear number s; shape of the square, float64.

    It goes with s^2 where the layer fills the bore and with s where it is thin, as impedances of openings do.
    """
    return (1 + square / 4) ** 0.5 - 1


def _term(ratios: Sequence[NumpyOrTorch], powers: NDArray[np.int64]) -> NumpyOrTorch:
    value: NumpyOrTorch = 1.0
    for ratio, power in zip(ratios, powers, strict=True):
        if power:
            value = value * ratio ** int(power)
    return value


def _series(terms: Sequence[NumpyOrTorch], coefficients: Array, layer: NumpyOrTorch) -> NumpyOrTorch:
    """Horner's rule in the layer's number."""
    total: NumpyOrTorch = 0.0
    for column in coefficients.T[::-1]:
        here: NumpyOrTorch = 0.0
        for coefficient, term in zip(column, terms, strict=True):
            here = here + float(coefficient) * term
        total = total * layer + here
    return total
