"""The decoder that needs no training: maximum likelihood over points, from the library alone.

If point i is touched, the microphones' samples of a frame, stacked into one vector x, are a zero-mean Gaussian with
covariance g C_i + N: C_i from :mod:`localize.frame_covariance`, g the unknown power of the touch, N the covariance of
the noise. The likelihood of each point, maximised over g, ranks the points (Gaussian-process classification; Rasmussen
and Williams 2006, chapter 2, for the likelihood). In coordinates where N is the identity, the eigenvectors of C_i make
the likelihood a sum over a few dozen terms.

A touch with few spectral lines fills far fewer of those terms than a flat spectrum, so that the likelihood weighs the
noise of the empty ones too high against the shape of the signal: the decoder assumes a share of the noise that it is
told, and divides its log-likelihoods by a temperature, so that its probabilities are as sure as they are right.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import log_softmax
from torch import Tensor

from localize.dataset import ArrayResponse, response_of
from localize.frame_covariance import check_noise, low_pass, touch_covariances, whitening
from localize.frames import checked_signals, cut_frames
from localize.noise import NoiseChoice, NoiseSpectrum
from localize.threads import one_thread

if TYPE_CHECKING:
    from acoustic_fem import Library

POWERS = 10 ** (np.arange(-80.0, 40.1, 4.0) / 10)
"""Values of g that are tried; a parabola through the best one and its neighbours gives the maximum."""
WEAKEST = 1e-2
"""Eigenvectors that hold less than this share of the assumed noise at g = 1 are left out: 1e-4 names the same points,
40 dB louder ones as well."""
NOISE_SHARE = 0.25
"""Of the noise that is told, in amplitude; tried on 216 points were 1, 1/2, 0.3, 1/5 and 1/10. See docs/decoder.md."""
TEMPERATURE = NOISE_SHARE**-2
"""Counts misfits by the noise that is told again: probabilities are then calibrated, see docs/decoder.md."""
CHUNK = 64
"""Frames that are decoded at once."""


@dataclass(frozen=True, eq=False)
class DecoderTables:
    """What the likelihood of a frame is computed from."""

    reduce: NDArray[np.float64]
    """(250, SAMPLES): from the samples of a microphone to fewer ones with white noise of variance 1."""
    vectors: NDArray[np.float64]
    """(n_point, n_microphone SAMPLES, rank) eigenvectors of each C_i."""
    weight: NDArray[np.float64]
    """(n_point, rank, n_power) of the energy along each of them, per value of g."""
    log_determinant: NDArray[np.float64]
    """(n_point, n_power) of the covariance."""


class BayesDecoder:
    """Gaussian-process maximum likelihood over the points of one array.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones.
        microphone_noise: the noise floor to assume: white, Pa rms over 0 to 500 Hz, 1e-9 to 10; or "design" for
            that of the library's design, see :mod:`localize.noise`. It also stands for what the library does not
            know; a higher one is kinder to a sensor that differs from its design.

    Raises:
        ValueError: the library does not cover 1 to 100 Hz, or the noise is outside its range.
    """

    @one_thread()
    def __init__(self, library: Library | ArrayResponse, microphone_noise: NoiseChoice = 1e-3) -> None:
        check_noise(microphone_noise)
        response = response_of(library)
        self.design = response.name
        self.microphones = response.microphones
        self.line = response.line
        self.place = response.place
        self.microphone_noise = microphone_noise
        self.provenance = response.provenance
        noise = response.noise(microphone_noise)
        self.noise_rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        whiten = whitening(share_of(noise))
        variance, vectors = _eigenvectors(touch_covariances(response, whiten))
        gain = variance[:, :, None] * POWERS
        self.tables = DecoderTables(
            reduce=(whiten @ low_pass()).T.copy(),
            vectors=vectors,
            weight=-gain / (1 + gain) / TEMPERATURE,
            log_determinant=np.log1p(gain).sum(1) / TEMPERATURE,
        )

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.line)

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Where the array was touched, all points equally likely beforehand.

        A recording longer than 250 samples is cut into frames, the last one ending with it, which are taken as
        independent observations of one touch.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64: probability per point.

        Raises:
            ValueError: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, batched = checked_signals(signals, self.microphones)
        probability = np.exp(self.log_probability(batch))
        return probability if batched else probability[0]

    @one_thread()
    def log_probability(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """The logarithm of what :meth:`locate` gives, which does not end at the smallest number there is.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n, n_point) float64, nats.

        Raises:
            ValueError: as :meth:`locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        frames = cut_frames(batch)
        flat = frames.flatten(0, 1).numpy()
        score = np.concatenate([self.log_likelihood(flat[k : k + CHUNK]) for k in range(0, len(flat), CHUNK)])
        return np.asarray(log_softmax(score.reshape(*frames.shape[:2], -1).sum(1), axis=1))

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, maximised over the power of the touch and divided by the temperature.

        Args:
            frames: (n, n_microphone, 250), Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        tables = self.tables
        x = (frames @ tables.reduce).reshape(len(frames), -1)
        # (point, frame, ...): one matrix product per point.
        energy = (x @ tables.vectors) ** 2
        score = -0.5 * (energy @ tables.weight + tables.log_determinant[:, None, :])
        return vertex(score).T


def vertex(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Maximum over the last axis of samples of a smooth curve: that of the parabola around the largest one."""
    best = values.argmax(-1)
    inner = np.clip(best, 1, values.shape[-1] - 2)[..., None]
    left, middle, right = (np.take_along_axis(values, inner + k, -1)[..., 0] for k in (-1, 0, 1))
    bend = left - 2 * middle + right
    with np.errstate(divide="ignore", invalid="ignore"):
        rise = -((right - left) ** 2) / (8 * bend)
    # At an end of the range the curve may still be rising: then the sample itself is taken.
    is_top = (best == inner[..., 0]) & (bend < 0)
    return np.where(is_top, middle + np.where(is_top, rise, 0.0), values.max(-1))


def share_of(noise: float | NoiseSpectrum) -> float | NoiseSpectrum:
    """The noise that likelihoods are computed with."""
    if isinstance(noise, NoiseSpectrum):
        return NoiseSpectrum(noise.power * NOISE_SHARE**2, noise.source)
    return noise * NOISE_SHARE


def _eigenvectors(covariances: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Eigenvalues (n_point, rank) and vectors (n_point, n_microphone SAMPLES, rank) of each C_i, where N is 1."""
    values, vectors = np.linalg.eigh(covariances)
    # The largest eigenvalues come last. The same number for every point keeps the tables rectangular.
    rank = max(1, int((values > WEAKEST).sum(1).max()))
    return np.clip(values[:, -rank:], 0, None), np.ascontiguousarray(vectors[:, :, -rank:])
