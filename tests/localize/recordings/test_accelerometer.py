"""The file of an accelerometer: which are read, which are refused by name, and what is left of a waved hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from refusals import refused
from shared import solved

import acoustic_fem
import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from localize.live.sources import ReplaySource
from localize.recordings import AccelerationFile, read_acceleration
from localize.recordings.accelerometer import COLUMNS
from localize.signals import fitted_motion, motion_signals
from studies.test_rig import Recorder, Rig, record_motion, waved_hand
from studies.test_rig.rig_motion import motion_of_rig, write_acceleration

SECONDS = 8.0


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return solved("array-2x6", np.concatenate([[0.5], np.arange(1.0, 201.0)]))


@pytest.fixture(scope="module")
def rig() -> Rig:
    return Rig("array-2x6", 9900, fidelity="lumped")


def moved_hand(seed: int = 1) -> np.ndarray:
    return waved_hand(SECONDS, np.random.default_rng(seed), 5.0)


def test_a_table_that_was_written_is_read_again(tmp_path: Path) -> None:
    moved = moved_hand()
    path = tmp_path / "moved.csv"
    write_acceleration(path, moved, 1000.0)
    found = read_acceleration(AccelerationFile(path))
    np.testing.assert_allclose(found.samples, moved, rtol=1e-4, atol=1e-9)
    assert found.rate == pytest.approx(1000.0)


def test_a_wav_file_is_read_by_the_full_scale_and_the_channels_that_are_given(tmp_path: Path) -> None:
    moved, path = moved_hand(), tmp_path / "moved.wav"
    write_wav(path, np.stack([np.zeros(moved.shape[1]), moved[2] / 20]), 1000)
    found = read_acceleration(AccelerationFile(path, 20.0, {"z": 2}))
    np.testing.assert_allclose(found.samples[2], moved[2], atol=20 / 2**15)
    assert found.axes == ("z",)
    with refused(Kind.MISSING):
        read_acceleration(AccelerationFile(path, channels={"z": 2}))
    with refused(Kind.MISMATCH):
        read_acceleration(AccelerationFile(path, 20.0))
    with refused(Kind.MISSING, "acceleration_channels", "z=3"):
        read_acceleration(AccelerationFile(path, 20.0, {"z": 3}))


def test_a_file_without_an_acceleration_in_its_unit_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "moved.csv"
    path.write_text("time,z_g\n0,0\n0.001,0\n")
    with refused(Kind.MISSING):
        read_acceleration(AccelerationFile(path))


def test_another_rate_another_length_and_a_missing_axis_are_refused(
    library: acoustic_fem.Library, tmp_path: Path
) -> None:
    moved, path = moved_hand(), tmp_path / "moved.csv"
    signals = np.zeros((2, moved.shape[1]))
    write_acceleration(path, moved[:, :-100], 1000.0)
    with refused(Kind.MISMATCH):
        read_acceleration(AccelerationFile(path)).taken_out(library, signals, 1000.0)
    write_acceleration(path, moved, 500.0)
    with refused(Kind.MISMATCH):
        read_acceleration(AccelerationFile(path)).taken_out(library, signals, 1000.0)
    rows = "".join(f"{k / 1000},0\n" for k in range(moved.shape[1]))
    path.write_text(f"time,{COLUMNS[0]}\n{rows}")
    with refused(Kind.MISSING, COLUMNS[2]):
        read_acceleration(AccelerationFile(path)).taken_out(library, signals, 1000.0)


def test_bad_arguments_are_refused() -> None:
    with refused(Kind.OUT_OF_RANGE, "acceleration_full_scale", 0.0):
        AccelerationFile("a.wav", 0.0)
    with refused(Kind.OUT_OF_RANGE, "acceleration_channels", "w=1"):
        AccelerationFile("a.wav", 1.0, {"w": 1})


def test_the_motion_of_an_as_built_sensor_is_fitted_and_a_touch_is_kept(
    library: acoustic_fem.Library, rig: Rig
) -> None:
    moved = moved_hand()
    motion = motion_of_rig(rig, moved)
    touch = np.zeros_like(motion)
    touch[:, 4000:4200] = 0.5 * np.sin(np.pi * np.arange(200) / 200) ** 2 * np.array([[1.0], [0.4]])
    predicted = motion_signals(library, moved)
    # the first strokes, while the filter of the fit settles, are left out
    before, after = ((motion - each)[:, 500:].std() for each in (predicted, fitted_motion(motion + touch, predicted)))
    assert after < 0.3 * before
    assert after < 0.02 * motion[:, 500:].std()


def test_a_sensor_that_is_not_moved_keeps_its_signals(library: acoustic_fem.Library) -> None:
    signals = np.random.default_rng(3).standard_normal((2, 4000))
    assert fitted_motion(signals, motion_signals(library, np.zeros((3, 4000)))) == pytest.approx(0.0, abs=1e-12)


def test_a_waved_sensor_with_an_accelerometer_reports_no_touch(
    library: acoustic_fem.Library, rig: Rig, tmp_path: Path
) -> None:
    recording = tmp_path / "waved.wav"
    recorder = Recorder()
    beside = record_motion(rig, moved_hand(2), recording, recorder)
    model = localize.open_model(library, microphone_output="voltage", tolerances=False)
    without = model.locate_file(recording, recorder.full_scale)
    less = model.locate_file(recording, recorder.full_scale, acceleration=AccelerationFile(beside))
    assert len(without.touches) >= 3
    assert len(less.touches) == 0
    # a file that is played is the same
    correct = model.motion_correction(AccelerationFile(beside))
    played = ReplaySource(recording, ("A", "B"), recorder.full_scale, correct=correct)
    read = model.read(recording, recorder.full_scale, acceleration=AccelerationFile(beside))
    assert played._samples == pytest.approx(read.signals, abs=1e-9)


def test_the_recording_itself_may_hold_the_acceleration(library: acoustic_fem.Library, tmp_path: Path) -> None:
    moved = moved_hand()
    heard = motion_signals(library, moved) + 1e-4 * np.random.default_rng(1).standard_normal((2, moved.shape[1]))
    path = tmp_path / "all.npz"
    np.savez(path, sample_rate=1000.0, A=heard[0], B=heard[1], **dict(zip(COLUMNS, moved, strict=True)))
    model = localize.open_model(library, tolerances=False)
    with refused(Kind.MISMATCH):
        model.read(path)
    left = model.read(path, acceleration=AccelerationFile(path)).signals
    assert left.std() < 0.02 * heard.std()


def test_an_acceleration_needs_a_library(library: acoustic_fem.Library, tmp_path: Path) -> None:
    path = tmp_path / "moved.csv"
    write_acceleration(path, moved_hand(), 1000.0)
    model = localize.open_model(localize.BayesDecoder(library, 1e-3))
    with refused(Kind.MISSING, "acceleration"):
        model.motion_correction(AccelerationFile(path))
