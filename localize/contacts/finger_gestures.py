"""Gestures of a tool at one place or from one to another: taps, presses, slides; and the pulse under a finger."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Unpack

import numpy as np

from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array
from localize.contacts.contact import Contact
from localize.contacts.contact_shapes import FINGER, QUIET, Place, Tool, held, still, stroke, times
from localize.contacts.draws import Draws, Stream

TAP_SECONDS = (0.01, 0.1)
"""Shortest and longest tap, s."""
DOUBLE_TAP_SECONDS = (0.12, 0.35)
"""Shortest and longest time from one tap of two to the other, s."""
PRESS_SECONDS = (0.05, 0.2)
"""Shortest and longest time in which a press rises, and falls, s."""
HOLD_SECONDS = (0.4, 1.5)
"""Shortest and longest hold, s."""
HEART_RATES = (30.0, 220.0)
"""Lowest and highest heart rate, beats a minute."""
WAVES = {
    "percussion": ((0.11, 0.14), (1.0, 1.0), (0.040, 0.050)),
    "tidal": ((0.24, 0.29), (0.45, 0.75), (0.050, 0.065)),
    "dicrotic": ((0.42, 0.50), (0.25, 0.45), (0.055, 0.075)),
}
"""Ranges of each wave of a pulse: its time after the foot at 75 beats a minute, s; its height against the first; its
standard deviation, s. The order and rough times are those of the radial pulse (Nichols and O'Rourke, McDonald's
Blood Flow in Arteries); the ranges are ours."""


PULSE_FADE = 0.2
"""Time in which a pulse is faded in, and out, s."""


def tap(place: Place, *, tool: Tool = FINGER, **stream: Unpack[Stream]) -> Contact:
    """A tap of 10 to 100 ms, as sin^2.

    Args:
        place: where, mm.
        tool: with what.
        stream: ``seed``, ``purpose`` and ``sample`` of its random numbers, as of :class:`localize.contacts.Stream`.
    """
    draws = Draws("tap", **stream)
    lasts = draws.log_between(TAP_SECONDS)
    time = times(QUIET[0] + lasts + QUIET[1])
    return held("tap", place, time, _hump(time - QUIET[0], lasts), tool, draws)


def double_tap(place: Place, *, tool: Tool = FINGER, **stream: Unpack[Stream]) -> Contact:
    """Two taps 120 to 350 ms apart, the second of 60 to 140 % of the first; arguments as for :func:`tap`."""
    draws = Draws("double tap", **stream)
    lasts, apart = draws.log_between(TAP_SECONDS), draws.between(DOUBLE_TAP_SECONDS)
    second = draws.between((0.6, 1.4))
    time = times(QUIET[0] + apart + lasts + QUIET[1])
    pressed = _hump(time - QUIET[0], lasts) + second * _hump(time - QUIET[0] - apart, lasts)
    return held("double tap", place, time, pressed, tool, draws)


def press(place: Place, hold: float | None = None, *, tool: Tool = FINGER, **stream: Unpack[Stream]) -> Contact:
    """A press that rises within 50 to 200 ms, is held, and falls.

    Args:
        place: where, mm.
        hold: how long, s, up to 100; by default 0.4 to 1.5 s are drawn.
        tool: with what.
        stream: ``seed``, ``purpose`` and ``sample`` of its random numbers, as of :class:`localize.contacts.Stream`.

    Raises:
        Refusal: a hold out of range.
    """
    draws = Draws("press", **stream)
    rise, fall = draws.log_between(PRESS_SECONDS), draws.log_between(PRESS_SECONDS)
    drawn = draws.between(HOLD_SECONDS)
    hold = drawn if hold is None else check_range("hold", hold, 0.0, 100.0, "s")
    time = times(QUIET[0] + rise + hold + fall + QUIET[1])
    since = time - QUIET[0]
    up, down = np.clip(since / rise, 0, 1), np.clip((rise + hold + fall - since) / fall, 0, 1)
    return held("press", place, time, np.sin(np.pi / 2 * np.minimum(up, down)) ** 2, tool, draws)


def slide(start: Place, end: Place, speed: float, *, tool: Tool = FINGER, **stream: Unpack[Stream]) -> Contact:
    """A straight stroke from one place, mm, to another at a speed, mm/s; further arguments and errors as
    :func:`localize.contacts.stroke`.
    """
    made = stroke([start, end], speed, tool, **stream)
    return Contact(made.time, made.path, made.force, made.contact_radius_mm, made.roughness, "slide")


def pulse_wave(place: Place, rate: float = 75.0, seconds: float = 4.0, **stream: Unpack[Stream]) -> Contact:
    """A finger that rests on the array, through whose skin the pulse comes: percussion, tidal and dicrotic wave.

    The percussion wave adds 20 to 200 uN to the force of the finger, which sways slowly by 2 to 50 uN, rms. The force
    with which it rests changes nothing and is left out; what is left is faded in and out within 0.2 s. Beats differ in
    length by 2 %, rms, and their waves keep to times that go with the root of their length.

    Args:
        place: where, mm.
        rate: beats a minute, 30 to 220.
        seconds: length, 0.5 to 1000 s.
        stream: ``seed``, ``purpose`` and ``sample`` of its random numbers, as of :class:`localize.contacts.Stream`.

    Raises:
        Refusal: a rate or a length out of range.
    """
    heart = _heart(rate, seconds, **stream)
    time, pulse = times(seconds), np.zeros(len(times(seconds)))
    for foot, stretch in heart.beats:
        for later, weight, width in heart.waves.values():
            pulse += weight * np.exp(-0.5 * ((time - foot - later * stretch) / (width * stretch)) ** 2)
    sway = heart.draws.noise(time, (0.1, 0.5))
    fade = np.sin(np.pi / 2 * np.clip(np.minimum(time, time[-1] - time) / PULSE_FADE, 0, 1)) ** 2
    force = fade * (heart.height * pulse + heart.swaying * (sway - sway.min()))
    return Contact(time, still(place, len(time)), force, heart.radius, 0.0, "pulse wave")


def pulse_times(rate: float = 75.0, seconds: float = 4.0, **stream: Unpack[Stream]) -> dict[str, Array]:
    """Times of the waves of :func:`pulse_wave`, at a rate in beats a minute, over a length in seconds; errors as there.

    Returns:
        (n_beat,) float64, s, by the name of the wave; the first beats lie before the contact.
    """
    heart = _heart(rate, seconds, **stream)
    return {
        name: np.array([foot + later * stretch for foot, stretch in heart.beats])
        for name, (later, _, _) in heart.waves.items()
    }


@dataclass(frozen=True)
class _Heart:
    """Random numbers of one pulse."""

    draws: Draws
    swaying: float
    height: float
    radius: float
    waves: dict[str, tuple[float, float, float]]
    """Time after the foot and width at 75 beats a minute, s, and height of each wave."""
    beats: tuple[tuple[float, float], ...]
    """Time of the foot of each beat, s, and by how much its waves are stretched."""


def _heart(rate: float, seconds: float, **stream: Unpack[Stream]) -> _Heart:
    check_range("rate", rate, *HEART_RATES, "beats a minute")
    check_range("seconds", seconds, 0.5, 1000.0, "s")
    draws = Draws("pulse", **stream)
    swaying, height = draws.log_between((2e-6, 50e-6)), draws.log_between((20e-6, 200e-6))
    radius = draws.between(FINGER.contact_radius_mm)
    waves = {}
    for name, limits in WAVES.items():
        later, weight, width = (draws.between(each) for each in limits)
        waves[name] = (later, weight, width)
    beat = 60 / rate
    at = -beat * (1 + draws.between((0.0, 1.0)))
    number = np.arange(math.ceil(seconds / beat) + 4, dtype=np.float64)
    beats = []
    for moved in draws.noise(number * beat, (0.08, 0.3), 6):
        length = beat * (1 + 0.02 * float(moved))
        beats.append((at, math.sqrt(length / 0.8)))
        at += length
    return _Heart(draws, swaying, height, radius, waves, tuple(beats))


def _hump(since: Array, lasts: float) -> Array:
    phase = since / lasts
    return np.where((phase > 0) & (phase < 1), np.sin(np.pi * np.clip(phase, 0, 1)) ** 2, 0.0)
