"""The pulse in a recording of an array's microphones: where it is felt, its waveform and its rate."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import localize
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.sound.sound_file import check_sound_there
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import write_text
from localize.model.decoding import Decoding
from localize.model.located_touches import RecordingResult
from localize.model.opening import ModelSource, files_of, open_library
from localize.recordings.recording import read_recording
from localize.signals.array_response import response_of
from studies.output.figure_style import WIDTH, figure_in_style, line_colours, save_figure
from studies.output.folders import check_new_file, is_own_table, new_picture

#: Frequency down to which outputs of microphones are equalised unless it is given, Hz: a fifth of a slow pulse.
LOWEST_OF_PULSE = 0.2
#: Columns of the waveform, at 1 kHz.
COLUMNS = ("time (s)", "force (N)")


@dataclass(frozen=True, eq=False, kw_only=True)
class RecordedPulse(RecordingResult):
    """Pulse in a recording."""

    reading: localize.PulseReading
    """Point, waveform, waves and rate."""
    force_is_known: bool
    """True if the membranes, which give the force, are those of the library: a calibration does not measure them, and
    takes them as designed."""


def read_pulse(
    library: ModelSource,
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    picture: str | os.PathLike[str] | None = None,
    point: int | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
) -> RecordedPulse:
    """Pulse of an artery under a finger that rests on an array, from a recording of its microphones.

    Args:
        library: library of the array, with its design: a path, a library or an open model. Tolerances are not modelled.
        recording: see :func:`localize.read_recording`; at least 3 s.
        out: a CSV file for the waveform; an earlier file of a pulse is replaced.
        picture: a file for a picture of the waveform with its waves, ``.png`` by default; an earlier file is replaced.
        point: number of the point under the finger, from 1; by default the point that the decoder finds.
        full_scale: see :func:`studies.locate_recording`.
        decoding: options for the noise and for the air of the place.

    Raises:
        Refusal: a file that cannot be written or read; no library, or one without a design; a recording that is too
            short; a point that the array does not have.
    """
    given = decoding or Decoding()
    table = None if out is None else Path(out)
    kept = None if table is None or is_own_table(table, COLUMNS) else "a table that does not come from pulse"
    check_new_file(table, ".csv", reads=(*files_of(library), recording), kept=kept)
    drawn = new_picture(picture, reads=(*files_of(library), recording), option="picture")
    check_sound_there(recording)
    response = response_of(open_library(library, given.air))
    array = response.array
    if response.force_response is None:
        problem = "is of no design; the force of a pulse needs its membranes"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
    check_point(point, array.point_count)
    reader = localize.PulseReader(response, given.microphone_noise)
    heard = read_recording(Path(recording), array.microphones, full_scale)
    reading = reader.read(given.pressures(heard.signals, array, LOWEST_OF_PULSE), point)
    if table is not None:
        write_text(table, _rows(reading))
    if drawn is not None:
        draw_pulse(reading, drawn)
    return RecordedPulse(
        array=array,
        seconds=heard.seconds,
        assumptions=array.assumptions,
        reading=reading,
        force_is_known=array.provenance.get("fidelity") != MEASURED,
    )


def check_point(point: int | None, count: int) -> None:
    """Refuse a point that an array of so many does not have; None is for the one that is named."""
    if point is not None:
        check_range("point", point, 1, count, whole=True, why="the points of the array")


def draw_pulse(reading: localize.PulseReading, path: str | os.PathLike[str]) -> Path:
    """Picture of the waveform of a pulse, with the waves of each beat.

    Args:
        reading: what was read.
        path: file, PNG.

    Returns:
        The path.
    """
    time = np.arange(len(reading.waveform)) / 1e3
    with figure_in_style((WIDTH, 3.2)) as figure:
        axes = figure.subplots()
        axes.plot(time, 1e6 * reading.waveform, color="#777777", linewidth=1.0)
        for (name, at), colour in zip(reading.waves.items(), line_colours(len(reading.waves)), strict=True):
            there = at[np.isfinite(at)]
            axes.plot(
                there, 1e6 * np.interp(there, time, reading.waveform), "o", color=colour, markersize=4, label=name
            )
        axes.set(xlabel="time  (s)", ylabel="force on the membrane  (uN)")
        found = f"{reading.rate:.1f} beats a minute" if reading.found else "no pulse found"
        axes.set_title(f"point {reading.point}, {found}")
        figure.legend(loc="outside lower center", ncols=3)
        return save_figure(figure, path)


def _rows(reading: localize.PulseReading) -> str:
    """The waveform as text; empty where it is not known."""
    lines = [",".join(COLUMNS)]
    for number, force in enumerate(reading.waveform.tolist()):
        lines.append(f"{number / 1e3:.3f}," + ("" if force != force else f"{force:.4g}"))
    return "\n".join(lines) + "\n"
