"""Touches that a board has decided on, as they come in over its serial line."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from time import perf_counter, sleep
from typing import Literal

import numpy as np

from geometry.ground.refusal import Kind, counted
from geometry.ground.typed import Array
from localize.live.events import Fault, TouchEvent
from localize.live.listener import Heard, Notice
from localize.live.serial_frames import BoardFrame, SampleFrame, StatusFrame, TouchFrame
from localize.live.serial_port import BoardLine
from localize.live.sources import SourceError
from localize.live.stream_options import ListenerOptions
from localize.signals.array_facts import ArrayFacts
from localize.signals.stimulus import SAMPLE_RATE


class BoardListener:
    """Listener to a board that sends touches.

    A port that is lost is opened again until it is back. Touches are reported as the board sent them. If a frame is
    lost, a notice says how many, because a touch may have been in it.

    Args:
        line: to the board.
        array: that the board must have.
        wait: called with the time to wait, s, before a lost port is opened again.
        options: when a board is lost and how its port is opened again.

    Raises:
        SourceError: the board was made for another array.
    """

    stopped = ""
    """Never anything: nothing is recorded."""
    recordings: tuple[Path, ...] = ()
    """No files: a board that sends touches sends no samples."""

    def __init__(
        self,
        line: BoardLine,
        array: ArrayFacts,
        wait: Callable[[float], None] = sleep,
        options: ListenerOptions = ListenerOptions(),
    ) -> None:
        self._line, self._array, self._wait, self._options = line, array, wait, options
        self.recent: Array = np.zeros((len(array.microphones), 1))
        """(n_microphone, 1) zeros: a board that sends touches sends no samples."""
        self._time = 0.0
        self._lost_frames = 0  # lost frames that a notice has reported, whenever the line was opened
        self._new_run()
        try:
            for frame in line.first:
                self._check(frame)
        except SourceError:
            line.close()
            raise

    @property
    def name(self) -> str:
        """Name of what is listened to."""
        return f"{self._line.port} (touches of the board)"

    def listen(self) -> Generator[Heard, None, None]:
        """Events without an end; close it to stop.

        Raises:
            SourceError: the board sends samples, or was made for another array.
        """
        frames, heard_at = self._line.taken(), perf_counter()
        try:
            while True:
                reason = None
                for frame in frames:
                    self._check(frame)
                    yield from self._events(frame)
                    heard_at = perf_counter()
                try:
                    frames = self._line.read()
                except SourceError as error:
                    reason = error.notice()
                if not reason and perf_counter() - heard_at > self._options.stall:
                    reason = f"{self._line.port}: no frames for {self._options.stall:g} s"
                if reason:
                    self._line.close()
                    yield self._notice("source lost", reason)
                    yield from self._opened_again(reason)
                    self._new_run()
                    frames, heard_at = self._line.taken(), perf_counter()
                    yield self._notice("source back", self.name)
        finally:
            self._line.close()

    def _new_run(self) -> None:
        self._lost_on_board: int | None = None
        self._restarts = self._line.counts.restarts

    def _check(self, frame: BoardFrame) -> None:
        """Refuse a board that sends samples, or that was made for another array."""
        port, array = self._line.port, self._array
        if isinstance(frame, SampleFrame) or (isinstance(frame, StatusFrame) and frame.mode == "raw"):
            raise SourceError("sends samples now, not touches", kind=Kind.MISMATCH, field="serial", value=port)
        if not isinstance(frame, StatusFrame):
            return
        expected = (array.point_count, len(array.microphones), _sent(array.design))
        if (frame.points, frame.microphones, frame.name) != expected:
            problem = (
                f"is a board for {frame.name!r} with {counted(frame.points, 'point')} and "
                f"{counted(frame.microphones, 'microphone')}; the model is of {array.design!r} with {expected[0]} and "
                f"{expected[1]}"
            )
            raise SourceError(problem, kind=Kind.MISMATCH, field="serial", value=port)

    def _events(self, frame: BoardFrame) -> Iterator[Heard]:
        counts = self._line.counts
        if counts.restarts > self._restarts:
            self._restarts, self._lost_on_board = counts.restarts, None
            yield Heard(Fault(self._time, "restarted"))
        if counts.lost > self._lost_frames:
            missing = counts.lost - self._lost_frames
            self._lost_frames = counts.lost
            yield self._notice("frames lost", f"{counted(missing, 'frame')} of {self._line.port}")
        if isinstance(frame, StatusFrame):
            self._time = frame.sample / SAMPLE_RATE
            before, self._lost_on_board = self._lost_on_board, frame.lost
            if before is not None and frame.lost > before:
                yield Heard(Fault(self._time, "samples lost", samples=frame.lost - before))
        elif isinstance(frame, TouchFrame):
            self._time = frame.sample / SAMPLE_RATE
            told = TouchEvent(
                time=self._time,
                kind=frame.kind,
                touch=frame.touch,
                point=frame.point,
                probability=frame.probability,
                level=frame.level,
                latency=frame.latency,
            )
            yield Heard(told, perf_counter())

    def _opened_again(self, reason: str) -> Iterator[Heard]:
        attempt = 0
        while True:
            waits = self._options.waits
            self._wait(waits[min(attempt, len(waits) - 1)])
            attempt += 1
            try:
                self._line.open()
            except SourceError as error:
                notice = error.notice()
                if notice != reason:
                    yield self._notice("source lost", notice)
                reason = notice
            else:
                return

    def _notice(self, kind: Literal["source lost", "source back", "frames lost"], text: str) -> Heard:
        return Heard(Notice(self._time, kind, text))


def _sent(name: str) -> str:
    """Name of a design as a board sends it: its first 32 bytes."""
    return name.encode()[:32].decode("utf-8", "ignore")
