r"""The thermal field of a cylinder with round bores, by sections: no mesh of the body is needed.

In the cavity the field is that of a closed cylinder, axisymmetric, and in a bore that of a long one. Both are solved by
quadratic finite elements of their own section, graded to the walls, which leave less than 1e-5 of the mean.

An opening is a hole in a cold wall. The field is linear there, with the slope g, and reaches into it; by reciprocity
that adds :math:`c\, a^3 g^2 / s` to its integral, s = j w / alpha, as for the potential at a small hole in a conductor
(H. A. Bethe, Phys. Rev. 66 (1944) 163). Where openings are wide against the layer the wall's cold air counts, not the
slope: :math:`c = c_0 / (1 + \epsilon a^2 s)` is fitted to fields of whole cells on meshes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import scipy.sparse as sp
import skfem
from numpy.typing import NDArray
from scipy.interpolate import RegularGridInterpolator

from acoustic_fem.fields.assembly import mass_matrix, stiffness_matrix
from acoustic_fem.fields.diffusion import field_coefficients, field_model
from acoustic_fem.numerics.rational_sweep import ReducedModel
from acoustic_fem.quantities.units import metres
from geometry.ground.typed import Array, ComplexArray

#: Elements from the middle to a wall; the one at the wall has at most this part of the thinnest layer.
_ELEMENTS, _AT_WALL = 14, 0.3
#: c_0 and epsilon.
_OPENING, _WIDE = 0.85, 0.06
#: Allowed error of the mean: in a^3 of every opening, part of the volume, and besides. Of 2e-4 besides two cells that
#: served to choose nothing were off by 1.2 and 1.4 times what is stated, against meshes that leave half as much.
_UNKNOWN, _ELSE = 0.3, 5e-4
#: Places that agree within this part of the extent are the same.
_SAME_PLACE = 1e-9
#: Poles of what openings add, and at how many frequencies they are fitted.
_POLES, _FITTED = 8, 40


@dataclass(frozen=True)
class SideBore:
    """A round bore beyond a wall of a cylinder."""

    radius: float
    """Radius, mm."""
    length: float
    """Mean length from the wall, mm."""
    height: float | None
    """Height of its axis, which meets that of the cylinder, mm; None for a bore along it, from the top."""


@dataclass(frozen=True)
class CylinderAir:
    """A cylinder about the z axis from z = 0 with bores beyond its walls."""

    radius: float
    """Radius, mm."""
    height: float
    """Height, mm."""
    bores: Sequence[SideBore]
    """Its bores, one at least."""

    @property
    def volumes(self) -> Array:
        """Volume of the cylinder, then of all bores, (2,) float64, mm^3."""
        bored = sum(bore.radius**2 * bore.length for bore in self.bores)
        return np.pi * np.array([self.radius**2 * self.height, bored])

    @property
    def mean_error(self) -> float:
        """Allowed error of the mean of its field, absolute."""
        return float(_ELSE + _UNKNOWN * sum(bore.radius**3 for bore in self.bores) / self.volumes.sum())

    def shortened(self, lengths: Sequence[float]) -> CylinderAir:
        """The same air without pieces of these lengths, mm, of its first bores."""
        left = [replace(bore, length=bore.length - gone) for bore, gone in zip(self.bores, lengths, strict=False)]
        return replace(self, bores=(*left, *self.bores[len(left) :]))


@dataclass(frozen=True, eq=False)
class CylinderField:
    """A field Psi = sum_k c_k(f) v_k of real v_k, as :class:`~acoustic_fem.fields.diffusion.DiffusionField`."""

    air: CylinderAir
    """The cavity and its bores."""
    section: skfem.CellBasis
    """Space of the cavity's section, distance from the axis and height, mm."""
    functions: Array
    """The v_k at its degrees of freedom, (n_dof, r) float64."""
    means: Array
    """Mean of every v_k over the cavity, then over all bores, (2, r) float64."""
    model: ReducedModel
    """Reduced model that gives the coefficients."""

    def mean(self, frequency: Array, diffusivity: float) -> ComplexArray:
        """Mean of the field over the body, (n_freq,) complex128.

        Args:
            frequency: (n_freq,) Hz.
            diffusivity: of heat, m^2/s.
        """
        return np.asarray(field_coefficients(self.model, frequency, diffusivity) @ self._over_all)

    def means_over(self, flow: skfem.CellBasis) -> Array:
        """Mean of every v_k over each element of a mesh of the body, or of a half of it, (r, n_element) float64.

        The mean over the body is kept exactly; layers thinner than the elements are met by chance.
        """
        x, y, z = np.asarray(flow.global_coordinates())
        volume, distance = flow.dx.sum(axis=1), np.hypot(x, y)
        outside = np.maximum(distance - self.air.radius, np.maximum(z - self.air.height, -z)).mean(axis=1) > 0
        place = np.clip(np.stack([distance, z], axis=-1), 0.0, [self.air.radius, self.air.height])
        axes, numbers = _tensor(self.section)
        values = RegularGridInterpolator(axes, self.functions[numbers], bounds_error=False, fill_value=None)(place)
        means = np.einsum("eqr,eq->re", values, flow.dx) / volume
        means[:, outside] = self.means[1][:, None]
        return np.asarray(means + (self._over_all - means @ volume / volume.sum())[:, None])

    @property
    def _over_all(self) -> Array:
        """Mean of every v_k over cavity and bores, (r,) float64."""
        return np.asarray(self.air.volumes @ self.means / self.air.volumes.sum())


def cylinder_field(air: CylinderAir, diffusivity: float, band: tuple[float, float]) -> CylinderField:
    """Solve the field over a band of frequencies.

    Args:
        air: the cavity and its bores, mm; the field is zero on all walls.
        diffusivity: of heat, m^2/s.
        band: lowest and highest frequency, Hz.
    """
    layer = float(np.sqrt(diffusivity / (np.pi * band[1]))) / metres(1.0)
    half = _graded(air.height / 2, layer)
    along = np.concatenate([air.height / 2 - half[:0:-1], air.height / 2 + half])
    rectangle = skfem.MeshQuad.init_tensor(_graded(air.radius, layer), along)
    section = skfem.Basis(rectangle, skfem.ElementQuad2(), intorder=5)
    at_wall = air.radius * (1 - 1e-9), half[-1] * (1 - 1e-9)
    walls = rectangle.facets_satisfying(lambda x: (x[0] > at_wall[0]) | (np.abs(x[1] - air.height / 2) > at_wall[1]))
    spaces = [(section, section.complement_dofs(section.get_dofs(walls)), 1.0)]
    for bore in air.bores:
        radii = skfem.Basis(skfem.MeshLine(_graded(bore.radius, layer)), skfem.ElementLineP2(), intorder=5)
        spaces.append((radii, np.flatnonzero(radii.doflocs[0] < bore.radius * (1 - 1e-9)), bore.length))
    stiffness, mass, load = [], [], []
    for basis, free, length in spaces:
        ring = 2 * np.pi * length * np.asarray(basis.global_coordinates())[0]
        whole = mass_matrix(basis, ring)
        stiffness.append(stiffness_matrix(basis, ring)[free][:, free])
        mass.append(whole[free][:, free])
        load.append(np.asarray(whole.sum(axis=1))[free])
    blocks = [sp.csr_array(sp.block_diag(part, format="csr")) for part in (stiffness, mass)]
    model, found = field_model(blocks[0], blocks[1], np.concatenate(load), diffusivity, band)
    ends = np.cumsum([0, *(len(free) for _, free, _ in spaces)])
    parts = [found[begin:end] for begin, end in pairwise(ends)]
    functions = np.zeros((section.N, found.shape[1]))
    functions[spaces[0][1]] = parts[0]
    integrals = [each @ part for each, part in zip(load, parts, strict=True)]
    means = np.stack([integrals[0], np.sum(integrals[1:], axis=0)]) / air.volumes[:, None]
    return _opened(CylinderField(air, section, functions, means, model), diffusivity)


def _opened(field: CylinderField, diffusivity: float) -> CylinderField:
    """The field with what its openings add, spread evenly over the body: a sum over poles on the negative axis of s."""
    air, model = field.air, field.model
    frequency = np.geomspace(model.lowest, model.highest, _FITTED)
    rate = 2j * np.pi * frequency * metres(1.0) ** 2 / diffusivity
    coefficients, added = field_coefficients(model, frequency, diffusivity), np.zeros_like(rate)
    for bore in air.bores:
        slope = coefficients @ (field.functions.T @ _slope_at(bore, field))
        added += _OPENING * bore.radius**3 / (1 + _WIDE * bore.radius**2 * rate) * slope**2 / rate
    poles = np.geomspace(np.abs(rate[0]) / 3, 3 * np.abs(rate[-1]), _POLES)
    terms = rate[:, None] / (rate[:, None] + poles)
    parts = np.vstack([terms.real, terms.imag]), np.concatenate([added.real, added.imag])
    shares = np.linalg.lstsq(*parts, rcond=1e-10)[0] / air.volumes.sum()
    bare, whole = model.matrices.shape[1], model.matrices.shape[1] + _POLES
    matrices = np.zeros((2, whole, whole))
    matrices[:, :bare, :bare] = model.matrices
    matrices[:, bare:, bare:] = np.diag(poles), np.eye(_POLES)
    return replace(
        field,
        functions=np.hstack([field.functions, np.broadcast_to(shares, (len(field.functions), _POLES))]),
        means=np.hstack([field.means, np.broadcast_to(shares, (2, _POLES))]),
        model=replace(
            model,
            matrices=matrices,
            excitations=np.concatenate([model.excitations, np.ones((1, _POLES, 1))], axis=1),
            basis=None,
        ),
    )


def _slope_at(bore: SideBore, field: CylinderField) -> Array:
    """Slope towards the wall, its mean over the opening of a bore, as a functional: (n_dof,) float64, 1/mm."""
    section, air = field.section, field.air
    part, weight = np.polynomial.legendre.leggauss(24)
    if bore.height is None:
        wall, end, along = 1, air.height, bore.radius * (1 + part) / 2
        weight = weight * along
    else:
        wall, end, along = 0, air.radius, bore.height + bore.radius * part
        weight = weight * np.sqrt(1 - part**2)
    axes, numbers = _tensor(section)
    numbers = numbers if wall == 0 else numbers.T
    shares = np.stack([np.interp(along, axes[1 - wall], node) for node in np.eye(len(axes[1 - wall]))]) @ weight
    # Within the element at the wall the field is a quadratic, and zero at its end.
    step, total = end - axes[wall][-2], np.zeros(section.N)
    total[numbers[-2]], total[numbers[-3]] = 2 / step * shares, -0.5 / step * shares
    return total / weight.sum()


def _tensor(section: skfem.CellBasis) -> tuple[list[Array], NDArray[np.int64]]:
    """Places of the degrees of freedom along both axes, mm, and their numbers there, (n_across, n_along) int64."""
    axes, steps = [], []
    for places in section.doflocs:
        ordered = np.sort(places)
        # Places that should be the same differ in the last bits.
        begins = np.diff(ordered, prepend=-np.inf) > _SAME_PLACE * ordered[-1]
        axes.append(ordered[begins])
        steps.append(np.searchsorted(axes[-1], places + _SAME_PLACE * ordered[-1], "right") - 1)
    return axes, np.lexsort((steps[1], steps[0])).reshape(len(axes[0]), len(axes[1]))


def _graded(extent: float, layer: float) -> Array:
    """Places from the middle, 0, to a wall, (n,) float64, mm: closer towards the wall where its layer is thin."""
    first, low, high = min(_AT_WALL * layer / extent, 1 / _ELEMENTS), 1.0, 3.0
    for _ in range(60):
        ratio = (low + high) / 2
        low, high = (ratio, high) if first * (ratio ** np.arange(_ELEMENTS)).sum() < 1 else (low, ratio)
    steps = ratio ** np.arange(_ELEMENTS)[::-1]
    places = np.concatenate([[0.0], np.cumsum(steps)])
    return np.asarray(extent * places / places[-1])
