"""Test of frames that hold room sound alone: the same pressure on all membranes, and no touch.

Sound moves all microphones by one function of frequency, whatever its level and spectrum: with two microphones it
fills half of the directions in which a frame can lie, with four a quarter. Energy in the other directions is noise, and
follows the chi-squared distribution if the library matches the sensor (as in :mod:`localize.decoders.judgement`). An
as-built sensor differs from its library: a fraction of the sound then appears in the other directions without being a
touch. Most of that fraction comes from the gains of the microphones, which are therefore fitted.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import scipy.special
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from geometry.ground.typed import Array
from localize.decoders.decoder_options import SoundOptions
from localize.decoders.frame_covariance import ambient_covariance, check_level, check_noise, low_pass, whitening
from localize.decoders.judgement import too_loud
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class SoundTest:
    """Test that detects sound without a touch.

    Args:
        library: library with a design, from which the response to room sound follows.
        microphone_noise: the noise there is, as of :class:`localize.BayesDecoder`.
        loudest_sound_db: level up to which sound is recognised, dB SPL, 0 to 140. The louder, the more of what lies
            below 20 Hz passes for sound: from 100 dB SPL on all of it.
        options: numbers that tune it.

    Raises:
        Refusal: an argument out of range; a library without a design; sound too far above the noise for double
            precision; or as :func:`localize.signals.array_response.response_of`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        loudest_sound_db: float = 80.0,
        options: SoundOptions = SoundOptions(),
    ) -> None:
        check_noise(microphone_noise)
        response = response_of(library)
        check_level(response, loudest_sound_db, "loudest_sound_db")
        self.microphones, self.options = response.microphones, options
        self._response, self._given = response, (microphone_noise, loudest_sound_db, options)
        noise = response.noise(microphone_noise)
        self.noise_rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        """Noise of a microphone that the test was made for, Pa rms over 0 to 500 Hz."""
        each = np.eye(len(response.microphones))
        whiten = whitening(noise)
        together = np.kron(each, whiten)
        values, vectors = np.linalg.eigh(together @ ambient_covariance(response, loudest_sound_db) @ together.T)
        if values.max() * np.finfo(np.float64).eps > options.leak:
            remedy = ("expect more noise, or quieter sound",)
            raise too_loud("loudest_sound_db", loudest_sound_db, "dB SPL", remedy)
        reduce = np.kron(each, whiten @ low_pass())
        self._all = np.asarray(reduce.T, np.float64, copy=True)
        self.directions = vectors[:, values <= options.leak]
        """Directions that sound does not reach, where the noise is white, (n_microphone SAMPLES, freedom) float64."""
        self._beside = np.asarray((self.directions.T @ reduce).T, np.float64, copy=True)
        self.freedom = self._beside.shape[1]
        """Degrees of freedom of one frame's residual."""

    def heard_by(self, microphones: tuple[str, ...]) -> SoundTest:
        """The test for some of the microphones, names of two or more."""
        return SoundTest(self._response.heard_by(microphones), *self._given)

    @one_thread()
    def p_value(self, signals: ArrayLike | Tensor) -> Array:
        """Probability that noise leaves a residual as large as the signal's beside sound.

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
        """Energy that sound does not explain, and the most that it and noise may leave, see :class:`SoundOptions`.

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
        """Energy that noise leaves beside sound at most, but in a fraction ``false_alarm`` of signals of so many
        frames; the unit is that of the noise in one direction.
        """
        return float(scipy.special.chdtri(self.freedom * frames, self.options.false_alarm))

    def is_sound(self, signals: ArrayLike | Tensor) -> NDArray[np.bool_]:
        """True if sound explains signals, on the library's sensor or on one that is made a little differently.

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
