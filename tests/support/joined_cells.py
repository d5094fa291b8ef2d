"""The library of a design from its cells and their network: what a batch of one must agree with."""

from __future__ import annotations

import acoustic_fem
from acoustic_fem.library.network_responses import closed_form, joined_cells
from acoustic_fem.library.transfer_functions import library_from_arrays
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.local_air import AirLike, medium_of
from geometry import ArrayDesign


def library_of_cells(
    design: ArrayDesign, frequency: FrequencyLike, fidelity: str = "lumped", air: AirLike = None
) -> acoustic_fem.Library:
    """Library whose cells are closed forms, each with nodes of its own, joined as cells in 3-D are."""
    grid, medium = frequency_grid(frequency), medium_of(air, design)
    values = joined_cells(
        design, grid, medium, lambda cells: {cell: closed_form(fidelity, cell, grid, medium) for cell in cells}
    )
    return library_from_arrays(design, grid, values, fidelity, medium, {})
