"""The paper's design rules put to the test: ``python -m benchmarks.design_rules`` writes docs/studies/design_rules.

Each study file there is swept from the 2 x 6 array, and again from the simulated line of 36 points, whose membranes
are stiff and bores wide. Tables, figures and verdicts come from the results; the ends of every range are solved at
navier-stokes as well. About two minutes of one core where no cell is in the cache.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy.stats import spearmanr

import acoustic_fem
import geometry
from geometry import ArrayDesign
from geometry.ground.whole_files import replace_section, whole_file
from studies.study.metric_registry import METRICS
from studies.study.study import read_study
from studies.sweep.results import open_sweep
from studies.sweep.run import run_sweep

FOLDER = Path(__file__).parents[1] / "docs" / "studies" / "design_rules"
BEGIN, END = "<!-- {name}: made by benchmarks/design_rules.py -->", "<!-- end {name} -->"
BASES = {"2 x 6": "array-2x6", "line of 36": "line-2"}
COLOURS = {"2 x 6": "#1f5f8b", "line of 36": "#b5651d"}
#: What is tabled: metric, heading, digits behind the point of its number.
COLUMNS = (
    ("distance_smallest_low", "distance, 1 to 20 Hz", ".3f"),
    ("distance_smallest", "distance, 1 to 100 Hz", ".3f"),
    ("predicted_top1", "top-1 in quiet (%)", ".1f"),
    ("predicted_top1_white_noise", "top-1 in noise (%)", ".1f"),
    ("sensitivity_force", "sensitivity (Pa/N)", ".3g"),
)
#: A rank correlation beyond this is called a rise or a fall.
TREND = 0.9


@dataclass(frozen=True)
class Rule:
    """One claim: which parameter, what it is called on axes, and where distances should grow to."""

    name: str
    parameter: str
    axis: str
    claim: str
    grows: int
    """1: distances should grow with the parameter; -1: as it falls."""


RULES = (
    Rule("cavity_volume", "resonator.cavity_height", "height of the cavities (mm)",
         "Points with larger cavities are easier to tell apart at low frequency.", 1),
    Rule("tube_length", "tube.length", "length of the tubes (mm)",
         "Points joined by longer tubes are easier to tell apart at low frequency.", 1),
    Rule("tube_diameter", "tube.inner_diameter", "bore of the tubes (mm)",
         "Points joined by thinner tubes are easier to tell apart.", -1),
    Rule("membrane_stiffness", "membrane.thickness", "thickness of the membranes (mm)",
         "Points under softer membranes are easier to tell apart.", -1),
    Rule("points", "lines.0.points", "points on the line",
         "More points are harder to tell apart. This rule is ours and not the paper's.", -1),
)  # fmt: skip


@dataclass(frozen=True)
class Curve:
    """A rule seen from one base: the values of the parameter, ascending, and each metric on them."""

    values: NDArray[np.float64]
    metrics: dict[str, NDArray[np.float64]]

    def trend(self, metric: str) -> float:
        """Rank correlation of a metric with the parameter."""
        return float(spearmanr(self.values, self.metrics[metric]).statistic)


def main() -> None:
    for rule in RULES:
        curves = {title: sweep(rule, geometry.prototype(base)) for title, base in BASES.items()}
        draw(rule, curves, FOLDER / f"{rule.name}.png")
        lines = [f"*{rule.claim}*", "", *verdict(rule, curves), "", *table(rule, curves), "", at_navier_stokes(rule)]
        print("\n".join(lines), end="\n\n")
        begin, end = BEGIN.format(name=rule.name), END.format(name=rule.name)
        replace_section(FOLDER / "README.md", begin, end, lines)


def sweep(rule: Rule, base: ArrayDesign) -> Curve:
    """The study of a rule from one base."""
    text = (FOLDER / f"{rule.name}.toml").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "results.zarr"
        summary = run_sweep(read_study(text, f"{rule.name}.toml", base=base), out, workers=1).summary
        if summary.failures:
            raise RuntimeError(f"{rule.name}: {summary.failures}")
        found = open_sweep(out)
        values = np.asarray(found.values[rule.parameter], np.float64)
        order = np.argsort(values)
        return Curve(values[order], {name: found.values[name][order] for name in found.metrics})


def table(rule: Rule, curves: dict[str, Curve]) -> list[str]:
    """Lowest, middle and highest value of each base."""
    lines = [
        f"| design | {rule.axis} | " + " | ".join(heading for _, heading, _ in COLUMNS) + " |",
        "|---" * (2 + len(COLUMNS)) + "|",
    ]
    for title, curve in curves.items():
        for k in (0, len(curve.values) // 2, len(curve.values) - 1):
            numbers = [
                format((100 if "%" in heading else 1) * curve.metrics[name][k], digits)
                for name, heading, digits in COLUMNS
            ]
            lines.append(f"| {title} | {curve.values[k]:.3g} | " + " | ".join(numbers) + " |")
    return lines


def verdict(rule: Rule, curves: dict[str, Curve]) -> list[str]:
    """Table of distances and accuracies, each with its verdict on the claim, from the rank correlations alone."""
    lines = ["| measure | verdict |", "|---|---|"]
    for metric, called in (
        ("distance_smallest_low", "distance, 1 to 20 Hz"),
        ("distance_smallest", "distance, 1 to 100 Hz"),
        ("predicted_top1", "accuracy in quiet"),
        ("predicted_top1_white_noise", "accuracy in noise"),
    ):
        trends = {title: rule.grows * curve.trend(metric) for title, curve in curves.items()}
        if all(value > TREND for value in trends.values()):
            found = "confirmed"
        elif all(value < -TREND for value in trends.values()):
            found = "**the opposite**"
        else:
            each = ", ".join(f"{title} {rule.grows * value:+.2f}" for title, value in trends.items())
            found = f"no common trend ({each})"
        lines.append(f"| {called} | {found} |")
    return lines


def at_navier_stokes(rule: Rule) -> str:
    """Both ends of the range from the 2 x 6 array, solved in three dimensions."""
    text = (FOLDER / f"{rule.name}.toml").read_text(encoding="utf-8")
    study = read_study(text, f"{rule.name}.toml")
    values = sweep(rule, study.base).values
    names = ("distance_smallest_low", "distance_smallest")
    worst, ends = 0.0, []
    for value in (values[0], values[-1]):
        design = study.base.with_values({rule.parameter: int(value) if rule.name == "points" else float(value)})
        lumped, solved = (
            [METRICS[name].of_library(acoustic_fem.solve(design, study.frequency, fidelity)) for name in names]
            for fidelity in ("lumped", "navier-stokes")
        )
        worst = max(worst, *(abs(a / b - 1) for a, b in zip(lumped, solved, strict=True)))
        ends.append(solved[0])
    return (
        f"Solved in 3-D (`navier-stokes`), the distance of 2 x 6 from 1 to 20 Hz goes from {ends[0]:.3f} to "
        f"{ends[1]:.3f}. Closed forms (`lumped`) differ by at most {100 * worst:.1f} %."
    )


def draw(rule: Rule, curves: dict[str, Curve], path: Path) -> None:
    """Distances, accuracies and sensitivity over the parameter."""
    figure = Figure(figsize=(9.6, 3.0), layout="constrained")
    distance, accuracy, sensitivity = figure.subplots(1, 3)
    for title, curve in curves.items():
        colour = COLOURS[title]
        for axes, metric, style, scale in (
            (distance, "distance_smallest_low", "-", 1),
            (distance, "distance_smallest", "--", 1),
            (accuracy, "predicted_top1", "-", 100),
            (accuracy, "predicted_top1_white_noise", "--", 100),
            (sensitivity, "sensitivity_force", "-", 1),
        ):
            axes.plot(curve.values, scale * curve.metrics[metric], style, color=colour, marker="o", markersize=3)
        sensitivity.plot([], [], color=colour, label=title)
    for axes, full, dashed in ((distance, "1 to 20 Hz", "1 to 100 Hz"), (accuracy, "quiet", "0.05 Pa")):
        axes.plot([], [], "-", color="black", label=full)
        axes.plot([], [], "--", color="black", label=dashed)
    for axes, title in (
        (distance, "smallest distance of two points"),
        (accuracy, "predicted top-1 (%)"),
        (sensitivity, "sensitivity (Pa/N)"),
    ):
        axes.set_title(title, fontsize=10)
        axes.set_xlabel(rule.axis)
        axes.grid(color="#dddddd", linewidth=0.6)
        axes.legend(frameon=False, fontsize=8)
    distance.set_yscale("log")
    sensitivity.set_yscale("log")
    accuracy.set_ylim(0, 102)
    with whole_file(path) as beside:
        figure.savefig(beside, dpi=110)


if __name__ == "__main__":
    main()
