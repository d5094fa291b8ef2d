"""Kinds of touches by name, mixtures of several, and louder ones."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import torch

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from localize.signals.finger_stimuli import friction, presses, pulse_wave, slides, taps
from localize.signals.finger_strokes import press_strokes, slide_strokes, tap_strokes
from localize.signals.random_streams import Purpose, choice, random_words, uniform
from localize.signals.stimulus import Device, Stimuli, StimulusSource, multi_sines

RUN = 64
"""Consecutive samples of a mixture that come from one source."""


@dataclass(frozen=True)
class Mixture:
    """Mixture of several sources: every 64 consecutive samples come from one of them, drawn.

    Raises:
        Refusal: no source, or shares that are not one positive number for each.
    """

    sources: tuple[StimulusSource, ...]
    """Sources from which is drawn, at least one."""
    shares: tuple[float, ...] = ()
    """How often each is drawn, relative to the others; all alike where none are given."""

    def __post_init__(self) -> None:
        if not self.sources:
            raise Refusal("holds no source", kind=Kind.UNSUITABLE, field="sources")
        if self.shares and (
            len(self.shares) != len(self.sources) or not all(0 < each < math.inf for each in self.shares)
        ):
            raise Refusal(
                kind=Kind.OUT_OF_RANGE,
                field="shares",
                value=self.shares,
                allowed=f"{counted(len(self.sources), 'finite number')} above zero, one for each source",
            )

    def which(self, seed: int, purpose: Purpose, first: int, count: int) -> list[int]:
        """Source of each of consecutive runs of 64 samples, from 0; run k is that of the samples from 64 k on."""
        drawn = uniform(random_words(seed, purpose, "mixture", first, count, 1))[:, 0, 0]
        if not self.shares:
            return choice(drawn, len(self.sources)).tolist()
        bounds = torch.cumsum(torch.tensor(self.shares, dtype=torch.float64), 0)
        return torch.searchsorted(bounds[:-1] / bounds[-1], drawn.double(), right=True).tolist()

    def __call__(
        self, seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device
    ) -> Stimuli:
        """Stimuli of consecutive samples; arguments as :class:`localize.signals.stimulus.StimulusSource`."""
        first, last = start // RUN, (start + count - 1) // RUN
        parts = []
        for run, which in enumerate(self.which(seed, purpose, first, last - first + 1), first):
            begin, end = max(start, run * RUN), min(start + count, (run + 1) * RUN)
            parts.append(self.sources[which](seed, purpose, begin, end - begin, band, device))
        none = [torch.zeros_like(part.interval, dtype=torch.bool) for part in parts]
        strokes = [no if part.is_stroke is None else part.is_stroke for no, part in zip(none, parts, strict=True)]
        return Stimuli(
            torch.cat([part.spectrum for part in parts]),
            torch.cat([part.interval for part in parts]),
            torch.cat([part.components for part in parts]),
            torch.cat(strokes),
        )


@dataclass(frozen=True)
class Louder:
    """Source whose touches are all louder than those of another, their own noise too.

    Raises:
        Refusal: a level out of range.
    """

    source: StimulusSource
    """Source of the touches."""
    level: float
    """By how much they are louder, dB, -60 to 60; the publication's own amplitudes have no unit."""

    def __post_init__(self) -> None:
        check_range("level", self.level, -60.0, 60.0, "dB")

    def __call__(
        self, seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device
    ) -> Stimuli:
        """Stimuli of consecutive samples; arguments as :class:`localize.signals.stimulus.StimulusSource`."""
        made = self.source(seed, purpose, start, count, band, device)
        return replace(made, spectrum=10 ** (self.level / 20) * made.spectrum)


#: The sources that need no file, by name.
STIMULI: Mapping[str, StimulusSource] = {
    "multi-sines": multi_sines,
    "taps": taps,
    "presses": presses,
    "slides": slides,
    "friction": friction,
    "pulse-wave": pulse_wave,
    "tap-strokes": tap_strokes,
    "press-strokes": press_strokes,
    "slide-strokes": slide_strokes,
}
