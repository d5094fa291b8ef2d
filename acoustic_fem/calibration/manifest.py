"""The manifest of a calibration: which recording is of which point, and what its channels are.

::

    design = "array-2x6"          # a prototype, or a design file beside the manifest
    record = "record.toml"        # of the build, as `acoustic-fem parts` writes it: measured thicknesses, batches
    output = "voltage"            # the array's microphones as they are; by default "pressure": already equalised
    response = "reference.csv"    # of the calibration microphone: frequency (Hz), dB and degrees; by default flat
    [channels]                    # of WAV files and matrices, from 1; by default in this order
    reference = 1                 # the calibration microphone at the touched cavity
    A = 2
    B = 3
    [pascals]                     # at 1 kHz, of one unit in the files, of full scale in WAV files; by default 1
    reference = 20.0
    [started_late]                # s by which a channel's recorder started after the others; by default 0
    reference = 0.0123
    [clock_ppm]                   # by which a channel's recorder samples faster than it states; by default estimated
    A = 21.5
    [points]
    1 = "point-01.wav"
    2 = {reference = "point-02-cavity.wav", A = "point-02-a.csv", B = "point-02-b.wav"}
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, PlainValidator
from pydantic_core import PydanticCustomError

from acoustic_fem.calibration.build_record import BuildRecord, read_record
from acoustic_fem.calibration.reference_response import ReferenceResponse, read_response
from acoustic_fem.quantities.microphone_signals import Output
from acoustic_fem.sound.estimate import Estimator
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import prototype_names, resolve_design
from geometry.ground.argument_checks import whole_number
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import read_toml
from geometry.schema.field_errors import model_of

#: The channel of the calibration microphone.
REFERENCE = "reference"

_Number = Annotated[float, Field(allow_inf_nan=False)]


class ManifestError(Refusal):
    """A manifest that cannot be used: one line that names the file, the field and the reason."""


def _fault(path: Path, problem: str, kind: Kind = Kind.CONFLICT, **facts: Any) -> ManifestError:
    return ManifestError(problem, kind=kind, file=path, **facts)


def _files(value: Any) -> Any:
    """One file, or one per channel."""
    if not isinstance(value, str) and not (
        isinstance(value, dict) and all(isinstance(file, str) for file in value.values())
    ):
        raise PydanticCustomError("files", "it is neither a file nor a table of one file per channel")
    return value


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    design: str
    points: dict[str, Annotated[str | dict[str, str], PlainValidator(_files)]] = Field(min_length=1)
    channels: dict[str, Annotated[int, Field(ge=1, le=1024)]] | None = None
    pascals: dict[str, Annotated[_Number, Field(ge=1e-12, le=1e12)]] = {}
    started_late: dict[str, Annotated[_Number, Field(ge=-60, le=60)]] = {}
    clock_ppm: dict[str, Annotated[_Number, Field(ge=-1000, le=1000)]] = {}
    response: Annotated[str, Field(min_length=1)] | None = None
    record: Annotated[str, Field(min_length=1)] | None = None
    output: Output = "pressure"
    estimator: Estimator = "H1"
    least_coherence: Annotated[_Number, Field(ge=0, lt=1)] = 0.9


@dataclass(frozen=True)
class Manifest:
    """Recordings of a sensor; every mapping over channels has the reference first, then the design's microphones."""

    design: ArrayDesign
    """The design of the sensor."""
    points: Mapping[int, Mapping[str, Path]]
    """File of every channel by number of the point, from 1; the same file for all where one holds them."""
    channels: Mapping[str, int]
    """Number of every channel in WAV files and matrices, from 1."""
    pascals: Mapping[str, float]
    """Pressure at 1 kHz of one unit in the files of every channel, Pa."""
    started_late: Mapping[str, float]
    """Time by which the recorder of every channel started after the others, s."""
    estimator: Estimator = "H1"
    """Estimator of the transfer functions."""
    least_coherence: float = 0.9
    """Median over frequency that the coherence of the best microphone of a point must reach."""
    clock_ppm: Mapping[str, float] = field(default_factory=dict)
    """Rate of the recorder of a channel above the one that its files state, 1e-6; of channels that are not there it is
    estimated against the reference."""
    response: ReferenceResponse | None = None
    """Response of the calibration microphone; None for a flat one."""
    record: BuildRecord | None = None
    """Record of the build; None where the manifest names none."""
    output: Output = "pressure"
    """Content of the channels of the array's microphones: their outputs, whose high-pass a calibration divides out, or
    pressures in front of them."""


def read_manifest(path: Path) -> Manifest:
    """Read a manifest; whether its recordings exist and are good is seen when they are read.

    Raises:
        ManifestError: it cannot be read, is not TOML, lacks a field, or holds an unknown or impossible one.
        Refusal: the response or the record cannot be read, or the record is of another design.
        DesignError: the design is neither a prototype nor a valid design file.
    """
    path = Path(path)
    file = model_of(_File, read_toml(path, "a manifest", ManifestError), str(path), "manifest", ManifestError)
    design = resolve_design(file.design if file.design in prototype_names() else path.parent / file.design)
    names = (REFERENCE, *design.microphones)
    if REFERENCE in design.microphones:
        raise _fault(
            path,
            f"has a microphone {REFERENCE!r}, which is the name of the reference channel",
            field="design",
            remedy="rename the microphone",
        )
    by_channel_name: dict[str, Mapping[str, float] | None] = {
        "channels": file.channels,
        "pascals": file.pascals,
        "started_late": file.started_late,
        "clock_ppm": file.clock_ppm,
    }
    for key, given in by_channel_name.items():
        unknown = [name for name in given or {} if name not in names]
        if unknown:
            raise ManifestError(kind=Kind.UNKNOWN, file=path, field=f"{key}.{unknown[0]}", allowed=names)
    channels = file.channels or {name: number for number, name in enumerate(names, 1)}
    if set(channels) != set(names) or len(set(channels.values())) < len(names):
        raise _fault(path, f"must give {', '.join(names)} a number each, all different", field="channels")
    points: dict[int, Mapping[str, Path]] = {}
    for text, files in file.points.items():
        number = whole_number(text)
        if not 1 <= number <= design.point_count or number in points:
            raise ManifestError(
                kind=Kind.OUT_OF_RANGE,
                file=path,
                field=f"points.{text}",
                allowed=f"a point from 1 to {design.point_count}, each once",
            )
        by_channel = dict.fromkeys(names, files) if isinstance(files, str) else files
        if set(by_channel) != set(names):
            raise _fault(
                path,
                f"has files of {', '.join(by_channel)}; it must be one file, or one each of: {', '.join(names)}",
                kind=Kind.MISMATCH,
                field=f"points.{text}",
            )
        points[number] = {name: path.parent / by_channel[name] for name in names}
    return Manifest(
        design,
        points,
        {name: channels[name] for name in names},
        {name: file.pascals.get(name, 1.0) for name in names},
        {name: file.started_late.get(name, 0.0) for name in names},
        file.estimator,
        file.least_coherence,
        {name: file.clock_ppm[name] for name in names if name in file.clock_ppm},
        None if file.response is None else read_response(path.parent / file.response),
        None if file.record is None else read_record(path.parent / file.record, design),
        file.output,
    )
