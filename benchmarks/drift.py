"""Accuracy on a calibrated sensor that drifts: with the library as it was, and with the drift followed.

``python benchmarks/drift.py --write`` writes a table of docs/evidence/calibration.md; ``--sensors 3`` is a quick
trial. Sensors are virtual rigs at ``navier-stokes`` fidelity, with all their hidden deviations. Seeds begin at
``FIRST``, and no constant was chosen on them. The calibrated library is that of the sensor before the drift, with the
error of a calibration (:func:`acoustic_fem.calibration.model_discrepancy.draw`).
"""

from __future__ import annotations

import argparse
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
from natural_touches import KINDS, NOISE, touched

import acoustic_fem
import geometry
import localize
from acoustic_fem.calibration.model_discrepancy import draw
from acoustic_fem.library.transfer_functions import measured_library
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import response_of
from studies.test_rig.virtual_rig import HiddenScatter, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "calibration.md"
BEGIN, END = "<!-- drift: made by benchmarks/drift.py -->", "<!-- end of drift -->"
FIRST, SENSORS, TOUCHES = 9400, 20, 200
SETTLED = 9
"""Touches before those that are counted."""
GRID = np.geomspace(1.0, 150.0, 48)
DESIGNS = ("array-2x6", "line-2")
DRIFTS = {
    "none": HiddenScatter(),
    "modulus -20 %": HiddenScatter(modulus=0.8),
    "modulus +15 %": HiddenScatter(modulus=1.15),
    "2000 m altitude": HiddenScatter(altitude=2000.0),
}


def transfer_function(name: str, seed: int, drift: str) -> np.ndarray:
    """Transfer functions of a sensor that has drifted, (n_point, n_microphone, n_freq)."""
    return Rig(geometry.prototype(name), seed, DRIFTS[drift], "navier-stokes").transfer_function(GRID)


def rows_of(name: str, sensors: int) -> list[str]:
    """Rows of the table of one design."""
    nominal = acoustic_fem.solve(geometry.prototype(name), GRID, "lumped")
    plain = response_of(nominal)
    shares: dict[tuple[str, str], list[tuple[float, ...]]] = {}
    for seed in range(FIRST, FIRST + sensors):
        exact = transfer_function(name, seed, "none")
        known = exact * (1 + draw(np.random.default_rng(seed), GRID, (1, *exact.shape[:2]))[0])
        library = measured_library(nominal.design, nominal, known, 0.01 * np.abs(known), ("numpy",), {})
        fixed, following = localize.BayesDecoder(library, NOISE), localize.DriftDecoder(library, NOISE)
        for drift in DRIFTS:
            truth = replace(plain, transfer_function=transfer_function(name, seed, drift))
            exact_decoder = localize.BayesDecoder(truth, NOISE)
            for kind in KINDS:
                frames, points = touched(truth, kind, TOUCHES, seed)
                followed, _ = following.follow(frames, following.start)
                named = [fixed.locate(frames), followed, exact_decoder.locate(frames)]
                right = [100 * float((each.argmax(1) == points)[SETTLED:].mean()) for each in named]
                shares.setdefault((drift, kind), []).append(tuple(right))
    rows = []
    for drift in DRIFTS:
        table = np.array([shares[drift, kind] for kind in KINDS])
        means, worst = (
            ["/".join(f"{share:.1f}" for share in each) for each in pick(1).T] for pick in (table.mean, table.min)
        )
        cells = (f"{mean} ({least})" for mean, least in zip(means, worst, strict=True))
        rows.append(f"| {name} | {drift} | {' | '.join(cells)} |")
        print(rows[-1], flush=True)
    return rows


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--designs", nargs="+", default=list(DESIGNS), choices=list(DESIGNS))
    parser.add_argument("--write", action="store_true", help="into docs/evidence/calibration.md")
    chosen = parser.parse_args()
    lines = [
        "| design | drift | not followed | followed | known exactly |",
        "|---|---|---|---|---|",
    ]
    print("\n".join(lines))
    for name in chosen.designs:
        lines += rows_of(name, chosen.sensors)
    if chosen.write:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
