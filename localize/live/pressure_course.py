"""Course of the mean pressure of the microphones, as a stream's decisions carry it: strokes, waves and what is held.

Slow pressure reaches all microphones of a closed array with the same sign. Their mean as they come, before the
high-pass, therefore rises when a finger presses a membrane and falls when it lets go, whichever point it is.
"""

from __future__ import annotations

import math
from collections import deque

import numpy as np

from geometry.ground.typed import Array
from localize.live.events import HOP, Decision
from localize.signals.stimulus import SAMPLE_RATE

HOP_SECONDS = HOP / SAMPLE_RATE
"""Time from one decision to the next, s."""
RESTS = 0.1
"""Fraction of the peak of a wave below which the pressure rests."""


class PressureCourse:
    """Course of the pressure over the last seconds, a mean for every decision.

    Args:
        seconds: length of what is remembered, s.
    """

    def __init__(self, seconds: float) -> None:
        self._means: deque[float] = deque(maxlen=round(seconds / HOP_SECONDS))
        self._time = -math.inf

    def take(self, event: Decision) -> None:
        """Take the next decision; after a gap, or one without a pressure, all before it is forgotten."""
        if event.mean_pressure is None or not 0 < event.time - self._time < 1.5 * HOP_SECONDS:
            self._means.clear()
        if event.mean_pressure is not None:
            self._means.append(event.mean_pressure)
        self._time = event.time

    @property
    def newest(self) -> float | None:
        """Pressure at the last decision, Pa; None where it is not known."""
        return self._means[-1] if self._means else None

    def last(self, hops: int) -> Array:
        """Pressure at the last decisions; (n_hop,) float64, Pa, empty where it is not known for so long."""
        return np.array(list(self._means)[-hops:]) if hops <= len(self._means) else np.empty(0)


class Wave:
    """Wave of the pressure since a touch, or a beat of it, began.

    Args:
        course: (n,) float64, Pa, from before it began; empty where it is not known.
        before: number of values in which its foot lies.
        held_fraction: fraction of its peak below which nothing is held any more.
    """

    def __init__(self, course: Array, before: int, held_fraction: float) -> None:
        self._held_fraction = held_fraction
        # What follows a short tap may lie below its foot.
        foot = int(course[:before].argmin()) if len(course) else 0
        self._foot = float(course[foot]) if len(course) else math.nan
        self._peak = 0.0
        self.rests = 0
        """Number of decisions for which the pressure has rested near its foot."""
        self.fallen = 0
        """Number of decisions since the pressure has fallen back; 0 from its peak until then, while it is held."""
        for each in course[foot:]:
            self.take(float(each), True)

    @property
    def peak(self) -> float:
        """Height of the wave so far, Pa."""
        return self._peak

    def take(self, pressure: float | None, in_contact: bool) -> None:
        """Take the next pressure, Pa; None where it is not known. The wave only grows in a contact."""
        height = math.nan if pressure is None else pressure - self._foot
        if in_contact and height > self._peak:
            self._peak, self.fallen = height, 0
        elif self.fallen or not height >= self._held_fraction * self._peak:
            self.fallen += 1
        self.rests += not height >= RESTS * self._peak


def first_stroke(course: Array) -> float:
    """First large change of a pressure, Pa: above 0 for a rise, below 0 for a fall.

    It is the largest rise or the largest fall, whichever first reaches a third of the larger one: behind a high-pass of
    the microphones, a tap falls further than it has risen.

    Args:
        course: (n,) float64, Pa, n at least 1.
    """
    rise = course - np.minimum.accumulate(course)
    fall = np.maximum.accumulate(course) - course
    large = max(rise.max(), fall.max()) / 3
    rises, falls = np.flatnonzero(rise > large), np.flatnonzero(fall > large)
    if not len(rises) and not len(falls):
        return 0.0
    goes_up = len(rises) > 0 and (not len(falls) or rises[0] < falls[0])
    return float(rise.max() if goes_up else -fall.max())


def is_round_wave(course: Array, before: int, slow: float, roundness: float) -> bool | None:
    """True if a pressure goes up and down slowly, without staying up, as a beat of a pulse does.

    Args:
        course: (n,) float64, Pa, n above ``before``.
        before: number of values in which the foot of the wave lies.
        slow: least time from half of the peak to the peak, times two, s.
        roundness: largest ratio of the time above nine tenths of the peak to that time.

    Returns:
        None before the pressure has fallen to half of its peak.
    """
    foot = int(course[:before].argmin())
    wave = course[foot:] - course[foot]
    at = int(wave.argmax())
    up, down = wave[: at + 1][::-1], wave[at:]
    if down.min() > 0.5 * wave[at]:
        return None
    rise = 2 * HOP_SECONDS * _falls_to(0.5, up)
    top = HOP_SECONDS * (_falls_to(0.9, up) + _falls_to(0.9, down))
    return rise >= slow and top <= roundness * rise


def _falls_to(fraction: float, course: Array) -> float:
    """Hops after which a course from its peak first falls to a fraction of it; all of them where it does not."""
    level = fraction * course[0]
    below = np.flatnonzero(course < level)
    if not len(below):
        return float(len(course))
    k = int(below[0])
    return float(k - (level - course[k]) / (course[k - 1] - course[k]))
