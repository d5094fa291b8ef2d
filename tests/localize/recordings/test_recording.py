"""Recordings come in at 1 kHz in pascals; bad ones are refused with the name of what is wrong."""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import numpy as np
import pytest
import scipy.io
import scipy.io.wavfile
from refusals import check_messages, refused

from geometry import Kind
from localize import RecordingError, read_recording
from localize.recordings.recording import RecordingWarning

NAMES = ("left", "right")


def tones(rate, seconds=1.0):
    """(2, n): 20 Hz and 90 Hz, at most half of full scale."""
    time = np.arange(round(rate * seconds)) / rate
    return 0.5 * np.stack([np.sin(2 * np.pi * 20 * time), np.cos(2 * np.pi * 90 * time)])


def wav(path, samples, rate=1000):
    scipy.io.wavfile.write(path, rate, samples.T)
    return path


@pytest.mark.parametrize(("dtype", "scale", "step"), [
    ("float32", 1, 1e-6), ("float64", 1, 1e-9), ("int16", 2**15, 1e-4), ("int32", 2**31, 1e-8), ("uint8", 2**7, 1e-2)
])  # fmt: skip
def test_every_sample_format_of_a_wav_file_gives_the_same_pascals(tmp_path, dtype, scale, step):
    samples = tones(1000) * scale + (128 if dtype == "uint8" else 0)
    path = wav(tmp_path / "a.wav", (samples.round() if scale > 1 else samples).astype(dtype))
    heard = read_recording(path, NAMES)
    assert heard.signals == pytest.approx(tones(1000), abs=step)
    assert (heard.rate, heard.seconds) == (1000, 1.0)
    assert read_recording(path, NAMES, full_scale=20.0).signals == pytest.approx(20 * heard.signals)


@pytest.mark.parametrize("rate", [250, 800, 2000, 8000, 44100, 48000])
def test_other_rates_become_1_khz(tmp_path, rate):
    path = tmp_path / "a.npz"
    inside = slice(100, -100)
    samples = tones(rate)
    np.savez(path, signals=samples, sample_rate=rate)
    found = read_recording(path, NAMES).signals
    assert found.shape == (2, 1000)
    channels = slice(None) if rate > 250 else slice(1)  # 90 Hz is close to half of 250 Hz
    assert found[channels, inside] == pytest.approx(tones(1000)[channels, inside], abs=0.01)


def test_columns_are_found_by_name_and_the_time_column_gives_the_rate(tmp_path):
    time, (left, right) = np.arange(2000) / 2000, tones(2000)
    text = "right,time,left\n" + "".join(f"{b!r},{t!r},{a!r}\n" for t, a, b in zip(
        time.tolist(), left.tolist(), right.tolist(), strict=True))  # fmt: skip
    (tmp_path / "a.csv").write_text(text)
    heard = read_recording(tmp_path / "a.csv", NAMES)
    assert heard.rate == pytest.approx(2000)
    assert heard.signals[:, 100:-100] == pytest.approx(tones(1000)[:, 100:-100], abs=1e-2)
    (tmp_path / "b.csv").write_text("left,right\n" + "".join(f"{k % 7},{k % 5}\n" for k in range(300)))
    assert read_recording(tmp_path / "b.csv", NAMES).signals[1, :6].tolist() == [0, 1, 2, 3, 4, 0]


@pytest.mark.parametrize("suffix", [".npz", ".mat"])
def test_arrays_come_as_a_matrix_in_the_order_of_the_design_or_one_per_microphone(tmp_path, suffix):
    left, right = samples = tones(2000)
    save = np.savez if suffix == ".npz" else lambda file, **arrays: scipy.io.savemat(file, arrays)
    save(tmp_path / f"a{suffix}", signals=samples, sample_rate=2000.0, remark="of a matrix only its rows are read")
    save(tmp_path / f"b{suffix}", right=right, left=left, sample_rate=2000.0)
    matrix, named = (read_recording(tmp_path / f"{name}{suffix}", NAMES) for name in "ab")
    assert matrix.rate == named.rate == 2000.0
    assert matrix.signals == pytest.approx(named.signals, abs=0)
    assert matrix.signals[:, 100:-100] == pytest.approx(tones(1000)[:, 100:-100], abs=1e-2)
    save(tmp_path / f"c{suffix}", right=right, left=left)
    assert read_recording(tmp_path / f"c{suffix}", NAMES).signals == pytest.approx(samples, abs=0)  # 1 kHz


def test_microphones_called_by_numbers_are_found_by_name_and_numbered_channels_by_place(tmp_path):
    np.savez(tmp_path / "a.npz", **{"1": tones(1000)[0], "2": tones(1000)[1]})
    np.savez(tmp_path / "b.npz", signals=tones(1000))
    assert read_recording(tmp_path / "a.npz", ("2", "1")).signals == pytest.approx(tones(1000)[::-1], abs=0)
    assert read_recording(tmp_path / "b.npz", ("2", "1")).signals == pytest.approx(tones(1000), abs=0)


def test_a_slow_quiet_signal_in_coarse_steps_is_not_taken_for_clipped(tmp_path):
    coarse = np.round(40 * tones(1000)) / 2**15
    np.savez(tmp_path / "a.npz", signals=coarse)
    assert read_recording(tmp_path / "a.npz", NAMES).signals == pytest.approx(coarse)


def saved(change, rate=1000):
    def write(folder):
        path = folder / "a.npz"
        samples = tones(1000)
        np.savez(path, signals=change(samples), sample_rate=rate)
        return path

    return write


def with_value(channel, index, value):
    def change(samples):
        samples[channel, index] = value
        return samples

    return change


def clipped_wav(folder):
    return wav(folder / "a.wav", np.clip(3 * tones(1000) * 2**15, -(2**15), 2**15 - 1).astype(np.int16))


def short_wav(folder):
    path = wav(folder / "a.wav", tones(1000).astype(np.float32))
    path.write_bytes(path.read_bytes()[:3000])
    return path


def text(name, content):
    def write(folder):
        (folder / name).write_text(content)
        return folder / name

    return write


def short_npz(folder):
    path = saved(lambda samples: samples)(folder)
    path.write_bytes(path.read_bytes()[:3000])
    return path


ROWS = "".join(f"{k % 7},{k % 5}\n" for k in range(300))


BAD = {
    "missing WAV": (lambda folder: folder / "none.wav", Kind.MISSING),
    "missing NPZ": (lambda folder: folder / "none.npz", Kind.MISSING),
    "other suffix": (lambda folder: folder / "a.mp3", Kind.UNREADABLE),
    "too few channels": (saved(lambda s: s[:1]), Kind.MISMATCH),
    "one row": (saved(lambda s: s[0]), Kind.MISMATCH),
    "three dimensions": (saved(lambda s: s[None]), Kind.WRONG_TYPE),
    "too short": (saved(lambda s: s[:, :249]), Kind.UNSUITABLE),
    "slow rate": (saved(lambda s: s, 100), Kind.OUT_OF_RANGE),
    "no rate": (saved(lambda s: s, np.nan), Kind.OUT_OF_RANGE),
    "two rates": (saved(lambda s: s, [1000.0, 1000.0]), Kind.WRONG_TYPE),
    "not finite": (saved(with_value(1, 400, np.nan)), Kind.UNSUITABLE),
    "complex": (saved(lambda s: s + 1j), Kind.WRONG_TYPE),
    "objects": (saved(lambda _: np.array([{}, {}])), Kind.UNREADABLE),
    "silent": (saved(with_value(0, slice(None), 0.3)), Kind.UNSUITABLE),
    "flat tops": (saved(lambda s: np.clip(s, -0.3, 0.3)), Kind.UNSUITABLE),
    "twice one channel": (saved(lambda s: np.stack([s[0], s[0]])), Kind.UNSUITABLE),
    "clipped WAV": (clipped_wav, Kind.UNSUITABLE),
    "short WAV": (short_wav, Kind.UNREADABLE),
    "text WAV": (text("a.wav", "no sound"), Kind.UNREADABLE),
    "empty WAV": (text("a.wav", ""), Kind.UNREADABLE),
    "short NPZ": (short_npz, Kind.UNREADABLE),
    "text NPZ": (text("a.npz", "no numbers"), Kind.UNREADABLE),
    "empty CSV": (text("a.csv", ""), Kind.UNREADABLE),
    "other columns": (text("a.csv", "left,middle\n" + ROWS), Kind.MISMATCH),
    "columns twice": (text("a.csv", "left,right,left\n1,2,3\n2,3,4\n"), Kind.UNREADABLE),
    "semicolons": (text("a.csv", "left;right\n0,1;0.2\n"), Kind.WRONG_TYPE),
    "time alone": (text("a.csv", "time\n0\n1\n"), Kind.UNREADABLE),
    "short row": (text("a.csv", "left,right\n" + ROWS + "1"), Kind.UNREADABLE),
    "no number": (text("a.csv", "left,right\n" + ROWS + "1,x"), Kind.WRONG_TYPE),
    "uneven time": (text("a.csv", "time,left,right\n0,1,2\n0.001,2,3\n0.5,1,1\n"), Kind.UNSUITABLE),
    "falling time": (text("a.csv", "time,left,right\n3,1,2\n2,2,3\n1,1,1\n"), Kind.UNSUITABLE),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_recordings_are_refused_by_name_and_reason(tmp_path, name):
    write, kind = BAD[name]
    path = write(tmp_path)
    with refused(kind, file=path, error=RecordingError):
        read_recording(path, NAMES)


def test_the_wording_of_bad_recordings(tmp_path):
    def case(number, write):
        folder = tmp_path / str(number)
        folder.mkdir()
        return lambda: read_recording(write(folder), NAMES)

    cases = {name: case(number, write) for number, (name, (write, _)) in enumerate(BAD.items())}
    folders = {f"{tmp_path / str(number)}{os.sep}": "" for number in reversed(range(len(BAD)))}
    check_messages(Path(__file__).parent / "messages.txt", cases, folders)


@pytest.mark.parametrize("full_scale", [0.0, -1.0, float("nan"), float("inf")])
def test_a_full_scale_out_of_range_is_refused(tmp_path, full_scale):
    with refused(Kind.OUT_OF_RANGE, "full_scale"):
        read_recording(tmp_path / "a.wav", NAMES, full_scale)


def test_a_given_full_scale_is_where_other_formats_clip(tmp_path):
    np.savez(tmp_path / "a.npz", signals=tones(1000))
    with refused(Kind.UNSUITABLE, error=RecordingError):
        read_recording(tmp_path / "a.npz", NAMES, full_scale=0.5)
    assert read_recording(tmp_path / "a.npz", NAMES, full_scale=0.6).signals.shape == (2, 1000)


@pytest.mark.parametrize("rate", [1000, 8000])
def test_channels_may_be_clipped_for_what_reports_clipped_samples(tmp_path, rate):
    names = ("left", "right", "top")
    time = np.arange(rate) / rate
    whole = 0.3 * np.sin(2 * np.pi * np.array([[5.0], [7.0], [11.0]]) * time + 0.1)
    one, two = whole.copy(), whole.copy()
    one[1] = np.clip(2 * whole[1], -0.4, 0.4)
    two[:2] = np.clip(2 * whole[:2], -0.4, 0.4)
    np.savez(tmp_path / "one.npz", signals=one, sample_rate=rate)
    np.savez(tmp_path / "two.npz", signals=two, sample_rate=rate)
    with refused(Kind.UNSUITABLE, error=RecordingError):
        read_recording(tmp_path / "one.npz", names)
    with refused(Kind.UNSUITABLE, error=RecordingError):
        read_recording(tmp_path / "two.npz", names, fallback=True)
    with pytest.warns(RecordingWarning, match="is clipped at"):
        both = read_recording(tmp_path / "two.npz", names, clipped=True)
    assert (np.abs(both.signals) >= both.limit).any(axis=1).tolist() == [True, True, False]
    with pytest.warns(RecordingWarning, match=r"channel right is clipped at 0\.4 Pa, first at .*; its clipped samples"):
        heard = read_recording(tmp_path / "one.npz", names, clipped=True)
    assert heard.limit is not None
    reached = np.abs(heard.signals) >= heard.limit
    assert not reached[[0, 2]].any()
    over = np.abs(2 * whole[1]) >= 0.4
    expected = np.zeros(1000, bool)
    expected[np.flatnonzero(over) * 1000 // rate] = True
    assert np.array_equal(reached[1], expected)
    np.savez(tmp_path / "whole.npz", signals=whole, sample_rate=rate)
    assert read_recording(tmp_path / "whole.npz", names, clipped=True).limit is None


@pytest.mark.parametrize("what", ["begins 3 s after", "ends 3 s before"])
def test_channels_that_are_not_of_one_time_are_refused(tmp_path, what):
    signals = np.random.default_rng(0).standard_normal((2, 8000))
    signals[1, :3000] = 0.0
    if what.startswith("ends"):
        signals = signals[:, ::-1]
    np.savez(tmp_path / "late.npz", signals=signals)
    with refused(Kind.UNSUITABLE, file="late.npz", error=RecordingError) as found:
        read_recording(tmp_path / "late.npz", ("left", "right"))
    assert f"channel right {what} channel left" in str(found.value)


def test_one_channel_may_be_silent_for_what_goes_on_with_the_others(tmp_path):
    signals = np.random.default_rng(0).standard_normal((3, 8000))
    signals[1, 4000:] = 0.0
    np.savez(tmp_path / "dies.npz", signals=signals)
    with pytest.warns(RecordingWarning, match="channel b ends 4 s before channel a"):
        read_recording(tmp_path / "dies.npz", ("a", "b", "c"), fallback=True)
    signals[1] = 0.0
    np.savez(tmp_path / "dead.npz", signals=signals)
    assert (read_recording(tmp_path / "dead.npz", ("a", "b", "c"), fallback=True).signals[1] == 0).all()
    signals[2] = 0.0
    np.savez(tmp_path / "both.npz", signals=signals)
    with refused(Kind.UNSUITABLE, error=RecordingError):
        read_recording(tmp_path / "both.npz", ("a", "b", "c"), fallback=True)


@pytest.mark.parametrize(("late", "told"), [(300, 0), (700, 1)])
def test_a_channel_that_is_a_little_late_is_told(tmp_path, late, told):
    signals = np.random.default_rng(0).standard_normal((2, 8000))
    signals[1, :late] = 0.0
    np.savez(tmp_path / "late.npz", signals=signals)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert read_recording(tmp_path / "late.npz", ("left", "right")).seconds == 8.0
    notes = [str(each.message) for each in caught if each.category is RecordingWarning]
    assert len(notes) == told
    assert all("late.npz: channel right begins 0.5 s after channel left" in note for note in notes)


@pytest.mark.parametrize(("level", "told"), [(100.0, 0), (1e30, 1)])
def test_a_pressure_that_no_microphone_takes_is_told(tmp_path, level, told):
    np.savez(tmp_path / "loud.npz", signals=level * tones(1000))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        read_recording(tmp_path / "loud.npz", NAMES)
    notes = [str(each.message) for each in caught if each.category is RecordingWarning]
    assert [f"loud.npz: reaches {level / 2:.3g} Pa, more than the 1000 Pa" in note for note in notes] == told * [True]


@pytest.mark.parametrize("kind", ["lost samples", "touches without noise", "quantised silence", "one channel"])
def test_zeros_in_place_of_lost_samples_are_told(tmp_path, kind):
    signals = np.random.default_rng(0).standard_normal((2, 4000))
    if kind == "lost samples":
        signals[:, 1200:1248] = signals[:, 3000:3016] = 0.0
    elif kind == "touches without noise":
        time = np.arange(4000) / 1000
        signals = np.sin(2 * np.pi * time).clip(0) ** 2 * np.sin(40 * np.pi * time) * [[1.0], [0.7]]
    elif kind == "quantised silence":
        signals = np.where(np.arange(4000) % 1000 < 30, signals, np.round(0.12 * signals))
    else:
        signals[0, 1200:1248] = 0.0
    np.savez(tmp_path / "take.npz", signals=signals)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        read_recording(tmp_path / "take.npz", NAMES)
    notes = [str(each.message) for each in caught if each.category is RecordingWarning]
    assert len(notes) == (kind == "lost samples"), notes
    assert all("2 gaps, 0.064 s in all, the first at 1.200 s" in note for note in notes)


def test_channels_that_are_quiet_now_and_then_are_of_one_time(tmp_path):
    signals = np.random.default_rng(0).standard_normal((2, 8000))
    signals[1, :3000] = signals[1, 4000:6000] = 0.0  # below the steps of the format until it is touched
    np.savez(tmp_path / "quiet.npz", signals=signals)
    assert read_recording(tmp_path / "quiet.npz", ("left", "right")).seconds == 8.0
    signals = np.random.default_rng(0).standard_normal((2, 8000))
    signals[1, :800] = 0.0
    np.savez(tmp_path / "quiet.npz", signals=signals)
    assert read_recording(tmp_path / "quiet.npz", ("left", "right")).seconds == 8.0
