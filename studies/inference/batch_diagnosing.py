"""Diagnosis of many sensors of one design, each from a recording of touches in one folder."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from acoustic_fem import Library
from acoustic_fem.library.provenance import versions
from acoustic_fem.sound.sound_file import FORMATS
from geometry.design.design_file import write_design
from geometry.ground.file_checks import LARGEST_DATA, read_bytes
from geometry.ground.record import read_record, sha256, write_record
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.text_files import read_toml
from localize.diagnosis.diagnosis import Diagnoser
from localize.diagnosis.known_touches import KnownPoints
from localize.diagnosis.production_limits import ProductionLimits, limits_of
from localize.model.decoding import Decoding
from localize.model.opening import ModelSource, files_of, open_library
from localize.recordings.recording import read_recording
from localize.signals.array_response import response_of
from studies.inference.batch_files import write_batch
from studies.inference.diagnosed_sensors import BatchDiagnosis, DiagnosedSensor
from studies.output.display import Display
from studies.output.folders import claimed_folder, make_folder

#: Marks a folder as one of diagnoses, which the same call may go on with.
MARK = ".acoustic-fem-diagnoses"
#: Folder of the diagnoses that are done, and the kind of their records.
_DONE, _KIND = "done", "diagnosis 1"


def diagnose_batch(
    library: ModelSource,
    recordings: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    limits: ProductionLimits | str | os.PathLike[str] | None = None,
    points: KnownPoints | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
    channels: Mapping[str, int] | None = None,
    display: Display | None = None,
) -> BatchDiagnosis:
    """Faults and as-built parameters of many sensors, each of which passes or fails by stated limits.

    Diagnoses that are done are kept in ``out``. A call that was stopped goes on where it was, and one with other
    limits diagnoses nothing again. A recording is diagnosed anew if it, the library or an option has changed.

    Args:
        library: library of the design: a path, a library or an open model.
        recordings: folder with one recording of each sensor, named after it; see
            :func:`studies.diagnose_recording`. A file of TOML with the same name may state ``points`` of its own:
            ``points = [1, 2, 3]``, or a table ``[points]`` of ``"2.5" = 9``, times in seconds.
        out: folder for ``report.html``, ``sensors.csv``, ``parameters.csv`` and ``sensors.json``: a new one, or that
            of an earlier call.
        limits: limits within which a sensor passes, or their file, see
            :func:`localize.diagnosis.production_limits.read_limits`; by default no fault passes.
        points: of the touches of every recording that has no points of its own, as far as they are known.
        full_scale: see :func:`studies.locate_recording`.
        decoding: options for the noise, the air of the place and the outputs of the microphones.
        channels: see :func:`studies.locate_recording`.
        display: shows progress.

    Raises:
        Refusal: a folder that holds no recording, or two of one sensor; limits that cannot be read; a folder of
            results that cannot be written or holds other files; a library without a design, or of a design whose
            scatter is not known. A recording that cannot be used ends nothing: its sensor has no diagnosis.
    """
    given, folder, source = decoding or Decoding(), Path(out), Path(recordings)
    stated = limits_of(limits if limits is None or isinstance(limits, ProductionLimits) else Path(limits))
    files = _recordings_in(source, {Path(each).resolve() for each in files_of(library) if each is not None})
    reads = (*files_of(library), *files)
    with claimed_folder(folder, "diagnose", MARK, reads=reads), (display or Display()).stage("Diagnosis") as report:
        report("library", 0.0)
        opened = open_library(library, given.air)
        array = response_of(opened).array
        diagnoser = Diagnoser(opened, given.microphone_noise)
        settings = _settings(opened, diagnoser, given, full_scale, channels)
        make_folder(folder, "diagnose", MARK)
        (folder / _DONE).mkdir(exist_ok=True)
        sensors = []
        for number, path in enumerate(files):
            report(path.stem, number / len(files))
            try:
                known = _own_points(path.with_suffix(".toml"), points)
                key = sha256(settings, read_bytes(path, "a recording", Refusal, LARGEST_DATA), _as_text(known))
                done = folder / _DONE / f"{path.name}.record"
                found = _kept(done, key)
                if found is None:
                    heard = read_recording(path, array.microphones, full_scale, channels=channels)
                    found = diagnoser.diagnose(given.pressures(heard.signals, array), known).summary()
                    write_record(done, _KIND, key, json.dumps(found).encode())
                sensor = DiagnosedSensor(path.stem, path, found)
            except Refusal as error:
                sensor = DiagnosedSensor(path.stem, path, problem=str(error))
            sensors.append(replace(sensor, objections=sensor.judged(stated)))
        batch = BatchDiagnosis(opened.design.name, tuple(sensors), stated, folder)
        write_batch(batch)
    return batch


def _recordings_in(folder: Path, others: set[Path]) -> list[Path]:
    """Recordings of a folder in the order of their names, without some other files."""
    if not folder.is_dir():
        raise Refusal("must be a folder of recordings", kind=Kind.MISSING, file=folder, field=Field("batch"))
    found = [
        path
        for path in sorted(folder.iterdir())
        if path.suffix.lower() in FORMATS and not path.name.startswith(".") and path.resolve() not in others
    ]
    if not found:
        problem = f"holds no recording; it must hold one of each sensor, {', '.join(FORMATS)}"
        raise Refusal(problem, kind=Kind.MISSING, file=folder, field=Field("batch"))
    seen: dict[str, Path] = {}
    for path in found:
        other = seen.setdefault(path.stem, path)
        if other is not path:
            problem = f"holds two recordings of the sensor {path.stem}: {other.name} and {path.name}"
            raise Refusal(problem, kind=Kind.CONFLICT, file=folder, field=Field("batch"), remedy="remove one of them")
    return found


def _own_points(path: Path, points: KnownPoints | None) -> KnownPoints | None:
    """Known points of a sensor: those of its own file if there is one."""
    if not path.is_file():
        return points
    given = read_toml(path, "a file of points", Refusal)
    if set(given) != {"points"}:
        raise Refusal("must hold points and nothing else", kind=Kind.UNKNOWN, file=path)
    stated = given["points"]
    of_times = isinstance(stated, dict)
    numbers = list(stated.values()) if of_times else stated
    allowed = 'a list of whole numbers, or a table of time = point such as "2.5" = 9'
    if not isinstance(numbers, list) or not all(type(each) is int for each in numbers):
        raise Refusal(kind=Kind.WRONG_TYPE, file=path, field="points", value=stated, allowed=allowed)
    if not of_times:
        return numbers
    try:
        return {float(time): point for time, point in stated.items()}
    except ValueError:
        raise Refusal(kind=Kind.WRONG_TYPE, file=path, field="points", value=stated, allowed=allowed) from None


def _settings(
    library: Library,
    diagnoser: Diagnoser,
    decoding: Decoding,
    full_scale: float | None,
    channels: Mapping[str, int] | None,
) -> str:
    """Everything but the recording and its points that a diagnosis depends on, as a text."""
    parts = (
        versions(None, ())["code_version"],
        sha256(library.transfer_function.values.tobytes(), library.frequency.tobytes()),
        write_design(library.design),
        library.fidelity,
        library.medium,
        diagnoser.options,
        (decoding.microphone_noise, decoding.microphone_output, decoding.lowest),
        full_scale,
        sorted((channels or {}).items()),
    )
    return "\n".join(map(repr, parts))


def _as_text(points: KnownPoints | None) -> str:
    return repr(sorted(points.items()) if isinstance(points, Mapping) else points and list(points))


def _kept(path: Path, key: str) -> dict[str, Any] | None:
    """Diagnosis that was done of this recording with these options; None if there is none, or a damaged one."""
    try:
        return dict(json.loads(read_record(path, _KIND, key, Refusal))) if path.is_file() else None
    except Refusal:
        return None
