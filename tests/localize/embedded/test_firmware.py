"""The firmware: its frames hold what its low-pass gives of the samples, or the touches of Python; gaps are counted."""

import contextlib
import socket
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
import scipy.signal
from embedded_bench import COMPILER, SANITIZED, STRICT, needs_compiler
from small_run import small_design

import acoustic_fem
import studies
from acoustic_fem.sound.sound_file import read_wav
from benchmarks.boards import WITHOUT_FPU, missing_tools
from benchmarks.embedded_touches import array_of
from benchmarks.firmware import (
    ARRAYS,
    FULL_SCALE,
    differing,
    firmware_bytes,
    linked_firmware,
    run_firmware,
    started,
    write_project,
)
from benchmarks.firmware_touches import decimated, events_in_python, of_converter, recordings
from localize.embedded import embed
from localize.embedded.decimator import FACTOR, FIR_TAPS, decimator_response
from localize.live import serial_port
from localize.live.events import Decision, TouchEvent
from localize.live.serial_frames import FrameReader, SampleFrame, StatusFrame, TouchFrame
from localize.live.sources import SourceError
from localize.signals.array_response import response_of

SOURCES = ("firmware", "ring", "decimator", "serial")
needs_board = pytest.mark.skipif(missing_tools() is not None, reason=f"{missing_tools()} is not installed")
RECORDINGS = Path(__file__).parents[3] / "docs" / "examples" / "recordings"
HOST = Path(__file__).parents[2] / "support" / "firmware_host.c"


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 20), "lumped")


@pytest.fixture(scope="module")
def folder(tmp_path_factory, library):
    """The project of a small array with two microphones."""
    path = tmp_path_factory.mktemp("firmware")
    for name, text in embed(library, prefix="hand").files.items():
        (path / name).write_text(text, encoding="utf-8")
    host = HOST.read_text(encoding="utf-8").replace("touch_", "hand_").replace("TOUCH_", "HAND_")
    (path / "host.c").write_text(host, encoding="utf-8")
    return path


def test_a_prefix_reaches_the_lines_that_build(folder):
    readme = (folder / "README.md").read_text(encoding="utf-8")
    assert "-DHAND_EVENT_MODE=1" in readme
    assert "TOUCH_" not in readme


def built(folder, name, parts, *options):
    sources = ["host.c", *(f"hand_{each}.c" for each in parts)]
    command = [str(COMPILER), *STRICT, *SANITIZED, *options, *sources, "-lm", "-o", name]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    return folder / name


@pytest.fixture(scope="module")
def host(folder):
    return built(folder, "host", SOURCES)


def samples_of(instants):
    """(n, 2) int16 of a converter: tones in the band, above it, and noise."""
    time = np.arange(instants) / 16_000
    tones = 6000 * np.sin(2 * np.pi * 40 * time) + 5000 * np.sin(2 * np.pi * 3100 * time)
    noise = np.random.default_rng(1).normal(0, 500, (instants, 2))
    return np.clip(np.stack([tones, -0.3 * tones], axis=1) + noise, -32768, 32767).astype("<i2")


def without(pressures, gaps):
    """Pressures at 1 kHz, NaN where the low-pass spans an instant of the gaps (begin, count) of the converter."""
    newest = FACTOR * np.arange(pressures.shape[1]) + FACTOR - 1
    lost = np.zeros(pressures.shape[1], bool)
    for begin, count in gaps:
        lost |= (newest >= begin) & (newest - FIR_TAPS < begin + count - 1)
    return np.where(lost, np.nan, pressures)


def assert_frames_hold(frames, expected):
    for frame in frames:
        here = expected[:, frame.first : frame.first + frame.samples.shape[1]]
        step = np.abs(here).max() / 32767
        np.testing.assert_allclose(frame.samples, here, rtol=0, atol=0.51 * step + 2e-6 * FULL_SCALE)


def test_the_low_pass_is_as_flat_and_as_steep_as_it_is_said_to_be():
    assert np.abs(decimator_response(np.linspace(0, 300, 1000))).max() < 0.01
    assert decimator_response(np.linspace(612, 8000, 5000)).max() < -70


COUNTING = """
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "hand_decimator.h"
/* Blocks done before, then instants to skip after the first 40 blocks: the numbers of all outputs that follow. */
int main(int count, char **given)
{
    static hand_decimator decimator;
    const int16_t samples[HAND_MICROPHONES] = {0};
    float out[HAND_MICROPHONES];
    (void)count;
    decimator.number = (uint32_t)strtoul(given[1], NULL, 10);
    for (int part = 0; part < 2; part++) {
        for (int k = 0; k < 40 * HAND_FIR_FACTOR; k++)
            if (hand_decimator_take(&decimator, samples, out)) printf("%" PRIu32 "\\n", decimator.number - 1);
        if (part == 0) hand_decimator_skip(&decimator, (uint32_t)strtoul(given[2], NULL, 10));
    }
    return 0;
}
"""


@pytest.mark.parametrize("first", [2**28 - 20, 2**32 - 20])
@pytest.mark.parametrize("lost", [7, 16 * 1000 + 9])
def test_numbers_of_samples_go_on_after_three_days_and_after_forty_nine(folder, first, lost):
    """16 kHz times 2^-32 is 75 hours, in which a count of instants would begin again."""
    (folder / "counting.c").write_text(COUNTING, encoding="utf-8")
    command = [str(COMPILER), *STRICT, "counting.c", "hand_decimator.c", "-o", "counting"]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    told = subprocess.run([folder / "counting", str(first), str(lost)], capture_output=True, text=True, check=True)
    numbers = np.array(told.stdout.split(), np.int64)
    known = (FIR_TAPS + FACTOR - 1) // FACTOR - 1  # blocks until the low-pass knows all of its instants
    before = first + np.arange(known, 40)
    newest = 40 * FACTOR + lost + np.arange(40 * FACTOR)  # instants behind the gap
    ends = newest[(newest % FACTOR == FACTOR - 1) & (np.arange(40 * FACTOR) >= FIR_TAPS - 1)]
    assert numbers.tolist() == (np.concatenate([before, first + ends // FACTOR]) % 2**32).tolist()


@pytest.fixture
def patient(monkeypatch):
    """All samples wait until they are taken: the emulator is faster than time."""
    monkeypatch.setattr(serial_port, "QUEUE", 60.0)


@contextlib.contextmanager
def emulated(folder, prefix, samples, mode="raw"):
    """Address of the line of an emulated board, whose samples begin when somebody is there."""
    program = linked_firmware(folder, prefix, mode)
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    board = started(program, samples, f"tcp:127.0.0.1:{port},server=on,wait=on")
    try:
        yield f"socket://127.0.0.1:{port}"
    finally:
        board.kill()
        board.wait()


def as_soon_as_it_is_there(call):
    """Result of a call, as soon as the emulator listens."""
    for _ in range(200):
        with contextlib.suppress(SourceError):
            return call()
        time.sleep(0.1)
    raise AssertionError("the emulator does not start")


@needs_compiler
def test_gaps_of_the_board_are_where_they_were_and_counted(host):
    samples = samples_of(40_000)
    gaps = [(1003, 5), (9000, 160), (20_000, 4000)]
    words = [str(word) for gap in gaps for word in gap]
    done = subprocess.run([host, *words], input=samples.tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    reader = FrameReader()
    found = reader.push(done.stdout)
    frames = [each for each in found if isinstance(each, SampleFrame)]
    assert (reader.counts.lost, reader.counts.damaged) == (0, 0)
    expected = without(decimated(samples, FULL_SCALE), gaps)
    assert_frames_hold(frames, expected)
    got = np.concatenate([each.first + np.arange(each.samples.shape[1]) for each in frames])
    known = np.flatnonzero(np.isfinite(expected).all(0))
    assert got.tolist() == known[: len(got)].tolist()
    assert len(known) - len(got) < 16  # the hop that the end cuts off
    last = [each for each in found if isinstance(each, StatusFrame)][-1]
    assert (last.name, last.points, last.microphones, last.mode) == (small_design().name, 3, 2, "raw")
    assert last.lost == last.sample - (known < last.sample).sum() - known[0]
    assert last.lost > 260


@needs_compiler
def test_frames_that_find_no_room_are_lost_and_told(host):
    done = subprocess.run([host], input=samples_of(20_000).tobytes(), capture_output=True, check=True)
    reader = FrameReader()
    last = [each for each in reader.push(done.stdout) if isinstance(each, StatusFrame)][-1]
    assert last.unsent == reader.counts.lost > 5


@needs_compiler
def test_touches_that_the_firmware_sends_are_those_of_python_across_gaps_too(folder, library):
    response = response_of(library)
    program = built(folder, "events", (*SOURCES, "decoder", "tables", "tracker"), "-DHAND_EVENT_MODE=1")
    samples = of_converter(recordings(response, 3, FULL_SCALE, 5)["taps"], FULL_SCALE)
    gaps = [(16_003, 7), (38_000, 900)]
    words = [str(word) for gap in gaps for word in gap]
    done = subprocess.run([program, *words], input=samples.tobytes(), capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    reader = FrameReader()
    frames = reader.push(done.stdout)
    touches = [each for each in frames if isinstance(each, TouchFrame)]
    expected = events_in_python(response, without(decimated(samples, FULL_SCALE), gaps), FULL_SCALE)
    assert [(each.kind, each.touch, each.point, each.sample) for each in touches] == [
        (each.kind, each.touch, each.point, round(1000 * each.time)) for each in expected.events
    ]
    numbers = [(each.probability, each.level, each.latency) for each in touches]
    same = [(each.probability, each.level, each.latency) for each in expected.events]
    np.testing.assert_allclose(numbers, same, rtol=1e-4, atol=1e-4)
    assert len(touches) >= 10
    states = [each for each in frames if isinstance(each, StatusFrame)]
    assert {each.mode for each in states} == {"events"}
    assert states[-1].lost == sum(np.isnan(without(np.zeros((1, 5000)), gaps))[0])
    assert (reader.counts.lost, reader.counts.damaged) == (0, 0)


@pytest.mark.slow
@needs_board
@pytest.mark.parametrize("name", ARRAYS)
def test_touches_of_the_whole_firmware_on_an_emulated_board_are_those_of_python(tmp_path, name):
    """Low-pass, decoder, tracker and line on a Cortex-M4F: five recordings of an as-built sensor, calibrated."""
    response, kinds = array_of(name, True), set()
    write_project(tmp_path, name)
    for kind, signals in recordings(response, 46, FULL_SCALE, 5).items():
        samples = of_converter(signals, FULL_SCALE)
        found = run_firmware(tmp_path, samples, "events")
        expected = events_in_python(response, decimated(samples, FULL_SCALE), FULL_SCALE)
        assert differing(found.touches, expected.events) == 0, kind
        numbers = [(each.probability, each.level, each.latency) for each in found.touches]
        same = [(each.probability, each.level, each.latency) for each in expected.events]
        np.testing.assert_allclose(numbers, same, rtol=2e-4, atol=1e-3, err_msg=kind)
        assert found.lost == found.states[-1].lost == found.states[-1].unsent == 0
        assert 0 < found.longest < found.instructions
        kinds |= {each.kind for each in found.touches}
        assert found.touches
    assert kinds >= {"down", "moved", "up"}


@pytest.mark.slow
@needs_board
def test_a_core_without_a_floating_point_unit_sends_the_same_in_16_kilobytes(tmp_path):
    """A Cortex-M0 with 256 KiB of flash, in both modes."""
    response = array_of("array-2x6", True)
    write_project(tmp_path, "array-2x6", "int16")
    samples = of_converter(recordings(response, 46, FULL_SCALE, 2)["taps"], FULL_SCALE)
    raw = run_firmware(tmp_path, samples, "raw", WITHOUT_FPU)
    assert raw.lost == 0
    assert len(raw.samples) > 100
    assert_frames_hold(raw.samples, decimated(samples, FULL_SCALE))
    found = run_firmware(tmp_path, samples, "events", WITHOUT_FPU)
    expected = events_in_python(response, decimated(samples, FULL_SCALE), FULL_SCALE)
    assert found.touches
    assert differing(found.touches, expected.events) == 0
    assert found.instructions > raw.instructions


@pytest.mark.slow
@needs_board
def test_an_emulated_board_is_recorded_over_its_line(folder, tmp_path, patient):
    samples = samples_of(16_000 * 5)
    with emulated(folder, "hand", samples) as port:
        made = as_soon_as_it_is_there(lambda: studies.record_board(port, tmp_path / "r.wav", seconds=4))
    assert (made.samples_lost, made.line.lost, made.line.damaged) == (0, 0, 0)
    sound = read_wav(tmp_path / "r.wav")
    found = np.stack([sound.channels["1"], sound.channels["2"]])
    first = FIR_TAPS // FACTOR - 1
    expected = decimated(samples, FULL_SCALE)[:, first : first + 4000]
    np.testing.assert_allclose(found, expected, atol=np.abs(expected).max() / 60_000)
    flash, ram = firmware_bytes(folder / "raw.elf")
    assert flash < 12_000
    assert ram < 8_000


@pytest.mark.slow
@needs_board
@pytest.mark.parametrize("mode", ["raw", "events"])
def test_touches_that_an_emulated_board_sends_are_those_of_the_recording(tmp_path, patient, mode):
    library, recording = RECORDINGS / "library.nc", RECORDINGS / "touches.wav"
    for name, text in embed(acoustic_fem.load(library)).files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    sound = read_wav(recording)
    signals = scipy.signal.resample_poly(20 * np.stack(list(sound.channels.values())), FACTOR, 1, axis=1)
    samples = np.round(np.pad(signals, ((0, 0), (0, 16_000))) / FULL_SCALE * 32767).astype("<i2").T
    downs = []

    def hear(session, heard, line):
        if isinstance(heard.event, TouchEvent) and heard.event.kind == "down":
            downs.append(heard.event.point)
        if isinstance(heard.event, Decision):
            return heard.event.time <= 6.4
        return not (isinstance(heard.event, TouchEvent) and (heard.event.kind, heard.event.touch) == ("up", 12))

    with emulated(tmp_path, "touch", samples, mode) as port:
        source = studies.LiveInput(serial=port)
        summary = as_soon_as_it_is_there(lambda: studies.listen(library, source, hear=hear))
    expected = [touch.point for touch in studies.locate_recording(library, recording, full_scale=20.0).touches]
    assert downs == expected
    assert len(downs) == 12
    assert (summary.samples_lost, summary.line.lost, summary.line.damaged) == (0, 0, 0)
