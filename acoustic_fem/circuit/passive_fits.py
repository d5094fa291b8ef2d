"""Resistors, capacitors and inductors that behave as a viscous tube, as air that cools at walls, or as rubber.

Each of these is a sum of relaxations with positive weights. Their rates are chosen beforehand, some to a decade, and
the weights are found by non-negative least squares (C. L. Lawson and R. J. Hanson, Solving Least Squares Problems
(1974), chapter 23), so every element is positive and the circuit is passive whatever the fit is. Foster's forms of
such circuits: W. Cauer, Theorie der linearen Wechselstromschaltungen (1941).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import nnls

from geometry.ground.typed import Array, ComplexArray

#: Relaxations in a decade.
BY_DECADE = 6
#: Frequencies of a fit in a decade.
_FREQUENCIES_BY_DECADE = 12
#: Weights below this part of the largest one are left out.
_NEGLIGIBLE = 1e-9


def fit_grid(low: float, high: float) -> Array:
    """Frequencies on which a band is fitted, (n,) float64, Hz."""
    return np.geomspace(low, high, round(np.log10(high / low) * _FREQUENCIES_BY_DECADE) + 1)


@dataclass(frozen=True, eq=False)
class Relaxations:
    """Sum of a constant, a term with one more or one less power of frequency, and relaxations, all positive."""

    constant: float
    """Resistance of a series impedance, or conductance of a shunt admittance; SI units of what was fitted."""
    reactive: float
    """Inductance of a series impedance, or capacitance of a shunt admittance."""
    elastic: float
    """Inverse of the capacitance in series, of a membrane; 0 elsewhere."""
    weight: Array
    """Weights of the relaxations, (n,) float64, above 0."""
    rate: Array
    """Their rates, (n,) float64, 1/s."""
    error: float
    """Largest error of the fit, relative to the magnitude."""


def fit_rising(values: ComplexArray, frequency: Array) -> Relaxations:
    """Fit of c + s a + sum w s / (s + p): the impedance of a tube, or the admittance of air with c = 0 and w p.

    Args:
        values: (n,) complex128, in any unit.
        frequency: (n,) float64, Hz.
    """
    s = np.asarray(2j * np.pi * frequency, np.complex128)
    rate = _rates(frequency)
    return _fitted(values, rate, np.ones_like(s), s, None, s[:, None] / (s[:, None] + rate))


def fit_falling(values: ComplexArray, frequency: Array) -> Relaxations:
    """Fit of c + s a + e / s + sum w / (s + p): the impedance of a membrane.

    Arguments as :func:`fit_rising`.
    """
    s = np.asarray(2j * np.pi * frequency, np.complex128)
    rate = _rates(frequency)
    terms = np.asarray(1 / (s[:, None] + rate), np.complex128)
    return _fitted(values, rate, np.ones_like(s), s, np.asarray(1 / s, np.complex128), terms)


def _rates(frequency: Array) -> Array:
    low, high = float(frequency[0]), float(frequency[-1])
    return 2 * np.pi * np.geomspace(low / 3, high * 10, round(np.log10(30 * high / low) * BY_DECADE) + 1)


def _fitted(
    values: ComplexArray,
    rate: Array,
    constant: ComplexArray,
    reactive: ComplexArray,
    elastic: ComplexArray | None,
    terms: ComplexArray,
) -> Relaxations:
    none = np.zeros((len(values), 1), np.complex128) if elastic is None else elastic[:, None]
    relative = np.concatenate([constant[:, None], reactive[:, None], none, terms], axis=1) / values[:, None]
    matrix = np.concatenate([relative.real, relative.imag])
    scale = np.linalg.norm(matrix, axis=0)
    scale[scale == 0] = 1.0
    wanted = np.repeat([1.0, 0.0], len(values))
    found = nnls(matrix / scale, wanted, maxiter=100 * matrix.shape[1])[0]
    found[found < _NEGLIGIBLE * found.max()] = 0.0
    found /= scale
    error = float(np.abs(relative @ found - 1).max())
    kept = found[3:] > 0
    return Relaxations(float(found[0]), float(found[1]), float(found[2]), found[3:][kept], rate[kept], error)
