"""Stated errors of the cells of designs, and their errors against a far finer mesh.

``python -m benchmarks.cell_errors``, some twenty minutes. Cells are those of designs drawn at random, resonators and
microphones in turn, at the accuracy of designs and at 1e-3.
"""

from __future__ import annotations

import argparse
import time
import warnings

import numpy as np

from acoustic_fem.cell.condensed import AirModel, CondensedBody, condense
from acoustic_fem.cell.one_cell import CHECKED_UP_TO, DESIGN_ACCURACY, DESIGN_BAND, marked_solid
from acoustic_fem.cell.solid import MeshGoal, converge
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from benchmarks.atlas.held_out import random_design
from geometry.air.cells import Cell, cell_catalogue
from geometry.layout.arrangement import lay_out

FREQUENCY = np.geomspace(DESIGN_BAND[0], CHECKED_UP_TO, 9)
#: Scales of the meshes that errors are found with, flow and heat: the default begins at 1.3 and 0.96.
FINE = (0.7, 0.5)
ACCURACIES = (DESIGN_ACCURACY, 1e-3)


def reference(cell: Cell, air: Medium, scales: tuple[float, float] = FINE) -> CondensedBody:
    """The cell on meshes of these scales, flow and heat, its tubes meshed as far as the ports.

    For narrow tubes it is a mesh of half the size and less.
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
    print("| cell | asked (%) | unknowns | stated (%) | found (%) | compliance, found (%) | s |")
    print("|---|---|---|---|---|---|---|")
    for seed in range(chosen.seed, chosen.seed + chosen.designs):
        design = random_design(seed)
        cells, air = cell_catalogue(design, lay_out(design)).distinct, design_air(design)
        cell = cells[seed % len(cells)]
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            exact = reference(cell, air).nodal_admittance(FREQUENCY)
        size = np.sqrt(np.abs(np.einsum("fii->fi", exact)))
        for accuracy in ACCURACIES:
            goal = MeshGoal(accuracy, cell.smallest_extent, (DESIGN_BAND[0], CHECKED_UP_TO))
            started = time.process_time()
            solved = converge(marked_solid(cell), AirModel(air, DESIGN_BAND), goal)
            seconds = time.process_time() - started
            answer = solved.body.nodal_admittance(FREQUENCY)
            found = np.abs(answer - exact) / (size[:, :, None] * size[:, None, :])
            whole = np.abs(answer.sum((1, 2)) / exact.sum((1, 2)) - 1)
            print(
                f"| {seed}: {cell.label} | {100 * accuracy:g} | {solved.body.unknowns} | {100 * solved.mesh_error:.2f} "
                f"| {100 * found.max():.2f} | {100 * whole.max():.2f} | {seconds:.1f} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
