"""The worst held-out designs against 3-D on finer meshes: how much of the difference is that of the default's meshes.

``python -m benchmarks.atlas.finer SEED ...`` solves the cells to 1e-3 instead of 3e-3: minutes each.
"""

from __future__ import annotations

import sys
import warnings

import acoustic_fem
from acoustic_fem.cell import one_cell
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.quantities.local_air import design_air
from benchmarks.atlas.certify import apart
from benchmarks.atlas.held_out import FREQUENCY, random_design
from geometry.air.cells import cell_catalogue
from geometry.layout.arrangement import lay_out

#: Relative error of the bare cell that the finer meshes are refined to.
ACCURACY = 1e-3


def main(seeds: list[int]) -> None:
    """Print a row for each design."""
    for seed in seeds:
        design = random_design(seed)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
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


if __name__ == "__main__":
    main([int(each) for each in sys.argv[1:]])
