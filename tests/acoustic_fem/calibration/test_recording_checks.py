"""Faults injected into recordings: each is named, and the good points survive the bad ones."""

from __future__ import annotations

import shutil
import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import scipy.io.wavfile
import tomlkit
from numpy.typing import NDArray
from refusals import check_messages, refused

import acoustic_fem
import geometry
from acoustic_fem.calibration.manifest import ManifestError, read_manifest
from acoustic_fem.calibration.measured_library import Calibration, CalibrationError, calibrate
from acoustic_fem.calibration.recording_checks import largest_changes
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.sound.sound_file import Sound, read_sound, write_wav
from geometry.ground.refusal import Kind, Refusal
from studies.test_rig.virtual_rig import Recorder, Rig

GRID = np.linspace(1.0, 100.0, 34)
DESIGN = geometry.prototype("array-2x6")
GOOD, BAD = 6, 3
RATE = 1000

Signals = NDArray[np.float64]


@pytest.fixture(scope="module")
def model() -> Library:
    return acoustic_fem.solve(DESIGN, GRID, "lumped")


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("recorded")
    Rig(DESIGN, 11, fidelity="lumped").record(folder, [GOOD, BAD], Recorder(seconds=44.0))
    return folder


def spoilt(recorded: Path, folder: Path, change: Callable[[Signals], Signals]) -> Path:
    """The recordings with the signals of the bad point changed, (reference, A, B)."""
    shutil.copytree(recorded, folder, dirs_exist_ok=True)
    file = folder / f"point-{BAD}.wav"
    sound: Sound = read_sound(file)
    write_wav(file, change(np.stack(list(sound.channels.values()))), RATE)
    return folder / "calibration.toml"


def judged(manifest: Path, model: Library) -> tuple[Calibration, str]:
    """The calibration, and why the bad point was left out; the good one must be in."""
    found = calibrate(read_manifest(manifest), model)
    assert list(found.estimates) == [GOOD]
    (excluded,) = [finding for finding in found.findings if finding.excluded]
    assert excluded.point == BAD
    return found, excluded.text


def findings(manifest: Path, model: Library) -> None:
    """The finding on the bad recording, as a refusal."""
    raise Refusal(judged(manifest, model)[1], kind=Kind.OUT_OF_RANGE)


def clip(signals: Signals) -> Signals:
    return np.clip(signals, -0.5 * np.abs(signals).max(1)[:, None], 0.5 * np.abs(signals).max(1)[:, None])


def with_channel(number: int, values: Callable[[Signals], Signals]) -> Callable[[Signals], Signals]:
    def change(signals: Signals) -> Signals:
        changed = signals.copy()
        changed[number] = values(signals[number])
        return changed

    return change


def gap(row: Signals) -> Signals:
    return np.concatenate([row[:20_000], np.full(300, row[20_000]), row[20_300:]])


def fading(row: Signals) -> Signals:
    return row * np.linspace(1.0, 0.4, len(row))


def losing(row: Signals) -> Signals:
    return np.concatenate([row[:22_000], row[22_020:], row[-20:]])


def quieter(row: Signals) -> Signals:
    return row * np.where(np.arange(len(row)) < 22_000, 1.0, 1 / 1.5)


def noise(row: Signals) -> Signals:
    return 0.1 * np.random.default_rng(0).standard_normal(len(row))


SIGNAL_FAULTS: dict[str, Callable[[Signals], Signals]] = {
    "limited": clip,
    "overdriven": with_channel(0, lambda row: 1.2 * row / np.abs(row).max()),
    "silent": with_channel(1, np.zeros_like),
    "weak": with_channel(2, lambda row: row * 1e-3),
    "interrupted": with_channel(1, gap),
    "short": lambda signals: signals[:, :10_000],
    "microphones exchanged": lambda signals: signals[[0, 2, 1]],
    "reference exchanged": lambda signals: signals[[2, 1, 0]],
    "one polarity": with_channel(2, np.negative),
    "reference polarity": with_channel(0, np.negative),
    "noise only": lambda signals: np.stack([noise(signals[0]), *signals[1:]]),
    "one deaf": with_channel(2, noise),
    "fading": with_channel(0, fading),
    "one loses samples": with_channel(1, losing),
    "the other loses samples": with_channel(2, losing),
    "one grows quieter": with_channel(1, quieter),
    "the other grows quieter": with_channel(2, quieter),
    "one channel twice": lambda signals: signals[[0, 1, 1]],
    "one channel at two gains": lambda signals: np.stack([signals[0], -0.3 * signals[2], signals[2]]),
    "the reference twice": lambda signals: signals[[0, 0, 2]],
    "a channel missing": lambda signals: signals[:2],
}


@pytest.mark.slow
def test_a_fault_in_the_signals_is_named_and_the_good_point_survives(
    recorded: Path, model: Library, tmp_path: Path
) -> None:
    cases = {
        fault: partial(findings, spoilt(recorded, tmp_path / fault, change), model)
        for fault, change in SIGNAL_FAULTS.items()
    }
    check_messages(Path(__file__).with_name("signals.txt"), cases)


@pytest.mark.parametrize("seconds", [24.0, 40.0])
def test_losses_and_changes_are_found_wherever_they_are_and_good_recordings_have_none(seconds: float) -> None:
    recorder = Recorder(seconds=seconds, hum=2e-2, drift=5e-2)
    for seed, point in ((1, 1), (2, 7)):
        good = Rig(DESIGN, seed, fidelity="lumped").signals(point, recorder)
        levels, delays = largest_changes(good, RATE, GRID)
        assert levels.max() < 0.2
        assert delays.max() < 2.5e-4
        for share in (0.25, 0.7):
            at = int(share * good.shape[1])
            for microphone in (0, 1):
                changed = good.copy()
                row = good[1 + microphone]
                changed[1 + microphone] = np.concatenate([row[:at], row[at + 2 :], row[-2:]])
                _, delays = largest_changes(changed, RATE, GRID)
                assert delays[microphone] == pytest.approx(2e-3, abs=3e-4)
                assert delays[1 - microphone] < 2.5e-4
                changed[1 + microphone] = row * np.where(np.arange(len(row)) < at, 1.0, 1.5)
                levels, _ = largest_changes(changed, RATE, GRID)
                assert levels[microphone] == pytest.approx(20 * np.log10(1.5), abs=0.3)
                assert levels[1 - microphone] < 0.2


@pytest.mark.parametrize("late", [-60, 100, 200])
def test_a_late_reference_is_no_reversed_one(late: int, recorded: Path, model: Library, tmp_path: Path) -> None:
    def shifted(signals: Signals) -> Signals:
        return np.stack([np.roll(signals[0], late), *signals[1:]])

    found = calibrate(read_manifest(spoilt(recorded, tmp_path / "late", shifted)), model)
    assert list(found.estimates) == [BAD, GOOD]
    (note,) = [finding for finding in found.findings if "lag by" in finding.text]
    assert note.point == BAD
    lag = float(note.text.split("lag by ")[1].split(" ms")[0])
    assert lag == pytest.approx(-late, abs=2.0)

    def reversed_too(signals: Signals) -> Signals:
        return shifted(signals) * np.array([[1.0], [1.0], [-1.0]])

    _, text = judged(spoilt(recorded, tmp_path / "both", reversed_too), model)
    assert "polarity of microphone B" in text


@pytest.mark.parametrize("scale", [1e200, 1e-200])
def test_values_out_of_range_are_named_without_a_warning(
    scale: float, recorded: Path, model: Library, tmp_path: Path
) -> None:
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    signals = np.stack(list(read_sound(tmp_path / f"point-{BAD}.wav").channels.values()))
    np.savez(tmp_path / "a.npz", signals=signals * np.array([[scale], [1.0], [1.0]]), sample_rate=float(RATE))
    path = tmp_path / "calibration.toml"
    manifest = tomlkit.parse(path.read_text(encoding="utf-8"))
    manifest["points"] = {str(GOOD): f"point-{GOOD}.wav", str(BAD): "a.npz"}
    path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        _, text = judged(path, model)
    assert text.startswith("channels.reference has a largest value of ")


def test_one_file_of_one_channel_given_for_two_is_named(recorded: Path, model: Library, tmp_path: Path) -> None:
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    signals = np.stack(list(read_sound(tmp_path / f"point-{BAD}.wav").channels.values()))
    for name, row in zip(("cavity", "a"), signals, strict=False):
        write_wav(tmp_path / f"{name}.wav", row[None], RATE)
    path = tmp_path / "calibration.toml"
    manifest = tomlkit.parse(path.read_text(encoding="utf-8"))
    twice = {"reference": "cavity.wav", "A": "a.wav", "B": "a.wav"}
    manifest["points"] = {str(GOOD): f"point-{GOOD}.wav", str(BAD): twice}
    path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
    _, text = judged(path, model)
    assert text.startswith(f"points.{BAD}.A and points.{BAD}.B are a.wav")


def test_the_recording_of_another_point_is_named(recorded: Path, model: Library, tmp_path: Path) -> None:
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    other = Rig(DESIGN, 11, fidelity="lumped").record(tmp_path / "other", [10], Recorder(seconds=24.0))
    shutil.copy(other.parent / "point-10.wav", tmp_path / f"point-{BAD}.wav")
    _, text = judged(tmp_path / "calibration.toml", model)
    assert "would explain it" in text


def rewritten(file: Path, rate: int) -> None:
    _, samples = scipy.io.wavfile.read(file)
    scipy.io.wavfile.write(file, rate, samples)


FILE_FAULTS: dict[str, Callable[[Path], object]] = {
    "missing": lambda file: file.unlink(),
    "empty": lambda file: file.write_bytes(b""),
    "cut short": lambda file: file.write_bytes(file.read_bytes()[:50_000]),
    "a text": lambda file: file.write_text("no sound at all"),
    "rate too low": lambda file: rewritten(file, 200),
}
OTHER_FILES: dict[str, Callable[[Path], object]] = {
    "a.mp3": lambda file: file.write_bytes(b"ID3"),
    "no archive.npz": lambda file: file.write_bytes(b"PK"),
    "not finite.npz": lambda file: np.savez(
        file, **{name: np.full(30_000, np.nan) for name in ("reference", "A", "B")}, sample_rate=1000.0
    ),
}


def test_a_fault_in_a_file_is_named_and_the_good_point_survives(recorded: Path, model: Library, tmp_path: Path) -> None:
    cases = {}
    for fault, change in (FILE_FAULTS | OTHER_FILES).items():
        folder = tmp_path / fault.split(".")[0]
        shutil.copytree(recorded, folder)
        path = folder / "calibration.toml"
        if fault in FILE_FAULTS:
            change(folder / f"point-{BAD}.wav")
        else:
            change(folder / fault)
            manifest = tomlkit.parse(path.read_text(encoding="utf-8"))
            manifest["points"] = {str(GOOD): f"point-{GOOD}.wav", str(BAD): fault}
            path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
        cases[fault] = partial(findings, path, model)
    check_messages(Path(__file__).with_name("files.txt"), cases, {f"{tmp_path}/": ""})


BAD_MANIFESTS: dict[str, tuple[dict[str, object], str]] = {
    "a point too many": ({"points": {"13": "x.wav"}}, "points.13"),
    "no point": ({"points": {}}, "points"),
    "a number": ({"points": {"1": 3}}, "points.1"),
    "one channel's file": ({"points": {"1": {"reference": "x.wav"}}}, "points.1"),
    "a channel left out": ({"channels": {"reference": 1, "A": 2}}, "channels"),
    "a channel twice": ({"channels": {"reference": 1, "A": 1, "B": 2}}, "channels"),
    "a channel that is none": ({"pascals": {"C": 1.0}}, "pascals.C"),
    "negative": ({"pascals": {"A": -1.0}}, "pascals.A"),
    "too large": ({"pascals": {"A": 1e300}}, "pascals.A"),
    "too late": ({"started_late": {"A": 1e9}}, "started_late.A"),
    "estimator": ({"estimator": "H7"}, "estimator"),
    "another field": ({"colour": "blue"}, "colour"),
    "no text": ({"design": 3}, "design"),
}


def test_a_bad_manifest_is_refused_before_any_work(recorded: Path, tmp_path: Path) -> None:
    shutil.copy(recorded / "design.toml", tmp_path)
    cases = {}
    for fault, (change, field) in BAD_MANIFESTS.items():
        path = tmp_path / f"{fault}.toml"
        manifest = tomlkit.parse((recorded / "calibration.toml").read_text(encoding="utf-8"))
        manifest.update(change)
        path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
        with pytest.raises(ManifestError) as found:
            read_manifest(path)
        assert str(found.value).startswith(f"{path}: {field}"), found.value
        cases[fault] = partial(read_manifest, path)
    check_messages(Path(__file__).with_name("messages.txt"), cases, {f"{tmp_path}/": ""})


def test_one_recording_of_two_neighbours_counts_for_neither(recorded: Path, model: Library, tmp_path: Path) -> None:
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    path = tmp_path / "calibration.toml"
    manifest = tomlkit.parse(path.read_text(encoding="utf-8"))
    files = {"3": "point-3.wav", "6": "point-6.wav", "7": "point-6.wav"}
    manifest["points"] = files
    path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
    found = calibrate(read_manifest(path), model)
    assert list(found.estimates) == [3]
    texts = [(finding.point, finding.text) for finding in found.findings if finding.excluded]
    assert texts == [(6, "is the same recording as that of point 7"), (7, "is the same recording as that of point 6")]


def test_without_a_good_recording_there_is_no_calibration(recorded: Path, model: Library, tmp_path: Path) -> None:
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    for file in tmp_path.glob("*.wav"):
        file.unlink()
    with refused(Kind.UNSUITABLE, "points.3", error=CalibrationError):
        calibrate(read_manifest(tmp_path / "calibration.toml"), model)
