"""Rigid bodies that touch a face of a disc without friction, by multipliers: what they touch they do not enter.

A multiplier for each corner on the face is the contact pressure per relaxed area, linear between corners. With N its
shape function and g the distance of the face's points from the body, the mean gaps

    G = integral of N g 2 pi R dR,    G >= 0, pressure >= 0, pressure times G = 0

hold exactly at convergence. The set of touching corners is found together with the displacements, by Newton's method
(Hueber and Wohlmuth, Comput. Methods Appl. Mech. Eng. 194 (2005) 3147).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
import skfem

from acoustic_fem.membrane.finite_elasticity import Block, Numbers, Section
from geometry.ground.typed import Array


class Distance(NamedTuple):
    """Distance of points from a rigid body and its derivatives."""

    value: Array
    """Distance, below 0 inside the body; same shape as the points, float64."""
    normal: Array
    """Its gradient in r and z, (..., 2) float64."""
    curvature: Array
    """Its second derivatives, (..., 2, 2) float64."""


class RigidBody(Protocol):
    """A body by the distance of points from it."""

    def distance(self, radius: Array, height: Array) -> Distance:
        """Distance of points from the body; coordinates in a, z along the outer normal of the disc."""


@dataclass(frozen=True)
class Punch:
    """Body of revolution above the disc: a flat end with a round edge. Without a flat end it is a sphere."""

    flat: float
    """Radius of the flat end, in a; 0 for a sphere."""
    edge: float
    """Radius of the edge, or of the sphere, in a."""
    lowest: float
    """Height of its lowest point, in a."""

    def distance(self, radius: Array, height: Array) -> Distance:
        """Distance of points from the punch: that from its flat disc, less the radius of its edge."""
        beside = np.maximum(radius - self.flat, 0.0)
        below = height - (self.lowest + self.edge)
        away = np.hypot(beside, below)
        normal = np.stack([beside, below], axis=-1) / away[..., None]
        curvature = (np.eye(2) - normal[..., :, None] * normal[..., None, :]) / away[..., None, None]
        if self.flat:
            curvature = np.where((beside > 0)[..., None, None], curvature, 0.0)
        return Distance(away - self.edge, normal, curvature)


@dataclass(frozen=True)
class Floor:
    """Flat floor of the cavity."""

    depth: float
    """Depth below the relaxed lower face, in a."""

    def distance(self, radius: Array, height: Array) -> Distance:
        """Height of points above the floor."""
        normal = np.zeros((*radius.shape, 2))
        normal[..., 1] = 1.0
        return Distance(height + self.depth, normal, np.zeros((*radius.shape, 2, 2)))


class Gaps(NamedTuple):
    """Mean gaps of a face and their derivatives."""

    mean: Array
    """Gaps times areas by corner, (n_corner,) float64."""
    gradient: Block
    """Their derivatives: rows are corners, columns displacements."""
    curvature: Block
    """Second derivatives of minus the sum of pressures times gaps."""
    force: float
    """Vertical force of the pressures on the body, in E a^2, upwards."""
    moved: Array
    """Derivative of the mean gaps by corner as the body goes down, (n_corner,) float64."""
    turned: Array
    """Derivative of minus the sum of pressures times gaps in displacements and the way down, (n,) float64."""
    stiffness: float
    """Second derivative of minus that sum in the way down."""


class Face:
    """Horizontal face of a disc that a rigid body may touch.

    Args:
        section: the disc.
        facets: facets of the face, (n,) int64.
    """

    def __init__(self, section: Section, facets: Numbers) -> None:
        mesh = section.mesh
        basis = skfem.FacetBasis(mesh, section.displacement.elem, facets=facets, intorder=7)
        linear = skfem.FacetBasis(mesh, skfem.ElementQuad1(), facets=facets, intorder=7)
        self.radius, self.height = np.asarray(basis.global_coordinates())
        self.length = basis.dx
        values = [np.asarray(function) for function, *_ in basis.basis]
        slopes = [function.grad[:, 0] for function, *_ in basis.basis]
        self.moved = np.stack(values, axis=-1).transpose(1, 2, 0, 3)
        self.stretched = np.stack(slopes, axis=-1).transpose(1, 2, 0, 3)
        self.unknowns = basis.element_dofs.T
        corners = np.unique(mesh.facets[:, facets])
        corners = corners[np.argsort(mesh.p[0, corners])]
        self.corners = mesh.p[0, corners]
        number = np.full(linear.N, -1)
        number[linear.nodal_dofs[0][corners]] = np.arange(len(corners))
        owner = number[linear.element_dofs.T]
        shape = np.stack([np.broadcast_to(each, self.radius.shape) for each, *_ in linear.basis], axis=-1)
        self._shape = np.where(owner[:, None] >= 0, shape, 0.0)
        self._owner = np.maximum(owner, 0)
        self._ring = 2 * np.pi * self.radius * self.length
        self.area = self._corner_sums(np.ones_like(self._ring))
        self._size = section.size

    def _corner_sums(self, values: Array) -> Array:
        total = np.zeros(len(self.corners))
        np.add.at(total, self._owner, np.einsum("eq,eqk->ek", self._ring * values, self._shape))
        return total

    def positions(self, state: Array) -> tuple[Array, Array]:
        """Radius and height of the deformed face at its quadrature points, (n_facet, n_place) float64 each."""
        radial, axial = np.einsum("eqai,ei->aeq", self.moved, state[self.unknowns])
        return self.radius + radial, self.height + axial

    def gaps(self, state: Array, pressure: Array, body: RigidBody) -> Gaps:
        """Gaps between the deformed face and a body.

        Args:
            state: unknowns of the section, (n,) float64.
            pressure: contact pressures by corner, (n_corner,) float64.
            body: the rigid body.
        """
        distance, normal, curvature = body.distance(*self.positions(state))
        pressing = self._ring * np.einsum("eqk,ek->eq", self._shape, pressure[self._owner])
        along = np.einsum("eqa,eqai->eqi", normal, self.moved)
        gradient = np.einsum("eq,eqk,eqi->eki", self._ring, self._shape, along, optimize=True)
        bent = np.einsum("eq,eqai,eqab,eqbj->eij", -pressing, self.moved, curvature, self.moved, optimize=True)
        turned = np.zeros(self._size)
        np.add.at(turned, self.unknowns, np.einsum("eq,eqa,eqai->ei", -pressing, curvature[..., 1], self.moved))
        return Gaps(
            mean=self._corner_sums(distance),
            gradient=Block(gradient, self._owner, self.unknowns),
            curvature=Block(bent, self.unknowns, self.unknowns),
            force=-float((pressing * normal[..., 1]).sum()),
            moved=self._corner_sums(normal[..., 1]),
            turned=turned,
            stiffness=-float((pressing * curvature[..., 1, 1]).sum()),
        )


class Volume(NamedTuple):
    """Volume that the lower face has swept outwards, and its derivatives."""

    value: float
    """Volume, in a^3."""
    gradient: Array
    """Its derivative in the unknowns, (n,) float64."""
    curvature: Block
    """Its second derivative."""


def swept_volume(opening: Face, state: Array) -> Volume:
    """Volume between the relaxed and the deformed lower face over the opening, outwards.

    V = 2 pi int u_z (R + u_r) (1 + du_r/dR) dR: the edge of the opening does not move.

    Args:
        opening: lower face over the opening.
        state: unknowns of the section, (n,) float64.
    """
    local = state[opening.unknowns]
    parts = np.concatenate([opening.moved[:, :, ::-1], opening.stretched[:, :, :1]], axis=2)
    axial, radial, slope = np.einsum("eqai,ei->aeq", parts, local)
    ring, wide, place = 2 * np.pi * opening.length, 1 + slope, opening.radius + radial
    slopes = np.stack([place * wide, axial * wide, axial * place], axis=-1)
    second = np.zeros((*axial.shape, 3, 3))
    for row, column, value in ((0, 1, wide), (0, 2, place), (1, 2, axial)):
        second[..., row, column] = second[..., column, row] = value
    gradient = np.zeros_like(state)
    np.add.at(gradient, opening.unknowns, np.einsum("eq,eqa,eqai->ei", ring, slopes, parts))
    curvature = np.einsum("eq,eqai,eqab,eqbj->eij", ring, parts, second, parts, optimize=True)
    return Volume(
        float((ring * axial * place * wide).sum()), gradient, Block(curvature, opening.unknowns, opening.unknowns)
    )
