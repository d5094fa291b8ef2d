"""Recorded touches: split by recording, refused by name, drawn the same whatever was drawn before."""

import hashlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from hypothesis import given, settings, strategies as st
from rc_line import rc_line
from refusals import refused

import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from localize.learned.checkpoint import CheckpointError
from localize.learned.recorded_frames import RecordedFrames
from localize.live import AS_IT_COMES
from localize.recordings.touch_manifest import PARTS, read_touch_manifest, split

NOISE = 1e-2
POINTS = 4
PLAN = localize.TrainingPlan(seconds_per_point=16, epochs=3, batch=16, seed=3, microphone_noise=NOISE)

groups = st.dictionaries(
    st.tuples(st.integers(1, 6), st.sampled_from(PARTS)), st.integers(1, 12), min_size=1, max_size=12
)


def listed(counts):
    return [(point, part, f"{point}-{part}-{k}.wav") for (point, part), n in counts.items() for k in range(n)]


@given(counts=groups, seed=st.integers(0, 2**32), order=st.randoms())
def test_no_recording_is_on_both_sides_and_every_point_keeps_one_to_train_on(counts, seed, order) -> None:
    recordings = listed(counts)
    held = split(recordings, seed)
    assert len(held) == len(recordings)  # one side each
    for (point, part), count in counts.items():
        own = [h for each, h in zip(recordings, held, strict=True) if each[:2] == (point, part)]
        assert sum(own) == (0 if count == 1 else max(1, round(0.2 * count)))
        assert not all(own)
    assert {each[0] for each, h in zip(recordings, held, strict=True) if not h} == {point for point, _ in counts}
    # the same seed is the same split, in any order and with or without the recordings of other points
    shuffled = order.sample(recordings, len(recordings))
    again = dict(zip(shuffled, split(shuffled, seed), strict=True))
    assert [again[each] for each in recordings] == list(held)
    first = [each for each in recordings if each[0] == recordings[0][0]]
    assert split(first, seed) == tuple(h for each, h in zip(recordings, held, strict=True) if each[0] == first[0][0])


def test_another_seed_is_another_split() -> None:
    recordings = listed({(1, "taps"): 10})
    assert len({split(recordings, seed) for seed in range(20)}) > 5


@pytest.fixture(scope="module")
def array():
    return rc_line(POINTS)


def recorded(folder: Path, array, takes=3, parts=("taps", "random-1-10")) -> Path:
    """Two seconds of quiet with a second of touch in them, for each take; every sample tells its recording."""
    made = localize.TouchGenerator(array, 9, "evaluation", 0.0).samples(0, 400).signals.double().numpy()
    random, number = np.random.default_rng(1), 0
    lines = ["full_scale = 4.0"]
    for point in range(1, array.point_count + 1):
        own = made[point - 1 :: array.point_count]
        loud = iter(np.argsort(-own.std(-1).max(1)))
        for part in parts:
            for take in range(takes):
                signals = NOISE * random.standard_normal((2, 2000))
                signals[:, 500:1500] += own[next(loud)]
                name = f"{point}-{part}-{take}.wav"
                write_wav(folder / name, signals / 4, 1000, 32)
                lines += ["[[recordings]]", f'file = "{name}"', f"point = {point}", f'part = "{part}"']
                number += 1
    (folder / "touches.toml").write_text("\n".join(lines))
    return folder / "touches.toml"


@pytest.fixture(scope="module")
def manifest(array, tmp_path_factory):
    return recorded(tmp_path_factory.mktemp("touches"), array)


@pytest.fixture(scope="module")
def frames(array, manifest):
    return RecordedFrames(manifest, array, NOISE, 0)


def test_frames_are_those_that_a_stream_hears_of_the_recordings_of_their_side(array, manifest, frames) -> None:
    found = read_touch_manifest(manifest, POINTS)
    decoder = localize.BayesDecoder(array, NOISE)
    sides = {False: {}, True: {}}
    for each, held in zip(found.recordings, frames.held_out, strict=True):
        heard = localize.read_recording(each.path, array.microphones, 4.0).signals
        for event in localize.TouchStream(decoder, options=AS_IT_COMES).push(heard):
            if event.state == "touch":
                end = round(event.time * 1000)
                key = heard[:, end - 250 : end].astype(np.float32).tobytes()
                sides[held][key] = (each.point - 1, each.part)
    assert not sides[False].keys() & sides[True].keys()
    assert sum(entry["frames"] for entry in frames.to_dict()["training"]) == len(sides[False])
    drawn, point = frames.samples(0, 4000)
    rounds = point.reshape(-1, POINTS)
    assert torch.equal(rounds.sort(1).values, torch.arange(POINTS).expand_as(rounds))
    assert len(torch.unique(rounds, dim=0)) > 2
    keys = [frame.numpy().tobytes() for frame in drawn]
    assert all(sides[False][key][0] == own for key, own in zip(keys, point.tolist(), strict=True))
    # nearly all of them are drawn, the parts equally often
    assert len(set(keys)) > 0.95 * len(sides[False])
    assert sum(sides[False][key][1] == "taps" for key in keys) == pytest.approx(2000, abs=150)
    judged = {frame.numpy().tobytes() for frame in frames.judged_frames}
    assert judged <= sides[True].keys()
    assert len(judged) == sum(min(64, entry["frames"]) for entry in frames.to_dict()["held_out"])


@settings(max_examples=20)
@given(start=st.integers(0, 10**9), count=st.integers(1, 40), skip=st.integers(0, 20))
def test_any_sample_can_be_drawn_alone(frames, start, count, skip) -> None:
    whole, point = frames.samples(start, skip + count)
    part, own = frames.samples(start + skip, count)
    assert torch.equal(whole[skip:], part)
    assert torch.equal(point[skip:], own)


def test_a_decoder_is_judged_by_part(array, frames) -> None:
    found = frames.judge(localize.BayesDecoder(array, NOISE))
    assert set(found) == {"random-1-10", "taps"}
    for each in found.values():
        assert each.top1 > 0.8
        assert each.recordings == POINTS
    assert sum(each.frames for each in found.values()) == len(frames.judged_frames)


def entry(file="a.wav", point=1, part="taps"):
    return f'[[recordings]]\nfile = "{file}"\npoint = {point}\npart = "{part}"\n'


FOUR = "".join(entry(f"{k}.wav", k) for k in range(1, 5))


@pytest.mark.parametrize(
    ("text", "kind", "field", "file"),
    [
        ("x", Kind.UNREADABLE, "", "touches.toml"),
        ("", Kind.MISSING, "recordings", "touches.toml"),
        ("recordings = []", Kind.OUT_OF_RANGE, "recordings", "touches.toml"),
        (entry(part="knocks"), Kind.OUT_OF_RANGE, "recordings.0.part", "touches.toml"),
        (entry() + entry("b.wav", 0), Kind.OUT_OF_RANGE, "recordings.1.point", "touches.toml"),
        (FOUR + entry("5.wav", 5), Kind.OUT_OF_RANGE, "recordings.4.point", "touches.toml"),
        ("full_scale = 0.0\n" + FOUR, Kind.OUT_OF_RANGE, "full_scale", "touches.toml"),
        ("volume = 1\n" + FOUR, Kind.UNKNOWN, "volume", "touches.toml"),
        (FOUR + entry("nowhere.wav"), Kind.MISSING, "", "nowhere.wav"),
        (FOUR + entry("1.wav", 2), Kind.CONFLICT, "", "touches.toml"),
        (FOUR + entry("copy.wav", 1), Kind.CONFLICT, "", "touches.toml"),
        (entry("1.wav", 1) + entry("3.wav", 3), Kind.MISSING, "", "touches.toml"),
        (FOUR, Kind.UNSUITABLE, "", "touches.toml"),
        (FOUR + entry("quiet.wav", 2), Kind.UNSUITABLE, "", "quiet.wav"),
        (FOUR + entry("clipped.wav", 2), Kind.UNSUITABLE, "", "clipped.wav"),
    ],
)
def test_a_manifest_that_cannot_be_used_is_refused_by_name(array, tmp_path, text, kind, field, file) -> None:
    random = np.random.default_rng(0)
    for name in ("1", "2", "3", "4", "5", "quiet", "clipped"):
        level = {"quiet": 0.5 * NOISE, "clipped": 1.0}.get(name, 0.05)
        write_wav(tmp_path / f"{name}.wav", level * random.standard_normal((2, 1000)), 1000)
    (tmp_path / "copy.wav").write_bytes((tmp_path / "1.wav").read_bytes())
    (tmp_path / "touches.toml").write_text(text)
    with refused(kind, field, file=file):
        RecordedFrames(tmp_path / "touches.toml", array, NOISE, 0)


def weights(localizer):
    return localizer.classifier.state_dict()


def same(one, other):
    return all(torch.equal(value, other[name]) for name, value in one.items())


class Stop(Exception):
    """Raised where a process might be killed."""


@pytest.mark.slow
@pytest.mark.parametrize("step", [2, 7])
def test_a_training_with_recordings_goes_on_bit_for_bit(array, manifest, tmp_path, monkeypatch, step) -> None:
    whole = localize.train(array, PLAN, recordings=manifest)
    drawn = RecordedFrames.samples

    def failing(self, start, count):
        if start == step * count:
            raise Stop
        return drawn(self, start, count)

    path = tmp_path / "checkpoint.safetensors"
    with monkeypatch.context() as patch:
        patch.setattr(RecordedFrames, "samples", failing)
        with pytest.raises(Stop):
            localize.train(array, replace(PLAN, checkpoint_interval=0.0), checkpoint=path, recordings=manifest)
    again = localize.train(array, PLAN, checkpoint=path, recordings=manifest)
    assert same(weights(whole), weights(again))
    for name in ("loss", "held_out_accuracy", "recorded_accuracy", "held_out_recordings", "recordings"):
        assert again.training[name] == whole.training[name]


def test_a_training_on_recordings_that_have_changed_is_refused_by_name(array, tmp_path) -> None:
    manifest, path = recorded(tmp_path, array, takes=2, parts=("taps",)), tmp_path / "checkpoint.safetensors"
    localize.train(array, PLAN, checkpoint=path, recordings=manifest)
    localize.train(array, PLAN, checkpoint=path, recordings=manifest)
    wav = tmp_path / "2-taps-1.wav"
    content = bytearray(wav.read_bytes())
    content[-5] ^= 1
    wav.write_bytes(bytes(content))
    with pytest.raises(CheckpointError, match=r"recording 2-taps-1\.wav"):
        localize.train(array, PLAN, checkpoint=path, recordings=manifest)
    with pytest.raises(CheckpointError, match=r"recording 1-taps-0\.wav"):
        localize.train(array, PLAN, checkpoint=path)


def test_the_localizer_keeps_the_split_and_how_the_held_out_recordings_are_named(array, manifest, tmp_path) -> None:
    localizer = localize.train(array, PLAN, recordings=manifest)
    localizer.save(tmp_path / "kept")
    kept = localize.load_localizer(tmp_path / "kept").training
    frames = RecordedFrames(manifest, array, NOISE, PLAN.seed)
    assert kept["recordings"] == frames.to_dict()
    for each in kept["recordings"]["training"] + kept["recordings"]["held_out"]:
        assert each["sha256"] == hashlib.sha256((manifest.parent / each["file"]).read_bytes()).hexdigest()
    judged = frames.judge(localize.load_localizer(tmp_path / "kept"))
    assert {part: found["top1"] for part, found in kept["held_out_recordings"].items()} == pytest.approx(
        {part: found.top1 for part, found in judged.items()}, abs=0.01
    )
    assert kept["recorded_accuracy"][-1] == {part: found["top1"] for part, found in kept["held_out_recordings"].items()}
    assert len(kept["recorded_accuracy"]) == PLAN.epochs


def test_without_recordings_nothing_of_them_is_drawn_or_kept(array) -> None:
    plain = localize.train(array, PLAN)
    assert "recordings" not in plain.training
    with refused(Kind.OUT_OF_RANGE, "recorded", 1.5):
        localize.TrainingPlan(recorded=1.5)
