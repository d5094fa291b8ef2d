"""Live input: decisions are those of the whole recording, and whatever happens to the source is told and survived."""

from __future__ import annotations

import itertools
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from fake_audio import FakeAudio, Run
from hypothesis import given, settings, strategies as st
from rc_line import rc_line
from refusals import refused

import localize
from acoustic_fem.sound.sound_file import read_wav
from geometry import Kind
from localize import Decision, Fault, TouchStream
from localize.live.listener import Latencies, LiveListener, Notice
from localize.live.recorder import LiveRecorder
from localize.live.sound_device import DeviceSource, input_devices
from localize.live.sources import Block, BlockQueue, SourceError
from localize.live.stream_options import ListenerOptions
from localize.signals.resampling import at_one_kilohertz

NOISE = 1e-2


@pytest.fixture(scope="module")
def array():
    return rc_line(6)


@pytest.fixture(scope="module")
def decoder(array):
    return localize.BayesDecoder(array, NOISE)


@pytest.fixture(scope="module")
def signals(array):
    """(2, 6000) Pa at 1 kHz: touches of a second, each behind half a second of noise."""
    made = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 30).signals.double().numpy()
    noise = NOISE * np.random.default_rng(0).standard_normal((2, 6000))
    for turn, sample in enumerate(np.argsort(-made.std(-1).max(1))[:4]):
        noise[:, 1500 * turn + 500 : 1500 * turn + 1500] += made[sample]
    return noise


@dataclass
class Given:
    """A source of blocks as they are given, at once; None is a loss of the source."""

    blocks: list[list[Block]]
    rate: float
    limit: float | None = None
    name: str = "given"
    room: float = 60.0
    ended: bool = False
    trouble: str | None = None
    opened: int = 0
    closed: int = field(default=0)

    def open(self) -> BlockQueue:
        queue = BlockQueue(self.room, self.rate)
        self.trouble = None
        for block in self.blocks[self.opened]:
            queue.put(block)
        self.opened += 1
        self.ended = self.opened == len(self.blocks)
        self.trouble = None if self.ended else "it was taken away"
        return queue

    def close(self) -> None:
        self.closed += 1


def blocks(samples: np.ndarray, rate: float, cuts: list[int], start: float = 100.0) -> list[Block]:
    edges = [0, *sorted(cuts), samples.shape[1]]
    return [Block(samples[:, a:b], a, start + (b - 1) / rate) for a, b in itertools.pairwise(edges) if b > a]


def stretched(signals: np.ndarray, factor: int) -> np.ndarray:
    """At ``factor`` kHz, by straight lines."""
    n = signals.shape[1]
    return np.stack([np.interp(np.arange(n * factor) / factor, np.arange(n), row) for row in signals])


@settings(max_examples=6, deadline=None)
@given(factor=st.sampled_from([1, 8, 44]), cuts=st.lists(st.floats(0, 1), max_size=40))
def test_decisions_are_those_of_the_whole_recording(decoder, signals, factor, cuts) -> None:
    samples = stretched(signals[:, :1400], round(factor))
    rate = 1000.0 * factor
    source = Given([blocks(samples, rate, [round(c * samples.shape[1]) for c in cuts])], rate)
    heard = list(LiveListener(source, TouchStream(decoder)).listen())
    assert [h.event for h in heard] == TouchStream(decoder).push(at_one_kilohertz(samples, rate))
    assert source.closed == 1


def test_the_age_of_a_decision_is_that_of_the_last_sample_of_its_frame(decoder, signals) -> None:
    for rate, factor in ((1000.0, 1), (8000.0, 8)):
        samples = stretched(signals[:, :1000], factor)
        source = Given([blocks(samples, rate, list(range(0, samples.shape[1], 33)))], rate)
        stream = TouchStream(decoder)
        assert 1e-3 < stream.delay < 3e-3
        for heard in LiveListener(source, stream).listen():
            if heard.available is not None:
                number = round(heard.event.time * 1000) - 1
                assert heard.available == pytest.approx(100 + number / 1000 - stream.delay, abs=1e-6)


def test_samples_that_found_no_room_are_told_by_their_number(decoder, signals) -> None:
    # the queue holds two seconds; all three come at once and nobody takes them
    source = Given([blocks(signals[:, :3000], 1000.0, list(range(0, 3000, 10)))], 1000.0, room=2.0)
    events = [heard.event for heard in LiveListener(source, TouchStream(decoder)).listen()]
    assert events[-1] == Fault(2.0, "samples lost", samples=1000)
    assert events[:-1] == TouchStream(decoder).push(signals[:, :2000])


@pytest.mark.parametrize("factor", [1, 8])
def test_a_gap_between_blocks_is_told_and_no_frame_spans_it(decoder, signals, factor) -> None:
    samples = stretched(signals[:, :3000], factor)
    given = blocks(samples, 1000.0 * factor, list(range(0, 3000 * factor, 10 * factor)))
    source = Given([given[:100] + given[150:]], 1000.0 * factor)
    events = [heard.event for heard in LiveListener(source, TouchStream(decoder)).listen()]
    (fault,) = [event for event in events if isinstance(event, Fault)]
    # behind the filter the last 10 ms before the gap are missing too
    assert fault == Fault(1.0, "samples lost", samples=500) if factor == 1 else Fault(0.99, "samples lost", samples=510)
    after = [event for event in events if event.time > 1.5]
    if factor == 1:
        assert after == TouchStream(decoder).push(samples[:, 1500:], 1500)
    assert after[0].time == 1.75


def test_a_device_gives_what_it_recorded_and_the_recording_gives_the_same_again(decoder, signals, tmp_path) -> None:
    raw = (stretched(signals, 48) / 2).astype(np.float32)
    board = np.zeros((raw.shape[1], 4), np.float32)
    board[:, 3], board[:, 1] = raw
    audio = FakeAudio([Run(board[:96_000], end="stall")], pace=0.0002)
    source = DeviceSource(("left", "right"), "usb", 2.0, {"left": 4, "right": 2}, audio)
    assert (source.rate, source.name) == (48_000.0, "USB array (ALSA, 48000 Hz)")
    recorder = LiveRecorder(tmp_path / "live.wav", source.rate, 2, 2.0)
    stream = TouchStream(decoder, limit=source.limit)
    expected = TouchStream(decoder).push(at_one_kilohertz(2.0 * raw[:, :96_000].astype(np.float64), 48_000.0))
    heard = []
    listening = LiveListener(source, stream, recorder).listen()
    for each in listening:
        heard.append(each.event)
        if len(heard) == len(expected) - 1:  # the end of the filter has no end of the device to wait for
            break
    # all has been taken from the queue but perhaps the last blocks, behind the last whole frame
    listening.close()
    assert heard == expected[: len(heard)]
    written = read_wav(tmp_path / "live.wav")
    count = len(written.channels["1"])
    assert count > 95_000
    np.testing.assert_array_equal(np.stack(list(written.channels.values())), raw[:, :count])
    again = localize.read_recording(tmp_path / "live.wav", ("left", "right"), 2.0)
    assert TouchStream(decoder).push(again.signals)[: len(heard) - 1] == heard[:-1]
    (arguments,) = audio.opened
    assert (arguments["channels"], arguments["dtype"], arguments["blocksize"]) == (4, "float32", 192)


def test_an_overflow_of_the_device_is_a_loss_by_its_clock(decoder, signals) -> None:
    board = (stretched(signals[:, :2000], 8) / 2).T.astype(np.float32)
    audio = FakeAudio(
        [Run(board, "stall", overflow_at=100, overflow_samples=800)], rate=8000.0, channels=2, pace=0.0002
    )
    listening = LiveListener(DeviceSource(("left", "right"), None, 2.0, None, audio), TouchStream(decoder)).listen()
    faults = [heard.event for heard in itertools.takewhile(lambda h: h.event.time < 1.5, listening)]
    listening.close()
    assert [fault for fault in faults if isinstance(fault, Fault)] == [Fault(0.39, "samples lost", samples=110)]


def test_clipping_is_seen_before_the_filter_hides_it(decoder, signals) -> None:
    board = (stretched(signals[:, :1500], 48) / 2).T.astype(np.float32)
    board[48_000:48_003, 1] = 1.0
    audio = FakeAudio([Run(board, "stall")], channels=2, pace=0.0002)
    source = DeviceSource(("left", "right"), None, 2.0, None, audio)
    listening = LiveListener(source, TouchStream(decoder, limit=source.limit)).listen()
    events = [heard.event for heard in itertools.takewhile(lambda h: h.event.time < 1.4, listening)]
    listening.close()
    (fault,) = [event for event in events if isinstance(event, Fault)]
    assert (fault.kind, fault.channel) == ("clipped", "right")
    states = {event.time: event.state for event in events if isinstance(event, Decision)}
    assert {state for at, state in states.items() if 1.02 < at < 1.24} == {"unreadable"}
    assert states[0.986] != "unreadable"


@pytest.mark.slow
@pytest.mark.parametrize("end", ["stop", "stall"])
def test_a_device_that_is_unplugged_is_waited_for(decoder, signals, tmp_path, end) -> None:
    # Longer than a thread waits for its turn on a busy machine.
    options = ListenerOptions(stall=5.0 if end == "stall" else 600.0)
    board = (stretched(signals[:, :1000], 8) / 2).T.astype(np.float32)
    audio = FakeAudio(
        [Run(board, end), Run(board, "stall")],
        rate=8000.0,
        channels=2,
        absent=2,
        failures=["Error opening InputStream: Device unavailable"],
        pace=0.0002,
    )
    waits: list[float] = []
    recorder = LiveRecorder(tmp_path / "live.wav", 8000.0, 2, 2.0)
    source = DeviceSource(("left", "right"), 1, 2.0, None, audio)
    listening = LiveListener(
        source, TouchStream(decoder), recorder, lambda s: (waits.append(s), time.sleep(0.02)), options=options
    )
    events = []
    for heard in (run := listening.listen()):
        events.append(heard.event)
        back = [k for k, event in enumerate(events) if isinstance(event, Notice) and event.kind == "source back"]
        if back and sum(isinstance(event, Decision) for event in events[back[0] :]) > 20:
            break
    run.close()
    notices = [event for event in events if isinstance(event, Notice)]
    assert [notice.kind for notice in notices] == ["source lost", "source lost", "source lost", "source back"]
    reason = "the device has stopped" if end == "stop" else "no samples for 5 s"
    assert [notice.text for notice in notices] == [
        f"USB array (ALSA, 8000 Hz): {reason}",
        "USB array: is not there",
        "USB array: Error opening InputStream: Device unavailable",
        "USB array (ALSA, 8000 Hz)",
    ]
    assert waits == [0.5, 1.0, 2.0, 5.0]
    # opened by the number it has now
    assert [arguments["device"] for arguments in audio.opened] == [1, 2]
    (fault,) = [event for event in events if isinstance(event, Fault)]
    assert fault.kind == "samples lost"
    assert fault.time == pytest.approx(0.99, abs=0.002)
    first = next(event for event in events[events.index(fault) :] if isinstance(event, Decision))
    assert first.time == pytest.approx(fault.time + fault.samples / 1000 + 0.25)
    times = [event.time for event in events if isinstance(event, Decision)]
    assert times == sorted(times)
    assert [path.name for path in recorder.paths] == ["live.wav", "live-2.wav"]
    np.testing.assert_array_equal(read_wav(tmp_path / "live.wav").channels["1"], board[:, 0])


def test_devices_are_chosen_by_number_or_part_of_a_name() -> None:
    audio = FakeAudio([])
    (only,) = input_devices(audio)
    assert (only.number, only.name, only.host, only.channels, only.default) == (1, "USB array", "ALSA", 4, True)
    names = ("A", "B")
    for device in (None, 1, "usb", "USB array"):
        assert DeviceSource(names, device, sounddevice=audio).name.startswith("USB array")
    for device in (7, "x"):
        with refused(Kind.UNKNOWN, "device", device, error=SourceError):
            DeviceSource(names, device, sounddevice=audio)
    for channels in ({"A": 1}, {"A": 1, "B": 1}, {"A": 1, "C": 2}):
        with refused(Kind.OUT_OF_RANGE, "channels", error=SourceError):
            DeviceSource(names, None, channels=channels, sounddevice=audio)
    with refused(Kind.MISSING, "channels", 9, error=SourceError):
        DeviceSource(names, None, channels={"A": 1, "B": 9}, sounddevice=audio)
    with refused(Kind.OUT_OF_RANGE, "sample rate", 50.0, error=SourceError):
        DeviceSource(names, None, sounddevice=FakeAudio([], rate=50.0))
    with refused(Kind.MISSING, error=SourceError):
        DeviceSource(names, None, sounddevice=FakeAudio([], channels=0))


@pytest.mark.parametrize(
    ("device", "host"),
    [
        ("USB array, Windows WASAPI", "Windows WASAPI"),
        ("usb array, windows wdm-ks", "Windows WDM-KS"),
        ("USB, WASAPI", "Windows WASAPI"),
        ("array,mme", "MME"),
        (1, "MME"),
        (None, "MME"),
    ],
)
def test_a_card_under_several_audio_systems_is_chosen_with_its_system(device: int | str | None, host: str) -> None:
    audio = FakeAudio([], hosts=("MME", "Windows WASAPI", "Windows WDM-KS"))
    assert DeviceSource(("A",), device, sounddevice=audio).name == f"USB array ({host}, 48000 Hz)"


@pytest.mark.parametrize("device", ["USB array", "usb", "", "USB, Windows", "array, w"])
def test_a_name_that_fits_several_audio_systems_is_refused_with_what_to_give(device: str) -> None:
    audio = FakeAudio([], hosts=("MME", "Windows WASAPI", "Windows WDM-KS"))
    with refused(Kind.UNKNOWN, "device", device, error=SourceError) as found:
        DeviceSource(("A",), device, sounddevice=audio)
    assert "2 'USB array, Windows WASAPI', 3 'USB array, Windows WDM-KS'" in str(found.value)
    for each in ("USB array, CoreAudio", "Speaker, MME", "mic, MME"):
        with refused(Kind.UNKNOWN, "device", each, error=SourceError):
            DeviceSource(("A",), each, sounddevice=audio)


def test_a_device_records_at_the_rate_that_was_asked_for() -> None:
    samples = np.zeros((1000, 2), np.float32)
    audio = FakeAudio([Run(samples)])
    source = DeviceSource(("A", "B"), None, sounddevice=audio, rate=44_100)
    source.open()
    source.close()
    assert (source.rate, source.name) == (44_100.0, "USB array (ALSA, 44100 Hz)")
    assert audio.opened[0]["samplerate"] == 44_100
    # a rate that the device states is not used, and may be nonsense
    assert DeviceSource(("A",), None, sounddevice=FakeAudio([], rate=50.0), rate=48_000).rate == 48_000.0


@pytest.mark.parametrize(
    ("rate", "kind"),
    [
        (12_345, Kind.UNSUITABLE),
        (192_000, Kind.UNSUITABLE),
        (0, Kind.OUT_OF_RANGE),
        (100, Kind.OUT_OF_RANGE),
        (2_000_000, Kind.OUT_OF_RANGE),
        (44_100.5, Kind.OUT_OF_RANGE),
    ],
)
def test_a_rate_that_a_device_does_not_take_is_refused(rate: int, kind: Kind) -> None:
    with refused(kind, "rate", rate, error=SourceError) as found:
        DeviceSource(("A",), None, sounddevice=FakeAudio([]), rate=rate)
    assert kind is Kind.OUT_OF_RANGE or "USB array, ALSA: Invalid sample rate; its own rate is 48000 Hz" in str(
        found.value
    )


@pytest.mark.parametrize(
    ("failure", "words"),
    [
        (
            ("Unanticipated host error", -9999, (0, -16, "Device or resource busy")),
            "Device or resource busy (error -16",
        ),
        (("Unanticipated host error", -9999, (0, -1005, "")), "error -1005 of the audio system"),
        (("Device unavailable", -9985), "USB array: Device unavailable"),
    ],
)
def test_the_error_of_the_audio_system_is_shown(failure: tuple[object, ...], words: str) -> None:
    audio = FakeAudio([Run(np.zeros((10, 2), np.float32))], failures=[failure], opened=[{}])
    source = DeviceSource(("A",), None, sounddevice=audio)
    with refused(Kind.STOPPED, file="USB array", error=SourceError) as found:
        source.open()
    assert words in str(found.value)


def test_putting_never_waits_and_a_bounded_queue_holds_what_it_can() -> None:
    queue = BlockQueue(1.0, 1000.0)
    for first in range(0, 100_000, 100):
        queue.put(Block(np.zeros((2, 100)), first, 0.0))  # one that waited would wait for ever
    held = [queue.get(0.0) for _ in range(11)]
    assert [block.first for block in held if block] == list(range(0, 1000, 100))
    assert held[-1] is None
    assert queue.end == 100_000
    queue.put(Block(np.zeros((2, 100)), 100_000, 0.0))
    assert queue.get(0.0).first == 100_000


def test_latencies_are_counted_in_memory_that_does_not_grow() -> None:
    latencies = Latencies()
    assert latencies.percentile(99) == 0
    drawn = np.random.default_rng(0).gamma(2.0, 0.004, 20_000)
    for value in drawn:
        latencies.add(float(value))
    latencies.add(9.0)
    assert latencies.count == 20_001
    assert latencies.largest == 9.0
    for share in (50, 99):
        assert latencies.percentile(share) == pytest.approx(np.percentile(drawn, share), abs=2e-4)


def test_a_full_disk_ends_the_recording_and_not_the_listening(decoder, signals, tmp_path, monkeypatch) -> None:
    source = Given([blocks(signals, 1000.0, list(range(0, 6000, 50)))], 1000.0)
    recorder = LiveRecorder(tmp_path / "a.wav", 1000.0, 2)
    write = recorder.write

    def fills(samples: np.ndarray) -> None:
        if recorder._file is not None and recorder._file.samples >= 100:
            raise OSError(28, "No space left on device", str(tmp_path / "a.wav"))
        write(samples)

    monkeypatch.setattr(recorder, "write", fills)
    listener = LiveListener(source, TouchStream(decoder), recorder)
    events = [heard.event for heard in listener.listen()]
    (stopped,) = [event for event in events if isinstance(event, Notice)]
    assert (stopped.kind, stopped.text) == ("recording stopped", "No space left on device")
    assert [event for event in events if event != stopped] == TouchStream(decoder).push(signals)
    assert listener.stopped == f"{tmp_path / 'a.wav'}: cannot be written: No space left on device"
    assert len(read_wav(tmp_path / "a.wav").channels["1"]) == 100


def test_a_recording_that_cannot_be_begun_ends_the_listening(decoder, signals) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs /dev/full")
    source = Given([blocks(signals, 1000.0, list(range(0, 6000, 50)))], 1000.0)
    listener = LiveListener(source, TouchStream(decoder), LiveRecorder("/dev/full", 1000.0, 2))
    with pytest.raises(OSError, match="No space left on device: '/dev/full'"):
        next(listener.listen())
    assert Path("/dev/full").exists()


def test_lost_samples_are_zeros_in_the_recording_and_no_file_is_replaced_by_a_second_one(tmp_path) -> None:
    (tmp_path / "a-2.wav").write_text("mine")
    recorder = LiveRecorder(tmp_path / "a.wav", 1000.0, 1, 4.0)
    recorder.begin()
    recorder.write(np.full((1, 10), 2.0))
    recorder.skip(2500)
    recorder.write(np.full((1, 10), 1.0))
    recorder.begin()
    recorder.close()
    samples = read_wav(tmp_path / "a.wav").channels["1"]
    assert (len(samples), samples[9], samples[10], samples[2509], samples[2510]) == (2520, 0.5, 0.0, 0.0, 0.25)
    assert [path.name for path in recorder.paths] == ["a.wav", "a-3.wav"]
    assert (tmp_path / "a-2.wav").read_text() == "mine"


# -- what the terminal shows -----------------------------------------------------------------------------
