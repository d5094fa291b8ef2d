"""Boards on a serial port: samples and touches as they were sent, every loss counted, an unplugged board awaited."""

import json
import os
import threading
from binascii import crc_hqx

import numpy as np
import pytest
from embedded_bench import needs_compiler
from pseudo_port import PseudoPort
from rc_line import rc_line
from refusals import refused
from serial_line import Board

import acoustic_fem
import localize
import studies
from acoustic_fem.sound.sound_file import read_wav
from geometry import Kind
from localize.live import serial_port
from localize.live.board_events import BoardListener
from localize.live.events import Decision, Fault, TouchEvent
from localize.live.listener import Notice
from localize.live.serial_frames import FrameReader, LineCounts
from localize.live.serial_port import BoardLine
from localize.live.sources import SourceError
from localize.live.touches import TouchTracker
from localize.signals.array_response import response_of
from studies.inference.live import check_needs_no_samples

pytestmark = [needs_compiler, pytest.mark.skipif(not hasattr(os, "openpty"), reason="no terminals here")]
NOISE = 1e-2


@pytest.fixture(autouse=True)
def patient(monkeypatch):
    """All samples wait until they are taken: these boards are faster than time."""
    monkeypatch.setattr(serial_port, "QUEUE", 60.0)


@pytest.fixture(scope="module")
def array():
    return rc_line(6)


@pytest.fixture(scope="module")
def signals(array):
    """(2, 6000) Pa at 1 kHz: four touches of a second."""
    made = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 30).signals.double().numpy()
    noise = NOISE * np.random.default_rng(0).standard_normal((2, 6000))
    for turn, sample in enumerate(np.argsort(-made.std(-1).max(1))[:4]):
        noise[:, 1500 * turn + 500 : 1500 * turn + 1500] += made[sample]
    return noise


def worn(frames, seed=1):
    """The frames, of which 1 % are overwritten and 1 % are left out; and which are whole."""
    random = np.random.default_rng(seed)
    fate = random.choice(3, len(frames), p=[0.98, 0.01, 0.01])
    fate[[0, 1, 2, -1]] = 0
    sent = []
    for frame, each in zip(frames, fate, strict=True):
        at = int(random.integers(0, len(frame) - 8))
        sent.append((frame, frame[:at] + random.bytes(8) + frame[at + 8 :], b"")[each])
    return sent, fate == 0


def heard_until(end, found):
    """Keeps events in a list until one of a time has come."""

    def hear(session, heard, line):
        json.loads(line)
        found.append(heard.event)
        return not (isinstance(heard.event, (Decision, TouchEvent)) and heard.event.time >= end)

    return hear


def test_samples_of_a_worn_line_are_decided_as_if_they_were_pushed_with_their_gaps(tmp_path, array, signals):
    decoder = localize.BayesDecoder(array, NOISE)
    sent, whole = worn(Board().stream(signals, first=2**32 - 3000, limit=50.0), 6)
    assert 3 <= (~whole).sum() < 20
    found = []
    with PseudoPort(tmp_path / "board", sent, 0.002) as port:
        source = studies.LiveInput(serial=str(port.path))
        summary = studies.listen(decoder, source, hear=heard_until(5.98, found))
    expected, stream = [], localize.open_model(decoder).stream(50.0)
    frames = np.flatnonzero(np.arange(len(sent)) % 17 != 0)  # every 17th frame is the state of the board
    starts = range(0, 6000, 16)
    for first, number in zip(starts, frames, strict=True):
        if whole[number]:
            expected += stream.push(signals[:, first : first + 16], first)
    lost = sum(min(16, 6000 - first) for first, number in zip(starts, frames, strict=True) if not whole[number])
    decided = [[each for each in events if isinstance(each, Decision)] for events in (found, expected)]
    assert len(decided[0]) == len(decided[1]) > 200
    for a, b in zip(*decided, strict=True):
        assert (a.time, a.state, a.point) == (pytest.approx(b.time), b.state, b.point)
    assert summary.samples_lost == lost > 0
    assert (summary.line.lost, summary.line.restarts) == ((~whole).sum(), 0)
    tracker = TouchTracker(array)
    told = [touch for event in expected for touch in tracker.take(event)]
    same = [(each.kind, each.touch, each.point, round(each.time, 6)) for each in told]
    events = [each for each in found if isinstance(each, TouchEvent)]
    assert [(each.kind, each.touch, each.point, round(each.time, 6)) for each in events] == same
    assert summary.touches >= 3


def test_touches_of_a_board_come_as_they_were_sent_and_what_is_lost_is_told(tmp_path, array):
    board, sent, kinds = Board(), [], ("down", "moved", "up")
    sent.append(board.status(0, points=6, microphones=2, mode="events", name="rc-line-6"))
    for k in range(3000):
        sent.append(board.touch(100 * k, k // 3 + 1, kinds[k % 3], k % 6 + 1, 0.75, 0.5, 0.0625))
        if k % 10 == 9:
            sent.append(board.status(100 * k, lost=k // 1000, points=6, microphones=2, mode="events", name="rc-line-6"))
    worn_bytes, whole = worn(sent, 2)
    found = []
    decoder = localize.BayesDecoder(array, NOISE)
    with PseudoPort(tmp_path / "board", worn_bytes) as port:
        source = studies.LiveInput(serial=str(port.path))
        summary = studies.listen(decoder, source, tmp_path / "lines.jsonl", hear=heard_until(299.9, found))
    touches = [each for each in found if isinstance(each, TouchEvent)]
    numbers = [round(10 * each.time) for each in touches]
    assert len(numbers) > 2900
    assert sorted(set(numbers)) == numbers
    for k, each in zip(numbers, touches, strict=True):
        assert (each.kind, each.touch, each.point) == (kinds[k % 3], k // 3 + 1, k % 6 + 1)
    told = [int(each.text.split()[0]) for each in found if isinstance(each, Notice) and each.kind == "frames lost"]
    assert sum(told) == summary.line.lost == (~whole).sum() > 30
    assert sum(each.samples for each in found if isinstance(each, Fault)) == summary.samples_lost == 2
    assert len((tmp_path / "lines.jsonl").read_text().splitlines()) == len(found)


class LineInRuns:
    """Line to a board that is unplugged after each run of frames."""

    port = "board"

    def __init__(self, *runs):
        self.counts = LineCounts()
        self._runs = list(runs)
        self.open()

    def open(self):
        self.first = FrameReader(self.counts).push(b"".join(self._runs.pop(0)))

    def taken(self):
        return self.first

    def read(self):
        raise SourceError("has gone", kind=Kind.STOPPED, field="serial", value=self.port)

    def close(self):
        pass


def test_frames_lost_while_a_line_is_opened_are_told_each_time(array):
    runs = []
    for lost in (1, 3):
        board = Board()
        touches = [board.touch(100 * k, k + 1, "down", 1) for k in range(6)]
        runs.append(touches[:1] + touches[1 + lost :])
    listener = BoardListener(LineInRuns(*runs), response_of(array).array, wait=lambda seconds: None)
    found = []
    for heard in listener.listen():
        found.append(heard.event)
        if sum(isinstance(each, TouchEvent) for each in found) == sum(map(len, runs)):
            break
    told = [each.text for each in found if isinstance(each, Notice) and each.kind == "frames lost"]
    assert told == ["1 frame of board", "3 frames of board"]


def test_a_board_with_another_version_of_the_frames_is_named(tmp_path):
    other = bytearray(Board().status())
    other[2] = 2
    other[10:12] = crc_hqx(bytes(other[:10]), 0xFFFF).to_bytes(2, "little")
    with (
        PseudoPort(tmp_path / "board", [bytes(other)]) as port,
        refused(Kind.UNSUITABLE, "serial", str(port.path)) as found,
    ):
        BoardLine(str(port.path))
    assert found.value.notice().startswith(f"{port.path}: sends frames of version 2;")


def test_a_board_that_is_unplugged_is_awaited(tmp_path, array, signals, monkeypatch):
    decoder = localize.BayesDecoder(array, NOISE)
    frames, found = Board().stream(signals), []
    first = PseudoPort(tmp_path / "board", frames[:100], 0.002)
    second = PseudoPort(tmp_path / "board", Board().stream(signals)[:200], 0.002)

    def hear(session, heard, line):
        found.append(heard.event)
        if isinstance(heard.event, Decision) and heard.event.time > 1.4 and first.path.is_symlink():
            first.unplug()
        if isinstance(heard.event, Notice) and heard.event.kind == "source lost" and not second.path.is_symlink():
            second.__enter__()
        kinds = [each.kind for each in found if isinstance(each, Notice)]
        return not (kinds[-1:] == ["source back"] and isinstance(heard.event, Decision))

    with first:
        studies.listen(decoder, studies.LiveInput(serial=str(first.path)), record=tmp_path / "r.wav", hear=hear)
        second.unplug()
    kinds = [each.kind for each in found if isinstance(each, Notice)]
    assert (kinds[0], kinds[-1]) == ("source lost", "source back")
    assert {each.name for each in tmp_path.glob("*.wav")} == {"r.wav", "r-2.wav"}


def test_a_recording_of_a_board_holds_its_samples_and_zeros_for_lost_ones(tmp_path, signals):
    frames = Board().stream(signals, limit=50.0)
    del frames[7]  # after a status: samples 96 to 111
    with PseudoPort(tmp_path / "board", frames, 0.001) as port:
        made = studies.record_board(str(port.path), tmp_path / "r.wav", seconds=2)
    sound = read_wav(tmp_path / "r.wav")
    found = np.stack([sound.channels["1"], sound.channels["2"]])
    assert (sound.rate, found.shape, made.seconds) == (1000, (2, 2000), 2.0)
    expected = signals[:, :2000].copy()
    expected[:, 96:112] = 0
    np.testing.assert_allclose(found, expected, atol=np.abs(signals).max() / 60_000)
    assert (made.samples_lost, made.line.lost, made.microphones) == (16, 1, 2)
    with refused(Kind.EXISTS, "out"):
        studies.record_board("anything", tmp_path / "r.wav")


def test_what_happened_to_a_port_and_what_to_do_is_said(tmp_path, array, signals):
    absent = str(tmp_path / "board")
    with refused(Kind.MISSING, "serial", absent) as found:
        BoardLine(absent)
    assert "is not there; plug the board in, or give another port; " in str(found.value)
    assert found.value.notice().startswith(f"{absent}: is not there; plug")
    with refused(Kind.MISSING, "serial", "socket://127.0.0.1:1") as found:
        BoardLine("socket://127.0.0.1:1")
    assert str(found.value).endswith("check the address, and that a program answers there")
    port, told = PseudoPort(tmp_path / "board", Board().stream(signals)[:100], 0.002), []

    def hear(text):
        told.append(text)
        if len(told) == 2:
            raise KeyboardInterrupt

    with port:
        threading.Timer(1.0, port.unplug).start()
        made = studies.record_board(absent, tmp_path / "r.wav", hear=hear)
    assert made.recordings == (tmp_path / "r.wav",)
    assert told[0].startswith(f"{absent} (1000 Hz): ")
    assert told[0].endswith("waiting until it is back, or press Ctrl-C to end the recording")
    assert told[1].startswith(f"{absent}: is not there; plug the board in")


def test_a_recording_is_a_wav_file(tmp_path):
    with refused(Kind.OUT_OF_RANGE, "out", str(tmp_path / "r.txt")):
        studies.record_board(str(tmp_path / "board"), tmp_path / "r.txt")


def test_what_is_no_board_is_refused(tmp_path, array, monkeypatch):
    decoder = localize.BayesDecoder(array, NOISE)
    with refused(Kind.MISSING, "serial"):
        studies.record_board(str(tmp_path / "board"), tmp_path / "r.wav")
    monkeypatch.setattr(serial_port, "FIRST_FRAME", 0.3)
    with PseudoPort(tmp_path / "board", [b"hello\r\n"] * 5) as port, refused(Kind.MISSING, "serial") as found:
        studies.listen(decoder, studies.LiveInput(serial=str(port.path)))
    assert "other bytes came" in str(found.value)
    touches = [Board().status(points=5, mode="events", name="other")] * 50
    with PseudoPort(tmp_path / "board", touches, 0.01) as port:
        source = studies.LiveInput(serial=str(port.path))
        with refused(Kind.MISMATCH, "serial"):
            studies.listen(decoder, source)
        with refused(Kind.CONFLICT, "record"):
            studies.listen(decoder, source, record=tmp_path / "r.wav")
        with refused(Kind.MISMATCH, "serial"):
            studies.record_board(str(port.path), tmp_path / "r.wav")
    for given, named in (
        ({"channels": {"left": 1, "right": 2}}, "channels"),
        ({"two_touches": True}, "two_touches"),
        ({"library": "array.nc"}, "library"),
        ({"air": acoustic_fem.LocalAir(temperature_c=25.0)}, "temperature_c"),
    ):
        with PseudoPort(tmp_path / "board", touches, 0.01) as port:
            board = BoardLine(str(port.path))
            channels = given.pop("channels", None)
            source = studies.LiveInput(serial=str(port.path), channels=channels)
            with refused(Kind.CONFLICT, named):
                check_needs_no_samples(board, source, None, None, localize.model.Decoding(**given))
    three = PseudoPort(tmp_path / "board", Board().stream(np.ones((3, 800))), 0.01)
    with three, refused(Kind.MISMATCH, "serial"):
        studies.listen(decoder, studies.LiveInput(serial=str(three.path)))
    assert not (tmp_path / "r.wav").exists()
