"""Listening while it happens: blocks of a source to 1 kHz, into a stream, decisions out with the age of their samples.

The stream counts in samples of 1 kHz since the first one. A source that is lost is opened again until it is back; the
count then goes on by the clock, so that the stream tells how many samples are missing.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter, sleep
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from localize.live.events import Decision, Fault, SeveralTouches, TouchEvent, TrackedGesture, TrackedPlace
from localize.live.recorder import LiveRecorder
from localize.live.sources import Block, BlockQueue, Source, SourceError
from localize.live.stream import TouchStream
from localize.live.stream_options import ListenerOptions
from localize.signals.resampling import StreamResampler
from localize.signals.stimulus import SAMPLE_RATE


@dataclass(frozen=True)
class Notice:
    """Notice of what happens to the source or the recording, or of a sensor that does not fit its library."""

    time: float
    """Time of the sample that is due, s; the stream's sample 0 is at 0."""
    kind: Literal["source lost", "source back", "recording stopped", "sensor does not fit", "frames lost"]
    """Kind of what happened."""
    text: str
    """Reason or result, in words for the user."""

    def json_line(self) -> str:
        """Notice as one line of JSON."""
        return json.dumps({"time": round(self.time, 6), "notice": self.kind, "text": self.text})


@dataclass(frozen=True)
class Heard:
    """Event of a stream, with the time at which its samples were there."""

    event: Decision | Fault | TouchEvent | SeveralTouches | TrackedPlace | TrackedGesture | Notice
    """Decision or fault of the stream, touch, place, gesture, or notice of the listener."""
    available: float | None = None
    """Time at which what the frame of a decision shows last was there, s on the clock of ``time.perf_counter``: its
    last sample, less the delay of the stream's high-pass."""

    def json_line(self, latency: float | None) -> str:
        """Event as one line of JSON, of a decision with ``latency`` in s, which adds to that of a touch or a place."""
        if isinstance(self.event, (TouchEvent, SeveralTouches, TrackedPlace)):
            return replace(self.event, latency=self.event.latency + (latency or 0.0)).json_line()
        line = self.event.json_line()
        if latency is None or isinstance(self.event, TrackedGesture):
            return line
        return f'{line[:-1]}, "latency": {latency:.5f}}}'


class Tracker(Protocol):
    """Tracker that combines frames into touches, places or gestures."""

    def take(self, event: object) -> Sequence[TouchEvent | SeveralTouches | TrackedPlace | TrackedGesture | Notice]:
        """Take the next event of a stream and say what it means."""

    def finish(self) -> Sequence[TouchEvent | SeveralTouches | TrackedPlace | TrackedGesture | Notice]:
        """Say what is left to say when the stream ends."""


class LiveListener:
    """Listener that joins a source to a stream.

    Args:
        source: where samples come from.
        stream: listens to them; new.
        recorder: writes them as they come in.
        wait: called with the time to wait, s, before a lost source is opened again.
        trackers: report touches, places and gestures while they happen; by default nothing does.
        options: when a source is lost and how it is opened again.
    """

    def __init__(
        self,
        source: Source,
        stream: TouchStream,
        recorder: LiveRecorder | None = None,
        wait: Callable[[float], None] = sleep,
        trackers: Sequence[Tracker] = (),
        options: ListenerOptions = ListenerOptions(),
    ) -> None:
        self.source, self.stream, self.recorder, self.options = source, stream, recorder, options
        self.trackers = tuple(trackers)
        """Trackers that report touches, places, gestures and a sensor that does not fit."""
        self.stopped = ""
        """Why the recording was stopped while the listening went on, in one line with its file; empty if it was not."""
        self._wait = wait
        self._channels = len(stream.locator.microphones)
        self._paths: list[Path] = [] if recorder is None else recorder.paths
        self.recent: NDArray[np.float64] = np.zeros((self._channels, options.recent))
        """(n_microphone, n) Pa: the newest samples, replaced whenever there are more."""
        self._began: float | None = None  # when the stream's sample 0 was there
        self._due = 0  # number of the stream's sample that comes next
        self._new_run()

    @property
    def recordings(self) -> tuple[Path, ...]:
        """Files that were recorded so far."""
        return tuple(self._paths)

    def __iter__(self) -> Generator[Heard, None, None]:
        return self.listen()

    def listen(self) -> Generator[Heard, None, None]:
        """Events until the source ends; close it to stop earlier.

        Raises:
            SourceError: the source is not there at the beginning; later it is waited for.
            OSError: the recording cannot be begun; later it is stopped, and :attr:`stopped` says why.
        """
        try:
            queue = self.source.open()
            if self.recorder is not None:
                self.recorder.begin()
            while True:
                reason = yield from self._run(queue)
                if reason is None:
                    return
                self.source.close()
                yield self._notice("source lost", f"{self.source.name}: {reason}")
                queue = yield from self._opened_again(reason)
                self._new_run()
                yield self._notice("source back", self.source.name)
                yield from self._record(LiveRecorder.begin)
        finally:
            self.source.close()
            if self.recorder is not None:
                self.recorder.close()

    def _new_run(self) -> None:
        """The source counts from 0 again."""
        self._resampler = StreamResampler(self.source.rate, self._channels, self.source.limit)
        self._input = 0  # number of the source's sample that comes next
        self._offset: int | None = None  # number in the stream of the resampler's sample 0

    def _run(self, queue: BlockQueue) -> Generator[Heard, None, str | None]:
        """Listen until the source ends or is lost; returns why it is lost."""
        heard_at = perf_counter()
        while True:
            # Asked before the queue is, so that samples from before the end are still processed.
            ended, reason = self.source.ended, self.source.trouble
            block = queue.get(0.0 if ended or reason else self.options.poll)
            if block is not None:
                heard_at = perf_counter()
                yield from self._take(block)
            elif ended:
                yield from self._finish(queue)
                return None
            elif reason:
                return reason
            elif perf_counter() - heard_at > self.options.stall:
                return f"no samples for {self.options.stall:g} s"

    def _opened_again(self, reason: str) -> Generator[Heard, None, BlockQueue]:
        """Open a lost source as soon as it is back; a reason that differs from the last one is reported."""
        attempt = 0
        while True:
            waits = self.options.waits
            self._wait(waits[min(attempt, len(waits) - 1)])
            attempt += 1
            try:
                return self.source.open()
            except SourceError as error:
                notice = error.notice()
                if notice != reason:
                    yield self._notice("source lost", notice)
                reason = notice

    def _take(self, block: Block) -> Iterator[Heard]:
        if self._offset is None:
            first_at = block.available - (block.first + block.samples.shape[1] - 1) / self.source.rate
            if self._began is None:
                self._began = first_at
            missing = round((first_at - self._began) * SAMPLE_RATE)
            self._offset = max(missing, self._due + 1) if self._due else 0
        lost = block.first - self._input
        if lost:
            # Never less than one sample of 1 kHz: a gap must not pass for none.
            self._resampler.skip(block.first, self._resampler.next + 1)
            yield from self._record(lambda recorder: recorder.skip(lost))
        self._input = block.first + block.samples.shape[1]
        yield from self._record(lambda recorder: recorder.write(block.samples))
        yield from self._push(self._resampler.push(block.samples), block)

    def _finish(self, queue: BlockQueue) -> Iterator[Heard]:
        """The end of the filter, and what was dropped behind the last block that was taken."""
        if self._offset is None:
            return
        yield from self._push(self._resampler.finish(), None)
        for tracker in self.trackers:
            for told in tracker.finish():
                yield Heard(told)
        if queue.end > self._input:
            end = -(-queue.end * self._resampler.up // self._resampler.down) + self._offset
            for event in self.stream.push(np.empty((self._channels, 0)), max(end, self._due + 1)):
                yield Heard(event)

    def _push(self, samples: NDArray[np.float64], block: Block | None) -> Iterator[Heard]:
        if not samples.shape[1] or self._offset is None:
            return
        self._due = self._offset + self._resampler.next
        events = self.stream.push(samples, self._due - samples.shape[1])
        self.recent = np.concatenate([self.recent, samples], axis=1)[:, -self.options.recent :]
        for event in events:
            available = self._available(event, block)
            yield Heard(event, available)
            for tracker in self.trackers:
                for told in tracker.take(event):
                    yield Heard(told, None if isinstance(told, Notice) else available)

    def _available(self, event: Decision | Fault, block: Block | None) -> float | None:
        """When the last sample of a decision's frame was there, by that of the block that came last."""
        if block is None or self._offset is None or not isinstance(event, Decision):
            return None
        number = round(event.time * SAMPLE_RATE) - 1 - self._offset
        place = number * self._resampler.down / self._resampler.up
        return block.available + (place - (self._input - 1)) / self.source.rate - self.stream.delay

    def _record(self, act: Callable[[LiveRecorder], None]) -> Iterator[Heard]:
        """Do something with the recorder; a disk that is full ends the recording, not the listening."""
        if self.recorder is None:
            return
        try:
            act(self.recorder)
        except OSError as error:
            self.stopped = f"{error.filename or 'the recording'}: cannot be written: {error.strerror or error}"
            with suppress(OSError):
                self.recorder.close()
            self.recorder = None
            yield self._notice("recording stopped", error.strerror or str(error))

    def _notice(self, kind: Literal["source lost", "source back", "recording stopped"], text: str) -> Heard:
        return Heard(Notice(self._due / SAMPLE_RATE, kind, text))


class Latencies:
    """Percentiles of any number of latencies in memory that does not grow."""

    STEP = 5e-5
    """Resolution of the percentiles, s."""
    _COUNT = 40_000

    def __init__(self) -> None:
        self._bins = np.zeros(self._COUNT, np.int64)
        self.largest = 0.0
        """s."""

    def add(self, latency: float) -> None:
        """Take one latency, in s; beyond 2 s only the largest is known exactly."""
        self._bins[min(max(int(latency / self.STEP), 0), self._COUNT - 1)] += 1
        self.largest = max(self.largest, latency)

    @property
    def count(self) -> int:
        """Number of latencies so far."""
        return int(self._bins.sum())

    def percentile(self, share: float) -> float:
        """Latency in s that ``share`` percent do not exceed, to :attr:`STEP` above; 0 of none."""
        total = np.cumsum(self._bins)
        if not total[-1]:
            return 0.0
        return float((np.searchsorted(total, share / 100 * total[-1]) + 1) * self.STEP)
