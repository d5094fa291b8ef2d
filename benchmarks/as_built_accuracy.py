"""Predicted accuracy of as-built sensors against sensors that are touched and decoded in full, on random designs.

``python -m benchmarks.as_built_accuracy`` repeats the predictions and their times, and writes the tables of
docs/evidence/designs.md from docs/evidence/as_built_accuracy.csv. ``--decode FIRST COUNT`` adds designs to that file,
half a minute of one core each.

A design is drawn from the prototypes and examples: bores, lengths, heights and thicknesses within a factor of two, and
6 to 36 points on a line. Twenty as-built sensors and twenty virtual rigs of each are touched at all points by taps and
presses of a run, by multi-sines, and by taps and presses of 0.1 N, and decoded by :class:`localize.TolerantDecoder`.
Designs 1000 to 1039 set the numbers of the model and the widths of the intervals. The file has those from 1040 on, on
which nothing was chosen.
"""

from __future__ import annotations

import argparse
import csv
import warnings
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from time import process_time

import numpy as np
from scipy.interpolate import CubicSpline

import acoustic_fem
import geometry
import localize
from acoustic_fem.numerics.frequency_splines import interpolated
from geometry.ground.typed import ComplexArray
from geometry.ground.whole_files import replace_section
from localize.evaluation.held_out import MULTI_SINES, PRESSES, TAPS, HeldOutTouches, TouchedSensors, TouchKinds, decide
from localize.signals import stimulus
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.finger_strokes import press_strokes, tap_strokes
from localize.signals.locator import Locator
from studies.evaluation.evaluated_sensors import SENSORS, rig_sensors, scattered_sensors
from studies.metrics import AsBuiltAccuracy, as_built_accuracy

ROOT = Path(__file__).parents[1]
PAGE, ROWS = ROOT / "docs" / "evidence" / "designs.md", ROOT / "docs" / "evidence" / "as_built_accuracy.csv"
BEGIN, END = "<!-- as-built accuracy: made by benchmarks/as_built_accuracy.py -->", "<!-- end as-built accuracy -->"
SEED = 4711
BASES = (
    "array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "line-2", "fingertip-12.toml", "glove-15.toml",
    "graded-line-36.toml", "pad-24.toml", "ring-3x12.toml", "wristband-16.toml",
)  # fmt: skip
FORCE, CALIBRATED = 0.1, 4
KINDS: Mapping[str, TouchKinds] = {"taps": TAPS, "presses": PRESSES, "multi_sines": MULTI_SINES}
BY_FORCE: Mapping[str, TouchKinds] = {
    "taps_of_force": TouchKinds("taps", (partial(tap_strokes, peak=(FORCE, FORCE)),), TAPS.high_pass),
    "presses_of_force": TouchKinds("presses", (partial(press_strokes, peak=(FORCE, FORCE)),), PRESSES.high_pass),
}
FIGURES = (
    *(f"built_{kind}" for kind in (*KINDS, *BY_FORCE)),
    *(f"rigs_{kind}" for kind in KINDS),
    *(f"calibrated_{kind}" for kind in KINDS),
)
TITLES = {
    "built_taps": "taps, as-built sensors", "built_presses": "presses, as-built sensors",
    "built_multi_sines": "multi-sines, as-built sensors", "built_taps_of_force": "taps of 0.1 N, as-built sensors",
    "built_presses_of_force": "presses of 0.1 N, as-built sensors", "rigs_taps": "taps, virtual rigs",
    "rigs_presses": "presses, virtual rigs", "rigs_multi_sines": "multi-sines, virtual rigs",
    "calibrated_taps": "taps, calibrated", "calibrated_presses": "presses, calibrated",
    "calibrated_multi_sines": "multi-sines, calibrated",
}  # fmt: skip


def random_design(number: int) -> tuple[str, geometry.ArrayDesign]:
    """A design of a number, and the name of what it was drawn from."""
    random = np.random.default_rng((SEED, number))

    def factor(low: float, high: float) -> float:
        return float(np.exp(random.uniform(np.log(low), np.log(high))))

    while True:
        name = BASES[int(random.integers(len(BASES)))]
        file = ROOT / "docs" / "examples" / name
        base = geometry.load_design(file) if name.endswith(".toml") else geometry.prototype(name)
        flat, bore = base.model_dump(), factor(0.6, 1.6)
        values: dict[str, object] = {}
        for tube in ("tube", "microphone_tube"):
            inner = flat[tube]["inner_diameter"] * bore
            values[f"{tube}.inner_diameter"] = inner
            values[f"{tube}.outer_diameter"] = flat[tube]["outer_diameter"] + inner - flat[tube]["inner_diameter"]
        values["tube.length"] = flat["tube"]["length"] * factor(0.7, 2.0)
        values["resonator.cavity_height"] = flat["resonator"]["cavity_height"] * factor(0.6, 1.8)
        values["membrane.thickness"] = flat["membrane"]["thickness"] * factor(0.7, 1.8)
        if len(flat["lines"]) == 1 and random.random() < 0.7:
            values["lines.0.points"] = int(random.integers(6, 37))
        try:
            return name, base.with_values(values)
        except geometry.ground.refusal.Refusal:
            continue


def touched(response: ArrayResponse, sensors: ComplexArray, kind: str, each: int, seed: int) -> HeldOutTouches:
    """Touches of all points of some sensors."""
    made = TouchedSensors(response, "design", seed, sensors=sensors)
    if kind in BY_FORCE:  # strokes are forces in N, not displacements of a given pressure
        for generator in made._generators:
            lines = np.clip(stimulus.line_frequencies()[: generator._stop], None, response.frequency[-1])
            assert response.cavity_response is not None
            cavity = interpolated(response.cavity_response, response.frequency, lines)
            generator._membrane_on_lines = generator._on_lines_of(cavity)
    return made.touches({**KINDS, **BY_FORCE}[kind], each)


def top1(decoder: Locator, response: ArrayResponse, sensors: ComplexArray, kind: str, each: int, seed: int) -> float:
    """Fraction of touches that a decoder assigns correctly, %."""
    return 100 * decide(decoder, touched(response, sensors, kind, each, seed)).evaluation().top1


def decoded(number: int) -> dict[str, object]:
    """Row of the file: a design decoded in full."""
    base, design = random_design(number)
    library = acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")
    response, seed = response_of(library), 9000 + number
    built = scattered_sensors(library, response, 50000 + number, SENSORS, (1.0,))[0][0][-1]
    rigs = rig_sensors(library, response, 60000 + 100 * number, SENSORS)[0][-1]
    decoder, each = localize.TolerantDecoder(library), max(2, round(60 / design.point_count))
    row: dict[str, object] = {"number": number, "base": base, "points": design.point_count}
    row |= {f"built_{kind}": top1(decoder, response, built, kind, each, seed) for kind in (*KINDS, *BY_FORCE)}
    row |= {f"rigs_{kind}": top1(decoder, response, rigs, kind, each, seed) for kind in KINDS}
    nodes = np.geomspace(1, 500, 8)
    random = np.random.default_rng(77000 + number)
    right: dict[str, list[float]] = {kind: [] for kind in KINDS}
    for sensor in built[:CALIBRATED]:
        error = 0.01 * random.standard_normal((2, *sensor.shape[:2], 8)) / np.sqrt(2)
        wrong = CubicSpline(np.log(nodes), error[0] + 1j * error[1], axis=-1)(np.log(response.frequency))
        own = localize.BayesDecoder(replace(response, transfer_function=sensor * np.exp(wrong)))
        for kind, found in right.items():
            found.append(top1(own, response, sensor[None], kind, 2 * each, seed))
    return row | {f"calibrated_{kind}": float(np.mean(found)) for kind, found in right.items()}


def predicted(number: int) -> dict[str, tuple[float, float, float]]:
    """Prediction and the ends of its interval of each figure, %."""
    _, design = random_design(number)
    of_run, of_force = (as_built_accuracy(design, force=force) for force in (None, FORCE))
    sets: dict[str, tuple[AsBuiltAccuracy, str]] = {f"built_{kind}": (of_run, kind) for kind in KINDS}
    sets |= {f"built_{kind}_of_force": (of_force, kind) for kind in ("taps", "presses")}
    calibrated = as_built_accuracy(design, force=None, calibrated=True)
    sets |= {f"rigs_{kind}": (of_run, kind) for kind in KINDS}
    sets |= {f"calibrated_{kind}": (calibrated, kind) for kind in KINDS}
    figures = {name: getattr(found, kind) for name, (found, kind) in sets.items()}
    return {name: (100 * each.mean, 100 * each.low, 100 * each.high) for name, each in figures.items()}


def table(rows: list[dict[str, str]]) -> list[str]:
    """Lines of the table of predictions against full decoding."""
    found = [predicted(int(row["number"])) for row in rows]
    lines = [
        f"Predicted top-1 accuracy of {len(rows)} random designs against {SENSORS} sensors of each, decoded in full.",
        "",
        "| touches, sensors | decoded (%) | mean error (points) | rms error (points) | within 3 points (%) "
        "| inside the interval (%) | mean width of the interval (points) |",
        "|---|---|---|---|---|---|---|",
    ]
    for name in FIGURES:
        true = np.array([float(row[name]) for row in rows])
        mean, low, high = np.array([each[name] for each in found]).T
        error = mean - true
        inside = (true >= low - 1e-9) & (true <= high + 1e-9)
        lines.append(
            f"| {TITLES[name]} | {true.mean():.1f} | {error.mean():+.1f} | {np.sqrt((error**2).mean()):.1f} "
            f"| {100 * (np.abs(error) <= 3).mean():.0f} | {100 * inside.mean():.0f} | {(high - low).mean():.1f} |"
        )
    return lines


def times() -> list[str]:
    """Lines of the table of processor times."""
    lines = ["| points of `array-2x6` | processor time of a prediction (ms) |", "|---|---|"]
    for points in (12, 24, 36):
        design = geometry.prototype("array-2x6").with_values({"lines.0.points": points})
        as_built_accuracy(design)
        spent = []
        for seed in range(5):
            start = process_time()
            as_built_accuracy(design, seed=seed)
            spent.append(process_time() - start)
        lines.append(f"| {points} | {1e3 * min(spent):.0f} |")
    return lines


def main() -> None:
    """Print and write the tables, or decode more designs."""
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--decode", nargs=2, type=int, metavar=("FIRST", "COUNT"))
    chosen = parser.parse_args()
    if chosen.decode:
        first, count = chosen.decode
        with ROWS.open("a", newline="") as file:
            writer = csv.DictWriter(file, ["number", "base", "points", *FIGURES], lineterminator="\n")
            if not file.tell():
                writer.writeheader()
            for number in range(first, first + count):
                row = decoded(number)
                writer.writerow(
                    {key: f"{value:.2f}" if isinstance(value, float) else value for key, value in row.items()}
                )
                file.flush()
        return
    with ROWS.open(newline="") as file:
        rows = list(csv.DictReader(file))
    lines = [*table(rows), "", *times()]
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
