"""A virtual rig calibrated from its recordings: coverage of the stated bands, and gain in accuracy.

``python benchmarks/calibration.py`` writes the table of docs/evidence/calibration.md and prints the other
figures. ``python benchmarks/calibration.py 3 2x6`` does three rigs of one kind. Every sensor is recorded to WAV files,
read back from them, and fitted as ``calibrate`` does, with the tolerances of the rig.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections import defaultdict
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
import localize
from acoustic_fem.calibration.fitted_model import UpdatedModel
from acoustic_fem.calibration.manifest import read_manifest
from acoustic_fem.calibration.measured_library import calibrate
from acoustic_fem.calibration.model_updating import Update, update
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import replace_section
from localize.recalibration.accuracy_to_expect import AccuracyOptions, expected_accuracy, is_enough
from localize.signals.array_response import response_of
from studies.test_rig.priors import fit_priors
from studies.test_rig.rig_parameters import rig_tolerances, within_95
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "calibration.md"
BEGIN, END = "<!-- rigs: made by benchmarks/calibration.py -->", "<!-- end -->"
GRID = np.linspace(1.0, 100.0, 48)
RIGS, TOUCHES, NOISE = 20, 20, 1e-3


def long_line(bore: float) -> ArrayDesign:
    """36 points between two microphones, as the prototype line-2 but for its bores, mm."""
    values = {"lines.0.points": 36, "layout.columns": 18, "membrane.thickness": 1.0, "resonator.cavity_diameter": 8.0,
              "resonator.cavity_height": 3.0}  # fmt: skip
    for tube in ("tube", "microphone_tube"):
        values |= {f"{tube}.inner_diameter": bore, f"{tube}.outer_diameter": bore + 0.5}
    return geometry.prototype("array-2x6").with_values(values)


DESIGNS = {
    "2x6": geometry.prototype("array-2x6"),
    "2x36": long_line(0.6),
    "2x36 wide": long_line(0.8),
}
#: Played more softly than usual: in wide bores pressure rises on its way, and would clip.
SOFTLY = {"2x36 wide": 0.25}
#: Measured points, by the number of points of the line.
MEASURED = {12: ((6,), (4, 9), (2, 6, 11)), 36: ((18,), (12, 25), (8, 18, 29))}
#: Of which the shares in their stated 95 % bands are counted.
STATED = {
    "bore": "bores",
    "compliance": "compliances",
    "gain": "gains",
    "high-pass": "high-passes",
    "chamber": "chambers",
}


@dataclass
class Kept:
    """How often what was stated at 95 % was so."""

    estimates: list[np.ndarray] = field(default_factory=list)
    parameters: defaultdict[str, list[bool]] = field(default_factory=lambda: defaultdict(list))
    responses: list[float] = field(default_factory=list)

    def count(self, fit: Update, rig: Rig, truth: np.ndarray) -> None:
        """Stated spread of a fit: of the parameters and of the responses of all points."""
        for part, is_inside in within_95(rig, fit):
            self.parameters[part].append(is_inside)
        inside = np.abs(fit.transfer_function - truth) < np.sqrt(-2 * np.log(0.05)) * fit.deviation
        self.responses.append(float(inside.mean()))


def row(name: str, design: ArrayDesign, modulus: float, rigs: int) -> tuple[str, str]:
    library = acoustic_fem.solve(design, GRID, "lumped")
    nominal = response_of(library)
    recorder = Recorder(level=SOFTLY.get(name, Recorder.level))
    model = UpdatedModel(library, fit_priors(design, rig_tolerances(HiddenScatter())))
    accuracies, kept, refused, excluded, unwarned, seconds = [], Kept(), 0, 0, 0, 0.0
    for seed in range(rigs):
        rig = Rig(design, seed, HiddenScatter(batch=0.0, modulus=modulus), "navier-stokes")
        truth = rig.transfer_function(GRID)
        with tempfile.TemporaryDirectory() as folder:
            manifest = rig.record(Path(folder), range(1, design.point_count + 1), recorder)
            found = calibrate(read_manifest(manifest), library)
        excluded += sum(finding.excluded for finding in found.findings)
        for number, estimate in found.estimates.items():
            kept.estimates.append(np.abs(estimate.transfer_function - truth[number - 1]) < estimate.radius_95)
        # points whose recording was left out come from a fit to the others, as the verb does
        fill = update(model, found.estimates) if found.missing else None
        full = found.library(library, fit=fill).transfer_function.values
        known, fits = [nominal.transfer_function, truth, full], []
        for points in MEASURED[design.point_count]:
            start = time.process_time()
            fit = update(model, {k: found.estimates[k] for k in points if k in found.estimates})
            seconds = max(seconds, time.process_time() - start)
            refused += fit.objection is not None
            kept.count(fit, rig, truth)
            fits.append(fit)
        touched = replace(nominal, transfer_function=truth)
        known += [fit.transfer_function for fit in fits]
        accuracies.append([accuracy(replace(nominal, transfer_function=h), touched) for h in known])
        low = [
            fit
            for fit, share in zip(fits, accuracies[-1][-len(fits) :], strict=True)
            if share < AccuracyOptions().enough
        ]
        unwarned += sum(is_enough(fit, expected_accuracy(fit)) for fit in low)
        print(name, modulus, seed, np.round(100 * np.array(accuracies[-1]), 1), file=sys.stderr, flush=True)
    shares = 100 * np.array(accuracies)
    cells = (f"{mean:.1f}/{worst:.1f}" for mean, worst in zip(shares.mean(0), shares.min(0), strict=True))
    label = name if modulus == 1 else f"{name}, soft"
    print(
        f"{label}: {refused} of {3 * rigs} fits refused, {unwarned} below 95 % without a warning, {excluded} of "
        f"{rigs * design.point_count} recordings left out, slowest fit {seconds:.1f} s"
    )
    rest = (f"{100 * np.mean(kept.estimates):.1f}",)
    stated = [f"{100 * np.mean(kept.parameters[part]):.0f}" for part in STATED]
    stated.append(f"{100 * np.mean(kept.responses):.0f}/{100 * min(kept.responses):.0f}")
    return "| " + " | ".join((label, *cells, *rest)) + " |", " | ".join((label, *stated))


def accuracy(known: localize.signals.ArrayResponse, touched: localize.signals.ArrayResponse) -> float:
    return localize.evaluate(localize.BayesDecoder(known, NOISE), touched, TOUCHES, NOISE).top1


def table(rigs: int, names: tuple[str, ...]) -> str:
    head = "| sensors | nominal | known exactly | all measured | one point | two | three | in band (%) |"
    stated = ("sensors", *STATED.values(), "responses/worst fit")
    rows = [row(name, DESIGNS[name], modulus, rigs) for name in names for modulus in (1.0, 0.85)]
    print("Fits to one, two and three points together: true values in their stated 95 % bands (%)")
    print("\n".join([" | ".join(stated), *(of_parts for _, of_parts in rows)]))
    return "\n".join([head, "|---" * 8 + "|", *(of_decoding for of_decoding, _ in rows)])


def main() -> None:
    given = sys.argv[1:]
    text = table(int(given[0]) if given else RIGS, tuple(given[1:]) or tuple(DESIGNS))
    print(text)
    if not given:
        replace_section(PAGE, BEGIN, END, text.splitlines())


if __name__ == "__main__":
    main()
