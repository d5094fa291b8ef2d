"""Recorders whose clocks differ: the difference is found, and the calibration is as good as with one clock."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import tomlkit
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.calibration.clock_drift import at_nominal_times, clock_difference
from acoustic_fem.calibration.manifest import REFERENCE, ManifestError, read_manifest
from acoustic_fem.calibration.measured_library import Calibration, CalibrationError, calibrate
from acoustic_fem.calibration.reference_response import ResponseError, read_response
from acoustic_fem.sound.sound_file import read_wav, write_wav
from geometry.ground.refusal import Kind
from studies.test_rig.virtual_rig import Recorder, Rig

GRID = np.linspace(1.0, 100.0, 34)
DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4, "layout.columns": 4})
RECORDER = Recorder(seconds=40.0, separate=True, reference_corner=0.0)
FASTER = 40.0
"""Rate of the microphones' recorders above the stated one, ppm."""


@pytest.fixture(scope="module")
def rig() -> Rig:
    return Rig(DESIGN, 5, fidelity="lumped")


@pytest.fixture(scope="module")
def model() -> acoustic_fem.Library:
    return acoustic_fem.solve(DESIGN, GRID, "lumped")


def with_fast_clocks(path: Path, rig: Rig) -> None:
    """Make the microphones' files of a session as recorders write them that sample too fast."""
    for name in DESIGN.microphones:
        file = path.parent / f"point-2-{name}.wav"
        samples = read_wav(file).channels["1"]
        write_wav(file, at_nominal_times(samples, -FASTER)[None], RECORDER.rate, 32)


def change(path: Path, **values: object) -> None:
    """Add fields to a manifest."""
    write = tomlkit.parse(path.read_text())
    for name, value in values.items():
        write[name] = value
    fields = [name for name, value in write.items() if not isinstance(value, dict)]
    path.write_text(tomlkit.dumps({name: write[name] for name in [*fields, *(set(write) - set(fields))]}))


def error(found: Calibration, rig: Rig) -> float:
    """Mean relative error of what was measured at point 2."""
    truth = rig.transfer_function(GRID)[1]
    return float(np.abs(found.estimates[2].transfer_function / truth - 1).mean())


@pytest.mark.parametrize("ppm", [-150.0, 0.0, 2.0, 25.0])
def test_the_difference_of_two_clocks_is_found_to_a_ppm(ppm: float, rig: Rig) -> None:
    reference, *others = rig.signals(2, replace(RECORDER, late=0.0))
    signals = [reference, *(at_nominal_times(each, -ppm) for each in others)]
    shortest = min(map(len, signals))
    found = clock_difference(np.stack([each[:shortest] for each in signals]), 1000.0, GRID)
    assert found == pytest.approx(ppm if abs(ppm) > 6 else 0.0, abs=1.0)


def test_channels_without_anything_in_common_have_no_difference_of_clocks() -> None:
    noise = np.random.default_rng(0).standard_normal((3, 40_000))
    assert clock_difference(noise, 1000.0, GRID) == 0.0


def test_a_signal_comes_back_at_the_times_of_a_right_clock() -> None:
    time = np.arange(20_000) / 1000
    fast = np.sin(2 * np.pi * 90 * time / (1 + 1e-4))
    found = at_nominal_times(fast, 100.0)
    assert found == pytest.approx(np.sin(2 * np.pi * 90 * time[: len(found)]), abs=1e-4)
    assert len(found) == 19_998


def test_a_calibration_allows_for_the_clocks_and_says_so(tmp_path: Path, rig: Rig, model: acoustic_fem.Library) -> None:
    path = rig.record(tmp_path, [2], RECORDER)
    one_clock = error(calibrate(read_manifest(path), model), rig)
    with_fast_clocks(path, rig)
    found = calibrate(read_manifest(path), model)
    assert error(found, rig) < 1.2 * one_clock
    assert any("ppm faster" in each.text and not each.excluded for each in found.findings)
    change(path, clock_ppm=dict.fromkeys(DESIGN.microphones, FASTER))
    given = calibrate(read_manifest(path), model)
    assert error(given, rig) < 1.2 * one_clock
    assert not any("ppm" in each.text for each in given.findings)
    change(path, clock_ppm=dict.fromkeys(DESIGN.microphones, 0.0))
    with refused(Kind.UNSUITABLE, "points.2", error=CalibrationError):
        calibrate(read_manifest(path), model)


def test_lost_samples_are_not_taken_for_a_difference_of_clocks(
    tmp_path: Path, rig: Rig, model: acoustic_fem.Library
) -> None:
    path = rig.record(tmp_path, [2], RECORDER)
    for name in DESIGN.microphones:
        file = tmp_path / f"point-2-{name}.wav"
        samples = read_wav(file).channels["1"]
        write_wav(file, np.concatenate([samples[:20_000], samples[20_002:]])[None], RECORDER.rate, 32)
    with refused(Kind.UNSUITABLE, "points.2", error=CalibrationError):
        calibrate(read_manifest(path), model)


def test_the_response_of_the_calibration_microphone_is_taken_out(
    tmp_path: Path, rig: Rig, model: acoustic_fem.Library
) -> None:
    path = rig.record(tmp_path, [2], RECORDER)
    flat = calibrate(read_manifest(path), model).estimates[2]
    (tmp_path / "mic.csv").write_text("frequency;dB;degrees\n0,5;-6;90\n50;-3;45\n200;0;0\n")
    change(path, response="mic.csv")
    found = calibrate(read_manifest(path), model).estimates[2]
    level = 20 * np.log10(np.abs(found.transfer_function / flat.transfer_function))
    turn = np.degrees(np.angle(found.transfer_function / flat.transfer_function))
    at = int(np.argmin(np.abs(GRID - 50.0)))
    between = np.log(GRID[at] / 0.5) / np.log(50.0 / 0.5) if GRID[at] <= 50 else 1.0
    assert level[:, at] == pytest.approx(-6 + 3 * between, abs=0.1)
    assert turn[:, at] == pytest.approx(90 - 45 * between, abs=1.0)
    np.testing.assert_allclose(found.deviation / flat.deviation, 10 ** (level / 20), rtol=1e-9)


@pytest.mark.parametrize(("text", "kind", "field"), [
    ("frequency,dB\n1,0\n200,0\n", Kind.MISSING, "degrees"),
    ("frequency,dB,degrees\n200,0,0\n1,0,0\n", Kind.UNSUITABLE, "frequency"),
    ("frequency,dB,degrees\n0,0,0\n200,0,0\n", Kind.UNSUITABLE, "frequency"),
    ("frequency,dB,degrees\n1,0,nan\n200,0,0\n", Kind.OUT_OF_RANGE, "degrees"),
    ("frequency,dB,degrees\n1,0,0\n", Kind.UNSUITABLE, None),
])  # fmt: skip
def test_a_response_that_is_none_is_refused(text: str, kind: Kind, field: str | None, tmp_path: Path) -> None:
    (tmp_path / "mic.csv").write_text(text)
    with refused(kind, field, file="mic.csv", error=ResponseError):
        read_response(tmp_path / "mic.csv")


def test_a_response_must_cover_the_frequencies(tmp_path: Path) -> None:
    (tmp_path / "mic.csv").write_text("frequency,dB,degrees\n20,0,0\n200,0,0\n")
    known = read_response(tmp_path / "mic.csv")
    with refused(Kind.OUT_OF_RANGE, "frequency", file="mic.csv", error=ResponseError):
        known.at(GRID)


@pytest.mark.parametrize(("values", "kind", "field"), [
    ({"clock_ppm": {"C": 1.0}}, Kind.UNKNOWN, "clock_ppm.C"),
    ({"clock_ppm": {REFERENCE: 2000.0}}, Kind.OUT_OF_RANGE, f"clock_ppm.{REFERENCE}"),
    ({"response": "nowhere.csv"}, Kind.MISSING, None),
])  # fmt: skip
def test_clocks_and_responses_of_a_manifest_are_checked(
    values: dict[str, object], kind: Kind, field: str | None, tmp_path: Path, rig: Rig
) -> None:
    path = rig.record(tmp_path, [2], Recorder(seconds=4.0))
    change(path, **values)
    with refused(kind, field, error=ResponseError if "response" in values else ManifestError):
        read_manifest(path)
