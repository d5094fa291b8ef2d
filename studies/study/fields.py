"""Fields of a study file. The arguments of :class:`studies.study.study.Study` have the same names."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from acoustic_fem.quantities.fidelity import Fidelity
from studies.study.parameter import Sampling

Keep = Literal["metrics", "responses", "libraries"]
Precision = Literal["double", "single"]
Membranes = Literal["interpolated", "solved"]
Outside = Literal["fail", "navier-stokes"]
#: Most cases of one study; a store of more should be several.
LARGEST = 10_000_000


class FileSection(BaseModel):
    """Base of every section of a study file: immutable; unknown keys and non-finite numbers are rejected."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class RangeFields(FileSection):
    """Range of a parameter in a study file."""

    first: Annotated[float, Field(strict=True, alias="from", description="first value of the range")]
    last: Annotated[float, Field(strict=True, alias="to", description="last value of the range")]
    count: Annotated[int, Field(strict=True, ge=2, le=100_000)] | None = Field(
        default=None, description="number of values; in a grid only"
    )
    scale: Literal["linear", "log"] = Field(default="linear", description="equal steps or equal ratios")
    step: Annotated[float, Field(strict=True, gt=0)] | None = Field(
        default=None, description="difference between values that can be bought, counted from the first value"
    )


class StudyFields(FileSection):
    """Study file, its own fields."""

    name: str = Field(
        default="study",
        min_length=1,
        max_length=80,
        pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$",
        description="name of the study, used in reports",
    )
    description: str = Field(default="", description="question that the study answers, used in reports")
    base: str = Field(description="a prototype, a design file beside the study, or a section `[base]` with the design")
    sampling: Sampling = Field(
        default="grid", description="every combination of values (`grid`), or samples of the ranges"
    )
    cases: Annotated[int, Field(strict=True, ge=1, le=LARGEST)] | None = Field(
        default=None, description="number of samples, preferably a power of 2 for `sobol`; not for a `grid`"
    )
    seed: Annotated[int, Field(strict=True, ge=0, le=2**53)] = Field(
        default=0, description="seed of the samples; the same seed gives the same cases on every machine"
    )
    constraints: tuple[str, ...] = Field(
        default=(), description="conditions that each case must meet; other cases are left out and counted"
    )
    fidelity: Fidelity | None = Field(
        default=None,
        description="method by which the cells are solved; by default `atlas` if it covers the base design, otherwise "
        "`navier-stokes`",
    )
    outside: Outside = Field(
        default="fail",
        description="treatment of a case outside the atlas: it fails with its reason (`fail`), or its cells are solved "
        "in 3-D (`navier-stokes`); only with the fidelity `atlas`",
    )
    frequency: str = Field(
        default="1:100:64",
        description="frequencies in Hz, FIRST:LAST:COUNT or a list; they must cover the band of every metric",
    )
    metrics: tuple[str, ...] = Field(min_length=1, description="names of the metrics to compute")
    keep: Keep = Field(
        default="metrics",
        description="results that the store keeps of each case: only its `metrics`; also the `responses`, which are "
        "its transfer functions; or everything that its library needs (`libraries`)",
    )
    precision: Precision = Field(
        default="double",
        description="precision of the responses that are kept: 16 bytes for each value (`double`), or 8 (`single`)",
    )
    membranes: Membranes | None = Field(
        default=None,
        description="treatment of 50 or more membranes of different proportions: they are `interpolated` between a few "
        "dozen solutions, or each is `solved`, which takes about a twentieth of a second per membrane; by default "
        "`solved` if libraries are kept, otherwise `interpolated`",
    )
    stock: Literal["on", "off"] = Field(
        default="on",
        description="sizes of bought parts: only those of the catalogue (`on`), or any (`off`); a range with a step "
        "states its own",
    )
    vary: dict[str, Any] = Field(
        default_factory=dict,
        description="fields that vary independently: their dotted names, each with a list of values or a range",
    )
    together: tuple[dict[str, Any], ...] = Field(
        default=(), description="groups of fields that vary together, like the columns of a table"
    )
