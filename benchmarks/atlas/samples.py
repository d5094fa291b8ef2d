"""Cells from which the atlas is made, solved in 3-D one by one; solved cells are kept.

``python -m benchmarks.atlas.samples FOLDER`` continues where it was. Sizes are multiples of the larger bore, which has
a shear number of 5 at 500 Hz. Everything else follows from Sobol numbers.
"""

from __future__ import annotations

import json
import sys
import time
import warnings
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from scipy.stats import qmc

from acoustic_fem import Medium
from acoustic_fem.cell.condensed import AirModel, CondensedBody, condense
from acoustic_fem.cell.one_cell import marked_solid
from acoustic_fem.fields.diffusion import diffusion_field
from acoustic_fem.fields.element_sizes import mesh_sizes
from geometry.air.cells import Cell
from geometry.schema.ports import CellPort

HIGHEST = 500.0
SEEDS = (19, 20)
MEDIUM = Medium.at()
#: Shear numbers of the larger bore at which a cell is kept.
SHEAR = np.array([0.1, 0.35, 0.7, 1.0, 1.3, 1.6, 1.9, 2.2, 2.6, 3.0, 3.4, 3.8, 4.2, 4.6, 5.0])
BORE = 2e3 * SHEAR[-1] * float(np.sqrt(MEDIUM.kinematic_viscosity / (2 * np.pi * HIGHEST)))  # mm
FREQUENCY = HIGHEST * (SHEAR / SHEAR[-1]) ** 2
Kind = Literal["resonator", "microphone"]


@dataclass(frozen=True)
class Sample:
    """A cell to solve, and on which meshes."""

    name: str
    """Name of its file."""
    cell: Cell
    """The cell."""
    flow_scale: float
    """Scale of the mesh of the flow, see :func:`acoustic_fem.fields.element_sizes.mesh_sizes`."""
    heat_scale: float
    """Scale of the mesh of the thermal field."""


def resonators(count: int, seed: int) -> list[Cell]:
    """Resonators with two tubes, half of them with ports at mid height, half of them with equal bores."""
    cells: list[Cell] = []
    for u in qmc.Sobol(4, seed=seed).random(1024):
        alpha = np.exp(np.interp(u[0], [0, 1], np.log([0.055, 0.31])))
        beta = np.exp(np.interp(u[1], [0, 1], np.log([0.08, 0.85])))
        gamma = np.exp(np.interp(u[2], [0, 1], np.log([0.08, 0.51])))
        number = len(cells)
        if number % 2 == 0:
            beta = gamma
        above, below = 1 / gamma, 1 / beta
        if not (0.3 <= alpha * (above + below) <= 2.3 and below <= 1.2 * above):
            continue
        other = 1.0 if number // 2 % 2 == 0 else float(np.interp(u[3], [0, 1], [0.4, 0.95]))
        cells.append(_resonator(alpha, below, above, other))
        if len(cells) == count:
            break
    return cells


def _resonator(alpha: float, below: float, above: float, other: float) -> Cell:
    a = BORE / 2
    ports = (CellPort(0.0, round(BORE * other, 4)), CellPort(180.0, round(BORE, 4)))
    diameter = round(2 * a / alpha, 4)
    return Cell("resonator", diameter, round(a * (below + above), 4), round(a * below, 4), ports, diameter, 0.0)


def microphones(count: int, seed: int, hole_by_height: tuple[float, float] = (0.12, 0.23)) -> list[Cell]:
    """Chambers with one tube and a sound hole, of a radius by the height of the chamber between the two."""
    cells: list[Cell] = []
    for u in qmc.Sobol(4, seed=seed).random(1024):
        a = BORE / 2
        alpha = np.exp(np.interp(u[0], [0, 1], np.log([0.15, 0.42])))
        beta = np.exp(np.interp(u[1], [0, 1], np.log([0.1, 0.56])))
        radius, height = a / alpha, 2 * a / beta
        hole = radius * np.interp(u[2], [0, 1], [0.12, 0.32])
        if not (0.7 <= height / radius <= 3.0 and hole_by_height[0] <= hole / height <= hole_by_height[1]):
            continue
        cells.append(
            Cell(
                "microphone",
                round(2 * radius, 4),
                round(height, 4),
                round(height, 4) / 2,
                (CellPort(0.0, round(BORE, 4)),),
                round(2 * hole, 4),
                round(1.4 * hole, 4),
            )
        )
        if len(cells) == count:
            break
    return cells


def condensed(
    cell: Cell, medium: Medium, band: tuple[float, float], highest: float, scales: tuple[float, float]
) -> CondensedBody:
    """A cell on one mesh for the flow and one for heat, of these scales at the highest frequency that counts."""
    solid = marked_solid(cell)
    heat_mesh = solid.mesh(mesh_sizes(scales[1], cell.smallest_extent, medium, highest)[1], lambda: None)
    heat = diffusion_field(heat_mesh, solid.faces.open, medium.thermal_diffusivity, band)
    flow_mesh = solid.mesh(mesh_sizes(scales[0], cell.smallest_extent, medium, highest)[0], lambda: None)
    return condense(flow_mesh, heat, solid.faces, AirModel(medium, band), tolerance=3e-5)


def solved(sample: Sample) -> dict[str, Any]:
    """Admittance of a sample at all shear numbers."""
    started = time.process_time()
    band = (float(FREQUENCY[0]), float(FREQUENCY[-1]))
    body = condensed(sample.cell, MEDIUM, band, HIGHEST, (sample.flow_scale, sample.heat_scale))
    admittance = body.nodal_admittance(FREQUENCY)
    return {
        "cell": asdict(sample.cell),
        "flow_scale": sample.flow_scale,
        "heat_scale": sample.heat_scale,
        "unknowns": body.unknowns,
        "seconds": time.process_time() - started,
        "real": admittance.real.tolist(),
        "imag": admittance.imag.tolist(),
    }


def samples() -> list[Sample]:
    """All samples, in the order in which they are solved."""
    shells, chambers = resonators(32, 19), microphones(16, 19)
    chambers += microphones(8, 20, (0.055, 0.12))
    # what the mesh of all changes, on a few; cells are ranked by size, so that some of the smallest take part
    small = sorted(range(len(shells)), key=lambda k: shells[k].diameter ** 2 * shells[k].height)
    rooms = sorted(range(len(chambers)), key=lambda k: chambers[k].diameter ** 2 * chambers[k].height)
    first = [Sample(f"microphone-{k:02}", cell, 0.85, 2.5) for k, cell in enumerate(chambers)]
    first += [Sample(f"resonator-{k:02}", cell, 0.85, 2.5) for k, cell in enumerate(shells)]
    fine = [Sample(f"microphone-{k:02}-fine", chambers[k], 0.7, 0.7) for k in rooms[:9:3]]
    fine += [Sample(f"resonator-{k:02}-fine", shells[k], 0.7, 0.7) for k in small[:9:2]]
    return fine[:1] + first + fine[1:]


def main(folder: Path) -> None:
    """Solve what is not solved yet."""
    folder.mkdir(parents=True, exist_ok=True)
    every = samples()
    for number, sample in enumerate(every, 1):
        path = folder / f"{sample.name}.json"
        if path.exists():
            continue
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            found = solved(sample)
        beside = path.with_suffix(".part")
        beside.write_text(json.dumps(found))
        beside.replace(path)
        print(f"{number} of {len(every)}: {sample.name} {found['seconds']:.1f} s, {found['unknowns']}", flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
