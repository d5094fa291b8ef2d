"""Paths of contacts in a recording of an array's microphones: a table, a picture, and gestures."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.sound.sound_file import check_sound_there
from geometry.ground.whole_files import write_text
from geometry.layout.arrangement import lay_out
from geometry.surface import PlanInSpace, plan_in_space
from localize.evaluation.connection_faults import ConnectionFault
from localize.evaluation.goodness_of_fit import LoudFrames, sensor_fit
from localize.live.stream_options import MOVING
from localize.model.decoding import Decoding
from localize.model.located_touches import RecordingResult
from localize.model.opened_model import Model
from localize.model.opening import ModelSource, files_of, opened_as_designed
from localize.recordings.accelerometer import AccelerationFile
from localize.signals.array_response import ArrayResponse
from localize.tracking.path import Track
from localize.tracking.path_gestures import Gesture, gesture_of
from localize.tracking.signal_track import tracks_of
from studies.output.figure_style import figure_in_style, line_colours, save_figure
from studies.output.folders import check_new_file, is_own_table, new_picture

#: Columns of the table.
COLUMNS = ("path", "time_s", "x_mm", "y_mm", "deviation_mm", "speed_mm_s", "force_N", "detected")
#: Further columns of the table of an array on a body: place on it, and the direction away from it.
BODY_COLUMNS = ("body_x_mm", "body_y_mm", "body_z_mm", "normal_x", "normal_y", "normal_z")


@dataclass(frozen=True, eq=False, kw_only=True)
class TrackedRecording(RecordingResult):
    """Paths of a recording."""

    tracks: tuple[Track, ...]
    """Paths in the order of time."""
    gestures: tuple[Gesture, ...]
    """Gesture of each path."""
    force_is_known: bool
    """True if the membranes, which give the forces, are those of the library: a calibration does not measure them, and
    takes them as designed."""
    fault: ConnectionFault | None = None
    """Fault in how the microphones are connected, which explains the touches far better; None if none was found."""
    warning: str | None = None
    """Fault in words; None if none was found."""
    body: PlanInSpace | None = None
    """The body that the paths lie on, by the plan of their places; None for an array that is not laid on one."""


def track_recording(
    library: ModelSource,
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    picture: str | os.PathLike[str] | None = None,
    contact_radius_mm: float = MOVING,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
    channels: Mapping[str, int] | None = None,
    acceleration: AccelerationFile | None = None,
) -> TrackedRecording:
    """Paths of contacts over the surface of an array, from a recording of its microphones.

    Args:
        library: library of the array, with its design: a path, a library or an open model.
        recording: see :func:`localize.read_recording`.
        out: a CSV file with a row for every 16 ms of each path; an earlier file of paths is replaced. For an array on a
            body it also has the place on the body and the direction away from it.
        picture: a file for a picture of the paths on the array, ``.png`` by default; an earlier file is replaced.
        contact_radius_mm: radius of the contact, mm, 0.05 to 100.
        full_scale: see :func:`studies.locate_recording`.
        decoding: options for noise, sound and air of the place.
        channels: channel of each microphone in the recording, counted from 1; by default found by the names of the
            channels or by their order.
        acceleration: as of :func:`studies.locate_recording`.

    Raises:
        Refusal: a file that cannot be written or read, no library, or a radius out of range.
    """
    table = None if out is None else Path(out)
    reads = (*files_of(library), recording, None if acceleration is None else acceleration.path)
    headers = COLUMNS, (*COLUMNS, *BODY_COLUMNS)
    is_own = table is None or any(is_own_table(table, columns) for columns in headers)
    kept = None if is_own else "a table that does not come from track"
    check_new_file(table, ".csv", reads=reads, kept=kept)
    drawn = new_picture(picture, reads=reads, option="picture")
    check_sound_there(recording)
    model = opened_as_designed(library, decoding)
    tracker, array = model.tracker(contact_radius_mm), model.locator.array
    read = model.read(recording, full_scale, channels, acceleration, tolerant=False)
    stream, loud = model.stream(frames=True), LoudFrames()
    tracks = tuple(tracks_of(stream, tracker, read.signals, loud.take))
    fit = sensor_fit(stream.locator, loud.frames(), stream.noise, only_faults=True)
    body = _body_of(model)
    if table is not None:
        write_text(table, _rows(tracks, body))
    if drawn is not None:
        draw_paths(tracks, tracker.response, drawn)
    return TrackedRecording(
        array=array,
        seconds=read.seconds,
        assumptions=model.assumptions,
        tracks=tracks,
        gestures=tuple(map(gesture_of, tracks)),
        force_is_known=array.provenance.get("fidelity") != MEASURED,
        fault=None if fit is None else fit.fault,
        warning=None if fit is None else fit.warning,
        body=body,
    )


def _body_of(model: Model) -> PlanInSpace | None:
    """The body under an array, by its plan; None for an array that is not laid on one."""
    design = None if model.library is None else model.library.design
    if design is None or design.layout.kind != "surface":
        return None
    return plan_in_space(design, lay_out(design))


def _rows(tracks: tuple[Track, ...], body: PlanInSpace | None) -> str:
    """The table as text; of paths on a body with their places in space."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS if body is None else (*COLUMNS, *BODY_COLUMNS))
    for number, track in enumerate(tracks, 1):
        on_body = None if body is None else body.at(track.place)
        for k in range(len(track.time)):
            force = f"{track.force[k]:.4g}" if track.detected[k] else ""
            x, y = track.place[k]
            speed = f"{track.speed[k]:.2f}"
            place = (f"{track.time[k]:.3f}", f"{x:.3f}", f"{y:.3f}", f"{track.deviation[k]:.3f}", speed)
            row = [number, *place, force, int(track.detected[k])]
            if on_body is not None:
                row += [f"{each:.3f}" for each in (*on_body[0][k], *on_body[1][k])]
            writer.writerow(row)
    return text.getvalue()


def draw_paths(tracks: tuple[Track, ...], response: ArrayResponse, path: str | os.PathLike[str]) -> Path:
    """Picture of paths on the points of an array: where contacts are detected, with the uncertainty.

    Args:
        tracks: the paths.
        response: of the array, with its places.
        path: file, PNG.

    Returns:
        The path.
    """
    from matplotlib.collections import EllipseCollection

    assert response.position is not None
    assert response.membrane_radius is not None
    size = 2 * response.membrane_radius
    drawn = np.concatenate([response.position, *(track.place for track in tracks)])
    low, high = drawn.min(0) - size.max(), drawn.max(0) + size.max()
    width, depth = high - low
    with figure_in_style((6.4, float(np.clip(5.8 * depth / width, 1.2, 8.0)) + 0.9)) as figure:
        axes = figure.add_subplot()
        axes.add_collection(
            EllipseCollection(
                size, size, np.zeros(len(size)), units="xy", offsets=response.position, transOffset=axes.transData,
                facecolor="#eeeeee", edgecolor="#999999",
            )
        )  # fmt: skip
        for number, (track, colour) in enumerate(zip(tracks, line_colours(len(tracks)), strict=True), 1):
            axes.plot(*track.place.T, color=colour, linewidth=1.0, label=f"path {number}, from {track.time[0]:.2f} s")
            wide = 2 * track.deviation
            axes.add_collection(
                EllipseCollection(
                    wide, wide, np.zeros(len(wide)), units="xy", offsets=track.place, transOffset=axes.transData,
                    facecolor=colour, alpha=0.06,
                )
            )  # fmt: skip
            axes.plot(*track.place[track.detected].T, ".", color=colour, markersize=3)
            axes.plot(*track.place[0], "o", color=colour, markersize=6)
        axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.set_xlabel("x  (mm)")
        axes.set_ylabel("y  (mm)")
        if 0 < len(tracks) <= 8:
            axes.legend(loc="upper left", bbox_to_anchor=(0, -0.5 / figure.get_figheight()), ncols=2, fontsize=8)
        return save_figure(figure, path)
