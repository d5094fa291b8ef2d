"""Figures of a sweep: a metric against each parameter, and one metric against another."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from geometry.ground.figures import new_figure
from studies.study.metric_registry import METRICS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Number of steps of a parameter for its median, and of different values up to which each is a step.
_STEPS = 10


class Results(Protocol):
    """Results of a sweep, as far as they are drawn."""

    @property
    def values(self) -> Mapping[str, NDArray[Any]]:
        """Values of parameters and metrics by name, (n_case,) each."""

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters."""

    @property
    def followers(self) -> Mapping[str, str]:
        """Parameters without values of their own, and what they follow."""

    @property
    def done(self) -> NDArray[np.bool_]:
        """True if a case was computed; (n_case,) bool."""

    def units(self, name: str) -> str:
        """Unit of a variable."""


def plot_effects(sweep: Results, metric: str) -> Figure:
    """Figure with a panel for each parameter that varies on its own: the metric against it, and the median along it."""
    rows = sweep.done & np.isfinite(sweep.values[metric])
    names = [name for name in sweep.parameters if name not in sweep.followers]
    figure = new_figure(3.2 * min(len(names), 3) + 1.0, 0.4 + 2.8 * -(-len(names) // 3))
    grid = figure.subplots(-(-len(names) // 3), min(len(names), 3), squeeze=False, sharey=True).flat
    values = sweep.values[metric][rows]
    for axes, name in zip(grid, names, strict=False):
        place, labels = _numbers(sweep.values[name][rows])
        axes.plot(place, values, ".", color="#9ecae1", markersize=4)
        axes.plot(*_medians(place, values), "o-", color="#08519c")
        unit = sweep.units(name)
        axes.set_xlabel(f"{name}  ({unit})" if unit not in ("", "1") and not labels else name)
        if labels:
            axes.set_xticks(range(len(labels)), labels)
    for axes in list(grid)[len(names) :]:
        axes.set_visible(False)
    figure.supylabel(_title(metric))
    return figure


def plot_trade_off(sweep: Results, metric: str, against: str) -> Figure:
    """Figure of one metric against another: all cases, and those that no other case beats in both."""
    rows = np.flatnonzero(sweep.done & np.isfinite(sweep.values[metric]) & np.isfinite(sweep.values[against]))
    figure = new_figure(6.4, 4.4)
    axes = figure.subplots()
    x, y = sweep.values[against][rows], sweep.values[metric][rows]
    axes.plot(x, y, ".", color="#9ecae1", label="cases")
    best = _front(_goodness(against, x), _goodness(metric, y))
    axes.plot(x[best], y[best], "o-", color="#08519c", label="best in both")
    for number, across, up in zip(rows[best], x[best], y[best], strict=True):
        axes.annotate(str(number), (across, up), xytext=(4, 4), textcoords="offset points", fontsize=8)
    axes.set(xlabel=_title(against), ylabel=_title(metric))
    axes.legend()
    return figure


def _title(metric: str) -> str:
    about = METRICS[metric]
    return f"{about.long_name}  ({about.unit})" if about.unit != "1" else about.long_name


def _goodness(metric: str, values: NDArray[np.float64]) -> NDArray[np.float64]:
    return -values if METRICS[metric].better == "smaller" else values


def _front(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.int64]:
    """Rows that no other beats in both values, in the order of the first; larger is better."""
    order = np.lexsort((-second, -first))
    ahead = np.concatenate([[-np.inf], np.maximum.accumulate(second[order])[:-1]])
    return order[second[order] > ahead]


def _numbers(values: NDArray[Any]) -> tuple[NDArray[np.float64], list[str]]:
    """Values as numbers, texts as the places of their labels."""
    if values.dtype != object:
        return values.astype(np.float64), []
    labels = list(dict.fromkeys(map(str, values)))
    return np.array([labels.index(str(value)) for value in values], np.float64), labels


def _medians(place: NDArray[np.float64], values: NDArray[np.float64]) -> tuple[list[float], list[float]]:
    """Median of the values at each place, or in steps that hold about equally many."""
    if not len(place):
        return [], []
    if len(np.unique(place)) <= _STEPS:
        groups = [place == each for each in np.unique(place)]
    else:
        edges = np.unique(np.quantile(place, np.linspace(0, 1, _STEPS + 1)))
        step = np.clip(np.searchsorted(edges, place, side="right") - 1, 0, len(edges) - 2)
        groups = [step == each for each in np.unique(step)]
    return [float(place[own].mean()) for own in groups], [float(np.median(values[own])) for own in groups]
