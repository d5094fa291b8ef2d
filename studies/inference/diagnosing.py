"""Diagnosis of a built sensor from a recording of touches."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path

from acoustic_fem.sound.sound_file import check_sound_there
from geometry.ground.whole_files import write_text
from localize.diagnosis.diagnosis import Diagnoser, Diagnosis
from localize.diagnosis.known_touches import KnownPoints
from localize.model.decoding import Decoding
from localize.model.opening import ModelSource, files_of, open_library
from localize.recordings.recording import read_recording
from localize.signals.array_response import response_of
from studies.output.folders import check_new_file


def diagnose_recording(
    library: ModelSource,
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    points: KnownPoints | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
    channels: Mapping[str, int] | None = None,
) -> Diagnosis:
    """Fault of a built sensor, found from a recording of 20 to 30 ordinary touches.

    Args:
        library: library of the sensor's design, or its calibrated one: a path, a library or an open model.
        recording: see :func:`localize.read_recording`; touches one at a time, each with quiet before and after it.
        out: a file of JSON for the diagnosis; an earlier file is replaced.
        points: of the touches, as far as they are known, from 1: one for each touch, or {time in s: point} of some.
        full_scale: see :func:`studies.locate_recording`.
        decoding: options for the noise, the air of the place and the outputs of the microphones.
        channels: see :func:`studies.locate_recording`.

    Raises:
        Refusal: a file that cannot be written or read, a library without a design or of a design whose scatter is not
            known, too few touches, or points that do not fit the touches.
    """
    given = decoding or Decoding()
    path = None if out is None else Path(out)
    check_new_file(path, ".json", reads=(*files_of(library), recording))
    check_sound_there(recording)
    opened = open_library(library, given.air)
    array = response_of(opened).array
    diagnoser = Diagnoser(opened, given.microphone_noise)
    heard = read_recording(Path(recording), array.microphones, full_scale, channels=channels)
    found = diagnoser.diagnose(given.pressures(heard.signals, array), points)
    if path is not None:
        write_text(path, json.dumps(found.summary(), indent=2) + "\n")
    return found
