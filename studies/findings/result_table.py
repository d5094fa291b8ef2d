"""Results of a sweep or a search as plain columns: for the report and for the table of best designs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from geometry import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.declared_fields import DesignField, field_named
from studies.optimization.problem import Optimization
from studies.optimization.search import OptimizationResult, pareto_front
from studies.study.cases import by_kind
from studies.study.metric_registry import METRICS
from studies.study.parameter import followers
from studies.sweep.results import Sweep, base_of

Values = NDArray[np.float64]
#: Steps of a range in the figures of effects and of pairs.
BINS = 10


@dataclass(frozen=True, eq=False)
class Column:
    """Column of a parameter or a metric, with its value for every design."""

    name: str
    """Dotted name of a field, or name of a metric."""
    title: str
    """Title, a few words."""
    unit: str
    """Unit of the values; empty for ratios."""
    values: Values
    """Value of each design, in the unit; of a text, the index of its label; (n,) float64."""
    labels: tuple[str, ...] = ()
    """Texts that the values stand for; empty for numbers."""
    better: str = ""
    """Word for the values that are wanted, "larger" or "smaller"; empty for parameters."""
    follows: str = ""
    """Name of the parameter whose values decide those of this one; empty if it varies on its own, and for metrics."""
    caution: str = ""
    """Caution to whoever ranks designs by it alone; empty where there is none."""

    @property
    def words(self) -> dict[str, Any]:
        """The column's description on a page: name, title, unit, labels and the better direction."""
        return {
            "name": self.name,
            "title": self.title,
            "unit": self.unit,
            "labels": list(self.labels),
            "better": self.better,
        }

    @property
    def goodness(self) -> Values:
        """Values with a sign, larger being better; (n,) float64."""
        return -self.values if self.better == "smaller" else self.values


@dataclass(frozen=True, eq=False)
class ResultTable:
    """Table of the designs that were computed, and of what kept others from it."""

    title: str
    """Title of the study."""
    description: str
    """Question that the study asks."""
    source: str
    """Word for how the designs were chosen: "sweep" or "search"."""
    fidelity: str
    """Fidelity that the cells were computed with."""
    frequency: Values
    """Frequencies of the study; (n_freq,) float64, Hz."""
    open_base: Callable[[], ArrayDesign]
    """Maker of :attr:`base`, which another process can be handed."""
    number: NDArray[np.int64]
    """Number of the case or trial of each row; (n,) int64."""
    parameters: tuple[Column, ...]
    """Columns of what was varied; those that follow others come last."""
    metrics: tuple[Column, ...]
    """Columns of what was computed, all finite."""
    failures: tuple[tuple[str, int], ...]
    """Kinds of reasons, each by its first, and how many designs failed for each."""
    waiting: int
    """Number of designs not computed yet."""
    base_metrics: Mapping[str, float]
    """Figures of the base design, in their units; empty where they are not known."""

    @cached_property  # a table is listed without the classes of designs
    def base(self) -> ArrayDesign:
        """Design that was varied."""
        return self.open_base()

    @property
    def free(self) -> tuple[Column, ...]:
        """Columns of the parameters that vary on their own, so that effects can be told apart."""
        return tuple(column for column in self.parameters if not column.follows)

    def values(self, row: int) -> dict[str, Any]:
        """Parameters of a design by dotted name."""
        return {column.name: _value(column, row) for column in self.parameters}

    def metric(self, name: str) -> Column:
        """Column of a metric by name.

        Raises:
            Refusal: it was not computed.
        """
        for column in self.metrics:
            if column.name == name:
                return column
        allowed = tuple(column.name for column in self.metrics)
        raise Refusal(kind=Kind.UNKNOWN, field="by", value=name, allowed=allowed)

    @property
    def leading(self) -> Column:
        """Column that designs are ranked by unless told otherwise: what a search looks for first; of a sweep the first
        that needs no caution, if there is one.
        """
        trusted = [column for column in self.metrics if not column.caution] if self.source == "sweep" else []
        return (trusted or list(self.metrics))[0]

    def label(self, row: int) -> str:
        """Name of the design of a row: its number."""
        return str(int(self.number[row]))

    def best(self, metric: str, count: int) -> list[int]:
        """Rows of the best designs by one metric, the best first; equals by number.

        Raises:
            Refusal: the metric was not computed.
        """
        order = np.lexsort((self.number, -self.metric(metric).goodness))
        return [int(row) for row in order[:count]]

    def fronts(self) -> NDArray[np.int64]:
        """Rows that lie on the front of any two metrics, ascending; (n,) int64."""
        rows: set[int] = set()
        for first, second in combinations(self.metrics, 2):
            rows.update(np.flatnonzero(fast_front(np.column_stack([first.goodness, second.goodness]))).tolist())
        return np.array(sorted(rows), dtype=np.int64)


@dataclass(frozen=True, eq=False)
class Effect:
    """Main effect of one parameter on a metric, all others varying as they do."""

    centres: Values
    """Centres of the steps; of texts, their indices; (n,) float64, in the unit of the parameter."""
    mean: Values
    """Mean of the metric in each step; (n,) float64, in its unit."""
    low: Values
    """10th percentile of the metric in each step; (n,) float64, in its unit."""
    high: Values
    """90th percentile of the metric in each step; (n,) float64, in its unit."""
    share: float
    """Share of the metric's variance that the means explain, 0 to 1, less what chance would (omega squared)."""


def effect(parameter: Column, metric: Column) -> Effect:
    """Main effect of a parameter on a metric, from designs in about equally filled steps."""
    groups = steps(parameter)
    members = [metric.values[groups == k] for k in range(groups.max() + 1)]
    centres = np.array([parameter.values[groups == k].mean() for k in range(len(members))])
    low, high = (np.array([np.quantile(each, q) for each in members]) for q in (0.1, 0.9))
    means = np.array([each.mean() for each in members])
    total = float(((metric.values - metric.values.mean()) ** 2).sum())
    between = float(sum(len(each) * (m - metric.values.mean()) ** 2 for each, m in zip(members, means, strict=True)))
    free = len(metric.values) - len(members)
    noise = (total - between) / free if free > 0 else 0.0
    share = (between - (len(members) - 1) * noise) / (total + noise) if total > 0 else 0.0
    return Effect(centres, means, low, high, min(max(share, 0.0), 1.0))


def steps(parameter: Column) -> NDArray[np.int64]:
    """Step of each design by a parameter, from 0; (n,) int64: its value where there are few, else ranges that hold
    about equally many.
    """
    distinct, index = np.unique(parameter.values, return_inverse=True)
    if len(distinct) <= BINS:
        return np.asarray(index, np.int64)
    edges = np.unique(np.quantile(parameter.values, np.linspace(0, 1, BINS + 1)[1:-1]))
    return np.unique(np.searchsorted(edges, parameter.values, side="right"), return_inverse=True)[1].astype(np.int64)


def pair_map(first: Column, second: Column, metric: Column) -> tuple[Values, Values, Values]:
    """Mean of a metric over the steps of two parameters.

    Returns:
        Centres (n_first,) and (n_second,) float64, and means (n_second, n_first) float64, NaN where there is no design.
    """
    own, other = steps(first), steps(second)
    shape = (int(other.max()) + 1, int(own.max()) + 1)
    total, count = np.zeros(shape), np.zeros(shape)
    np.add.at(total, (other, own), metric.values)
    np.add.at(count, (other, own), 1)
    with np.errstate(invalid="ignore"):
        means = np.where(count > 0, total / np.maximum(count, 1), np.nan)
    centres = [
        np.array([column.values[group == k].mean() for k in range(group.max() + 1)])
        for column, group in ((first, own), (second, other))
    ]
    return centres[0], centres[1], means


def fast_front(values: Values) -> NDArray[np.bool_]:
    """Rows of two columns that no other row beats: as :func:`studies.optimization.search.pareto_front`, by sorting.

    Args:
        values: (n, n_objective) float64, larger is better; other than two columns are left to that function.

    Returns:
        (n,) bool.
    """
    if values.shape[1] != 2:
        return pareto_front(values)
    order = np.lexsort((-values[:, 1], -values[:, 0]))
    best = np.maximum.accumulate(values[order, 1])
    ahead = np.concatenate([[-np.inf], best[:-1]])
    keep = values[order, 1] > ahead
    # equals of one that is kept are beaten by none
    same = np.concatenate([[False], (values[order][1:] == values[order][:-1]).all(axis=1)])
    for k in np.flatnonzero(same):
        keep[k] = keep[k - 1]
    front = np.zeros(len(values), dtype=bool)
    front[order] = keep
    return front


# -- made from --------------------------------------------------------------------------------------
def table_of_sweep(sweep: Sweep) -> ResultTable:
    """Table of the finished cases of a sweep; those with a metric that is not finite count as failed.

    Raises:
        Refusal: no case is done, or nothing was computed.
    """
    values, about = sweep.values, sweep.attributes
    columns = {name: np.asarray(values[name], np.float64) for name in sweep.metrics}
    finite = np.all([np.isfinite(column) for column in columns.values()], axis=0)
    rows = np.flatnonzero(sweep.done & finite)
    if not len(rows):
        problem = f"has no case that is done, of {len(values['case'])}"
        raise Refusal(problem, kind=Kind.NO_RESULT, file=sweep.records.path)
    reasons = [(int(number), str(values["reason"][number])) for number in np.flatnonzero(sweep.failed)]
    reasons += [(int(number), "a metric is not finite") for number in np.flatnonzero(sweep.done & ~finite)]
    return ResultTable(
        title=about["title"],
        description=about["description"],
        source="sweep",
        fidelity=about["fidelity"],
        frequency=sweep.frequency,
        open_base=partial(base_of, sweep.records.path, about["base_design"]),
        number=rows.astype(np.int64),
        parameters=_in_order(
            [_parameter(name, values[name][rows], sweep.units(name)) for name in sweep.parameters], sweep.followers
        ),
        metrics=tuple(_metric(name, column[rows]) for name, column in columns.items()),
        failures=tuple((reason, len(numbers)) for reason, numbers in by_kind(reasons).items()),
        waiting=int((~sweep.done & ~sweep.failed).sum()),
        base_metrics={},
    )


def table_of_search(problem: Optimization, result: OptimizationResult) -> ResultTable:
    """Table of the designs that a search computed and that keep its limits.

    Raises:
        Refusal: none does.
    """
    kept = [each for each in result.candidates if each.feasible]
    if not kept:
        words = f"has no design among {len(result.candidates)} that keeps the limits"
        raise Refusal(words, kind=Kind.NO_RESULT, file=problem.study.name)
    broken = len(result.candidates) - len(kept)
    limits = "; ".join(str(limit) for limit in problem.limits)
    failures = [*result.refused, *([(f"not {limits}", broken)] if broken else [])]
    return ResultTable(
        title=problem.study.name,
        description=problem.study.description,
        source="search",
        fidelity=problem.study.fidelity,
        frequency=problem.study.frequency,
        open_base=partial(_same, problem.study.base),
        number=np.array([each.number for each in kept], dtype=np.int64),
        parameters=_in_order(
            [
                _parameter(parameter.name, np.array([each.values[parameter.name] for each in kept], dtype=object),
                           unit_of(parameter.name))
                for parameter in problem.study.parameters
            ],
            followers([[(each.name, each.values) for each in axis] for axis in problem.study.axes]),
        ),
        metrics=tuple(
            _metric(metric.name, np.array([each.metrics[metric.name] for each in kept])) for metric in problem.metrics
        ),
        failures=tuple(sorted(failures, key=lambda pair: -pair[1])),
        waiting=0,
        base_metrics=result.base.metrics,
    )  # fmt: skip


def _in_order(columns: Iterable[Column], follow: Mapping[str, str]) -> tuple[Column, ...]:
    """Columns with what they follow; those that follow others come last."""
    named = [replace(column, follows=follow.get(column.name, "")) for column in columns]
    return tuple(sorted(named, key=lambda column: bool(column.follows)))


def _same(design: ArrayDesign) -> ArrayDesign:
    return design


def _value(column: Column, row: int) -> float | int | str:
    """Value of a parameter as a design states it: fields that are whole numbers take no others."""
    value = float(column.values[row])
    if column.labels:
        return column.labels[int(value)]
    field = _field(column.name)
    return int(value) if field is not None and field.kind == "a whole number" else value


def unit_of(name: str) -> str:
    """Unit of a field of the design by dotted name, empty if it is dimensionless."""
    field = _field(name)
    return "" if field is None else field.unit


def _field(name: str) -> DesignField | None:
    return field_named(ArrayDesign, name)


def _parameter(name: str, values: NDArray[Any], unit: str) -> Column:
    try:
        return Column(name, name, "" if unit == "1" else unit, values.astype(np.float64))
    except (ValueError, TypeError):
        texts = [str(value) for value in values]
        labels = tuple(dict.fromkeys(texts))
        return Column(name, name, "", np.array([labels.index(text) for text in texts], dtype=np.float64), labels)


def with_base_metrics(table: ResultTable) -> ResultTable:
    """The table with the figures of the base of a sweep in closed form, which is rarely one of its cases: solved.

    At fidelity atlas a base outside the atlas has no figures, like a failed case.
    """
    if table.base_metrics or table.fidelity not in CLOSED_FORMS:
        return table
    if table.fidelity == "atlas" and acoustic_fem.atlas.outside_atlas(table.base, table.frequency):
        return table
    library = acoustic_fem.solve(table.base, table.frequency, table.fidelity)
    return replace(table, base_metrics={each.name: METRICS[each.name].of_library(library) for each in table.metrics})


def _metric(name: str, values: Values) -> Column:
    about = METRICS[name]
    unit = "" if about.unit == "1" else about.unit
    return Column(name, about.long_name, unit, values, better=about.better, caution=about.caution)
