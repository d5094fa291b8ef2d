"""Recordings as files: what a file states and does not hold is refused, and none takes more memory than is stated."""

from __future__ import annotations

import struct
import warnings
from functools import partial
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import scipy.io
import scipy.io.wavfile
from refusals import check_messages, refused

from acoustic_fem.sound.sound_file import SoundFileError, SoundFileWarning, read_sound, read_wav, write_wav
from geometry.ground.extras import MissingExtra
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
    "no channels": (22, "<H", 0),
    "block align 0": (32, "<H", 0),
    "block align 40000": (32, "<H", 40_000),
    "rate 0": (24, "<I", 0),
    "a format of its own": (20, "<H", 85),
    "twice the samples": (40, "<I", 400),
    "a head of 4 GB": (16, "<I", 2**32 - 1),
}
#: The same of files whose samples are all there, however wrong the header is.
UNTRUE_FIELDS = {
    "a length of 4 GB": (4, "<I", 2**32 - 1),
    "a length of eight bytes too many": (4, "<I", 244),
    "a stream of FFmpeg": (40, "<I", 2**32 - 1),
    "a stream of arecord": (40, "<I", 0x7FFFF000),
    "a stream of no length": (40, "<I", 0),
    "half of the samples": (40, "<I", 100),
}


@pytest.mark.parametrize("fault", FALSE_FIELDS)
def test_a_wav_file_that_states_what_it_does_not_hold_is_refused(fault: str, tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    path.write_bytes(with_field(wav(path), *FALSE_FIELDS[fault]))
    with refused(Kind.UNREADABLE, file=path, error=SoundFileError):
        read_wav(path)


@pytest.mark.parametrize("fault", UNTRUE_FIELDS)
def test_samples_are_read_whole_with_a_note_where_the_header_is_not_true(fault: str, tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    path.write_bytes(with_field(wav(path), *UNTRUE_FIELDS[fault]))
    with pytest.warns(SoundFileWarning) as told:
        found = read_wav(path)
    assert len(told) == 1
    np.testing.assert_allclose(np.stack(list(found.channels.values())), SAMPLES, atol=2.0**-16)


def chunks(*parts: tuple[bytes, bytes], pad: bool = True, magic: bytes = b"RIFF") -> bytes:
    """A WAV file of chunks with their names; after the format of two channels of 16 bits at 1 kHz."""
    form = struct.pack("<HHIIHH", 1, 2, 1000, 4000, 4, 16)
    body = b""
    for name, content in ((b"fmt ", form), *parts):
        body += name + struct.pack("<I", len(content)) + content + (b"\0" if pad and len(content) % 2 else b"")
    return magic + struct.pack("<I", 4 + len(body)) + b"WAVE" + body


RAW = np.rint(SAMPLES.T * 2**15).astype("<i2").tobytes()
#: Bytes of a file, and whether a note is due; all hold the same samples.
LAYOUTS = {
    "two chunks of samples": (chunks((b"data", RAW[:80]), (b"data", RAW[80:])), True),
    "an odd chunk with its pad byte": (chunks((b"LIST", b"INFOx"), (b"data", RAW)), False),
    "an odd chunk without a pad byte": (chunks((b"LIST", b"INFOx"), (b"data", RAW), pad=False), True),
    "remarks behind the samples": (chunks((b"data", RAW), (b"LIST", b"INFOISFT\0\0\0\0")), False),
    "a remark that is cut off": (chunks((b"data", RAW), (b"id3 ", b"x" * 40))[:-20], True),
    "half of a sample at the end": (chunks((b"data", RAW + b"\1\2")), True),
    "room that was not used": (chunks((b"data", RAW)) + bytes(4000), False),
    "a title of the old kind": (chunks((b"data", RAW)) + b"TAG" + b"x" * 125, False),
    "BW64": (
        b"BW64\xff\xff\xff\xffWAVE"
        + b"ds64" + struct.pack("<IQQQI", 28, 72 + len(RAW), len(RAW), 50, 0)
        + chunks((b"data", RAW))[12:].replace(b"data" + struct.pack("<I", len(RAW)), b"data\xff\xff\xff\xff"),
        False,
    ),
}  # fmt: skip


@pytest.mark.parametrize("layout", LAYOUTS)
def test_samples_are_found_in_the_layouts_of_all_recorders(layout: str, tmp_path: Path) -> None:
    content, noted = LAYOUTS[layout]
    (tmp_path / "given.wav").write_bytes(content)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = read_wav(tmp_path / "given.wav")
    assert bool(told) == noted, [str(each.message) for each in told]
    np.testing.assert_allclose(np.stack(list(found.channels.values())), SAMPLES, atol=2.0**-16)


@pytest.mark.parametrize(("name", "subtype"), [("a.flac", "PCM_24"), ("a.aiff", "PCM_16"), ("a.AIF", "PCM_24")])
def test_flac_and_aiff_hold_what_wav_does(name: str, subtype: str, tmp_path: Path) -> None:
    soundfile = pytest.importorskip("soundfile")
    soundfile.write(tmp_path / name, SAMPLES.T, 8000, subtype, format="FLAC" if "flac" in name else "AIFF")
    found = read_sound(tmp_path / name)
    assert (found.rate, found.numbered) == (8000.0, True)
    assert found.full_scale == 1 - 2.0 ** (1 - int(subtype[-2:]))
    np.testing.assert_allclose(np.stack(list(found.channels.values())), SAMPLES, atol=2.0**-15)
    (tmp_path / "not.flac").write_bytes(b"fLaC" + bytes(100))
    with refused(Kind.UNREADABLE, file="not.flac", error=SoundFileError):
        read_sound(tmp_path / "not.flac")


def test_the_extra_for_flac_is_named_where_it_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.flac").write_bytes(b"fLaC")
    monkeypatch.setattr("geometry.ground.extras.find_spec", lambda name: None)
    with refused(Kind.NOT_INSTALLED, error=MissingExtra) as found:
        read_sound(tmp_path / "a.flac")
    assert "[audio]" in str(found.value)


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
    "commas twice": ("time,A\n0,0,1,5\n0,1,2,5\n", Kind.UNREADABLE, "line 2"),
    "points and commas": ("time;A\n0;1.5\n0,1;2\n", Kind.WRONG_TYPE, "line 3"),
    "thousands": ("time;A\n0;1.234,5\n1;2\n", Kind.WRONG_TYPE, "line 2"),
    "a line below": ("time,A\n0,0.1_0\n1,2\n", Kind.WRONG_TYPE, "line 2"),
    "digits of another script": ("time,A\n0,\u0661\n1,2\n", Kind.WRONG_TYPE, "line 2"),
    "blanks": ("time A\n0 1\n1 2\n", Kind.UNREADABLE, "line 1"),
    "a column without a name": ("time,A,\n0,1,2\n1,2,3\n", Kind.UNREADABLE, ""),
    "a value that is missing": ("time,A\n0,\n1,2\n", Kind.WRONG_TYPE, "line 2"),
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


#: Tables as other programs write them, all with the same values.
TABLES = {
    "tabs and points": b"time\tA\tB\n0\t1\t0.5\n0.001\t-2\t1.5\n",
    "tabs and commas": b"time\tA\tB\r\n0,0\t1,0\t0,5\r\n0,001\t-2,0\t1,5\r\n",
    "semicolons and commas": b"time;A;B\n0;1;0,5\n0,001;-2;1,5\n",
    "commas in quotes": b'time,A,B\n0,1,"0,5"\n"0,001",-2,"1,5"\n',
    "a stated separator": b"sep=,\r\ntime,A,B\r\n0,1,0.5\r\n0.001,-2,1.5\r\n",
    "a stated separator in quotes": b'"sep=;"\r\ntime;A;B\r\n0;1;0.5\r\n0.001;-2;1.5\r\n',
    "a strange separator": b"SEP=|\ntime|A|B\n0|1|0.5\n0.001|-2|1.5\n",
    "remarks": b"# my board\n#100 Pa\n\ntime,A,B\n0,1,0.5\n# pause\n0.001,-2,1.5\n",
    "UTF-16": "time,A,B\n0,1,0.5\n0.001,-2,1.5\n".encode("utf-16"),
    "UTF-16 without a mark, little end": "time,A,B\n0,1,0.5\n0.001,-2,1.5\n".encode("utf-16-le"),
    "UTF-16 without a mark, big end": "time,A,B\n0,1,0.5\n0.001,-2,1.5\n".encode("utf-16-be"),
    "a byte order mark": b"\xef\xbb\xbftime,A,B\n0,1,0.5\n0.001,-2,1.5\n",
    "blank columns": b"time,,A,B,,\n0,,1,0.5,,\n0.001,,-2,1.5\n,,,,,\n".replace(b"-2,1.5\n", b"-2,1.5,,\n"),
    "blank ends": b"time,A,B\n0,1,0.5,\n0.001,-2,1.5,,\n\n",
    "blanks around": b"time, A , B\n 0, 1,  0.5\n0.001 ,-2, 1.5 \n",
}


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize("suffix", [".csv", ".txt"])
def test_tables_of_other_programs_are_read(table: str, suffix: str, tmp_path: Path) -> None:
    (tmp_path / f"given{suffix}").write_bytes(TABLES[table])
    found = read_sound(tmp_path / f"given{suffix}")
    assert found.rate == pytest.approx(1000.0)
    assert {name: values.tolist() for name, values in found.channels.items()} == {"A": [1.0, -2.0], "B": [0.5, 1.5]}


def test_a_rate_that_is_assumed_is_told(tmp_path: Path) -> None:
    (tmp_path / "given.csv").write_text("A,B\n1,2\n2,3\n")
    np.savez(tmp_path / "given.npz", signals=SAMPLES)
    for name in ("given.csv", "given.npz"):
        with pytest.warns(SoundFileWarning, match="1000 Hz is assumed"):
            assert read_sound(tmp_path / name, 1000.0).rate == 1000.0


def test_mat_files_of_version_7_3_are_read_as_matlab_shows_them(tmp_path: Path) -> None:
    path = tmp_path / "given.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        file["signals"] = SAMPLES.T  # MATLAB counts along columns first
        file["sample_rate"] = [[8000.0]]
        file["title"] = np.array([[72], [105]], np.uint16)
        file["title"].attrs["MATLAB_class"] = np.bytes_("char")
        file.create_group("settings")
    with path.open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(124) + b"\0\2IM")
    found = read_sound(path)
    assert (found.rate, found.numbered) == (8000.0, True)
    np.testing.assert_array_equal(np.stack(list(found.channels.values())), SAMPLES)
    content = path.read_bytes()
    path.write_bytes(content[: len(content) // 2])
    with refused(Kind.UNREADABLE, file=path, error=SoundFileError):
        read_sound(path)


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
    for fault in ("twice the samples",):  # others are in the words of scipy
        (tmp_path / f"{fault}.wav").write_bytes(with_field(wav(tmp_path / "whole.wav"), *FALSE_FIELDS[fault]))
    (tmp_path / "a.mp3").write_bytes(b"ID3")
    np.savez(tmp_path / "another name.npz", signals=SAMPLES, fs=48000.0)
    files = [path for path in sorted(tmp_path.iterdir()) if path.name != "whole.wav"]
    cases = {path.name: partial(read_sound, path) for path in files}
    check_messages(Path(__file__).with_name("messages.txt"), cases, {f"{tmp_path}/": ""})


def test_a_table_beyond_the_bound_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("acoustic_fem.sound.recorded_table.MOST_NUMBERS", 4)
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


@pytest.mark.parametrize("behind", [b"\xff" * 97, b"LIST\x1a\0\0\0INFO cut off", bytes(range(1, 60))])
def test_a_few_bytes_behind_the_samples_are_no_samples(behind: bytes, tmp_path: Path) -> None:
    path = tmp_path / "given.wav"
    write_wav(path, np.full((2, 2000), 0.25), 8000)
    with path.open("ab") as end:
        end.write(behind)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SoundFileWarning)
        found = read_wav(path)
    assert {len(each) for each in found.channels.values()} == {2000}
