"""Discrepancy of a network of lumped parts: the part of a made sensor's responses that no parameters of it explain.

Tubes are not quite as long as they should be, cavities and membranes differ apart from each other, the room is warm,
and 3-D cells are not the lumped ones. The relative effect on a transfer function is smooth over frequency
and much the same at all points and microphones, so that it does not average out over frequencies as noise
does (Kennedy and O'Hagan 2001, J. R. Stat. Soc. B 63, 425). It is described as a Gaussian process over the logarithm of
frequency, a sum of one that all transfer functions share, one for each microphone, and one for each transfer function.
"""

from __future__ import annotations

import numpy as np

from geometry.ground.typed import Array, ComplexArray

COMMON, OF_MICROPHONE, OWN = 0.012, 0.008, 0.007
"""Root mean square, relative to the transfer function, of the three parts: about those of sensors of the virtual rig,
measured in benchmarks/discrepancy.py."""
TOTAL = float(np.hypot(np.hypot(COMMON, OF_MICROPHONE), OWN))
SMOOTH = 1.0
"""Length over which it changes, in the logarithm of frequency."""
LEAST_NOISE = 1e-4
"""Relative deviation of the real part, and of the imaginary part, below which no measurement is believed."""
_NEGLIGIBLE = 1e-6  # share of the variance of a smooth process that is left out


class Discrepancy:
    """Residuals in units of what measurement and model together are trusted to, independent of each other.

    The covariance of relative residuals is one block per transfer function (noise and own part), which is factored
    alone, and a few columns that all share, which the factored residuals are corrected for.

    Args:
        frequency: (n_freq,) float64, Hz.
        about: (n_point, n_microphone, n_freq) complex128, Pa/Pa, not 0: transfer functions that the discrepancy is
            relative to. Not the measured ones in the end: what is common to all of them would then be found too small,
            for that lessens the scatter of the others (Peelle's puzzle; D'Agostini 1994, Nucl. Instrum. Methods A 346,
            306).
        noise: of the same shape, standard deviation of the real part, and of the imaginary part, of the measurement.
    """

    def __init__(self, frequency: Array, about: ComplexArray, noise: Array) -> None:
        self._about = about
        own = np.broadcast_to(OWN**2 / 2 * _covariance(frequency), (*about.shape, len(frequency))).copy()
        diagonal = np.arange(len(frequency))
        own[..., diagonal, diagonal] += (noise / np.abs(about)) ** 2 + LEAST_NOISE**2
        self._whiten = np.linalg.inv(np.linalg.cholesky(own))
        smooth = _columns(frequency)
        microphones = about.shape[1]
        shared = np.zeros((microphones, len(frequency), (1 + microphones) * smooth.shape[1]))
        for number, columns in enumerate(shared):
            parts = [COMMON * smooth, *[np.zeros_like(smooth)] * microphones]
            parts[1 + number] = OF_MICROPHONE * smooth
            columns[:] = np.concatenate(parts, axis=1) / np.sqrt(2)  # half of it in each of real and imaginary part
        self._q, self._s, _ = np.linalg.svd((self._whiten @ shared).reshape(about.size, -1), full_matrices=False)

    def residuals(self, difference: ComplexArray) -> Array:
        """Independent residuals, or derivatives of them.

        Args:
            difference: (..., n_point, n_microphone, n_freq) complex128, Pa/Pa, between a sensor and what was measured,
                or derivatives of that by parameters.

        Returns:
            (..., 2 n) float64: real and imaginary parts of all n values, in standard deviations.
        """
        own = self._own(difference)
        # (1 + V V^T)^(-1/2) with V = Q s R^T
        found = own + own @ self._q * (1 / np.sqrt(1 + self._s**2) - 1) @ self._q.T
        return np.concatenate([found.real, found.imag], axis=-1)

    def by_point(self, difference: ComplexArray) -> Array:
        """Sum of squares per residual, without what all points share: about 1 where nothing is wrong.

        Args:
            difference: (n_point, n_microphone, n_freq) complex128, Pa/Pa.

        Returns:
            (n_point,) float64.
        """
        own = self._own(difference)
        left = own - own @ self._q * (self._s**2 / (1 + self._s**2)) @ self._q.T
        return np.asarray((np.abs(left.reshape(len(difference), -1)) ** 2).mean(1) / 2)

    def _own(self, difference: ComplexArray) -> ComplexArray:
        relative = (difference / self._about)[..., None]
        return np.asarray((self._whiten @ relative)[..., 0].reshape(*difference.shape[:-3], -1))


def draw(random: np.random.Generator, frequency: Array, shape: tuple[int, int, int]) -> ComplexArray:
    """Effects in as-built sensors that the model lacks, relative to their transfer functions.

    Args:
        random: where the numbers come from.
        frequency: (n_freq,) Hz.
        shape: numbers of sensors, points and microphones.

    Returns:
        (*shape, n_freq) complex128.
    """
    columns = _columns(frequency)
    sensors, points, microphones = shape

    def process(*size: int) -> ComplexArray:
        parts = random.standard_normal((2, *size, columns.shape[1]))
        return np.asarray((parts[0] + 1j * parts[1]) / np.sqrt(2) @ columns.T)

    return (
        COMMON * process(sensors, 1, 1)
        + OF_MICROPHONE * process(sensors, 1, microphones)
        + OWN * process(sensors, points, microphones)
    )


def _covariance(frequency: Array) -> Array:
    apart = np.subtract.outer(np.log(frequency), np.log(frequency)) / SMOOTH
    return np.asarray(np.exp(-(apart**2) / 2))


def _columns(frequency: Array) -> Array:
    """(n_freq, few) whose product with their transpose is the covariance."""
    values, vectors = np.linalg.eigh(_covariance(frequency))
    kept = values > _NEGLIGIBLE * values[-1]
    return np.asarray(vectors[:, kept] * np.sqrt(values[kept]))
