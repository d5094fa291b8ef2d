"""The pulse in a recording of an array's microphones: where it is felt, its waveform and its rate."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import write_text
from studies.listening.opening import Decoding, library_there
from studies.output.folders import check_new_file, is_own_table

if TYPE_CHECKING:
    from localize import PulseReading

#: Columns of the waveform, at 1 kHz.
COLUMNS = ("time (s)", "force (N)")


@dataclass(frozen=True, eq=False)
class RecordedPulse:
    """Pulse in a recording."""

    reading: PulseReading
    """What was read: point, waveform, waves and rate."""
    seconds: float
    """Length of the recording, s."""
    design: str
    """Name of the design whose points are named."""
    force_is_known: bool
    """Whether the membranes, by which the force is told, are those of the library: those of a calibrated sensor are
    not measured, and taken as designed."""
    assumes: str
    """What is taken for granted of the sensor, in words."""


def read_pulse(
    library: str | os.PathLike[str],
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
        library: of the array, with a design; its sensor is decoded as it is.
        recording: see :func:`localize.read_recording`; at least 3 s.
        out: a table of the waveform, ``.csv``; an earlier one of a pulse is replaced.
        picture: of the waveform with its waves, ``.png``; an earlier one is replaced.
        point: under which it is felt, from 1; by default that which is named.
        full_scale: as of :func:`studies.locate_recording`.
        decoding: noise and air of the place.

    Raises:
        Refusal: a file that cannot be written or read; no library, or one without a design; a recording that is too
            short; a point that the array does not have.
    """
    given = decoding or Decoding()
    table, drawn = (None if each is None else Path(each) for each in (out, picture))
    kept = None if table is None or is_own_table(table, COLUMNS) else "a table that is none of a pulse"
    check_new_file(table, ".csv", reads=(library, recording), kept=kept)
    check_new_file(drawn, ".png", reads=(library, recording), option="picture")
    from acoustic_fem.library.transfer_functions import MEASURED
    from acoustic_fem.sound.sound_file import check_sound_there
    from localize import PulseReader, read_recording
    from localize.decoders.bayes import assumed_of
    from localize.signals.array_response import response_of

    check_sound_there(recording)
    response = response_of(library_there(library, given.air))
    if response.force_response is None:
        raise Refusal(f"{library}: is of no design; the force of a pulse needs its membranes")
    if point is not None and not 1 <= point <= response.point_count:
        raise Refusal(f"point = {point} must be from 1 to {response.point_count}, the points of the array")
    reader = PulseReader(response, "design" if given.noise is None else given.noise)
    heard = read_recording(Path(recording), response.microphones, full_scale)
    reading = reader.read(heard.signals, None if point is None else point - 1)
    if table is not None:
        write_text(table, _rows(reading))
    if drawn is not None:
        draw_pulse(reading, drawn)
    measured = response.provenance.get("fidelity") == MEASURED
    return RecordedPulse(reading, heard.seconds, response.name, not measured, assumed_of(response.provenance))


def draw_pulse(reading: PulseReading, path: str | os.PathLike[str]) -> Path:
    """Picture of the waveform of a pulse, with the waves of each beat.

    Args:
        reading: what was read.
        path: file, PNG.

    Returns:
        The path.
    """
    import numpy as np

    from studies.output.figure_style import WIDTH, figure_in_style, line_colours, save_figure

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
        axes.set_title(f"point {reading.point + 1}, {reading.rate:.1f} beats a minute")
        figure.legend(loc="outside lower center", ncols=3)
        return save_figure(figure, path)


def _rows(reading: PulseReading) -> str:
    """The waveform as text; empty where it is not known."""
    lines = [",".join(COLUMNS)]
    for number, force in enumerate(reading.waveform.tolist()):
        lines.append(f"{number / 1e3:.3f}," + ("" if force != force else f"{force:.4g}"))
    return "\n".join(lines) + "\n"
