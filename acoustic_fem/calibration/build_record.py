"""The record of a build: what its maker measured of the parts before the sensor was put together, in TOML.

::

    design = "array-2x6"
    sensor = "3"                  # number on its label
    built = "2026-11-27"
    [measuring]
    thickness_error = 0.01        # mm, standard deviation of a measured thickness
    [batches.1]                   # silicone mixed in one cup: one modulus
    silicone = "Dragon Skin 30"
    lot = "A1234"
    points = [1, 2, 3]
    modulus = 0.61                # MPa, where it was measured, with its relative standard deviation
    modulus_error = 0.05
    [thickness]                   # mm, of the membrane on each point that was measured
    1 = 0.52
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import whole_number
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import read_toml
from geometry.schema.field_errors import model_of

#: Largest ratio of a measured thickness or modulus to that of the design, either way: beyond, it is a slip of the pen.
_LARGEST_RATIO = 2.0
#: Name of the batch of points that the record gives to none.
_REST = "not recorded"

_Number = Annotated[float, Field(allow_inf_nan=False)]
_Text = Annotated[str, Field(max_length=2000)]


class RecordError(Refusal):
    """A record that cannot be used: one line that names the file, the field and the reason."""


class _Measuring(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    thickness_error: Annotated[_Number, Field(gt=0, le=1)] = 0.01


class _Batch(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    points: list[int] = Field(min_length=1)
    silicone: _Text = ""
    lot: _Text = ""
    mixed: _Text = ""
    modulus: Annotated[_Number, Field(gt=0, le=1e4)] | None = None
    modulus_error: Annotated[_Number, Field(gt=0, le=0.5)] = 0.05


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    design: str
    sensor: _Text = ""
    built: _Text = ""
    builder: _Text = ""
    notes: _Text = ""
    measuring: _Measuring = _Measuring()
    batches: dict[str, _Batch] = {}
    thickness: dict[str, Annotated[_Number, Field(gt=0, le=100)]] = {}


@dataclass(frozen=True)
class Batch:
    """Silicone mixed in one cup."""

    name: str
    """Name of its table."""
    points: tuple[int, ...]
    """Numbers of the points whose membranes are of it, from 1."""
    modulus: float | None = None
    """Measured Young's modulus, MPa; None where it was not measured."""
    modulus_error: float = 0.05
    """Relative standard deviation of that."""
    silicone: str = ""
    """Name of the silicone."""
    lot: str = ""
    """Number on the package."""


@dataclass(frozen=True)
class BuildRecord:
    """Measurements that the maker of a sensor took of its parts."""

    sensor: str
    """Number on the label of the sensor."""
    built: str
    """Date."""
    thickness: Mapping[int, float]
    """Measured thickness of membranes by number of the point, from 1, mm."""
    thickness_error: float
    """Standard deviation of a measured thickness, mm."""
    batches: tuple[Batch, ...]
    """Batches of silicone, which have every point once; points that the record gives to none are one more batch."""

    @property
    def says_something(self) -> bool:
        """True if a thickness or a modulus was measured, or if there are several batches."""
        return bool(self.thickness) or len(self.batches) > 1 or any(each.modulus for each in self.batches)


def read_record(path: Path, design: ArrayDesign) -> BuildRecord:
    """Read the record of a build.

    Args:
        path: of the file.
        design: the design of the sensor.

    Raises:
        RecordError: it cannot be read, is not TOML, holds an unknown field, is of another design, has a point that the
            design lacks or that is in two batches, or has a value that differs from the design's by more than
            a factor of 2.
    """
    path = Path(path)
    file = model_of(_File, read_toml(path, "a record", RecordError), str(path), "record", RecordError)
    if file.design != design.name:
        problem = f"is the record of {file.design!r}, and the manifest is of {design.name!r}"
        raise RecordError(problem, kind=Kind.MISMATCH, file=path, field="design")
    thickness: dict[int, float] = {}
    for text, value in file.thickness.items():
        number = _point(path, f"thickness.{text}", whole_number(text), design, thickness)
        designed = design.of_kind(design.kinds[design.kind_of_point[number - 1]]).membrane.thickness
        _check_ratio(path, f"thickness.{text}", value, designed, "mm")
        thickness[number] = value
    return BuildRecord(file.sensor, file.built, thickness, file.measuring.thickness_error, _batches(path, file, design))


def _batches(path: Path, file: _File, design: ArrayDesign) -> tuple[Batch, ...]:
    designed = design.material(design.membrane.material).youngs_modulus
    taken: dict[int, str] = {}
    batches = []
    for name, given in file.batches.items():
        for place, number in enumerate(given.points):
            taken[_point(path, f"batches.{name}.points.{place}", number, design, taken)] = name
        if given.modulus is not None:
            _check_ratio(path, f"batches.{name}.modulus", given.modulus, designed, "MPa")
        facts = (given.modulus, given.modulus_error, given.silicone, given.lot)
        batches.append(Batch(name, tuple(given.points), *facts))
    rest = tuple(number for number in range(1, design.point_count + 1) if number not in taken)
    return (*batches, Batch(_REST, rest)) if rest else tuple(batches)


def _point(path: Path, field: str, number: int, design: ArrayDesign, taken: Mapping[int, Any]) -> int:
    """Number of a point that the design has, and that is not among those taken."""
    if not 1 <= number <= design.point_count or number in taken:
        allowed = f"a point from 1 to {design.point_count}, each once"
        raise RecordError(kind=Kind.OUT_OF_RANGE, file=path, field=field, value=number, allowed=allowed)
    return number


def _check_ratio(path: Path, field: str, value: float, designed: float, unit: str) -> None:
    if not 1 / _LARGEST_RATIO <= value / designed <= _LARGEST_RATIO:
        allowed = f"{designed / _LARGEST_RATIO:.3g} to {designed * _LARGEST_RATIO:.3g} {unit}"
        raise RecordError(
            kind=Kind.OUT_OF_RANGE, file=path, field=field, value=value, unit=unit, allowed=allowed,
            remedy=f"the design states {designed:.3g} {unit}: put what you cast into the design",
        )  # fmt: skip
