"""A recognizer learns, goes on where it was killed, survives its files, and refuses what is not its own."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import refused
from shared import solved

import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from localize.decoders.reconstruct import Reconstructor
from localize.learned.checkpoint import CheckpointError
from localize.recognition.event_kinds import event_pressure
from localize.recognition.filter_bank import FilterBank
from localize.recognition.recorded_takes import Stretch, cut, stretches
from localize.recognition.takes import TakeMaker, simulated_signals
from localize.recordings.touch_manifest import TouchManifestError, read_labelled_manifest
from localize.signals import response_of

ARRAY = rc_line(3, np.arange(1.0, 501.0, 2.0))
PLAN = localize.RecognitionPlan(takes=12, epochs=5, batch=16, microphone_noise=1e-3, seed=3)
TINY = replace(PLAN, takes=5, epochs=3, batch=20)


@pytest.fixture(scope="module")
def trained():
    return localize.train_recognizer(ARRAY, "events", PLAN)


def test_twelve_events_are_learnt_from_a_few_takes(trained) -> None:
    maps, kind = TakeMaker("events", Reconstructor(ARRAY, 1e-3), (ARRAY,), 9, 1e-3).maps("evaluation", 48)
    assert (trained.of_maps(maps).argmax(1) == kind.numpy()).mean() > 0.5  # a twelfth by chance
    assert np.array(trained.training["confusion"]).sum() == trained.training["held_out_takes"] == 36


def test_a_training_goes_on_to_the_same_weights(tmp_path: Path) -> None:
    path = tmp_path / "checkpoint.safetensors"

    def stop(progress) -> None:
        if progress.epoch == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        localize.train_recognizer(ARRAY, "events", replace(TINY, checkpoint_interval=0.0), stop, path)
    whole = localize.train_recognizer(ARRAY, "events", TINY)
    again = localize.train_recognizer(ARRAY, "events", TINY, checkpoint=path)
    for name, value in whole.classifier.state_dict().items():
        assert torch.equal(value, again.classifier.state_dict()[name]), name
    with pytest.raises(CheckpointError, match=r"plan\.seed"):
        localize.train_recognizer(ARRAY, "events", replace(TINY, seed=4), checkpoint=path)


def test_a_saved_recognizer_gives_the_same_probabilities(trained, tmp_path: Path) -> None:
    trained.save(tmp_path)
    wave = event_pressure("knock", 1024, np.random.default_rng(0))
    again = localize.load_recognizer(tmp_path)
    np.testing.assert_array_equal(trained.recognize(wave), again.recognize(wave))
    assert again.recognize(np.stack([wave, wave])).shape == (2, 12)
    assert (again.labels, again.microphones) == (trained.labels, trained.microphones)


@pytest.mark.parametrize(
    ("change", "kind", "field"),
    [
        ({"format": "other"}, Kind.UNREADABLE, None),
        ({"version": 9}, Kind.MISMATCH, "version"),
        ({"labels": ["a", "b"]}, Kind.DAMAGED, ""),
        ({"labels": 3}, Kind.WRONG_TYPE, "labels"),
        ({"extra": 3}, Kind.UNKNOWN, "extra"),
    ],
)
def test_a_changed_description_is_refused(trained, tmp_path: Path, change, kind: Kind, field: str) -> None:
    trained.save(tmp_path)
    path = tmp_path / "recognizer.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    with refused(kind, field, file=path, error=localize.RecognizerError):
        localize.load_recognizer(tmp_path)


@pytest.mark.parametrize(
    ("call", "kind", "field"),
    [
        (lambda: localize.train_recognizer(ARRAY, "moods"), Kind.OUT_OF_RANGE, "subject"),
        (lambda: localize.train_recognizer(ARRAY, "labels"), Kind.CONFLICT, "subject"),
        (lambda: localize.RecognitionPlan(takes=2), Kind.OUT_OF_RANGE, "takes"),
        (lambda: localize.RecognitionPlan(salt_and_pepper=0.9), Kind.OUT_OF_RANGE, "salt_and_pepper"),
        (lambda: localize.RecognitionPlan(network="huge"), Kind.OUT_OF_RANGE, "network"),
    ],
)
def test_trainings_that_cannot_be_are_refused(call, kind: Kind, field: str) -> None:
    with refused(kind, field):
        call()


def test_a_waveform_of_another_length_or_with_a_gap_is_refused(trained) -> None:
    with refused(Kind.WRONG_TYPE, "waveforms"):
        trained.recognize(np.zeros(1000))
    with refused(Kind.UNSUITABLE, "waveforms"):
        trained.recognize(np.full(1024, np.nan))


def test_stretches_part_where_it_is_silent_for_long_and_windows_hold_the_touch() -> None:
    found = stretches(np.array([1000, 1016, 1100, 3000]))
    assert [(each.begin, each.end) for each in found] == [(1101, 1249), (3001, 3249)]
    wave = np.full(5000, np.nan)
    wave[250:4900] = 0.0
    wave[2000:2040] = 1.0
    (window,) = cut(wave, Stretch(1990, 2060))
    assert np.flatnonzero(window)[[0, -1]].tolist() == [200, 239]
    assert cut(wave[:1000], Stretch(300, 400)).shape == (0, 1024)


def test_the_first_window_of_a_long_touch_shows_how_it_begins() -> None:
    wave = np.zeros(6000)
    wave[2000:4000] = 1.0
    windows = cut(wave, Stretch(2000, 4000))
    assert len(windows) == 5  # a quarter of a window apart
    assert not windows[0, :175].any()
    assert windows[0, 200:].all()


# -- recordings ----------------------------------------------------------------------------------------
def recorded(folder: Path, takes: int = 3, labels: tuple[str, ...] = ("knock", "rub")) -> Path:
    """Three touches with silence between in each recording."""
    lines = ["full_scale = 8.0"]
    for label in labels:
        for take in range(takes):
            random = np.random.default_rng([take, labels.index(label)])
            pressure = np.zeros(7000)
            for begin in (600, 2700, 4800):
                pressure[begin : begin + 1024] = event_pressure(label, 1024, random) * np.hanning(1024) ** 0.25
            name = f"{label}-{take}.wav"
            write_wav(folder / name, simulated_signals(ARRAY, 2, pressure, 1e-3, random) / 8, 1000, 32)
            lines += ["[[recordings]]", f'file = "{name}"', "point = 2", f'label = "{label}"']
    (folder / "touches.toml").write_text("\n".join(lines))
    return folder / "touches.toml"


def test_recordings_in_which_nothing_is_heard_are_refused(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, takes=2)
    write_wav(tmp_path / "rub-1.wav", 1e-5 * np.random.default_rng(0).standard_normal((2, 4000)), 1000, 32)
    with refused(Kind.UNSUITABLE, file="rub-1.wav", error=TouchManifestError):
        localize.train_recognizer(ARRAY, "labels", PLAN, recordings=manifest)


@pytest.mark.slow
def test_labels_of_recordings_are_learnt_and_told_of_another(tmp_path: Path) -> None:
    manifest = recorded(tmp_path)
    own = localize.train_recognizer(ARRAY, "labels", replace(PLAN, epochs=12), recordings=manifest)
    assert own.labels == ("knock", "rub")
    assert sum("held out" in said for said in own.training["recordings"].values()) == 2
    assert own.training["held_out_takes"] == 7  # of six touches, cut as `recognize` cuts them: one is long
    random, pressure = np.random.default_rng(77), np.zeros(6000)
    for begin, name in ((700, "rub"), (3200, "knock")):
        pressure[begin : begin + 1024] = event_pressure(name, 1024, random) * np.hanning(1024) ** 0.25
    signals = simulated_signals(ARRAY, 2, pressure, 1e-3, random)
    told = FilterBank(ARRAY, own).touches(signals, None, None, localize.BayesDecoder(ARRAY, 1e-3))
    assert [own.labels[each.probability.argmax()] for each in told] == ["rub", "knock"]
    assert [each.point for each in told] == [2, 2]


@pytest.mark.parametrize(
    ("old", "new", "kind", "field"),
    [
        ('label = "rub"', 'part = "taps"', Kind.MISSING, "recordings.3.label"),
        ('label = "rub"', 'label = "knock"', Kind.UNSUITABLE, ""),
        ('rub-0.wav"\npoint = 2\nlabel = "rub"', 'rub-0.wav"\npoint = 2\nlabel = "x"', Kind.UNSUITABLE, ""),
        ("point = 2", "point = 9", Kind.OUT_OF_RANGE, "recordings.0.point"),
        ("point = 2", 'point = 2\nspeed = "12"', Kind.WRONG_TYPE, "recordings.0.speed"),
        ('label = "rub"', 'label = " "', Kind.OUT_OF_RANGE, "recordings.3.label"),
    ],
)
def test_a_manifest_that_cannot_be_used_is_refused(tmp_path: Path, old: str, new: str, kind: Kind, field: str) -> None:
    manifest = recorded(tmp_path)
    manifest.write_text(manifest.read_text().replace(old, new))
    with refused(kind, field, file=manifest, error=TouchManifestError):
        read_labelled_manifest(manifest, 3)


def test_letters_of_recordings_state_no_speed(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, takes=2)
    manifest.write_text(manifest.read_text().replace("point = 2", "point = 2\nspeed = 40.0"))
    array = response_of(solved("array-2x6", np.arange(1.0, 501.0, 4.0)))
    with refused(Kind.CONFLICT, file=manifest, error=TouchManifestError):
        localize.train_recognizer(array, "letters", PLAN, recordings=manifest)


def test_a_take_given_twice_and_speeds_of_some_are_refused(tmp_path: Path) -> None:
    manifest = recorded(tmp_path, takes=2)
    text = manifest.read_text()
    manifest.write_text(text + "\nspeed = 12.0")
    with refused(Kind.CONFLICT, file=manifest, error=TouchManifestError):
        localize.train_recognizer(ARRAY, "labels", PLAN, recordings=manifest)
    from acoustic_fem.sound.sound_file import read_wav

    sound = np.stack(list(read_wav(tmp_path / "rub-0.wav").channels.values()))
    write_wav(tmp_path / "rub-1.wav", 0.5 * sound, 1000, 32)
    manifest.write_text(text)
    with refused(Kind.CONFLICT, file=manifest, error=TouchManifestError) as found:
        localize.train_recognizer(ARRAY, "labels", PLAN, recordings=manifest)
    assert "rub-1.wav is the same take as rub-0.wav" in str(found.value)
