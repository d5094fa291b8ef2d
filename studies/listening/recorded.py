"""Touches in a recording of an array's microphones."""

from __future__ import annotations

import os
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.files.writing import write_text
from geometry.refusal import Refusal
from studies.listening.opening import Decoding, assumed_by, open_localizer, open_stream
from studies.output.folders import check_new_file

if TYPE_CHECKING:
    from localize import Decision, Fault, Touch, TouchEvent
    from localize.live.events import State
    from localize.live.touches import Array as TouchedArray


@dataclass(frozen=True, eq=False)
class LocatedTouches:
    """Touches in a recording."""

    touches: tuple[Touch, ...]
    """Touches in the order of time."""
    events: tuple[Decision | Fault | TouchEvent, ...]
    """Decisions, 16 ms apart, faults, and touches as they would have been told while they happened."""
    array: TouchedArray
    """Array with the lines and places of its points."""
    seconds: float
    """Length of the recording, s."""
    design: str
    """Name of the design whose points are named: that of the localizer, whatever was recorded."""
    assumes: str
    """What the localizer takes for granted of the sensor, in words."""

    @property
    def seconds_by_state(self) -> dict[State, float]:
        """Time for which the decisions said what, s, for each state that there was."""
        from localize.live.events import HOP, Decision
        from localize.signals.stimulus import SAMPLE_RATE

        states = Counter(event.state for event in self.events if isinstance(event, Decision))
        return {state: count * HOP / SAMPLE_RATE for state, count in states.items()}


def locate_recording(
    model: str | os.PathLike[str],
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
) -> LocatedTouches:
    """Touches of an array, where and when, from a recording of its microphones.

    Args:
        model: the folder of a trained localizer, an ONNX file, or a library for the model-based decoder, which expects
            the tolerances of manufacturing where the library is not a calibrated one.
        recording: see :func:`localize.read_recording`.
        out: a file for a line of JSON for every frame; an earlier one is replaced.
        full_scale: Pa: of WAV files the pressure at full scale, 1 Pa by default; of others that at which they clip, by
            default recognised by flat tops.
        decoding: how signals are read, and what is told beside the point.

    Raises:
        Refusal: a file that cannot be written or read, or options that do not go together.
    """
    source, path = Path(model), None if out is None else Path(out)
    given = decoding or Decoding()
    check_new_file(path, ".jsonl", reads=(model, recording, given.library))
    if given.waveform and path is None:
        raise Refusal("`waveform` goes into the lines of `out`; give that too")
    from localize import TouchTracker, read_recording, touches_of

    localizer = open_localizer(source, given)
    stream = open_stream(source, localizer, given)
    heard = read_recording(Path(recording), localizer.microphones, full_scale)
    decided = stream.push(heard.signals)
    tracker = TouchTracker(localizer, stream.delay)
    events = [each for event in decided for each in (event, *tracker.take(event))]
    events += tracker.finish()
    if path is not None:
        write_text(path, "".join(event.json_line() + "\n" for event in events))
    touches = tuple(touches_of(decided, localizer))
    assumes = assumed_by(source, localizer, given)
    return LocatedTouches(touches, tuple(events), localizer, heard.seconds, localizer.design, assumes)
