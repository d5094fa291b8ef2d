"""From a design to its library of transfer functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.library.provenance import library_provenance
from acoustic_fem.library.result import Library, library_from_arrays
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.quantities.fidelity import FIDELITIES
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell, cell_catalogue
from geometry.design.array_design import ArrayDesign
from geometry.layout.arrangement import lay_out
from geometry.refusal import Refusal


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
        fidelity: "lumped" (closed forms), "helmholtz" (scalar 3-D cells, a cross-check that is wrong at openings)
            or "navier-stokes" (3-D cells, the one to trust).
        medium: the air; by default that of the design.
        progress: called with what is being done and the fraction done, 0 to 1.

    Raises:
        Refusal: a bad frequency grid or an unknown fidelity.
    """
    grid = frequency_grid(frequency)
    if fidelity not in FIDELITIES:
        raise Refusal(f"fidelity = {fidelity!r} must be one of: {', '.join(FIDELITIES)}")
    report = progress or (lambda message, fraction: None)
    if medium is None:
        medium = Medium.at(design.air.temperature, design.air.humidity, design.air.pressure)
    layout = lay_out(design)
    catalogue = cell_catalogue(design, layout)
    admittances, solved = _cell_admittances(catalogue.distinct, grid, fidelity, medium, report)

    from acoustic_fem.network.array_network import solve_network

    report("network", 0.95)
    response = solve_network(design, layout, catalogue, admittances, grid, medium)
    library = library_from_arrays(
        design,
        grid,
        {
            "transfer_function": response.source_response / response.point_impedance[:, None, :],
            "source_response": response.source_response,
            "point_impedance": response.point_impedance,
            "microphone_impedance": response.microphone_impedance,
        },
        fidelity,
        medium,
        {
            **library_provenance(grid, ("gmsh", "numpy", "scikit-fem", "scipy", "xarray")),
            "cells": solved,
        },
    )
    report("done", 1.0)
    return library


def _cell_admittances(
    cells: tuple[Cell, ...],
    frequency: NDArray[np.float64],
    fidelity: str,
    medium: Medium,
    report: Callable[[str, float], None],
) -> tuple[dict[Cell, NDArray[np.complex128]], list[dict[str, Any]]]:
    """Nodal admittances of the cells, and how each was obtained."""
    if fidelity == "lumped":
        from acoustic_fem.cell.lumped import lumped_admittance

        return (
            {cell: lumped_admittance(cell, frequency, medium) for cell in cells},
            [{"cell": cell.label, "method": "closed form"} for cell in cells],
        )
    from acoustic_fem.cell.design_cells import solve_cells

    solutions = solve_cells(
        cells, frequency, medium, fidelity, progress=lambda label, fraction: report(label, 0.95 * fraction)
    )
    admittances = {cell: solution.admittance for cell, solution in solutions.items()}
    solved = [{"cell": cell.label, **solution.summary()} for cell, solution in solutions.items()]
    return admittances, solved
