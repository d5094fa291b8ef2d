"""Matrices of scalar fields on tetrahedra: those of all elements at once, by products of small dense matrices.

scikit-fem works out every pair of shape functions by itself; here the sums over places are one product per element.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import scipy.sparse as sp
import skfem

from geometry.ground.typed import Array

#: Elements taken together: the numbers of so many stay in the processor's caches.
_TOGETHER = 512


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
