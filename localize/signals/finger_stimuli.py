"""Pressure that fingers make in a cavity, in Pa: taps, presses, slides, friction, a pulse wave, and recordings.

Scale: a membrane that sweeps the volume V of a sealed cavity of volume V_0 raises its pressure by about P_0 V / V_0,
P_0 = 101 kPa being the isothermal bulk modulus of the air; under a cap of 8 mm over 150 mm^3 a tenth of a micrometre
in the middle makes about 1 Pa. The ranges below are chosen around that, from a stroke that is barely felt to a light
tap; they are ours, for no measured ones are published.

Taps, slides, friction and recordings begin and end within the sample's second. On the periodic grid of
:mod:`localize.signals.stimulus` they are followed by three seconds of silence, so that the steady state of the array,
which the generator computes, is their exact linear convolution with the impulse response, see :mod:`localize.signals`.
Every source keeps to the frequencies that the library covers: the top fifth of them is faded out by half a cosine. Each
sample owns its random numbers, as everywhere (:mod:`localize.signals.random_streams`).
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from acoustic_fem.sound.sound_file import read_wav
from geometry.ground.refusal import Kind, Refusal, counted
from localize.signals.frames import FRAME
from localize.signals.random_streams import Purpose, between, choice, complex_normal, log_between, random_words, uniform
from localize.signals.resampling import at_one_kilohertz, check_full_scale
from localize.signals.stimulus import (
    LINE_COUNT,
    LINE_SPACING,
    PERIOD,
    SAMPLE_LENGTH,
    SAMPLE_RATE,
    Device,
    Stimuli,
    lines_within,
    time_signal,
)

PULSE_SECONDS = (0.005, 0.1)
"""Shortest and longest pulse, s: from a tap to a short press."""
PULSE_PEAK = (0.1, 10.0)
"""Lowest and highest peak of a pulse, Pa."""
LISTEN = 50
"""Samples between the end of a pulse and that of the frame it falls in, for the response to arrive."""

PRESS_RISE = (0.05, 0.2)
"""Shortest and longest rise of a press, and fall, s."""
PRESS_HOLD = (0.1, 0.8)
"""Shortest and longest hold of a press, s."""
TREMOR = (6, 12)
"""Band of the tremor of a hand that holds, Hz, as of :data:`localize.contacts.draws.TREMOR`."""
UNSTEADINESS = (0.005, 0.05)
"""Least and most tremor, rms as a share of the press."""

SLIDE_LENGTH = (4.0, 14.0)
"""Shortest and longest way on which a finger that passes presses a membrane, mm: opening and finger pad together."""
SLIDE_SPEED = (14.0, 200.0)
"""Lowest and highest speed of a finger that passes, mm/s."""
GRAIN = (0.25, 4.0)
"""Shortest and longest wave of a rough finger along its way, mm, as of :mod:`localize.contacts.contact`."""
ROUGHNESS = (0.05, 0.3)
"""Least and most fluctuation of a finger that passes, rms as a share of its pressure."""

FRICTION_EDGES = ((3.0, 30.0), (60.0, 300.0))
"""Ranges in which the lower and the upper edge of the band of friction lie, Hz."""
FRICTION_RMS = (0.02, 1.0)
"""Lowest and highest level of friction, Pa rms."""
SWELL = 0.7
"""Standard deviation of the logarithm of the moving level of friction."""
SWELL_HERTZ = 4
"""Highest frequency of the moving level of friction, Hz."""
FADE = 20
"""Samples over which what does not begin or end by itself is faded in and out."""

HEART_LINES = (3, 7)
"""Beats in the four seconds of the period: 45 to 105 per minute."""
PULSE_WAVE_PEAK = (0.02, 0.5)
"""Lowest and highest peak of a pulse wave, Pa."""
_HARMONICS = 24

TOP_SHARE = 0.2
"""Share of the library's band, at its top, over which stimuli are faded out."""


def taps(seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device) -> Stimuli:
    """One smooth pulse each, sin^2 over 5 to 100 ms, within the last 250 samples: those that decisions are made from.

    Duration and peak are spread evenly on a logarithmic scale. Arguments as
    :class:`localize.signals.stimulus.StimulusSource`, its band in Hz.
    """
    drawn = uniform(random_words(seed, purpose, "taps", start, count, 2), device)
    length = SAMPLE_RATE * log_between(*PULSE_SECONDS, drawn[:, 0, 0])
    peak = log_between(*PULSE_PEAK, drawn[:, 0, 1])
    begin = between(0.0, 1.0, drawn[:, 1, 0]) * (FRAME - LISTEN - length) + (SAMPLE_LENGTH - FRAME)
    phase = (_samples(device) - begin[:, None]) / length[:, None]
    pulse = torch.where((phase > 0) & (phase < 1), torch.sin(math.pi * phase) ** 2, 0.0)
    return transient(peak[:, None] * pulse, band)


def presses(seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device) -> Stimuli:
    """One press each: it begins anywhere in the second, rises, is held by a hand that trembles, and falls.

    A press may last into the three seconds of silence, which keep the convolution exact. Arguments as
    :class:`localize.signals.stimulus.StimulusSource`, its band in Hz.
    """
    tremor = 1 + TREMOR[1] - TREMOR[0]
    words = random_words(seed, purpose, "presses", start, count, tremor + 3)
    drawn = uniform(words[:, tremor:], device)
    rise, fall = (SAMPLE_RATE * log_between(*PRESS_RISE, drawn[:, 0, k])[:, None] for k in range(2))
    hold = SAMPLE_RATE * log_between(*PRESS_HOLD, drawn[:, 1, 0])[:, None]
    peak = log_between(*PULSE_PEAK, drawn[:, 1, 1])[:, None]
    begin = between(0.0, SAMPLE_LENGTH - LISTEN, drawn[:, 2, 0])[:, None]
    since = torch.arange(2 * SAMPLE_LENGTH, device=device) - begin
    pressed = torch.minimum(since / rise, (rise + hold + fall - since) / fall).clamp(0.0, 1.0)
    slow = torch.zeros(count, SAMPLE_LENGTH // 2, dtype=torch.complex64, device=device)
    slow[:, TREMOR[0] : TREMOR[1] + 1] = complex_normal(words[:, :tremor], device)
    trembling = log_between(*UNSTEADINESS, drawn[:, 2, 1])[:, None] * unit_noise(slow).repeat(1, 2)
    return transient(peak * torch.sin(0.5 * math.pi * pressed) ** 2 * (1 + trembling), band)


def slides(seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device) -> Stimuli:
    """One rough finger each that passes over the membrane: pressure rises and falls as it comes and goes.

    Its roughness is noise along the way, whose frequencies rise with the speed. Arguments as
    :class:`localize.signals.stimulus.StimulusSource`, its band in Hz.
    """
    lines = SAMPLE_LENGTH // 2
    words = random_words(seed, purpose, "slides", start, count, lines + 3)
    drawn = uniform(words[:, lines:], device)
    speed = log_between(*SLIDE_SPEED, drawn[:, 0, 0])[:, None]
    length = SAMPLE_RATE * between(*SLIDE_LENGTH, drawn[:, 0, 1])[:, None] / speed
    peak = log_between(*PULSE_PEAK, drawn[:, 1, 0])[:, None]
    rough = between(*ROUGHNESS, drawn[:, 1, 1])[:, None]
    begin = drawn[:, 2, :1] * (SAMPLE_LENGTH - length).clamp(min=0.0)
    phase = (_samples(device) - begin) / length
    passing = torch.where((phase > 0) & (phase < 1), torch.sin(math.pi * phase) ** 2, 0.0)
    frequency = torch.arange(lines, device=device) * (SAMPLE_RATE / SAMPLE_LENGTH)
    inside = (frequency >= speed / GRAIN[1]) & (frequency <= (speed / GRAIN[0]).clamp(max=band[1]))
    noise = unit_noise(complex_normal(words[:, :lines], device) * inside)
    return transient(peak * passing * (1 + rough * noise), band)


def friction(seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device) -> Stimuli:
    """Band noise whose level moves as that of a finger that strokes: a log-normal process below 4 Hz.

    Both edges of the band and the level are drawn. Arguments as :class:`localize.signals.stimulus.StimulusSource`.
    """
    lines = SAMPLE_LENGTH // 2
    words = random_words(seed, purpose, "friction", start, count, lines + SWELL_HERTZ + 2)
    drawn = uniform(words[:, -2:], device)
    low, high = (between(*edge, drawn[:, 0, k])[:, None] for k, edge in enumerate(FRICTION_EDGES))
    rms = log_between(*FRICTION_RMS, drawn[:, 1, 0])
    frequency = torch.arange(lines, device=device) * (SAMPLE_RATE / SAMPLE_LENGTH)
    inside = (frequency >= low) & (frequency <= torch.clamp(high, max=band[1]))
    noise = unit_noise(complex_normal(words[:, :lines], device) * inside)
    slow = torch.zeros(count, lines, dtype=torch.complex64, device=device)
    slow[:, 1 : 1 + SWELL_HERTZ] = complex_normal(words[:, lines : lines + SWELL_HERTZ], device)
    moving = noise * torch.exp(SWELL * unit_noise(slow))
    level = moving.square().mean(-1).sqrt()
    return transient(_faded((rms / level)[:, None] * moving), band)


def pulse_wave(
    seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device
) -> Stimuli:
    """An artery's pulse: a systolic and a later, lower diastolic wave per beat, both Gaussian, steadily repeated.

    The shape is that of Tang et al. (2020, "Synthetic photoplethysmogram generation using two Gaussian functions",
    Scientific Reports 10, 13883); the ranges of its parameters are ours. Whole beats fill the period, so that the wave
    lies on lines of the grid. Arguments as :class:`localize.signals.stimulus.StimulusSource`, its band in Hz.
    """
    drawn = uniform(random_words(seed, purpose, "pulse wave", start, count, 4), device)
    beats = HEART_LINES[0] + choice(drawn[:, 0, 0], HEART_LINES[1] - HEART_LINES[0] + 1)
    peak = log_between(*PULSE_WAVE_PEAK, drawn[:, 0, 1])
    turn, height = drawn[:, 1, 0], between(0.2, 0.6, drawn[:, 1, 1])
    later, widths = between(0.25, 0.4, drawn[:, 2, 0]), (between(0.06, 0.09, drawn[:, 2, 1]), 0.12)
    harmonic = torch.arange(1, _HARMONICS + 1, device=device)
    # The coefficients of Gaussians of width s, repeated every beat: s exp(-2 (pi m s)^2) exp(-2 pi j m place).
    shape = torch.zeros(count, _HARMONICS, dtype=torch.complex64, device=device)
    for weight, width, place in ((torch.ones_like(height), widths[0], turn), (height, widths[1], turn + later)):
        wide = torch.as_tensor(width, device=device).expand(count)[:, None]
        size = weight[:, None] * wide * torch.exp(-2 * (math.pi * harmonic * wide) ** 2)
        shape = shape + torch.polar(size, -2 * math.pi * harmonic * place[:, None])
    spectrum = torch.zeros(count, LINE_COUNT, dtype=torch.complex64, device=device)
    spectrum.scatter_(1, beats[:, None] * harmonic, shape)
    spectrum *= (peak / time_signal(spectrum, PERIOD).amax(-1))[:, None]
    return _unnamed(spectrum * top_faded(band, device))


@dataclass(frozen=True, eq=False)
class RecordedStimulus:
    """Cuts of one second from a WAV file, each at a random place, faded in and out: a source of stimuli.

    Args:
        path: a file of one channel, at least a second long; resampled to 1 kHz.
        full_scale: Pa of the largest value the file's format can hold (1.0 for floating point): a WAV has no unit.

    Raises:
        Refusal: a file that cannot be read, has several channels, is too short, silent or not finite; a scale
            that is not above zero.
    """

    path: str | os.PathLike[str]
    """File of one channel, at least a second long."""
    full_scale: float
    """Pressure of the largest value that the file's format can hold, Pa."""
    pressure: Tensor = field(init=False, repr=False)
    """Content of the file at 1 kHz; (n_sample,) float32, Pa."""

    def __post_init__(self) -> None:
        check_full_scale(self.full_scale)
        pressure = self.full_scale * _read_wav(Path(self.path))
        object.__setattr__(self, "pressure", torch.from_numpy(pressure.astype(np.float32)))

    def __call__(
        self, seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device
    ) -> Stimuli:
        """Cuts of consecutive samples; arguments as :class:`localize.signals.stimulus.StimulusSource`."""
        drawn = uniform(random_words(seed, purpose, "recording", start, count, 1), device)
        begin = choice(drawn[:, 0, 0], len(self.pressure) - SAMPLE_LENGTH + 1)
        cut = self.pressure.to(device)[begin[:, None] + torch.arange(SAMPLE_LENGTH, device=device)]
        return transient(_faded(cut), band)


def _samples(device: Device) -> Tensor:
    return torch.arange(SAMPLE_LENGTH, device=device)


def transient(pressure: Tensor, band: tuple[float, float]) -> Stimuli:
    """Stimuli that begin and end by themselves.

    Args:
        pressure: (n, at most PERIOD) float32, Pa; silence follows for the rest of the period.
        band: frequencies that the transfer functions cover, Hz.
    """
    spectrum = torch.fft.rfft(pressure, n=PERIOD, norm="forward")[:, :LINE_COUNT]
    return _unnamed(spectrum * top_faded(band, pressure.device))


def _unnamed(spectrum: Tensor) -> Stimuli:
    none = torch.zeros(len(spectrum), dtype=torch.int64, device=spectrum.device)
    return Stimuli(spectrum=spectrum, interval=none - 1, components=none)


def top_faded(band: tuple[float, float], device: Device = "cpu") -> Tensor:
    """Factors on the lines by which the sources here keep to the library's frequencies.

    One up to four fifths of the band's top, then half a cosine down to zero.

    Args:
        band: frequencies that the transfer functions cover, Hz.
        device: where the result shall be.

    Returns:
        (LINE_COUNT,) float32.
    """
    stop = lines_within(band).stop
    frequency = torch.arange(LINE_COUNT, device=device) * LINE_SPACING
    share = ((band[1] - frequency) / (TOP_SHARE * band[1])).clamp(0.0, 1.0)
    fade = torch.sin(0.5 * math.pi * share) ** 2
    return torch.where(torch.arange(LINE_COUNT, device=device) < stop, fade, 0.0)


def unit_noise(spectrum: Tensor) -> Tensor:
    """Noise of mean square one, (n, SAMPLE_LENGTH), from lines 1 Hz apart, (n, n_line) complex64."""
    signal = torch.fft.irfft(spectrum, n=SAMPLE_LENGTH, norm="forward")
    return signal / signal.square().mean(-1, keepdim=True).sqrt()


def _faded(pressure: Tensor) -> Tensor:
    sample = _samples(pressure.device)
    edge = torch.minimum(sample, SAMPLE_LENGTH - 1 - sample)
    return pressure * torch.sin(0.5 * math.pi * (edge / FADE).clamp(max=1.0)) ** 2


def _read_wav(path: Path) -> np.ndarray:
    """(n_sample,) float64 at 1 kHz, one being the largest value the format holds."""
    sound = read_wav(path)
    if len(sound.channels) != 1:
        raise Refusal(
            f"has {counted(len(sound.channels), 'channel')}, must have one: the pressure in a cavity",
            kind=Kind.MISMATCH,
            file=path,
        )
    (pressure,) = sound.channels.values()
    if not np.isfinite(pressure).all():
        raise Refusal("holds values that are not finite", kind=Kind.UNSUITABLE, file=path)
    if not len(pressure) or not np.ptp(pressure) > 0:
        raise Refusal("is silent: its value never changes", kind=Kind.UNSUITABLE, file=path)
    resampled = at_one_kilohertz(pressure[None], sound.rate)[0]
    if len(resampled) < SAMPLE_LENGTH:
        raise Refusal(
            f"lasts {len(pressure) / sound.rate:.3g} s, must last at least 1 s", kind=Kind.UNSUITABLE, file=path
        )
    return resampled
