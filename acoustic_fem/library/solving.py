"""From a design to its library of transfer functions."""

from __future__ import annotations

from collections.abc import Callable

from numpy.typing import ArrayLike

from acoustic_fem.library.network_responses import array_responses
from acoustic_fem.library.provenance import library_provenance
from acoustic_fem.library.transfer_functions import Library, library_from_arrays
from acoustic_fem.quantities.checks import frequency_grid, one_of
from acoustic_fem.quantities.fidelity import FIDELITIES
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign


def solve(
    design: ArrayDesign,
    frequency: ArrayLike,
    fidelity: str = "navier-stokes",
    medium: Medium | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> Library:
    """Transfer functions of an array from every point to every microphone.

    Args:
        design: the array.
        frequency: (n_freq,) ascending, 1e-3 to 2e3 Hz.
        fidelity: "lumped" (closed forms), "atlas" (with what 3-D adds to them, from a table whose errors the library
            states), "helmholtz" (scalar 3-D cells, a cross-check that is wrong at openings) or "navier-stokes" (3-D
            cells, the one to trust).
        medium: the air; by default that of the design.
        progress: called with what is being done and the fraction done, 0 to 1.

    Raises:
        Refusal: a bad frequency grid, an unknown fidelity, or a design outside the atlas.
    """
    grid = frequency_grid(frequency)
    one_of("fidelity", fidelity, FIDELITIES)
    report = progress or (lambda message, fraction: None)
    if medium is None:
        medium = design_air(design)
    values, cells = array_responses(design, grid, fidelity, medium, report)
    provenance = {**library_provenance(grid, ("gmsh", "numpy", "scikit-fem", "scipy", "xarray")), "cells": cells}
    library = library_from_arrays(design, grid, values, fidelity, medium, provenance)
    report("done", 1.0)
    return library
