"""A sound card as a source of live samples, through PortAudio by the package ``sounddevice``, which is optional."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from importlib import import_module
from threading import Event
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, said_by
from localize.live.sources import BLOCK, QUEUE, Block, BlockQueue, SourceError, rate_out_of_range
from localize.recordings.channel_choice import chosen_channels
from localize.recordings.recording import HIGHEST_RATE, LOWEST_RATE

INSTALL = "pip install 'acoustic-fem[live]'; on Linux PortAudio itself: apt install libportaudio2"
"""Commands that install what a sound card needs, in words."""
LARGEST = 32767 / 32768
"""Share of full scale that 16 bits can hold; a sample at or above it is clipped, with more bits too."""
_OLDEST = 10.0
"""s: a sample that is older when it is handed on has a wrong time stamp."""


def load_sounddevice() -> Any:
    """Module ``sounddevice``, imported.

    Raises:
        SourceError: it or PortAudio is not installed, with what to install.
    """
    try:
        return import_module("sounddevice")
    except ModuleNotFoundError as error:
        if error.name != "sounddevice":
            raise
        raise SourceError("sounddevice is not installed", kind=Kind.NOT_INSTALLED, remedy=INSTALL) from None
    except OSError as error:  # what it raises where it finds no PortAudio
        raise SourceError(said_by(error), kind=Kind.NOT_INSTALLED, remedy=INSTALL) from None


@dataclass(frozen=True)
class InputDevice:
    """Device as PortAudio knows it."""

    number: int
    """Number of the device, by PortAudio's count."""
    name: str
    """Name of the device."""
    host: str
    """Name of the audio system."""
    channels: int
    """Number of its input channels."""
    rate: float
    """Sample rate of its own, Hz."""
    default: bool
    """True if it is the system's default."""

    @property
    def label(self) -> str:
        """Name with the audio system, because a card appears once under each system: ``USB array, ALSA``."""
        return f"{self.name}, {self.host}"


def input_devices(sounddevice: Any | None = None) -> list[InputDevice]:
    """Devices that can record.

    Args:
        sounddevice: the module, or one that behaves like it.

    Raises:
        SourceError: as :func:`load_sounddevice`, or PortAudio fails.
    """
    audio = sounddevice or load_sounddevice()
    try:
        hosts = [host["name"] for host in audio.query_hostapis()]
        found = list(audio.query_devices())
    except audio.PortAudioError as error:
        raise SourceError(f"PortAudio: {_words(error)}", kind=Kind.STOPPED) from None
    try:
        default = audio.query_devices(kind="input")["index"]
    except audio.PortAudioError:  # there is no default device
        default = -1
    return [
        InputDevice(
            number=number,
            name=str(each["name"]),
            host=str(hosts[each["hostapi"]]),
            channels=int(each["max_input_channels"]),
            rate=float(each["default_samplerate"]),
            default=number == default,
        )
        for number, each in enumerate(found)
        if each["max_input_channels"] > 0
    ]


class DeviceSource:
    """Source of the microphones on a sound card, at its own rate.

    Args:
        microphones: names of the array's microphones.
        device: number, a part of the name, or name and audio system such as ``USB array, WASAPI``, a part of each; by
            default that of the system.
        full_scale: pressure of the largest value of the device, Pa.
        channels: microphone -> channel of the device, from 1; by default the first ones in order.
        sounddevice: the module, or one that behaves like it.
        rate: sample rate to record at, Hz; by default that of the device.

    Raises:
        SourceError: the module, PortAudio, the device or a channel is not there, the rate is outside 250 Hz to 1 MHz,
            or the device does not record at it.
    """

    def __init__(
        self,
        microphones: Sequence[str],
        device: int | str | None = None,
        full_scale: float = 1.0,
        channels: Mapping[str, int] | None = None,
        sounddevice: Any | None = None,
        rate: int | None = None,
    ) -> None:
        self._audio = sounddevice or load_sounddevice()
        self._device = self._find(device)
        self._channels = chosen_channels(microphones, channels, self._device.channels, self._device.name, SourceError)
        if rate is None and not LOWEST_RATE <= self._device.rate <= HIGHEST_RATE:
            raise rate_out_of_range(self._device.rate, self._device.name)
        self.rate = self._device.rate if rate is None else self._checked_rate(rate)
        self._full_scale = full_scale
        self.limit = LARGEST * full_scale
        self._stream: Any = None
        self._lost = Event()
        self._opened = False
        self.ended = False

    @property
    def name(self) -> str:
        """Name of the device, its audio system and its rate, for the user."""
        return f"{self._device.name} ({self._device.host}, {self.rate:g} Hz)"

    @property
    def trouble(self) -> str | None:
        """Reason why no more samples come, where PortAudio has ended the stream by itself, as it does where a device is
        unplugged; None where all is well.
        """
        return "the device has stopped" if self._lost.is_set() else None

    def open(self) -> BlockQueue:
        """Begin to record; after the first time on the device of the same name, whatever its number is by now."""
        if self._opened:
            self._look_again()
        queue = BlockQueue(QUEUE, self.rate)
        self._lost = lost = Event()
        try:
            self._stream = self._audio.InputStream(
                device=self._device.number,
                channels=int(self._channels.max()) + 1,
                samplerate=self.rate,
                blocksize=max(1, round(BLOCK * self.rate)),
                dtype="float32",
                latency="low",
                callback=self._callback(queue),
                finished_callback=lost.set,
            )
            self._stream.start()
        except (self._audio.PortAudioError, ValueError) as error:
            self.close()
            raise SourceError(_words(error), kind=Kind.STOPPED, file=self._device.name) from None
        self._opened = True
        return queue

    def close(self) -> None:
        """Stop recording."""
        stream, self._stream = self._stream, None
        if stream is not None:
            stream.close(ignore_errors=True)  # a device that is gone cannot be closed

    def _callback(self, queue: BlockQueue) -> Any:
        channels, rate, scale = self._channels, self.rate, self._full_scale
        due, ended = 0, -np.inf

        def heard(data: NDArray[np.float32], frames: int, time: Any, status: Any) -> None:
            nonlocal due, ended
            now = perf_counter()
            age = time.currentTime - time.inputBufferAdcTime
            stamped = time.inputBufferAdcTime > 0 and 0 <= age < _OLDEST
            # Some audio systems give no time of the converter: then that of the arrival is the best there is.
            begun = time.inputBufferAdcTime if stamped else now - frames / rate
            if status.input_overflow:
                due += max(1, round((begun - ended) * rate)) if due else 1
            ended = begun + frames / rate
            available = min(now, now - age + (frames - 1) / rate) if stamped else now
            queue.put(Block(scale * data[:, channels].T.astype(np.float64), due, available))
            due += frames

        return heard

    def _checked_rate(self, rate: int) -> float:
        """The rate that was asked for, Hz, at which the device can record."""
        check_range("rate", rate, LOWEST_RATE, HIGHEST_RATE, "Hz", whole=True, error=SourceError)
        try:
            self._audio.check_input_settings(
                device=self._device.number,
                channels=int(self._channels.max()) + 1,
                dtype="float32",
                samplerate=rate,
            )
        except (self._audio.PortAudioError, ValueError) as error:
            problem = f"is not possible with {self._device.label}: {_words(error)}"
            remedy = f"its own rate is {self._device.rate:g} Hz"
            raise SourceError(
                problem, kind=Kind.UNSUITABLE, field="rate", value=rate, unit="Hz", remedy=remedy
            ) from None
        return float(rate)

    def _find(self, device: int | str | None) -> InputDevice:
        devices = input_devices(self._audio)
        if not devices:
            raise no_device()
        if device is None:
            found = [each for each in devices if each.default] or devices[:1]
        elif isinstance(device, int):
            found = [each for each in devices if each.number == device]
        else:
            found = _named(devices, device)
        if len(found) != 1:
            names = ", ".join(f"{each.number} {each.label!r}" for each in found or devices)
            problem = f"fits several: {names}" if found else f"is not there: {names}"
            remedy = f"give a number, or the name with its audio system, such as {found[0].label!r}" if found else ""
            raise SourceError(problem, kind=Kind.UNKNOWN, field="device", value=device, remedy=remedy)
        return found[0]

    def _look_again(self) -> None:
        """Find the device of the same name: PortAudio lists devices when it begins, and at no other time."""
        with suppress(self._audio.PortAudioError):  # where an attempt before could not begin it again
            self._audio._terminate()
        try:
            self._audio._initialize()
        except self._audio.PortAudioError as error:
            raise SourceError(f"PortAudio: {_words(error)}", kind=Kind.STOPPED) from None
        for each in input_devices(self._audio):
            same = (each.name, each.host) == (self._device.name, self._device.host)
            if same and each.channels > self._channels.max():
                self._device = replace(each, rate=self.rate)
                return
        raise SourceError("is not there", kind=Kind.MISSING, file=self._device.name)


def no_device() -> SourceError:
    """The refusal where no device can record."""
    remedy = ("plug one in, or play a file with ", Field("replay"))
    return SourceError("no device that can record is there", kind=Kind.MISSING, remedy=remedy)


def _named(devices: Sequence[InputDevice], text: str) -> list[InputDevice]:
    """Devices that a text names: exactly, then by a part of the name, then by parts of the name and the system."""
    wanted = text.lower()
    exact = [each for each in devices if wanted in (each.name.lower(), each.label.lower())]
    if exact:
        return exact
    name, comma, host = (part.strip() for part in wanted.rpartition(","))
    return [each for each in devices if wanted in each.name.lower()] or [
        each for each in devices if comma and name in each.name.lower() and host in each.host.lower()
    ]


def _words(error: Exception) -> str:
    """PortAudio's message without its code, and the error of the audio system behind it."""
    if not error.args:
        return type(error).__name__
    _, code, text = error.args[2] if len(error.args) > 2 else (0, 0, "")
    return f"{error.args[0]}: {text} (error {code} of the audio system)" if text or code else str(error.args[0])
