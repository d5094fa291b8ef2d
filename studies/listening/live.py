"""Touches named while they happen, from a sound card or a recording played in real time."""

from __future__ import annotations

import gc
import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import whole_lines
from studies.listening.opening import Decoding, assumed_by, open_localizer, open_stream, open_tracker
from studies.output.folders import check_new_file

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from localize import SensorFit
    from localize.live.listener import Heard, Latencies, LiveListener
    from localize.live.recorder import LiveRecorder
    from localize.live.sources import Source
    from localize.live.touches import Array as TouchedArray
    from localize.signals.locator import Locator


@dataclass(frozen=True)
class LiveInput:
    """Where live samples come from."""

    device: int | str | None = None
    """Sound card: its number, or a part of its name; by default that of the system."""
    replay: str | os.PathLike[str] | None = None
    """WAV file to play in real time instead of listening."""
    channels: Mapping[str, int] | None = None
    """Channel of each microphone, from 1; by default the first ones, in the order of the design."""
    full_scale: float = 1.0
    """Pressure at full scale of the sound card or file, Pa."""

    def __post_init__(self) -> None:
        if self.device is not None and self.replay is not None:
            raise Refusal("`device` must not be given beside `replay`")

    def open(self, locator: Locator) -> Source:
        """Source of a locator's microphones, not listened to yet."""
        from localize.live.sound_device import DeviceSource
        from localize.live.sources import ReplaySource

        if self.replay is not None:
            return ReplaySource(self.replay, locator.microphones, self.full_scale, self.channels)
        return DeviceSource(locator.microphones, self.device, self.full_scale, self.channels)


class LiveSession:
    """Session of listening, for whoever shows it.

    Args:
        listener: joins the source to the stream.
        array: what its points are.
        recorder: writes what comes in.
        assumes: what the localizer takes for granted of the sensor, in words.
    """

    def __init__(
        self, listener: LiveListener, array: TouchedArray, recorder: LiveRecorder | None = None, assumes: str = ""
    ) -> None:
        from localize.live.listener import Latencies

        self._listener, self._recorder = listener, recorder
        self.array = array
        """Array with the lines and places of its points."""
        self.microphones = listener.stream.locator.microphones
        """Names of the microphones."""
        self.assumes = assumes
        """What the localizer takes for granted of the sensor, in words."""
        self.latencies = Latencies()
        """Latencies of the decisions so far."""

    @property
    def source(self) -> str:
        """Name of what is listened to."""
        return self._listener.source.name

    @property
    def recordings(self) -> tuple[Path, ...]:
        """Files that were recorded so far."""
        return () if self._recorder is None else tuple(self._recorder.paths)

    @property
    def recent(self) -> NDArray[np.float64]:
        """Newest samples at 1 kHz; (n_microphone, n) float64, Pa."""
        return self._listener.recent


Hear = Callable[["LiveSession", "Heard", str], bool | None]
"""Takes the session, an event and its line of JSON; listening ends where it says False."""


@dataclass(frozen=True, eq=False)
class LiveSummary:
    """Counts of all that was heard."""

    seconds: float
    """Time that was listened, s."""
    states: Mapping[str, int]
    """Number of decisions by what they say."""
    touches: int
    """Number of touches that came down."""
    faults: Mapping[str, int]
    """Number of faults and notices by kind."""
    samples_lost: int
    """Number of samples at 1 kHz that were lost."""
    latencies: Latencies
    """Latencies of the decisions, from the last sample of their frame to the end of what was done with them."""
    recordings: tuple[Path, ...]
    """Files that were recorded."""
    assumes: str
    """What the localizer takes for granted of the sensor, in words."""
    doubt: str | None = None
    """Reason to doubt what was told: the sensor does not fit the library; as of
    :attr:`studies.listening.recorded.LocatedTouches.doubt`."""
    unrecorded: str = ""
    """Why the recording was stopped while the listening went on, in one line with its file; empty if it was not."""


def listen(
    model: str | os.PathLike[str],
    source: LiveInput | None = None,
    out: str | os.PathLike[str] | None = None,
    *,
    record: str | os.PathLike[str] | None = None,
    decoding: Decoding | None = None,
    radius: float | None = None,
    hear: Hear | None = None,
) -> LiveSummary:
    """Summary of touches that are named while they happen, until the source ends, ``hear`` says so, or Ctrl-C.

    A sound card that is unplugged is waited for.

    Args:
        model: the folder of a trained localizer, an ONNX file, or a library for the model-based decoder, which expects
            the tolerances of manufacturing where the library is not a calibrated one.
        source: where samples come from; by default the system's sound card.
        out: a file for a line of JSON for every frame, 16 ms apart, written as it comes; an earlier one is replaced.
        record: a new WAV file for what comes in, at the rate at which it does; readable even if the program is killed.
        decoding: how signals are read, and what is told beside the point.
        radius: of a contact whose place on the surface is told beside its point, and what it did when its path has
            ended, for a library as model, mm; by default neither is.
        hear: called with every event.

    Raises:
        Refusal: a file that cannot be written or read, options that do not go together, or no such sound card.
        OSError: a disk that is full: the lines cannot be written, or the recording cannot be begun.
    """
    lines = None if out is None else Path(out)
    from localize import BayesDecoder
    from localize.evaluation.goodness_of_fit import LoudFrames, sensor_fit

    heard_from, given = source or LiveInput(), decoding or Decoding()
    reads = (model, heard_from.replay, given.library)
    check_new_file(lines, ".jsonl", reads=reads)
    check_new_file(None if record is None else Path(record), ".wav", kept="a recording", option="record")
    if lines is not None and record is not None and lines.resolve() == Path(record).resolve():
        raise Refusal(f"{lines}: out and record must be two files")
    listener, session = _opened(Path(model), heard_from, record, given, radius)
    counts, loud = _Counts(), LoudFrames()
    with ExitStack() as stack:
        stack.enter_context(_nothing_freed())
        # Lines are written as they come, and stand in the file whenever the program ends.
        write = None if lines is None else stack.enter_context(whole_lines(lines))
        try:
            for heard in stack.enter_context(closing(listener.listen())):
                available = heard.available
                line = heard.json_line(None if available is None else perf_counter() - available)
                if write is not None:
                    write(line)
                goes_on = hear is None or hear(session, heard, line) is not False
                if available is not None:
                    session.latencies.add(perf_counter() - available)
                counts.take(heard)
                loud.take([heard.event])
                if not goes_on:
                    break
        except KeyboardInterrupt:
            pass
    locator = listener.stream.locator
    fit = sensor_fit(locator, loud.frames, listener.stream.noise) if isinstance(locator, BayesDecoder) else None
    return counts.summary(session, fit, listener.stopped)


def _opened(
    model: Path, source: LiveInput, record: str | os.PathLike[str] | None, decoding: Decoding, radius: float | None
) -> tuple[LiveListener, LiveSession]:
    """What listens, and what is told of it; nothing is heard or written yet."""
    from localize.live.listener import LiveListener
    from localize.live.recorder import LiveRecorder
    from localize.live.touches import TouchTracker
    from localize.signals.resampling import check_full_scale
    from localize.tracking import GestureTracker

    check_full_scale(source.full_scale)
    locator = open_localizer(model, decoding)
    samples = source.open(locator)
    stream = open_stream(model, locator, decoding, samples.limit, frames=True)
    recorder = None
    if record is not None:
        recorder = LiveRecorder(Path(record), samples.rate, len(locator.microphones), source.full_scale)
    places = () if radius is None else (GestureTracker(open_tracker(model, decoding, radius)[1]),)
    listener = LiveListener(samples, stream, recorder, trackers=(TouchTracker(locator), *places))
    return listener, LiveSession(listener, locator, recorder, assumed_by(model, locator, decoding))


@contextmanager
def _nothing_freed() -> Iterator[None]:
    """Memory as it is: looking through all that was imported for what can be freed takes longer than a frame."""
    gc.collect()
    gc.freeze()
    try:
        yield
    finally:
        gc.unfreeze()


class _Counts:
    """What was heard so far."""

    def __init__(self) -> None:
        self._states: Counter[str] = Counter()
        self._faults: Counter[str] = Counter()
        self._lost = self._touches = 0
        self._began = perf_counter()

    def take(self, heard: Heard) -> None:
        """Count an event."""
        from localize.live.events import Decision, Fault, TouchEvent
        from localize.live.listener import Notice

        event = heard.event
        if isinstance(event, Decision):
            self._states[event.state] += 1
        elif isinstance(event, Fault):
            self._faults[event.kind] += 1
            self._lost += (event.samples or 0) if event.kind == "samples lost" else 0
        elif isinstance(event, TouchEvent):
            self._touches += event.kind == "down"
        elif isinstance(event, Notice):
            self._faults[event.kind] += 1

    def summary(self, session: LiveSession, fit: SensorFit | None, unrecorded: str) -> LiveSummary:
        """All of it."""
        return LiveSummary(
            perf_counter() - self._began,
            dict(self._states),
            self._touches,
            dict(self._faults),
            self._lost,
            session.latencies,
            session.recordings,
            session.assumes,
            None if fit is None else fit.doubt,
            unrecorded,
        )
