"""Figures of an evaluation, as PNG files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from localize.evaluation.accuracy import wilson_interval
from localize.evaluation.conditions import Outcome
from studies.evaluation.full_evaluation import LocalizerResult
from studies.output.figure_style import WIDTH, figure_in_style as figure_in_style, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COLOURS = ("#2a6f97", "#d1731f", "#5b8c3e")
_MARKS = ("o", "s", "^")


def draw_reliability(results: Sequence[LocalizerResult], path: str | os.PathLike[str]) -> Path:
    """Picture of the fraction classified correctly against the stated probability, and its histogram; its path."""
    with figure_in_style((WIDTH / 1.6, 5.0)) as figure:
        upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
        upper.plot([0, 1], [0, 1], color="#999999", linestyle="--", linewidth=1)
        for each, colour, mark in zip(results, _COLOURS, _MARKS, strict=False):
            bins = [each_bin for each_bin in each.headline.reliability.bins if each_bin.touches]
            stated, right = ([getattr(each_bin, name) for each_bin in bins] for name in ("stated", "right"))
            error = each.headline.reliability.expected_error
            label = f"{each.name}: expected calibration error {100 * error:.1f} %"
            upper.plot(stated, right, marker=mark, color=colour, label=label)
            lower.plot(stated, [each_bin.touches for each_bin in bins], marker=mark, color=colour)
        upper.set(ylabel="classified correctly", ylim=(0, 1.03), title="stated probability and truth")
        upper.legend(loc="upper left")
        lower.set(xlabel="stated probability", ylabel="touches", yscale="log", xlim=(0, 1.03))
        return save_figure(figure, path)


def draw_conditions(results: Sequence[LocalizerResult], path: str | os.PathLike[str]) -> Path:
    """Picture of top-1 in every condition with its 95 % interval, a panel per group, of several sensors the worst one
    dashed; its path.
    """
    groups = list(dict.fromkeys(outcome.group for each in results for outcome in each.outcomes))
    rows = -(-(len(groups) + 1) // 2)
    with figure_in_style((WIDTH, 0.4 + 2.9 * rows)) as figure:
        panels = figure.subplots(rows, 2, squeeze=False).flat
        _draw_components(results, panels[0])
        for panel, group in zip(panels[1:], groups, strict=False):
            for number, each in enumerate(results):
                _draw_group(panel, [outcome for outcome in each.outcomes if outcome.group == group], number, each.name)
            panel.set(title=group)
        for panel in panels[len(groups) + 1 :]:
            panel.set_axis_off()
        for panel in panels[: len(groups) + 1]:
            panel.set(ylim=(0, 103), ylabel="top-1  (%)")
        panels[1].legend(loc="lower left")
        return save_figure(figure, path)


def _draw_components(results: Sequence[LocalizerResult], panel: Axes) -> None:
    for number, each in enumerate(results):
        counted = list(each.headline.multi_sines.by_components.values())
        shares = [100 * share for share, _ in counted]
        bars = _error_bars([(share, *wilson_interval(share, touches)) for share, touches in counted])
        _draw_bars(panel, list(each.headline.multi_sines.by_components), shares, bars, number, len(results), each.name)
    panel.set(title="sines of a multi-sine touch, nominal sensor")


def _draw_group(panel: Axes, outcomes: list[Outcome], number: int, name: str) -> None:
    names = [outcome.name for outcome in outcomes]
    place = np.arange(len(names))
    colour, mark = _COLOURS[number], _MARKS[number]
    bars = _error_bars([(outcome.top1, outcome.low, outcome.high) for outcome in outcomes])
    # Beside each other, so that one does not hide the other.
    panel.errorbar(place + 0.12 * number, [100 * outcome.top1 for outcome in outcomes], bars, marker=mark, color=colour,
                   label=name, capsize=2, linestyle="-" if outcomes[0].value is not None else "none")  # fmt: skip
    worst = [outcome.worst for outcome in outcomes if outcome.worst is not None]
    if len(worst) == len(outcomes):
        panel.plot(place, [100 * share for share in worst], color=colour, linestyle="--", linewidth=1)
    panel.set_xticks(place, names, rotation=25 if len(names) > 4 else 0, fontsize=8)


def _error_bars(shares: Sequence[tuple[float, float, float]]) -> NDArray[np.float64]:
    """(2, n) percent below and above, of (share, low, high) each."""
    share, low, high = 100 * np.array(shares).T
    return np.maximum(np.stack([share - low, high - share]), 0.0)


def _draw_bars(
    panel: Axes, names: list[str], values: list[float], bars: NDArray[np.float64], number: int, count: int, label: str
) -> None:
    width = 0.8 / count
    place = np.arange(len(names)) + (number - (count - 1) / 2) * width
    panel.bar(place, values, width, yerr=bars, capsize=2, color=_COLOURS[number], label=label)
    panel.set_xticks(np.arange(len(names)), names, fontsize=8)
