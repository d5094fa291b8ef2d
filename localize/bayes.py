"""The decoder that needs no training: maximum likelihood over points, from the library alone.

If point i is touched, the microphones' samples of a frame, stacked into one vector x, are a zero-mean Gaussian with
covariance g C_i + N: C_i is that of a source with a flat spectrum from 1 to 100 Hz (and the level of the stimulus
noise beyond, as far as the library reaches) seen through the transfer functions of point i, g the unknown power of
the touch, N the covariance of the microphones' noise. The likelihood of each point, maximised over g, ranks the
points (Gaussian-process classification; Rasmussen and Williams 2006, chapter 2, for the likelihood).

Samples are low-passed and decimated by four first, which changes C_i and N in a known way and loses nothing of the
band. In coordinates where N is the identity, the eigenvectors of C_i make the likelihood a sum over a few dozen terms.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import scipy.linalg
import scipy.signal
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from localize.dataset import ArrayResponse, response_of
from localize.frames import FRAME, checked_signals, combined_probability, cut_frames
from localize.noise import NoiseChoice, NoiseSpectrum
from localize.stimulus import BAND, NOISE, SAMPLE_RATE
from localize.threads import one_thread

if TYPE_CHECKING:
    from acoustic_fem import Library

DECIMATION = 4
TAPS = 35
"""Length of the low-pass filter."""
CUTOFF = 115.0
"""Hz."""
SAMPLES = (FRAME - TAPS) // DECIMATION + 1
"""Samples of a frame and microphone after decimation."""
SOURCE_RMS = 0.25
"""Pa: the touch at g = 1, typical of the multi-sine stimuli."""
POWERS = 10 ** (np.arange(-80.0, 40.1, 4.0) / 10)
"""Values of g that are tried; a parabola through the best one and its neighbours gives the maximum."""
INTEGRATION_STEP = 0.5
"""Hz: covariances repeat after 2 s, eight frames."""
WEAKEST = 1e-4
"""Eigenvectors that hold less than this share of the noise at g = 1 are left out."""
CHUNK = 64
"""Frames that are decoded at once."""


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
        if microphone_noise != "design" and not 1e-9 <= microphone_noise <= 10.0:
            raise ValueError(f"microphone_noise = {microphone_noise} Pa must be between 1e-9 and 10 Pa")
        response = response_of(library)
        self.design = response.name
        self.microphones = response.microphones
        self.line = response.line
        self.place = response.place
        self.microphone_noise = microphone_noise
        self.provenance = response.provenance
        assumed = response.noise(microphone_noise)
        self.noise_rms = assumed.rms if isinstance(assumed, NoiseSpectrum) else assumed
        noise = scipy.linalg.toeplitz(_noise_covariance(assumed))
        whiten = np.linalg.inv(np.linalg.cholesky(noise))
        # From the 250 samples of a microphone to SAMPLES ones with white noise of variance 1.
        self._reduce = (whiten @ _low_pass()).T.copy()
        variance, vectors = _eigenvectors(response, whiten)
        self._vectors = vectors
        gain = variance[:, :, None] * POWERS
        self._weight = -gain / (1 + gain)
        self._log_determinant = np.log1p(gain).sum(1)

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
        import torch

        batch, batched = checked_signals(signals, self.microphones)
        frames = cut_frames(batch)
        flat = frames.flatten(0, 1).numpy()
        score = np.concatenate([self.log_likelihood(flat[k : k + CHUNK]) for k in range(0, len(flat), CHUNK)])
        per_frame = torch.from_numpy(score).unflatten(0, frames.shape[:2])
        probability = combined_probability(per_frame).numpy()
        return probability if batched else probability[0]

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, maximised over the power of the touch.

        Args:
            frames: (n, n_microphone, 250), Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        x = (frames @ self._reduce).reshape(len(frames), -1)
        # (point, frame, ...): one matrix product per point.
        energy = (x @ self._vectors) ** 2
        score = -0.5 * (energy @ self._weight + self._log_determinant[:, None, :])
        return _vertex(score).T


def _vertex(values: NDArray[np.float64]) -> NDArray[np.float64]:
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


def _low_pass() -> NDArray[np.float64]:
    """Filter and decimation of a frame, (SAMPLES, 250); its last output sees the last sample."""
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    matrix = np.zeros((SAMPLES, FRAME))
    for row in range(SAMPLES):
        end = FRAME - (SAMPLES - 1 - row) * DECIMATION
        matrix[row, end - TAPS : end] = taps
    return matrix


def _noise_covariance(noise: float | NoiseSpectrum) -> NDArray[np.float64]:
    """Covariance of filtered noise, white ones in Pa rms, at the lags of the decimated samples, (SAMPLES,), Pa^2."""
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    if isinstance(noise, NoiseSpectrum):
        frequency = np.arange(len(noise.power), dtype=np.float64)
        _, gain = scipy.signal.freqz(taps, worN=frequency, fs=SAMPLE_RATE)
        lag = np.arange(SAMPLES) * DECIMATION / SAMPLE_RATE
        return np.asarray(np.cos(2 * math.pi * lag[:, None] * frequency) @ (noise.power * np.abs(gain) ** 2))
    correlation = np.zeros(max(SAMPLES * DECIMATION, TAPS))
    correlation[:TAPS] = np.correlate(taps, taps, "full")[TAPS - 1 :]
    return noise**2 * correlation[: SAMPLES * DECIMATION : DECIMATION]


def _eigenvectors(
    response: ArrayResponse, whiten: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Eigenvalues (n_point, rank) and vectors (n_point, n_microphone SAMPLES, rank) of each C_i, where N is 1."""
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
    frequency = np.arange(BAND[0], top + 1e-9, INTEGRATION_STEP)
    density = np.where(frequency <= BAND[1], SOURCE_RMS**2 / (BAND[1] - BAND[0]), NOISE**2 / (SAMPLE_RATE / 2))
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    _, gain = scipy.signal.freqz(taps, worN=frequency, fs=SAMPLE_RATE)
    power = density * np.abs(gain) ** 2 * INTEGRATION_STEP
    lag = np.arange(-(SAMPLES - 1), SAMPLES) * DECIMATION / SAMPLE_RATE
    turn = np.exp(2j * math.pi * frequency[:, None] * lag)
    rows = np.arange(SAMPLES)
    toeplitz = rows[:, None] - rows[None, :] + SAMPLES - 1
    h = response.at(frequency)
    microphones = len(response.microphones)
    size = microphones * SAMPLES

    values = np.empty((response.point_count, size))
    vectors = np.empty((response.point_count, size, size))
    for point, of_point in enumerate(h):
        cross = of_point[:, None, :] * of_point[None, :, :].conj() * power
        blocks = (cross @ turn).real[..., toeplitz]
        white = whiten @ blocks @ whiten.T
        covariance = white.transpose(0, 2, 1, 3).reshape(size, size)
        values[point], vectors[point] = np.linalg.eigh((covariance + covariance.T) / 2)
    # The largest eigenvalues come last. The same number for every point keeps the tables rectangular.
    rank = max(1, int((values > WEAKEST).sum(1).max()))
    return np.clip(values[:, -rank:], 0, None), np.ascontiguousarray(vectors[:, :, -rank:])
