"""Touches in a recording of an array's microphones."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from acoustic_fem.sound.sound_file import check_sound_there
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import write_text
from localize.diagnosis.bad_fits import fault_of_touches
from localize.live.events import Decision
from localize.model.decoding import Decoding as Decoding
from localize.model.located_touches import LocatedTouches as LocatedTouches
from localize.model.opened_model import Model
from localize.model.opening import ModelSource, files_of, opened
from localize.recordings.accelerometer import AccelerationFile as AccelerationFile
from localize.recordings.recording import Recording
from studies.output.figure_style import WIDTH, figure_in_style, save_figure
from studies.output.folders import check_new_file, new_picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BINS = 2_000
"""Number of places along the time axis of which the least and the largest value are drawn: more than pixels."""

LABELLED = 40
"""Number of touches up to which each is labelled; more labels would hide each other."""


def locate_recording(
    model: ModelSource,
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    picture: str | os.PathLike[str] | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
    channels: Mapping[str, int] | None = None,
    correct: bool = False,
    acceleration: AccelerationFile | None = None,
) -> LocatedTouches:
    """Touches in a recording of an array's microphones, with their points and times.

    Args:
        model: a path, a library, a localizer or an open model, see :func:`localize.open_model`.
        recording: see :func:`localize.read_recording`.
        out: a file for a line of JSON for each frame; an earlier file is replaced.
        picture: a file for a picture of the signals and the touches, ``.png`` by default; an earlier file is replaced.
        full_scale: pressure at full scale of WAV files, Pa, by default 1 Pa. For other files, the pressure at which the
            recorder clipped; by default clipping is detected by its flat tops.
        decoding: options for opening the model and for what is reported besides the point.
        channels: channel of each microphone in the recording, counted from 1; by default found by the names of the
            channels or by their order.
        correct: whether a reversed, exchanged or late microphone is corrected before touches are located, if the check
            of the sensor finds one; by default the fault is reported and probabilities are lowered.
        acceleration: file of an accelerometer on the housing; the pressures of its motion are subtracted from the
            signals. By default the sensor lies still.

    Raises:
        Refusal: a file that cannot be written or read, or options that contradict each other.
    """
    path = None if out is None else Path(out)
    beside = None if acceleration is None else acceleration.path
    reads = (*files_of(model), recording, beside, *files_of(None if decoding is None else decoding.library))
    check_new_file(path, ".jsonl", reads=reads)
    drawn = new_picture(picture, reads=reads, option="picture")
    check_sound_there(recording)
    found = opened(model, decoding)
    if found.decoding.waveform and path is None:
        problem = ("goes into the lines of ", Field("out"), "; give that too")
        raise Refusal(problem, kind=Kind.MISSING, field="waveform")
    heard = found.read(recording, full_scale, channels, acceleration)
    located = _with_diagnosis(found.locate_recording(heard, correct=correct), found, heard)
    if path is not None:
        write_text(path, "".join(event.json_line() + "\n" for event in located.events))
    if drawn is not None:
        draw_touches(located, heard.signals, drawn)
    return located


def _with_diagnosis(located: LocatedTouches, model: Model, heard: Recording) -> LocatedTouches:
    """Touches with the broken part in their warning, if the sensor does not fit and one explains the touches."""
    if located.warning is None or located.fault is not None or model.library is None:
        return located
    signals = model.decoding.pressures(heard.signals, located.array)
    fault = fault_of_touches(model.library, [signals], model.decoding.microphone_noise)
    if fault is None:
        return located
    return replace(located, warning=f"{fault.text} ({located.warning}). {fault.to_do}")


def draw_touches(found: LocatedTouches, signals: Array, path: str | os.PathLike[str]) -> Path:
    """Picture of a recording with the touches that were found in it.

    Args:
        found: the touches.
        signals: of the microphones, (n_microphone, n) float64, Pa at 1 kHz.
        path: file, PNG.

    Returns:
        The path.
    """
    microphones = found.array.microphones
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
        named.set_ylabel("located point")
        named.set_xlabel("time  (s): shaded, touches; dots, single frames of 250 ms at their ends")
        return save_figure(figure, path)


def _draw_signal(panel: Axes, heard: Array) -> None:
    """Draw a signal, (n,) Pa at 1 kHz; a long one by its least and largest value in each bin."""
    time = np.arange(len(heard)) / 1e3
    if len(heard) <= 2 * BINS:
        panel.plot(time, heard, color="#1f5a99", linewidth=0.8)
        return
    begins = np.linspace(0, len(heard), BINS, endpoint=False, dtype=int)
    least, largest = np.minimum.reduceat(heard, begins), np.maximum.reduceat(heard, begins)
    panel.fill_between(time[begins], least, largest, color="#1f5a99", linewidth=0.4, step="post")
