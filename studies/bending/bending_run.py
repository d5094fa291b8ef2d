"""A bending study from a rig to its files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from studies.bending.bending_files import RESULT, save_bending
from studies.bending.bending_rig import BendingRig
from studies.bending.solution import Bending, solve_bending
from studies.output.display import Display
from studies.output.folders import claimed_folder
from studies.output.frequencies import FREQUENCIES


@dataclass(frozen=True, eq=False)
class BendingStudy:
    """Results of a bending study, and their files."""

    result: Bending
    """Transfer functions at every angle, and how far they lie from those of the straight tube."""
    files: tuple[Path, ...]
    """Files that were written: ``bending.png``, ``bending.csv`` and ``bending.json``."""


def bending_study(
    out: str | os.PathLike[str],
    rig: BendingRig | None = None,
    *,
    fidelity: str = ONE_DESIGN,
    frequency: FrequencyLike = FREQUENCIES,
    display: Display | None = None,
) -> BendingStudy:
    """Results of bending a tube on the publication's rig: how much less it transmits, with the bent bore solved in 3-D.

    Args:
        out: the folder to write to; earlier files of a study are replaced.
        rig: the tube; by default the published one.
        fidelity: of the bent bore, ``"navier-stokes"`` or ``"helmholtz"``.
        frequency: (n_freq,) Hz, ascending, or FIRST:LAST:COUNT.
        display: shows progress.

    Raises:
        Refusal: a folder that cannot be written, or a bad frequency or fidelity, before any work.
    """
    folder = Path(out)
    with claimed_folder(folder, "bend", RESULT):
        with (display or Display()).stage("Bending") as report:
            result = solve_bending(rig or BendingRig(), frequency, fidelity, report)
        return BendingStudy(result, save_bending(result, folder))
