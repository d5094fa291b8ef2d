"""The verb recalibrate: the library that Python makes, and nothing written or replaced where it refuses."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from foreign_touches import Array, calibrated, heard, nominal, touches, truth

import acoustic_fem
from studies.cli.app import main


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
def test_the_command_makes_the_same_library_from_recordings(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    acoustic_fem.save(nominal(), tmp_path / "last.nc")
    files = [recording(tmp_path / f"{k}.npz", part) for k, part in enumerate(np.split(heard(), [70]))]
    assert run(monkeypatch, tmp_path / "last.nc", *files, "--out", tmp_path / "now.nc") == 0
    said = capsys.readouterr().out
    assert "from 160 frames with touches" in said
    assert "no touch was named point 7:" in said
    made = acoustic_fem.load(tmp_path / "now.nc")
    assert made.provenance["self_calibration"] == calibrated().summary()
    assert np.array_equal(made.transfer_function.values, calibrated().library().transfer_function.values)


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
    assert f"{again} is the same take as {take}: the correlation" in " ".join(capsys.readouterr().err.split())
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
    assert "touches that fill 1 to 100 Hz (multi-sines or noise; no taps and no friction), one at a time" in said
