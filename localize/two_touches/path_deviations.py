"""Deviations of a sensor from its library, as smooth functions of frequency with a joint normal distribution.

The logarithm of each transfer function deviates by a polynomial of degree 3 in the logarithm of the frequency. The
deviations of two points have something in common, because they share tubes, air and rubber, so their covariance is kept
as the coefficients of many drawn sensors. A hypothesis about the touched points takes the principal components of their
joint distribution.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.polynomial import legendre

from acoustic_fem import Library
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import ScatteredDesign, Tolerance
from geometry.ground.typed import Array, ComplexArray
from localize.signals.array_response import ArrayResponse
from localize.signals.stimulus import BAND
from localize.two_touches.two_touch_options import TwoTouchOptions

_NODES = np.geomspace(*BAND, 24)


class PathDeviations:
    """Coefficients of drawn sensors; made by :meth:`of_tolerances` or :meth:`of_calibration`."""

    def __init__(self, coefficients: Array, frequency: Array) -> None:
        self._drawn = coefficients - coefficients.mean(0)  # (n_draw, n_point, n_microphone, 2 n_term)
        self._mean = coefficients.mean(0)
        self._basis = _polynomials(frequency)

    @classmethod
    def of_tolerances(
        cls,
        library: Library,
        response: ArrayResponse,
        tolerances: Sequence[Tolerance],
        frequency: Array,
        options: TwoTouchOptions,
    ) -> PathDeviations:
        """Deviations of sensors that are built with tolerances, in an air and of a rubber that nobody knows.

        Args:
            library: of a design.
            response: of that library, all of its microphones or some.
            tolerances: of manufacturing.
            frequency: (n_freq,) float64, Hz, where the deviations are wanted.
            options: of the decoder.

        Raises:
            Refusal: a design whose scatter is not known.
        """
        scattered = ScatteredDesign(library.design, tolerances)
        heard = [library.design.microphones.index(name) for name in response.microphones]
        parts = []
        for first in range(0, options.draws, _BLOCK):
            count = min(_BLOCK, options.draws - first)
            factors = scatter_factors(
                scattered, library.medium, _NODES, count, options.seed,
                first=first, air_and_rubber=options.air_and_rubber,
            )[:, :, heard]  # fmt: skip
            parts.append(np.log(np.abs(factors)) + 1j * np.unwrap(np.angle(factors)))
        return cls(_coefficients(np.concatenate(parts)), frequency)

    @classmethod
    def of_calibration(cls, response: ArrayResponse, frequency: Array, options: TwoTouchOptions) -> PathDeviations:
        """Deviations of a sensor whose library was measured; arguments as of :meth:`of_tolerances`."""
        random = np.random.default_rng(options.seed)
        shape = options.draws, response.point_count, len(response.microphones), 2 * _TERMS
        falling = np.tile(0.5 ** np.arange(_TERMS), 2)
        return cls(options.calibrated_error * falling * random.standard_normal(shape), frequency)

    def of_points(self, points: tuple[int, ...], count: int) -> ComplexArray:
        """Principal components of the joint deviations of some points, each times its standard deviation.

        Args:
            points: indices from 0.
            count: largest number of components.

        Returns:
            (n_component, n_here, n_microphone, n_freq) complex128, n_here the number of the given points.
        """
        drawn = self._drawn[:, list(points)]
        flat = drawn.reshape(len(drawn), -1)
        power, vectors = np.linalg.eigh(flat.T @ flat / len(flat))
        components = (vectors * np.sqrt(np.maximum(power, 0.0))).T[::-1][:count]
        return self._curves(components.reshape(-1, *drawn.shape[1:]))

    @cached_property
    def means(self) -> ComplexArray:
        """Mean deviation of each point, (n_point, n_microphone, n_freq) complex128."""
        return self._curves(self._mean)

    def _curves(self, coefficients: Array) -> ComplexArray:
        level, phase = coefficients[..., :_TERMS], coefficients[..., _TERMS:]
        return np.asarray((level + 1j * phase) @ self._basis)


_BLOCK = 300
_TERMS = 4


def _polynomials(frequency: Array) -> Array:
    """Legendre's polynomials of the logarithm of the frequency, (n_term, n_freq); constant outside the band."""
    middle = np.sqrt(BAND[0] * BAND[1])
    place = np.log(np.clip(frequency, *BAND) / middle) / np.log(BAND[1] / middle)
    return np.asarray(legendre.legvander(place, _TERMS - 1).T)


def _coefficients(logarithms: ComplexArray) -> Array:
    """Coefficients of curves at the nodes, (..., n_node) complex128 -> (..., 2 n_term) float64, the levels first."""
    inverse = np.linalg.pinv(_polynomials(_NODES))
    return np.concatenate([logarithms.real @ inverse, logarithms.imag @ inverse], axis=-1)
