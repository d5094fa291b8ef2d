"""Touches in a recording of an array's microphones."""

from __future__ import annotations

import os
from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import write_text
from studies.listening.opening import Decoding, assumed_by, open_localizer, open_stream
from studies.output.folders import check_new_file

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from localize import Decision, Fault, SensorFit, Touch, TouchEvent, TouchStream
    from localize.live.events import State
    from localize.live.touches import Array as TouchedArray
    from localize.signals.locator import Locator

PART = 60_000
"""Number of samples that are decided at once: a minute."""

BINS = 2_000
"""Number of places along the time axis of which the least and the largest value are drawn: more than pixels."""

LABELLED = 40
"""Number of touches up to which each is labelled; more labels would hide each other."""


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
    doubt: str | None = None
    """Reason to doubt what was decided, in words: the sensor does not fit the library. None where there is none, or
    nothing tells: of a trained localizer, or of fewer than eight touches."""
    brought: str | None = None
    """Microphone that is far off its level, and was brought to it before touches were decided; None where none is."""

    @property
    def seconds_by_state(self) -> dict[State, float]:
        """Time for which the decisions said what, s, for each state that there was."""
        from localize.live.events import HOP, Decision
        from localize.signals.stimulus import SAMPLE_RATE

        states = Counter(event.state for event in self.events if isinstance(event, Decision))
        return {state: count * HOP / SAMPLE_RATE for state, count in states.items()}

    @property
    def first_faults(self) -> tuple[Fault, ...]:
        """Faults of the recording: the first of each kind at each microphone."""
        from localize.live.events import Fault

        first: dict[tuple[str, str | None], Fault] = {}
        for event in self.events:
            if isinstance(event, Fault):
                first.setdefault((event.kind, event.channel), event)
        return tuple(first.values())


def locate_recording(
    model: str | os.PathLike[str],
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    picture: str | os.PathLike[str] | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
) -> LocatedTouches:
    """Touches of an array, where and when, from a recording of its microphones.

    Args:
        model: the folder of a trained localizer, an ONNX file, or a library for the model-based decoder, which expects
            the tolerances of manufacturing where the library is not a calibrated one.
        recording: see :func:`localize.read_recording`.
        out: a file for a line of JSON for every frame; an earlier one is replaced.
        picture: of the signals and the touches, ``.png``; an earlier one is replaced.
        full_scale: Pa: of WAV files the pressure at full scale, 1 Pa by default; of others that at which they clip, by
            default recognised by flat tops.
        decoding: how signals are read, and what is told beside the point.

    Raises:
        Refusal: a file that cannot be written or read, or options that do not go together.
    """
    source, given = Path(model), decoding or Decoding()
    path, drawn = (None if each is None else Path(each) for each in (out, picture))
    check_new_file(path, ".jsonl", reads=(model, recording, given.library))
    check_new_file(drawn, ".png", reads=(model, recording, given.library), option="picture")
    if given.waveform and path is None:
        raise Refusal("`waveform` goes into the lines of `out`; give that too")
    import numpy as np

    from acoustic_fem.sound.sound_file import check_sound_there
    from localize import BayesDecoder, DriftDecoder, TouchTracker, read_recording, touches_of

    check_sound_there(recording)
    localizer = open_localizer(source, given)
    stream = open_stream(source, localizer, given, frames=True)
    # A network knows nothing of the array without one of its microphones.
    spare = isinstance(localizer, BayesDecoder) and len(localizer.microphones) > 2
    heard = read_recording(Path(recording), localizer.microphones, full_scale, spare=spare)
    stream.limit = heard.limit
    decided, fit = _decided(stream, localizer, heard.signals)
    brought = None
    if fit is not None and fit.off_level is not None:
        brought, level = fit.off_level
        signals = heard.signals.copy()
        signals[fit.microphones.index(brought)] /= 10 ** (level / 20)
        if isinstance(localizer, DriftDecoder):
            localizer.reset()  # what it followed was the level's
        if heard.limit is not None:  # what was clipped stays so
            signals = np.where(np.abs(heard.signals) >= heard.limit, heard.signals, signals)
        decided = open_stream(source, localizer, given, heard.limit).push(signals)
    tracker = TouchTracker(localizer, stream.delay)
    events = [each for event in decided for each in (event, *tracker.take(event))]
    events += tracker.finish()
    if path is not None:
        write_text(path, "".join(event.json_line() + "\n" for event in events))
    touches = tuple(touches_of(decided, localizer))
    assumes = assumed_by(source, localizer, given)
    doubt = None if fit is None else fit.doubt
    found = LocatedTouches(touches, tuple(events), localizer, heard.seconds, localizer.design, assumes, doubt, brought)
    if drawn is not None:
        draw_touches(found, heard.signals, localizer.microphones, drawn)
    return found


def _decided(
    stream: TouchStream, localizer: Locator, signals: NDArray[np.float64]
) -> tuple[list[Decision | Fault], SensorFit | None]:
    """What a stream says of signals, (n_microphone, n) Pa, and whether they are of the localizer's sensor."""
    from localize import BayesDecoder
    from localize.evaluation.goodness_of_fit import LoudFrames, sensor_fit
    from localize.live.events import Decision

    loud, decided = LoudFrames(), []
    for first in range(0, signals.shape[1], PART):
        events = stream.push(signals[:, first : first + PART])
        loud.take(events)
        # The samples of all frames take sixteen times the memory of the recording.
        decided += [replace(event, frame=None) if isinstance(event, Decision) else event for event in events]
    fit = sensor_fit(localizer, loud.frames, stream.noise) if isinstance(localizer, BayesDecoder) else None
    return decided, fit


def draw_touches(
    found: LocatedTouches, signals: NDArray[np.float64], microphones: tuple[str, ...], path: str | os.PathLike[str]
) -> Path:
    """Picture of a recording with the touches that were found in it.

    Args:
        found: the touches.
        signals: what the microphones heard, (n_microphone, n) float64, Pa at 1 kHz.
        microphones: their names.
        path: file, PNG.

    Returns:
        The path.
    """
    import numpy as np

    from localize.live.events import Decision
    from studies.output.figure_style import WIDTH, figure_in_style, save_figure

    count = len(microphones)
    with figure_in_style((WIDTH, 1.1 * count + 3.0)) as figure:
        panels = figure.subplots(count + 1, 1, sharex=True, height_ratios=[*[1.0] * count, 2.2])
        for panel, name, heard in zip(panels, microphones, signals, strict=False):
            _draw_signal(panel, heard)
            panel.set_ylabel(f"{name}  (Pa)")
        named = panels[-1]
        frames = [(each.time, each.point, each.probability) for each in found.events
                  if isinstance(each, Decision) and each.state == "touch"]  # fmt: skip
        time, point, probability = np.array(frames, dtype=float).reshape(-1, 3).T
        dots = named.scatter(time, point, c=100 * probability, s=7, vmin=0, vmax=100, cmap="viridis_r", zorder=3)
        figure.colorbar(dots, ax=named, label="probability  (%)", pad=0.01)
        for touch in found.touches:
            for panel in panels:
                panel.axvspan(touch.start, touch.end, color="#d9821f", alpha=0.18, linewidth=0)
            if len(found.touches) <= LABELLED:
                named.annotate(
                    f"{touch.point}", ((touch.start + touch.end) / 2, touch.point), (0, 7),
                    textcoords="offset points", ha="center", fontsize=9, weight="bold",
                )  # fmt: skip
        for fault in found.first_faults:
            for panel in panels:
                panel.axvline(fault.time, color="#b00020", linestyle=":", linewidth=1.0)
        named.set(ylim=(0, len(found.array.line) + 1), xlim=(0, found.seconds))
        named.yaxis.get_major_locator().set_params(integer=True)
        named.set_ylabel("named point")
        named.set_xlabel("time  (s): shaded, touches; dots, single frames of 250 ms at their ends")
        return save_figure(figure, path)


def _draw_signal(panel: Axes, heard: NDArray[np.float64]) -> None:
    """Draw a signal, (n,) Pa at 1 kHz; a long one by its least and largest value in each bin."""
    import numpy as np

    time = np.arange(len(heard)) / 1e3
    if len(heard) <= 2 * BINS:
        panel.plot(time, heard, color="#1f5a99", linewidth=0.8)
        return
    begins = np.linspace(0, len(heard), BINS, endpoint=False, dtype=int)
    least, largest = np.minimum.reduceat(heard, begins), np.maximum.reduceat(heard, begins)
    panel.fill_between(time[begins], least, largest, color="#1f5a99", linewidth=0.4, step="post")
