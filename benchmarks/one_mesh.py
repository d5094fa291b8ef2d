"""A line of resonators as one body of air in one mesh, and the same line from one cell and plane waves between."""

from __future__ import annotations

import cadquery as cq
import numpy as np
from numpy.typing import NDArray

from acoustic_fem.cell.condensed import AirModel, BodyFaces, CondensedBody, condense
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.one_cell import CellSolution
from acoustic_fem.duct import plane_wave
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.fields.navier_stokes import WallMotion
from geometry.air.cells import Cell
from geometry.air.mesh import SolidMesh, mesh_solid
from geometry.schema.ports import CellPort
from tests.support.reference_data import AIR

BORE, RADIUS, HEIGHT, LENGTH = 0.5, 3.0, 2.5, 12.5  # mm
PITCH = 2 * RADIUS + LENGTH
CELL = Cell("resonator", 2 * RADIUS, HEIGHT, HEIGHT / 2, (CellPort(0.0, BORE), CellPort(180.0, BORE)), 2 * RADIUS, 0.0)
MIRROR = "mirror"
MEMBRANE, MICROPHONE = 1.2e-11, 5e-14  # m^3/Pa


def line_meshes(points: int, scale: float, highest: float) -> tuple[list[SolidMesh], list[WallMotion]]:
    """Half the air of a line, from tube end A to tube end B: meshes for flow and heat, and its membranes.

    Args:
        points: number of resonators.
        scale: of the element sizes, see :func:`acoustic_fem.fields.element_sizes.mesh_sizes`.
        highest: frequency, Hz.
    """
    places = (np.arange(points) - (points - 1) / 2) * PITCH
    end = float(places[-1]) + RADIUS + LENGTH
    air = cq.Workplane("YZ").circle(BORE / 2).extrude(end, both=True).translate((0, 0, HEIGHT / 2))
    faces = {"A": (-end, 0.05, HEIGHT / 2), "B": (end, 0.05, HEIGHT / 2), MIRROR: (float(places[0]), 0, HEIGHT / 2)}
    radius = np.linspace(0, RADIUS, 200)
    profile = np.column_stack([radius, (1 - (radius / RADIUS) ** 2) ** 2])
    motions = []
    for k, place in enumerate(places.tolist()):
        air = air.union(cq.Workplane().circle(RADIUS).extrude(HEIGHT).translate((place, 0, 0)))
        faces[f"membrane {k}"] = (place, 0.1, HEIGHT)
        motions.append(WallMotion(f"membrane {k}", profile, (place, 0, HEIGHT)))
    half = air.intersect(cq.Workplane().box(4 * end, 50, 200).translate((0, 25, 0))).val()
    return [mesh_solid(half, faces, ("A", "B"), sizes) for sizes in mesh_sizes(scale, HEIGHT, AIR, highest)], motions


def in_one_mesh(points: int, frequency: NDArray[np.float64], scale: float = 1.2) -> CondensedBody:
    """The line in one mesh: ports A and B, then the membranes."""
    meshes, motions = line_meshes(points, scale, float(frequency[-1]))
    air = AirModel(AIR, (float(frequency[0]), float(frequency[-1])))
    return condense(*meshes, BodyFaces(("A", "B"), motions, MIRROR), air)


def in_pieces(points: int, frequency: NDArray[np.float64]) -> tuple[NDArray[np.complex128], CellSolution]:
    """Nodal admittance (n_freq, 2 + points, 2 + points) of the same nodes from one cell and ducts, and the cell."""
    cell = solve_cells([CELL], frequency, AIR)[CELL]
    stub = CELL.ports[0].stub_length
    inner = plane_wave.port_admittance(BORE / 2e3, (LENGTH - 2 * stub) * 1e-3, frequency, AIR)
    outer = plane_wave.port_admittance(BORE / 2e3, (LENGTH - stub) * 1e-3, frequency, AIR)
    nodes = 2 + points  # A, B, membranes; then the left and right port of every cell
    total = np.zeros((len(frequency), nodes + 2 * points, nodes + 2 * points), dtype=complex)

    def left(k: int) -> int:
        return nodes + 2 * k

    entries = [([left(k) + 1, left(k), 2 + k], cell.admittance) for k in range(points)]
    entries += [([0, left(0)], outer), ([left(points - 1) + 1, 1], outer)]
    entries += [([left(k) + 1, left(k + 1)], inner) for k in range(points - 1)]
    for at, matrix in entries:
        total[np.ix_(range(len(frequency)), at, at)] += matrix
    kept, gone = slice(0, nodes), slice(nodes, None)
    to_kept = np.linalg.solve(total[:, gone, gone], total[:, gone, kept])
    return total[:, kept, kept] - total[:, kept, gone] @ to_kept, cell


def transfer_functions(nodal: NDArray[np.complex128], frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
    """From each membrane to a small volume at either end, (n_freq, 2 points), membranes on their compliance."""
    points = nodal.shape[1] - 2
    loaded = nodal.copy()
    for node, compliance in enumerate([MICROPHONE] * 2 + [MEMBRANE] * points):
        loaded[:, node, node] += 2j * np.pi * frequency * compliance
    impedance = np.linalg.inv(loaded)
    return np.stack([impedance[:, m, p] / impedance[:, p, p] for p in range(2, 2 + points) for m in (0, 1)], axis=1)
