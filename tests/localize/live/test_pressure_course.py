"""The course of the mean pressure distinguishes rises from falls, and beats from taps and presses."""

from __future__ import annotations

import numpy as np
import pytest

from localize import Decision
from localize.live.pressure_course import HOP_SECONDS, PressureCourse, Wave, first_stroke, is_round_wave

QUIET = np.zeros(15)


def stroke(seconds: float, held: float = 0.0) -> np.ndarray:
    """A pulse sin^2 between rests, held at its peak; every 16 ms."""
    time = np.arange(0.0, seconds + held + 0.3, HOP_SECONDS)
    pressed = np.clip(np.minimum(time, seconds + held - time) / (seconds / 2), 0.0, 1.0)
    return np.concatenate([QUIET, np.sin(0.5 * np.pi * pressed) ** 2])


def test_the_first_stroke_is_the_first_large_change() -> None:
    assert first_stroke(stroke(0.1)) == pytest.approx(1.0, abs=0.05)
    assert first_stroke(-stroke(0.1)) == pytest.approx(-1.0, abs=0.05)
    pressed = stroke(0.2, held=1.0)
    assert first_stroke(pressed[:40]) == pytest.approx(1.0, abs=0.01)
    assert first_stroke(pressed[40:]) == pytest.approx(-1.0, abs=0.01)
    assert first_stroke(np.concatenate([QUIET, [-0.2, -0.1], stroke(0.2)])) == pytest.approx(1.2, abs=0.02)
    assert first_stroke(np.concatenate([QUIET, [0.55, 0.59, -0.64, -0.3]])) == pytest.approx(0.59)
    assert first_stroke(QUIET) == 0.0


@pytest.mark.parametrize(("seconds", "held", "is_round"), [
    (0.03, 0.0, False), (0.1, 0.0, False), (0.2, 0.0, True), (0.4, 0.0, True), (0.2, 0.2, False), (0.2, 1.0, False),
])  # fmt: skip
def test_a_slow_wave_without_a_hold_is_round(seconds: float, held: float, is_round: bool) -> None:
    course = stroke(seconds, held)
    assert is_round_wave(course, 15, 0.064, 0.65) is is_round
    at_peak = course[: int(course.argmax()) + 1]
    assert is_round_wave(at_peak, 15, 0.064, 0.65) is None


def test_a_wave_is_held_until_the_pressure_has_once_fallen_and_grows_in_contacts_only() -> None:
    wave = Wave(QUIET, 15, 0.3)
    for pressure in stroke(0.2, held=0.5)[15:45]:
        wave.take(float(pressure), True)
    assert (wave.peak, wave.fallen, wave.rests) == (pytest.approx(1.0), 0, 0)
    wave.take(0.2, False)
    assert (wave.fallen, wave.rests) == (1, 0)
    wave.take(0.05, False)
    assert (wave.fallen, wave.rests) == (2, 1)
    wave.take(3.0, False)  # a slow drift is not a press
    assert (wave.peak, wave.fallen) == (pytest.approx(1.0), 3)
    assert Wave(np.empty(0), 15, 0.3).peak == 0.0


def test_a_short_tap_is_not_held_though_the_pressure_falls_below_its_foot_behind_it() -> None:
    wave = Wave(np.concatenate([QUIET, [1.0, -0.1, -0.05]]), 15, 0.3)
    wave.take(-0.01, True)
    assert (wave.peak, wave.fallen) == (1.0, 3)


def test_a_course_begins_anew_after_a_gap_and_after_a_frame_that_is_unreadable() -> None:
    course = PressureCourse(1.0)
    for hop in range(100):
        course.take(Decision(0.016 * hop, "no touch", 0.0, mean_pressure=float(hop)))
    assert course.last(3).tolist() == [97.0, 98.0, 99.0]
    assert course.newest == 99.0
    assert not len(course.last(63))  # a second is 62 decisions
    course.take(Decision(1.7, "no touch", 0.0, mean_pressure=5.0))
    assert course.last(1).tolist() == [5.0]
    assert not len(course.last(2))
    course.take(Decision(1.716, "unreadable", 0.0))
    assert course.newest is None
