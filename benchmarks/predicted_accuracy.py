"""Predicted top-1 accuracy against that of trained networks and of the Bayes decoder, on designs and noises.

``python benchmarks/predicted_accuracy.py`` trains the networks that docs/predicted_accuracy.json lacks (about a
quarter of a minute of one core per 12 points), repeats the predictions, and writes the table of
docs/evidence/designs.md.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section
from studies.metrics.confusion import Listener, predict_confusion

DOCS = Path(__file__).parents[1] / "docs"
RESULTS = DOCS / "predicted_accuracy.json"
PAGE = DOCS / "evidence" / "designs.md"
BEGIN, END = "<!-- predicted accuracy: made by benchmarks/predicted_accuracy.py -->", "<!-- end -->"

#: What it is called, the prototype, what is changed in it, and the microphone noise, Pa rms over 0 to 500 Hz.
CASES: list[tuple[str, str, dict[str, Any], float]] = [
    ("2 x 6", "array-2x6", {}, 0.01),
    ("2 x 6", "array-2x6", {}, 0.1),
    ("2 x 6", "array-2x6", {}, 0.3),
    (
        "2 x 6, bores 0.6 mm",
        "array-2x6",
        {
            "tube.inner_diameter": 0.6,
            "tube.outer_diameter": 1.1,
            "microphone_tube.inner_diameter": 0.6,
            "microphone_tube.outer_diameter": 1.1,
        },
        0.3,
    ),
    ("2 x 6, cavities 6 mm high", "array-2x6", {"resonator.cavity_height": 6.0}, 0.1),
    ("2 x 6, membranes 2 mm thick", "array-2x6", {"membrane.thickness": 2.0}, 0.1),
    ("6 points", "array-2x6", {"lines.0.points": 6}, 0.3),
    ("24 points", "array-2x6", {"lines.0.points": 24}, 0.01),
    ("24 points", "array-2x6", {"lines.0.points": 24}, 0.03),
    ("fingertip 3 x 4", "fingertip-3x4", {}, 0.03),
    ("fingertip 4 x 6", "fingertip-4x6", {}, 0.03),
    (
        "triangle of three lines of 5",
        "glove",
        {
            "lines": [{"between": list(pair), "points": 5} for pair in ("AB", "AC", "BC")],
            "layout": {"kind": "ring"},
            "microphone.chamber_diameter": 1.8,
        },
        0.3,
    ),
    ("line of 36", "line-2", {}, 0.003),
    ("line of 36", "line-2", {}, 0.01),
]
GRID = np.linspace(1.0, 100.0, 64)
SHARES = ("predicted_network", "trained", "predicted_model", "bayes")
#: One-second touches per point in training, and touches per point in the evaluation.
SECONDS_PER_POINT, EPOCHS, EVALUATED = 150, 16, 200


def measure(title: str, prototype: str, values: dict[str, Any], noise: float) -> dict[str, Any]:
    """Train, and evaluate on touches that were never seen."""
    library = solved(prototype, values)
    plan = replace(
        localize.TrainingPlan.on_maps(), seconds_per_point=SECONDS_PER_POINT, epochs=EPOCHS, microphone_noise=noise
    )
    network, decoder = localize.train(library, plan), localize.BayesDecoder(library, noise)
    trained, bayes = (localize.evaluate(who, library, EVALUATED, noise).top1 for who in (network, decoder))
    return {
        "title": title,
        "prototype": prototype,
        "values": values,
        "noise": noise,
        "points": library.design.point_count,
        "microphones": len(library.design.microphones),
        "trained": trained,
        "bayes": bayes,
    }


def solved(prototype: str, values: dict[str, Any]) -> acoustic_fem.Library:
    """With membranes of constant loss, of which the stored networks were trained."""
    design = geometry.prototype(prototype).with_values(values).completed()
    constant = design.with_values({f"materials.{design.membrane.material}.law": "constant"})
    return acoustic_fem.solve(constant, GRID, "lumped")


def predicted(row: dict[str, Any], listener: Listener, touches: int = 200) -> float:
    h = solved(row["prototype"], row["values"]).transfer_function.values[None]
    return float(predict_confusion(h, GRID, row["noise"], listener=listener, touches=touches).top1[0])


def agreement(first: np.ndarray, second: np.ndarray) -> str:
    difference = 100 * (first - second)
    return (
        f"correlation {np.corrcoef(first, second)[0, 1]:.3f}, mean error {difference.mean():+.1f}, rms "
        f"{np.sqrt((difference**2).mean()):.1f}, largest {np.abs(difference).max():.1f} percentage points"
    )


def table(rows: list[dict[str, Any]]) -> str:
    lines = [
        "| design (points, microphones) | noise (Pa) | predicted, `network` (%) | trained network (%) "
        "| predicted, `model` (%) | Bayes decoder (%) |",
        "|---|---|---|---|---|---|",
    ]
    for row in rows:
        shares = " | ".join(f"{100 * row[name]:.1f}" for name in SHARES)
        lines.append(f"| {row['title']} ({row['points']}, {row['microphones']}) | {row['noise']:g} | {shares} |")
    at = {name: np.array([row[name] for row in rows]) for name in SHARES}
    lines += [
        "",
        f"Predicted against trained network: {agreement(at['predicted_network'], at['trained'])}.",
        f"Predicted against Bayes decoder: {agreement(at['predicted_model'], at['bayes'])}.",
    ]
    return "\n".join(lines)


def main() -> None:
    rows: list[dict[str, Any]] = json.loads(RESULTS.read_text()) if RESULTS.exists() else []
    keys = ("title", "prototype", "values", "noise")
    for case in CASES:
        if not any([row[name] for name in keys] == list(case) for row in rows):
            rows.append(measure(*case))
            print(f"{case[0]}, {case[3]:g} Pa: network {rows[-1]['trained']:.3f}, decoder {rows[-1]['bayes']:.3f}")
            sys.stdout.flush()
            RESULTS.write_text(json.dumps(rows, indent=1) + "\n")
    for row in rows:
        row["predicted_network"], row["predicted_model"] = predicted(row, "network"), predicted(row, "model")
    RESULTS.write_text(json.dumps(rows, indent=1) + "\n")
    print(table(rows))
    replace_section(PAGE, BEGIN, END, table(rows).splitlines())


if __name__ == "__main__":
    main()
