"""Networks trained on the nominal design and on a library of mis-made sensors, both judged on sensors never seen.

``python benchmarks/mis_made.py`` writes the table of docs/tolerances.md anew; a minute of one core per design.
"""

from __future__ import annotations

import tempfile
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
import localize
from localize.dataset import response_of
from studies.confusion import predict_confusion
from studies.perturbed_library import write_perturbed_library

PAGE = Path(__file__).parents[1] / "docs" / "tolerances.md"
BEGIN, END = "<!-- mis-made: made by benchmarks/mis_made.py -->", "<!-- end -->"
GRID = np.linspace(1.0, 100.0, 64)
DESIGNS, NOISE = ("array-2x6", "fingertip-3x4"), 3e-3
STORED, JUDGED, TOUCHES = 1000, 40, 20
PLAN = localize.TrainingPlan(seconds_per_point=150, epochs=16, microphone_noise=NOISE)


def row(name: str) -> str:
    design = geometry.prototype(name)
    library = acoustic_fem.solve(design, GRID, "lumped")
    response = response_of(library)
    with tempfile.TemporaryDirectory() as folder:
        store = write_perturbed_library(Path(folder) / "seen.zarr", design, STORED, GRID)
        unseen = write_perturbed_library(Path(folder) / "unseen.zarr", design, JUDGED, GRID, seed=1).sensors(0, JUDGED)
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
    shares = (predicted[0], trained[0], predicted[1], trained[1])
    return f"| {name} | " + " | ".join(f"{100 * share:.1f}" for share in shares) + " |"


def main() -> None:
    warnings.simplefilter("ignore")
    lines = [
        "| design | nominal: predicted (%) | nominal: trained (%) | mis-made: predicted (%) | mis-made: trained (%) |",
        "|---|---|---|---|---|",
        *(row(name) for name in DESIGNS),
    ]
    print("\n".join(lines))
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    PAGE.write_text("\n".join([before + BEGIN, *lines, END + rest.split(END, 1)[1]]), encoding="utf-8")


if __name__ == "__main__":
    main()
