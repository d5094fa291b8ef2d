"""Strokes of a membrane by a finger: what the membrane does, anywhere in the frame that a decision is made from.

A stroke is how far a finger moves the membrane over time. The pressure in the cavity is not that stroke: air leaks
into the tubes, so that it undershoots when the finger lifts. The generator therefore takes a stroke through
:attr:`localize.ArrayResponse.cavity_response`, which holds membrane and air, and scales it to the pressure that it
makes at :data:`localize.signals.stimulus.SCALED_AT`. Where an array does not know its membranes, a stroke is a
pressure.

A tap rises and falls, a press rises, is held and falls, a finger that slides over the membrane presses as it passes. In
each, either the rise or the fall lies in the last 250 samples of the second. Where strokes are evaluated, that edge
lies wholly in this frame if it is short enough, as in the frames by which a stream reports a touch. In training it may
also begin before. The ranges are those of :mod:`localize.contacts` and :mod:`localize.signals.finger_stimuli`.
"""

from __future__ import annotations

import math
from dataclasses import replace

import torch
from torch import Tensor

from localize.signals.finger_stimuli import (
    GRAIN,
    PRESS_HOLD,
    PRESS_RISE,
    ROUGHNESS,
    SLIDE_LENGTH,
    SLIDE_SPEED,
    TREMOR,
    UNSTEADINESS,
    transient,
    unit_noise,
)
from localize.signals.frames import FRAME
from localize.signals.random_streams import Purpose, between, complex_normal, log_between, random_words, uniform
from localize.signals.stimulus import SAMPLE_LENGTH, SAMPLE_RATE, Device, Stimuli

TAP_SECONDS = (0.01, 0.1)
"""Shortest and longest tap, s."""
PEAK = (0.03, 30.0)
"""Lowest and highest peak, Pa: from a stroke that is barely felt to a firm press."""
SECOND = (0.06, 0.35)
"""Shortest and longest time from one tap to the next of a double tap, s."""
DOUBLE = 0.25
"""Share of the taps that are double."""
HEARD = 30
"""Samples at the end of the frame in which an edge does not begin, for the response to arrive."""


def tap_strokes(
    seed: int,
    purpose: Purpose,
    start: int,
    count: int,
    band: tuple[float, float],
    device: Device,
    peak: tuple[float, float] = PEAK,
) -> Stimuli:
    """One tap each, one in four followed by a second one; arguments as of
    :class:`localize.signals.stimulus.StimulusSource`, its band in Hz, and lowest and highest peak.
    """
    drawn = uniform(random_words(seed, purpose, "tap strokes", start, count, 4), device)
    half = 0.5 * SAMPLE_RATE * log_between(*TAP_SECONDS, drawn[:, 0, 0])
    begin = _begin(2 * half, drawn[:, 0, 1], purpose)
    apart = SAMPLE_RATE * between(*SECOND, drawn[:, 1, 0])
    second = torch.where(drawn[:, 1, 1] < DOUBLE, between(0.6, 1.4, drawn[:, 2, 0]), 0.0)
    # Either tap of the two may be the one in the frame.
    begin = torch.where(drawn[:, 2, 1] < 0.5, begin, begin - apart * (second > 0))
    none = torch.zeros_like(half)
    shape = _pressed(begin, half, none, half) + second[:, None] * _pressed(begin + apart, half, none, half)
    return _strokes(log_between(*peak, drawn[:, 3, 0]), shape, band)


def press_strokes(
    seed: int,
    purpose: Purpose,
    start: int,
    count: int,
    band: tuple[float, float],
    device: Device,
    peak: tuple[float, float] = PEAK,
) -> Stimuli:
    """One press each by a hand that trembles; arguments as of :class:`localize.signals.stimulus.StimulusSource`, its
    band in Hz, and lowest and highest peak.
    """
    tremor = 1 + TREMOR[1] - TREMOR[0]
    words = random_words(seed, purpose, "press strokes", start, count, tremor + 4)
    drawn = uniform(words[:, tremor:], device)
    rise, fall = (SAMPLE_RATE * log_between(*PRESS_RISE, drawn[:, 0, k]) for k in range(2))
    hold = SAMPLE_RATE * log_between(*PRESS_HOLD, drawn[:, 1, 0])
    at_rise = drawn[:, 2, 0] < 0.5
    begin = torch.where(
        at_rise, _begin(rise, drawn[:, 1, 1], purpose), _begin(fall, drawn[:, 1, 1], purpose) - rise - hold
    )
    # What would begin before the second is held for less long.
    hold, begin = hold + begin.clamp(max=0.0) * ~at_rise, begin.clamp(min=0.0)
    slow = torch.zeros(count, SAMPLE_LENGTH // 2, dtype=torch.complex64, device=device)
    slow[:, TREMOR[0] : TREMOR[1] + 1] = complex_normal(words[:, :tremor], device)
    trembling = log_between(*UNSTEADINESS, drawn[:, 2, 1])[:, None] * unit_noise(slow).repeat(1, 2)
    shape = _pressed(begin, rise, hold, fall) * (1 + trembling)
    return _strokes(log_between(*peak, drawn[:, 3, 0]), shape, band)


def slide_strokes(
    seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device
) -> Stimuli:
    """One rough finger each that passes over the membrane; arguments as of
    :class:`localize.signals.stimulus.StimulusSource`, its band in Hz.
    """
    lines = SAMPLE_LENGTH // 2
    words = random_words(seed, purpose, "slide strokes", start, count, lines + 3)
    drawn = uniform(words[:, lines:], device)
    speed = log_between(*SLIDE_SPEED, drawn[:, 0, 0])
    half = 0.5 * SAMPLE_RATE * between(*SLIDE_LENGTH, drawn[:, 0, 1]) / speed
    rough = between(*ROUGHNESS, drawn[:, 1, 1])[:, None]
    frequency = torch.arange(lines, device=device) * (SAMPLE_RATE / SAMPLE_LENGTH)
    along = speed[:, None]
    inside = (frequency >= along / GRAIN[1]) & (frequency <= (along / GRAIN[0]).clamp(max=band[1]))
    noise = unit_noise(complex_normal(words[:, :lines], device) * inside).repeat(1, 2)
    shape = _pressed(_begin(2 * half, drawn[:, 2, 0], purpose), half, torch.zeros_like(half), half)
    return _strokes(log_between(*PEAK, drawn[:, 1, 0]), shape * (1 + rough * noise), band)


def _begin(length: Tensor, drawn: Tensor, purpose: Purpose) -> Tensor:
    """Sample at which an edge of some length begins, so that most of it lies in the last frame; (n,)."""
    start = SAMPLE_LENGTH - FRAME
    first, last = start - 0.9 * length, SAMPLE_LENGTH - HEARD - 0.5 * length
    if purpose == "evaluation":
        inside = SAMPLE_LENGTH - 2 * HEARD - length
        is_short = inside > start
        first, last = torch.where(is_short, start, first + 0.4 * length), torch.where(is_short, inside, last)
    return first + (torch.maximum(last, first) - first) * drawn


def _pressed(begin: Tensor, rise: Tensor, hold: Tensor, fall: Tensor) -> Tensor:
    """(n, 2000) strokes of height one, from four times in samples, (n,) each."""
    since = torch.arange(2 * SAMPLE_LENGTH, device=begin.device) - begin[:, None]
    left = (rise + hold + fall)[:, None] - since
    return torch.sin(0.5 * math.pi * torch.minimum(since / rise[:, None], left / fall[:, None]).clamp(0.0, 1.0)) ** 2


def _strokes(peak: Tensor, shape: Tensor, band: tuple[float, float]) -> Stimuli:
    made = transient(peak[:, None] * shape, band)
    return replace(made, is_stroke=torch.ones_like(made.interval, dtype=torch.bool))
