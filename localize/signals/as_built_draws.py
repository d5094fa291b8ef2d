"""As-built sensors of a design, drawn as they are needed: transfer functions to train on."""

from __future__ import annotations

import functools

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from acoustic_fem import Library
from acoustic_fem.scatter.air_and_rubber import UNKNOWN_AIR_AND_RUBBER
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign
from localize.signals.array_response import ArrayResponse
from localize.signals.stimulus import SAMPLE_RATE

SOLVED_FREQUENCIES = 40
"""Number of frequencies at which drawn sensors are solved, evenly spread on a logarithmic scale."""
_BLOCK = 50


class AsBuiltDraws:
    """Transfer functions of many sensors that a design may come out as, and now and then of the design itself.

    Sizes of parts, air and the slope of the rubber are those of a sensor that nobody calibrated. The factors of
    :func:`acoustic_fem.scatter.scatter_factors` are solved at a few frequencies and interpolated in
    level and phase, so that thousands of sensors take seconds and nothing is stored.

    Args:
        library: of a design whose scatter is known.
        response: of that library.
        count: number of sensors.
        seed: any non-negative integer.
        designed_share: share of the sensors that are the design itself, 0 to 1.
    """

    def __init__(self, library: Library, response: ArrayResponse, count: int, seed: int, designed_share: float) -> None:
        self._scattered, self._medium = ScatteredDesign(library.design, UNCALIBRATED), library.medium
        self._response, self._seed = response, seed
        self.sensor_count, self.frequency = count, response.frequency
        self._is_designed = np.floor(np.arange(1, count + 1) * designed_share) > np.floor(
            np.arange(count) * designed_share
        )
        top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
        self._nodes = np.geomspace(response.frequency[0], top, SOLVED_FREQUENCIES)
        self._block = functools.lru_cache(maxsize=2)(self._logarithms)

    def sensors(self, first: int, count: int) -> NDArray[np.complex128]:
        """Transfer functions of consecutive sensors, as of
        :class:`localize.signals.array_response.TransferFunctionSource`.

        Args:
            first: number of the first sensor.
            count: sensors.

        Returns:
            (count, n_point, n_microphone, n_freq) complex128, Pa/Pa.
        """
        return np.asarray(self._response.transfer_function * self.factors(first, count, self.frequency))

    def factors(self, first: int, count: int, frequency: NDArray[np.float64]) -> NDArray[np.complex64]:
        """Transfer functions of consecutive sensors over those of the design.

        Args:
            first: number of the first sensor.
            count: sensors.
            frequency: (n,) float64, Hz; outside the library's range they are those at its ends.

        Returns:
            (count, n_point, n_microphone, n) complex64.
        """
        at = np.log(np.clip(frequency, self._nodes[0], self._nodes[-1]))
        parts = []
        for block in range(first // _BLOCK, (first + count - 1) // _BLOCK + 1):
            own = slice(max(first - block * _BLOCK, 0), min(first + count - block * _BLOCK, _BLOCK))
            parts.append(self._block(block)[own])
        logarithm = CubicSpline(np.log(self._nodes), np.concatenate(parts), axis=-1)(at)
        return np.asarray(np.exp(logarithm.astype(np.complex64)))

    def _logarithms(self, block: int) -> NDArray[np.complex128]:
        first = block * _BLOCK
        factors = scatter_factors(
            self._scattered,
            self._medium,
            self._nodes,
            _BLOCK,
            self._seed,
            first=first,
            air_and_rubber=UNKNOWN_AIR_AND_RUBBER,
        )
        logarithm = np.log(np.abs(factors)) + 1j * np.unwrap(np.angle(factors))
        logarithm[: self.sensor_count - first][self._is_designed[first : first + _BLOCK]] = 0.0
        return np.asarray(logarithm)
