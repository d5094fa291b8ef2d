"""Curves of a design solved in 3-D, where the quick ones are not enough."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import xarray as xr

import acoustic_fem
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from geometry.design.array_design import ArrayDesign
from studies.panels.curve_validity import Validity
from studies.panels.curves import curve_frequencies, quick_library


@dataclass(frozen=True, eq=False)
class SolvedCurves:
    """Transfer functions of a design solved in 3-D."""

    transfer_function: xr.DataArray
    """Transfer functions at the frequencies of the curves; (n_point, n_microphone, n_freq) complex128, Pa/Pa."""
    validity: Validity
    """Validity of them, with how far the quick ones were off."""


def solve_curves(design: ArrayDesign, notify: Callable[[str], None] = lambda line: None) -> SolvedCurves:
    """Transfer functions of a design from cells solved in 3-D.

    Args:
        design: the array.
        notify: called with how far it is.

    Raises:
        Refusal: a cell that is too large for 3-D, or software for it that is not installed.
    """
    quick, fidelity = quick_library(design)
    solved = acoustic_fem.solve(
        design, curve_frequencies(), ONE_DESIGN, progress=lambda step, done: notify(f"{step}, {done:.0%}")
    ).transfer_function
    off = 100 * float(np.abs(solved.values / quick.transfer_function.transpose(*solved.dims).values - 1).max())
    reason = f"Solved in 3-D. The quick answer, of fidelity {fidelity.name}, differed from it by at most {off:.2g} %."
    return SolvedCurves(solved, Validity("3-D", reason, False))
