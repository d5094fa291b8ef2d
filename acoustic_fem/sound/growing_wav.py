"""A WAV file that grows while it is recorded, and can be read whenever the process that writes it is killed.

A name for a whole file only, as of all other results, would lose a recording with its process. Here samples are
appended first, and then the head is rewritten to state them: it never states more than there is, and what lies behind
is passed over by readers. The head is 58 bytes in the first page of the file and written by one call, which a signal
does not cut in two. A cut of power is another matter: nothing is forced onto the disk before the end.
"""

from __future__ import annotations

import os
import struct
from io import FileIO
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np

from geometry.ground.argument_checks import check_range, check_shape
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import writing

LARGEST = 2**31
"""Bytes of samples in a file; WAV can state twice that, and many readers no more than this."""
_HEAD = "<4sI4s4sIHHIIHHH4sII4sI"
_HEAD_BYTES = struct.calcsize(_HEAD)
_FLOAT = 3


class GrowingWav:
    """One WAV file of 32-bit floating-point numbers.

    Args:
        path: a file that is there is replaced.
        rate: Hz.
        channels: how many.

    Raises:
        OSError: it cannot be written.
        Refusal: no channel, or a rate that a WAV file cannot state.
    """

    def __init__(self, path: str | os.PathLike[str], rate: int, channels: int) -> None:
        for name, value, most in (("rate", rate, 2**31), ("channels", channels, 1024)):
            check_range(name, value, 1, most)
        self.path, self.rate, self.channels = Path(path), rate, channels
        self.samples = 0
        """Written per channel."""
        self._file = FileIO(self.path, "wb")
        try:
            with writing(self.path):
                self._write_head()
        except OSError:  # a disk that is full from the beginning leaves no file
            self._file.close()
            if self.path.is_file():  # and no device
                self.path.unlink()
            raise

    @property
    def full(self) -> bool:
        """True if another second might not fit."""
        return 4 * self.channels * (self.samples + self.rate) > LARGEST

    def write(self, samples: Array) -> None:
        """Append samples, (n_channel, n) float64, of full scale.

        Raises:
            Refusal: another number of channels, or more than the file can hold.
            OSError: it cannot be written: the disk is full.
        """
        check_shape("samples", samples, (self.channels, "n"), "a row for each channel")
        if 4 * self.channels * (self.samples + samples.shape[1]) > 2 * LARGEST - _HEAD_BYTES:
            raise Refusal(
                f"cannot hold {self.samples + samples.shape[1]} samples: a WAV file has at most {2 * LARGEST} bytes",
                kind=Kind.OUT_OF_RANGE,
                file=self.path,
            )
        self._file.seek(_HEAD_BYTES + 4 * self.channels * self.samples)
        rest = memoryview(np.ascontiguousarray(samples.T, "<f4").tobytes())
        with writing(self.path):
            while rest:
                rest = rest[self._file.write(rest) :]
            self.samples += samples.shape[1]
            self._write_head()

    def close(self) -> None:
        """Close the file, with all of it on the disk."""
        if not self._file.closed:
            os.fsync(self._file.fileno())
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _write_head(self) -> None:
        frame = 4 * self.channels
        size = frame * self.samples
        head = struct.pack(
            _HEAD,
            *(b"RIFF", _HEAD_BYTES - 8 + size, b"WAVE"),
            *(b"fmt ", 18, _FLOAT, self.channels, self.rate, self.rate * frame, frame, 32, 0),
            *(b"fact", 4, self.samples),
            *(b"data", size),
        )
        self._file.seek(0)
        self._file.write(head)
