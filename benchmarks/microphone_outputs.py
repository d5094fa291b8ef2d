"""Calibrations from four points: outputs of microphones, pressures, and outputs that are taken for pressures.

``python -m benchmarks.microphone_outputs`` writes a table of docs/evidence/calibration.md: half a minute.
"""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import scipy.stats

import acoustic_fem
import geometry
from acoustic_fem.calibration import UpdatedModel, calibrate, read_manifest, update
from acoustic_fem.network import output_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.sound import TransferEstimate
from geometry.ground.whole_files import replace_section
from studies.test_rig import HiddenScatter, Recorder, Rig
from studies.test_rig.priors import fit_priors

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "calibration.md"
BEGIN, END = "<!-- outputs: made by benchmarks/microphone_outputs.py -->", "<!-- end of outputs -->"
DESIGN = geometry.prototype("array-2x6")
GRID = np.linspace(1, 100, 32)
SEEDS = range(1, 13)
POINTS = (1, 4, 8, 12)
SIGNIFICANCE = 1e-3


def as_pressures(estimates: Mapping[int, TransferEstimate]) -> dict[int, TransferEstimate]:
    """Estimates that outputs give if nobody divides by the response of the microphones, as before this was known."""
    known = output_response(DESIGN.microphone, GRID, design_air(DESIGN))
    return {
        number: replace(
            each, transfer_function=each.transfer_function * known, deviation=each.deviation * np.abs(known)
        )
        for number, each in estimates.items()
    }


def main() -> None:
    """Write the table."""
    nominal = acoustic_fem.solve(DESIGN, GRID, "lumped")
    model = UpdatedModel(nominal, fit_priors(DESIGN))
    measured = np.isin(np.arange(1, DESIGN.point_count + 1), POINTS)
    cases = {
        "pressures": (HiddenScatter(), "pressure", False),
        "outputs": (HiddenScatter(), "voltage", False),
        "outputs, corners of the vents off by 30 %": (HiddenScatter(corner=0.3), "voltage", False),
        "outputs taken for pressures": (HiddenScatter(), "voltage", True),
    }
    lines = [
        "| recordings | chi-squared | accepted | measured points (%) | other points (%) |",
        "|---|---|---|---|---|",
    ]
    for name, (scatter, output, mistaken) in cases.items():
        found = []
        for seed in SEEDS:
            rig = Rig(DESIGN, seed, scatter, fidelity="lumped")
            with tempfile.TemporaryDirectory() as folder:
                recorder = Recorder(seconds=30.0, output=output, reference_corner=0.0 if output == "pressure" else 1.0)
                manifest = read_manifest(rig.record(Path(folder) / "bench", POINTS, recorder))
                estimates = calibrate(manifest, nominal).estimates
            fit = update(model, as_pressures(estimates) if mistaken else estimates)
            error = 100 * np.abs(fit.transfer_function / rig.transfer_function(GRID) - 1).mean((1, 2))
            limit = scipy.stats.chi2.isf(SIGNIFICANCE, fit.residuals)
            found.append((fit.chi_squared, fit.objection is None, error[measured].mean(), error[~measured].mean()))
            print(f"{name}, seed {seed}: chi-squared {fit.chi_squared:.0f} of {limit:.0f}, {error.round(1)}")
        chi, accepted, of_measured, of_others = np.array(found, float).T
        lines.append(
            f"| {name} | {np.median(chi):.3g}/{chi.max():.3g} | {accepted.sum():.0f} of {len(found)} | "
            f"{of_measured.mean():.1f}/{of_measured.max():.1f} | {of_others.mean():.1f}/{of_others.max():.1f} |"
        )
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
        main()
