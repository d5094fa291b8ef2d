"""The worst held-out designs against 3-D on finer meshes: how much of the difference is that of the default's meshes.

``python -m benchmarks.atlas.finer SEED ...`` solves the cells to 1e-3 instead of 3e-3, minutes each, and a stub of
the first cell with its opening on finer and finer meshes.
"""

from __future__ import annotations

import sys
import warnings

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.atlas.cell_in_atlas import atlas_admittance
from acoustic_fem.cell import one_cell
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.quantities.local_air import design_air
from benchmarks.atlas.certify import apart
from benchmarks.atlas.held_out import FREQUENCY, random_design
from benchmarks.atlas.samples import condensed
from geometry import ArrayDesign
from geometry.air.cells import cell_catalogue
from geometry.layout.arrangement import lay_out

#: Relative error of the bare cell that the finer meshes are refined to.
ACCURACY = 1e-3


def main(seeds: list[int]) -> None:
    """Print a row for each design."""
    for seed in seeds:
        design = random_design(seed)
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            found = {
                name: acoustic_fem.solve(design, FREQUENCY, name).transfer_function.values
                for name in ("navier-stokes", "atlas", "lumped")
            }
            usual, one_cell.DESIGN_ACCURACY = one_cell.DESIGN_ACCURACY, ACCURACY
            for cell in cell_catalogue(design, lay_out(design)).distinct:
                solve_cells([cell], FREQUENCY, design_air(design))  # in this process, which knows the accuracy
            exact = acoustic_fem.solve(design, FREQUENCY, "navier-stokes").transfer_function.values
            one_cell.DESIGN_ACCURACY = usual
        for name, values in found.items():
            heard, per_log = apart(exact, values)
            print(f"{seed} {name}: {100 * heard:.2f} %, {100 * per_log:.2f} %", flush=True)
        stubs(design)


def stubs(design: ArrayDesign) -> None:
    """Impedance of a stub with its opening in mu / a^3 at the highest frequency, on finer and finer meshes."""
    cell, air, highest = cell_catalogue(design, lay_out(design)).distinct[0], design_air(design), FREQUENCY[-1:]
    unit = (5e-4 * cell.ports[0].bore_diameter) ** 3 / air.viscosity

    def stub(admittance: NDArray[np.complex128]) -> str:
        apart = np.linalg.inv(admittance) * unit
        return f"{apart[0, 0, 0] - apart[0, 0, 1]:.4f}"

    print("lumped", stub(lumped_admittance(cell, highest, air)))
    print("atlas", stub(atlas_admittance(cell, highest, air)))
    for scale in (1.2, 0.8, 0.55):
        body = condensed(cell, air, (1.0, 500.0), float(highest[0]), (scale, 2.5))
        print(f"3-D, scale {scale}", stub(body.nodal_admittance(highest)), flush=True)


if __name__ == "__main__":
    main([int(each) for each in sys.argv[1:]])
