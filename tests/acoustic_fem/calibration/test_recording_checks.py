"""Faults injected into recordings: each is named, and the good points survive the bad ones."""

from __future__ import annotations

import shutil
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.io.wavfile
import tomlkit
from numpy.typing import NDArray

import acoustic_fem
import geometry
from acoustic_fem.calibration.manifest import ManifestError, read_manifest
from acoustic_fem.calibration.measured_library import Calibration, CalibrationError, calibrate
from acoustic_fem.calibration.recording_checks import largest_changes
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.sound.sound_file import Sound, read_sound, write_wav
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


def drifting(row: Signals) -> Signals:
    index = np.arange(len(row), dtype=np.float64)
    return np.interp(index * (1 + 1e-4), index, row)


def fading(row: Signals) -> Signals:
    return row * np.linspace(1.0, 0.4, len(row))


def losing(row: Signals) -> Signals:
    return np.concatenate([row[:22_000], row[22_020:], row[-20:]])


def quieter(row: Signals) -> Signals:
    return row * np.where(np.arange(len(row)) < 22_000, 1.0, 1 / 1.5)


def noise(row: Signals) -> Signals:
    return 0.1 * np.random.default_rng(0).standard_normal(len(row))


SIGNAL_FAULTS: dict[str, tuple[Callable[[Signals], Signals], str]] = {
    "limited": (clip, "is clipped"),
    "overdriven": (with_channel(0, lambda row: 1.2 * row / np.abs(row).max()), "channel reference is clipped"),
    "silent": (with_channel(1, np.zeros_like), "channel A is silent"),
    "weak": (with_channel(2, lambda row: row * 1e-3), "channel B is too weak"),
    "interrupted": (with_channel(1, gap), "channel A is interrupted for 0.3"),
    "short": (lambda signals: signals[:, :10_000], "is 10 s long; it must be at least 19 s"),
    "microphones exchanged": (lambda signals: signals[[0, 2, 1]], "exchanged would explain it"),
    "reference exchanged": (lambda signals: signals[[2, 1, 0]], "channels reference and B exchanged"),
    "one polarity": (with_channel(2, np.negative), "polarity of microphone B is reversed"),
    "reference polarity": (with_channel(0, np.negative), "polarity of the reference is reversed"),
    "noise only": (lambda signals: np.stack([noise(signals[0]), *signals[1:]]), "coherence of microphone"),
    "one deaf": (with_channel(2, noise), "microphone B has nothing in common with the reference"),
    "clocks": (with_channel(0, drifting), "drift apart by"),
    "fading": (with_channel(0, fading), "changes by"),
    "one loses samples": (with_channel(1, losing), "microphone A and the reference drift apart by 20.0 ms"),
    "the other loses samples": (with_channel(2, losing), "microphone B and the reference drift apart by 20.0 ms"),
    "one grows quieter": (with_channel(1, quieter), "level of microphone A against the reference changes by 3.5 dB"),
    "the other grows quieter": (with_channel(2, quieter), "level of microphone B against the reference changes by 3.5"),
    "one channel twice": (lambda signals: signals[[0, 1, 1]], "channels A and B are the same signal"),
    "one channel at two gains": (
        lambda signals: np.stack([signals[0], -0.3 * signals[2], signals[2]]),
        "channels A and B are the same signal",
    ),
    "the reference twice": (lambda signals: signals[[0, 0, 2]], "channels reference and A are the same signal"),
    "a channel missing": (lambda signals: signals[:2], "has no channel 3 for B, but 1, 2"),
}


@pytest.mark.parametrize("fault", SIGNAL_FAULTS)
def test_a_fault_in_the_signals_is_named_and_the_good_point_survives(
    fault: str, recorded: Path, model: Library, tmp_path: Path
) -> None:
    change, message = SIGNAL_FAULTS[fault]
    _, text = judged(spoilt(recorded, tmp_path, change), model)
    assert message in text


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
    assert text == "polarity of microphone B is reversed against the others"


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
    assert text.startswith("largest value of channel reference = ")
    assert text.endswith(" must be between 1e-12 and 1e+12")


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
    assert text == f"points.{BAD}.A and points.{BAD}.B are a.wav, which has one channel; each must be its own"


def test_the_recording_of_another_point_is_named(recorded: Path, model: Library, tmp_path: Path) -> None:
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    other = Rig(DESIGN, 11, fidelity="lumped").record(tmp_path / "other", [10], Recorder(seconds=24.0))
    shutil.copy(other.parent / "point-10.wav", tmp_path / f"point-{BAD}.wav")
    _, text = judged(tmp_path / "calibration.toml", model)
    assert "would explain it" in text


def rewritten(file: Path, rate: int) -> None:
    _, samples = scipy.io.wavfile.read(file)
    scipy.io.wavfile.write(file, rate, samples)


FILE_FAULTS: dict[str, tuple[Callable[[Path], object], str]] = {
    "missing": (lambda file: file.unlink(), "no such file"),
    "empty": (lambda file: file.write_bytes(b""), "cut short or not a WAV file"),
    "cut short": (lambda file: file.write_bytes(file.read_bytes()[:50_000]), "cut short: it has 50000 of"),
    "a text": (lambda file: file.write_text("no sound at all"), "not a WAV file"),
    "rate too low": (lambda file: rewritten(file, 200), "sample rate = 200 Hz must be at least 250 Hz"),
}


@pytest.mark.parametrize("fault", FILE_FAULTS)
def test_a_fault_in_a_file_is_named_and_the_good_point_survives(
    fault: str, recorded: Path, model: Library, tmp_path: Path
) -> None:
    change, message = FILE_FAULTS[fault]
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    change(tmp_path / f"point-{BAD}.wav")
    _, text = judged(tmp_path / "calibration.toml", model)
    assert message in text


TIME = "time,reference,A,B\n"
OTHER_FILES: dict[str, tuple[str, Callable[[Path], object], str]] = {
    "suffix": ("a.mp3", lambda file: file.write_bytes(b"ID3"), "its name must end with .wav, .csv, .npz or .mat"),
    "no head": ("a.csv", lambda file: file.write_text(""), "is empty or not a CSV file"),
    "no time": ("a.csv", lambda file: file.write_text("reference,A,B\n1,2,3\n"), "they must be time and one per"),
    "ragged": ("a.csv", lambda file: file.write_text(TIME + "0,1,2,3\n1,2\n"), "line 3 has 2 values, must have 4"),
    "words": ("a.csv", lambda file: file.write_text(TIME + "0,1,2,x\n"), "could not convert string to float"),
    "uneven": ("a.csv", lambda file: file.write_text(TIME + "0,1,2,3\n1,1,2,3\n5,1,2,3\n"), "even steps"),
    "no rate": ("a.npz", lambda file: np.savez(file, A=np.ones(9)), "has no sample_rate, but A"),
    "a matrix": ("a.npz", lambda file: np.savez(file, A=np.ones((9, 9)), sample_rate=9.0), "one row of samples"),
    "objects": ("a.npz", lambda file: np.savez(file, A=np.array(["x"]), sample_rate=9.0), "not real numbers"),
    "unequal": (
        "a.npz",
        lambda file: np.savez(file, A=np.ones(9), B=np.ones(8), sample_rate=9.0),
        "different numbers of samples",
    ),
    "rate of zero": ("a.npz", lambda file: np.savez(file, A=np.ones(9), sample_rate=0.0), "finite and above 0"),
    "no NPZ": ("a.npz", lambda file: file.write_bytes(b"PK"), "not an NPZ file"),
    "no MAT": ("a.mat", lambda file: file.write_bytes(b"MATLAB" * 40), "not a MAT file"),
    "not finite": (
        "a.npz",
        lambda file: np.savez(
            file, **{name: np.full(30_000, np.nan) for name in ("reference", "A", "B")}, sample_rate=1000.0
        ),
        "channel reference is not finite at 0.000 s",
    ),
}


@pytest.mark.parametrize("fault", OTHER_FILES)
def test_a_fault_in_another_kind_of_file_is_named(fault: str, recorded: Path, model: Library, tmp_path: Path) -> None:
    name, make, message = OTHER_FILES[fault]
    shutil.copytree(recorded, tmp_path, dirs_exist_ok=True)
    make(tmp_path / name)
    path = tmp_path / "calibration.toml"
    manifest = tomlkit.parse(path.read_text(encoding="utf-8"))
    manifest["points"] = {str(GOOD): f"point-{GOOD}.wav", str(BAD): name}
    path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
    _, text = judged(path, model)
    assert message in text


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"points": {"13": "x.wav"}}, "points.13 must be a point from 1 to 12"),
        ({"points": {}}, "points = {} must be a table of at least 1 entries"),
        ({"points": {"1": 3}}, "points.1 = 3 is refused: it is neither a file nor a table of one file per channel"),
        (
            {"points": {"1": {"reference": "x.wav"}}},
            "points.1 has files of reference; it must be one file, or",
        ),
        ({"channels": {"reference": 1, "A": 2}}, "channels must give reference, A, B a number each, all different"),
        ({"channels": {"reference": 1, "A": 1, "B": 2}}, "all different"),
        ({"pascals": {"C": 1.0}}, "pascals.C must be one of: reference, A, B"),
        (
            {"pascals": {"A": -1.0}},
            "pascals.A = -1 is refused: input should be greater than or equal to",
        ),
        ({"pascals": {"A": 1e300}}, "pascals.A = 1e+300"),
        ({"started_late": {"A": 1e9}}, "started_late.A = 1000000000 is refused"),
        ({"estimator": "H7"}, "estimator = 'H7' must be one of: H1, H2, Hv"),
        ({"colour": "blue"}, "colour = 'blue' is not a field of a manifest; known: "),
        ({"design": 3}, "design = 3 must be a text"),
    ],
)
def test_a_bad_manifest_is_refused_before_any_work(
    change: dict[str, object], message: str, recorded: Path, tmp_path: Path
) -> None:
    manifest = tomlkit.parse((recorded / "calibration.toml").read_text(encoding="utf-8"))
    for key, value in change.items():
        manifest[key] = value
    (tmp_path / "design.toml").write_text((recorded / "design.toml").read_text(encoding="utf-8"), encoding="utf-8")
    path = tmp_path / "calibration.toml"
    path.write_text(tomlkit.dumps(manifest), encoding="utf-8")
    with pytest.raises(ManifestError) as refused:
        read_manifest(path)
    assert str(refused.value).startswith(f"{path}: ")
    assert message in str(refused.value)


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
    with pytest.raises(CalibrationError) as refused:
        calibrate(read_manifest(tmp_path / "calibration.toml"), model)
    assert "no recording can be used; point 3:" in str(refused.value)
