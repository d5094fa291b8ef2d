"""A press, a pulse and what trembles meanwhile are one touch each; two taps of one point are two."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rc_line import rc_line

import localize
from localize import Decision, TouchOptions, TouchStream, TouchTracker
from localize.live.events import HOP
from localize.live.joined_contacts import TouchJoiner

POINTS, PERIOD, NOISE = 6, 8000, 1e-3
ARRAY = rc_line(POINTS)
DECODER = localize.BayesDecoder(ARRAY, NOISE)


def heard(*touches: tuple[int, int, np.ndarray]) -> np.ndarray:
    """(2, PERIOD) Pa of pressures in cavities, each from a sample on, of a point from 1."""
    frequency = np.arange(PERIOD // 2 + 1) * 1000 / PERIOD
    spectrum = np.zeros((2, len(frequency)), np.complex128)
    within = frequency <= ARRAY.frequency[-1]
    response = ARRAY.at(np.maximum(frequency[within], ARRAY.frequency[0]))
    for begin, point, pressure in touches:
        whole = np.zeros(PERIOD)
        whole[begin : begin + len(pressure)] = pressure
        spectrum[:, within] += np.fft.rfft(whole)[within] * response[point - 1]
    return np.fft.irfft(spectrum, PERIOD) + NOISE * np.random.default_rng(2).standard_normal((2, PERIOD))


def pressed(length: int, flank: int, peak: float = 2.0) -> np.ndarray:
    since = np.arange(length)
    return peak * np.sin(0.5 * np.pi * np.clip(np.minimum(since, length - since) / flank, 0.0, 1.0)) ** 2


def pulse(beats: int, period: int, peak: float = 0.5) -> np.ndarray:
    since = np.arange(beats * period) / period
    wave = sum(
        high * np.exp(-0.5 * ((since - beat - at) / wide) ** 2)
        for beat in range(beats)
        for high, at, wide in ((1.0, 0.3, 0.075), (0.4, 0.6, 0.12))
    )
    return peak * np.asarray(wave)


def told(
    signals: np.ndarray, options: TouchOptions | None = None
) -> tuple[list[tuple[str, int, int]], list[localize.Touch]]:
    """Kind, touch and point of each event, and the touches as they are known afterwards."""
    options = options or TouchOptions()
    events = TouchStream(DECODER).push(signals)
    tracker = TouchTracker(ARRAY, options=options)
    found = [each for event in events for each in tracker.take(event)] + tracker.finish()
    return [(each.kind, each.touch, each.point) for each in found], localize.touches_of(events, ARRAY, options)


@pytest.mark.parametrize(("length", "flank"), [(500, 30), (1000, 30), (1000, 150), (3000, 60)])
def test_a_press_is_one_touch_from_its_beginning_to_its_release(length: int, flank: int) -> None:
    events, (touch,) = told(heard((1500, 4, pressed(length, flank))))
    assert events == [("down", 1, 4), ("up", 1, 4)]
    assert touch.point == 4
    assert 1.5 < touch.start < 1.7
    assert 1.5 + length / 1000 < touch.end < 1.5 + length / 1000 + 0.6
    assert touch.beats == ()


def test_a_release_later_than_the_longest_hold_is_a_touch_of_its_own() -> None:
    signals = heard((1500, 4, pressed(2500, 30)))
    events, touches = told(signals, TouchOptions(longest_hold=1.5))
    assert events == [("down", 1, 4), ("up", 1, 4), ("down", 2, 4), ("up", 2, 4)]
    assert len(touches) == 2
    assert touches[0].end == pytest.approx(3.0, abs=0.2)


def test_a_hand_that_trembles_while_it_presses_is_one_touch() -> None:
    press = pressed(2500, 100, peak=5.0)
    trembling = press * (1 + 0.05 * np.sin(2 * np.pi * 9 * np.arange(2500) / 1000))
    events, touches = told(heard((1500, 2, trembling)))
    assert events == [("down", 1, 2), ("up", 1, 2)]
    assert len(touches) == 1


def test_two_quick_taps_of_one_point_are_two_touches_and_so_is_a_tap_after_a_press() -> None:
    for pause in (500, 1000):
        tap = pressed(60, 30)
        events, touches = told(heard((1500, 3, tap), (1500 + pause, 3, tap)))
        assert events == [("down", 1, 3), ("up", 1, 3), ("down", 2, 3), ("up", 2, 3)]
        assert [touch.point for touch in touches] == [3, 3]
    events, touches = told(heard((1500, 3, pressed(800, 40)), (2800, 5, pressed(60, 30))))
    assert events == [("down", 1, 3), ("up", 1, 3), ("down", 2, 5), ("up", 2, 5)]
    assert [touch.point for touch in touches] == [3, 5]


def test_two_presses_of_one_point_with_a_rest_between_them_are_two_touches() -> None:
    events, _ = told(heard((1500, 3, pressed(300, 150)), (2500, 3, pressed(300, 150))))
    assert events == [("down", 1, 3), ("up", 1, 3), ("down", 2, 3), ("up", 2, 3)]


@pytest.mark.parametrize("period", [650, 900])
def test_a_pulse_is_one_touch_with_its_beats(period: int) -> None:
    events, touches = told(heard((1500, 3, pulse(4, period))))
    assert events == [("down", 1, 3), *[("beat", 1, 3)] * 3, ("up", 1, 3)]
    (touch,) = touches
    assert touch.point == 3
    assert np.diff(touch.beats) == pytest.approx([period / 1000] * 3, abs=0.1)


def test_pressures_and_events_are_the_same_for_chunks_of_any_size() -> None:
    signals = heard((1500, 3, pressed(800, 40)), (3000, 4, pulse(4, 650)))
    whole = TouchStream(DECODER).push(signals)
    stream, parts = TouchStream(DECODER), []
    for chunk in np.array_split(signals, 333, axis=1):
        parts += stream.push(chunk)
    assert whole == parts
    decisions = [[each for each in events if isinstance(each, Decision)] for events in (whole, parts)]
    pressures = [(event.mean_pressure, part.mean_pressure) for event, part in zip(*decisions, strict=True)]
    assert all(one == pytest.approx(other, rel=1e-12) for one, other in pressures)
    assert sum(one is not None for one, _ in pressures) > 400


def frames(*runs: tuple[str, int, int, float, float]) -> list[Decision]:
    """Decisions: so many of a state, with a point, a level and a pressure."""
    made: list[Decision] = []
    for state, count, point, level, pressure in runs:
        for _ in range(count):
            time = 0.25 + HOP / 1000 * len(made)
            each = Decision(time, "fading" if state == "fading" else "no touch", level, mean_pressure=pressure)
            if state == "touch":
                found = (np.full(POINTS, 1e-4) + np.eye(POINTS)[point - 1]) / (1 + POINTS * 1e-4)
                each = replace(each, state="touch", point=point, probability=float(found.max()), distribution=found)
            made.append(each)
    return made


TAP = (("quiet", 20, 0, 0.0, 0.0), ("touch", 2, 3, 1.0, 4.0), ("touch", 10, 3, 1.0, 0.0), ("fading", 10, 0, 0.1, 0.0))


def kinds(*runs: tuple[str, int, int, float, float]) -> list[str]:
    joiner = TouchJoiner()
    steps = [step for event in frames(*runs) for step in joiner.take(event)] + joiner.finish()
    return [step.kind for step in steps if step.kind in ("begins", "ends", "beat")]


def test_what_is_left_of_a_strong_touch_is_none_but_a_weak_touch_is() -> None:
    assert kinds(*TAP, ("touch", 10, 4, 0.05, 0.0)) == ["begins", "ends"]
    assert kinds(*TAP, ("quiet", 1, 0, 0.0, 0.0), ("touch", 10, 4, 0.05, 0.0)) == ["begins", "ends"] * 2
    assert kinds(*TAP, ("touch", 2, 4, 0.05, 0.2), ("touch", 8, 4, 0.05, 0.0)) == ["begins", "ends"] * 2
    assert kinds(*TAP, ("touch", 10, 4, 0.5, 0.0)) == ["begins", "ends"] * 2


def test_a_fall_at_another_point_long_after_a_tap_is_a_touch() -> None:
    assert kinds(*TAP, ("touch", 10, 3, 1.0, -4.0)) == ["begins", "ends"]
    late = (*TAP, ("quiet", 20, 0, 0.0, 0.0))
    assert kinds(*late, ("touch", 10, 5, 1.0, -4.0)) == ["begins", "ends"] * 2


def test_a_device_that_counts_anew_ends_the_touch() -> None:
    joiner = TouchJoiner()
    for event in frames(*TAP[:2]):
        joiner.take(event)
    steps = joiner.take(Decision(0.0, "no touch", 0.0, mean_pressure=0.0))
    assert [step.kind for step in steps] == ["ends"]
