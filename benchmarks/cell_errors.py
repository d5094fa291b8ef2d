"""What cells of designs state of their own error, and what a far finer mesh finds of it.

``python -m benchmarks.cell_errors``, some twenty minutes. Cells are those of designs drawn at random.
"""

from __future__ import annotations

import argparse
import warnings

import numpy as np

from acoustic_fem.cell.condensed import AirModel, CondensedBody, condense
from acoustic_fem.cell.one_cell import CHECKED_UP_TO, DESIGN_BAND, CellTask, marked_solid, rebuilt, solve_task
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from benchmarks.atlas.held_out import random_design
from geometry.air.cells import Cell, cell_catalogue
from geometry.layout.arrangement import lay_out

FREQUENCY = np.geomspace(DESIGN_BAND[0], CHECKED_UP_TO, 9)
#: Scales of the meshes that errors are found with, flow and heat: the default begins at 1.1 and 0.96.
FINE = (0.65, 0.5)


def reference(cell: Cell, air: Medium, scales: tuple[float, float] = FINE) -> CondensedBody:
    """The cell on meshes of these scales, flow and heat, its tubes meshed as far as the ports.

    Tubes have elements of half a viscous layer by default.
    """
    solid, (flow, heat) = marked_solid(cell), scales
    sizes = mesh_sizes(flow, cell.smallest_extent, air, CHECKED_UP_TO)[0]
    warm = mesh_sizes(heat, cell.smallest_extent, air, CHECKED_UP_TO)[1]
    meshes = [solid.mesh(each, lambda: None) for each in (sizes, warm)]
    return condense(*meshes, solid.faces, AirModel(air, DESIGN_BAND), tolerance=1e-5)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=4100)
    parser.add_argument("--designs", type=int, default=10)
    chosen = parser.parse_args()
    print("| cell | unknowns | stated (%) | found (%) | compliance found (%) | s |\n|---|---|---|---|---|---|")
    for seed in range(chosen.seed, chosen.seed + chosen.designs):
        design = random_design(seed)
        cell, air = cell_catalogue(design, lay_out(design)).distinct[0], design_air(design)
        task = CellTask(cell, air, DESIGN_BAND, "navier-stokes")
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            solved = rebuilt(task, solve_task(task, lambda done: None), FREQUENCY, False)
            exact = reference(cell, air).nodal_admittance(FREQUENCY)
        size = np.sqrt(np.abs(np.einsum("fii->fi", exact)))
        found = np.abs(solved.admittance - exact) / (size[:, :, None] * size[:, None, :])
        whole = np.abs(solved.admittance.sum((1, 2)) / exact.sum((1, 2)) - 1)
        print(
            f"| {seed}: {cell.label} | {solved.unknowns} | {100 * solved.mesh_error:.2f} | {100 * found.max():.2f} "
            f"| {100 * whole.max():.2f} | {solved.seconds:.1f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
