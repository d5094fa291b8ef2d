"""Matrices of scalar fields on tetrahedra: those of all elements at once, by products of small dense matrices.

scikit-fem works out every pair of shape functions by itself; here the sums over places are one product per element.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import scipy.sparse as sp
import skfem
from numpy.typing import NDArray
from skfem.mapping import MappingIsoparametric

from geometry.ground.typed import Array

#: Elements taken together: the numbers of so many stay in the processor's caches.
_TOGETHER = 512
#: Rounding errors of a place in an element, each of the size of the largest coordinate, over its shortest edge.
_ROUNDINGS = 64


class _Mapping(MappingIsoparametric):
    """Mapping of curved elements whose Newton iteration ends where rounding of the coordinates ends it.

    scikit-fem asks for 1e-12 of an element, which small elements far from the origin never reach.
    """

    def invF(
        self, x: Array, tind: NDArray[np.int64] | None = None, newton_max_iters: int = 50, newton_tol: float = 1e-12
    ) -> Array:
        """Places in the elements ``tind``, (3, n_element, n) float64 of one, of the points ``x``, mm."""
        corners = self.mesh.p[:, self.mesh.t]
        shortest = min(
            float(np.linalg.norm(corners[:, first] - corners[:, second], axis=0).min())
            for first in range(len(corners[0]))
            for second in range(first)
        )
        rounding = _ROUNDINGS * np.finfo(np.float64).eps * float(np.abs(self.mesh.p).max()) / shortest
        found: Array = super().invF(x, tind, newton_max_iters, max(newton_tol, rounding))
        return found


def surface_basis(basis: skfem.CellBasis, facets: NDArray[np.int64]) -> skfem.FacetBasis:
    """Finite element space of a basis on facets of its mesh, wherever that lies.

    Args:
        basis: finite element space on curved second-order tetrahedra.
        facets: numbers of the facets, (n,) int64.
    """
    mesh = basis.mesh
    mapping = _Mapping(mesh, mesh.elem(), mesh.bndelem)
    return skfem.FacetBasis(mesh, basis.elem, mapping=mapping, facets=facets, intorder=4)


def stiffness_matrix(basis: skfem.CellBasis, weight: Array | None = None) -> sp.csr_array:
    """Integral of weight grad p . grad q.

    Args:
        basis: finite element space of both.
        weight: at the quadrature points, (n_element, n_quadrature) float64; None: one everywhere.

    Returns:
        (n_dof, n_dof), in the unit of the weight times the mesh's unit of length.
    """
    strength = basis.dx if weight is None else basis.dx * weight
    local = np.empty((basis.nelems, basis.Nbfun, basis.Nbfun))
    for part in _parts(basis.nelems):
        gradient = _gradients(basis, part)
        weighted = gradient * strength[part, None, None, :]
        rows = (len(gradient), basis.Nbfun, -1)
        np.matmul(weighted.reshape(rows), gradient.reshape(rows).transpose(0, 2, 1), out=local[part])
    return _assembled(local, basis, basis)


def mass_matrix(basis: skfem.CellBasis, weight: Array | None = None) -> sp.csr_array:
    """Integral of weight p q; arguments as of :func:`stiffness_matrix`.

    Returns:
        (n_dof, n_dof), in the unit of the weight times the mesh's unit of volume.
    """
    strength = basis.dx if weight is None else basis.dx * weight
    value = _values(basis)
    pairs = (value[:, None, :] * value[None, :, :]).reshape(-1, value.shape[1])
    return _assembled((strength @ pairs.T).reshape(-1, basis.Nbfun, basis.Nbfun), basis, basis)


def divergence_matrix(velocity: skfem.CellBasis, pressure: skfem.CellBasis) -> sp.csr_array:
    """Integral of q div u.

    Args:
        velocity: space of each component of u; the components follow one another.
        pressure: space of q, on the same mesh and quadrature points.

    Returns:
        (n_pressure, 3 n_velocity), in the mesh's unit of area.
    """
    value = _values(pressure)
    local = np.empty((3, velocity.nelems, pressure.Nbfun, velocity.Nbfun))
    for part in _parts(velocity.nelems):
        weighted = _gradients(velocity, part) * velocity.dx[part, None, None, :]
        local[:, part] = np.einsum("eiaq,kq->aeki", weighted, value, optimize=True)
    return sp.csr_array(sp.hstack([_assembled(axis, pressure, velocity) for axis in local], format="csr"))


def _parts(count: int) -> Iterator[slice]:
    for first in range(0, count, _TOGETHER):
        yield slice(first, first + _TOGETHER)


def _values(basis: skfem.CellBasis) -> Array:
    """Shape functions at the quadrature points of any element, (n_function, n_quadrature) float64."""
    return np.stack([np.asarray(basis.elem.lbasis(basis.X, number)[0]) for number in range(basis.Nbfun)])


def _gradients(basis: skfem.CellBasis, part: slice) -> Array:
    """Gradients of the shape functions of some elements, (n_element, n_function, 3, n_quadrature) float64."""
    return np.stack([function[0].grad[:, part].transpose(1, 0, 2) for function in basis.basis], axis=1)


def _assembled(local: Array, rows: skfem.CellBasis, columns: skfem.CellBasis) -> sp.csr_array:
    """Matrices of the elements, (n_element, n_row_function, n_column_function) float64, added up."""
    row, column = rows.element_dofs.T[:, :, None], columns.element_dofs.T[:, None, :]
    at = (np.broadcast_to(row, local.shape).ravel(), np.broadcast_to(column, local.shape).ravel())
    return sp.coo_array((local.ravel(), at), shape=(rows.N, columns.N)).tocsr()
