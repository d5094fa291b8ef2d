"""Study files, read. Every refusal is a :class:`studies.study.study.StudyError` with file and field."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from acoustic_fem import atlas
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.quantities.fidelity import Fidelity
from geometry import ArrayDesign, DesignError, load_design
from geometry.design.changes import as_lists, check_name
from geometry.design.design_file import prototype, prototype_names, value_of
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_toml, read_text
from geometry.ground.typed import Array, PathLike
from geometry.schema.declared_fields import field_named
from geometry.schema.field_errors import check_value, model_of, nearest
from studies.study.constraints import parse_constraint
from studies.study.metric_registry import metrics_named
from studies.study.study import Parameter, Sampling, Study, StudyError

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
    base: str = Field(description="a prototype, or a design file beside the study")
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
        "`navier-stokes`; cases outside the atlas fail by name",
    )
    frequencies: str = Field(
        default="1:100:64", description="FIRST:LAST:COUNT, Hz; they must cover the band of every metric"
    )
    metrics: tuple[str, ...] = Field(min_length=1, description="names of figures of merit")
    transfer_functions: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="keep them too: 16 bytes per point, microphone and frequency of each case"
    )
    parameters: dict[str, Any] = Field(
        default_factory=dict,
        description="what varies, each on its own: dotted names of fields, with a list of values or a range",
    )
    together: tuple[dict[str, Any], ...] = Field(
        default=(), description="groups of parameters that vary together, like the columns of a table"
    )


#: Sections that every design file has and no study file.
_OF_A_DESIGN = ("resonator", "membrane", "tube")


def _check_no_design(given: Mapping[str, Any], source: str) -> None:
    """Reject a design file by its sections, with a study file that sweeps it.

    Raises:
        StudyError: it is a design file.
    """
    if "base" not in given and all(isinstance(given.get(section), Mapping) for section in _OF_A_DESIGN):
        example = f'''base = "{source}" / metrics = ["predicted_top1"] / [parameters] / "tube.length" = [10.0, 15.0]'''
        raise StudyError(
            "is a design file",
            kind=Kind.WRONG_TYPE,
            file=source,
            remedy=f"a study file names it and what varies, such as (a line for each part): {example}",
        )


def resolve_study(study: Study | PathLike) -> Study:
    """The study itself, or that of a file; errors as :func:`load_study`."""
    return study if isinstance(study, Study) else load_study(study)


def load_study(path: PathLike) -> Study:
    """Study read from a file; ``base`` is looked for in its folder.

    Raises:
        StudyError: no such file, not TOML, or not a valid study.
        DesignError: the base design is not valid.
    """
    path = Path(path)
    return read_study(read_text(path, "a study file", StudyError), str(path), path.parent)


def read_study(
    text: str, source: str = "study.toml", folder: Path | None = None, base: ArrayDesign | None = None
) -> Study:
    """Study read from the text of a file.

    Args:
        text: TOML.
        source: name of the file, for messages.
        folder: where design files are looked for; by default the current one.
        base: the base design, in place of the one the text names.

    Raises:
        StudyError: not TOML, or not a valid study.
        DesignError: the base design is not valid.
    """
    return study_of(parse_toml(text, source, StudyError), text, source, folder, base)


def study_of(
    given: Mapping[str, Any], text: str, source: str, folder: Path | None = None, base: ArrayDesign | None = None
) -> Study:
    """Study of the table of a study file.

    Args:
        given: as TOML gives it.
        text: the file it comes from, kept with the study.
        source: name of the file, for messages.
        folder: where design files are looked for; by default the current one.
        base: the base design, in place of the one the table names.

    Raises:
        StudyError: not a valid study.
        DesignError: the base design is not valid.
    """
    _check_no_design(given, source)
    file = model_of(StudyFields, given, source, "study", StudyError)
    design = base or _base(file.base, folder or Path(), source)
    try:
        frequency = frequency_grid(file.frequencies)
        axes = _axes(file, design)
        constraints = tuple(parse_constraint(each, design) for each in file.constraints)
        return Study(
            text=text,
            name=file.name,
            description=file.description,
            base=design,
            axes=axes,
            sampling=file.sampling,
            cases=_cases(file),
            seed=file.seed,
            constraints=constraints,
            fidelity=file.fidelity or atlas.quick_fidelity(design, frequency).name,
            frequency=frequency,
            metrics=_metrics(file.metrics, frequency),
            transfer_functions=file.transfer_functions,
        )
    except Refusal as error:
        raise error_of_file(error, source) from None


def error_of_file(error: Refusal, source: str) -> StudyError:
    """The error of a study file for one of the values in it, whose field is called as in the file."""
    return StudyError.of(error, file=source, field="frequencies" if error.field == "frequency" else error.field)


def _base(name: str, folder: Path, source: str) -> ArrayDesign:
    if name in prototype_names():
        return prototype(name)
    path = folder / name
    if not os.path.isfile(path):
        raise StudyError(
            f"is neither a file in {folder} nor a prototype",
            kind=Kind.UNKNOWN,
            file=source,
            field="base",
            value=name,
            remedy=nearest(name, prototype_names()),
        )
    return load_design(path)


def _metrics(names: tuple[str, ...], frequency: Array) -> tuple[str, ...]:
    for metric in metrics_named(names):
        metric.check_grid(frequency)
    return tuple(dict.fromkeys(names))


# -- what varies ------------------------------------------------------------------------------------
def _axes(file: StudyFields, base: ArrayDesign) -> tuple[tuple[Parameter, ...], ...]:
    groups = [("parameters", {name: value}) for name, value in _flat(file.parameters).items()]
    groups += [(f"together.{number}", _flat(each)) for number, each in enumerate(file.together)]
    if not any(group for _, group in groups):
        allowed = 'a table of at least one field that varies, such as "tube.length" = [10, 20]'
        raise Refusal(kind=Kind.MISSING, field="parameters", allowed=allowed)
    axes: list[tuple[Parameter, ...]] = []
    for table, group in groups:
        axis = tuple(
            _parameter(name, given, f"{table}.{name}", file.sampling == "grid", base) for name, given in group.items()
        )
        sizes = {parameter.name: parameter.size for parameter in axis}
        if len(set(sizes.values())) > 1:
            counts = ", ".join(f"{name} has {size}" for name, size in sizes.items())
            raise Refusal(f"must have equally many values of each field; {counts}", kind=Kind.CONFLICT, field=table)
        for name in group:
            if any(name == parameter.name for other in axes for parameter in other):
                remedy = "give it under [parameters] or in one group of [[together]]"
                raise Refusal("is given twice", kind=Kind.CONFLICT, field=f"{table}.{name}", remedy=remedy)
        axes.append(axis)
    tables = [table for table, _ in groups]
    _check_size(file, axes)
    for table, axis in zip(tables, axes, strict=True):
        if file.sampling == "grid" or all(parameter.values for parameter in axis):
            _check_distinct(table, axis)
    return tuple(axis for axis in axes if axis)


def _check_size(file: StudyFields, axes: Sequence[tuple[Parameter, ...]]) -> None:
    """Reject a grid of too many cases."""
    count = math.prod(len(axis[0].grid()) for axis in axes if axis) if file.sampling == "grid" else 0
    if count > LARGEST:
        problem = f"has {count} cases; it must have at most {LARGEST}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="sampling", value=file.sampling)


def _check_distinct(table: str, axis: tuple[Parameter, ...]) -> None:
    """Reject values, or rows of a group, that are there twice: they would give equal cases."""
    seen: set[tuple[Any, ...]] = set()
    for row in zip(*(parameter.grid().tolist() for parameter in axis), strict=True):
        if row in seen:
            alone = axis[0] if len(axis) == 1 else None
            raise Refusal(
                "is there twice, which gives equal cases",
                kind=Kind.CONFLICT,
                field=table if alone is None else f"{table}.{alone.name}",
                value=list(row) if alone is None else row[0],
                remedy="leave out one" if alone is None or alone.values else "give a smaller count",
            )
        seen.add(row)


def _flat(table: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Dotted names, whether they are in quotes or not: without quotes TOML makes tables of them."""
    flat: dict[str, Any] = {}
    for key, value in table.items():
        if isinstance(value, dict) and not {"from", "to"} & set(value) and value:
            flat |= _flat(value, f"{prefix}{key}.")
        else:
            flat[prefix + key] = value
    return flat


def _parameter(name: str, given: Any, place: str, in_grid: bool, base: ArrayDesign) -> Parameter:
    """The parameter of a field of the design, by what the study file gives for it at a dotted place."""
    try:
        check_name(as_lists(base.model_dump()), name, base.name)
        now = value_of(base, name)
    except DesignError as error:
        problem = error.problem if error.field == name else f"names {error.field}, which {error.problem}"
        raise Refusal.of(error, file=None, field=place, problem=problem) from None
    field = field_named(ArrayDesign, name)
    kind = "a number" if field is None else field.kind
    if kind in ("a table", "a list") or isinstance(now, (BaseModel, tuple, dict)):
        remedy = f"give the fields in it, such as {name}.length"
        raise Refusal(f"is {kind}", kind=Kind.WRONG_TYPE, field=place, remedy=remedy)
    if isinstance(given, list) and given:
        for value in given:
            _check_value(name, value, place)
        return Parameter(name, values=tuple(given), whole=kind == "a whole number")
    if not isinstance(given, dict) or not {"from", "to"} <= set(given):
        allowed = "a list of values, or a range {from = ..., to = ..., count = ...}"
        raise Refusal(kind=Kind.WRONG_TYPE, field=place, value=given, allowed=allowed)
    limits = model_of(RangeFields, given, "", "study", StudyError, table=place)
    whole = kind == "a whole number"
    if kind == "a text":
        raise Refusal("is a text", kind=Kind.WRONG_TYPE, field=place, remedy="give a list of values, not a range")

    def refusal(end: str, value: object, allowed: str, kind: Kind = Kind.CONFLICT) -> Refusal:
        return Refusal(kind=kind, field=f"{place}.{end}", value=value, allowed=allowed)

    for end, value in (("from", limits.first), ("to", limits.last)):
        if whole and value != round(value):
            raise refusal(end, value, "a whole number", Kind.WRONG_TYPE)
        _check_value(name, round(value) if whole else value, f"{place}.{end}")
    if limits.first >= limits.last:
        raise refusal("from", limits.first, f"below to = {limits.last:g}")
    if limits.scale == "log" and limits.first <= 0:
        raise refusal("from", limits.first, "above 0 for scale = 'log'")
    if whole and limits.scale == "log":
        raise refusal("scale", limits.scale, "'linear' for whole numbers")
    step = limits.step or 0.0
    if step and whole:
        raise refusal("step", step, "left out for whole numbers")
    if step > limits.last - limits.first:
        raise refusal("step", step, f"at most {limits.last - limits.first:g}, its range")
    steps = (limits.last - limits.first) / (1.0 if whole else step or math.inf)
    count = limits.count or (math.floor(steps + 1e-9) + 1 if whole or step else 0)
    if in_grid and not count:
        raise refusal("count", Refusal.NOT_GIVEN, "the number of values in a grid", Kind.MISSING)
    if whole:
        count = min(count, round(limits.last - limits.first) + 1)
    return Parameter(name, (), limits.first, limits.last, count if in_grid else 0, limits.scale, whole, step)


def _check_value(name: str, value: Any, place: str) -> None:
    """Refuse a value that its field never allows. Rules between fields are left: other parameters may satisfy them."""
    try:
        check_value(ArrayDesign, name, value, "")
    except DesignError as error:
        raise Refusal.of(error, file=None, field=place) from None


def _cases(file: StudyFields) -> int:
    if file.sampling == "grid":
        if file.cases is not None:
            allowed = "left out for sampling = 'grid', which has every combination"
            raise Refusal(kind=Kind.CONFLICT, field="cases", value=file.cases, allowed=allowed)
        return 0
    if file.cases is None:
        allowed = f"the number of samples for sampling = {file.sampling!r}"
        raise Refusal(kind=Kind.MISSING, field="cases", allowed=allowed)
    return file.cases
