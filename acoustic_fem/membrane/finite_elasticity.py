"""Half section of a disc of rubber at finite strain: elastic forces, their tangent, and the volume under the disc.

Compressible neo-Hookean rubber with the free energy per relaxed volume

    W = mu / 2 (tr(F^T F) - 3 - 2 ln J) + p ln J - p^2 / (2 lambda),    J = det F,

stationary in the pressure p, so that p = lambda ln J (Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element
Analysis (2008), section 6.4.3; the mixed form does not lock as Poisson's ratio goes to 1/2). At small strain it is the
elasticity of :mod:`acoustic_fem.membrane.elasticity`. Displacements are quadratic and pressures linear on rectangles
(Q2-Q1 of Taylor and Hood). Lengths are divided by the radius a of the opening, stresses by Young's modulus E.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
import skfem
from numpy.typing import NDArray

from acoustic_fem.membrane.half_section import FITTING, DiscShape, Mounting, graded_from_both
from geometry.ground.typed import Array

#: Radial steps are at most max(thickness, this) / (refinement + 1).
_RADIAL_SCALE = 0.1
#: Steps at the edge of a soft patch, per thickness.
_AT_PATCH = 0.25
#: Strain next to the edge of the glue, where stress is singular, is not reported within so many thicknesses of it.
NEAR_GLUE = 0.1

_ROUNDING = 1e-12

Numbers = NDArray[np.int64]


class Block(NamedTuple):
    """Element matrices and the unknowns of their rows and columns."""

    values: Array
    """Entries by element, (n_element, n_row, n_column) float64."""
    rows: Numbers
    """Unknowns of the rows, (n_element, n_row) int64."""
    columns: Numbers
    """Unknowns of the columns, (n_element, n_column) int64."""

    @property
    def transposed(self) -> Block:
        """The same entries with rows and columns exchanged."""
        return Block(self.values.swapaxes(1, 2), self.columns, self.rows)


@dataclass(frozen=True, eq=False)
class Strain:
    """Deformation at the quadrature points of all elements, (n_element, n_place) arrays."""

    gradient: Array
    """Deformation gradient F: rr, rz, zr, zz and the hoop component, (n_element, n_place, 5) float64."""
    inverse: Array
    """Inverse transpose of F, components as :attr:`gradient`, (n_element, n_place, 5) float64."""
    dilation: Array
    """J = det F, (n_element, n_place) float64."""
    pressure: Array
    """Pressure unknown p, (n_element, n_place) float64, in E; tension is positive."""


class Section:
    """Rectangles over the half section of a disc, their quadrature and their unknowns.

    The unknowns are displacements, then pressures at the corners.

    Args:
        shape: the disc, flat and without prestress.
        refinement: the largest step is a (refinement + 1)-th of the thickness, the smallest, at the edge of the clamp,
            2^-(refinement + 2) thicknesses.
        mounting: strain and glue with which the disc is mounted; by default it fits and its glue is rigid.
    """

    def __init__(self, shape: DiscShape, refinement: int, mounting: Mounting = FITTING) -> None:
        self.shape, self.mounting = shape, mounting
        ratio = shape.poisson_ratio
        self.shear = 1 / (2 * (1 + ratio))
        self.bulk = ratio / ((1 + ratio) * (1 - 2 * ratio))
        self.mesh = skfem.MeshQuad.init_tensor(*_corners(shape, refinement))
        self.displacement = skfem.Basis(self.mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
        self.pressure = self.displacement.with_element(skfem.ElementQuad1())
        self.size = self.displacement.N + self.pressure.N
        radius = self.displacement.global_coordinates()[0]
        self.weight = 2 * np.pi * radius * self.displacement.dx
        # By the free disc, which the mounting stretches: F is that of the mounted one over that of the free one.
        self._free_length = 1 - mounting.prestrain
        self._strain = _strain_of(self.displacement, radius) / self._free_length
        self._linear = np.stack([np.broadcast_to(each[0], radius.shape) for each in self.pressure.basis], axis=-1)
        self._moved = self.displacement.element_dofs.T
        self._squeezed = self.pressure.element_dofs.T + self.displacement.N

    # -- places -------------------------------------------------------------------------------------
    @cached_property
    def free(self) -> Numbers:
        """Unknowns that are not held, (n,) int64."""
        basis, shape = self.displacement, self.shape
        radius, height = basis.doflocs
        radial = np.zeros(basis.N, bool)
        for unknowns, (function, *_) in zip(basis.element_dofs, basis.basis, strict=True):
            radial[unknowns] = bool(np.any(function[0]))
        held = radial & (radius < _ROUNDING)
        if shape.rim and self.mounting.soft_glue is None:
            inside = (radius > 1 - _ROUNDING) & (radius < 1 + shape.glue + _ROUNDING)
            held |= inside & (height < _ROUNDING)
        elif not shape.rim:
            held |= radius > 1 - _ROUNDING
        return np.concatenate([np.flatnonzero(~held), np.arange(basis.N, self.size)])

    @cached_property
    def upper_face(self) -> Numbers:
        """Facets of the upper face, (n,) int64."""
        return self._facets(self.shape.thickness, float(self.mesh.p[0].max()))

    @cached_property
    def opening(self) -> Numbers:
        """Facets of the lower face over the opening, (n,) int64."""
        return self._facets(0.0, 1.0)

    def _facets(self, height: float, within: float, beyond: float = 0.0) -> Numbers:
        facets = self.mesh.boundary_facets()
        middle = self.mesh.p[:, self.mesh.facets[:, facets]].mean(axis=1)
        chosen = (np.abs(middle[1] - height) < _ROUNDING) & (middle[0] < within) & (middle[0] > beyond)
        return np.asarray(facets[chosen], np.int64)

    @cached_property
    def glue(self) -> Block | None:
        """Stiffness of a soft layer of glue under the rim, beside the elastic energy; None of a rigid one."""
        if self.mounting.soft_glue is None:
            return None
        facets = self._facets(0.0, 1 + self.shape.glue, 1.0)
        basis = skfem.FacetBasis(self.mesh, self.displacement.elem, facets=facets, intorder=5)
        area = 2 * np.pi * basis.global_coordinates()[0] * basis.dx
        functions = np.stack([np.broadcast_to(each[0], (2, *area.shape)) for each in basis.basis])
        stiffness = np.array(self.mounting.soft_glue)
        values = np.einsum("iaeq,a,jaeq,eq->eij", functions, stiffness, functions, area)
        unknowns = np.asarray(basis.element_dofs.T, np.int64)
        return Block(values, unknowns, unknowns)

    @cached_property
    def patch(self) -> Array:
        """Mean upward displacement of the soft patch per unknown, (n,) float64."""
        facets = self._facets(self.shape.thickness, self.shape.contact)
        basis = skfem.FacetBasis(self.mesh, self.displacement.elem, facets=facets, intorder=5)
        area = 2 * np.pi * basis.global_coordinates()[0] * basis.dx
        load = np.zeros(self.size)
        for unknowns, (function, *_) in zip(basis.element_dofs, basis.basis, strict=True):
            np.add.at(load, unknowns, (area * function[1]).sum(axis=-1))
        return load / (np.pi * self.shape.contact**2)

    # -- elasticity ---------------------------------------------------------------------------------
    def strain(self, state: Array) -> Strain | None:
        """Deformation of a state, (n,) float64; None where an element is turned inside out."""
        gradient = np.einsum("eqai,ei->eqa", self._strain, state[self._moved])
        gradient[..., [0, 3, 4]] += 1 / self._free_length
        rr, rz, zr, zz, hoop = np.moveaxis(gradient, -1, 0)
        plane = rr * zz - rz * zr
        if not ((plane > 0).all() and (hoop > 0).all()):
            return None
        inverse = np.stack([zz / plane, -zr / plane, -rz / plane, rr / plane, 1 / hoop], axis=-1)
        pressure = np.einsum("eqi,ei->eq", self._linear, state[self._squeezed])
        return Strain(gradient, inverse, plane * hoop, pressure)

    def residual(self, strain: Strain) -> Array:
        """Derivative of the elastic energy in all unknowns, (n,) float64."""
        stress = self.shear * strain.gradient + (strain.pressure - self.shear)[..., None] * strain.inverse
        excess = np.log(strain.dilation) - strain.pressure / self.bulk
        total = np.zeros(self.size)
        np.add.at(total, self._moved, np.einsum("eqai,eqa->ei", self._strain, stress * self.weight[..., None]))
        np.add.at(total, self._squeezed, np.einsum("eqi,eq->ei", self._linear, excess * self.weight))
        return total

    def tangent(self, strain: Strain) -> list[Block]:
        """Second derivative of the elastic energy, as element matrices."""
        inverse, weight = strain.inverse, self.weight
        modulus = np.zeros((*weight.shape, 5, 5))
        factor = self.shear - strain.pressure
        plane = inverse[..., :4].reshape(*weight.shape, 2, 2)
        # d(F^-T)_iJ = -(F^-T)_iL dF_kL (F^-T)_kJ
        turned = np.einsum("eqil,eqkj->eqijkl", plane, plane).reshape(*weight.shape, 4, 4)
        modulus[..., :4, :4] = factor[..., None, None] * turned
        modulus[..., 4, 4] = factor * inverse[..., 4] ** 2
        modulus[..., range(5), range(5)] += self.shear
        count, places, _, functions = self._strain.shape
        across = self._strain.reshape(count, places * 5, functions).swapaxes(1, 2)
        stiffness = across @ ((modulus * weight[..., None, None]) @ self._strain).reshape(count, places * 5, functions)
        dilation = np.einsum("eqa,eqai->eiq", inverse * weight[..., None], self._strain)
        volume = (self._linear * (-weight / self.bulk)[..., None]).swapaxes(1, 2) @ self._linear
        mixed = Block(dilation @ self._linear, self._moved, self._squeezed)
        return [
            Block(stiffness, self._moved, self._moved),
            mixed,
            mixed.transposed,
            Block(volume, self._squeezed, self._squeezed),
        ]

    def largest(self, strain: Strain) -> tuple[float, float]:
        """Largest principal stretch, a ratio, and largest principal Cauchy stress, in E, away from the glue's edges."""
        plane = strain.gradient[..., :4].reshape(*self.weight.shape, 2, 2)
        left = np.linalg.eigvalsh(plane @ plane.swapaxes(-1, -2))[..., 1]
        square = np.maximum(left, strain.gradient[..., 4] ** 2)
        stress = (self.shear * (square - 1) + strain.pressure) / strain.dilation
        radius, height = self.displacement.global_coordinates()
        edges = (1.0, 1 + self.shape.glue) if self.shape.rim else (1.0,)
        far = np.all([np.hypot(radius - edge, height) > NEAR_GLUE * self.shape.thickness for edge in edges], axis=0)
        if not self.shape.rim:
            far &= np.hypot(radius - 1, height - self.shape.thickness) > NEAR_GLUE * self.shape.thickness
        return float(np.sqrt(square[far].max())), float(stress[far].max())


def _strain_of(basis: skfem.CellBasis, radius: Array) -> Array:
    """Derivatives of the shape functions as components of F - 1, (n_element, n_place, 5, n_function)."""
    columns = []
    for function, *_ in basis.basis:
        slope, value = function.grad, np.asarray(function)
        columns.append(np.stack([slope[0, 0], slope[0, 1], slope[1, 0], slope[1, 1], value[0] / radius], axis=-1))
    return np.stack(columns, axis=-1)


def _corners(shape: DiscShape, refinement: int) -> tuple[Array, Array]:
    """Corners of the rectangles along r and along z, ascending."""
    thickness = shape.thickness
    largest = max(thickness, _RADIAL_SCALE) / (refinement + 1)
    along = thickness / (refinement + 1)
    finest = thickness * 0.5 ** (refinement + 2)
    at_patch = min(_AT_PATCH * thickness, largest)
    inner = graded_from_both(shape.contact, largest, at_patch, largest)
    parts = [inner, shape.contact + graded_from_both(1 - shape.contact, at_patch, finest, largest)[1:]]
    if shape.rim:
        last = along if shape.glue == shape.rim else finest
        parts.append(1 + graded_from_both(shape.glue, finest, last, largest)[1:])
        if shape.glue < shape.rim:
            free = graded_from_both(shape.rim - shape.glue, finest, largest, largest)
            parts.append(1 + shape.glue + free[1:])
    top = along if shape.rim else finest
    return np.concatenate(parts), graded_from_both(thickness, finest, top, along)
