"""Recordings of the samples that a board sends over a serial port."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import perf_counter, sleep

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from localize.live.recorder import LiveRecorder
from localize.live.serial_frames import LineCounts
from localize.live.serial_port import BoardLine, SerialSource
from localize.live.sources import BlockQueue, SourceError
from localize.live.stream_options import ListenerOptions
from studies.output.folders import check_new_file, claimed_file

_LONGEST = 86_400.0


@dataclass(frozen=True)
class RecordedBoard:
    """Recording of a board."""

    recordings: tuple[Path, ...]
    """Files that were recorded; one for each time that the port was opened."""
    seconds: float
    """Length of all files, s."""
    microphones: int
    """Number of microphones, each a channel in the order of the board."""
    rate: float
    """Sample rate, Hz."""
    limit: float | None
    """Pressure at which a sample is clipped, Pa; None where none is."""
    samples_lost: int
    """Number of samples that were lost, which are zeros in the files."""
    line: LineCounts
    """Counts of the frames of the line."""


def record_board(
    serial: str,
    out: str | os.PathLike[str],
    *,
    seconds: float | None = None,
    baud: int | None = None,
    hear: Callable[[str], object] | None = None,
) -> RecordedBoard:
    """Recording of a board in raw mode, until it has the length that is asked for, or until Ctrl-C.

    If the board is unplugged, the recording waits for it and goes on in another file.

    Args:
        serial: port of the board, such as ``/dev/ttyACM0`` or ``COM3``.
        out: a new WAV file, in Pa; readable even if the program is killed.
        seconds: length of the recording, s; by default until Ctrl-C.
        baud: speed of the line, bit/s, by default 115,200. USB serial ports ignore it.
        hear: function that is called with a line of text when the board is lost or back.

    Raises:
        Refusal: a file that exists or cannot be written, a length that is not between 0.1 s and a day, a port that
            cannot be opened, or a board that sends touches.
        OSError: the disk is full.
    """
    path = Path(out)
    check = partial(check_new_file, path, ".wav", kept="a recording")
    check()
    if path.suffix.lower() != ".wav":
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="out", value=str(path), allowed="a name that ends with .wav")
    if seconds is not None:
        check_range("seconds", seconds, 0.1, _LONGEST, "s")
    source = SerialSource(BoardLine(serial, baud))
    with ExitStack() as stack:
        stack.callback(source.close)
        stack.enter_context(claimed_file(path, check))
        recorder = LiveRecorder(path, source.rate, len(source.microphones))
        stack.callback(recorder.close)
        taken = _Recording(source, recorder, math.inf if seconds is None else round(seconds * source.rate))
        with suppress(KeyboardInterrupt):
            taken.run(hear or (lambda text: None))
    return RecordedBoard(
        tuple(recorder.paths),
        taken.count / source.rate,
        len(source.microphones),
        source.rate,
        source.limit,
        taken.lost,
        source.counts,
    )


class _Recording:
    """Samples from a source into a recorder."""

    def __init__(self, source: SerialSource, recorder: LiveRecorder, wanted: float) -> None:
        self._source, self._recorder, self._wanted = source, recorder, wanted
        self.count = self.lost = 0
        self._options = ListenerOptions()

    def run(self, hear: Callable[[str], object]) -> None:
        queue = self._source.open()
        while True:
            self._recorder.begin()
            reason = self._one_run(queue)
            if reason is None:
                return
            self._source.close()
            hear(f"{self._source.name}: {reason}; waiting until it is back, or press Ctrl-C to end the recording")
            queue = self._opened_again(reason, hear)
            hear(f"{self._source.name} is back")

    def _one_run(self, queue: BlockQueue) -> str | None:
        """Record until there is enough, or the source is lost; returns why it is lost."""
        due, heard_at = 0, perf_counter()
        while self.count < self._wanted:
            reason = self._source.trouble
            block = queue.get(0.0 if reason else self._options.poll)
            if block is None:
                if reason is None and perf_counter() - heard_at > self._options.stall:
                    reason = f"no samples for {self._options.stall:g} s"
                if reason is not None:
                    return reason
                continue
            heard_at = perf_counter()
            missing, room = block.first - due, self._wanted - self.count
            due = block.first + block.samples.shape[1]
            gap = int(min(missing, room))
            self._recorder.skip(gap)
            self.lost += gap
            samples = block.samples[:, : int(min(block.samples.shape[1], room - gap))]
            self._recorder.write(samples)
            self.count += gap + samples.shape[1]
        return None

    def _opened_again(self, reason: str, hear: Callable[[str], object]) -> BlockQueue:
        attempt = 0
        while True:
            waits = self._options.waits
            sleep(waits[min(attempt, len(waits) - 1)])
            attempt += 1
            try:
                return self._source.open()
            except SourceError as error:
                notice = error.notice()
                if notice != reason:
                    hear(notice)
                reason = notice
