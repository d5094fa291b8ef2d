"""Schemas of the descriptions in files of localizers: those of ONNX graphs, and the parts that all have.

Every value is checked before anything is made from it. Sizes are bounded here, because the memory that a description
asks for is allocated later without another check.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, Literal, Self, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from geometry.ground.refusal import Kind, Refusal
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

_Model = TypeVar("_Model", bound=BaseModel)

LARGEST_DESCRIPTION = 20_000_000
"""Most bytes of a description: the largest array has 120,000 points, and a long training a curve of 10,000 epochs."""
LARGEST_MODEL = 256_000_000
"""Most bytes of the weights or the graph of one localizer."""

Digest = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Share = Annotated[float, Field(ge=0, le=1)]
Count = Annotated[int, Field(ge=0, le=2**53)]


class LocalizerError(Refusal):
    """Refusal of a localizer that cannot be read: one line that names the file and the reason."""


class Strict(BaseModel):
    """Fields of exactly these names and kinds, and numbers that are finite."""

    model_config = ConfigDict(strict=True, extra="forbid", allow_inf_nan=False)


class ArrayDescription(Strict):
    """The array that a localizer is of."""

    design: Annotated[str, Field(min_length=1, max_length=200)]
    microphones: Annotated[
        list[Annotated[str, Field(min_length=1, max_length=100)]], Field(min_length=2, max_length=16)
    ]
    line: Annotated[list[Count], Field(min_length=2, max_length=120_000)]
    place: Annotated[list[Count], Field(min_length=2, max_length=120_000)]
    provenance: dict[str, Any]

    @model_validator(mode="after")
    def _agrees(self) -> Self:
        if len(set(self.microphones)) < len(self.microphones):
            raise Refusal(kind=Kind.CONFLICT, field="microphones", value=self.microphones, allowed="different names")
        if len(self.line) != len(self.place):
            raise Refusal(
                f"line and place must hold {len(self.line)} values each, a line and a place of every point",
                kind=Kind.MISMATCH,
            )
        if not isinstance(self.provenance.get("design", ""), str):
            raise Refusal(kind=Kind.WRONG_TYPE, field="provenance.design", allowed="a text")
        return self


class StreamDescription(Strict):
    """Treatment of samples before the graph, as a stream does it, for a program that has only the file."""

    high_pass: Annotated[float, Field(gt=0, le=500)]
    """Corner of the Butterworth high-pass that samples pass before frames are cut, Hz."""
    high_pass_order: Annotated[int, Field(ge=1, le=20)]
    high_pass_sections: Annotated[list[Annotated[list[float], Field(min_length=6, max_length=6)]], Field(max_length=10)]
    """The same as sections of second order: numerator and denominator of each, at the sample rate of the graph."""
    hop: Annotated[int, Field(ge=1, le=FRAME)]
    """Number of samples from one frame to the next."""
    silence: Annotated[float, Field(ge=0)]
    """Level of a frame below which it holds no touch, Pa rms."""


class GraphDescription(ArrayDescription):
    """Description in the metadata of an ONNX file."""

    format: str
    version: int
    kind: Literal["network", "model-based decoder"]
    sample_rate: float
    frame: int
    unit: str
    noise_rms: Annotated[float, Field(ge=0, le=100)]
    stream: StreamDescription | None = None
    opset: Count
    ir_version: Count | None = None
    versions: dict[str, Any]
    sha256: Digest | None = None

    @model_validator(mode="after")
    def _as_signals_are(self) -> Self:
        for name, value in (("sample_rate", SAMPLE_RATE), ("frame", FRAME), ("unit", "Pa")):
            if getattr(self, name) != value:
                raise Refusal(kind=Kind.MISMATCH, field=name, value=getattr(self, name), allowed=repr(value))
        return self


def check_format(
    values: object,
    format: str,
    version: int,
    source: str | os.PathLike[str],
    refusal: type[Refusal],
    what: str = "a localizer",
) -> None:
    """Refuse a description of something else, or of another version of the program, before its values are looked at.

    Args:
        values: what a JSON text states.
        format: what its field of this name must be.
        version: the same.
        source: where it stands, put before the message.
        refusal: class of the errors.
        what: what it should be of.

    Raises:
        Exception: by ``refusal``.
    """
    if not isinstance(values, dict) or values.get("format") != format:
        raise refusal(f"is not {what}: its format is not {format!r}", kind=Kind.UNREADABLE, file=source)
    if values.get("version") != version:
        raise refusal(
            kind=Kind.MISMATCH, file=source, field="version", value=values.get("version"), allowed=str(version)
        )


def described(model: type[_Model], text: str | bytes, source: str | os.PathLike[str], refusal: type[Refusal]) -> _Model:
    """Content of a JSON text, checked.

    Args:
        model: the schema.
        text: the text, which was read as JSON.
        source: where it stands, put before the message.
        refusal: class of the errors.

    Raises:
        Exception: by ``refusal``, in one line: a value that is missing, unknown or not allowed.
    """
    try:
        return model.model_validate_json(text)
    except ValidationError as error:
        found = error.errors(include_url=False)[0]
        # A step in brackets is no field but the tag of one of several models.
        where = ".".join(str(step) for step in found["loc"] if not str(step).startswith("("))
        if found["type"] == "missing":
            raise refusal(kind=Kind.MISSING, file=source, field=where) from None
        inner = found.get("ctx", {}).get("error")
        if isinstance(inner, Refusal):
            field = ".".join(filter(None, (where, inner.field)))
            raise refusal.of(inner, file=source, field=field) from None
        unknown, typed = found["type"] == "extra_forbidden", found["type"].endswith("_type")
        kind = Kind.UNKNOWN if unknown else Kind.WRONG_TYPE if typed else Kind.OUT_OF_RANGE
        problem = f"is not allowed: {found['msg'][:1].lower()}{found['msg'][1:]}"
        raise refusal(problem, kind=kind, file=source, field=where, value=found["input"]) from None


@contextmanager
def naming(path: Path, refusal: type[Refusal]) -> Iterator[None]:
    """Block whose refusals name the file, and are of the class given."""
    try:
        yield
    except Refusal as error:
        raise refusal.of(error, file=path) from None
