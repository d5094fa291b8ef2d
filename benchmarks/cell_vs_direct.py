"""Time saved by substructuring and the adaptive sweep: cells against direct solves, arrays in one mesh against cells.

    python -m benchmarks.cell_vs_direct [--quick]

One thread, seconds of processor time. Both sides of a ratio use the same meshes and the same linear solver; the
direct solves assemble once and keep the ordering of the first factorisation.
"""

from __future__ import annotations

import argparse
import platform
import tempfile
import time
from unittest.mock import patch

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from acoustic_fem.cell.condensed import AirModel, BodyFaces, condense
from acoustic_fem.fields.diffusion import diffusion_field, field_coefficients
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.fields.navier_stokes import cell_system, compliance_mass, flow_matrices
from acoustic_fem.numerics.linear_solver import SymmetricSolver, backend
from acoustic_fem.quantities.units import metres
from benchmarks.one_mesh import CELL, in_one_mesh, in_pieces
from geometry.air.cells import Cell
from geometry.air.mesh import SolidMesh, mesh_solid
from geometry.air.volume import MIDPLANE, MIRROR, air_volume
from geometry.schema.ports import CellPort
from tests.support.reference_data import AIR

FREQUENCY = np.geomspace(1, 100, 64)
BAND = (1.0, 100.0)
ACCURACY = 1e-3
CELLS = {
    "two ports in line (a quarter meshed)": CELL,
    "two ports at 90 degrees (half meshed)": Cell(
        "resonator", 6.0, 2.5, 1.25, (CellPort(0.0, 0.5), CellPort(90.0, 0.5)), 6.0, 0.0
    ),
    "three ports": Cell("resonator", 6.0, 2.5, 1.0, tuple(CellPort(a, 0.5) for a in (0.0, 120.0, 240.0)), 6.0, 0.0),
}


def direct(
    flow: SolidMesh, heat: SolidMesh, faces: BodyFaces, frequency: NDArray[np.float64]
) -> NDArray[np.complex128]:
    """Port admittance by one complex factorisation per frequency, (n_freq, n_port, n_port)."""
    whole = flow_matrices(flow)
    system = cell_system(whole, faces.tubes, (), faces.planes)
    field = diffusion_field(heat, faces.open, AIR.thermal_diffusivity, BAND)
    means = [compliance_mass(whole.pressure, mean) for mean in field.means_over(whole.pressure)]
    coefficients = field_coefficients(field.model, frequency, AIR.thermal_diffusivity)
    blank = sp.csr_array((system.n_velocity, system.n_velocity))
    length, answers = metres(1.0), []
    with SymmetricSolver(system.size) as solver:
        for f, c in zip(frequency, coefficients, strict=True):
            omega = 2 * np.pi * f
            cold = sum(value * mean for value, mean in zip(c, means, strict=True))
            stored = AIR.gamma * whole.compliance - (AIR.gamma - 1) * cold
            stored = stored * (1j * omega * AIR.viscosity / (AIR.gamma * AIR.pressure))
            matrix = system.viscous + system.inertia * (1j * omega * length**2 / AIR.kinematic_viscosity)
            matrix = matrix - system.coupling - sp.block_diag([blank, stored], format="csr")
            flux = system.port_flux.astype(complex)
            answers.append(flux.T @ solver.solve(sp.csr_array(matrix), flux))
    return np.stack(answers) * length**3 / AIR.viscosity * 2 ** len(faces.planes)


def cells(names: list[str]) -> None:
    print(f"\none cell, {len(FREQUENCY)} frequencies, meshes for accuracy = {ACCURACY:g}, {backend()}")
    print(f"{'cell':<34}{'unknowns':>9}{'direct s':>10}{'adaptive s':>12}{'ratio':>7}{'largest difference':>20}")
    for name in names:
        cell = CELLS[name]
        air = air_volume(cell)
        ports = tuple(air.ports)
        mirror, midplane = (name if name in air.mirrors else None for name in (MIRROR, MIDPLANE))
        marked = BodyFaces(ports, mirror=mirror, midplane=midplane)
        flow, heat = (
            mesh_solid(air.solid, air.faces, ports, sizes) for sizes in mesh_sizes(1.0, cell.height, AIR, BAND[1])
        )
        start = time.process_time()
        body = condense(flow, heat, marked, AirModel(AIR, BAND), tolerance=1e-2 * ACCURACY)
        swept = body.nodal_admittance(FREQUENCY)
        middle = time.process_time()
        exact = direct(flow, heat, marked, FREQUENCY)
        end = time.process_time()
        scale = np.sqrt(np.abs(np.einsum("fii->fi", exact)))
        difference = np.max(np.abs(swept - exact) / (scale[:, :, None] * scale[:, None, :]))
        print(
            f"{name:<34}{body.unknowns:>9}{end - middle:>10.1f}{middle - start:>12.1f}"
            f"{(end - middle) / (middle - start):>7.1f}{difference:>20.1e}",
            flush=True,
        )


def arrays(sizes: list[int]) -> None:
    print("\na line of points, adaptive sweep: in one mesh, and from its one distinct cell (solved anew) and ducts")
    print(f"{'points':>7}{'unknowns':>10}{'one mesh s':>12}{'cell unknowns':>15}{'cell s':>8}{'ratio':>7}")
    for points in sizes:
        start = time.process_time()
        body = in_one_mesh(points, FREQUENCY)
        body.nodal_admittance(FREQUENCY)
        middle = time.process_time()
        with tempfile.TemporaryDirectory() as empty, patch.dict("os.environ", ACOUSTIC_FEM_CACHE=empty):
            _, cell = in_pieces(points, FREQUENCY)
        pieces = time.process_time() - middle
        print(
            f"{points:>7}{body.unknowns:>10}{middle - start:>12.1f}{cell.unknowns:>15}{pieces:>8.1f}"
            f"{(middle - start) / pieces:>7.1f}",
            flush=True,
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="the first cell, and arrays of one and two points")
    quick = parser.parse_args().quick
    print(f"Python {platform.python_version()}, numpy {np.__version__}, {platform.processor() or platform.machine()}")
    with threadpool_limits(1):
        cells(list(CELLS)[:1] if quick else list(CELLS))
        arrays([1, 2] if quick else [1, 2, 3, 4])


if __name__ == "__main__":
    main()
