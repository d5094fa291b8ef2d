"""Recordings of one take are known by their signals, whatever was done to the file; different takes are told apart."""

import numpy as np
import pytest
import scipy.signal
from hypothesis import given, settings, strategies as st
from refusals import refused
from small_run import small_design

from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from geometry.design.design_file import write_design
from localize.learned.recorded_frames import RecordedFrames
from localize.recordings.recording import read_recording
from localize.recordings.same_take import LEAST_TOUCHED, find_same_take
from localize.recordings.touch_manifest import PARTS, TouchManifestError
from localize.signals.array_response import ArrayResponse
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

FULL_SCALE = 2.0
NOISE = 1e-3
MANIPULATED = {
    "without its first sample": lambda x: x[:, 1:],
    "without one in its middle": lambda x: np.delete(x, x.shape[1] // 2, axis=1),
    "half a second later": lambda x: x[:, 500:],
    "its first half": lambda x: x[:, : x.shape[1] // 2],
    "its second half": lambda x: x[:, x.shape[1] // 2 :],
    "half as loud": lambda x: 0.5 * x,
    "upside down": lambda x: -x,
}


@pytest.fixture(scope="module")
def rig():
    return Rig(small_design(), 4, HiddenScatter(batch=0.0, modulus=0.8), fidelity="lumped")


@pytest.fixture(scope="module")
def manifest(rig, tmp_path_factory):
    folder = tmp_path_factory.mktemp("takes")
    return record_touches(rig, folder, (1, 2, 3), TouchSession(takes=3), Recorder(hum=5e-4, drift=1e-3))


@pytest.fixture(scope="module")
def response(rig):
    frequency = np.arange(1.0, 161.0)
    return ArrayResponse(
        transfer_function=rig.transfer_function(frequency),
        frequency=frequency,
        line=np.zeros(3, np.int64),
        place=np.arange(3),
        microphones=rig.design.microphones,
        name="rig",
        provenance={"design": write_design(rig.design)},
    )


def pascals(manifest, rig, name):
    return read_recording(manifest.parent / name, rig.design.microphones, FULL_SCALE).signals


def added(manifest, name, point, part):
    """The manifest with one more recording."""
    path = manifest.parent / f"with-{name}.toml"
    entry = f'\n[[recordings]]\nfile = "{name}"\npoint = {point}\npart = "{part}"\n'
    path.write_text(manifest.read_text() + entry)
    return path


@pytest.mark.slow
def test_takes_of_all_parts_and_points_are_told_apart(manifest, response) -> None:
    assert len(RecordedFrames(manifest, response, NOISE, 0).recordings) == 36


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("how", MANIPULATED)
def test_a_take_is_known_by_its_signals(manifest, rig, how, part) -> None:
    take, other = (pascals(manifest, rig, f"point-02-{part}-{k}.wav") for k in (1, 2))
    copy = np.round(MANIPULATED[how](take) / FULL_SCALE * 2**15) / 2**15 * FULL_SCALE
    recordings = [each.astype(np.float32) for each in (other, take, copy)]
    found = find_same_take(recordings, [everywhere(each) for each in recordings])
    assert found is not None
    assert (found.first, found.second) == (1, 2)
    assert found.correlation > 0.995
    assert find_same_take(recordings[:2], [everywhere(each) for each in recordings[:2]]) is None


def everywhere(signals):
    return np.arange(0, signals.shape[1] - 249, 16)


@pytest.mark.parametrize(
    ("name", "rate", "bits", "point"),
    [("24-bit.wav", 1000, 24, 2), ("compact-disc.wav", 44100, 16, 3)],
)
@pytest.mark.slow
def test_a_copy_of_another_format_is_refused_at_every_point(manifest, rig, response, name, rate, bits, point) -> None:
    take = pascals(manifest, rig, "point-02-taps-2.wav")
    write_wav(manifest.parent / name, scipy.signal.resample_poly(take, rate // 100, 10, axis=1) / 4, rate, bits)
    with refused(Kind.CONFLICT, file=f"with-{name}.toml", error=TouchManifestError) as found:
        RecordedFrames(added(manifest, name, point, "taps"), response, NOISE, 0)
    assert f"{name} is the same take as point-02-taps-2.wav" in str(found.value)


def touches(seed, seconds=12):
    """Noise of 2 to 60 Hz in two microphones, a little of their own in each."""
    random = np.random.default_rng(seed)
    sos = scipy.signal.butter(2, (2.0, 60.0), "bandpass", fs=1000, output="sos")
    common = scipy.signal.sosfilt(sos, random.standard_normal(1000 * seconds))
    return np.array([[0.3], [0.1]]) * common + 1e-3 * random.standard_normal((2, 1000 * seconds))


@settings(max_examples=30)
@given(
    start=st.integers(0, 20_000),
    length=st.integers(LEAST_TOUCHED + 100, 30_000),
    gain=st.floats(1e-3, 1e3),
    sign=st.sampled_from([-1, 1]),
    offset=st.floats(-1, 1),
)
def test_any_stretch_of_a_take_is_found_at_any_gain(start, length, gain, sign, offset) -> None:
    take = touches(0, seconds=30)
    piece = sign * gain * (take[:, start : start + length] + offset)
    recordings = [each.astype(np.float32) for each in (take, touches(1), piece)]
    found = find_same_take(recordings, [everywhere(each) for each in recordings])
    assert found is not None
    assert (found.first, found.second) == (0, 2)


def test_silence_is_not_alike_and_not_divided_by() -> None:
    def padded(signals):
        return np.concatenate([np.zeros((2, 5000)), signals, np.zeros((2, 5000))], axis=1).astype(np.float32)

    one, other, copy = padded(touches(2)), padded(touches(3)), padded(touches(2)[:, 2000:])
    touched = [np.arange(5000, each.shape[1] - 5250, 16) for each in (one, other, copy)]
    with np.errstate(all="raise"):
        assert find_same_take([one, other], touched[:2]) is None
        found = find_same_take([one, other, copy], touched)
    assert found is not None
    assert (found.first, found.second) == (0, 2)


def test_one_tap_each_is_too_little_to_tell() -> None:
    time = np.arange(4000) / 1000
    tap = np.exp(-(((time - 1) / 0.02) ** 2))
    recordings = [np.stack([g * tap, g * tap]).astype(np.float32) for g in (0.3, 0.2)]
    frames = [np.arange(700, 1000, 16)] * 2  # they cover half a second
    assert find_same_take(recordings, frames) is None
    long = [np.arange(700, 700 + LEAST_TOUCHED - 250 + 16, 16)] * 2
    assert find_same_take(recordings, long) is not None
