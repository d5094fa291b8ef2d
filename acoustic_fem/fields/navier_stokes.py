r"""Linearised Navier-Stokes with a scalar thermal field: weak forms and finite element spaces only.

Find the velocity u and the pressure p of small harmonic motions of a viscous, heat-conducting gas in a
cell whose walls are rigid, no-slip and isothermal:

.. math::
    \int \mu \nabla u : \nabla w + j\omega\rho\, u\cdot w - p\, \nabla\!\cdot w
        = -\sum_i p_i \int_{P_i} w\cdot n , \qquad
    -\int q\, \nabla\!\cdot u - \int \frac{j\omega}{\rho c^2}\,
        \bigl(\gamma - (\gamma-1)\Psi_h\bigr)\, p\, q = 0 ,

with u = 0 on walls, no tangential velocity on ports, a given normal velocity on moving walls, and no normal
velocity on a mirror plane.
:math:`\Psi_h` is the thermal field, :math:`\alpha\nabla^2\Psi_h = j\omega(\Psi_h - 1)`, zero on walls
(Cummings 1993; Kampinga 2010). Bulk viscosity is left out: the flow is nearly divergence-free.

Taylor-Hood elements (quadratic velocity, linear pressure) on curved tetrahedra. Lengths are taken in
millimetres and pressure in units of mu / 1 mm, which brings all blocks of the matrix to one size; without
that a direct solver can lose every digit in silence.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy.sparse as sp
import skfem
from numpy.typing import NDArray

from acoustic_fem.fields.assembly import divergence_matrix, mass_matrix, stiffness_matrix, surface_basis
from geometry.air.mesh import SolidMesh
from geometry.ground.typed import Array


@skfem.LinearForm
def normal_flux(w: Any, form: Any) -> Any:
    """Weak form of one component's part of the flux out of the cell: w n_i."""
    return w * form.n[form.axis]


@dataclass(frozen=True)
class CellSystem:
    """Matrices of a cell with walls and ports built in; lengths mm, pressure in mu / 1 mm.

    The unknowns are the free velocities followed by the pressures. With s = j w L^2 / nu and
    t = j w mu / (rho c^2) (L = 1 mm) the system matrix is
    ``viscous + s inertia - coupling - t (gamma compliance - (gamma - 1) thermal)``, the last two on the pressures.
    """

    viscous: sp.csr_array
    """Viscous term, (n, n)."""
    inertia: sp.csr_array
    """Term of inertia, (n, n), taken s times."""
    coupling: sp.csr_array
    """Coupling of velocity and pressure, (n, n), subtracted."""
    port_flux: Array
    """Volume velocity out through each port, (n, n_port) float64, mm^2 times the velocity."""
    motion_terms: tuple[Array, Array, Array]
    """Viscous term, inertia and coupling applied to the scaled wall motions, restricted to the unknowns, (n, n_motion)
    float64 each.
    """
    motion_energy: Array
    """Viscous and inertia energy of the wall motions themselves, (2, n_motion, n_motion) float64."""
    n_velocity: int
    """Number of free velocities, which come first among the unknowns."""

    @property
    def size(self) -> int:
        """Number of unknowns."""
        return self.viscous.shape[0]


def compliance_mass(pressure: skfem.CellBasis, weight: Array) -> sp.csr_array:
    """Integral of weight p q over the cell, (n_pressure, n_pressure), mm^3; the weight, a ratio, is (n_element,)."""
    return mass_matrix(pressure, weight[:, None])


def tetrahedral_mesh(mesh: SolidMesh) -> tuple[skfem.MeshTet2, dict[str, NDArray[np.int64]]]:
    """The mesh in scikit-fem's form, and the facets of each face by name, (n_facet,) int64."""
    tetrahedra = skfem.MeshTet2(mesh.nodes.T, mesh.tetrahedra.T)
    vertex = _vertex_numbers(mesh)
    return tetrahedra, {name: _facets(tetrahedra, vertex[triangles]) for name, triangles in mesh.faces.items()}


def dirichlet_nodes(
    scalar: skfem.CellBasis, facets: dict[str, NDArray[np.int64]], ports: Sequence[str]
) -> NDArray[np.int64]:
    """Degrees of freedom of a scalar basis on every face that is not a port, (n_dof,) int64."""
    walls = [index for name, index in facets.items() if name not in ports]
    return np.unique(np.concatenate([scalar.get_dofs(index).all() for index in walls]))


@dataclass(frozen=True, eq=False)
class WallMotion:
    """A flat face that moves along its normal with a shape that depends on the distance from a centre."""

    face: str
    """Name of the face."""
    profile: Array
    """Radius (mm) and normal velocity, (n, 2) float64; scaled so that the integral of its magnitude over the face is 1:
    unit volume velocity into the cell, where the shape has one sign.
    """
    centre: tuple[float, float, float]
    """Centre of the profile, mm."""


@dataclass(frozen=True, eq=False)
class FlowMatrices:
    """Matrices of all velocities and pressures on a mesh, those on walls included, whatever moves it; lengths mm."""

    mesh: SolidMesh
    """The air."""
    facets: dict[str, NDArray[np.int64]]
    """Facets of each face by name, (n_facet,) int64."""
    velocity: skfem.CellBasis
    """Space of each component of the velocity; the components follow one another."""
    pressure: skfem.CellBasis
    """Space of the pressure."""
    viscous: sp.csr_array
    """Viscous term, (n, n)."""
    inertia: sp.csr_array
    """Term of inertia, (n, n)."""
    divergence: sp.csr_array
    """Divergence, (n_pressure, n)."""
    compliance: sp.csr_array
    """Storage of the gas at one weight everywhere, (n_pressure, n_pressure)."""


def flow_matrices(mesh: SolidMesh) -> FlowMatrices:
    """Assemble the flow on a mesh, with every port, moving wall and mirror plane named."""
    tetrahedra, facets = tetrahedral_mesh(mesh)
    quadratic = skfem.Basis(tetrahedra, skfem.ElementTetP2(), intorder=4)
    linear = quadratic.with_element(skfem.ElementTetP1())
    # The three components of the velocity share one scalar matrix each.
    scalars = stiffness_matrix(quadratic), mass_matrix(quadratic)
    viscous, inertia = (sp.csr_array(sp.block_diag([block] * 3, format="csr")) for block in scalars)
    compliance = compliance_mass(linear, np.ones(tetrahedra.nelements))
    divergence = divergence_matrix(quadratic, linear)
    return FlowMatrices(mesh, facets, quadratic, linear, viscous, inertia, divergence, compliance)


def cell_system(
    whole: FlowMatrices, ports: Sequence[str], motions: Sequence[WallMotion] = (), mirrors: Sequence[str] = ()
) -> CellSystem:
    """A cell with walls, ports and mirror planes built in.

    Args:
        whole: the matrices on its mesh.
        ports: names of the ports, in order.
        motions: walls that move, in order; several may share a face.
        mirrors: names of the planes that halve the cell; the ports and moving walls they cut are then halves as well.
    """
    mesh, facets, quadratic = whole.mesh, whole.facets, whole.velocity
    # Through a port the flow is straight, along a mirror it is free.
    barred = {name: _tangents(mesh.normals[name]) for name in ports}
    barred |= {name: mesh.normals[name][:, None] for name in mirrors}
    reduction = _velocity_reduction(
        quadratic.N,
        dirichlet_nodes(quadratic, facets, [*barred]),
        [(quadratic.get_dofs(facets[name]).all(), directions) for name, directions in barred.items()],
    )
    n_velocity, n_pressure = reduction.shape[1], whole.pressure.N
    blank = sp.csr_array((n_pressure, n_pressure))
    viscous = sp.block_diag([reduction.T @ whole.viscous @ reduction, blank], format="csr")
    inertia = sp.block_diag([reduction.T @ whole.inertia @ reduction, blank], format="csr")
    reduced_divergence = whole.divergence @ reduction
    coupling = sp.block_array([[None, reduced_divergence.T], [reduced_divergence, None]], format="csr")

    flux = np.zeros((n_velocity + n_pressure, len(ports)))
    for k, name in enumerate(ports):
        flux[:n_velocity, k] = reduction.T @ _flux_through(facets[name], quadratic)

    lift = np.zeros((3 * quadratic.N, len(motions)))
    for k, motion in enumerate(motions):
        resting = [index for name, index in facets.items() if name not in (motion.face, *mirrors)]
        lift[:, k] = _wall_motion(quadratic, facets[motion.face], resting, mesh.normals[motion.face], motion)
    terms = (whole.viscous @ lift, whole.inertia @ lift)
    zeros = np.zeros((n_pressure, len(motions)))
    motion_terms = (
        np.concatenate([reduction.T @ terms[0], zeros]),
        np.concatenate([reduction.T @ terms[1], zeros]),
        np.concatenate([np.zeros((n_velocity, len(motions))), whole.divergence @ lift]),
    )
    return CellSystem(
        viscous=viscous,
        inertia=inertia,
        coupling=coupling,
        port_flux=flux,
        motion_terms=motion_terms,
        motion_energy=np.stack([lift.T @ terms[0], lift.T @ terms[1]]),
        n_velocity=n_velocity,
    )


def _flux_through(face: NDArray[np.int64], quadratic: skfem.CellBasis) -> Array:
    """Volume velocity out of the cell through facets for each velocity, (3 n_scalar,) float64."""
    surface = surface_basis(quadratic, face)
    return np.concatenate([normal_flux.assemble(surface, axis=axis) for axis in range(3)])


def _vertex_numbers(mesh: SolidMesh) -> NDArray[np.int64]:
    """scikit-fem renumbers corner nodes by rank among all corners: node -> vertex."""
    corners = np.unique(mesh.tetrahedra[:, :4])
    vertex = np.full(len(mesh.nodes), -1, dtype=np.int64)
    vertex[corners] = np.arange(len(corners))
    return vertex


def _facets(mesh: skfem.MeshTet2, triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Facet numbers of corner triples; every triangle must be a boundary facet."""
    boundary = mesh.boundary_facets()
    n = mesh.nvertices

    def key(corners: NDArray) -> NDArray:
        a, b, c = np.sort(corners, axis=0).astype(np.int64)
        return (a * n + b) * n + c

    keys = key(mesh.facets[:, boundary])
    order = np.argsort(keys)
    wanted = key(triangles.T)
    place = np.minimum(np.searchsorted(keys[order], wanted), len(keys) - 1)
    if not np.array_equal(keys[order][place], wanted):
        raise RuntimeError("a named triangle is not a boundary facet of the mesh")
    return boundary[order[place]]


def _tangents(normal: Array) -> Array:
    """(3, 2): an orthonormal pair across the normal."""
    return _free_directions(normal[:, None])


def _free_directions(barred: Array) -> Array:
    """(3, d): orthonormal, across all of the barred directions, (3, n) float64."""
    left, length, _ = np.linalg.svd(barred)
    return np.asarray(left[:, np.count_nonzero(length > 1e-6) :])


def _velocity_reduction(
    n_scalar: int, wall_nodes: NDArray[np.int64], guided: Sequence[tuple[NDArray[np.int64], Array]]
) -> sp.csr_array:
    """Map from free velocities to all: none on walls, none along the directions (3, d) that guided nodes are barred."""
    components = np.arange(3 * n_scalar).reshape(3, -1)
    faces = np.zeros((len(guided), n_scalar), dtype=bool)
    for on_face, (nodes, _) in zip(faces, guided, strict=True):
        on_face[nodes] = True
    inner = np.ones(n_scalar, dtype=bool)
    inner[wall_nodes] = False
    rows, columns, values, count = [], [], [], 0
    for met in np.unique(faces.T, axis=0):
        nodes = np.flatnonzero(inner & (met == faces.T).all(axis=1))
        barred = [directions for on_face, (_, directions) in zip(met, guided, strict=True) if on_face]
        for direction in _free_directions(np.hstack(barred)).T if barred else np.eye(3):
            rows.append(components[:, nodes].ravel())
            columns.append(np.tile(count + np.arange(len(nodes)), 3))
            values.append(np.repeat(direction, len(nodes)))
            count += len(nodes)
    matrix = sp.coo_array(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=(3 * n_scalar, count)
    )
    matrix.eliminate_zeros()
    return sp.csr_array(matrix)


def _wall_motion(
    quadratic: skfem.CellBasis,
    face: NDArray[np.int64],
    resting: Sequence[NDArray[np.int64]],
    normal: Array,
    motion: WallMotion,
) -> Array:
    """Velocity of a moving wall, positive into the cell and scaled to a unit integral of its magnitude, mm^2."""
    on_face = np.unique(quadratic.get_dofs(face).all())
    rim = np.unique(np.concatenate([quadratic.get_dofs(index).all() for index in resting]))
    radius = np.linalg.norm(quadratic.doflocs[:, on_face] - np.array(motion.centre)[:, None], axis=0)
    shape = np.interp(radius, motion.profile[:, 0], motion.profile[:, 1])
    shape[np.isin(on_face, rim)] = 0.0
    inwards = np.zeros((3, quadratic.N, 2))
    inwards[:, on_face] = -normal[:, None, None] * np.column_stack([shape, np.abs(shape)])
    flat = inwards.reshape(-1, 2)
    scaled: Array = flat[:, 0] / (-_flux_through(face, quadratic) @ flat[:, 1])
    return scaled
