"""The half section of a disc in rectangles: their sizes, and the matrices of axisymmetric elasticity on them.

Displacements are quadratic and pressures linear along r and along z (Q2-Q1). Since every element is a rectangle, a
matrix over a block of elements is a sum of products of a matrix along r and one along z, which is cheap to make.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csc_array

from geometry.ground.typed import Array

#: Radial steps are at most max(thickness, this) / refinement.
_RADIAL_SCALE = 0.1

#: Gauss points on 0 to 1 and their weights: exact for polynomials of degree 5.
_PLACES = (np.polynomial.legendre.leggauss(3)[0] + 1) / 2
_WEIGHTS = np.polynomial.legendre.leggauss(3)[1] / 2

Indices = NDArray[np.int32]


class _Functions(NamedTuple):
    """Shape functions on 0 to 1, or their derivatives."""

    values: Array
    """Values at the Gauss points, (place, function)."""
    derivative: int
    """Order of the derivative."""


_VALUE = _Functions(
    np.stack([(1 - _PLACES) * (1 - 2 * _PLACES), 4 * _PLACES * (1 - _PLACES), _PLACES * (2 * _PLACES - 1)], axis=1), 0
)
_SLOPE = _Functions(np.stack([4 * _PLACES - 3, 4 - 8 * _PLACES, 4 * _PLACES - 1], axis=1), 1)
_LINEAR = _Functions(np.stack([1 - _PLACES, _PLACES], axis=1), 0)


@dataclass(frozen=True)
class DiscShape:
    """Dimensionless numbers on which the solution depends."""

    thickness: float
    """Thickness h / a, a ratio."""
    poisson_ratio: float
    """Poisson's ratio, above 0, below 1/2."""
    rim: float
    """Width of the rim / a, a ratio. 0: the lateral face r = 1 is clamped; above 0: the disc reaches to r = 1 + rim and
    its lower face is held on 1 < r < 1 + glue, all other faces are free.
    """
    glue: float
    """Width of the held annulus / a, a ratio, at most rim; ignored if rim is 0."""
    prestress: float
    """Equi-biaxial stress in the plane / E, a ratio, uniform."""
    contact: float
    """Radius of the patch in the middle of the upper face / a, a ratio."""
    raised: tuple[float, float, float] | None = None
    """Inner radius, outer radius and height above the disc's upper face of a thicker part, all / a: a boss from the
    axis, (0, b, height) with contact <= b <= 1, or a rim, (1, 1 + rim, height). Only where the prestress is 0.
    """


@dataclass(frozen=True)
class Mounting:
    """Strain and glue with which a disc is mounted."""

    prestrain: float = 0.0
    """Strain of a disc that was too small for its rim, the same in all directions, a ratio; negative of one that was
    too large. Free of stress it would be shorter by this fraction."""
    soft_glue: tuple[float, float] | None = None
    """Stiffness of the layer of glue under the rim by its area, along it and across it, in E / a; None: rigid."""


#: A disc that fits, on rigid glue.
FITTING = Mounting()


class Matrices(NamedTuple):
    """Matrices of the free unknowns: displacements along r, then along z, then pressures."""

    system: Any
    """Stiffness and volume change, (n, n) symmetric sparse; positive definite on displacements, negative on pressures,
    and so regular in any order of elimination.
    """
    mass: Any
    """Inertia, (n, n) symmetric sparse, 0 on pressures."""
    geometric: Any
    """Part of the pre-stress in the stiffness, (n, n) symmetric sparse."""


@dataclass(frozen=True, eq=False)
class HalfSection:
    """Rectangles over the half section of a disc, graded towards singular stresses, and the unknowns on their nodes.

    Nodes lie at corners and in the middle between them; node 2 k is corner k.
    """

    shape: DiscShape
    """The disc."""
    radii: Array
    """Corners along r, (n_radius,) float64, ascending, ratios to a."""
    heights: Array
    """Corners along z, (n_height,) float64, ascending, ratios to a."""
    blocks: tuple[tuple[slice, slice], ...]
    """Elements along r and along z of the disc and of a part that is raised above it."""

    # -- unknowns ---------------------------------------------------------------------------------
    @cached_property
    def _unknowns(self) -> tuple[Indices, Indices, Indices, int]:
        """Numbers of the displacements along r and along z by node, of the pressures by corner, and how many are free.

        Those that are held, and nodes outside the disc, have the number behind the last free one.
        """
        size = 2 * len(self.radii) - 1, 2 * len(self.heights) - 1
        inside = np.zeros(size, bool)
        for along_r, along_z in self.blocks:
            inside[2 * along_r.start : 2 * along_r.stop + 1, 2 * along_z.start : 2 * along_z.stop + 1] = True
        free = inside.copy()
        edge = 2 * self._radial(1.0)
        if self.shape.rim:
            free[edge : 2 * self._radial(1 + self.shape.glue) + 1, 0] = False
        else:
            free[edge] = False
        off_axis = free.copy()
        off_axis[0] = False
        numbers, first = [], 0
        for each in (off_axis, free, inside[::2, ::2]):
            last = first + int(np.count_nonzero(each))
            number = np.full(each.shape, -1, np.int32)
            number[each] = np.arange(first, last)
            numbers.append(number)
            first = last
        radial, axial, pressure = (np.where(number < 0, np.int32(first), number) for number in numbers)
        return radial, axial, pressure, first

    @property
    def unknowns(self) -> int:
        """Number of free unknowns."""
        return self._unknowns[-1]

    def _radial(self, radius: float) -> int:
        """Number of elements along r within a radius."""
        return int(np.count_nonzero((self.radii[1:] + self.radii[:-1]) / 2 < radius))

    # -- faces ------------------------------------------------------------------------------------
    @cached_property
    def opening(self) -> tuple[Indices, Array]:
        """Axial unknowns of the lower face over the opening, (n,) int32, outwards, and their radii, (n,) float64."""
        return self._face(0.0, 1.0, 0)

    @cached_property
    def patch(self) -> tuple[Indices, Array]:
        """Axial unknowns of the patch in the middle of the upper face, outwards, and their radii; as :attr:`opening`,
        (n,) int32 and (n,) float64.
        """
        middle = self.blocks[-1] if self.blocks[-1][0].start == 0 else self.blocks[0]
        return self._face(0.0, self.shape.contact, middle[1].stop)

    def _face(self, inner: float, outer: float, height: int) -> tuple[Indices, Array]:
        """Axial unknowns of a horizontal face at a corner along z, outwards, and their radii."""
        nodes = slice(2 * self._radial(inner), 2 * self._radial(outer) + 1)
        return self._unknowns[1][nodes, 2 * height], _nodes(self.radii)[nodes]

    def loads(self) -> Array:
        """Forces of a unit pressure on the lower face over the opening, of a unit force on the patch and of a unit
        pressure on the whole upper face, all outwards; (n, 3).
        """
        loads = np.zeros((self.unknowns + 1, 3))
        nodes, radii = self.opening
        loads[nodes, 0] = _ring_areas(radii)
        nodes, radii = self.patch
        loads[nodes, 1] = _ring_areas(radii) / (np.pi * self.shape.contact**2)
        reach, top = float(self.radii[-1]), self.blocks[0][1].stop
        start, end, _ = self.shape.raised or (0.0, 0.0, 0.0)
        faces = [(0.0, start, top), (start, end, len(self.heights) - 1), (end, reach, top)]
        for inner, outer, height in faces:
            if self._radial(outer) > self._radial(inner):
                nodes, radii = self._face(inner, outer, height)
                loads[nodes, 2] += _ring_areas(radii)
        if self.shape.raised is not None and end != 1:  # a boss as wide as a clamped disc has no wall that moves
            wall = 2 * self._radial(end if start == 0 else start)
            levels = _nodes(self.heights)[2 * top :]
            areas = 2 * np.pi * (end if start == 0 else -start) * _lengths(levels)
            loads[self._unknowns[0][wall, 2 * top :], 2] += areas
        return loads[:-1]

    # -- matrices ---------------------------------------------------------------------------------
    def matrices(self) -> Matrices:
        """Matrices of the disc: elasticity with pre-stress, inertia, and the part of the pre-stress."""
        ratio, prestress = self.shape.poisson_ratio, self.shape.prestress
        shear = 1 / (2 * (1 + ratio))
        bulk_compliance = (1 + ratio) * (1 - 2 * ratio) / ratio
        radial, axial, pressure, _ = self._unknowns
        system, mass, geometric = (_Sum(self.unknowns) for _ in range(3))
        for along_r, along_z in self.blocks:
            r, z = (
                _Line(corners[own.start : own.stop + 1])
                for corners, own in ((self.radii, along_r), (self.heights, along_z))
            )
            nodes = (
                slice(2 * along_r.start, 2 * along_r.stop + 1),
                slice(2 * along_z.start, 2 * along_z.stop + 1),
            )
            corners = slice(along_r.start, along_r.stop + 1), slice(along_z.start, along_z.stop + 1)
            u, w, p = radial[nodes], axial[nodes], pressure[corners]
            value, slope, linear = _VALUE, _SLOPE, _LINEAR
            # strains du/dr, u/r, dw/dz and du/dz + dw/dr; their sum without the last is the dilation
            across = r.product(value, value, r.places)
            stretch = r.product(slope, slope, r.places) + r.product(value, value, 1 / r.places)
            tilt = r.product(slope, slope, r.places)
            flat, steep = z.product(value, value), z.product(slope, slope)
            system.add(u, u, [((2 * shear + prestress) * stretch, flat), (shear * across, steep)])
            system.add(w, w, [(2 * shear * across, steep), ((shear + prestress) * tilt, flat)])
            mixed = [(shear * r.product(value, slope, r.places), z.product(slope, value))]
            system.add(u, w, mixed, symmetric=True)
            dilation = r.product(linear, slope, r.places) + r.product(linear, value)
            system.add(p, u, [(-dilation, z.product(linear, value))], symmetric=True)
            system.add(p, w, [(-r.product(linear, value, r.places), z.product(linear, slope))], symmetric=True)
            volume = r.product(linear, linear, r.places), z.product(linear, linear)
            system.add(p, p, [(-bulk_compliance * volume[0], volume[1])])
            for each in (u, w):
                mass.add(each, each, [(across, flat)])
            if prestress:
                geometric.add(u, u, [(prestress * stretch, flat)])
                geometric.add(w, w, [(prestress * tilt, flat)])
        return Matrices(system.matrix(), mass.matrix(), geometric.matrix())


class _Line:
    """Elements along r or z, and integrals of products of shape functions over them."""

    def __init__(self, corners: Array) -> None:
        self._steps = np.diff(corners)
        self.places = corners[:-1, None] + self._steps[:, None] * _PLACES
        """Places where the integrands are evaluated, (element, place)."""

    def product(self, left: _Functions, right: _Functions, weight: Array | float = 1.0) -> Array:
        """Integrals of products of two kinds of shape functions times a weight, (element, function, function)."""
        scaled = _WEIGHTS * (self._steps ** (1 - left.derivative - right.derivative))[:, None] * weight
        result: Array = np.einsum("eq,qa,qb->eab", scaled, left.values, right.values)
        return result


class _Sum:
    """Sparse matrix as a sum of products of matrices along r and along z."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._parts: list[tuple[Indices, Indices, Array]] = []

    def add(
        self, rows: Indices, columns: Indices, terms: Sequence[tuple[Array, Array]], symmetric: bool = False
    ) -> None:
        """Add products of integrals along r and along z.

        Args:
            rows: unknowns of the first shape functions by node.
            columns: of the second.
            terms: integrals along r and along z by element; equally many functions in all.
            symmetric: add the transpose too.
        """
        (r, r_left, r_right), (z, z_left, z_right) = (_joined([term[axis] for term in terms]) for axis in (0, 1))
        places = rows[r_left[:, None], z_left], columns[r_right[:, None], z_right]
        values = r.T @ z
        self._parts.append((*places, values))
        if symmetric:
            self._parts.append((*places[::-1], values))

    def matrix(self) -> Any:
        """The matrix over the circle; rows and columns of unknowns that are held are left out."""
        size = self._size + 1
        if not self._parts:
            return csc_array((self._size, self._size))
        rows, columns, values = (
            np.concatenate([each.ravel() for each in part]) for part in zip(*self._parts, strict=True)
        )
        whole = coo_array((2 * np.pi * values, (rows, columns)), shape=(size, size)).tocsc()
        return whole[:-1, :-1]


def _joined(integrals: Sequence[Array]) -> tuple[Array, Indices, Indices]:
    """Entries of matrices along a line with the same functions, (term, entry), and their rows and columns.

    Neighbouring elements share a node: their two entries for it are added.
    """
    local = np.stack(integrals)
    _, elements, left, right = local.shape
    local[:, 1:, 0, 0] += local[:, :-1, -1, -1]
    first = np.arange(elements)[:, None, None]
    rows = np.broadcast_to((left - 1) * first + np.arange(left)[:, None], local.shape[1:])
    columns = np.broadcast_to((right - 1) * first + np.arange(right), local.shape[1:])
    kept = np.ones(local.shape[1:], bool)
    kept[:-1, -1, -1] = False
    return local[:, kept], rows[kept], columns[kept]


# -- sizes ------------------------------------------------------------------------------------------
def half_section(shape: DiscShape, refinement: int) -> HalfSection:
    """Half section of a disc in rectangles, graded towards the edges of the clamp, of the patch and of a raised part,
    where stresses are singular.

    Args:
        shape: the disc.
        refinement: steps per thickness; the smallest step at the edge of the clamp is 4^-(refinement + 1) thickness.
    """
    thickness, rim, contact = shape.thickness, shape.rim, shape.contact
    start, end, height = shape.raised or (0.0, 0.0, 0.0)
    finest = min(thickness, 1.0) * 0.5 ** (2 * refinement + 2)
    radial = max(thickness, _RADIAL_SCALE) / refinement
    boss = end if height and start == 0 else 0.0
    at_patch = min(contact, 1 - contact, thickness) / refinement
    if contact < boss:
        at_patch = min(at_patch, (boss - contact) / refinement)
    # between radii where something ends: from radius to radius with the smallest step at each
    edges = {contact: at_patch}
    if boss:
        edges[boss] = min(edges.get(boss, finest), finest)
    edges[1.0] = finest
    first = min(edges)
    parts = [first - _graded(first, edges[first], radial)[::-1]]
    for inner, outer in pairwise(sorted(edges)):
        parts.append(inner + graded_from_both(outer - inner, edges[inner], edges[outer], radial)[1:])
    if rim and shape.glue < rim:
        parts.append(1 + graded_from_both(shape.glue, finest, finest, radial)[1:])
        parts.append(1 + shape.glue + _graded(rim - shape.glue, finest, radial)[1:])
    elif rim:
        parts.append(1 + _graded(rim, finest, radial)[1:])
    radii = np.concatenate(parts)
    at_top = finest if height else at_patch if rim else finest
    heights = graded_from_both(thickness, finest, at_top, thickness / refinement)
    blocks = [(slice(0, len(radii) - 1), slice(0, len(heights) - 1))]
    if height:
        at_patch = min(at_patch, height) if boss < 1 else finest
        above = graded_from_both(height, finest, at_patch, max(thickness, height) / refinement)
        middles = (radii[1:] + radii[:-1]) / 2
        inside = np.flatnonzero((middles > start) & (middles < end))
        along_r = slice(int(inside[0]), int(inside[-1]) + 1)
        blocks.append((along_r, slice(len(heights) - 1, len(heights) + len(above) - 2)))
        heights = np.concatenate([heights, thickness + above[1:]])
    return HalfSection(shape, radii, heights, tuple(blocks))


def _graded(length: float, first: float, largest: float) -> Array:
    """Nodes from 0 to length: steps double from ``first`` up to ``largest``."""
    steps = [first]
    while sum(steps) < length:
        steps.append(min(2 * steps[-1], largest))
    return _stretched(steps, length)


def graded_from_both(length: float, first: float, last: float, largest: float) -> Array:
    """Nodes from 0 to length, (n,) float64: steps double from both ends up to ``largest``."""
    front, back = [first], [last]
    while sum(front) + sum(back) < length:
        shorter = front if front[-1] <= back[-1] else back
        shorter.append(min(2 * shorter[-1], largest))
    return _stretched([*front, *back[::-1]], length)


def _stretched(steps: list[float], length: float) -> Array:
    nodes = np.concatenate([[0.0], np.cumsum(steps)])
    result: Array = nodes * (length / nodes[-1])
    result[-1] = length
    return result


def _nodes(corners: Array) -> Array:
    """Corners and the middles between them, ascending."""
    nodes = np.empty(2 * len(corners) - 1)
    nodes[::2] = corners
    nodes[1::2] = (corners[1:] + corners[:-1]) / 2
    return nodes


def _ring_areas(radius: Array) -> Array:
    """2 pi times integrals of N r dr for quadratic shape functions."""
    result: Array = 2 * np.pi * radius * _lengths(radius)
    return result


def _lengths(place: Array) -> Array:
    """Weights of Simpson's rule for nodes corner, middle, corner, ...: exact for cubics, so for N r."""
    steps = place[2::2] - place[:-2:2]
    weights = np.zeros_like(place)
    weights[:-2:2] += steps / 6
    weights[1::2] += 4 * steps / 6
    weights[2::2] += steps / 6
    return weights
