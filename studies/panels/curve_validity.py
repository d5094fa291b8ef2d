"""How far the quick curves of a design are from 3-D, by what is known of their fidelity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr

from acoustic_fem.atlas import QuickFidelity, cell_atlas
from acoustic_fem.quantities.fidelity import MANY_DESIGNS, ONE_DESIGN
from studies.run.check import LUMPED_IS_OFF

#: Smallest transfer function whose logarithm is taken.
_SILENT = 1e-300


@dataclass(frozen=True)
class Validity:
    """Validity of curves."""

    words: str
    """Their fidelity with its error, in a few words."""
    reason: str
    """Sentences on where the error comes from, or why the curves are not of the quick fidelity."""
    solves: bool
    """True if the design can be solved in 3-D instead."""


def validity(transfer_function: xr.DataArray, fidelity: QuickFidelity) -> Validity:
    """Validity of the transfer functions of a design.

    The error of the atlas is the largest that its held-out designs showed, for the weakest transfer function. Closed
    forms alone have the error that they have on the prototypes, because nothing is known of designs outside the atlas.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa.
        fidelity: that they were computed with.
    """
    if fidelity.name == ONE_DESIGN:
        return Validity("3-D", f"Solved in 3-D, because the quick answer does not hold: {fidelity.why}.", False)
    if fidelity.name != MANY_DESIGNS:
        worst = max(percent for _, percent, _ in LUMPED_IS_OFF)
        known = ", ".join(
            f"{percent:g} % and {degrees:g} degrees on {name}" for name, percent, degrees in LUMPED_IS_OFF
        )
        reason = f"Closed forms alone: {fidelity.why}. They differ from 3-D by up to {known}; here it is not known."
        return Validity(f"rough, \N{PLUS-MINUS SIGN}{worst:.1g} %", reason, False)
    atlas = cell_atlas()
    off = 100 * atlas.errors["transfer function by 1 + |ln H|"]
    weakest = float(np.maximum(np.abs(transfer_function.values), _SILENT).min())
    here = off * (1 + abs(np.log(weakest)))
    return Validity(
        f"quick, \N{PLUS-MINUS SIGN}{here:.2g} %",
        f"The atlas of cells differs from 3-D by up to {off:.2g} % x (1 + |ln H|) on 40 random designs (1 to "
        f"{atlas.known_up_to:g} Hz). The percentage here is that of the weakest transfer function of this design.",
        True,
    )
