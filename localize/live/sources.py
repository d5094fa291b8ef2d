"""Where live samples come from: what a source is, the queue behind it, and a WAV file played in real time.

A source runs a thread of its own, that of the audio system or one that keeps the time, and puts blocks into a queue. It
never waits for whoever takes them: what does not fit is dropped, and the numbers of the blocks tell how much it was.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from queue import Empty, SimpleQueue
from threading import Event, Lock, Thread
from time import perf_counter
from typing import Protocol, TypeAlias

import numpy as np

from acoustic_fem.sound.sound_file import read_wav
from geometry.ground.file_checks import MOST_NUMBERS
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.recordings.channel_choice import check_count, chosen_channels
from localize.recordings.recording import HIGHEST_RATE, LOWEST_RATE, check_length

BLOCK = 0.004
"""Length of the blocks in which a source hands on its samples, s."""
QUEUE = 2.0
"""Length of the samples that wait to be taken, s; more are dropped."""

Correction: TypeAlias = Callable[[Array, float, float | None], Array]
"""Makes samples, (n_microphone, n) float64, Pa, of others, their rate, Hz, and the pressure of clipped ones, Pa."""


class SourceError(Refusal):
    """Refusal of a source that cannot be listened to: one line with the reason."""

    def notice(self) -> str:
        """The refusal while the source is waited for: its name, the problem and the remedy, no argument of a call."""
        if self.field != "serial":
            return str(self)
        return Refusal.of(self, file=str(self.value), field="", value=self.NOT_GIVEN).sentence()


@dataclass(frozen=True, eq=False)
class Block:
    """Block of samples that came in together."""

    samples: Array
    """Pressures at the microphones, at the rate of the source; (n_microphone, n) float64, Pa."""
    first: int
    """Number of the first sample since the source was opened; a step beyond the end of the block before is a loss."""
    available: float
    """Time at which the last sample was there, before any buffer, s on the clock of ``time.perf_counter``."""


class BlockQueue:
    """Queue of blocks on their way from the thread of a source to that which decodes; bounded, and never waits to put.

    Args:
        seconds: length of the samples that it holds, s.
        rate: of the samples, Hz.
    """

    def __init__(self, seconds: float, rate: float) -> None:
        self._room = max(1, round(seconds * rate))
        self._blocks: SimpleQueue[Block] = SimpleQueue()
        self._lock = Lock()
        self._held = 0
        self.end = 0
        """Number of the sample behind the last one that came in, dropped ones included."""

    def put(self, block: Block) -> None:
        """Take a block, or drop it if the queue is full."""
        count = block.samples.shape[1]
        with self._lock:
            self.end = block.first + count
            if self._held + count > self._room:
                return
            self._held += count
        self._blocks.put(block)

    def get(self, timeout: float) -> Block | None:
        """Oldest block; None where none comes within ``timeout`` s."""
        try:
            block = self._blocks.get(timeout=timeout)
        except Empty:
            return None
        with self._lock:
            self._held -= block.samples.shape[1]
        return block


class Source(Protocol):
    """Source that can be listened to live."""

    @property
    def name(self) -> str:
        """Name of the source in words, for the user."""

    @property
    def rate(self) -> float:
        """Sample rate, Hz; the same whenever it is opened."""

    @property
    def limit(self) -> float | None:
        """Pressure at which a sample is clipped, Pa; None without such a limit."""

    def open(self) -> BlockQueue:
        """Begin to put blocks into a new queue, numbered from 0.

        Raises:
            SourceError: it is not there.
        """

    def close(self) -> None:
        """End the blocks, if the source is open."""

    @property
    def ended(self) -> bool:
        """True if all there is has been put into the queue."""

    @property
    def trouble(self) -> str | None:
        """Reason why no more samples come, though there should be more; None where all is well."""


def rate_out_of_range(rate: float, file: str | os.PathLike[str]) -> SourceError:
    """Refusal of a sample rate, Hz, of a file or the device of a name."""
    allowed = f"between {LOWEST_RATE:g} and {HIGHEST_RATE:g} Hz"
    return SourceError(kind=Kind.OUT_OF_RANGE, file=file, field="sample rate", value=rate, unit="Hz", allowed=allowed)


class ReplaySource:
    """Source of a WAV file, played as if it came in now.

    Args:
        path: of the file.
        microphones: names of the array's microphones.
        full_scale: pressure of the largest value of the file, Pa.
        channels: microphone -> channel of the file, from 1; by default all channels in the order of the microphones.
        correct: makes the samples that are played of those of the file, (n_microphone, n) Pa, their rate, Hz, and the
            pressure at which they were clipped, Pa or None; by default they stay as they are.

    Raises:
        SoundFileError: the file cannot be read.
        SourceError: a channel that is not there, more channels than microphones without ``channels``, less than one
            frame, above 2^26 samples, or a rate outside 250 Hz to 1 MHz.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        microphones: Sequence[str],
        full_scale: float = 1.0,
        channels: Mapping[str, int] | None = None,
        correct: Correction | None = None,
    ) -> None:
        self._path = Path(path)
        sound = read_wav(self._path)
        if channels is None:
            check_count(len(sound.channels), microphones, self._path, SourceError)
        picked = chosen_channels(microphones, channels, len(sound.channels), str(self._path), SourceError)
        if not LOWEST_RATE <= sound.rate <= HIGHEST_RATE:
            raise rate_out_of_range(sound.rate, self._path)
        count = sound.length
        check_length(self._path, count, sound.rate, SourceError)
        if count * len(picked) > MOST_NUMBERS:
            problem = f"has {count} samples of {len(picked)} microphones; at most {MOST_NUMBERS} in all can be played"
            raise SourceError(problem, kind=Kind.UNSUITABLE, file=self._path)
        self._samples = np.stack([full_scale * sound.channels[str(k + 1)] for k in picked])
        self.rate = sound.rate
        self.limit = None if sound.full_scale is None else sound.full_scale * full_scale
        if correct is not None:
            self._samples = correct(self._samples, self.rate, self.limit)
        self._thread: Thread | None = None
        self._stop = Event()
        self._ended = Event()
        self.trouble = None

    @property
    def name(self) -> str:
        """Path of the file, for the user."""
        return f"{self._path}, played"

    @property
    def ended(self) -> bool:
        """True if the last sample was put."""
        return self._ended.is_set()

    def open(self) -> BlockQueue:
        """Begin to play."""
        queue = BlockQueue(QUEUE, self.rate)
        self._stop.clear()
        self._ended.clear()
        self._thread = Thread(target=self._play, args=(queue,), name="replay", daemon=True)
        self._thread.start()
        return queue

    def close(self) -> None:
        """Stop playing."""
        self._stop.set()
        if self._thread is not None:
            self._thread.join()

    def _play(self, queue: BlockQueue) -> None:
        size = max(1, round(BLOCK * self.rate))
        started = perf_counter()
        for first in range(0, self._samples.shape[1], size):
            samples = self._samples[:, first : first + size]
            # A late turn of this thread counts as latency, as that of an audio system would.
            available = started + (first + samples.shape[1]) / self.rate
            if self._stop.wait(max(0.0, available - perf_counter())):
                return
            queue.put(Block(samples, first, available))
        self._ended.set()
