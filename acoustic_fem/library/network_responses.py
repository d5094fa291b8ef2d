"""Responses of an array as bare arrays: its cells, solved or in closed form, joined by its network."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.atlas.cell_in_atlas import atlas_admittance, least_angle
from acoustic_fem.atlas.cell_table import cell_atlas
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell, cell_catalogue
from geometry.design.array_design import ArrayDesign
from geometry.layout.arrangement import place_housings

#: Called with what is being done and the fraction done, 0 to 1.
Report = Callable[[str, float], None]


def array_responses(
    design: ArrayDesign,
    frequency: NDArray[np.float64],
    fidelity: str,
    medium: Medium,
    report: Report = lambda message, fraction: None,
) -> tuple[dict[str, NDArray[np.complex128]], list[dict[str, Any]]]:
    """Responses of an array, and how each distinct cell was computed.

    Args:
        design: the array.
        frequency: (n_freq,) float64, ascending, Hz.
        fidelity: one of :data:`acoustic_fem.FIDELITIES`.
        medium: the air.
        report: of the progress.

    Returns:
        Arrays by the names, shapes and units of :data:`acoustic_fem.library.transfer_functions.VARIABLES`, and a
        summary of each cell as JSON can hold it.
    """
    layout = place_housings(design)
    catalogue = cell_catalogue(design, layout)
    admittances, solved = _cell_admittances(catalogue.distinct, frequency, fidelity, medium, report)

    from acoustic_fem.network.array_network import solve_network

    report("network", 0.95)
    response = solve_network(design, layout, catalogue, admittances, frequency, medium)
    return {
        "transfer_function": response.source_response / response.point_impedance[:, None, :],
        "source_response": response.source_response,
        "point_impedance": response.point_impedance,
        "microphone_impedance": response.microphone_impedance,
    }, solved


def _cell_admittances(
    cells: tuple[Cell, ...],
    frequency: NDArray[np.float64],
    fidelity: str,
    medium: Medium,
    report: Report,
) -> tuple[dict[Cell, NDArray[np.complex128]], list[dict[str, Any]]]:
    """Nodal admittances of the cells, and how each was obtained."""
    if fidelity == "lumped":
        from acoustic_fem.cell.lumped import lumped_admittance

        return (
            {cell: lumped_admittance(cell, frequency, medium) for cell in cells},
            [{"cell": cell.label, "method": "closed form"} for cell in cells],
        )
    if fidelity == "atlas":
        atlas = cell_atlas()
        atlas.warn_above(frequency)
        atlas.warn_below(least_angle(cells))
        about = {
            "method": f"atlas of cells, table {atlas.digest}",
            "errors": dict(atlas.errors),
            "errors_up_to_hz": atlas.known_up_to,
            "errors_from_degrees": atlas.known_from,
        }
        return (
            {cell: atlas_admittance(cell, frequency, medium) for cell in cells},
            [{"cell": cell.label, **about} for cell in cells],
        )
    from acoustic_fem.cell.design_cells import solve_cells

    solutions = solve_cells(
        cells, frequency, medium, fidelity, progress=lambda label, fraction: report(label, 0.95 * fraction)
    )
    admittances = {cell: solution.admittance for cell, solution in solutions.items()}
    solved = [{"cell": cell.label, **solution.summary()} for cell, solution in solutions.items()]
    return admittances, solved
