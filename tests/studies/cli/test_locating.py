"""Verbs that put a localizer to work: onnx and locate."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
import scipy.io.wavfile
from command import Command, Outcome
from filelock import FileLock
from shared import shared_folder
from small_run import small_run

import acoustic_fem
import geometry
import localize
from localize.signals.array_response import response_of
from localize.signals.finger_strokes import tap_strokes


def assert_exported(told: Outcome) -> None:
    assert (told.code, "3 points, 2 microphones" in told.out) == (0, True), told.err
    assert [line for line in told.err.splitlines() if not line.startswith("note: entrance loss")] == []


def decoder_graph(command: Command) -> Path:
    """The decoder of the small run's library in a room with sound, made by the first who asks."""
    graph = shared_folder() / "row-3-decoder.onnx"
    with FileLock(graph.with_suffix(".lock")):
        if not graph.exists():
            words = ("--noise", 1e-3, "--ambient", 70)
            assert_exported(command("onnx", small_run().folder / "library.nc", "--out", graph, *words))
    return graph


@pytest.mark.slow
def test_a_recording_is_located_by_the_network_an_onnx_file_and_the_library_alike(
    command: Command, tmp_path: Path
) -> None:
    folder = small_run().folder
    library = acoustic_fem.load(folder / "library.nc")
    touches = localize.TouchGenerator(response_of(library), 0, "evaluation", 0.0).samples(0, 60)
    loud = [
        max((k for k in range(60) if touches.point[k] == point + 1), key=lambda k: float(touches.signals[k].std()))
        for point in (2, 0)
    ]
    samples = 2e-4 * np.random.default_rng(0).standard_normal((2, 5000))
    for turn, sample in enumerate(loud):
        samples[:, 500 + 2000 * turn : 1500 + 2000 * turn] += touches.signals[sample].numpy()
    recording = tmp_path / "recording.wav"
    scipy.io.wavfile.write(recording, 1000, samples.T.astype(np.float32))

    network, decoder = tmp_path / "network.onnx", decoder_graph(command)
    assert_exported(command("onnx", folder / "localizer", "--out", network))
    for model in (folder / "localizer", folder / "library.nc", network, decoder):
        told = command("locate", model, recording)
        assert told.code == 0, told.err
        assert "2 touches in 5.0 s" in told.out
        rows = [line.split() for line in told.out.splitlines() if re.match(r" *\d", line)]
        assert [row[2] for row in rows] == ["3", "1"]

    lines = tmp_path / "touches.jsonl"
    words = ("--out", lines, "--waveform", "--library", folder / "library.nc")
    assert command("locate", decoder, recording, *words).code == 0
    events = [json.loads(line) for line in lines.read_text(encoding="utf-8").splitlines()]
    assert {event["state"] for event in events if "state" in event} <= {"touch", "fading", "no touch", "sound"}
    assert [event["event"] for event in events if "event" in event] == ["down", "up", "down", "up"]
    waveforms = [event["waveform"] for event in events if event.get("state") == "touch" and event["time"] > 0.3]
    assert {len(waveform) for waveform in waveforms} == {16}


@pytest.mark.slow
def test_a_microphone_that_dies_or_clips_is_named_and_two_go_on(command: Command, tmp_path: Path) -> None:
    design = geometry.prototype("glove").with_values({"lines.0.points": 3, "lines.1.points": 3})
    solved = acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")
    acoustic_fem.save(solved, tmp_path / "glove.nc")
    library = response_of(solved)
    touches = localize.TouchGenerator(library, 0, "evaluation", 0.0).samples(0, 2 * design.point_count)
    first = [k for k in range(len(touches.point)) if library.line[touches.point[k] - 1] == 0]
    loud = sorted(first, key=lambda k: -float(touches.signals[k].std()))[:2]
    samples = 7e-4 * np.random.default_rng(0).standard_normal((3, 12000))
    for begin, sample in zip((2000, 9000), loud, strict=True):
        samples[:, begin : begin + 1000] += touches.signals[sample].numpy()
    clipped = samples.copy()
    clipped[2] = np.clip(samples[2], *(0.5 * np.array([samples[2].min(), samples[2].max()])))
    samples[2, 6000:] = 0.0
    recording = tmp_path / "recording.wav"
    scipy.io.wavfile.write(recording, 1000, samples.T.astype(np.float32))
    told = command("locate", tmp_path / "glove.nc", recording)
    assert told.code == 0, told.err
    assert re.search(r"^warning: dead channel of microphone C, from 6\.\d s on$", told.out, re.MULTILINE)
    rows = [line.split() for line in told.out.splitlines() if re.match(r" *\d", line)]
    assert [int(row[2]) for row in rows] == [int(touches.point[k]) for k in loud]
    scipy.io.wavfile.write(recording, 1000, clipped.T.astype(np.float32))
    told = command("locate", tmp_path / "glove.nc", recording)
    assert (told.code, "channel C is clipped at" in told.err + told.out) == (0, True)
    assert re.search(r"^warning: clipped .*microphone C", told.out, re.MULTILINE)
    rows = [line.split() for line in told.out.splitlines() if re.match(r" *\d", line)]
    # What follows a clipped beginning may be a touch of its own, of which nothing is sure.
    assert [int(row[2]) for row in rows if float(row[5]) > 50] == [int(touches.point[k]) for k in loud]
    # Nobody goes on with one of two.
    scipy.io.wavfile.write(recording, 1000, samples[[0, 2]].T.astype(np.float32))
    told = command("locate", small_run().folder / "library.nc", recording)
    assert (told.code, "ends 6 s before" in told.err) == (1, True)


@pytest.fixture
def of_no_touch(tmp_path: Path) -> Path:
    """Folder of two recordings: sound.wav, and two.wav of two touches at once."""
    library = response_of(acoustic_fem.load(small_run().folder / "library.nc"))
    touches = localize.TouchGenerator(library, 0, "evaluation", 1e-3, ambient=(70.0, 70.0)).samples(0, 3)
    quiet = localize.TouchGenerator(library, 0, "evaluation", 0.0).samples(0, 3)
    sound = (touches.signals - quiet.signals).numpy()
    two = quiet.signals[0].numpy() + quiet.signals[2].numpy() + 1e-3 * np.random.default_rng(0).standard_normal((2, 1))
    for name, signals in (("sound", sound[0]), ("two", two)):
        scipy.io.wavfile.write(tmp_path / f"{name}.wav", 1000, signals.T.astype(np.float32))
    return tmp_path


def test_a_library_tells_sound_and_what_no_point_explains_from_touches(command: Command, of_no_touch: Path) -> None:
    library = small_run().folder / "library.nc"
    assert " 0 touches" in command("locate", library, of_no_touch / "sound.wav").out  # it knows sound by itself
    told = command("locate", library, of_no_touch / "two.wav", "--reject", 1e-6)
    assert (told.code, "0 touches in 1.0 s, no single touch for 0.8 s" in told.out) == (0, True), told


@pytest.mark.slow
def test_sound_is_no_touch_for_any_model_that_is_given_a_library(command: Command, of_no_touch: Path) -> None:
    folder, sound = small_run().folder, of_no_touch / "sound.wav"
    network, graph = folder / "localizer", decoder_graph(command)
    words = ("--library", folder / "library.nc", "--ambient", 80)
    for model in (folder / "library.nc", network, graph):
        # A network and a graph know sound where they are given a library.
        assert (" 0 touches" in command("locate", model, sound).out) == (model == folder / "library.nc")
        told = command("locate", model, sound, *words)
        assert (told.code, "0 touches in 1.0 s, sound alone for 0.8 s" in told.out) == (0, True), told


@pytest.mark.slow
def test_a_microphone_far_off_its_level_is_told_and_brought_to_it(command: Command, tmp_path: Path) -> None:
    library = small_run().folder / "library.nc"
    # Taps, because multi-sine touches may begin with a fall, which a stream takes for the end of the touch before.
    response = response_of(acoustic_fem.load(library))
    touches = localize.TouchGenerator(response, 0, "evaluation", 0.0, stimuli=tap_strokes).samples(0, 12)
    loud = touches.signals.numpy() / touches.signals.numpy().std((1, 2), keepdims=True) / 20
    still = np.zeros((12, 2, 1000))
    samples = np.concatenate([still, loud], axis=2).transpose(1, 0, 2).reshape(2, -1)
    samples += 5e-4 * np.random.default_rng(0).standard_normal(samples.shape)
    heard = {}
    for name, factor in (("as it is", 1.0), ("off", 10 ** (-12 / 20))):
        scipy.io.wavfile.write(tmp_path / "heard.wav", 1000, (samples.T * [1.0, factor]).astype(np.float32))
        heard[name] = command("locate", library, tmp_path / "heard.wav").out
    assert "warning" not in heard["as it is"]
    assert re.search(r"warning: microphone . is 1[123] dB .* was corrected", heard["off"])
    points = {
        name: [line.split()[2] for line in told.splitlines() if re.match(r" *\d", line)] for name, told in heard.items()
    }
    assert len(points["off"]) >= 8
    assert points["off"] == points["as it is"]
