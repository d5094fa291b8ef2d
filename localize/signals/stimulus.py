"""Multi-sine stimuli: the pressure of a touch in a cavity, one random stream per sample.

A stimulus is the sum of N sinusoids between 1 and 100 Hz with amplitudes U[0.02, 0.1] Pa and random phases,
divided by its peak where that exceeds 1 Pa, plus white noise of 0.005 Pa rms (Scalable Dynamic Tactile Sensing
Enabled by Passive and Flexible Acoustic Waveguides, section on simulated data). N is drawn from one of seven
intervals, all equally likely. Three choices are ours: frequencies lie on the lines of a periodic grid, a quarter of
a hertz apart, so that the response of a linear array is exact; the sample is the first second of that period; and the
amplitudes, to which the publication gives no unit, are in Pa.

Stimuli of fingers are in :mod:`localize.signals.finger_stimuli`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from localize.signals.random_streams import Purpose, between, choice, complex_normal, fill_normal, random_words, uniform

if TYPE_CHECKING:
    import torch
    from torch import Tensor

SAMPLE_RATE = 1000.0
"""Sample rate of all signals, Hz."""
BAND = (1.0, 100.0)
"""Band of the stimuli and of the features, Hz."""
PERIOD = 4000
"""Length of the periodic grid, samples: spectral lines are 0.25 Hz apart."""
LINE_SPACING = SAMPLE_RATE / PERIOD
"""Distance of two spectral lines, Hz."""
LINE_COUNT = PERIOD // 2
"""Number of lines below half the sample rate; line k lies at k LINE_SPACING, line 0 stays empty."""
SAMPLE_LENGTH = 1000
"""Length of one stimulus, samples: one second."""
TOGETHER = 32
"""Number of signals that are made together, so that they stay in the processor's cache."""
COMPONENT_INTERVALS = ((1, 4), (4, 20), (20, 40), (40, 60), (60, 80), (80, 100), (1, 101))
"""Half-open intervals of the number of sinusoids."""
AMPLITUDE = (0.02, 0.1)
"""Lowest and highest amplitude of a sinusoid, Pa."""
PEAK = 1.0
"""Highest peak, Pa: stronger sums are scaled down to it."""
SCALED_AT = 30.0
"""Frequency at which a stroke makes a pressure of its own size in the cavity, Hz: the middle of what touches hold."""
NOISE = 0.005
"""Level of the white noise of a stimulus, Pa rms over 0 to 500 Hz."""

#: Where tensors lie: a device of torch, or its name.
Device: TypeAlias = "torch.device | str"
_MOST_COMPONENTS = max(high for _, high in COMPONENT_INTERVALS) - 1
_COMPONENT_WORDS = 2 + 2 * _MOST_COMPONENTS
_STIMULUS_WORDS = _COMPONENT_WORDS + LINE_COUNT


@dataclass(frozen=True)
class Stimuli:
    """Spectra of consecutive samples, in Pa: x(t) = spectrum_0 + 2 Re sum_k spectrum_k exp(2 pi j f_k t), k > 0."""

    spectrum: Tensor
    """Complex amplitudes on the lines of the periodic grid; (n, LINE_COUNT) complex64, Pa."""
    interval: Tensor
    """Index of each sample into ``COMPONENT_INTERVALS``, -1 for stimuli that are not multi-sine; (n,) int64."""
    components: Tensor
    """Number of sinusoids of each sample; (n,) int64."""
    is_stroke: Tensor | None = None
    """True for strokes of the membrane, which go through membrane and cavity first, see
    :mod:`localize.signals.finger_strokes`; (n,) bool, None where all are pressures in the cavity."""


class StimulusSource(Protocol):
    """Source of stimuli: :func:`multi_sines`, those of :mod:`localize.signals.finger_stimuli`, or your own."""

    def __call__(
        self, seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device, /
    ) -> Stimuli:
        """Stimuli of samples ``start`` to ``start + count - 1``, each the same whatever was asked for before.

        ``band`` is what the transfer functions cover, Hz: no line above it may be excited.
        """


def line_frequencies() -> NDArray[np.float64]:
    """Frequencies of the spectral lines; (LINE_COUNT,) float64, Hz."""
    return np.arange(LINE_COUNT, dtype=np.float64) * LINE_SPACING


def lines_within(band: tuple[float, float]) -> slice:
    """Slice of the lines from ``band[0]`` to ``band[1]`` Hz, both included, line 0 never."""
    tolerance = 1e-6
    first = math.ceil(band[0] / LINE_SPACING - tolerance)
    last = math.floor(band[1] / LINE_SPACING + tolerance)
    return slice(max(first, 1), min(last, LINE_COUNT - 1) + 1)


def multi_sines(
    seed: int, purpose: Purpose, start: int, count: int, noise_band: tuple[float, float], device: Device = "cpu"
) -> Stimuli:
    """Sums of sinusoids with white noise: samples ``start`` to ``start + count - 1`` of a stream of stimuli.

    Args:
        seed: any non-negative integer.
        purpose: streams of different purposes never share a stimulus, whatever the seed.
        start: index of the first sample.
        count: how many.
        noise_band: Hz; the white noise is limited to these frequencies (those the transfer functions cover).
            The sinusoids of a sample do not depend on it.
        device: where the result shall be.
    """
    import torch

    words = random_words(seed, purpose, "stimulus", start, count, _STIMULUS_WORDS)
    drawn = uniform(words[:, :_COMPONENT_WORDS], device)
    bounds = torch.tensor(COMPONENT_INTERVALS, device=device)
    interval = choice(drawn[:, 0, 0], len(COMPONENT_INTERVALS))
    low, high = bounds[interval, 0], bounds[interval, 1]
    components = low + choice(drawn[:, 0, 1], high - low)

    sines = lines_within(BAND)
    line = sines.start + choice(drawn[:, 2 : 2 + _MOST_COMPONENTS, 0], sines.stop - sines.start)
    rest = drawn[:, 2 + _MOST_COMPONENTS :]
    amplitude = between(*AMPLITUDE, rest[..., 0])
    amplitude = amplitude * (torch.arange(_MOST_COMPONENTS, device=device) < components[:, None])
    sine = torch.polar(amplitude / 2, (2 * math.pi) * rest[..., 1])
    noise = torch.zeros(count, LINE_COUNT, dtype=torch.complex64)
    band = lines_within(noise_band)
    fill_normal(words[:, _COMPONENT_WORDS:][:, band], noise.numpy()[:, band])
    spectrum = noise.mul_(NOISE / math.sqrt(2 * PERIOD)).to(device)
    on_processor = spectrum.device.type == "cpu"
    several = TOGETHER if on_processor else max(count, 1)
    sines_alone = spectrum.new_zeros(min(several, count), LINE_COUNT + 1)
    for part in (slice(first, first + several) for first in range(0, count, several)):
        own = sines_alone[: len(line[part])]
        own[:, : sines.stop] = 0
        own.scatter_add_(1, line[part], sine[part])
        # Weaker ones cannot reach the peak; an accelerator does them all rather than wait for their number.
        reached = amplitude[part].sum(-1) > PEAK if on_processor else torch.ones(len(own), dtype=torch.bool)
        strong = torch.nonzero(reached)[:, 0].to(device)
        if len(strong):
            peak = time_signal(own[strong]).abs().amax(-1)
            own[strong, : sines.stop] *= (PEAK / peak.clamp(min=PEAK))[:, None]
        spectrum[part, : sines.stop] += own[:, : sines.stop]
    return Stimuli(spectrum=spectrum, interval=interval, components=components)


def time_signal(spectrum: Tensor, sample_count: int = SAMPLE_LENGTH) -> Tensor:
    """First samples of the periodic signal with the given lines.

    Args:
        spectrum: (..., n_line) complex amplitudes of the lowest lines, in any unit; n_line may be below LINE_COUNT, and
            nothing is copied where it is LINE_COUNT + 1.
        sample_count: at most PERIOD.

    Returns:
        (..., sample_count) real, in the unit of the spectrum.
    """
    import torch

    # what is left out of the period is not kept
    several = TOGETHER if spectrum.ndim > 1 and spectrum.device.type == "cpu" else max(len(spectrum), 1)
    if len(spectrum) <= several:
        return torch.fft.irfft(spectrum, n=PERIOD, norm="forward")[..., :sample_count]
    parts = [torch.fft.irfft(part, n=PERIOD, norm="forward")[..., :sample_count] for part in spectrum.split(several)]
    return torch.cat(parts)


def white_noise(
    seed: int, purpose: Purpose, start: int, count: int, channels: int, rms: float, device: Device = "cpu"
) -> Tensor:
    """White Gaussian noise over 0 to 500 Hz, one stream beside the one of the stimuli.

    Args:
        seed: any non-negative integer.
        purpose: streams of different purposes never share a number.
        start: index of the first sample.
        count: how many.
        channels: independent of each other.
        rms: root mean square, in any unit.
        device: where the result shall be.

    Returns:
        (count, channels, SAMPLE_LENGTH) float32 in the unit of ``rms``.
    """
    import torch

    words = random_words(seed, purpose, "microphone", start, count, channels * SAMPLE_LENGTH // 2)
    return rms * torch.view_as_real(complex_normal(words, device)).reshape(count, channels, SAMPLE_LENGTH)


def coloured_noise(
    seed: int,
    purpose: Purpose,
    start: int,
    count: int,
    channels: int,
    power: NDArray[np.float64],
    device: Device = "cpu",
) -> Tensor:
    """Gaussian noise of a given spectrum on lines 1 Hz apart, from the same random numbers as the white one.

    Args:
        seed: any non-negative integer.
        purpose: streams of different purposes never share a number.
        start: index of the first sample.
        count: how many.
        channels: independent of each other.
        power: (SAMPLE_LENGTH / 2,) float64, mean square at 0, 1, ..., 499 Hz, in the square of the unit of the result.
        device: where the result shall be.

    Returns:
        (count, channels, SAMPLE_LENGTH) float32; the noise repeats after this length.
    """
    import torch

    lines = SAMPLE_LENGTH // 2
    words = random_words(seed, purpose, "microphone", start, count, channels * lines)
    # A line of 2 Re X exp(2 pi j f t) has the mean square 2 |X|^2, and a normal X of unit parts |X|^2 = 2.
    amplitude = torch.from_numpy(np.sqrt(power) / 2).float().to(device)
    spectrum = complex_normal(words, device).reshape(count, channels, lines) * amplitude
    return torch.fft.irfft(spectrum, n=SAMPLE_LENGTH, norm="forward")
