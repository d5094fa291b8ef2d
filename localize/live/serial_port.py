"""A board on a serial port: its frames, and its samples as a source, by the package ``pyserial``, which is optional."""

from __future__ import annotations

import errno
import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from importlib import import_module
from threading import Event, Thread
from time import perf_counter
from typing import Any

import numpy as np

from geometry.ground.argument_checks import check_range, check_unused
from geometry.ground.extras import check_extras
from geometry.ground.refusal import Field, Kind, counted, said_by
from geometry.ground.typed import Array
from localize.live.serial_frames import BoardFrame, FrameReader, LineCounts, SampleFrame, StatusFrame, TouchFrame
from localize.live.sources import QUEUE, Block, BlockQueue, SourceError, rate_out_of_range
from localize.live.stream_options import BAUD
from localize.recordings.channel_choice import chosen_channels
from localize.recordings.recording import HIGHEST_RATE, LOWEST_RATE

FIRST_FRAME = 3.0
"""Time within which a board must send a frame after its port is opened, s; it sends its state four times a second."""
NEARLY = 1 - 1e-4
"""Share of the limit of a board from which a sample is clipped: 16 bits round it."""
_POLL = 0.05
_RATES = (300, 20_000_000)
#: Beginnings of addresses whose line has no speed.
_WITHOUT_SPEED = ("socket://",)
#: Errors of the system, and what they say of a port.
_IS_ABSENT = (errno.ENOENT, errno.ENODEV, errno.ENXIO)
_IS_FORBIDDEN = (errno.EACCES, errno.EPERM)


def check_baud(port: str, baud: int | None) -> None:
    """Reject a speed, bit/s, that is out of range, or of a port that has no speed; None for the usual one."""
    if baud is None:
        return
    check_range("baud", baud, *_RATES, "bit/s", whole=True)
    if port.startswith(_WITHOUT_SPEED):
        check_unused({"baud": baud}, f": {port} is a connection over a network, which has no speed", unit="bit/s")


class BoardLine:
    """Line to a board on a serial port, which is open.

    Args:
        port: such as ``/dev/ttyACM0`` or ``COM3``, or an address of pyserial such as ``socket://host:4000``.
        baud: speed of the line, bit/s. USB serial ports ignore it.

    Raises:
        MissingExtra: pyserial is not installed.
        SourceError: the port is not there or cannot be opened, or no frame comes from it within three seconds.
        Refusal: a speed out of range.
    """

    def __init__(self, port: str, baud: int | None = None) -> None:
        check_extras("what reads a serial port", "serial")
        check_baud(str(port), baud)
        self._serial: Any = import_module("serial")
        self.port, self.baud = str(port), BAUD if baud is None else baud
        self.counts = LineCounts()
        """Counts of the line, whenever it was opened."""
        self._port: Any = None
        self._reader = FrameReader(self.counts)
        self.first: list[BoardFrame] = []
        """Frames that came first after the port was opened, which nobody has taken."""
        self.open()

    @property
    def mode(self) -> str:
        """``raw`` if the board sends samples, ``events`` if it sends touches."""
        for frame in self.first:
            if isinstance(frame, StatusFrame):
                return frame.mode
        return "events" if isinstance(self.first[0], TouchFrame) else "raw"

    def open(self) -> None:
        """Open the port, if it is not open, and wait for the first frame."""
        if self._port is not None:
            return
        try:
            self._port = self._serial.serial_for_url(self.port, baudrate=self.baud, timeout=_POLL)
        except (self._serial.SerialException, ValueError, OSError) as error:
            raise _not_opened(self.port, error) from None
        self._reader = FrameReader(self.counts)
        began, self.first = perf_counter(), []
        try:
            while not self.first:
                self.first = self.read()
                if perf_counter() - began > FIRST_FRAME and not self.first:
                    passed = "other bytes came" if self.counts.damaged else "nothing came"
                    problem = f"sent no frame within {FIRST_FRAME:g} s at {self.baud} bit/s; {passed}"
                    remedy = (
                        "check that the board runs the firmware of acoustic-fem embed",
                        *(() if self.port.startswith(_WITHOUT_SPEED) else (", and its speed, ", Field("baud"))),
                    )
                    raise SourceError(problem, kind=Kind.MISSING, field="serial", value=self.port, remedy=remedy)
        except BaseException:
            self.close()
            raise

    def read(self) -> list[BoardFrame]:
        """Frames that have come, at the latest after a twentieth of a second.

        Raises:
            SourceError: the port is gone, or the board sends another version of the frames.
        """
        try:
            received = self._port.read(max(1, self._port.in_waiting))
        except (self._serial.SerialException, OSError, TypeError) as error:  # TypeError: closed meanwhile
            problem = f"has gone: the board was unplugged, or another program reads it too ({said_by(error)})"
            remedy = "plug the board in again, and close the other program"
            raise SourceError(problem, kind=Kind.STOPPED, field="serial", value=self.port, remedy=remedy) from None
        try:
            return self._reader.push(received)
        except SourceError as error:  # the reader does not know the port
            raise SourceError.of(error, value=self.port) from None

    def taken(self) -> list[BoardFrame]:
        """Frames that came first, for whoever reads on."""
        found, self.first = self.first, []
        return found

    def close(self) -> None:
        """Close the port, if it is open."""
        port, self._port = self._port, None
        if port is not None:
            with suppress(self._serial.SerialException, OSError):  # a port that is gone cannot be closed
                port.close()


def _not_opened(port: str, error: Exception) -> SourceError:
    """Refusal of a port that cannot be opened: what happened, and what to do."""
    problem, remedy = _reason(port, getattr(error, "errno", None), said_by(error))
    return SourceError(problem, kind=Kind.MISSING, field="serial", value=port, remedy=remedy)


def _reason(port: str, number: int | None, text: str) -> tuple[str, str]:
    """Problem of a port and its remedy, by the number of an error and its words."""
    if "://" in port:
        return f"cannot be opened: {text}", "check the address, and that a program answers there"
    # Windows gives pyserial no number of an error.
    if number in _IS_ABSENT or "FileNotFoundError" in text:
        return "is not there", f"plug the board in, or give another port; {_ports_here()}"
    if number in _IS_FORBIDDEN and os.name == "posix":
        remedy = "add your user to the group of serial ports, on most systems dialout, and log in again"
        return "may not be opened by your user", remedy
    if number == errno.EBUSY or "PermissionError" in text:
        return "is in use by another program", "close that program"
    return f"cannot be opened: {text}", f"give the port of a board; {_ports_here()}"


def _ports_here() -> str:
    """Serial ports of this computer in words."""
    found = sorted(each.device for each in import_module("serial.tools.list_ports").comports())
    return f"the ports of this computer are {', '.join(found)}" if found else "this computer has no serial port now"


class SerialSource:
    """Source of the samples of a board.

    Args:
        line: to the board, in raw mode.
        microphones: names of the array's microphones; by default "1", "2" and so on, as many as the board has.
        channels: microphone -> channel of the board, from 1; by default all in the order of the microphones.

    Raises:
        SourceError: the board sends touches, has fewer microphones than channels, or another number without
            ``channels``; or a rate outside 250 Hz to 1 MHz.
    """

    def __init__(
        self, line: BoardLine, microphones: Sequence[str] | None = None, channels: Mapping[str, int] | None = None
    ) -> None:
        self._line = line
        try:
            frame = self._first_samples()
            count = len(frame.samples)
            self.microphones = tuple(microphones or (str(k + 1) for k in range(count)))
            if channels is None and count != len(self.microphones):
                names = f"{len(self.microphones)}: {', '.join(self.microphones)}"
                problem = f"has {counted(count, 'microphone')}, must have {names}"
                raise SourceError(problem, kind=Kind.MISMATCH, field="serial", value=line.port)
            self._channels = chosen_channels(self.microphones, channels, count, line.port, SourceError)
            if not LOWEST_RATE <= frame.rate <= HIGHEST_RATE:
                raise rate_out_of_range(frame.rate, line.port)
        except BaseException:
            line.close()
            raise
        self._count = count
        self.rate = float(frame.rate)
        self.limit = NEARLY * frame.limit if frame.limit > 0 else None
        self.name = f"{line.port} ({self.rate:g} Hz)"
        self.ended = False
        self.trouble: str | None = None
        self._stop = Event()
        self._thread: Thread | None = None

    @property
    def counts(self) -> LineCounts:
        """Counts of the line."""
        return self._line.counts

    def open(self) -> BlockQueue:
        """Begin to read the samples."""
        self._line.open()
        queue = BlockQueue(QUEUE, self.rate)
        self.trouble = None
        self._stop.clear()
        self._thread = Thread(target=self._read, args=(queue,), name="serial", daemon=True)
        self._thread.start()
        return queue

    def close(self) -> None:
        """Stop reading, and close the port."""
        self._stop.set()
        if self._thread is not None:
            self._thread.join()
            self._thread = None
        self._line.close()

    def _first_samples(self) -> SampleFrame:
        """First frame of samples, which is kept for :meth:`open`."""
        line, began = self._line, perf_counter()
        while True:
            if line.mode == "events":
                problem = "sends touches, not samples; set the board to raw mode"
                raise SourceError(problem, kind=Kind.MISMATCH, field="serial", value=line.port)
            for frame in line.first:
                if isinstance(frame, SampleFrame):
                    return frame
            if perf_counter() - began > FIRST_FRAME:
                problem = f"sent its state, but no samples within {FIRST_FRAME:g} s"
                raise SourceError(problem, kind=Kind.MISSING, field="serial", value=line.port)
            line.first += line.read()

    def _read(self, queue: BlockQueue) -> None:
        samples, restarts = _SampleCount(), self.counts.restarts
        frames = self._line.taken()
        while not self._stop.is_set():
            now = perf_counter()
            for frame in frames:
                if isinstance(frame, StatusFrame) and frame.mode != "raw":
                    self.trouble = "the board sends touches now"
                    return
                if not isinstance(frame, SampleFrame):
                    continue
                if frame.rate != self.rate or len(frame.samples) != self._count:
                    self.trouble = "the board has another rate or other microphones now"
                    return
                first = samples.number(frame)
                if first is None:
                    self.trouble = "the board was started again"
                    return
                for start, part in _good_parts(frame.samples[self._channels]):
                    queue.put(Block(part, first + start, now))
            if self.counts.restarts != restarts:
                self.trouble = "the board was started again"
                return
            try:
                frames = self._line.read()
            except SourceError as error:
                self.trouble = str(error.problem)
                return


class _SampleCount:
    """Numbers of samples without an end, from those of 32 bits."""

    def __init__(self) -> None:
        self._first: int | None = None
        self._due = 0

    def number(self, frame: SampleFrame) -> int | None:
        """Number of the first sample of a frame since the first frame; None where the board counts anew."""
        if self._first is None:
            self._first = frame.first
        step = (frame.first - self._first - self._due) % 2**32
        if step >= 2**31:
            return None
        first = self._due + step
        self._due = first + frame.samples.shape[1]
        return first


def _good_parts(samples: Array) -> list[tuple[int, Array]]:
    """Stretches without a sample that was lost on the board, and where they begin; a gap between them is a loss."""
    good = np.isfinite(samples).all(0)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], good, [False]]).astype(int)))
    return [(int(a), samples[:, a:b]) for a, b in edges.reshape(-1, 2)]
