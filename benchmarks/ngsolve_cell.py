"""A cell by NGSolve, solved at every frequency, against the same solid by this package.

    python -m benchmarks.ngsolve_cell

Linearised Navier-Stokes with heat: velocities and temperatures of order 2, pressures of order 1, half the cell, one
factorisation by PARDISO per frequency. One thread, processor time, meshing included. NGSolve (LGPL) is imported by
nothing else: ``python -m pip install ngsolve``.
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")

import tempfile
from pathlib import Path
from time import process_time
from unittest.mock import patch

import cadquery as cq
import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.quantities.units import metres
from benchmarks.one_mesh import BORE, CELL, HEIGHT, RADIUS
from geometry.ground.whole_files import replace_section
from tests.support.reference_data import AIR

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "speed.md"
FREQUENCY = np.geomspace(1, 100, 64)
#: Sizes of elements, mm.
SIZES = (0.15, 0.1, 0.07)
END = RADIUS + CELL.ports[0].stub_length


def ours() -> tuple[NDArray[np.complex128], float]:
    """Port admittance (n_freq, 2, 2), m^3/(Pa s), at the default accuracy with an empty cache, and its time, s."""
    tubes = cq.Workplane("YZ").circle(BORE / 2).extrude(END, both=True).translate((0, 0, HEIGHT / 2))
    solid = cq.Workplane().circle(RADIUS).extrude(HEIGHT).union(tubes)
    ports = {"A": (-END, 0.05, HEIGHT / 2), "B": (END, 0.05, HEIGHT / 2)}
    with tempfile.TemporaryDirectory() as empty, patch.dict("os.environ", ACOUSTIC_FEM_CACHE=empty):
        start = process_time()
        return acoustic_fem.cell.port_admittance(solid, ports, FREQUENCY, AIR), process_time() - start


def theirs(size: float) -> tuple[NDArray[np.complex128], int, float]:
    """The same by NGSolve with elements of a size in the tubes (mm) and five times that in the cavity, the number of
    unknowns, and its time, s.
    """
    import ngsolve as ng
    from netgen.occ import Box, Cylinder, OCCGeometry, Pnt, X, Z

    start = process_time()
    cavity = Cylinder(Pnt(0, 0, 0), Z, r=RADIUS, h=HEIGHT)
    tubes = Cylinder(Pnt(-END, 0, HEIGHT / 2), X, r=BORE / 2, h=2 * END)
    half = (cavity + tubes) * Box(Pnt(-2 * END, 0, -1), Pnt(2 * END, 2 * END, 2 * HEIGHT))
    half.faces.name = "wall"
    half.faces.Min(X).name, half.faces.Max(X).name = "A", "B"
    for face in half.faces:
        if abs(face.center.y) < 1e-9:
            face.name = "mirror"
        elif abs(face.center.x) > RADIUS - 0.1:
            face.maxh = size
    mesh = ng.Mesh(OCCGeometry(half).GenerateMesh(maxh=5 * size, grading=0.3))
    mesh.Curve(2)
    space = ng.FESpace(
        [
            ng.VectorH1(mesh, order=2, dirichlet="wall", dirichlety="mirror", complex=True),
            ng.H1(mesh, order=1, complex=True),
            ng.H1(mesh, order=2, dirichlet="wall", complex=True),
        ]
    )
    (u, p, s), (v, q, r) = space.TnT()
    normal, flux = ng.specialcf.normal(3), []
    for port in ("A", "B"):
        form = ng.LinearForm(space)
        form += -(v * normal) * ng.ds(port)
        flux.append(form.Assemble().vec)
    length, answers = metres(1.0), np.empty((len(FREQUENCY), 2, 2), dtype=np.complex128)
    for k, frequency in enumerate(FREQUENCY):
        omega = 2 * np.pi * frequency
        stored = 1j * omega * AIR.viscosity / (AIR.gamma * AIR.pressure)
        diffused = AIR.thermal_diffusivity / (1j * omega * length**2)
        form = ng.BilinearForm(space, symmetric=True)
        form += ng.InnerProduct(ng.grad(u), ng.grad(v)) * ng.dx
        form += (1j * omega * length**2 / AIR.kinematic_viscosity * (u * v) - p * ng.div(v) - q * ng.div(u)) * ng.dx
        form += -stored * AIR.gamma * p * q * ng.dx
        form += stored * (AIR.gamma - 1) * (s * q + p * r - s * r - diffused * ng.grad(s) * ng.grad(r)) * ng.dx
        inverse = form.Assemble().mat.Inverse(space.FreeDofs(), inverse="pardiso")
        for column in range(2):
            found = (inverse * flux[column]).Evaluate()
            for row in range(2):
                answers[k, row, column] = ng.InnerProduct(flux[row], found, conjugate=False)
    return 2 * answers * length**3 / AIR.viscosity, space.ndof, process_time() - start


def main() -> None:
    known, taken = ours()
    scale = np.sqrt(np.abs(np.einsum("fii->fi", known)))
    rows = [f"| here, default accuracy | | {taken:.1f} | | |"]
    for size in SIZES:
        found, unknowns, each = theirs(size)
        difference = np.max(np.abs(found - known) / (scale[:, :, None] * scale[:, None, :]))
        name = f"NGSolve, {size:g} mm in the tubes"
        rows.append(f"| {name} | {unknowns:,} | {each:.0f} | {each / taken:.0f} | {difference:.1e} |")
        print(rows[-1], flush=True)
    head = ["| cell by | unknowns | s | times as long | differs by |", "|---|---|---|---|---|"]
    lines = [f"Load {os.getloadavg()[0]:.1f}.", "", *head, *rows]
    print("\n".join(lines))
    replace_section(PAGE, "<!-- ngsolve: made by benchmarks/ngsolve_cell.py -->", "<!-- end ngsolve -->", lines)


if __name__ == "__main__":
    main()
