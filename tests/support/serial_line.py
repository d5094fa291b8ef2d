"""The board's end of a serial line: the exported C encoder, built as a library of this machine."""

from __future__ import annotations

import ctypes
import functools
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from embedded_bench import COMPILER

import localize.embedded

SOURCES = Path(localize.embedded.__file__).parent / "sources"
LARGEST = 4096
KINDS = {"down": 1, "moved": 2, "beat": 3, "up": 4}


class _Line(ctypes.Structure):
    _fields_ = (("counter", ctypes.c_uint32),)


class _Status(ctypes.Structure):
    _fields_ = (
        ("sample", ctypes.c_uint32), ("lost", ctypes.c_uint32), ("unsent", ctypes.c_uint32), ("limit", ctypes.c_float),
        ("points", ctypes.c_int), ("microphones", ctypes.c_int), ("mode", ctypes.c_int), ("name", ctypes.c_char_p),
    )  # fmt: skip


class _Event(ctypes.Structure):
    _fields_ = (
        ("sample", ctypes.c_uint32), ("touch", ctypes.c_uint32), ("kind", ctypes.c_int), ("point", ctypes.c_int),
        ("probability", ctypes.c_float), ("level", ctypes.c_float), ("latency", ctypes.c_float),
    )  # fmt: skip


@functools.cache
def encoder() -> ctypes.CDLL:
    """The C encoder."""
    folder = tempfile.TemporaryDirectory()
    built = Path(folder.name) / "touch_serial.so"
    command = [str(COMPILER), "-std=c99", "-O1", "-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Wshadow",
               "-Werror", "-shared", "-fPIC", str(SOURCES / "touch_serial.c"), "-o", str(built)]  # fmt: skip
    subprocess.run(command, check=True, capture_output=True)
    library = ctypes.CDLL(str(built))
    folder.cleanup()
    for name in ("status", "touch", "samples"):
        getattr(library, f"touch_serial_{name}").restype = ctypes.c_size_t
    library.touch_serial_crc.restype = ctypes.c_uint16
    return library


class Board:
    """Writes frames one after the other, as a board does."""

    def __init__(self, counter: int = 0) -> None:
        self._line = _Line(counter)
        self._frame = (ctypes.c_uint8 * LARGEST)()

    @property
    def counter(self) -> int:
        """Number of the next frame."""
        return int(self._line.counter)

    def status(self, sample=0, lost=0, unsent=0, limit=0.0, points=12, microphones=2, mode="raw", name="array-2x6"):
        """A frame of the state of the board."""
        number = ("raw", "events").index(mode)
        state = _Status(sample, lost, unsent, limit, points, microphones, number, name.encode())
        return self._made(encoder().touch_serial_status, ctypes.byref(state))

    def touch(self, sample, touch, kind, point, probability=0.9, level=0.1, latency=0.05):
        """A frame of a touch."""
        event = _Event(sample, touch, KINDS[kind], point, probability, level, latency)
        return self._made(encoder().touch_serial_touch, ctypes.byref(event))

    def samples(self, first, samples, rate=1000, limit=0.0):
        """A frame of (n_microphone, n) samples in Pa."""
        values = np.ascontiguousarray(np.asarray(samples).T, np.float32)
        return self._made(
            encoder().touch_serial_samples, ctypes.c_uint32(first), ctypes.c_uint16(rate),
            ctypes.c_int(values.shape[1]), ctypes.c_int(len(values)),
            values.ctypes.data_as(ctypes.POINTER(ctypes.c_float)), ctypes.c_float(limit),
        )  # fmt: skip

    def stream(self, samples, first=0, limit=0.0, hop=16):
        """Frames of (n_microphone, n) samples, a hop each, with the state of the board before every sixteenth."""
        frames = []
        for number, at in enumerate(range(0, samples.shape[1], hop)):
            if number % 16 == 0:
                frames.append(self.status(first + at, limit=limit, microphones=len(samples)))
            frames.append(self.samples(first + at, samples[:, at : at + hop], limit=limit))
        return frames

    def _made(self, write, *arguments) -> bytes:
        count = write(ctypes.byref(self._line), self._frame, *arguments)
        assert count <= LARGEST
        return bytes(self._frame[:count])
