"""The file of an optimisation: a study, and under ``[optimize]`` what is wanted of its designs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field

from geometry import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_toml
from geometry.schema.field_errors import model_of
from studies.optimization.printable import Demand, PrintDemand
from studies.study.cases import check_base
from studies.study.fields import FileSection
from studies.study.metric_registry import METRICS, Metric, metrics_named
from studies.study.mistaken_files import check_no_design, study_text
from studies.study.parameter import Parameter, StudyError
from studies.study.study import Study, study_of

#: Difference of a size from a limit that is rounding, mm.
_ROUNDING = 1e-6
Method = Literal["nsga2", "tpe", "random", "gradient"]


@dataclass(frozen=True)
class Objective:
    """Objective: a figure of merit to be made as large, or as small, as possible."""

    metric: Metric
    """Figure of merit."""
    better: Literal["larger", "smaller"]
    """Word for the values that are wanted."""

    @property
    def direction(self) -> Literal["maximize", "minimize"]:
        """Direction of the objective, as Optuna calls it."""
        return "maximize" if self.better == "larger" else "minimize"


@dataclass(frozen=True)
class Limit:
    """Bound on a figure of merit that a design must keep."""

    metric: Metric
    """Figure of merit."""
    least: float | None
    """Smallest value allowed; None for none."""
    most: float | None
    """Largest value allowed; None for none."""

    def excess(self, value: float) -> float:
        """Distance of a value beyond the bound, as a fraction of it; zero or below where it is kept."""
        scale = abs(self.least if self.least is not None else self.most or 0.0) or 1.0
        below = -float("inf") if self.least is None else (self.least - value) / scale
        above = -float("inf") if self.most is None else (value - self.most) / scale
        return max(below, above)

    def __str__(self) -> str:
        bounds = [f"at least {self.least:g}"] if self.least is not None else []
        bounds += [f"at most {self.most:g}"] if self.most is not None else []
        return f"{self.metric.name} {' and '.join(bounds)}{f' {self.metric.unit}' * (self.metric.unit != '1')}"


@dataclass(frozen=True, eq=False)
class Optimization:
    """Problem of an optimisation: what is varied, what is wanted, and how it is searched."""

    study: Study
    """Base design, parameters, constraints, fidelity, frequencies and metrics. Samples of it are not taken."""
    text: str
    """Text of the whole file."""
    objectives: tuple[Objective, ...]
    """Figures of merit to be made best, one or more."""
    limits: tuple[Limit, ...]
    """Bounds that a design must keep."""
    trials: int
    """Number of designs to try."""
    batch: int
    """Number of designs that are proposed at once and computed in one call."""
    method: Method
    """Method of the search: "nsga2" for a front, "tpe" for one objective, "random" for comparison, "gradient" for steps
    along the slopes of one objective that has them."""
    rules: PrintDemand
    """Demand that a design must meet to be printed and laid out."""
    free: Study | None = None
    """Study with ranges of free sizes, along whose slopes a search goes: each step is then made of the nearest sizes of
    the study that can be bought. None for other methods, whose steps are such sizes from the start."""

    @property
    def metrics(self) -> tuple[Metric, ...]:
        """Metrics to compute: objectives, limits, and what the study lists besides."""
        wanted: tuple[Objective | Limit, ...] = (*self.objectives, *self.limits)
        names = [each.metric.name for each in wanted] + list(self.study.metrics)
        return metrics_named(dict.fromkeys(names))


_Whole = Annotated[int, Field(strict=True)]
_Real = Annotated[float, Field(strict=True)]


class _Objective(FileSection):
    metric: str = Field(description="name of a metric")
    better: Literal["larger", "smaller"] | None = Field(
        default=None, description="values that are wanted; by default those that the metric calls better"
    )


class _Limit(FileSection):
    metric: str = Field(description="name of a metric")
    least: _Real | None = Field(default=None, description="smallest value allowed")
    most: _Real | None = Field(default=None, description="largest value allowed")


class OptimizeFields(FileSection):
    """Section ``[optimize]`` of a study file."""

    trials: Annotated[_Whole, Field(ge=1, le=1_000_000)] = Field(default=2000, description="number of designs to try")
    batch: Annotated[_Whole, Field(ge=1, le=10_000)] = Field(
        default=64, description="number of designs that are computed in one call"
    )
    method: Method | None = Field(
        default=None,
        description="`nsga2` for several objectives, `tpe` for one, `random` for comparison, `gradient` to follow "
        "derivatives; by default `nsga2` or `tpe`, depending on the number of objectives",
    )
    printable: Demand = Field(
        default="base",
        description="demand on the parts: `least` for no failed print rule; `advised` for every measure at its advised "
        "value or better; `base` for the advised values, or those of the base design where it falls short of them",
    )
    objectives: tuple[_Objective, ...] = Field(min_length=1, max_length=4, description="metrics to optimise")
    limits: tuple[_Limit, ...] = Field(default=(), description="bounds on metrics")


def load_optimization(path: str | os.PathLike[str]) -> Optimization:
    """Problem read from the file of an optimisation.

    Raises:
        StudyError: no such file, not TOML, or not valid.
        DesignError: the base design is not valid.
    """
    return read_optimization(study_text(path), os.fspath(path), Path(path).parent)


def read_optimization(
    text: str, source: str = "study.toml", folder: Path | None = None, base: ArrayDesign | None = None
) -> Optimization:
    """Problem read from the text of such a file; arguments and errors as :func:`studies.study.study.read_study`."""
    given = parse_toml(text, source, StudyError)
    check_no_design(given, source)
    wanted = given.pop("optimize", None)
    if wanted is None:
        allowed = 'a table that says what is wanted, such as [[optimize.objectives]] with metric = "distance_smallest"'
        raise StudyError(kind=Kind.MISSING, file=source, field="optimize", allowed=allowed)
    # the optimiser proposes the cases
    if given.get("outside", "fail") != "fail":
        allowed = "left out in a search: a design outside the atlas fails"
        raise StudyError(kind=Kind.CONFLICT, file=source, field="outside", value=given["outside"], allowed=allowed)
    given = {**given, "sampling": "random", "cases": 1}
    study = study_of(given, text, source, folder, base)
    file = model_of(OptimizeFields, wanted, source, "study", StudyError, table="optimize")
    free = study_of({**given, "stock": "off"}, text, source, folder, base) if file.method == "gradient" else None
    try:
        return _checked(file, study, text, free)
    except Refusal as error:
        raise StudyError.of(error, file=source) from None


def _checked(file: OptimizeFields, study: Study, text: str, free: Study | None) -> Optimization:
    objectives: list[Objective] = []
    for number, wanted in enumerate(file.objectives):
        metric = _metric(wanted.metric, f"optimize.objectives.{number}.metric")
        if metric.name in (each.metric.name for each in objectives):
            problem = "is an objective already"
            field = f"optimize.objectives.{number}.metric"
            raise Refusal(problem, kind=Kind.CONFLICT, field=field, value=metric.name, remedy="name different metrics")
        better: Any = wanted.better or metric.better
        objectives.append(Objective(metric, better))
    limits = []
    for number, bound in enumerate(file.limits):
        field = f"optimize.limits.{number}"
        if bound.least is None and bound.most is None:
            problem = f"has no bound for {bound.metric}"
            raise Refusal(problem, kind=Kind.MISSING, field=field, remedy="give least, most, or both")
        if bound.least is not None and bound.most is not None and bound.least > bound.most:
            allowed = f"at most most = {bound.most:g}"
            raise Refusal(kind=Kind.CONFLICT, field=f"{field}.least", value=bound.least, allowed=allowed)
        limits.append(Limit(_metric(bound.metric, f"{field}.metric"), bound.least, bound.most))
    for metric in (*(objective.metric for objective in objectives), *(limit.metric for limit in limits)):
        metric.check_grid(study.frequency)
    check_base(study)
    rules = PrintDemand(study.base, file.printable)
    for axis in study.axes:
        for parameter in axis:
            searched_range(parameter, rules)
        if all(each.values for each in axis) and not printable_rows(axis, rules):
            names = ", ".join(each.name for each in axis)
            problem = f"has no values of {names} that can be printed together"
            raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="vary")
    method = file.method or ("nsga2" if len(objectives) > 1 else "tpe")
    if free is not None:
        _check_slopes(objectives, free)
    aims, bounds = tuple(objectives), tuple(limits)
    return Optimization(study, text, aims, bounds, file.trials, file.batch, method, rules, free)


def _metric(name: str, field: str) -> Metric:
    try:
        return metrics_named([name])[0]
    except Refusal as error:
        raise Refusal.of(error, field=field) from None


def searched_range(parameter: Parameter, rules: PrintDemand) -> tuple[float, float]:
    """Ends of the range or list in which a parameter is searched, mm: not below what the process can print.

    Raises:
        Refusal: nothing of the range or list can be printed.
    """
    least = rules.least_value(parameter.name)
    if least is None:
        return (0.0, 0.0) if parameter.values else (parameter.low, parameter.high)
    ends = [float(each) for each in parameter.values] or [parameter.low, parameter.high]
    low, high = min(ends), max(ends)
    if high < least:
        raise Refusal(
            f"ends at {high:g} mm; it must reach {least:g} mm, the smallest that the process and optimize.printable = "
            f"{rules.demand!r} allow",
            kind=Kind.OUT_OF_RANGE,
            field=f"vary.{parameter.name}",
        )
    return max(low, least), high


def printable_rows(axis: Sequence[Parameter], rules: PrintDemand) -> list[int]:
    """Indices of the values of lists that go together which the process can print; see :func:`searched_range`."""
    least = {each.name: rules.least_value(each.name) for each in axis}
    limits = [(each.values, limit) for each in axis if (limit := least[each.name]) is not None]
    rows = range(len(axis[0].values))
    return [row for row in rows if all(float(values[row]) >= limit - _ROUNDING for values, limit in limits)]


def _check_slopes(objectives: Sequence[Objective], study: Study) -> None:
    """Refuse what cannot be searched along slopes.

    Raises:
        Refusal: several objectives, one without slopes, or a parameter that is not a free range of numbers above 0.
    """
    if len(objectives) != 1 or objectives[0].metric.slopes is None:
        having = ", ".join(metric.name for metric in METRICS.values() if metric.slopes is not None)
        given = ", ".join(each.metric.name for each in objectives)
        problem = f"needs one objective that has derivatives, {having}; the objectives are {given}"
        raise Refusal(problem, kind=Kind.CONFLICT, field="optimize.method", value="gradient")
    for axis in study.axes:
        first = axis[0]
        free = not first.values and not first.whole and not first.step and min(first.low, first.high) > 0
        if len(axis) != 1 or not free:
            allowed = "a range above 0, without steps and not under [[together]], for optimize.method = 'gradient'"
            raise Refusal(kind=Kind.CONFLICT, field=f"vary.{first.name}", allowed=allowed)
