"""A stand-in for the module ``sounddevice``: devices that come, go, overflow and fall silent as a script says."""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import numpy as np


class PortAudioError(Exception):
    """As that of sounddevice."""


@dataclass
class Run:
    """What happens from one opening of a device to the next."""

    samples: np.ndarray
    """(n, n_channel) float32."""
    end: str = "stop"
    """What comes behind them: ``stop`` (the device ends the stream) or ``stall`` (no word)."""
    overflow_at: int | None = None
    """Block before which samples were lost."""
    overflow_samples: int = 0
    stamped: bool = True


@dataclass
class FakeAudio:
    """Has the names of the module that are used."""

    runs: list[Run]
    rate: float = 48_000.0
    channels: int = 4
    name: str = "USB array"
    failures: list[str | tuple[Any, ...]] = field(default_factory=list)
    """Messages of attempts to open that fail before the next run, the first one succeeding; or all that PortAudio says.
    """
    hosts: tuple[str, ...] = ("ALSA",)
    """Audio systems, under each of which the device is listed."""
    rates: tuple[float, ...] = (44_100.0, 48_000.0)
    """Rates that the device can record at."""
    absent: int = 0
    """How often the list of devices is without it after a run."""
    pace: float = 0.0
    """s between blocks."""
    PortAudioError: type[Exception] = PortAudioError
    opened: list[dict[str, Any]] = field(default_factory=list)
    initialised: int = 1
    listed: int = 0

    def query_hostapis(self) -> list[dict[str, Any]]:
        return [{"name": host} for host in self.hosts]

    def query_devices(self, kind: str | None = None) -> Any:
        if not self.initialised:
            raise PortAudioError("PortAudio not initialized", -10000)
        speaker = self._entry("Speaker", 0)
        away = bool(self.opened) and self.absent > 0
        if kind == "input":
            if away:
                raise PortAudioError("Error querying device -1")
            return {**self._entry(self.name, self.channels), "index": 1}
        self.listed += 1
        if away:
            self.absent -= 1
            return [speaker]
        # after each return it has another number
        own = [self._entry(self.name, self.channels, host) for host in range(len(self.hosts))]
        return [speaker, *[speaker] * len(self.opened), *own]

    def _entry(self, name: str, channels: int, host: int = 0) -> dict[str, Any]:
        return {"name": name, "hostapi": host, "max_input_channels": channels, "default_samplerate": self.rate}

    def check_input_settings(self, device: int, channels: int, dtype: str, samplerate: float) -> None:
        if samplerate not in self.rates:
            raise PortAudioError("Invalid sample rate", -9997)

    def _terminate(self) -> None:
        if not self.initialised:
            raise PortAudioError("PortAudio not initialized", -10000)
        self.initialised = 0

    def _initialize(self) -> None:
        self.initialised = 1

    def InputStream(self, **arguments: Any) -> FakeStream:
        if self.opened and self.failures:
            failure = self.failures.pop(0)
            raise PortAudioError(*failure) if isinstance(failure, tuple) else PortAudioError(failure, -9985)
        self.opened.append(arguments)
        return FakeStream(self, arguments, self.runs[len(self.opened) - 1])


class FakeStream:
    """Calls back from a thread of its own, as PortAudio does."""

    def __init__(self, audio: FakeAudio, arguments: dict[str, Any], run: Run) -> None:
        self._audio, self._arguments, self._run = audio, arguments, run
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._play, daemon=True)

    def start(self) -> None:
        self._thread.start()

    def close(self, ignore_errors: bool = True) -> None:
        self._closed.set()
        self._thread.join()

    def _play(self) -> None:
        size, rate = self._arguments["blocksize"], self._arguments["samplerate"]
        began, clock = time.perf_counter(), 0
        samples = self._run.samples[:, : self._arguments["channels"]].astype(np.float32)
        for number, first in enumerate(range(0, len(samples), size)):
            if self._closed.wait(self._audio.pace):
                return
            block = samples[first : first + size]
            overflow = number == self._run.overflow_at
            clock += self._run.overflow_samples if overflow else 0
            # the converter's clock runs at the rate of the device, whatever the pace of this thread
            stamp = 1000.0 + clock / rate if self._run.stamped else 0.0
            now = 1000.0 + (time.perf_counter() - began)
            times = SimpleNamespace(inputBufferAdcTime=stamp, currentTime=max(now, stamp + len(block) / rate))
            clock += len(block)
            self._arguments["callback"](block, len(block), times, SimpleNamespace(input_overflow=overflow))
        if self._run.end == "stop":
            self._arguments["finished_callback"]()
        else:
            self._closed.wait()
