"""The verb recalibrate: the library that Python makes, and nothing written or replaced where it refuses."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from foreign_touches import DESIGN, GRID, NOISE, Array, heard, nominal, touches, truth
from refusals import refused

import acoustic_fem
import localize
import studies
from acoustic_fem.library.transfer_functions import measured_library
from geometry import Kind
from localize.live.stream_options import HIGH_PASS
from studies.cli.app import main
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig


def recording(path: Path, frames: Array) -> Path:
    """The frames one after the other, as a recording of 1 kHz."""
    np.savez(path, signals=np.concatenate(list(frames), axis=1))
    return path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr("sys.argv", ["acoustic-fem", "recalibrate", *map(str, arguments), "--noise", "1e-3"])
    with pytest.raises(SystemExit) as ended:
        main()
    return int(str(ended.value.code))


@pytest.mark.slow
def test_the_command_makes_the_library_of_the_sensor_from_recordings_of_touches(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Slow pressure, wander and hum of the rig are in them; what is read passes the high-pass of the streams."""
    acoustic_fem.save(nominal(), tmp_path / "last.nc")
    rig = Rig(DESIGN, 6, HiddenScatter(batch=0.0, modulus=0.85), fidelity="lumped")
    session = TouchSession(takes=1, seconds=4.0, parts=("random-1-100",))
    record_touches(rig, tmp_path / "touches", range(1, 13), session, Recorder(hum=2e-4, drift=1e-3))
    files = sorted((tmp_path / "touches").glob("*.wav"))
    arguments = (
        tmp_path / "last.nc",
        *files,
        "--full-scale",
        2,
        "--out",
        tmp_path / "now.nc",
        "--microphone-output",
        "voltage",
    )
    assert run(monkeypatch, *arguments) == 0
    assert "frames with touches" in capsys.readouterr().out
    made = acoustic_fem.load(tmp_path / "now.nc")
    assert made.provenance["self_calibration"]["high_pass"] == HIGH_PASS
    touched = replace(truth(), transfer_function=rig.transfer_function(GRID))
    before, after = (
        localize.evaluate(localize.BayesDecoder(each, NOISE), touched, 20, NOISE, seed=7).top1
        for each in (nominal(), made)
    )
    assert before < 0.7
    assert after > 0.99


@pytest.mark.slow
def test_the_command_writes_nothing_when_it_refuses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A library that is right already is kept, and so is one that the touches say too little of."""
    last, out = tmp_path / "last.nc", tmp_path / "now.nc"
    acoustic_fem.save(nominal(), last)
    before = last.read_bytes()
    own = touches(replace(truth(), transfer_function=nominal().transfer_function.values), 110)[0]
    for frames, reason in (
        (own, "which is as good"),
        (own[:30], "30 of 30 frames hold a touch"),
        (own[:, :1], "has 1 channel"),
    ):
        file = recording(tmp_path / "touches.npz", frames)
        assert run(monkeypatch, last, file, "--out", out) == 1
        assert reason in capsys.readouterr().err.splitlines()[-1]
        assert run(monkeypatch, last, tmp_path / "none.npz", "--out", out) == 1
    assert last.read_bytes() == before
    assert not out.exists()


def test_one_take_given_twice_is_refused_by_the_names_of_its_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Cut elsewhere and at another gain, it holds no frame that is a copy of another one."""
    acoustic_fem.save(nominal(), tmp_path / "last.nc")
    take = recording(tmp_path / "monday.npz", heard()[:70])
    other = recording(tmp_path / "tuesday.npz", heard()[70:])
    silent = tmp_path / "silent.npz"
    np.savez(silent, signals=1e-4 * np.random.default_rng(4).standard_normal((2, 4100)))
    again = tmp_path / "again.npz"
    np.savez(again, signals=0.9 * np.load(take)["signals"][:, 1111:])
    assert run(monkeypatch, tmp_path / "last.nc", silent, take, other, again, "--out", tmp_path / "now.nc") == 1
    assert f"{again}: is the same take as {take}: the correlation" in " ".join(capsys.readouterr().err.split())
    assert not (tmp_path / "now.nc").exists()


@pytest.mark.parametrize("kind", ["reversed", "exchanged", "late", "level"])
def test_a_wrong_connection_is_refused_before_the_search(kind: str, tmp_path: Path) -> None:
    """Exchanged microphones of this symmetric design show by the calibration of the sensor only."""
    h = truth().transfer_function
    present = measured_library(DESIGN, nominal(), h, 0.01 * np.abs(h), ("numpy",), {})
    acoustic_fem.save(present, tmp_path / "last.nc")
    one, other = np.concatenate(list(heard()[:120]), axis=1)
    if kind == "reversed":
        other = -other
    elif kind == "exchanged":
        one, other = other, one
    elif kind == "late":
        other = np.concatenate([np.zeros(40), other[:-40]])
    else:
        other = 5.0 * other
    np.savez(tmp_path / "touches.npz", signals=np.stack([one, other]))
    with refused(Kind.UNSUITABLE, "recordings", error=localize.SelfCalibrationError):
        studies.recalibrate(
            tmp_path / "last.nc", [tmp_path / "touches.npz"], tmp_path / "now.nc", microphone_noise=NOISE
        )
    assert not (tmp_path / "now.nc").exists()


def test_the_command_never_overwrites_a_library_its_own_least_of_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "last.nc").write_bytes(b"the last calibration")
    (tmp_path / "again.nc").symlink_to("last.nc")
    monkeypatch.chdir(tmp_path)
    for out in ("last.nc", "./last.nc", "again.nc"):
        assert run(monkeypatch, "last.nc", "touches.npz", "--out", out) == 1
        assert "exists, and a calibrated library is never overwritten" in capsys.readouterr().err
    assert (tmp_path / "last.nc").read_bytes() == b"the last calibration"


def test_help_says_what_touches_are_needed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(monkeypatch, "--help") == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "Record taps, presses or slides of fingers, one at a time, in a quiet room" in said
