r"""The viscous and the thermal field of a cell of any shape, by finite elements.

:math:`\nabla^2 \Psi = (j\omega/d)(\Psi - 1)`, zero on walls, no flux through ports: the thermal field with
the diffusivity d = alpha, the viscous one with d = nu. The layer along the walls is thinner than what the
flow needs to be resolved, so the field may have a mesh of its own. It is solved at a few frequencies; at any
other it is a combination of those solutions, so that what depends on it stays a short sum of real matrices
with scalar coefficients.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.sparse as sp
import skfem
from scipy.spatial import KDTree

from acoustic_fem.fields.assembly import mass_matrix, stiffness_matrix
from acoustic_fem.fields.navier_stokes import dirichlet_nodes, tetrahedral_mesh
from acoustic_fem.numerics.rational_sweep import ReducedModel, reduce_system
from acoustic_fem.quantities.units import metres
from geometry.air.mesh import SolidMesh
from geometry.ground.typed import Array, ComplexArray


@dataclass(frozen=True, eq=False)
class DiffusionField:
    """A field Psi = sum_k c_k(f) v_k of real functions v_k; the coefficients come from :func:`field_coefficients`."""

    basis: skfem.CellBasis
    """Finite element space of the field, lengths in mm."""
    functions: Array
    """Functions v_k at the degrees of freedom of the basis, (n_dof, r) float64."""
    model: ReducedModel
    """Reduced model that gives the coefficients."""

    def mean(self, frequency: Array, diffusivity: float) -> ComplexArray:
        """Mean of the field over the body, (n_freq,) complex128.

        Args:
            frequency: (n_freq,) Hz.
            diffusivity: of viscosity or of heat, m^2/s.
        """
        integrals = self.integrals.sum(axis=1)
        return field_coefficients(self.model, frequency, diffusivity) @ integrals / self.basis.dx.sum()

    @cached_property
    def integrals(self) -> Array:
        """Integral of every v_k over each element of its mesh, (r, n_element) float64, mm^3."""
        return np.einsum("rek,ek->re", self.at_quadrature(), self.basis.dx)

    def means_over(self, flow: skfem.CellBasis) -> Array:
        """Mean of every v_k over each element of another mesh of the same solid, (r, n_element) float64.

        Each element of the field's mesh counts for the element of the flow mesh whose middle is nearest: the integral
        over the whole solid is kept exactly, and the pressure that it meets hardly varies over so short a way.
        """
        _, nearest = KDTree(_middles(flow)).query(_middles(self.basis))
        volume = flow.dx.sum(axis=1)
        return np.stack([np.bincount(nearest, weights=each, minlength=len(volume)) / volume for each in self.integrals])

    def at_quadrature(self) -> Array:
        """Functions v_k at the quadrature points, (r, n_element, n_quadrature) float64."""
        return np.stack([np.asarray(self.basis.interpolate(function)) for function in self.functions.T])


def _middles(basis: skfem.CellBasis) -> Array:
    """Middles of the elements, (n_element, 3) float64, mm."""
    mesh = basis.mesh
    return np.asarray(mesh.p[:, mesh.t[:4]].mean(axis=1).T)


def diffusion_field(
    mesh: SolidMesh, open_faces: Sequence[str], diffusivity: float, band: tuple[float, float]
) -> DiffusionField:
    """Solve the field of a cell over a band of frequencies.

    Args:
        mesh: the air, mm; the field is zero on every face but the open ones.
        open_faces: ports and mirror plane.
        diffusivity: nu or alpha, m^2/s.
        band: lowest and highest frequency, Hz.
    """
    tetrahedra, facets = tetrahedral_mesh(mesh)
    basis = skfem.Basis(tetrahedra, skfem.ElementTetP2(), intorder=4)
    free = np.setdiff1d(np.arange(basis.N), dirichlet_nodes(basis, facets, open_faces))
    stiffness, mass = stiffness_matrix(basis)[free][:, free], mass_matrix(basis)
    load = np.asarray(mass @ np.ones(basis.N))[free]
    model, found = field_model(stiffness, mass[free][:, free], load, diffusivity, band)
    functions = np.zeros((basis.N, found.shape[1]))
    functions[free] = found
    return DiffusionField(basis, functions, model)


def field_model(
    stiffness: sp.csr_array, mass: sp.csr_array, load: Array, diffusivity: float, band: tuple[float, float]
) -> tuple[ReducedModel, Array]:
    """Reduced model of a field, and the functions v_k at its free degrees of freedom, (n, r) float64.

    Args:
        stiffness: integral of grad p . grad q, (n, n), mm.
        mass: integral of p q, (n, n), mm^3.
        load: integral of p, (n,) float64, mm^3.
        diffusivity: nu or alpha, m^2/s.
        band: lowest and highest frequency, Hz.
    """
    model = reduce_system(
        [sp.csr_array(stiffness), sp.csr_array(mass)],
        lambda frequency: _system_coefficients(frequency, diffusivity)[0],
        [load[:, None]],
        lambda frequency: _system_coefficients(frequency, diffusivity)[1],
        band,
        tolerance=1e-6,
        keep_basis=True,
    )
    if model.basis is None:
        raise RuntimeError("the reduced model was asked to keep its basis and did not")
    return model, model.basis


def field_coefficients(model: ReducedModel, frequency: Array, diffusivity: float) -> ComplexArray:
    """Coefficients c_k(f), (n_freq, r) complex128.

    Args:
        model: the field's reduced model.
        frequency: (n_freq,) Hz.
        diffusivity: of viscosity or of heat, m^2/s.
    """
    solution, _ = model.coordinates(*_system_coefficients(frequency, diffusivity))
    return np.asarray(solution[:, :, 0], dtype=np.complex128)


def _system_coefficients(frequency: Array, diffusivity: float) -> tuple[ComplexArray, ComplexArray]:
    rate = np.asarray(2j * np.pi * frequency * metres(1.0) ** 2 / diffusivity, dtype=np.complex128)
    return np.column_stack([np.ones_like(rate), rate]), rate[:, None]
