"""Accuracy on as-built sensors: of trained networks, and of designs that tolerate manufacturing scatter.

One network is trained on the nominal design and one on a library of as-built sensors, and both are evaluated on sensors
that neither has seen. The accuracy of further designs is predicted.

``python benchmarks/as_built.py`` writes both tables of docs/evidence/designs.md, in two minutes of one core for each
network. ``python benchmarks/as_built.py forgiving`` writes only the second table, in two minutes.
"""

from __future__ import annotations

import sys
import tempfile
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import response_of
from studies.metrics.confusion import predict_confusion
from studies.scatter.effects import scattered_accuracy
from studies.scatter.perturbed_library import write_perturbed_library
from studies.study.metric_registry import METRICS

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "designs.md"
BEGIN, END = "<!-- as-built: made by benchmarks/as_built.py -->", "<!-- end -->"
FORGIVING, FORGIVING_END = "<!-- forgiving: made by benchmarks/as_built.py -->", "<!-- end forgiving -->"
GRID = np.linspace(1.0, 100.0, 64)
DESIGNS, NOISE = ("array-2x6", "fingertip-3x4"), 3e-3
STORED, UNSEEN, TOUCHES = 1000, 40, 20
#: As-built sensors per design of the second table, and the seed of their deviations: not that of `scattered_top1`.
SENSORS, SEED = 256, 1
PLAN = replace(localize.TrainingPlan.on_maps(), seconds_per_point=150, epochs=32, microphone_noise=NOISE)


def row(name: str) -> str:
    design = geometry.prototype(name)
    library = acoustic_fem.solve(design, GRID, "lumped")
    response = response_of(library)
    with tempfile.TemporaryDirectory() as folder:
        store = write_perturbed_library(Path(folder) / "seen.zarr", design, STORED, GRID)
        unseen = write_perturbed_library(Path(folder) / "unseen.zarr", design, UNSEEN, GRID, seed=1).sensors(0, UNSEEN)
        seen = store.sensors(0, 32)
        networks = localize.train(library, PLAN), localize.train(library, PLAN, source=store)
    nominal = library.transfer_function.values[None]
    predicted = [
        predict_confusion(unseen, GRID, NOISE, assumed=assumed).top1.mean() for assumed in (nominal, seen)
    ]  # fmt: skip
    trained = [
        np.mean([
            localize.evaluate(network, replace(response, transfer_function=h), TOUCHES, NOISE).top1 for h in unseen
        ])
        for network in networks
    ]  # fmt: skip
    fractions = (predicted[0], trained[0], predicted[1], trained[1])
    return f"| {name} | " + " | ".join(f"{100 * fraction:.1f}" for fraction in fractions) + " |"


def bores(diameter: float) -> dict[str, float]:
    tubes = ("tube", "microphone_tube")
    return {
        f"{tube}.{field}": value
        for tube in tubes
        for field, value in (("inner_diameter", diameter), ("outer_diameter", diameter + 0.5))
    }


def between(*pairs: tuple[str, str], points: int) -> list[dict[str, Any]]:
    return [{"between": list(pair), "points": points} for pair in pairs]


VARIANTS: list[tuple[str, str, dict[str, Any]]] = [
    ("array-2x6", "array-2x6", {}),
    ("bores of 0.6 mm", "array-2x6", bores(0.6)),
    ("bores of 0.3 mm", "array-2x6", bores(0.3)),
    ("membranes 1 mm thick", "array-2x6", {"membrane.thickness": 1.0}),
    ("membranes 2 mm thick", "array-2x6", {"membrane.thickness": 2.0}),
    ("membranes 2 mm thick, bores of 0.3 mm", "array-2x6", {"membrane.thickness": 2.0, **bores(0.3)}),
    ("24 points on the line", "array-2x6", {"lines.0.points": 24}),
    ("glove", "glove", {}),
    ("fingertip-3x4", "fingertip-3x4", {}),
    ("36 points: one line (line-2)", "line-2", {}),
    ("36 points: a microphone in mid-line", "line-3", {"lines": between(("A", "B"), ("B", "C"), points=18)}),
    ("36 points: three lines of 12", "line-3", {"lines": between(("A", "B"), ("A", "C"), ("B", "C"), points=12)}),
    ("36 points: six lines of 6", "line-4", {"lines": between(*combinations("ABCD", 2), points=6)}),
    ("36 points: bores of 0.44 mm", "line-2", bores(0.44)),
    ("36 points: bores of 0.9 mm", "line-2", bores(0.9)),
    ("36 points: membranes 2 mm thick", "line-2", {"membrane.thickness": 2.0}),
    ("36 points: bores of 0.9 mm, membranes 2 mm thick", "line-2", {"membrane.thickness": 2.0, **bores(0.9)}),
]


def forgiving() -> list[str]:
    lines = ["| design | as designed (%) | as-built (%) | sensitivity (Pa/N) |", "|---|---|---|---|"]
    for title, prototype, values in VARIANTS:
        design = geometry.prototype(prototype).with_values(values)
        library = acoustic_fem.solve(design, GRID, "lumped")
        own, sensitivity = (METRICS[name].of_library(library) for name in ("predicted_top1", "sensitivity_force"))
        each = 100 * scattered_accuracy(design, GRID, sensors=SENSORS, seed=SEED)
        error = each.std(ddof=1) / np.sqrt(SENSORS)
        lines.append(f"| {title} | {100 * own:.1f} | {each.mean():.1f} ± {error:.1f} | {sensitivity:.3g} |")
    return lines


def put(lines: list[str], begin: str, end: str) -> None:
    print("\n".join(lines))
    replace_section(PAGE, begin, end, lines)


def main() -> None:
    put(forgiving(), FORGIVING, FORGIVING_END)
    if "forgiving" in sys.argv[1:]:
        return
    lines = [
        "| design | nominal: predicted (%) | nominal: trained (%) | as-built: predicted (%) | as-built: trained (%) |",
        "|---|---|---|---|---|",
        *(row(name) for name in DESIGNS),
    ]
    put(lines, BEGIN, END)


if __name__ == "__main__":
    main()
