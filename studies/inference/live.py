"""Touches located while they happen, from a sound card, a board, or a recording played in real time."""

from __future__ import annotations

import gc
import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, closing, contextmanager
from dataclasses import asdict, dataclass, fields
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import TypeAlias

from acoustic_fem.quantities.local_air import LocalAir
from geometry.ground.argument_checks import check_range, check_unused
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_lines
from localize.evaluation.fit_watch import short_turns
from localize.evaluation.goodness_of_fit import LoudFrames, SensorFit, sensor_fit
from localize.live.board_events import BoardListener
from localize.live.events import Decision, Fault, TouchEvent
from localize.live.listener import Heard, Latencies, LiveListener, Notice
from localize.live.recorder import LiveRecorder
from localize.live.serial_frames import LineCounts
from localize.live.serial_port import BoardLine, SerialSource, check_baud
from localize.live.sound_device import DeviceSource
from localize.live.sources import Correction, ReplaySource, Source
from localize.model.decoding import Decoding
from localize.model.opened_model import Model
from localize.model.opening import ModelSource, files_of, opened
from localize.recordings.accelerometer import AccelerationFile
from localize.recordings.recording import HIGHEST_RATE, LOWEST_RATE
from localize.signals.array_facts import ArrayFacts
from localize.signals.resampling import check_full_scale
from studies.output.call_defaults import FULL_SCALE
from studies.output.folders import check_new_file, claimed_file

#: Arguments of :class:`LiveInput` that only some sources take: those sources, and what to do with another one.
_TAKEN_BY = {
    "device": (("device",), "choose one of the two"),
    "replay": (("replay",), "choose one of the two"),
    "rate": (("device",), "leave it out: boards and recordings have a rate of their own"),
    "full_scale": (("device", "replay"), "leave it out: a board sends its samples in Pa"),
    "baud": (("serial",), "leave it out: it is the speed of a board's serial line"),
}


@dataclass(frozen=True)
class LiveInput:
    """Source of live samples."""

    device: int | str | None = None
    """Sound card: its number, a part of its name, or name and audio system (``USB array, WASAPI``); by default that of
    the system."""
    replay: str | os.PathLike[str] | None = None
    """WAV file to play in real time instead of listening."""
    channels: Mapping[str, int] | None = None
    """Channel of each microphone, from 1; by default the first ones, in the order of the design."""
    full_scale: float | None = None
    """Pressure at full scale of the sound card or file, Pa; by default 1 Pa."""
    rate: int | None = None
    """Sample rate of the sound card, Hz; by default its own."""
    serial: str | None = None
    """Serial port of a board, such as ``/dev/ttyACM0`` or ``COM3``, to read instead of a sound card."""
    baud: int | None = None
    """Speed of the serial line, bit/s, by default 115,200. USB serial ports ignore it."""
    acceleration: AccelerationFile | None = None
    """File of an accelerometer on the housing; the pressures of its motion are subtracted from ``replay``."""

    def __post_init__(self) -> None:
        source = next((name for name in ("serial", "replay") if getattr(self, name) is not None), "device")
        for name, (sources, remedy) in _TAKEN_BY.items():
            if source not in sources:
                why = (" without ", Field("serial")) if source == "device" else (" beside ", Field(source))
                check_unused({name: getattr(self, name)}, why, remedy)
        if self.rate is not None:
            check_range("rate", self.rate, LOWEST_RATE, HIGHEST_RATE, "Hz", whole=True)
        if self.acceleration is not None and self.replay is None:
            raise Refusal(
                ("needs ", Field("replay"), ", because motion is subtracted from whole recordings only"),
                kind=Kind.CONFLICT,
                field="acceleration",
            )
        if self.serial is not None:
            check_baud(self.serial, self.baud)
        check_full_scale(self.pascals)

    @property
    def pascals(self) -> float:
        """Pressure at full scale, Pa."""
        return FULL_SCALE if self.full_scale is None else self.full_scale

    def open(self, microphones: tuple[str, ...]) -> Source:
        """Source of the samples of these microphones; reading has not begun."""
        return self.source(microphones, None if self.serial is None else BoardLine(self.serial, self.baud))

    def source(
        self, microphones: tuple[str, ...], board: BoardLine | None, correct: Correction | None = None
    ) -> Source:
        """Source of the samples of these microphones, from a board whose line is open if there is one.

        Args:
            microphones: their names.
            board: line of a board.
            correct: as of :class:`localize.live.ReplaySource`.
        """
        if board is not None:
            return SerialSource(board, microphones, self.channels)
        if self.replay is not None:
            return ReplaySource(self.replay, microphones, self.pascals, self.channels, correct)
        return DeviceSource(microphones, self.device, self.pascals, self.channels, rate=self.rate)


class LiveSession:
    """Live session, for whoever shows it.

    Args:
        listener: joins the source to the stream.
        model: names the points.
    """

    def __init__(self, listener: LiveListener | BoardListener, model: Model) -> None:
        self._listener = listener
        self.array: ArrayFacts = model.locator.array
        """Array with the lines and places of its points, and the names of its microphones."""
        self.assumptions = model.assumptions
        """Assumptions of the model about the sensor, in words."""
        self.latencies = Latencies()
        """Latencies of the decisions so far."""

    @property
    def source(self) -> str:
        """Name of what is listened to."""
        return self._listener.name if isinstance(self._listener, BoardListener) else self._listener.source.name

    @property
    def recordings(self) -> tuple[Path, ...]:
        """Files that were recorded so far."""
        return self._listener.recordings

    @property
    def recent(self) -> Array:
        """Newest samples at 1 kHz; (n_microphone, n) float64, Pa."""
        return self._listener.recent


Hear: TypeAlias = Callable[[LiveSession, Heard, str], bool | None]
"""Takes the session, an event and its line of JSON; listening ends where it says False."""


@dataclass(frozen=True, eq=False)
class LiveSummary:
    """Counts of a live session."""

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
    assumptions: str
    """Assumptions of the model about the sensor, in words."""
    warning: str | None = None
    """Reason to distrust the touches: the sensor does not fit the library; as of :class:`LocatedTouches`."""
    unrecorded: str = ""
    """Why the recording was stopped while the listening went on, in one line with its file; empty if it was not."""
    line: LineCounts | None = None
    """Counts of the frames of a serial line; None for other sources."""


def listen(
    model: ModelSource,
    source: LiveInput | None = None,
    out: str | os.PathLike[str] | None = None,
    *,
    record: str | os.PathLike[str] | None = None,
    decoding: Decoding | None = None,
    contact_radius_mm: float | None = None,
    hear: Hear | None = None,
) -> LiveSummary:
    """Summary of a live session, in which touches are located while they happen. It ends when the source ends, when
    ``hear`` returns False, or with Ctrl-C.

    If a sound card or a board is unplugged, the session waits for it. A board in event mode decides by itself. Its
    touches are reported as it sent them, and the model only says which array it must have.

    Args:
        model: a path, a library, a localizer or an open model, see :func:`localize.open_model`.
        source: where samples come from; by default the system's sound card.
        out: a file for a line of JSON for each frame, every 16 ms, written at once; an earlier file is replaced.
        record: a new WAV file for the input, at its own sample rate; readable even if the program is killed.
        decoding: options for opening the model and for what is reported besides the point.
        contact_radius_mm: radius of the contact, mm. If you give it, its position on the surface is reported too, and
            its gesture when its path has ended. This needs a library. By default only points are reported.
        hear: function that is called with every event.

    Raises:
        Refusal: a file that cannot be written or read, options that contradict each other, or a sound card or a board
            that does not exist.
        OSError: the disk is full.
    """
    lines, kept, heard_from = (
        None if out is None else Path(out),
        None if record is None else Path(record),
        source or LiveInput(),
    )
    beside = None if decoding is None else decoding.library
    check_lines = partial(
        check_new_file, lines, ".jsonl", reads=(*files_of(model), heard_from.replay, *files_of(beside))
    )
    check_kept = partial(check_new_file, kept, ".wav", kept="a recording", option="record")
    check_lines()
    check_kept()
    if lines is not None and kept is not None and lines.resolve() == kept.resolve():
        problem = ("must be another file than ", Field("record"))
        raise Refusal(problem, kind=Kind.CONFLICT, field="out", value=str(lines))
    found = opened(model, decoding)
    board = None if heard_from.serial is None else BoardLine(heard_from.serial, heard_from.baud)
    decides = board is not None and board.mode == "events"
    if board is not None and decides:
        check_needs_no_samples(board, heard_from, kept, contact_radius_mm, decoding)
    correct = None if heard_from.acceleration is None else found.motion_correction(heard_from.acceleration)
    samples = None if decides else heard_from.source(found.locator.microphones, board, correct)
    recorder = None
    counts, loud = _Counts(), LoudFrames()
    with ExitStack() as stack:
        stack.enter_context(claimed_file(lines, check_lines))
        stack.enter_context(claimed_file(kept, check_kept))
        if kept is not None and samples is not None:
            recorder = LiveRecorder(kept, samples.rate, len(found.locator.microphones), heard_from.pascals)
        listener: LiveListener | BoardListener
        if samples is None:
            assert board is not None
            listener = BoardListener(board, found.locator.array)
        else:
            listener = found.listen(samples, recorder, contact_radius_mm)
        session = LiveSession(listener, found)
        stack.enter_context(_nothing_freed())
        stack.enter_context(short_turns())
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
    fit = None
    if isinstance(listener, LiveListener):
        fit = sensor_fit(found.locator, loud.frames(), listener.stream.noise)
    return counts.summary(session, fit, listener.stopped, None if board is None else board.counts)


def check_needs_no_samples(
    board: BoardLine, heard_from: LiveInput, record: Path | None, radius: float | None, decoding: Decoding | None
) -> None:
    """Refuse options that need samples, because a board that decides sends none."""
    options, usual = decoding or Decoding(), Decoding()
    chosen = {each.name: getattr(options, each.name) for each in fields(Decoding) if each.name != "tolerances"}
    given = {"record": record, "contact_radius_mm": radius, "channels": heard_from.channels}
    given |= {name: value for name, value in chosen.items() if value != getattr(usual, name)}
    air = given.pop("air", None)
    given |= asdict(air) if isinstance(air, LocalAir) else {}
    try:
        check_unused(
            given, ": it needs samples, and the board sends touches", "leave it out, or set the board to raw mode"
        )
    except Refusal:
        board.close()
        raise


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
    """Counts of the events so far."""

    def __init__(self) -> None:
        self._states: Counter[str] = Counter()
        self._faults: Counter[str] = Counter()
        self._lost = self._touches = 0
        self._began = perf_counter()

    def take(self, heard: Heard) -> None:
        """Count an event."""
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

    def summary(
        self, session: LiveSession, fit: SensorFit | None, unrecorded: str, line: LineCounts | None
    ) -> LiveSummary:
        """All of it."""
        return LiveSummary(
            perf_counter() - self._began,
            dict(self._states),
            self._touches,
            dict(self._faults),
            self._lost,
            session.latencies,
            session.recordings,
            session.assumptions,
            None if fit is None else fit.warning,
            unrecorded,
            line,
        )
