"""Recordings as files: what a file states and does not hold is refused, and none takes more memory than is stated."""

from __future__ import annotations

import struct
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io
import scipy.io.wavfile
from refusals import check_messages, refused

from acoustic_fem.sound.sound_file import SoundFileError, read_sound, read_wav, write_wav
from geometry.ground.refusal import Kind

SAMPLES = np.random.default_rng(0).uniform(-0.5, 0.5, (2, 50))


def wav(path: Path, bits: int = 16) -> bytes:
    """The bytes of a sound file of two channels; its samples begin at 44."""
    write_wav(path, SAMPLES, 1000, bits)
    return path.read_bytes()


def with_field(content: bytes, place: int, kind: str, value: int) -> bytes:
    size = struct.calcsize(kind)
    return content[:place] + struct.pack(kind, value) + content[place + size :]


#: Where a field lies, how it is packed, and what else is put there.
FALSE_FIELDS = {
    "a length of 4 GB": (4, "<I", 2**32 - 9),
    "a length of nothing": (4, "<I", 4),
    "no channels": (22, "<H", 0),
    "block align 0": (32, "<H", 0),
    "block align 40000": (32, "<H", 40_000),
    "rate 0": (24, "<I", 0),
    "a format of its own": (20, "<H", 85),
    "samples of 4 GB": (40, "<I", 2**32 - 1),
    "a head of 4 GB": (16, "<I", 2**32 - 1),
}


@pytest.mark.parametrize("fault", FALSE_FIELDS)
def test_a_wav_file_that_states_what_it_does_not_hold_is_refused(fault: str, tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    path.write_bytes(with_field(wav(path), *FALSE_FIELDS[fault]))
    with refused(Kind.UNREADABLE, file=path, error=SoundFileError):
        read_wav(path)


@pytest.mark.parametrize("channels", [1, 2])
def test_a_wav_file_without_samples_has_channels_of_none(channels: int, tmp_path: Path) -> None:
    write_wav(tmp_path / "given.wav", SAMPLES[:channels, :0], 1000)
    found = read_wav(tmp_path / "given.wav")
    assert (len(found.channels), found.length) == (channels, 0)


def test_a_wav_file_of_chunks_without_end_is_refused_at_once(tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    with path.open("wb") as file:
        file.write(b"RIFF" + struct.pack("<I", 400_000_000 - 8) + b"WAVE")
        file.truncate(400_000_000)  # all zeros: fifty million chunks of no length
    with refused(Kind.UNREADABLE, file=path, error=SoundFileError):
        read_wav(path)


def test_a_wav_file_of_four_gigabytes_is_refused_by_a_stated_bound(tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    with path.open("wb") as file:
        file.write(with_field(with_field(wav(tmp_path / "small.wav"), 4, "<I", 2**32 - 9), 40, "<I", 2**32 - 45))
        file.truncate(2**32 - 1)
    with refused(Kind.OUT_OF_RANGE, file=path, error=SoundFileError):
        read_sound(path)


def test_a_channel_beyond_the_bound_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wav(tmp_path / "given.wav")
    for most in (50, 49):
        monkeypatch.setattr("acoustic_fem.sound.sound_file.MOST_NUMBERS", most)
        if most == 50:
            assert len(read_wav(tmp_path / "given.wav").channels["2"]) == 50
    with refused(Kind.OUT_OF_RANGE, file="given.wav", error=SoundFileError):
        read_wav(tmp_path / "given.wav")


def test_channels_of_every_format_are_fractions_of_full_scale(tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    for bits in (16, 24, 32):
        wav(path, bits)
        sound = read_wav(path)
        assert (list(sound.channels), len(sound.channels), "3" in sound.channels) == (["1", "2"], 2, False)
        found = np.stack(list(sound.channels.values()))
        assert found.dtype == np.float64
        np.testing.assert_allclose(found, SAMPLES, atol=2.0**-bits)
        assert sound.full_scale == 1 - 2.0 ** (1 - bits)
    scipy.io.wavfile.write(path, 1000, np.array([[0, 128], [255, 64]], np.uint8))
    np.testing.assert_array_equal(np.stack(list(read_wav(path).channels.values())), [[-1, 127 / 128], [0, -0.5]])
    scipy.io.wavfile.write(path, 1000, SAMPLES[0].astype(np.float32))
    np.testing.assert_array_equal(read_wav(path).channels["1"], SAMPLES[0].astype(np.float32))


#: Text of a CSV file that is no recording, and kind and field of the refusal.
NO_CSV: dict[str, tuple[str, Kind, str]] = {
    "empty": ("", Kind.UNREADABLE, ""),
    "ragged": ("time,A\n0,1\n0.1\n", Kind.UNREADABLE, "line 3"),
    "words": ("time,A\n0,1\n0.1,x\n", Kind.WRONG_TYPE, "line 3"),
    "one sample": ("time,A\n0,1\n", Kind.UNSUITABLE, ""),
    "semicolons": ("time;A\n0;1\n", Kind.UNREADABLE, ""),
    "no time": ("reference,A,B\n1,2,3\n", Kind.MISSING, ""),
    "uneven": ("time,A\n0,1\n1,1\n5,1\n", Kind.UNSUITABLE, "time"),
}
#: Arrays of an NPZ file that is no recording, as for the texts above.
NO_NPZ: dict[str, tuple[dict[str, Any], Kind, str]] = {
    "no rate": ({"A": np.ones(9)}, Kind.MISSING, "sample_rate"),
    "a matrix": ({"A": np.ones((9, 9)), "sample_rate": 9.0}, Kind.WRONG_TYPE, "A"),
    "objects": ({"A": np.array(["x"]), "sample_rate": 9.0}, Kind.WRONG_TYPE, "A"),
    "unequal": ({"A": np.ones(9), "B": np.ones(8), "sample_rate": 9.0}, Kind.MISMATCH, ""),
    "rate of zero": ({"A": np.ones(9), "sample_rate": 0.0}, Kind.OUT_OF_RANGE, "sample rate"),
    "two rates": ({"A": np.ones(9), "sample_rate": np.ones(2)}, Kind.WRONG_TYPE, "sample_rate"),
    "no channel": ({"sample_rate": 9.0}, Kind.MISSING, ""),
}


@pytest.mark.parametrize("fault", NO_CSV)
def test_a_csv_file_that_is_no_recording_is_refused_with_the_line(fault: str, tmp_path: Path) -> None:
    text, kind, field = NO_CSV[fault]
    (tmp_path / "given.csv").write_text(text)
    with refused(kind, field, file="given.csv", error=SoundFileError):
        read_sound(tmp_path / "given.csv")


@pytest.mark.parametrize("fault", NO_NPZ)
def test_arrays_that_are_no_recording_are_refused_by_name(fault: str, tmp_path: Path) -> None:
    arrays, kind, field = NO_NPZ[fault]
    np.savez(tmp_path / "given.npz", **arrays)
    with refused(kind, field, file="given.npz", error=SoundFileError):
        read_sound(tmp_path / "given.npz")


def test_messages_of_sound_files_read_well(tmp_path: Path) -> None:
    for fault, (text, _, _) in NO_CSV.items():
        (tmp_path / f"{fault}.csv").write_text(text)
    for fault, (arrays, _, _) in NO_NPZ.items():
        np.savez(tmp_path / f"{fault}.npz", **arrays)
    for fault in ("a length of 4 GB", "a length of nothing", "samples of 4 GB"):  # others are in the words of scipy
        (tmp_path / f"{fault}.wav").write_bytes(with_field(wav(tmp_path / "whole.wav"), *FALSE_FIELDS[fault]))
    (tmp_path / "a.mp3").write_bytes(b"ID3")
    np.savez(tmp_path / "another name.npz", signals=SAMPLES, fs=48000.0)
    files = [path for path in sorted(tmp_path.iterdir()) if path.name != "whole.wav"]
    cases = {path.name: partial(read_sound, path) for path in files}
    check_messages(Path(__file__).with_name("messages.txt"), cases, {f"{tmp_path}/": ""})


def test_a_table_beyond_the_bound_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("acoustic_fem.sound.sound_file.MOST_NUMBERS", 4)
    (tmp_path / "given.csv").write_text("time,A\n0,1\n1,2\n2,3\n")
    with refused(Kind.OUT_OF_RANGE, file="given.csv", error=SoundFileError):
        read_sound(tmp_path / "given.csv")


@pytest.mark.parametrize("suffix", [".wav", ".csv", ".npz", ".mat"])
def test_a_recording_cut_anywhere_is_refused_by_its_name(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"given{suffix}"
    if suffix == ".wav":
        wav(path)
    elif suffix == ".csv":
        path.write_text("time,A\n" + "".join(f"{k / 100},{k}\n" for k in range(30)))
    elif suffix == ".npz":
        np.savez(path, sample_rate=1000.0, A=SAMPLES[0])
    else:
        scipy.io.savemat(path, {"sample_rate": 1000.0, "A": SAMPLES[0]}, do_compression=True)
    whole = path.read_bytes()
    said = []
    for size in range(0, len(whole), max(1, len(whole) // 40)):
        path.write_bytes(whole[:size])
        try:
            read_sound(path)
        except SoundFileError as error:
            said.append(str(error))
    assert len(said) >= (2 if suffix == ".csv" else 40)
    assert all(line.startswith(f"{path}: ") for line in said)


@pytest.mark.parametrize("name", ["rate", "fs", "Fs", "samplerate", "sampling_rate"])
def test_a_rate_by_another_name_is_refused_not_read_over(tmp_path: Path, name: str) -> None:
    path = tmp_path / "one.npz"
    np.savez(path, signals=SAMPLES, **{name: 48000.0})
    with refused(Kind.UNKNOWN, name, file=path, error=SoundFileError):
        read_sound(path, 1000.0)
