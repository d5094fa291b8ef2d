"""From a design to its library of transfer functions."""

from __future__ import annotations

from collections.abc import Callable

from acoustic_fem.library.network_responses import array_responses
from acoustic_fem.library.provenance import library_provenance
from acoustic_fem.library.transfer_functions import Library, library_from_arrays
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import FIDELITIES, ONE_DESIGN
from acoustic_fem.quantities.local_air import AirLike, LocalAir, checked_air, medium_of
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_choice


def solve(
    design: DesignLike,
    frequency: FrequencyLike,
    fidelity: str = ONE_DESIGN,
    air: AirLike = None,
    progress: Callable[[str, float], None] | None = None,
) -> Library:
    """Transfer functions of an array from every point to every microphone.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        frequency: (n_freq,) ascending, 1e-3 to 2e3 Hz, or FIRST:LAST:COUNT such as ``"1:500:500"``.
        fidelity: "lumped" (closed forms), "atlas" (closed forms with 3-D corrections from a table, whose errors the
            library states), "helmholtz" (scalar 3-D cells, a cross-check that is wrong at openings) or "navier-stokes"
            (3-D cells, the reference).
        air: air of the place where the sensor is used, which becomes part of the library's design; or any other gas,
            which does not. By default the air of the design.
        progress: function that is called with the name of the step and the fraction done, 0 to 1.

    Raises:
        Refusal: a bad frequency grid, an unknown fidelity, an air of another type, or a design outside the atlas.
    """
    grid = frequency_grid(frequency)
    check_choice("fidelity", fidelity, FIDELITIES)
    checked_air(air, gas=True)
    design = resolve_design(design)
    report = progress or (lambda message, fraction: None)
    if isinstance(air, LocalAir):
        design = design.with_values(air.design_values)
    medium = medium_of(air, design)
    values, cells = array_responses(design, grid, fidelity, medium, report)
    provenance = {**library_provenance(grid, ("gmsh", "numpy", "scikit-fem", "scipy", "xarray")), "cells": cells}
    library = library_from_arrays(design, grid, values, fidelity, medium, provenance)
    report("done", 1.0)
    return library
