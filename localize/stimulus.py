"""Multi-sine stimuli: what a touch does to the pressure in a cavity, one random stream per sample.

A stimulus is the sum of N sinusoids between 1 and 100 Hz with amplitudes U[0.02, 0.1] Pa and random phases,
divided by its peak where that exceeds 1 Pa, plus white noise of 0.005 Pa rms (Scalable Dynamic Tactile Sensing
Enabled by Passive and Flexible Acoustic Waveguides, section on simulated data). N is drawn from one of seven
intervals, all equally likely. Two choices are ours: frequencies lie on the lines of a periodic grid, a quarter of
a hertz apart, so that the response of a linear array is exact; and the sample is the first second of that period.

Random numbers: sample ``i`` of a stream owns a fixed block of one counter-based Philox sequence, whose key is a
``numpy.random.SeedSequence`` child of (seed, purpose). Samples are therefore independent, a block of consecutive
ones is drawn in one call, and any sample can be made again alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

SAMPLE_RATE = 1000.0
"""Hz."""
BAND = (1.0, 100.0)
"""Hz, the band of the stimuli and of the features."""
PERIOD = 4000
"""Samples of the periodic grid: spectral lines are 0.25 Hz apart."""
LINE_SPACING = SAMPLE_RATE / PERIOD
LINE_COUNT = PERIOD // 2
"""Lines below half the sample rate; line k lies at k LINE_SPACING, line 0 stays empty."""
SAMPLE_LENGTH = 1000
"""Samples of one stimulus: one second."""
COMPONENT_INTERVALS = ((1, 4), (4, 20), (20, 40), (40, 60), (60, 80), (80, 100), (1, 101))
"""Half-open intervals of the number of sinusoids."""
AMPLITUDE = (0.02, 0.1)
"""Pa."""
PEAK = 1.0
"""Pa: stronger sums are scaled down to it."""
NOISE = 0.005
"""Pa rms over 0 to 500 Hz."""

Purpose = Literal["training", "held-out", "evaluation"]
_PURPOSES: tuple[Purpose, ...] = ("training", "held-out", "evaluation")
_KINDS = ("stimulus", "microphone")
_MOST_COMPONENTS = max(high for _, high in COMPONENT_INTERVALS) - 1
_COMPONENT_WORDS = 2 + 2 * _MOST_COMPONENTS
_STIMULUS_WORDS = _COMPONENT_WORDS + LINE_COUNT


@dataclass(frozen=True)
class Stimuli:
    """Spectra of consecutive samples, in Pa: x(t) = 2 Re sum_k spectrum_k exp(2 pi j f_k t)."""

    spectrum: Tensor
    """(n, LINE_COUNT) complex64."""
    interval: Tensor
    """(n,) int64: index into ``COMPONENT_INTERVALS``."""
    components: Tensor
    """(n,) int64: number of sinusoids."""


def line_frequencies() -> NDArray[np.float64]:
    """Frequencies of the spectral lines, (LINE_COUNT,) float64, Hz."""
    return np.arange(LINE_COUNT, dtype=np.float64) * LINE_SPACING


def lines_within(band: tuple[float, float]) -> slice:
    """The lines from ``band[0]`` to ``band[1]`` Hz, both included."""
    tolerance = 1e-6
    first = math.ceil(band[0] / LINE_SPACING - tolerance)
    last = math.floor(band[1] / LINE_SPACING + tolerance)
    return slice(max(first, 1), min(last, LINE_COUNT - 1) + 1)


def multi_sines(seed: int, purpose: Purpose, start: int, count: int, noise_band: tuple[float, float]) -> Stimuli:
    """Samples ``start`` to ``start + count - 1`` of a stream of stimuli.

    Args:
        seed: any non-negative integer.
        purpose: streams of different purposes never share a stimulus, whatever the seed.
        start: index of the first sample.
        count: how many.
        noise_band: Hz; the white noise is limited to these frequencies (those the transfer functions cover).
            The sinusoids of a sample do not depend on it.
    """
    words = random_words(seed, purpose, "stimulus", start, count, _STIMULUS_WORDS)
    uniform = _uniform(words[:, :_COMPONENT_WORDS])
    bounds = torch.tensor(COMPONENT_INTERVALS)
    interval = _choice(uniform[:, 0, 0], len(COMPONENT_INTERVALS))
    low, high = bounds[interval, 0], bounds[interval, 1]
    components = low + _choice(uniform[:, 0, 1], high - low)

    sines = lines_within(BAND)
    line = sines.start + _choice(uniform[:, 2 : 2 + _MOST_COMPONENTS, 0], sines.stop - sines.start)
    rest = uniform[:, 2 + _MOST_COMPONENTS :]
    amplitude = AMPLITUDE[0] + (AMPLITUDE[1] - AMPLITUDE[0]) * rest[..., 0]
    amplitude = amplitude * (torch.arange(_MOST_COMPONENTS) < components[:, None])
    sine = torch.polar(amplitude / 2, (2 * math.pi) * rest[..., 1])
    spectrum = torch.zeros(count, LINE_COUNT, dtype=torch.complex64).scatter_add_(1, line, sine)
    peak = time_signal(spectrum[:, : sines.stop]).abs().amax(-1)
    spectrum[:, : sines.stop] *= (PEAK / peak.clamp(min=PEAK))[:, None]

    band = lines_within(noise_band)
    spectrum[:, band] += (NOISE / math.sqrt(2 * PERIOD)) * _complex_normal(words[:, _COMPONENT_WORDS:][:, band])
    return Stimuli(spectrum=spectrum, interval=interval, components=components)


def time_signal(spectrum: Tensor, sample_count: int = SAMPLE_LENGTH) -> Tensor:
    """The first samples of the periodic signal with the given lines.

    Args:
        spectrum: (..., n_line) complex amplitudes of the lowest lines; n_line may be below LINE_COUNT.
        sample_count: at most PERIOD.

    Returns:
        (..., sample_count) real, in the unit of the spectrum.
    """
    return torch.fft.irfft(spectrum, n=PERIOD, norm="forward")[..., :sample_count]


def white_noise(seed: int, purpose: Purpose, start: int, count: int, channels: int, rms: float) -> Tensor:
    """White Gaussian noise over 0 to 500 Hz, one stream beside the one of the stimuli.

    Returns:
        (count, channels, SAMPLE_LENGTH) float32 in the unit of ``rms``.
    """
    words = random_words(seed, purpose, "microphone", start, count, channels * SAMPLE_LENGTH // 2)
    return rms * torch.view_as_real(_complex_normal(words)).reshape(count, channels, SAMPLE_LENGTH)


def coloured_noise(
    seed: int, purpose: Purpose, start: int, count: int, channels: int, power: NDArray[np.float64]
) -> Tensor:
    """Gaussian noise of a given spectrum on lines 1 Hz apart, from the same random numbers as the white one.

    Args:
        seed: any non-negative integer.
        purpose: streams of different purposes never share a number.
        start: index of the first sample.
        count: how many.
        channels: independent of each other.
        power: (SAMPLE_LENGTH / 2,) mean square at 0, 1, ..., 499 Hz, in the square of the unit of the result.

    Returns:
        (count, channels, SAMPLE_LENGTH) float32; the noise repeats after this length.
    """
    lines = SAMPLE_LENGTH // 2
    words = random_words(seed, purpose, "microphone", start, count, channels * lines)
    # A line of 2 Re X exp(2 pi j f t) has the mean square 2 |X|^2, and a normal X of unit parts |X|^2 = 2.
    spectrum = _complex_normal(words).reshape(count, channels, lines) * torch.from_numpy(np.sqrt(power) / 2).float()
    return torch.fft.irfft(spectrum, n=SAMPLE_LENGTH, norm="forward")


def random_words(seed: int, purpose: Purpose, kind: str, start: int, count: int, words: int) -> NDArray[np.uint64]:
    """Random words of consecutive samples; sample i always gets the same ones.

    Returns:
        (count, words) uint64.
    """
    child = np.random.SeedSequence(seed, spawn_key=(_PURPOSES.index(purpose), _KINDS.index(kind)))
    philox = np.random.Philox(child)
    # Philox makes four words per count of its counter, so every sample starts at a multiple of four.
    padded = -(-words // 4) * 4
    philox.advance(start * (padded // 4))
    return philox.random_raw(count * padded).reshape(count, padded)[:, :words]


def _uniform(words: NDArray[np.uint64]) -> Tensor:
    """Two float32 numbers in (0, 1) from each word: (..., 2)."""
    halves = torch.from_numpy(np.ascontiguousarray(words).view(np.int32).reshape(*words.shape, 2))
    # The ends are kept out: zero has no logarithm, and one would be a choice beyond the last.
    return (halves.to(torch.float32) * 2.0**-32 + 0.5).clamp_(2.0**-26, 1 - 2.0**-24)


def _complex_normal(words: NDArray[np.uint64]) -> Tensor:
    """A complex number from each word, real and imaginary part normal with variance 1 (Box and Muller 1958)."""
    uniform = _uniform(words)
    radius = uniform[..., 0].log().mul_(-2).sqrt_()
    angle = (2 * math.pi) * uniform[..., 1]
    return torch.complex(radius * angle.cos(), radius * angle.sin())


def _choice(uniform: Tensor, count: Tensor | int) -> Tensor:
    """An integer in [0, count) from a number in (0, 1)."""
    return (uniform * count).long()
