"""Deviations of a sensor from its library, as smooth functions of frequency with a joint normal distribution.

The logarithm of each transfer function deviates by a polynomial of degree 3 in the logarithm of the frequency. The
deviations of two points have something in common, because they share tubes, air and rubber, so their covariance is kept
as the coefficients of many drawn sensors. A hypothesis about the touched points takes the principal components of their
joint distribution.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

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

    def __init__(self, coefficients: Array, most: int) -> None:
        self._drawn = coefficients - coefficients.mean(0)  # (n_draw, n_point, n_microphone, 2 n_term)
        self._most = most
        self._kept = dict[tuple[int, ...], Array]()
        self.mean: ComplexArray = _joined(coefficients.mean(0))
        """Coefficients of the mean deviation of each point, (n_point, n_microphone, n_term) complex128."""

    @classmethod
    def of_tolerances(
        cls,
        library: Library,
        response: ArrayResponse,
        tolerances: Sequence[Tolerance],
        options: TwoTouchOptions,
    ) -> PathDeviations:
        """Deviations of sensors that are built with tolerances, in an air and of a rubber that nobody knows.

        Args:
            library: of a design.
            response: of that library, all of its microphones or some.
            tolerances: of manufacturing.
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
        return cls(_coefficients(np.concatenate(parts)), options.most_components)

    @classmethod
    def of_calibration(cls, response: ArrayResponse, options: TwoTouchOptions) -> PathDeviations:
        """Deviations of a sensor whose library was measured; arguments as of :meth:`of_tolerances`."""
        random = np.random.default_rng(options.seed)
        shape = options.draws, response.point_count, len(response.microphones), 2 * _TERMS
        falling = np.tile(0.5 ** np.arange(_TERMS), 2)
        return cls(options.calibrated_error * falling * random.standard_normal(shape), options.most_components)

    def of_points(self, points: NDArray[np.int64], count: int) -> ComplexArray:
        """Principal components of the joint deviations of some points, each times its standard deviation.

        Args:
            points: touched points of each hypothesis, (n_hypothesis, n_stroke) int64, from 0.
            count: number of components.

        Returns:
            Coefficients of the smooth functions, (n_hypothesis, n_component, n_stroke, n_microphone, n_term)
            complex128.
        """
        wanted = [tuple(sorted(each)) for each in points.tolist()]
        new = [each for each in dict.fromkeys(wanted) if each not in self._kept]
        if len(self._kept) + len(new) > _MOST_KEPT:
            self._kept, new = {}, list(dict.fromkeys(wanted))
        if new:
            self._kept.update(zip(new, self._components(np.array(new)), strict=True))
        order = points.argsort(1).argsort(1)
        found = np.stack([self._kept[each][:count, own] for each, own in zip(wanted, order, strict=True)])
        return _joined(found)

    def _components(self, points: NDArray[np.int64]) -> Array:
        """Components of points (n_hypothesis, n_stroke), the largest first.

        (n_hypothesis, n_component, n_stroke, n_microphone, 2 n_term) float64.
        """
        drawn = self._drawn[:, points].swapaxes(0, 1)
        flat = drawn.reshape(*drawn.shape[:2], -1)
        power, vectors = np.linalg.eigh(flat.swapaxes(1, 2) @ flat / flat.shape[1])
        components = vectors * np.sqrt(np.maximum(power, 0.0))[:, None]
        found = components.swapaxes(1, 2)[:, ::-1][:, : self._most]
        return np.ascontiguousarray(found.reshape(len(points), -1, *drawn.shape[2:]))


def smooth_functions(frequency: Array) -> Array:
    """Functions whose coefficients describe deviations, (n_freq,) Hz -> (n_term, n_freq) float64.

    They are Legendre's polynomials of the logarithm of the frequency, constant outside of the band.
    """
    middle = np.sqrt(BAND[0] * BAND[1])
    place = np.log(np.clip(frequency, *BAND) / middle) / np.log(BAND[1] / middle)
    return np.asarray(legendre.legvander(place, _TERMS - 1).T)


_BLOCK = 300
_TERMS = 4
_MOST_KEPT = 2000
"""Largest number of combinations of points whose components are kept."""


def _joined(coefficients: Array) -> ComplexArray:
    """Coefficients of levels and phases (..., 2 n_term) as complex ones, (..., n_term) complex128."""
    return np.asarray(coefficients[..., :_TERMS] + 1j * coefficients[..., _TERMS:])


def _coefficients(logarithms: ComplexArray) -> Array:
    """Coefficients of curves at the nodes, (..., n_node) complex128 -> (..., 2 n_term) float64, the levels first."""
    inverse = np.linalg.pinv(smooth_functions(_NODES))
    return np.concatenate([logarithms.real @ inverse, logarithms.imag @ inverse], axis=-1)
