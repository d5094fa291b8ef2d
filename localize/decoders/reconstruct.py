"""The waveform of a touch from the microphones: the posterior mean of the pressure in the touched cavity.

The source is a zero-mean Gaussian process with the spectrum of
:func:`localize.decoders.frame_covariance.source_density`; the microphones hold it through the transfer functions of its
point, plus noise. Given the samples of a window of T at every microphone, y, the pressure s some samples before the
window's end is normal with

    mean = c^T R^-1 y,    variance = E[s^2] - c^T R^-1 c,    R = E[y y^T],  c = E[y s]

(Wiener 1949; Rasmussen and Williams 2006, equations 2.23 and 2.24). R^-1 c is one FIR filter per microphone. The number
of samples by which s lies before the end is the latency: what the array does to a wave takes time, and a filter that
may wait for it sees more. The mean needs no knowledge of the waveform; the variance is that of a touch as loud as
assumed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy.linalg
import scipy.signal
from numpy.typing import ArrayLike

from acoustic_fem import Library
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import SOURCE_RMS, check_noise, noise_covariance, source_density
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals
from localize.signals.noise_model import NoiseChoice
from localize.signals.stimulus import BAND, SAMPLE_RATE
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor

PAPER_WINDOW, PAPER_HOP = 32, 16
"""Window and hop of the paper's short-window transform for reconstruction, samples."""
_STEP = 0.25
"""Hz: covariances repeat after 4 s."""
LONGEST = 1000
"""Length of the longest window, samples; its lags stay below half of the period of 4 s."""


@dataclass(frozen=True, eq=False)
class Waveform:
    """Pressure in the touched cavity, Pa at 1 kHz."""

    pressure: Array
    """Posterior mean of the pressure; (n, n_sample) float64, Pa. Its first ``window - latency - 1`` and last
    ``latency`` samples have no whole window and are NaN."""
    deviation: float
    """Posterior standard deviation of the pressure, Pa: the same for all samples."""


class Reconstructor:
    """Wiener filters of every point, made when they are first asked for.

    Args:
        library: transfer functions that cover 1 to 100 Hz.
        microphone_noise: the noise there is: white, Pa rms over 0 to 500 Hz, 1e-9 to 10, or "design".
        window: samples that each estimate is made from, 2 to 1000.
        latency: samples by which an estimate lags behind the newest sample, 0 to ``window - 1``.
        source_rms: how loud a touch to assume, Pa rms, 1e-6 to 1e3.

    Raises:
        Refusal: an argument outside its range; the library does not cover 1 to 100 Hz.
    """

    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        window: int = 250,
        latency: int = 16,
        source_rms: float = SOURCE_RMS,
    ) -> None:
        check_noise(microphone_noise)
        check_range("window", window, 2, LONGEST, "samples", whole=True)
        check_range("latency", latency, 0, window - 1, "samples", whole=True, why="a window less one")
        check_range("source_rms", source_rms, 1e-6, 1e3, "Pa")
        response = response_of(library)
        self.microphones = response.microphones
        self.window = window
        self.latency = latency
        self._noise = response.noise(microphone_noise)
        top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
        self._frequency = np.arange(BAND[0], top + 1e-9, _STEP)
        self._response = response.at(self._frequency)
        self._power = source_density(self._frequency) * (source_rms / SOURCE_RMS) ** 2 * _STEP
        self._made: dict[int, tuple[Array, float]] = {}

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self._response)

    def filters(self, point: int) -> Array:
        """FIR filter of each microphone for a point, from 1; tap k takes the sample k before the newest; (n_microphone,
        window) float64.
        """
        return self._filter(point)[0].copy()

    def deviation(self, point: int) -> float:
        """Posterior standard deviation at a point, from 1, Pa, for a touch as loud as assumed."""
        return self._filter(point)[1]

    @one_thread()
    def waveform(self, signals: ArrayLike | Tensor, point: int) -> Waveform:
        """Pressure in the cavity of a touched point.

        Args:
            signals: (n, n_microphone, n_sample) or (n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples and a
                window.
            point: from 1.

        Raises:
            Refusal: no such point, signals shorter than the window, or as :meth:`localize.BayesDecoder.locate`.
        """
        taps, deviation = self._filter(point)
        batch, _ = checked_signals(signals, self.microphones)
        count = batch.shape[-1]
        if count < self.window:
            problem = f"have {counted(count, 'sample')}, must have at least a window of {self.window}"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="signals")
        whole = scipy.signal.fftconvolve(batch, taps[None], mode="valid", axes=2).sum(1)
        pressure = np.full((len(batch), count), np.nan)
        pressure[:, self.window - 1 - self.latency : count - self.latency] = whole
        return Waveform(pressure=pressure, deviation=deviation)

    @one_thread()
    def _filter(self, point: int) -> tuple[Array, float]:
        _check_point(point, self.point_count)
        if point not in self._made:
            h, taps = self._response[point - 1], self.window
            lag = np.arange(-(taps - 1), taps) / SAMPLE_RATE
            turn = np.exp(2j * math.pi * self._frequency[:, None] * lag)
            # E[y_a(t + lag) y_b(t)]; tap k is the sample at -k, so rows and columns run backwards in time.
            cross = ((h[:, None, :] * h[None, :, :].conj() * self._power) @ turn).real
            cross[np.arange(len(h)), np.arange(len(h))] += noise_covariance(self._noise, lag)
            index = np.arange(taps)[None, :] - np.arange(taps)[:, None] + taps - 1
            covariance = cross[:, :, index].transpose(0, 2, 1, 3).reshape(len(h) * taps, -1)
            ahead = (self.latency - np.arange(taps)) / SAMPLE_RATE
            with_source = ((h * self._power) @ np.exp(2j * math.pi * self._frequency[:, None] * ahead)).real.reshape(-1)
            solved = scipy.linalg.solve(covariance, with_source, assume_a="pos")
            variance = max(float(self._power.sum() - with_source @ solved), 0.0)
            self._made[point] = solved.reshape(len(h), taps), math.sqrt(variance)
        return self._made[point]


def short_window_waveform(
    library: Library | ArrayResponse,
    signals: ArrayLike | Tensor,
    point: int,
    window: int = PAPER_WINDOW,
    hop: int = PAPER_HOP,
) -> Array:
    """Waveform by the paper's method: short-window transform, then least squares over the microphones (our addition) in
    each bin, then the inverse transform.

    The product with a transfer function is exact only for windows much longer than the impulse response. At the
    paper's 32 samples, 31 Hz between bins, the error is that of the window, whatever the noise.

    Args:
        library: transfer functions that cover 1 to 100 Hz; there the waveform ends, because beyond them the array
            transmits only noise.
        signals: (n, n_microphone, n_sample) or (n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.
        point: from 1.
        window: samples, Hann window, 4 to 1000.
        hop: samples, 1 to half the window.

    Returns:
        (n, n_sample) float64, Pa.

    Raises:
        Refusal: an argument outside its range, or as :meth:`localize.BayesDecoder.locate`.
    """
    response = response_of(library)
    _check_point(point, response.point_count)
    check_range("window", window, 4, LONGEST, "samples", whole=True)
    check_range("hop", hop, 1, window // 2, "samples", whole=True, why="half the window")
    batch, _ = checked_signals(signals, response.microphones)
    transform = scipy.signal.ShortTimeFFT(np.hanning(window + 1)[:window], hop, SAMPLE_RATE)
    spectrum = transform.stft(batch)
    known = transform.f <= BAND[1]
    # Below the lowest frequency of the library its value there stands for the static one.
    h = response.at(np.maximum(transform.f[known], response.frequency[0]))[point - 1]
    source = np.zeros((len(batch), *spectrum.shape[2:]), complex)
    source[:, known] = np.einsum("mf,nmft->nft", h.conj(), spectrum[:, :, known]) / (np.abs(h) ** 2).sum(0)[:, None]
    return np.asarray(transform.istft(source, k1=batch.shape[-1]))


def _check_point(point: int, count: int) -> None:
    check_range("point", point, 1, count, whole=True, why="the points of the array")
