r"""Lossy Helmholtz equation by scalar viscous and thermal fields: weak forms and finite element spaces only.

.. math::
    \nabla\cdot(\Psi_v \nabla p) + k_0^2 (\gamma - (\gamma-1)\Psi_h)\, p = 0, \qquad
    u = -\frac{\Psi_v}{j\omega\rho} \nabla p ,

the sequential linearised Navier-Stokes model (W. R. Kampinga, thesis, Twente 2010). The viscous field obeys
:math:`\nu\nabla^2\Psi_v = j\omega(\Psi_v - 1)`, zero on walls, and so does the thermal one with alpha.

Exact in straight ducts of any section. **Wrong where a tube opens into a cavity**: the wide cavity's field
leaks into the mouth, and the entrance loss comes out with the wrong sign, 5 % of the admittance of a cell at
1 Hz. A bend lowers the resistance by 13 (a/R)^2 / 48, 13 times too much (docs/theory.md). Use it for straight
ducts and as a cross-check, not for numbers to trust.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy.sparse as sp
import skfem
from numpy.typing import NDArray

from acoustic_fem.fields.assembly import mass_matrix, stiffness_matrix, surface_basis
from acoustic_fem.fields.navier_stokes import WallMotion, tetrahedral_mesh
from geometry.air.mesh import SolidMesh
from geometry.ground.typed import Array


@skfem.LinearForm
def weighted_load(q: Any, form: Any) -> Any:
    """Weak form of a source on a face: weight q."""
    return form.weight * q


@dataclass(frozen=True, eq=False)
class PressureSystem:
    """Quadratic pressure on curved tetrahedra, lengths mm; ports hold one pressure each.

    Unknowns are the pressures off the ports.
    """

    basis: skfem.CellBasis
    """Finite element space of the pressure, lengths in mm."""
    free: NDArray[np.int64]
    """Degrees of freedom off the ports, (n_free,) int64."""
    on_ports: Array
    """Pressure of one at each port, (n_dof, n_port) float64: 1 on the nodes of the port."""
    sources: Array
    """Integral of each wall motion against the pressure, (n_dof, n_motion) float64, for a unit integral of its
    magnitude.
    """

    def conduction(self, weight: Array) -> sp.csr_array:
        """Integral of weight grad p . grad q, (n_dof, n_dof), mm; weight at quadrature points (n_element, q)."""
        return stiffness_matrix(self.basis, weight)

    def storage(self, weight: Array) -> sp.csr_array:
        """Integral of weight p q, (n_dof, n_dof), mm^3; weight at quadrature points (n_element, q)."""
        return mass_matrix(self.basis, weight)


def pressure_system(mesh: SolidMesh, ports: Sequence[str], motions: Sequence[WallMotion] = ()) -> PressureSystem:
    """Finite element space and sources of a cell; every face that is not a port is a wall, a mirror plane included."""
    tetrahedra, facets = tetrahedral_mesh(mesh)
    basis = skfem.Basis(tetrahedra, skfem.ElementTetP2(), intorder=4)
    on_ports = np.zeros((basis.N, len(ports)))
    for k, name in enumerate(ports):
        on_ports[basis.get_dofs(facets[name]).all(), k] = 1.0
    sources = np.zeros((basis.N, len(motions)))
    for k, motion in enumerate(motions):
        surface = surface_basis(basis, facets[motion.face])
        offset = np.asarray(surface.global_coordinates()) - np.array(motion.centre)[:, None, None]
        shape = np.interp(np.linalg.norm(offset, axis=0), motion.profile[:, 0], motion.profile[:, 1])
        sources[:, k] = weighted_load.assemble(surface, weight=shape) / np.sum(np.abs(shape) * surface.dx)
    free = np.flatnonzero(on_ports.sum(axis=1) == 0)
    return PressureSystem(basis, free, on_ports, sources)
