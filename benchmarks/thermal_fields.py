"""Thermal fields of cells from their sections, against those on fine meshes of their bodies.

``python -m benchmarks.thermal_fields``, some minutes. Cells are drawn at random: two tubes in line or at a right angle,
three without a mirror plane, chambers.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

from acoustic_fem.cell.one_cell import CHECKED_UP_TO, DESIGN_BAND, marked_solid
from acoustic_fem.fields.cylinder_heat import cylinder_field
from acoustic_fem.fields.diffusion import diffusion_field
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell
from geometry.schema.ports import CellPort

FREQUENCY = np.geomspace(DESIGN_BAND[0], CHECKED_UP_TO, 9)
#: Of the elements; half of what the accuracy of a design's cells asks for.
SCALE = 0.48
ANGLES = {"in line": (0.0, 180.0), "right angle": (0.0, 90.0), "three tubes": (0.0, 100.0, 220.0), "chamber": (0.0,)}


def drawn(family: str, random: np.random.Generator) -> tuple[Cell, Medium]:
    """A random cell of a family, and its air."""

    def between(low: float, high: float) -> float:
        return float(random.uniform(low, high))

    air = Medium.at(between(0, 40), 0.5, between(7e4, 1.05e5))
    if family == "chamber":
        diameter = between(1.5, 5.0)
        height = diameter / 2 * between(0.9, 2.4)
        bore = min(diameter * between(0.17, 0.4), height / 1.7)
        hole = round(diameter * between(0.14, 0.3), 3)
        port = (CellPort(0.0, round(bore, 3)),)
        sizes = round(diameter, 3), round(height, 3), round(height / 2, 4)
        return Cell("microphone", *sizes, port, hole, round(between(0.2, 1.0), 2)), air
    diameter = float(np.exp(random.uniform(np.log(1.8), np.log(4.5))))
    height = diameter / 2 * between(0.5, 1.8)
    bore = min(diameter * between(0.1, 0.3), height / 1.7)
    port_height = round(between(max(0.2 * height, 0.65 * bore), 0.5 * height), 4)
    ports = tuple(CellPort(angle, round(bore * between(0.6, 1.0), 3)) for angle in ANGLES[family])
    return Cell("resonator", round(diameter, 3), round(height, 3), port_height, ports, round(diameter, 3), 0.0), air


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=77003)
    parser.add_argument("--rounds", type=int, default=2)
    chosen = parser.parse_args()
    random = np.random.default_rng(chosen.seed)
    print("| cell | elements | stated (%) | found (%) | s |\n|---|---|---|---|---|")
    for family in list(ANGLES) * chosen.rounds:
        cell, air = drawn(family, random)
        solid, heat, excess = marked_solid(cell).shortened(), air.thermal_diffusivity, air.gamma - 1
        if solid.cylinder is None:
            raise RuntimeError("a cell that is drawn as a cylinder must be told as one")
        started = time.process_time()
        found = cylinder_field(solid.cylinder, heat, DESIGN_BAND).mean(FREQUENCY, heat)
        seconds = time.process_time() - started
        mesh = solid.mesh(mesh_sizes(SCALE, cell.smallest_extent, air, CHECKED_UP_TO)[1], lambda: None)
        exact = diffusion_field(mesh, solid.faces.open, heat, DESIGN_BAND).mean(FREQUENCY, heat)
        error = np.abs((air.gamma - excess * found) / (air.gamma - excess * exact) - 1).max()
        print(
            f"| {cell.label} | {len(mesh.tetrahedra)} | {100 * excess * solid.cylinder.mean_error:.3f} "
            f"| {100 * error:.3f} | {seconds:.2f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
