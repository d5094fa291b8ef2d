"""Disturbances that microphones record beside the touch: sound from outside, and the scatter of the microphones.

Sound: its wavelength, 3.4 m at 100 Hz, is far above the size of an array, so that it presses on all membranes alike.
The network tells what reaches each microphone (:meth:`acoustic_fem.Library.touch_response`, summed over the points). It
is pink, as rooms and traffic are by and large, from 20 Hz to the top of the library's range or 500 Hz; its level is
the rms pressure of this band in dB re 20 uPa.

Microphones: sensitivity and vent scatter from one to the next. With the vent ratio v of the design's microphone
(:func:`acoustic_fem.network.microphone.vent_ratio`), one whose vent conducts s times as well and whose sensitivity is g
times the nominal one records g (1 + v) / (s + v) times what the nominal one would.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from geometry.ground.argument_checks import check_range, real_numbers, wrong_type
from geometry.ground.refusal import Kind, Refusal
from localize.signals.random_streams import Purpose, between, complex_normal, random_words, uniform
from localize.signals.stimulus import SAMPLE_LENGTH, SAMPLE_RATE, Device

if TYPE_CHECKING:
    from torch import Tensor

REFERENCE = 20e-6
"""Reference pressure of sound levels, Pa."""
LOWEST_SOUND = 20.0
"""Lowest frequency of the sound outside, Hz."""
MAINS = (50.0, 60.0)
"""Frequencies of mains, Hz: their hum comes in by cables, not through the array."""
ROOM_LEVELS = (30.0, 95.0)
"""Lowest and highest level of the sound of rooms that localizers are trained in, dB SPL: the paper's 90 dB are not the
edge of the range in training."""
SOUND_LEVELS = (0.0, 140.0)
"""Lowest and highest level of sound that a decoder can assume, dB SPL."""
SIMULATED_LEVELS = (-100.0, 140.0)
"""Lowest and highest level of simulated sound, dB SPL: down to what no microphone records."""
SOUND_LINES = SAMPLE_LENGTH // 2
"""Number of lines of the sound, 1 Hz apart: it repeats after a second, the length of a sample."""


@dataclass(frozen=True)
class MicrophoneMismatch:
    """Scatter of the microphones of an array; each sample is recorded by microphones of its own.

    Raises:
        Refusal: a figure outside its range.
    """

    gain: float = 0.0
    """Standard deviation of the sensitivity, 0 to 20 dB."""
    vent: float = 0.0
    """Relative standard deviation of the vent's conductance (log-normal), 0 to 1."""

    def __post_init__(self) -> None:
        for name, most, unit in (("gain", 20.0, "dB"), ("vent", 1.0, "")):
            check_range(f"mismatch.{name}", getattr(self, name), 0, most, unit)

    def factors(
        self, seed: int, purpose: Purpose, start: int, count: int, microphones: int, vent_ratio: Tensor
    ) -> Tensor:
        """Ratio of the recorded to the nominal signal, of each sample's own microphones.

        Args:
            seed: any non-negative integer.
            purpose: see :mod:`localize.signals.random_streams`.
            start: index of the first sample.
            count: how many.
            microphones: of the array.
            vent_ratio: (n_line,) complex, v of the module's text; on the device on which the result shall be.

        Returns:
            (count, microphones, n_line) complex64.
        """
        import torch

        drawn = complex_normal(
            random_words(seed, purpose, "mismatch", start, count, microphones), vent_ratio.device
        )[..., None]  # fmt: skip
        gain = 10 ** (self.gain / 20 * drawn.real)
        vent = torch.exp(math.sqrt(math.log1p(self.vent**2)) * drawn.imag)
        return gain * (1 + vent_ratio) / (vent + vent_ratio)


def check_sound_level(level: float | None, field: str = "ambient") -> None:
    """Refuse a level of sound that no decoder can assume; None stands for a quiet room.

    Args:
        level: dB SPL.
        field: name of the argument.

    Raises:
        Refusal: not one number, or outside 0 to 140 dB SPL.
    """
    if level is not None:
        check_range(field, level, *SOUND_LEVELS, "dB SPL")


def steady_sound(ambient: float | None) -> tuple[float, float] | None:
    """Lowest and highest level of a simulated sound of one level, dB SPL; None for silence.

    Raises:
        Refusal: not one number, or outside -100 to 140 dB SPL.
    """
    if ambient is None:
        return None
    level = check_range("ambient", ambient, *SIMULATED_LEVELS, "dB SPL")
    return level, level


def check_ambient(ambient: tuple[float, float]) -> None:
    """Refuse levels of ambient sound, dB SPL, that are no range.

    Raises:
        Refusal: not two numbers, or levels that do not ascend from -100 to 140 dB SPL.
    """
    levels = real_numbers("ambient", ambient)
    if levels.shape != (2,):
        raise wrong_type("ambient", "must be two numbers, the lowest and the highest level, dB SPL", value=ambient)
    low, high = SIMULATED_LEVELS
    if not low <= levels[0] <= levels[1] <= high:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="ambient",
            value=ambient,
            allowed="the lowest and the highest level, between -100 and 140 dB SPL",
        )


def ambient_sound(
    seed: int,
    purpose: Purpose,
    start: int,
    count: int,
    levels: tuple[float, float],
    top: float,
    device: Device = "cpu",
) -> Tensor:
    """Pink sound on lines 1 Hz apart, each sample of a level of its own, evenly spread between two.

    Args:
        seed: any non-negative integer.
        purpose: see :mod:`localize.signals.random_streams`.
        start: index of the first sample.
        count: how many.
        levels: lowest and highest level, dB re 20 uPa over the whole band.
        top: Hz, upper end of the band.
        device: where the result shall be.

    Returns:
        (count, SOUND_LINES) complex64, Pa: p(t) = 2 Re sum_k spectrum_k exp(2 pi j f_k t), f_k = k Hz.
    """
    import torch

    words = random_words(seed, purpose, "ambient", start, count, SOUND_LINES + 1)
    rms = REFERENCE * 10 ** (between(*levels, uniform(words[:, -1:], device)[:, 0, :1]) / 20)
    frequency = torch.arange(SOUND_LINES, device=device) * (SAMPLE_RATE / SAMPLE_LENGTH)
    power = torch.where((frequency >= LOWEST_SOUND) & (frequency <= top), 1 / frequency.clamp(min=1.0), 0.0)
    # A line of 2 Re X exp(2 pi j f t) has the mean square 2 |X|^2, and a normal X of unit parts |X|^2 = 2.
    return rms * (power / power.sum() / 4).sqrt() * complex_normal(words[:, :-1], device)
