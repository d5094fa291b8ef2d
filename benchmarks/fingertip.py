"""The example of docs/optimize.md against its base.

``python benchmarks/fingertip.py`` writes the table, in a quarter of a minute.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
from geometry.ground.whole_files import replace_section
from studies.scatter.effects import scatter_effects
from studies.study.metric_registry import METRICS

DOCS = Path(__file__).parents[1] / "docs"
BEGIN, END = "<!-- fingertip: made by benchmarks/fingertip.py -->", "<!-- end fingertip -->"
GRID = np.linspace(1.0, 100.0, 64)
SENSORS, SEED = 256, 1
#: Name, heading, factor to its unit.
FIGURES = (
    ("distance_smallest", "smallest distance of two points (the objective)", 1.0),
    ("distance_mean", "mean distance", 1.0),
    ("ild_smallest", "smallest level difference, dB", 1.0),
    ("ipd_smallest", "smallest phase difference, degrees", 1.0),
    ("predicted_top1", "predicted top-1, the microphone's own noise, %", 100.0),
    ("predicted_top1_white_noise", "predicted top-1, 0.05 Pa of white noise, %", 100.0),
    ("sensitivity_force", "sensitivity, kPa/N", 1e-3),
    ("noise_equivalent_force", "noise-equivalent force, nN", 1e9),
    ("volume", "volume of all parts, mm³", 1.0),
)
SCATTERED = (
    ("calibrated", "as-built, each sensor calibrated, %"),
    ("nominal", "as-built, one localizer of the nominal design, %"),
)


def main() -> None:
    base, found = geometry.prototype("fingertip-3x4"), geometry.load_design(DOCS / "examples" / "fingertip-12.toml")
    lines = [f"| | `{base.name}` | `{found.name}` | |", "|---|---|---|---|"]
    libraries = [acoustic_fem.solve(design, GRID, "lumped") for design in (base, found)]
    for name, title, factor in FIGURES:
        old, new = (factor * METRICS[name].of_library(library) for library in libraries)
        better = (new > old) == (METRICS[name].better == "larger")
        lines.append(f"| {title} | {old:.3g} | {new:.3g} | {'better' if better else 'worse'} |")
    scattered = [
        scatter_effects(design, GRID, samples=SENSORS, base_samples=0, seed=SEED).accuracy for design in (base, found)
    ]
    for name, title in SCATTERED:
        old, new = (100 * accuracy[name] for accuracy in scattered)
        change = new - old  # the same deviations of both
        verdict = "better" if change.mean() > 0 else "worse"
        if abs(change.mean()) < 2 * error(change):
            verdict = "no difference"
        lines.append(f"| {title} | {spread(old)} | {spread(new)} | {verdict} ({spread(change, '+.1f')}) |")
    print("\n".join(lines))
    page = DOCS / "evidence" / "designs.md"
    replace_section(page, BEGIN, END, lines)


def error(values: np.ndarray) -> float:
    return float(values.std(ddof=1) / np.sqrt(len(values)))


def spread(values: np.ndarray, form: str = ".1f") -> str:
    return f"{values.mean():{form}} ± {error(values):.1f}"


if __name__ == "__main__":
    main()
