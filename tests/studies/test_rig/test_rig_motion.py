"""A virtual rig that is moved: its motion, what its microphones record of it, and its files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from refusals import refused
from small_run import small_design

import acoustic_fem
import localize
from geometry import Kind
from localize.recordings.accelerometer import COLUMNS
from localize.signals import motion_signals
from studies.test_rig import HiddenScatter, Recorder, Rig, TouchSession, record_motion, table_knocks, waved_hand
from studies.test_rig.rig_motion import made_acceleration_response, motion_of_rig
from studies.test_rig.rig_touches import record_touches

STILL = "volume membrane batch length loss temperature pressure slope bore gain corner chamber"
EXACT = HiddenScatter(**dict.fromkeys(STILL.split(), 0.0))


def test_a_sensor_without_deviations_answers_to_acceleration_as_its_library_does() -> None:
    rig = Rig(small_design(), 1, EXACT, fidelity="lumped")
    found, grid = made_acceleration_response(rig)
    expected = acoustic_fem.solve(rig.design, grid, "lumped").acceleration_response.values
    assert found.shape == (2, 3, len(grid))
    np.testing.assert_allclose(found[:, 2], expected[:, 2], rtol=1e-6)


def test_an_as_built_sensor_deviates_and_its_signals_follow_its_response() -> None:
    rig = Rig(small_design(), 1, fidelity="lumped")
    response, grid = made_acceleration_response(rig)
    nominal = acoustic_fem.solve(rig.design, grid, "lumped")
    ratio = response[:, 2] / nominal.acceleration_response.values[:, 2]
    assert 0.02 < np.abs(ratio - 1).max() < 1.0
    time = np.arange(4000) / 1e3
    moved = np.stack([0 * time, 0 * time, np.sin(2 * np.pi * 10 * time)])
    heard = motion_of_rig(rig, moved)[:, 1000:3000]
    amplitude = np.abs(heard @ np.exp(-2j * np.pi * 10 * time[1000:3000])) / 1000
    at_10 = [np.interp(10.0, grid, np.abs(each)) for each in response[:, 2]]
    assert amplitude == pytest.approx(at_10, rel=0.01)
    assert motion_signals(nominal, moved).shape == heard.shape[:1] + time.shape


def test_a_hand_goes_from_rest_to_rest_and_is_never_faster_than_asked() -> None:
    moved = waved_hand(20.0, np.random.default_rng(3), 5.0, (0.0, 3.0, 4.0))
    assert moved.shape == (3, 20000)
    size = np.linalg.norm(moved, axis=0)
    assert 3.0 < size.max() <= 5.0 * 1.02
    np.testing.assert_allclose(moved[1], 0.75 * moved[2], atol=1e-12)
    assert np.abs(moved[0]).max() == 0
    # each stroke stops where it ends
    assert np.abs(np.cumsum(moved[2]) / 1e3).max() < 1.0
    knocks = table_knocks(20.0, np.random.default_rng(3), 20.0)
    assert 10.0 < np.abs(knocks[2]).max() <= 20.0


def test_a_recording_of_motion_has_its_acceleration_beside_it(tmp_path: Path) -> None:
    rig = Rig(small_design(), 1, fidelity="lumped")
    moved = waved_hand(4.0, np.random.default_rng(3))
    beside = record_motion(rig, moved, tmp_path / "waved.wav", Recorder(output="pressure", hum=0.0, drift=0.0))
    table = np.genfromtxt(beside, delimiter=",", names=True)
    assert table.dtype.names == ("time", *COLUMNS)
    np.testing.assert_allclose(table["z_m_per_s2"], moved[2], atol=1e-3)
    heard = localize.read_recording(tmp_path / "waved.wav", rig.design.microphones, 2.0).signals
    np.testing.assert_allclose(heard, motion_of_rig(rig, moved), atol=2e-2)


def test_touches_are_recorded_while_the_hand_is_waved(tmp_path: Path) -> None:
    rig = Rig(small_design(), 1, fidelity="lumped")
    recorder, loud = Recorder(output="pressure", hum=0.0, drift=0.0), []
    for name, motion in (("still", 0.0), ("waved", 5.0)):
        session = TouchSession(1, 4.0, ("taps",), motion=motion)
        record_touches(rig, tmp_path / name, [2], session, recorder)
        path = tmp_path / name / "point-02-taps-1.wav"
        loud.append(localize.read_recording(path, rig.design.microphones, 2.0).signals)
    assert 0.1 < (loud[1] - loud[0]).std() < 2.0


def test_bad_motion_is_refused() -> None:
    random = np.random.default_rng(0)
    with refused(Kind.OUT_OF_RANGE, "largest", -1.0):
        waved_hand(1.0, random, -1.0)
    with refused(Kind.OUT_OF_RANGE, "direction"):
        waved_hand(1.0, random, 1.0, (0.0, 0.0, 0.0))
    with refused(Kind.OUT_OF_RANGE, "motion", 1e4):
        TouchSession(motion=1e4)
