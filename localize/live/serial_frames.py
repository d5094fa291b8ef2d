"""Frames of a board on a serial line: bytes in, frames out, with a count of what was lost or damaged on the way.

docs/serial.md has the table of bytes, and ``touch_serial.c`` of :mod:`localize.embedded` writes the frames. A header
with a check of its own gives the length of each frame, so a damaged length never hides the frames behind it. The reader
looks for the next frame from the byte after a damaged one's first on. It accepts no frame whose checks fail.
"""

from __future__ import annotations

import struct
from binascii import crc_hqx
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from geometry.ground.refusal import Kind
from localize.live.sources import SourceError

VERSION = 1
"""Version of the frames that is read."""
SYNC = b"\xa5\x5a"
"""First bytes of every frame."""
_HEADER = struct.Struct("<2sBBIHH")
_STATUS = struct.Struct("<IIIfHBB")
_SAMPLES = struct.Struct("<IHBBff")
_TOUCH = struct.Struct("<IIHBBfff")
_LARGEST_PAYLOAD = _SAMPLES.size + 2 * 256
_LOST = -32768
KINDS: dict[int, Literal["down", "moved", "beat", "up"]] = {1: "down", 2: "moved", 3: "beat", 4: "up"}
"""Kinds of touches by their numbers in a frame."""
_MODES: tuple[Literal["raw", "events"], ...] = ("raw", "events")
_CRC_START = 0xFFFF


@dataclass(frozen=True)
class StatusFrame:
    """State of the board, which it sends at its start and four times a second."""

    counter: int
    """Number of the frame, from 0 at the start of the board."""
    sample: int
    """Samples at 1 kHz since the start."""
    lost: int
    """Samples at 1 kHz that the board lost since its start."""
    unsent: int
    """Frames for which the line had no room since the start."""
    limit: float
    """Pressure at which a sample is clipped, Pa; 0 where none is."""
    points: int
    """Number of points of the board's array."""
    microphones: int
    """Number of its microphones."""
    mode: Literal["raw", "events"]
    """``raw`` if the board sends samples, ``events`` if it sends touches."""
    name: str
    """Name of the array, its first 32 bytes."""


@dataclass(frozen=True, eq=False)
class SampleFrame:
    """Samples of all microphones."""

    counter: int
    """Number of the frame, from 0 at the start of the board."""
    first: int
    """Number of the first sample, modulo 2^32."""
    rate: int
    """Sample rate, Hz."""
    limit: float
    """Pressure at which a sample is clipped, Pa; 0 where none is."""
    samples: NDArray[np.float64]
    """(n_microphone, n) float64, Pa; NaN for samples that the board lost."""


@dataclass(frozen=True)
class TouchFrame:
    """Touch that came down, moved, beat or ended, as the board decided."""

    counter: int
    """Number of the frame, from 0 at the start of the board."""
    sample: int
    """Samples at 1 kHz up to the end of the frame that decided it, modulo 2^32."""
    touch: int
    """Number of the touch, from 1."""
    kind: Literal["down", "moved", "beat", "up"]
    """What happened."""
    point: int
    """Point that is touched from now on, or was until now, from 1."""
    probability: float
    """Probability of that point by all frames of the touch."""
    level: float
    """Level of the loudest microphone, Pa rms."""
    latency: float
    """Longest time from the event to its report on the board, s."""


BoardFrame: TypeAlias = StatusFrame | SampleFrame | TouchFrame


@dataclass
class LineCounts:
    """Counts of a serial line since it was opened."""

    frames: int = 0
    """Frames that were accepted."""
    lost: int = 0
    """Frames whose number is missing between accepted ones: damaged, lost on the line or not sent."""
    damaged: int = 0
    """Stretches of bytes between accepted frames that are no frame."""
    restarts: int = 0
    """Times that the board began to count anew."""


@dataclass
class FrameReader:
    """Reader of a stream of bytes that may begin anywhere, and of which any part may be damaged or missing."""

    counts: LineCounts = field(default_factory=LineCounts)
    """Counts so far."""
    _bytes: bytearray = field(default_factory=bytearray)
    _due: int | None = None  # number of the frame that comes next
    _between: bool = False  # whether bytes were passed over since the last accepted frame

    def push(self, received: bytes) -> list[BoardFrame]:
        """Frames that the next bytes complete, any number of bytes at a time.

        Raises:
            SourceError: the board sends another version of the frames.
        """
        self._bytes += received
        found, at, data = list[BoardFrame](), 0, self._bytes
        while (start := data.find(SYNC, at)) >= 0 and start + _HEADER.size <= len(data):
            self._pass_over(start - at)
            at = start
            header = bytes(data[start : start + _HEADER.size])
            _, version, kind, counter, length, check = _HEADER.unpack(header)
            if crc_hqx(header[:-2], _CRC_START) != check or length > _LARGEST_PAYLOAD:
                at += self._pass_over(1)
                continue
            if version != VERSION:
                problem = f"sends frames of version {version}; this program reads version {VERSION}"
                raise SourceError(problem, kind=Kind.UNSUITABLE, field="serial")
            end = start + _HEADER.size + length + 2
            if end > len(data):
                break
            whole = bytes(data[start:end])
            if crc_hqx(whole[:-2], _CRC_START) != int.from_bytes(whole[-2:], "little"):
                at += self._pass_over(1)
                continue
            at = end
            self._count(counter)
            frame = _frame_of(kind, counter, whole[_HEADER.size : -2])
            found += [] if frame is None else [frame]
        else:
            # The last byte may be the first one of a frame.
            kept = start if start >= 0 else max(at, len(data) - data.endswith(SYNC[:1]))
            self._pass_over(kept - at)
            at = kept
        del data[:at]
        return found

    def _pass_over(self, count: int) -> int:
        """Pass over bytes that are no frame; returns their number."""
        if count and not self._between:
            self._between = True
            self.counts.damaged += 1
        return count

    def _count(self, counter: int) -> None:
        missing = 0 if self._due is None else (counter - self._due) % 2**32
        if missing >= 2**31:
            self.counts.restarts += 1
        else:
            self.counts.lost += missing
        self._due = (counter + 1) % 2**32
        self.counts.frames += 1
        self._between = False


def _frame_of(kind: int, counter: int, payload: bytes) -> BoardFrame | None:
    """Frame of a kind; None where this version knows no such frame."""
    if kind == 1 and len(payload) >= _STATUS.size:
        sample, lost, unsent, limit, points, microphones, mode = _STATUS.unpack_from(payload)
        name = payload[_STATUS.size :].decode("utf-8", "ignore")
        if mode < len(_MODES):
            return StatusFrame(counter, sample, lost, unsent, limit, points, microphones, _MODES[mode], name)
    if kind == 2 and len(payload) >= _SAMPLES.size:
        first, rate, microphones, count, step, limit = _SAMPLES.unpack_from(payload)
        numbers = np.frombuffer(payload, "<i2", offset=_SAMPLES.size)
        if len(numbers) == microphones * count and count and rate:
            samples = np.where(numbers == _LOST, np.nan, step * numbers.astype(np.float64))
            return SampleFrame(counter, first, rate, limit, samples.reshape(count, microphones).T)
    if kind == 3 and len(payload) == _TOUCH.size:
        sample, touch, point, happened, _, probability, level, latency = _TOUCH.unpack(payload)
        if happened in KINDS:
            return TouchFrame(counter, sample, touch, KINDS[happened], point, probability, level, latency)
    return None
