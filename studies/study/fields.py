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

    first: Annotated[float, Field(strict=True, alias="from", description="where the range begins")]
    last: Annotated[float, Field(strict=True, alias="to", description="where the range ends")]
    count: Annotated[int, Field(strict=True, ge=2, le=100_000)] | None = Field(
        default=None, description="number of values; in a grid only"
    )
    scale: Literal["linear", "log"] = Field(default="linear", description="equal steps or equal ratios")
    step: Annotated[float, Field(strict=True, gt=0)] | None = Field(
        default=None, description="between values that can be bought, from the beginning of the range"
    )


class StudyFields(FileSection):
    """Study file, its own fields."""

    name: str = Field(
        default="study",
        min_length=1,
        max_length=80,
        pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$",
        description="of the study, for people",
    )
    description: str = Field(default="", description="what it asks, for people")
    base: str = Field(description="a prototype, a design file beside the study, or a section `[base]` with the design")
    sampling: Sampling = Field(default="grid", description="every combination (`grid`), or samples")
    cases: Annotated[int, Field(strict=True, ge=1, le=LARGEST)] | None = Field(
        default=None, description="number of samples, a power of 2 for Sobol points; not for a grid"
    )
    seed: Annotated[int, Field(strict=True, ge=0, le=2**53)] = Field(
        default=0, description="of the samples: the same seed gives the same cases, everywhere"
    )
    constraints: tuple[str, ...] = Field(
        default=(), description="conditions on a case; a case that breaks any is left out and counted"
    )
    fidelity: Fidelity | None = Field(
        default=None,
        description="what the cells are computed with; by default `atlas` if it covers the base, otherwise "
        "`navier-stokes`",
    )
    outside: Outside = Field(
        default="fail",
        description="what becomes of a case outside the atlas: it fails by name (`fail`), or its cells are solved in "
        "3-D (`navier-stokes`); only with the fidelity `atlas`",
    )
    frequency: str = Field(
        default="1:100:64", description="FIRST:LAST:COUNT or a list, Hz; it must cover the band of every metric"
    )
    metrics: tuple[str, ...] = Field(min_length=1, description="names of figures of merit")
    keep: Keep = Field(
        default="metrics",
        description="what the store holds of each case: its `metrics`; also the `responses`, which are its transfer "
        "functions; or everything that `libraries` need",
    )
    precision: Precision = Field(
        default="double", description="of the responses that are kept: 16 bytes for each value, or 8"
    )
    membranes: Membranes = Field(
        default="interpolated",
        description="how many membranes of different proportions are computed: 50 or more are interpolated between a "
        "few dozen solutions, or each is solved, which takes a fifth of a second",
    )
    vary: dict[str, Any] = Field(
        default_factory=dict,
        description="what varies, each on its own: dotted names of fields, with a list of values or a range",
    )
    together: tuple[dict[str, Any], ...] = Field(
        default=(), description="groups of parameters that vary together, like the columns of a table"
    )
