"""Discrepancies that no parameters of a fit explain.

``python benchmarks/discrepancy.py`` writes a table of docs/evidence/calibration.md.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
from acoustic_fem.calibration.fitted_model import UpdatedModel
from acoustic_fem.calibration.model_discrepancy import COMMON, OF_MICROPHONE, OWN, TOTAL
from geometry.ground.whole_files import replace_section
from studies.test_rig.rig_parameters import hidden_parameters
from studies.test_rig.virtual_rig import HiddenScatter, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "calibration.md"
BEGIN, END = "<!-- discrepancy: made by benchmarks/discrepancy.py -->", "<!-- end of discrepancy -->"
GRID = np.geomspace(1, 100, 32)
SEEDS = range(9000, 9024)
DESIGNS = ("array-2x6", "fingertip-3x4", "line-2")


def parts(name: str) -> list[float]:
    """Root mean squares in %: of the part that all transfer functions share, of a microphone's, of each one's own, of
    all.

    Deviations are relative to the model at the true parameters of each rig. A fit would explain more than is true.
    """
    design = geometry.prototype(name)
    model = UpdatedModel(acoustic_fem.solve(design, GRID, "lumped"))
    left = []
    for seed in SEEDS:
        rig = Rig(design, seed, HiddenScatter(), fidelity="lumped")
        true = hidden_parameters(rig, model)
        logarithms = np.array([np.log(true[each][0]) if each in true else 0.0 for each in model.names])
        known = model.transfer_function((logarithms / model.scale)[None])[0]
        left.append(rig.transfer_function(GRID) / known - 1)
    relative = np.array(left)
    common = relative.mean((1, 2), keepdims=True)
    of_microphone = (relative - common).mean(1, keepdims=True)
    own = relative - common - of_microphone
    return [100 * float(np.sqrt((np.abs(each) ** 2).mean())) for each in (common, of_microphone, own, relative)]


def main() -> None:
    """Write the table."""
    head = ["| rms (%) | shared by all | of a microphone | own | together |", "|---|---|---|---|---|"]
    rows = [(f"`{name}`", parts(name)) for name in DESIGNS]
    rows.append(("trusted to", [100 * each for each in (COMMON, OF_MICROPHONE, OWN, TOTAL)]))
    lines = [f"| {name} | " + " | ".join(f"{each:.1f}" for each in values) + " |" for name, values in rows]
    replace_section(PAGE, BEGIN, END, [*head, *lines])


if __name__ == "__main__":
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
        main()
