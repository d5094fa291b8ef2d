"""An artery's pressure under a finger: beats of a percussion, a tidal and a dicrotic wave.

Each wave is a Gaussian of the beat's phase, as Tang et al. (2020, "Synthetic photoplethysmogram generation using two
Gaussian functions", Scientific Reports 10, 13883) have two of them; the ranges, and that the heart's period wanders
from beat to beat, are ours.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from localize.signals.stimulus import SAMPLE_RATE

Array = NDArray[np.float64]

WAVES = ("percussion", "tidal", "dicrotic")
"""Waves of a beat, in the order of time."""
_AT = (0.0, 0.17, 0.38)
"""Time of each wave behind the first at 60 beats a minute, s; it goes with the root of the period (Weissler 1968)."""
_WIDTH = (0.055, 0.06, 0.065)
"""Standard deviation of each wave at 60 beats a minute, s."""
_HEIGHT = ((1.0, 1.0), (0.45, 0.65), (0.3, 0.5))
"""Lowest and highest height of each wave."""
_WANDER = 0.03
"""Standard deviation of the period from beat to beat, a share of it."""


def beat_times(count: int, rate: float, random: np.random.Generator) -> tuple[Array, Array]:
    """Beginnings of beats that cover a take, and their periods.

    Args:
        count: samples at 1 kHz.
        rate: beats a minute.
        random: draws where the first begins and how the period wanders.

    Returns:
        (n_beat,) float64, s, of the percussion waves, the first before the take; and (n_beat,) float64, s.
    """
    number = int(np.ceil(count / SAMPLE_RATE * rate / 60)) + 4
    period = 60 / rate * (1 + _WANDER * np.clip(random.standard_normal(number), -2.5, 2.5))
    return np.cumsum(period) - period[0] - (1 + random.uniform()) * 60 / rate, period


def arterial_pressure(
    count: int, rate: float, random: np.random.Generator, truth: dict[str, Array] | None = None
) -> Array:
    """Pressure of an artery, of height one.

    Args:
        count: samples at 1 kHz.
        rate: beats a minute.
        random: draws the beats.
        truth: filled with the times of the waves by name, (n_beat,) float64, s, where it is given.

    Returns:
        (count,) float64.
    """
    begin, period = beat_times(count, rate, random)
    time, made = np.arange(count) / SAMPLE_RATE, np.zeros(count)
    heights = [random.uniform(*height) for height in _HEIGHT]
    places = [at * random.uniform(0.95, 1.05) for at in _AT]
    stretch = np.sqrt(period)
    for name, at, width, height in zip(WAVES, places, _WIDTH, heights, strict=True):
        centre = begin + at * stretch
        if truth is not None:
            truth[name] = centre
        made += height * np.exp(-0.5 * ((time - centre[:, None]) / (width * stretch[:, None])) ** 2).sum(0)
    return np.asarray(made)
