"""Second moments of a frame: what a touch of each point, and the noise, do to the microphones' samples.

The touch is a source with a flat spectrum from 1 to 100 Hz (and the level of the stimulus noise beyond, as far as the
library reaches), seen through the transfer functions of its point. Samples are low-passed and decimated by four
first, which changes the covariances in a known way and loses nothing of the band.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np
import scipy.linalg
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem.numerics.frequency_splines import interpolation
from geometry.ground.refusal import Kind, Refusal
from localize.signals.array_response import ArrayResponse
from localize.signals.disturbances import LOWEST_SOUND, MAINS, REFERENCE, check_sound_level
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum, check_noise_choice
from localize.signals.stimulus import BAND, NOISE, SAMPLE_RATE

DECIMATION = 4
TAPS = 35
"""Length of the low-pass filter, samples."""
CUTOFF = 115.0
"""Corner of the low-pass filter, Hz."""
SAMPLES = (FRAME - TAPS) // DECIMATION + 1
"""Number of samples of a frame and microphone after decimation."""
SOURCE_RMS = 0.25
"""Level of the touch at power 1, Pa rms, typical of the multi-sine stimuli."""
INTEGRATION_STEP = 0.5
"""Step of the integrals over frequency, Hz: covariances repeat after 2 s, eight frames. For the deviations of as-built
sensors a step of 1 Hz named 3 to 4 % fewer touches on 36 points in line, one of 0.25 Hz no more."""

LEAST_NOISE = 1e-4
"""Noise that every microphone has beside its own where sound is taken out of whole frames, Pa rms."""
HUM = 3e-3
"""Level of each line of mains that is expected in every microphone, Pa rms; 1 mPa did as well with hum of 10 mPa."""
HUM_LINES = 2
"""Multiples of each frequency of mains that the filter lets pass."""

PASSED = 200.0
"""Frequency beyond which the low-pass leaves 2e-11 of a touch, Hz: integrals end there."""
DEVIATING = np.arange(BAND[0], BAND[1] + 1e-9, INTEGRATION_STEP)
"""Frequencies at which transfer functions may deviate, Hz: above the band touches are all but silent."""


SourceDensity = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""Power density of a touch, Pa^2/Hz, from frequencies in Hz, both of shape (n_freq,)."""


def check_noise(choice: NoiseChoice, field: str = "microphone_noise") -> None:
    """Refuse a noise that nothing can be divided by.

    Args:
        choice: white, Pa rms over 0 to 500 Hz, or "design".
        field: name of the argument.

    Raises:
        Refusal: neither "design" nor 1e-9 to 10 Pa.
    """
    check_noise_choice(choice, field, 1e-9, 10.0, "between 1e-9 and 10 Pa, or 'design'")


def low_pass() -> NDArray[np.float64]:
    """Matrix that filters and decimates a frame, whose last output sees the last sample; (SAMPLES, 250) float64."""
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    matrix = np.zeros((SAMPLES, FRAME))
    for row in range(SAMPLES):
        end = FRAME - (SAMPLES - 1 - row) * DECIMATION
        matrix[row, end - TAPS : end] = taps
    return matrix


def frame_noise_covariance(noise: float | NoiseSpectrum) -> NDArray[np.float64]:
    """Covariance of filtered noise at the lags of the decimated samples.

    Args:
        noise: white, Pa rms over 0 to 500 Hz, or a spectrum.

    Returns:
        (SAMPLES,) float64, Pa^2.
    """
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    if isinstance(noise, NoiseSpectrum):
        frequency = np.arange(len(noise.power), dtype=np.float64)
        _, gain = scipy.signal.freqz(taps, worN=frequency, fs=SAMPLE_RATE)
        lag = np.arange(SAMPLES) * DECIMATION / SAMPLE_RATE
        return np.asarray(np.cos(2 * math.pi * lag[:, None] * frequency) @ (noise.power * np.abs(gain) ** 2))
    correlation = np.zeros(max(SAMPLES * DECIMATION, TAPS))
    correlation[:TAPS] = np.correlate(taps, taps, "full")[TAPS - 1 :]
    return noise**2 * correlation[: SAMPLES * DECIMATION : DECIMATION]


def floor_covariance(noise: float | NoiseSpectrum) -> NDArray[np.float64]:
    """Covariance of a microphone's noise and of mains hum, whose amplitude and phase nobody knows.

    If a decoder does not expect hum, hum makes it choose wrong points with certainty: 2 mPa of hum cost two touches of
    ten. Hum that is expected but absent had no measurable cost, because a touch fills the whole band.

    Args:
        noise: white, Pa rms over 0 to 500 Hz, or a spectrum.

    Returns:
        (SAMPLES, SAMPLES) float64, Pa^2.
    """
    lines = np.outer(np.arange(1, HUM_LINES + 1), MAINS).ravel()
    _, gain = sampled_waves(lines)
    lag = np.arange(SAMPLES) * DECIMATION / SAMPLE_RATE
    hum = np.cos(2 * math.pi * lag[:, None] * lines) @ (HUM * gain) ** 2
    return np.asarray(scipy.linalg.toeplitz(frame_noise_covariance(noise) + hum))


def whitening(microphone_noise: float | NoiseSpectrum) -> NDArray[np.float64]:
    """Matrix that makes the filtered noise of one microphone white, of variance 1; (SAMPLES, SAMPLES) float64, 1/Pa."""
    covariance = scipy.linalg.toeplitz(frame_noise_covariance(microphone_noise))
    return np.asarray(np.linalg.inv(np.linalg.cholesky(covariance)))


def joint_whitening(
    response: ArrayResponse, noise: float | NoiseSpectrum, ambient: float | None
) -> NDArray[np.float64]:
    """Matrix that makes noise, hum and sound at all microphones together white, of variance 1.

    Args:
        response: the array, with its ``ambient_response`` where there is sound.
        noise: white, Pa rms over 0 to 500 Hz, or a spectrum.
        ambient: level of the sound outside, dB SPL; None for quiet.

    Returns:
        (n, n) float64, n = n_microphone SAMPLES, microphone by microphone, 1/Pa.
    """
    whole = joint_covariance(response, noise, ambient)
    return np.asarray(scipy.linalg.solve_triangular(np.linalg.cholesky(whole), np.eye(len(whole)), lower=True))


def joint_covariance(
    response: ArrayResponse, noise: float | NoiseSpectrum, ambient: float | None
) -> NDArray[np.float64]:
    """Covariance of noise, hum and sound at all microphones together; arguments as of :func:`joint_whitening`.

    Returns:
        (n, n) float64, n = n_microphone SAMPLES, microphone by microphone, Pa^2.
    """
    alone = np.kron(np.eye(len(response.microphones)), floor_covariance(noise))
    return np.asarray(alone if ambient is None else alone + ambient_covariance(response, ambient))


def whole_frame_covariance(
    response: ArrayResponse, noise: float | NoiseSpectrum, ambient: float
) -> NDArray[np.float64]:
    """Covariance of noise and sound in all samples of a frame, neither filtered nor decimated, without hum.

    Args:
        response: the array, with its ``ambient_response``.
        noise: white, Pa rms over 0 to 500 Hz, or a spectrum; :data:`LEAST_NOISE` at least.
        ambient: level of the sound outside, dB SPL.

    Returns:
        (n, n) float64, n = n_microphone 250, microphone by microphone, Pa^2.
    """
    time = np.arange(FRAME) / SAMPLE_RATE
    alone = noise_covariance(noise, time)
    alone[0] += LEAST_NOISE**2
    h, amplitude, frequency = ambient_waves(response, ambient)
    sound = _second_moment(h, amplitude, np.exp(2j * math.pi * frequency[:, None] * time))
    return np.asarray(np.kron(np.eye(len(response.microphones)), scipy.linalg.toeplitz(alone)) + sound)


def noise_covariance(noise: float | NoiseSpectrum, lag: NDArray[np.float64]) -> NDArray[np.float64]:
    """Covariance of a microphone's noise.

    Args:
        noise: white, Pa rms over 0 to 500 Hz, or a spectrum.
        lag: of any shape, float64, s.

    Returns:
        Same shape as the lags, float64, Pa^2.
    """
    if isinstance(noise, NoiseSpectrum):
        frequency = np.arange(len(noise.power), dtype=np.float64)
        return np.asarray(np.cos(2 * math.pi * lag[:, None] * frequency) @ noise.power)
    return np.where(lag == 0, noise**2, 0.0)


def check_level(response: ArrayResponse, level: float | None, field: str = "ambient") -> None:
    """Refuse sound that is out of range, or whose path to the microphones is not known.

    Args:
        response: the array.
        level: dB SPL; None for quiet.
        field: name of the argument.

    Raises:
        Refusal: a level outside 0 to 140 dB SPL, or an array without a design.
    """
    check_sound_level(level, field)
    if level is not None and response.ambient_response is None:
        problem = "needs a library with a design, from which the response to sound follows"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field=field, value=level, unit="dB SPL")


def ambient_covariance(response: ArrayResponse, level: float) -> NDArray[np.float64]:
    """Covariance of filtered sound from outside, the same pressure on all membranes, pink from 20 Hz.

    Args:
        response: the array, with its ``ambient_response``.
        level: dB re 20 uPa, of the sound as :func:`localize.signals.disturbances.ambient_sound` makes it.

    Returns:
        (n, n) float64, n = n_microphone SAMPLES, microphone by microphone, Pa^2: of rank one at each frequency.
    """
    h, amplitude, frequency = ambient_waves(response, level)
    turn, gain = sampled_waves(frequency)
    return _second_moment(h, amplitude * gain, turn)


def ambient_waves(
    response: ArrayResponse, level: float
) -> tuple[NDArray[np.complex128], NDArray[np.float64], NDArray[np.float64]]:
    """Sound from outside as waves at the microphones; arguments as of :func:`ambient_covariance`.

    Returns:
        Pressures of each over that outside, (n_microphone, n_freq) complex128, Pa/Pa; amplitudes, Pa, and frequencies,
        Hz, (n_freq,) float64.
    """
    if response.ambient_response is None:
        raise Refusal("sound needs a library with a design", kind=Kind.UNSUITABLE)
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
    frequency = np.arange(LOWEST_SOUND, top + 1e-9, INTEGRATION_STEP)
    power = (REFERENCE * 10 ** (level / 20)) ** 2 / frequency / (1 / frequency).sum()
    even, odd = interpolation(response.frequency, frequency)
    h = response.ambient_response.real @ even.T + 1j * (response.ambient_response.imag @ odd.T)
    return h, np.sqrt(power), frequency


def source_density(frequency: NDArray[np.float64]) -> NDArray[np.float64]:
    """Power density of the touch at power 1.

    Args:
        frequency: (n,) float64, Hz, from 1 Hz on.

    Returns:
        (n,) float64, Pa^2/Hz.
    """
    return np.where(frequency <= BAND[1], SOURCE_RMS**2 / (BAND[1] - BAND[0]), NOISE**2 / (SAMPLE_RATE / 2))


def touch_covariances(
    response: ArrayResponse,
    whiten: NDArray[np.float64],
    density: SourceDensity = source_density,
    lowest: float = BAND[0],
) -> NDArray[np.float64]:
    """Covariances C_i of every point at power 1, where the noise is white of variance 1.

    Args:
        response: the array.
        whiten: (SAMPLES, SAMPLES) float64, 1/Pa, of :func:`whitening`, or (n, n) of :func:`joint_whitening`.
        density: power density of the touch, Pa^2/Hz, from frequencies in Hz, both of shape (n_freq,).
        lowest: frequency of the touch, Hz.

    Returns:
        (n_point, n, n) float64, n = n_microphone SAMPLES, microphone by microphone.
    """
    top = min(float(response.frequency[-1]), PASSED)
    frequency = np.arange(lowest, top + 1e-9, INTEGRATION_STEP)
    turn, gain = sampled_waves(frequency)
    turn = turn @ whiten.T
    amplitude = np.sqrt(density(frequency) * INTEGRATION_STEP) * gain
    size = len(response.microphones) * SAMPLES
    covariances = np.empty((response.point_count, size, size))
    for point, of_point in enumerate(response.at(frequency)):
        covariances[point] = _second_moment(of_point, amplitude, turn)
    return covariances


def deviation_moments(
    touched: NDArray[np.complex128], shapes: NDArray[np.complex64], seen: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Covariance between a touch whose transfer functions deviate by each shape and the nominal touch.

    Args:
        touched: transfer functions of the point, (n_microphone, n_freq) at :data:`DEVIATING`, Pa/Pa.
        shapes: how their logarithms deviate, (n_shape, n_microphone, n_freq).
        seen: directions onto which the touch is projected, (n, m) float64, n = n_microphone SAMPLES.

    Returns:
        B_k^T B of each shape, times the directions, (n_shape, n, m) float64, Pa^2: rows are the samples that deviate.
    """
    amplitude, turn = _deviating_waves()
    touch = random_waves(touched, amplitude, turn) @ seen
    deviating = random_waves((touched * shapes).reshape(-1, len(amplitude)), amplitude, turn)
    return np.asarray((deviating.T @ touch).reshape(len(shapes), -1, touch.shape[1]))


@functools.cache
def _deviating_waves() -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """Amplitudes of a touch at :data:`DEVIATING`, and its waves as the decimated samples see them."""
    turn, gain = sampled_waves(DEVIATING)
    return np.sqrt(source_density(DEVIATING) * INTEGRATION_STEP) * gain, turn


def sampled_waves(frequency: NDArray[np.float64]) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """Waves as the decimated samples see them, and the gain of the filter.

    Args:
        frequency: (n,) float64, Hz.

    Returns:
        (n, SAMPLES) complex128, and (n,) float64.
    """
    taps = scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE)
    _, gain = scipy.signal.freqz(taps, worN=frequency, fs=SAMPLE_RATE)
    time = np.arange(SAMPLES) * DECIMATION / SAMPLE_RATE
    return np.exp(2j * math.pi * frequency[:, None] * time), np.abs(gain)


def _second_moment(
    h: NDArray[np.complex128], amplitude: NDArray[np.float64], turn: NDArray[np.complex128]
) -> NDArray[np.float64]:
    """Second moment of a random cosine and sine at each frequency: B^T B is positive semidefinite to the last bit."""
    both = random_waves(h, amplitude, turn)
    return np.asarray(both.T @ both)


def random_waves(
    h: NDArray[np.complex128], amplitude: NDArray[np.float64], turn: NDArray[np.complex128]
) -> NDArray[np.float64]:
    """Samples at the microphones of a random cosine and a random sine per frequency, (2 n_freq, n)."""
    waves = ((h.T * amplitude[:, None])[:, :, None] * turn[:, None, :]).reshape(len(amplitude), -1)
    return np.concatenate([waves.real, waves.imag])
