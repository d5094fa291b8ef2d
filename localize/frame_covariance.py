"""Second moments of a frame: what a touch of each point, and the noise, do to the microphones' samples.

The touch is a source with a flat spectrum from 1 to 100 Hz (and the level of the stimulus noise beyond, as far as the
library reaches), seen through the transfer functions of its point. Samples are low-passed and decimated by four
first, which changes the covariances in a known way and loses nothing of the band.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import scipy.linalg
import scipy.signal
from numpy.typing import NDArray

from localize.dataset import ArrayResponse
from localize.frames import FRAME
from localize.noise import NoiseChoice, NoiseSpectrum
from localize.stimulus import BAND, NOISE, SAMPLE_RATE

DECIMATION = 4
TAPS = 35
"""Length of the low-pass filter."""
CUTOFF = 115.0
"""Hz."""
SAMPLES = (FRAME - TAPS) // DECIMATION + 1
"""Samples of a frame and microphone after decimation."""
SOURCE_RMS = 0.25
"""Pa: the touch at power 1, typical of the multi-sine stimuli."""
INTEGRATION_STEP = 0.5
"""Hz: covariances repeat after 2 s, eight frames."""


def check_noise(choice: NoiseChoice) -> None:
    """Refuse a noise that nothing can be divided by.

    Raises:
        ValueError: neither "design" nor 1e-9 to 10 Pa.
    """
    if choice != "design" and not 1e-9 <= choice <= 10.0:
        raise ValueError(f"microphone_noise = {choice} Pa must be between 1e-9 and 10 Pa")


def low_pass() -> NDArray[np.float64]:
    """Filter and decimation of a frame, (SAMPLES, 250); its last output sees the last sample."""
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    matrix = np.zeros((SAMPLES, FRAME))
    for row in range(SAMPLES):
        end = FRAME - (SAMPLES - 1 - row) * DECIMATION
        matrix[row, end - TAPS : end] = taps
    return matrix


def noise_covariance(noise: float | NoiseSpectrum) -> NDArray[np.float64]:
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


def whitening(noise: float | NoiseSpectrum) -> NDArray[np.float64]:
    """(SAMPLES, SAMPLES): makes filtered noise white, of variance 1."""
    covariance = scipy.linalg.toeplitz(noise_covariance(noise))
    return np.asarray(np.linalg.inv(np.linalg.cholesky(covariance)))


def source_density(frequency: NDArray[np.float64]) -> NDArray[np.float64]:
    """Power density of the touch at power 1, Pa^2/Hz, at frequencies from 1 Hz."""
    return np.where(frequency <= BAND[1], SOURCE_RMS**2 / (BAND[1] - BAND[0]), NOISE**2 / (SAMPLE_RATE / 2))


def touch_covariances(
    response: ArrayResponse,
    whiten: NDArray[np.float64],
    density: Callable[[NDArray[np.float64]], NDArray[np.float64]] = source_density,
) -> NDArray[np.float64]:
    """C_i of every point at power 1, where the noise is white of variance 1.

    Args:
        response: the array.
        whiten: of :func:`whitening`.
        density: power density of the touch at frequencies in Hz, Pa^2/Hz.

    Returns:
        (n_point, n, n) float64, n = n_microphone SAMPLES, microphone by microphone.
    """
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
    frequency = np.arange(BAND[0], top + 1e-9, INTEGRATION_STEP)
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    _, gain = scipy.signal.freqz(taps, worN=frequency, fs=SAMPLE_RATE)
    amplitude = np.sqrt(density(frequency) * INTEGRATION_STEP) * np.abs(gain)
    turn = np.exp(2j * math.pi * frequency[:, None] * (np.arange(SAMPLES) * DECIMATION / SAMPLE_RATE)) @ whiten.T
    size = len(response.microphones) * SAMPLES
    covariances = np.empty((response.point_count, size, size))
    for point, of_point in enumerate(response.at(frequency)):
        # A random cosine and a random sine per frequency: C = B^T B is positive semidefinite to the last bit.
        waves = ((of_point.T * amplitude[:, None])[:, :, None] * turn[:, None, :]).reshape(len(frequency), size)
        both = np.concatenate([waves.real, waves.imag])
        covariances[point] = both.T @ both
    return covariances
