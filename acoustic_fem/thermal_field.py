r"""The thermal field of a cell of any shape, by finite elements on a mesh of its own.

:math:`\nabla^2 \Psi_h = (j\omega/\alpha)(\Psi_h - 1)`, zero on isothermal walls, no flux through ports.
Its layer along the walls is thinner than what the flow needs to be resolved, so it has its own mesh. It is
solved at a few frequencies; at any other it is a combination of those solutions, so that the compliance
gamma - (gamma - 1) Psi_h stays a short sum of real matrices with scalar coefficients.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
import skfem
from numpy.typing import NDArray
from scipy.spatial import KDTree

from acoustic_fem.frequency import ReducedModel, reduce_system
from acoustic_fem.medium import Medium
from acoustic_fem.navier_stokes import dirichlet_nodes, laplace, tetrahedral_mesh, weighted_mass
from acoustic_fem.units import metres
from geometry.mesh import SolidMesh


@dataclass(frozen=True)
class ThermalField:
    """Psi_h = sum_k c_k(f) v_k with real functions v_k."""

    basis: skfem.CellBasis
    functions: NDArray[np.float64]
    """(n_dof, r): v_k at the degrees of freedom of the basis."""
    model: ReducedModel
    diffusion_time: float
    """(1 mm)^2 / alpha, s."""

    def coefficients(self, frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        """c_k(f), (n_freq, r)."""
        solution, _ = self.model.coordinates(*_coefficients(frequency, self.diffusion_time))
        return solution[:, :, 0]

    def means_over(self, flow: skfem.CellBasis) -> NDArray[np.float64]:
        """Mean of every v_k over each element of another mesh of the same solid, (r, n_element).

        Each quadrature point of the thermal mesh counts for the element of the flow mesh whose quadrature
        point is nearest: the integral over the whole solid is kept exactly.
        """
        element_count, per_element = flow.dx.shape
        places = flow.global_coordinates().reshape(3, -1).T
        points = self.basis.global_coordinates().reshape(3, -1).T
        _, nearest = KDTree(places).query(points)
        element = nearest // per_element
        volume = flow.dx.sum(axis=1)
        return np.stack(
            [
                np.bincount(
                    element,
                    weights=(np.asarray(self.basis.interpolate(function)) * self.basis.dx).ravel(),
                    minlength=element_count,
                )
                / volume
                for function in self.functions.T
            ]
        )


def thermal_field(mesh: SolidMesh, ports: tuple[str, ...], medium: Medium, band: tuple[float, float]) -> ThermalField:
    """Solve the thermal field of a cell over a band of frequencies.

    Args:
        mesh: the air, mm; every face but the ports is isothermal.
        ports: names of the ports.
        medium: the gas.
        band: lowest and highest frequency, Hz.
    """
    tetrahedra, facets = tetrahedral_mesh(mesh)
    basis = skfem.Basis(tetrahedra, skfem.ElementTetP2(), intorder=4)
    free = np.setdiff1d(np.arange(basis.N), dirichlet_nodes(basis, facets, ports))
    stiffness = laplace.assemble(basis).tocsr()[free][:, free]
    mass = weighted_mass.assemble(basis, weight=np.ones_like(basis.dx)).tocsr()
    load = np.asarray(mass @ np.ones(basis.N))[free]
    diffusion_time = metres(1.0) ** 2 / medium.thermal_diffusivity
    model = reduce_system(
        [sp.csr_array(stiffness), sp.csr_array(mass[free][:, free])],
        lambda frequency: _coefficients(frequency, diffusion_time)[0],
        [load[:, None]],
        lambda frequency: _coefficients(frequency, diffusion_time)[1],
        band,
        tolerance=1e-6,
        keep_basis=True,
    )
    assert model.basis is not None
    functions = np.zeros((basis.N, model.basis.shape[1]))
    functions[free] = model.basis
    return ThermalField(basis, functions, model, diffusion_time)


def _coefficients(
    frequency: NDArray[np.float64], diffusion_time: float
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    rate = np.asarray(2j * np.pi * frequency * diffusion_time, dtype=np.complex128)
    return np.column_stack([np.ones_like(rate), rate]), rate[:, None]
