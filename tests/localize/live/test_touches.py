"""Touches are told while they happen, once each, and as they were."""

from __future__ import annotations

import json
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from rc_line import rc_line

import localize
from localize import Decision, Fault, TouchStream, TouchTracker
from localize.live import AS_IT_COMES
from localize.live.events import HOP

ARRAY = SimpleNamespace(line=np.zeros(6, np.int64), place=np.arange(6))
NOISE = 1e-2


def frames(*runs: tuple[str, int, int, float]) -> list[Decision]:
    """Decisions: so many of a state, with a point and a level."""
    made: list[Decision] = []
    for state, count, point, level in runs:
        for _ in range(count):
            time = 0.25 + 0.016 * len(made)
            if state == "touch":
                probability = np.full(6, 1e-4) + np.eye(6)[point - 1]
                probability /= probability.sum()
                made.append(Decision(time, "touch", level, point, float(probability.max()), probability))
            else:
                made.append(Decision(time, state, level))
    return made


def told(events: list[Decision]) -> list[tuple[str, int, int]]:
    tracker = TouchTracker(ARRAY)
    found = [each for event in events for each in tracker.take(event)] + tracker.finish()
    return [(each.kind, each.touch, each.point) for each in found]


def test_a_touch_is_told_as_it_comes_down_moves_and_goes_up() -> None:
    events = frames(("no touch", 5, 0, 0.0), ("touch", 20, 2, 1.0), ("touch", 20, 3, 1.0), ("no touch", 10, 0, 0.0))
    assert told(events) == [("down", 1, 2), ("moved", 1, 3), ("up", 1, 3)]
    assert [touch.point for touch in localize.touches_of(events, ARRAY)] == [2, 3]


def test_the_latency_is_the_time_from_the_first_frame_that_showed_it() -> None:
    tracker = TouchTracker(ARRAY, 0.002)
    events = frames(("no touch", 5, 0, 0.0), ("touch", 20, 2, 1.0), ("no touch", 10, 0, 0.0))
    found = {each.kind: each for event in events for each in tracker.take(event)}
    began, ended = events[5].time, events[24].time
    assert found["down"].latency == pytest.approx(found["down"].time - began + HOP / 1000 + 0.002)
    assert found["down"].latency < 0.06
    assert found["up"].latency == pytest.approx(found["up"].time - ended + HOP / 1000 + 0.002)
    line = json.loads(found["down"].json_line())
    assert line["event"] == "down"
    assert line["probability"] == round(found["down"].probability, 4)
    assert set(line) == {"time", "event", "touch", "point", "probability", "level", "latency"}


@pytest.mark.parametrize("count", [6, 8, 12, 40])
def test_what_is_stated_afterwards_is_as_sure_as_what_was_stated_meanwhile(count: int) -> None:
    likely = np.array([0.01, 1e-12, 1e-12, 0.99, 1e-12, 1e-12])
    events = [
        replace(event, distribution=likely, probability=0.99) if event.state == "touch" else event
        for event in frames(("touch", count, 4, 1.0), ("no touch", 10, 0, 0.0))
    ]
    tracker = TouchTracker(ARRAY)
    up = [each for event in events for each in tracker.take(event)][-1]
    (touch,) = localize.touches_of(events, ARRAY)
    assert (up.kind, up.point, touch.point) == ("up", 4, 4)
    assert touch.probability == pytest.approx(up.probability, abs=1e-9)
    assert touch.probability >= 0.99 - 1e-6


def test_what_is_stated_of_a_point_is_as_sure_as_the_frames_are() -> None:
    # Three frames that give the point 0.8 are one frame: they share most of their samples.
    likely = np.array([0.2, 1e-12, 1e-12, 0.8, 1e-12, 1e-12])
    unsure = [
        replace(event, distribution=likely, probability=0.8)
        for event in frames(("touch", 3, 4, 1.0), ("no touch", 10, 0, 0.0))
        if event.state == "touch"
    ]
    tracker = TouchTracker(ARRAY)
    (down,) = [each for event in unsure for each in tracker.take(event)]
    assert (down.kind, down.point) == ("down", 4)
    assert down.probability == pytest.approx(0.8, abs=1e-6)
    # The sound of an end says little beside the loudest frame.
    fading = replace(unsure[-1], time=unsure[-1].time + HOP / 1000, level=0.05, distribution=np.roll(likely, 2))
    assert tracker.take(fading) == []
    (up,) = tracker.finish()
    assert up.probability == pytest.approx(0.8, abs=0.02)


def test_a_level_that_rises_again_is_a_new_touch_and_a_small_swell_is_none() -> None:
    beats = [("touch", 12, 4, 1.0), ("touch", 6, 4, 0.3), ("touch", 12, 4, 1.0), ("touch", 6, 4, 0.3)]
    assert told(frames(*beats)) == [("down", 1, 4), ("up", 1, 4), ("down", 2, 4), ("up", 2, 4)]
    assert len(localize.touches_of(frames(*beats), ARRAY)) == 2
    swell = [("touch", 12, 4, 1.0), ("touch", 6, 4, 0.6), ("touch", 12, 4, 1.0)]
    assert told(frames(*swell)) == [("down", 1, 4), ("up", 1, 4)]


def test_frames_in_which_a_touch_only_begins_are_waited_for() -> None:
    wandering = [("touch", 1, 6, 0.1), ("touch", 1, 1, 0.3), ("touch", 20, 3, 1.0), ("no touch", 10, 0, 0.0)]
    assert told(frames(*wandering)) == [("down", 1, 3), ("up", 1, 3)]


def test_frames_that_name_two_points_in_turn_are_waited_for_until_one_is_likely() -> None:
    def unsure(count: int) -> list[Decision]:
        even = np.array([0.02, 0.47, 0.02, 0.45, 0.02, 0.02])
        turns = [even, even[[0, 3, 2, 1, 4, 5]]]
        return [
            Decision(0.25 + 0.016 * k, "touch", 1.0, int(turns[k % 2].argmax()) + 1, 0.47, turns[k % 2])
            for k in range(count)
        ]

    assert told(unsure(12)) == []
    sure = [replace(each, time=0.25 + 0.016 * (12 + k)) for k, each in enumerate(frames(("touch", 20, 4, 1.0)))]
    assert told([*unsure(12), *sure]) == [("down", 1, 4), ("up", 1, 4)]


def test_a_contact_of_a_frame_that_says_nothing_is_none() -> None:
    unsure = Decision(0.266, "touch", 0.1, 1, 0.2, np.array([0.2, 0.2, 0.15, 0.15, 0.15, 0.15]))
    assert told([unsure, *frames(("no touch", 20, 0, 0.0))[2:]]) == []


def test_faults_mean_nothing_to_a_tracker() -> None:
    tracker = TouchTracker(ARRAY)
    assert tracker.take(Fault(1.0, "samples lost", samples=3)) == []
    assert tracker.finish() == []


def tapping(pause: int) -> tuple[np.ndarray, list[int]]:
    """Two pulses of 40 ms on an array, the second a third as loud."""
    array = rc_line(6)
    period, begins = 8000, (1500, 1540 + pause)
    frequency = np.arange(1, period // 2 + 1) * 1000 / period
    spectrum = np.zeros((2, period // 2 + 1), np.complex128)
    within = frequency <= array.frequency[-1]
    for begin, point, peak in zip(begins, (1, 4), (6.0, 2.0), strict=True):
        pressure = np.zeros(period)
        pressure[begin : begin + 40] = peak * np.sin(np.pi * np.arange(40) / 40) ** 2
        lines = np.fft.rfft(pressure)[1:]
        spectrum[:, 1:][:, within] += lines[within] * array.at(frequency[within])[point]
    return np.fft.irfft(spectrum, period) + 1e-3 * np.random.default_rng(2).standard_normal((2, period)), [2, 5]


def test_the_next_touch_is_found_half_a_second_later_and_few_frames_name_a_wrong_point() -> None:
    samples, points = tapping(500)
    decoder = localize.BayesDecoder(rc_line(6), 1e-3)
    events = TouchStream(decoder).push(samples)
    assert [touch.point for touch in localize.touches_of(events, decoder)] == points
    assert "fading" in {event.state for event in events}
    wrong = [e for e in events if e.state == "touch" and e.point != points[e.time > 2.04]]
    assert len(wrong) <= 4
    before = TouchStream(decoder, options=AS_IT_COMES).push(samples)
    assert "fading" not in {event.state for event in before}


@pytest.mark.parametrize("kind", ["noise", "hum"])
def test_noise_and_hum_that_nobody_told_of_are_no_touches(kind) -> None:
    decoder = localize.BayesDecoder(rc_line(6), 7e-4)
    random, time = np.random.default_rng(3), np.arange(6000) / 1000
    samples = 7e-4 * random.standard_normal((2, 6000))
    if kind == "noise":
        samples += 3e-3 * random.standard_normal((2, 6000))
    else:
        samples += 2.8e-3 * np.sin(2 * np.pi * 50.03 * time + np.array([[0.3], [2.0]]))
    assert {event.state for event in TouchStream(decoder).push(samples)} == {"no touch"}
    assert "touch" in {event.state for event in TouchStream(decoder, options=AS_IT_COMES).push(samples)}
