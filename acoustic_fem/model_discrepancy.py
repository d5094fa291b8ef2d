"""What a network of lumped parts is trusted to: the part of a made sensor's responses that no parameters of it explain.

Tubes are not quite as long as they should be, cavities and membranes differ apart from each other, the room is warm,
and 3-D cells are not the lumped ones. What such effects do to a transfer function, relative to it, is smooth over
frequency and much the same at all points and microphones, so that it does not average out over frequencies as noise
does (Kennedy and O'Hagan 2001, J. R. Stat. Soc. B 63, 425). It is described as a Gaussian process over the logarithm of
frequency, a sum of one that all transfer functions share, one for each microphone, and one for each transfer function.
"""

from __future__ import annotations

import numpy as np
import scipy.linalg
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

COMMON, OF_MICROPHONE, OWN = 0.012, 0.008, 0.007
"""Root mean square, relative to the transfer function, of the three parts: measured on sensors of the virtual rig."""
TOTAL = float(np.hypot(np.hypot(COMMON, OF_MICROPHONE), OWN))
SMOOTH = 1.0
"""Of the logarithm of frequency, over which it changes."""


class Discrepancy:
    """Residuals in units of what measurement and model together are trusted to, independent of each other.

    Args:
        frequency: (n_freq,) Hz.
        about: (n_point, n_microphone, n_freq) Pa/Pa, transfer functions that the discrepancy is relative to. Not the
            measured ones in the end: what is common to all of them would then be found too small, for that lessens the
            scatter of the others (Peelle's puzzle; D'Agostini 1994, Nucl. Instrum. Methods A 346, 306).
        noise: of the same shape, standard deviation of the real part, and of the imaginary part, of the measurement.
    """

    def __init__(self, frequency: Array, about: Complex, noise: Array) -> None:
        points, microphones, _ = about.shape
        apart = np.subtract.outer(np.log(frequency), np.log(frequency)) / SMOOTH
        smooth = np.exp(-(apart**2) / 2)
        of_all, of_one = np.ones((points, points)), np.ones((microphones, microphones))
        shared = (
            COMMON**2 * np.kron(of_all, of_one)
            + OF_MICROPHONE**2 * np.kron(of_all, np.eye(microphones))
            + OWN**2 * np.eye(points * microphones)
        )
        covariance = np.kron(shared, smooth) / 2  # half of it in the real part, half in the imaginary part
        covariance[np.diag_indices_from(covariance)] += (noise / np.abs(about)).ravel() ** 2
        self._about = about
        self._root = scipy.linalg.cholesky(covariance, lower=True)

    def residuals(self, difference: Complex) -> Array:
        """(..., 2 n) independent residuals, or derivatives of them.

        Args:
            difference: (..., n_point, n_microphone, n_freq) Pa/Pa, between a sensor and what was measured, or
                derivatives of that by parameters.
        """
        relative = (difference / self._about).reshape(-1, self._about.size)
        both = np.concatenate([relative.real, relative.imag]).T
        found = scipy.linalg.solve_triangular(self._root, both, lower=True).T
        stacked = np.concatenate([found[: len(relative)], found[len(relative) :]], axis=1)
        return np.asarray(stacked.reshape(*difference.shape[:-3], -1))
