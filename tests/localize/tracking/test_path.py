"""Paths over the surface: from signals, and gestures from paths."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
import localize
from geometry import Kind
from localize.contacts import Contact, record
from localize.live.events import Decision, TrackedGesture
from localize.signals import response_of
from localize.signals.array_response import ArrayResponse
from localize.tracking.footprints import footprints_over
from localize.tracking.path import PathTracker, Track
from localize.tracking.path_gestures import GestureTracker
from localize.tracking.smoothing import HOP_TIME, Cells, smoothed


@cache
def array() -> ArrayResponse:
    """Two rows of three points, 18 mm apart, between two microphones."""
    design = geometry.prototype("array-2x6").with_values(
        {"lines.0.points": 6, "layout.kind": "serpentine", "layout.columns": 3, "layout.pitch": 18.0}
    )
    return response_of(acoustic_fem.solve(design, np.arange(1.0, 501.0, 1.0), "lumped"))


def moved(corners: np.ndarray, speed: float, ambient: float | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Signals of a finger that goes along corners, silence around it, (2, n) Pa, and its path."""
    lengths = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    at = np.concatenate([[0.0], np.cumsum(lengths)]) / speed
    time = np.arange(round(1e3 * (at[-1] + 2.0))) / 1e3
    path = np.column_stack([np.interp(time - 0.5, at, along) for along in corners.T])
    pressed = (time >= 0.5) & (time <= 0.5 + at[-1])
    contact = Contact(time, path, 5e-3 * pressed, 5.0, 0.2)
    return record(contact, array(), microphone_noise=1e-3, ambient=ambient).signals, path


def track(signals: np.ndarray) -> list[Track]:
    return localize.track(array(), signals, microphone_noise=1e-3)


def test_a_slide_along_a_row_is_followed_between_its_points_too() -> None:
    assert array().position is not None
    row = array().position[:3]
    signals, path = moved(row[[0, 2]], 60.0)
    (found,) = track(signals)
    true = path[np.round(1e3 * found.time).astype(int)]
    error = np.linalg.norm(found.place - true, axis=1)
    assert (error < found.pitch / 2).mean() > 0.95
    assert (error < 4 * found.deviation).mean() > 0.9
    assert found.speed[5:-5].mean() == pytest.approx(60.0, rel=0.3)
    gesture = localize.gesture_of(found)
    assert (gesture.kind, gesture.direction) == ("swipe", "right" if row[2, 0] > row[0, 0] else "left")


def test_a_path_is_the_same_however_the_stream_is_cut() -> None:
    assert array().position is not None
    signals, _ = moved(array().position[:2], 60.0)
    tracker = PathTracker(array(), microphone_noise=1e-3)
    decoder = localize.BayesDecoder(array(), microphone_noise=1e-3)
    stream = localize.TouchStream(decoder, options=localize.StreamOptions(frames=True))
    told = []
    for first in range(0, signals.shape[1], 37):
        for event in stream.push(signals[:, first : first + 37]):
            told += tracker.take(event)
    tracker.finish()
    (whole,), (pieces,) = track(signals), tracker.tracks
    assert np.array_equal(whole.place, pieces.place)
    # What is told at once is close to what is known afterwards.
    true = np.array([[np.interp(each.time, whole.time, along) for along in whole.place.T] for each in told])
    off = np.linalg.norm(np.array([each.place for each in told]) - true, axis=1)
    assert np.median(off) < whole.pitch
    assert {"time", "x", "y", "deviation", "latency"} <= set(json.loads(told[0].json_line()))


def test_a_gesture_is_told_once_its_path_has_ended_and_at_the_end_of_the_stream() -> None:
    assert array().position is not None
    row = array().position[:3]
    signals, _ = moved(row[[0, 2]], 60.0)
    noise = 1e-3 * np.random.default_rng(2).standard_normal((2, 1500))
    decoder = localize.BayesDecoder(array(), microphone_noise=1e-3)
    for heard, at_the_end in ((np.concatenate([signals, noise], axis=1), False), (signals[:, :1400], True)):
        tracker = GestureTracker(PathTracker(array(), microphone_noise=1e-3))
        stream = localize.TouchStream(decoder, options=localize.StreamOptions(frames=True))
        during = [told for event in stream.push(heard) for told in tracker.take(event)]
        after = tracker.finish()
        (gesture,) = [each for each in (*during, *after) if isinstance(each, TrackedGesture)]
        assert (gesture in after) is at_the_end
        assert gesture.kind == "swipe"
        assert gesture.end < gesture.time <= heard.shape[1] / 1e3
        assert json.loads(gesture.json_line())["direction"] == gesture.direction != ""
        assert not tracker.finish()


def test_silence_has_no_path() -> None:
    noise = 1e-3 * np.random.default_rng(0).standard_normal((2, 3000))
    assert track(noise) == []


def test_frames_are_kept_only_where_they_are_asked_for() -> None:
    assert array().position is not None
    signals, _ = moved(array().position[:2], 60.0)
    decoder = localize.BayesDecoder(array(), microphone_noise=1e-3)
    plain = [each for each in localize.TouchStream(decoder).push(signals) if isinstance(each, Decision)]
    kept = localize.TouchStream(decoder, options=localize.StreamOptions(frames=True)).push(signals)
    assert all(each.frame is None for each in plain)
    frames = [each.frame for each in kept if isinstance(each, Decision) and each.state == "touch"]
    assert frames
    assert all(frame is not None and frame.shape == (2, 250) for frame in frames)
    assert plain == kept


@pytest.mark.parametrize("option", [{"contact_radius_mm": 0.0}, {"ambient": 200.0}])
def test_options_out_of_range_are_refused(option: dict[str, float]) -> None:
    with refused(Kind.OUT_OF_RANGE):
        PathTracker(array(), **option)


def test_a_smooth_path_goes_on_where_nothing_is_known() -> None:
    time = np.arange(60) * HOP_TIME
    true = np.column_stack([50 * time, 20 * np.sin(3 * time)])
    sure = np.where((np.arange(60) > 20) & (np.arange(60) < 30), np.inf, 1.0)
    place, deviation, speed = smoothed(true, sure)
    assert np.linalg.norm(place - true, axis=1).max() < 2.0
    assert deviation[25] > deviation[10]
    assert speed[30] == pytest.approx(np.linalg.norm(np.gradient(true, HOP_TIME, axis=0)[30]), rel=0.2)


def test_steps_over_the_surface_are_likelier_the_nearer() -> None:
    cells = Cells.of(footprints_over(array(), 5.0, 100), 18.0)
    assert np.allclose(cells.transition.sum(1), 1)
    apart = np.linalg.norm(cells.middle - cells.middle[0], axis=1)
    order = np.argsort(apart)
    assert (np.diff(cells.transition[0, order]) <= 1e-12).all()


def path_of(place: np.ndarray, force: np.ndarray | None = None) -> Track:
    count = len(place)
    heard = np.ones(count, bool)
    return Track(
        HOP_TIME * np.arange(count), place, np.ones(count), np.ones(count), np.ones(count) if force is None else force,
        heard, 18.0,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("end", "direction"), [((60, 5), "right"), ((3, 60), "up"), ((-60, 8), "left"), ((0, -60), "down")]
)
def test_swipes_have_a_direction(end: tuple[float, float], direction: str) -> None:
    gesture = localize.gesture_of(path_of(np.linspace((0.0, 0.0), end, 40)))
    assert (gesture.kind, gesture.direction) == ("swipe", direction)
    assert gesture.length == pytest.approx(np.hypot(*end))


def test_circles_turn_one_way_or_the_other() -> None:
    angle = np.linspace(0, 2 * np.pi, 80)
    circle = 40 * np.column_stack([np.cos(angle), np.sin(angle)])
    for place, way in ((circle, "anticlockwise"), (circle[::-1], "clockwise")):
        gesture = localize.gesture_of(path_of(place))
        assert (gesture.kind, gesture.direction) == ("circle", way)
    assert localize.gesture_of(path_of(circle[:40])).kind == "stroke"


def test_what_stays_is_a_tap_a_double_tap_or_a_hold() -> None:
    tap = np.array([0.2, 1.0, 0.4, -0.6, -0.1])
    quiet = np.full(12, np.nan)
    forces = {
        "tap": tap,
        "double tap": np.concatenate([tap, quiet, 0.8 * tap]),
        "hold": np.concatenate([[0.3, 1.0, 0.5], np.full(60, np.nan), [-0.4, -1.0, -0.2]]),
    }
    for kind, force in forces.items():
        assert localize.gesture_of(path_of(np.zeros((len(force), 2)), force)).kind == kind
