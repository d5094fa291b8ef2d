"""Gestures of a tool at one place or from one to another: taps, presses, slides."""

from __future__ import annotations

from typing import Unpack

import numpy as np

from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array
from localize.contacts.contact import Contact
from localize.contacts.contact_shapes import FINGER, QUIET, Place, Tool, held, stroke, times
from localize.contacts.draws import Draws, Stream

TAP_SECONDS = (0.01, 0.1)
"""Shortest and longest tap, s."""
DOUBLE_TAP_SECONDS = (0.12, 0.35)
"""Shortest and longest time from one tap of two to the other, s."""
PRESS_SECONDS = (0.05, 0.2)
"""Shortest and longest time in which a press rises, and falls, s."""
HOLD_SECONDS = (0.4, 1.5)
"""Shortest and longest hold, s."""


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


def _hump(since: Array, lasts: float) -> Array:
    phase = since / lasts
    return np.where((phase > 0) & (phase < 1), np.sin(np.pi * np.clip(phase, 0, 1)) ** 2, 0.0)
