"""Motion of the sensor and touches are recognised, each alone and together, in batches and in a stream."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refusals import refused
from shared import solved

import acoustic_fem
import geometry
import localize
from geometry import Kind
from localize import Decision, HandMotion, MotionTest, TouchStream
from localize.contacts import Contact, ContactRecorder
from localize.contacts.contact import surface_of
from localize.decoders.frame_covariance import SAMPLES
from localize.live.front_end import HighPass
from localize.signals import motion_signals
from localize.signals.array_response import response_of
from studies.test_rig import waved_hand
from studies.test_rig.rig_motion import motion_of_rig
from studies.test_rig.virtual_rig import Rig

GRID = np.concatenate([[0.5], np.arange(1.0, 201.0)])
NOISE, LARGEST = 1e-3, 5.0


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return solved("array-2x6", GRID)


@pytest.fixture(scope="module")
def motion(library: acoustic_fem.Library) -> HandMotion:
    return HandMotion.of(library, LARGEST)


@pytest.fixture(scope="module")
def motion_test(library: acoustic_fem.Library, motion: HandMotion) -> MotionTest:
    return MotionTest(library, motion, NOISE)


def waved(seconds: float = 8.0, seed: int = 1) -> np.ndarray:
    return waved_hand(seconds, np.random.default_rng(seed), LARGEST)


def noisy(pressures: np.ndarray, seed: int = 2) -> np.ndarray:
    return pressures + NOISE * np.random.default_rng(seed).standard_normal(pressures.shape)


def frames_of(signals: np.ndarray) -> np.ndarray:
    passed = HighPass(len(signals), 3.0).begin(signals)
    count = passed.shape[1] // 250
    return np.stack(np.split(passed[:, : 250 * count], count, axis=1))


def test_motion_alone_leaves_no_more_than_noise(library: acoustic_fem.Library, motion_test: MotionTest) -> None:
    frames = frames_of(noisy(motion_signals(library, waved(60.0))))
    p_value = motion_test.p_value(frames)
    assert p_value.mean() == pytest.approx(0.5, abs=0.06)
    assert motion_test.is_motion(frames).all()
    assert not localize.SoundTest(library, NOISE).is_sound(frames).all()


@pytest.mark.parametrize("seed", [9700, 9701])
def test_an_as_built_sensor_that_is_waved_is_moved_too(motion_test: MotionTest, seed: int) -> None:
    frames = frames_of(noisy(motion_of_rig(Rig("array-2x6", seed, fidelity="lumped"), waved(20.0))))
    assert motion_test.is_motion(frames).mean() > 0.95


def test_touches_are_no_motion(library: acoustic_fem.Library, motion_test: MotionTest) -> None:
    made = localize.TouchGenerator(response_of(library), 0, "evaluation", NOISE).samples(0, 240)
    assert (~motion_test.is_motion(made.signals.double().numpy()[..., -250:])).mean() >= 0.99


def test_what_is_louder_than_the_largest_acceleration_is_no_motion(
    library: acoustic_fem.Library, motion_test: MotionTest
) -> None:
    loud = frames_of(noisy(3 * motion_signals(library, waved())))
    assert motion_test.explains(loud).all()
    loudest = np.abs(loud).max((1, 2)).argmax()
    assert not motion_test.is_motion(loud[[loudest]]).any()


def test_a_stream_of_a_waved_sensor_reports_no_touch_and_one_that_comes_down_in_it(
    library: acoustic_fem.Library, motion_test: MotionTest
) -> None:
    moving = noisy(motion_signals(library, waved()))
    decoder = localize.BayesDecoder(library, NOISE)
    as_before = localize.touches_of(TouchStream(decoder).push(moving), decoder)
    assert as_before  # the motion is taken for touches
    events = TouchStream(decoder, motion_test=motion_test).push(moving)
    assert localize.touches_of(events, decoder) == []
    assert {event.state for event in events if isinstance(event, Decision)} >= {"motion"}

    points, time = (2, 9, 5, 12, 1, 7), np.arange(8000) / 1000
    begin, rising = 1.0 + 1.1 * np.arange(6), np.zeros((6, 8000))
    for each, at in zip(rising, begin, strict=True):
        each[:] = np.sin(np.pi * np.clip((time - at) / 0.05, 0, 1)) ** 2
    place, radius = surface_of(response_of(library))
    path = place[np.array(points) - 1][np.clip(np.searchsorted(begin - 0.3, time) - 1, 0, 5)]
    contact = Contact(time, path, 1e-3 * rising.sum(0), float(radius.min()) / 4)
    pressed = ContactRecorder(library, microphone_noise=0.0, linear=True).take(contact).signals
    touched = moving + pressed[:, : moving.shape[1]]
    found = localize.touches_of(TouchStream(decoder, motion_test=motion_test).push(touched), decoder)
    near = [[each.point for each in found if -0.05 <= each.start - at <= 0.2] for at in begin]
    assert [each[0] for each in near] == list(points)


def test_fewer_microphones_have_a_test_of_their_own() -> None:
    library = solved("fingertip-3x4", np.arange(1.0, 201.0, 2.0))
    motion = HandMotion.of(library, LARGEST)
    names = tuple(library.design.microphones)
    some = MotionTest(library, motion, NOISE).heard_by(names[:2])
    assert some.microphones == names[:2]
    assert some.motion.response.shape[0] == 2


def test_a_sensor_that_moves_in_as_many_directions_as_it_has_microphones_is_refused(
    library: acoustic_fem.Library, motion: HandMotion
) -> None:
    along = motion.response.copy()
    along[:, 0] = along[:, 2] * np.array([[1.0], [-1.0]])
    with refused(Kind.UNSUITABLE, "motion", LARGEST):
        MotionTest(library, replace(motion, response=along), NOISE)


def test_the_membranes_of_a_wristband_move_its_two_microphones_as_one() -> None:
    design = geometry.load_design(Path(__file__).parents[3] / "docs" / "examples" / "wristband-16.toml")
    library = acoustic_fem.solve(design, np.arange(1.0, 201.0, 4.0), "lumped")
    test = MotionTest(library, HandMotion.of(library, LARGEST), NOISE)
    assert test.freedom >= 0.45 * len(library.design.microphones) * SAMPLES


def test_bad_arguments_are_refused(library: acoustic_fem.Library) -> None:
    with refused(Kind.OUT_OF_RANGE, "motion", 0.0):
        HandMotion.of(library, 0.0)
    with refused(Kind.OUT_OF_RANGE, "motion", -1.0):
        localize.open_model(library, motion=-1.0)
    with refused(Kind.MISMATCH, "motion_test"):
        other = solved("line-2", GRID)
        TouchStream(localize.BayesDecoder(library, NOISE), motion_test=_test_of(other))


def _test_of(library: acoustic_fem.Library) -> MotionTest:
    renamed = response_of(library).heard_by(tuple(library.design.microphones)[::-1])
    return MotionTest(renamed, HandMotion.of(library, LARGEST), NOISE)
