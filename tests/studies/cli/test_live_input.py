"""The verb live from the outside: replay, recording, a sound card that is not there, one that goes, and kills."""

import contextlib
import dataclasses
import json
import math
import os
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import fake_audio
import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import localize
import studies
from acoustic_fem.sound.sound_file import read_wav, write_wav
from geometry import Kind

ROOT = Path(__file__).parents[3]
NOISE = 1e-2
RATE = 8000
PATIENCE = 600  # s, for processes on a machine that is busy with others


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A decoder as an ONNX file, and three seconds of 8 kHz with a touch in their middle, in the wrong order."""
    path = tmp_path_factory.mktemp("live")
    array = rc_line(6)
    localize.export_onnx(localize.BayesDecoder(array, NOISE), path / "model.onnx")
    made = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 30).signals.double().numpy()
    signals = NOISE * np.random.default_rng(0).standard_normal((2, 3000))
    signals[:, 1000:2000] += made[np.argmax(made.std(-1).max(1))]
    at = np.arange(3 * RATE) / RATE * 1000
    played = np.stack([np.interp(at, np.arange(3000), row) for row in signals[::-1]]) / 4
    write_wav(path / "play.wav", played, RATE)
    write_wav(path / "short.wav", played[:, :0], 1000)
    write_wav(path / "long.wav", np.tile(played, 200), RATE)  # ten minutes: it does not end before it is stopped
    # For processes that wait for their turn: no samples are dropped, and a silence is no loss.
    (path / "sitecustomize.py").write_text(
        "from localize.live import listener, sound_device, sources\n"
        f"listener.STALL = sound_device.QUEUE = sources.QUEUE = {PATIENCE}\n"
    )
    return path


def obey_ctrl_c() -> None:
    """In a new process: what runs in the background is often told to ignore it, and its children with it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def acoustic_fem(*arguments: object, path: Path, **options):
    """The command as a process; ``path`` holds modules that it finds, with colons between several folders."""
    found = os.pathsep.join(map(str, [ROOT, path]))
    return subprocess.Popen(
        [sys.executable, "-m", "studies.cli", *map(str, arguments)],
        env={**os.environ, "PYTHONPATH": found, **options.pop("env_more", {})},
        stdout=options.pop("stdout", subprocess.PIPE),
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=None if sys.platform == "win32" else obey_ctrl_c,
        **options,
    )


def read_terminal(terminal: int, shown: bytearray) -> None:
    """All that a program writes to its terminal until it ends, when Linux reports an error instead of an end."""
    with contextlib.suppress(OSError):
        while text := os.read(terminal, 65536):
            shown += text


def wait_for(condition) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.05)


@pytest.mark.slow
def test_a_replay_gives_what_locate_gives_and_records_what_it_plays(folder, tmp_path):
    chosen = ("--channels", "left=2,right=1", "--full-scale", "4")
    with acoustic_fem(
        *("live", folder / "model.onnx", "--replay", folder / "play.wav", *chosen),
        *("--out", tmp_path / "live.jsonl", "--record", tmp_path / "again.wav"),
        path=folder,
    ) as process:
        told, errors = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0, errors
    assert (tmp_path / "live.jsonl").read_text() == told
    lines = [json.loads(line) for line in told.splitlines()]
    recording = localize.read_recording(tmp_path / "again.wav", ("left", "right"), 4.0)
    np.testing.assert_array_equal(
        np.stack(list(read_wav(tmp_path / "again.wav").channels.values())),
        np.stack(list(read_wav(folder / "play.wav").channels.values()))[::-1],
    )
    events = localize.TouchStream(localize.OnnxLocalizer(folder / "model.onnx")).push(recording.signals)
    expected = [json.loads(event.json_line()) for event in events]
    late = [line.pop("latency") for line in lines if "latency" in line]
    decisions = [line for line in lines if "event" not in line]
    assert decisions == expected
    assert sum(line["state"] == "touch" for line in decisions) > 40
    assert [line["event"] for line in lines if "event" in line][:1] == ["down"]
    # the end of the filter comes when the file has ended, and has no age
    assert len(late) >= len(lines) - 1
    assert min(late) > 0.01
    (seconds,) = re.findall(r"listened for (\d+\.\d) s: \d+ touch(?:es)?; decisions: \d+ no touch, \d+ touch", errors)
    assert float(seconds) >= 3
    assert "faults: none" in errors
    assert re.search(r"latency: p50 \d+\.\d ms, p99 \d+\.\d ms, at most", errors)
    assert errors.rstrip().endswith(str(tmp_path / "again.wav"))


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="needs a system that kills")
def test_a_killed_program_leaves_its_recording_and_its_lines(folder, tmp_path):
    played = read_wav(folder / "long.wav").channels
    with acoustic_fem(
        *("live", folder / "model.onnx", "--replay", folder / "long.wav", "--full-scale", "4"),
        *("--out", tmp_path / "live.jsonl", "--record", tmp_path / "cut.wav"),
        path=folder,
    ) as process:
        for _ in range(64):
            process.stdout.readline()
        process.kill()
    assert process.returncode == -signal.SIGKILL
    left = read_wav(tmp_path / "cut.wav").channels
    assert 1.2 * RATE < len(left["1"]) < len(played["1"])
    np.testing.assert_array_equal(left["1"], played["1"][: len(left["1"])])
    assert all("time" in json.loads(line) for line in (tmp_path / "live.jsonl").read_text().splitlines())


SOUND_CARD = f"""
import sys
sys.path.insert(0, {str(ROOT / "tests" / "support")!r})
import numpy as np
import fake_audio
noise = 1e-2 * np.random.default_rng(0).standard_normal(({RATE} * 60, 2)).astype(np.float32)
card = fake_audio.FakeAudio([fake_audio.Run(noise[:4000]), fake_audio.Run(noise, "stall")], rate={RATE}, channels=2,
                            absent=1, pace=0.004)
globals().update({{name: getattr(card, name) for name in dir(card) if not name.startswith("__")}})
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs signals between processes")
def test_a_sound_card_is_listened_to_until_ctrl_c_though_it_is_unplugged(folder, tmp_path):
    (tmp_path / "sounddevice.py").write_text(SOUND_CARD)
    with acoustic_fem(
        *("live", folder / "model.onnx", "--device", "usb", "--record", tmp_path / "card.wav"),
        path=os.pathsep.join(map(str, (tmp_path, folder))),
    ) as process:
        lines, back = [], 0
        while back < 20:
            lines.append(json.loads(process.stdout.readline()))
            back += any(line.get("notice") == "source back" for line in lines)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0, errors
    notices = [(line["notice"], line["text"]) for line in lines if "notice" in line]
    assert notices == [
        ("source lost", "USB array (ALSA, 8000 Hz): the device has stopped"),
        ("source lost", "USB array: is not there"),
        ("source back", "USB array (ALSA, 8000 Hz)"),
    ]
    (lost,) = [line for line in lines if line.get("fault") == "samples lost"]
    assert lost["samples"] > 1000
    assert f"1 samples lost ({lost['samples']} samples)" in errors
    assert errors.rstrip().splitlines()[-2:] == [str(tmp_path / "card.wav"), str(tmp_path / "card-2.wav")]
    assert len(read_wav(tmp_path / "card.wav").channels["1"]) == 4000


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs a pseudo-terminal")
def test_a_terminal_shows_the_array_and_ctrl_c_ends_it(folder, tmp_path):
    import pty

    ours, theirs = pty.openpty()
    environment = {"TERM": "xterm", "COLUMNS": "90", "LINES": "30", "PYTHONIOENCODING": "utf-8"}
    with acoustic_fem(
        *("live", folder / "model.onnx", "--replay", folder / "long.wav", "--full-scale", "4"),
        *("--channels", "left=2,right=1", "--out", tmp_path / "live.jsonl"),
        path=folder,
        stdout=theirs,
        env_more=environment,
    ) as process:
        os.close(theirs)
        shown = bytearray()
        # To its end: a terminal that nobody reads fills up, and whoever writes to it waits.
        reader = threading.Thread(target=read_terminal, args=(ours, shown), daemon=True)
        reader.start()
        wait_for(lambda: b"point" in shown or not reader.is_alive())
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=PATIENCE)
        reader.join(PATIENCE)
    os.close(ours)
    assert process.returncode == 0, errors
    assert "listened for" in errors
    text = bytes(shown).decode(errors="replace")
    for words in ("long.wav, played", "line 1", "○", "level", "latency p50", "faults: none", "left   ", "right  "):
        assert words in text, words
    assert "{" not in text
    assert len((tmp_path / "live.jsonl").read_text().splitlines()) > 10


@pytest.mark.slow
def test_lines_into_a_program_that_ends_are_no_error(folder):
    with acoustic_fem("live", folder / "model.onnx", "--replay", folder / "play.wav", path=folder) as process:
        process.stdout.readline()
        process.stdout.close()
        errors = process.stderr.read()
    assert process.returncode == 0
    assert "Error" not in errors
    assert "listened for" in errors


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "sounddevice is not installed; pip install 'acoustic-fem[live]'; on Linux PortAudio itself: apt install "),
        (("--list-devices",), "sounddevice is not installed"),
        (("--replay", "nowhere.wav"), "nowhere.wav: no such file"),
        (
            ("--replay", "{folder}/play.wav", "--channels", "left=1,right=3"),
            "--channels = 3 is not there for microphone",
        ),
        (
            ("--replay", "{folder}/play.wav", "--channels", "left=1"),
            "--channels = 'left=1' must be a number each for left",
        ),
        (
            ("--replay", "{folder}/play.wav", "--full-scale", "0"),
            "--full-scale = 0 Pa must be between 1e-12 and 1e+12",
        ),
        (("--replay", "{folder}/short.wav"), "short.wav: has 0 samples, must have at least 250 (0.25 s at 1000 Hz)"),
        (("--replay", "{folder}/model.onnx"), "cut short or not a WAV file"),
        (
            ("--replay", "{folder}/play.wav", "--record", "{folder}/play.wav"),
            "play.wav: --record exists, and a recording is never overwritten",
        ),
        (
            ("--replay", "{folder}/play.wav", "--record", "{folder}/model.onnx"),
            "exists, and a recording is never overwritten; name another file, or remove this one",
        ),
        (("--replay", "{folder}/play.wav", "--record", "{folder}"), "record must be a file, not a folder"),
        (
            ("--replay", "{folder}/play.wav", "--record", "{folder}/no/x.wav"),
            "record must lie in a folder that exists",
        ),
        (("--replay", "{folder}/play.wav", "--noise", "1"), "--noise = 1 Pa is for a library"),
    ],
)
def test_what_cannot_be_listened_to_is_one_line(folder, monkeypatch, capsys, arguments, message):
    from studies.cli import app

    monkeypatch.setitem(sys.modules, "sounddevice", None)  # as if it were not installed
    given = [argument.format(folder=folder) for argument in arguments]
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "live", str(folder / "model.onnx"), *given])
    with pytest.raises(SystemExit) as ended:
        app.main()
    (line,) = capsys.readouterr().err.splitlines()
    assert ended.value.code == 1
    assert line.startswith("acoustic-fem: ")
    assert message in line


def test_a_computer_without_portaudio_is_told_what_to_install(folder, tmp_path, monkeypatch):
    from localize.live.sound_device import load_sounddevice
    from localize.live.sources import SourceError

    # what the package does where it finds no library
    (tmp_path / "sounddevice.py").write_text("raise OSError('PortAudio library not found')\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "sounddevice", raising=False)
    with pytest.raises(SourceError, match=r"PortAudio library not found; pip install .* apt install libportaudio2"):
        load_sounddevice()


def test_sound_cards_are_listed_without_a_model(monkeypatch, capsys):
    from studies.cli import app

    monkeypatch.setitem(sys.modules, "sounddevice", fake_audio.FakeAudio([]))
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "live", "--list-devices"])
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == 0
    assert re.search(r"1\s+USB array\s+ALSA\s+4\s+48000\s+default", capsys.readouterr().out)


def test_a_list_without_a_sound_card_says_so(monkeypatch, capsys):
    from studies.cli import app

    monkeypatch.setitem(sys.modules, "sounddevice", fake_audio.FakeAudio([], channels=0))
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "live", "--list-devices"])
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("acoustic-fem: no device that can record is there")


@pytest.mark.parametrize(
    ("given", "kind", "field"),
    [
        ({"rate": 48_000, "replay": "a.wav"}, Kind.CONFLICT, "rate"),
        ({"device": 1, "replay": "a.wav"}, Kind.CONFLICT, "device"),
        ({"rate": 100}, Kind.OUT_OF_RANGE, "rate"),
        ({"rate": 48e3}, Kind.OUT_OF_RANGE, "rate"),
        ({"rate": math.nan}, Kind.OUT_OF_RANGE, "rate"),
        ({"rate": True}, Kind.OUT_OF_RANGE, "rate"),
    ],
)
def test_an_input_that_cannot_be_is_refused_by_name(given, kind, field):
    with refused(kind, field):
        studies.LiveInput(**given)


#: A value of every argument of a live input, and the sources that take it.
TAKEN_BY = {
    "device": (1, {"device"}),
    "replay": ("a.wav", {"replay"}),
    "channels": ({"A": 1}, {"device", "replay", "serial"}),
    "full_scale": (1.0, {"device", "replay"}),
    "rate": (48_000, {"device"}),
    "serial": ("/dev/ttyACM0", {"serial"}),
    "baud": (9600, {"serial"}),
    "acceleration": (studies.AccelerationFile("moved.csv"), {"replay"}),
}


@pytest.mark.parametrize("source", ["device", "replay", "serial"])
@pytest.mark.parametrize("argument", TAKEN_BY)
def test_an_argument_that_a_source_does_not_take_is_refused_by_name(source, argument):
    assert set(TAKEN_BY) == {each.name for each in dataclasses.fields(studies.LiveInput)}
    value, sources = TAKEN_BY[argument]
    given = {source: TAKEN_BY[source][0], argument: value}
    if source in sources:
        assert getattr(studies.LiveInput(**given), argument) == value
        return
    rank = ("device", "replay", "serial")  # the source that comes later is taken, the other one is named
    named = source if argument in rank and rank.index(argument) > rank.index(source) else argument
    with refused(Kind.CONFLICT, named):
        studies.LiveInput(**given)


def test_a_speed_without_a_line_that_has_one_is_refused():
    for given in ({"baud": 9600}, {"serial": "socket://127.0.0.1:5555", "baud": 9600}):
        with refused(Kind.CONFLICT, "baud", 9600):
            studies.LiveInput(**given)
    with refused(Kind.OUT_OF_RANGE, "baud", 1):
        studies.LiveInput(serial="/dev/ttyACM0", baud=1)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--device", "1", "--replay", "a.wav"), "--device = 1 has no effect beside --replay"),
        (("--baud", "9600", "--replay", "a.wav"), "--baud = 9600 has no effect beside --replay"),
        (("--baud", "115200"), "--baud = 115200 has no effect without --serial"),
        (("--full-scale", "1", "--serial", "a"), "--full-scale = 1 has no effect beside --serial"),
        (("--lowest", "2", "--replay", "a.wav"), "--lowest = 2 Hz has no effect"),
    ],
)
def test_options_without_effect_are_one_line(folder, monkeypatch, capsys, arguments, message):
    from studies.cli import app

    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "live", str(folder / "model.onnx"), *arguments])
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert message in line


def test_channels_that_cannot_be_read_are_a_wrong_command_line(folder, monkeypatch, capsys):
    from studies.cli import app

    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "live", str(folder / "model.onnx"), "--channels", "A:1"])
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == 2
    assert "--channels" in capsys.readouterr().err


@pytest.mark.slow
def test_ten_seconds_of_two_times_36_points_in_real_time_lose_no_frame(folder):
    result = subprocess.run(
        [sys.executable, ROOT / "benchmarks" / "live.py", "--seconds", "10", "--json"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, [ROOT, folder]))},
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
    )
    assert result.returncode == 0, result.stderr
    # Latencies are the benchmark's to tell: they say how busy a machine is.
    for row in json.loads(result.stdout):
        assert row["decisions"] == row["offline"] == (10_000 - 250) // 16 + 1
        assert row["same"]
        assert row["faults"] == 0
        assert row["memory at the end"] < 1.05 * row["memory at first"]


def test_a_replay_is_not_faster_than_its_file(folder):
    from localize.live.sources import ReplaySource

    source = ReplaySource(folder / "long.wav", ("left", "right"))
    began = time.perf_counter()
    queue = source.open()
    count = 0
    while (block := queue.get(PATIENCE)) is not None:
        assert time.perf_counter() >= block.available
        count += block.samples.shape[1]
        if count > RATE:
            break
    assert time.perf_counter() - began > 0.95
    source.close()
    assert not source.ended
