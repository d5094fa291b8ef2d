"""Test of frames that hold no touch: a disturbance that the library knows, and noise, explain them.

A disturbance such as sound moves all microphones by few functions of frequency, whatever its level and spectrum. It
fills part of the directions in which a frame can lie. Energy in the other directions is noise, and follows the
chi-squared distribution if the library matches the sensor (as in :mod:`localize.decoders.judgement`). An as-built
sensor differs from its library: a fraction of the disturbance then appears in the other directions without being a
touch. Most of that fraction comes from the gains of the microphones, which are therefore fitted.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import scipy.special
from numpy.typing import ArrayLike, NDArray

from geometry.ground.typed import Array
from localize.decoders.decoder_options import SoundOptions
from localize.decoders.frame_covariance import low_pass, whitening
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class BackgroundTest:
    """Test that detects a disturbance without a touch.

    Args:
        microphones: names of the microphones.
        noise: noise of each, white, Pa rms over 0 to 500 Hz, or a spectrum.
        covariance: of the disturbance at the filtered samples of a frame, microphone by microphone, (n, n) float64,
            Pa^2, n = n_microphone SAMPLES.
        options: numbers that tune it.
    """

    def __init__(
        self, microphones: tuple[str, ...], noise: float | NoiseSpectrum, covariance: Array, options: SoundOptions
    ) -> None:
        self.microphones, self.options = microphones, options
        self.noise_rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        """Noise of a microphone that the test was made for, Pa rms over 0 to 500 Hz."""
        each = np.eye(len(microphones))
        whiten = whitening(noise)
        together = np.kron(each, whiten)
        values, vectors = np.linalg.eigh(together @ covariance @ together.T)
        self.loudest_eigenvalue = float(values.max())
        """Largest variance of the disturbance in a direction, by that of the noise."""
        reduce = np.kron(each, whiten @ low_pass())
        self._all = np.asarray(reduce.T, np.float64, copy=True)
        self.directions = vectors[:, values <= options.leak]
        """Directions that the disturbance does not reach, where the noise is white, (n_microphone SAMPLES, freedom)
        float64."""
        self._beside = np.asarray((self.directions.T @ reduce).T, np.float64, copy=True)
        self.freedom = self._beside.shape[1]
        """Degrees of freedom of one frame's residual."""

    @property
    def is_precise(self) -> bool:
        """True if the disturbance is so near the noise that double precision tells them apart."""
        return self.loudest_eigenvalue * float(np.finfo(np.float64).eps) <= self.options.leak

    @one_thread()
    def p_value(self, signals: ArrayLike | Tensor) -> Array:
        """Probability that noise leaves a residual as large as the signal's beside the disturbance.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples; cut into frames that do not
                overlap, whose residuals are added.

        Returns:
            (n,) float64.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`.
        """
        frames = self._frames(signals)
        return np.asarray(scipy.special.chdtrc(self.freedom * frames.shape[1], _energy(frames, self._beside)))

    @one_thread()
    def beside(self, signals: ArrayLike | Tensor, noise_ratio: float = 1.0) -> tuple[Array, Array]:
        """Energy that the disturbance does not explain, and the most that it and noise may leave.

        See :class:`localize.SoundOptions`.

        Args:
            signals: (n, n_microphone, n_sample), as :meth:`p_value`.
            noise_ratio: a ratio, the amplitude of the noise there is over that which the test was made for, 1 or above.

        Returns:
            Two of (n,) float64, energies; the unit is that of the noise in one direction.

        Raises:
            Refusal: as :meth:`p_value`.
        """
        frames = self._frames(signals)
        count = len(self.microphones)
        apart = frames.reshape(*frames.shape[:2], count, -1)
        # What each microphone contributes; its gain u multiplies that. Of u' G u the least with gains of mean 1 lies
        # where G u is the same for all; where they would leave their bounds, the least on the way from all equal.
        parts = np.einsum("nfms,msd->nmfd", apart, self._beside.reshape(count, -1, self.freedom)).reshape(
            len(frames), count, -1
        )
        gram = parts @ parts.swapaxes(1, 2)
        gains = np.linalg.solve(gram + np.eye(count), np.ones((len(frames), count, 1)))
        change = gains / gains.mean(1, keepdims=True) - 1
        gains = 1 + change * np.minimum(
            1.0, self.options.gain / np.maximum(np.abs(change).max(1, keepdims=True), 1e-12)
        )
        found = (gains * (gram @ gains)).sum((1, 2))
        usual = noise_ratio**2 * self.usual(frames.shape[1])
        return found, usual + self.options.mismatch**2 * _energy(frames, self._all)

    def usual(self, frames: int = 1) -> float:
        """Energy that noise leaves beside it at most, but in a fraction ``false_alarm`` of signals of so many
        frames; the unit is that of the noise in one direction.
        """
        return float(scipy.special.chdtri(self.freedom * frames, self.options.false_alarm))

    def explains(self, signals: ArrayLike | Tensor) -> NDArray[np.bool_]:
        """True if the disturbance explains signals, on the library's sensor or on one that is made a little
        differently.

        Args:
            signals: (n, n_microphone, n_sample), as :meth:`p_value`.

        Returns:
            (n,) bool; True also of noise alone.

        Raises:
            Refusal: as :meth:`p_value`.
        """
        found, most = self.beside(signals)
        return found <= most

    def _frames(self, signals: ArrayLike | Tensor) -> Array:
        batch, _ = checked_signals(signals, self.microphones)
        frames = cut_frames(batch)
        return frames.reshape(*frames.shape[:2], -1)


def _energy(frames: Array, directions: Array) -> Array:
    """(n, n_frame, n_microphone 250) along (n_microphone 250, m), summed over frames, (n,)."""
    return np.asarray(((frames @ directions) ** 2).sum((1, 2)))
