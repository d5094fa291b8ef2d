"""Cross-sections of ducts by finite elements: mean viscous and thermal fields of any shape."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import scipy.sparse as sp
import skfem
from numpy.typing import ArrayLike, NDArray
from skfem.helpers import dot, grad

from acoustic_fem.duct.sections import Section
from acoustic_fem.numerics.rational_sweep import reduce_system
from geometry.ground.argument_checks import check_range, positive_numbers, unsuitable, wrong_type
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Wall layer sqrt(2/|s|) per element edge on the wall below which a meshed section warns.
RESOLVED_LAYER = 1.0


@dataclass(frozen=True, eq=False)
class MeshedSection(Section):
    """Any section, by quadratic elements on curved second-order triangles.

    Its whole boundary is wall. A circle of 96 triangles is within 0.014 % at low frequency; the error
    falls by 11 to 16 with each halving of the elements. Where the wall layer is thinner than an element edge on the
    wall, the error reaches 0.2 to 0.5 % and a warning says so.
    """

    points: Array
    """Places of the nodes, (n, 2) float64, m."""
    triangles: NDArray[np.int64]
    """Nodes of the triangles, (m, 6) int64: three corners, then the middles of edges 01, 12 and 20; turned
    counter-clockwise where they are not.
    """

    def __post_init__(self) -> None:
        points, triangles = np.asarray(self.points, dtype=np.float64), np.asarray(self.triangles)
        if points.ndim != 2 or points.shape[1] != 2 or not np.isfinite(points).all():
            raise wrong_type("points", f"has shape {points.shape}; it must be (n, 2) and finite")
        if triangles.ndim != 2 or triangles.shape[1] != 6 or not len(triangles):
            raise wrong_type("triangles", f"has shape {triangles.shape}; it must be (m, 6) with at least one row")
        if triangles.dtype.kind not in "iu" or triangles.min() < 0 or triangles.max() >= len(points):
            raise Refusal(f"must hold integers from 0 to {len(points) - 1}", kind=Kind.OUT_OF_RANGE, field="triangles")
        clockwise = _corner_areas(points[triangles]) < 0
        triangles = np.where(clockwise[:, None], triangles[:, [0, 2, 1, 5, 4, 3]], triangles).astype(np.int64)
        # counter-clockwise neighbours run along their common edge in opposite directions unless they overlap
        directed = triangles[:, [0, 1, 2]] * len(points) + triangles[:, [1, 2, 0]]
        _, first, times = np.unique(directed, return_index=True, return_counts=True)
        bad = np.asarray((_jacobians(points[triangles]) <= 0).any(axis=1))
        bad[first[times > 1] // 3] = True
        if bad.any():
            k = int(np.argmax(bad))
            x, y = points[triangles[k, :3]].mean(axis=0)
            raise unsuitable(
                "triangles", f"row {k} at ({x:g}, {y:g}) m is inverted, overlaps a neighbour or has no area"
            )
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "triangles", triangles)

    @classmethod
    def from_mesh(cls, mesh: skfem.MeshTri) -> MeshedSection:
        """The section of a scikit-fem ``MeshTri2`` (curved) or ``MeshTri1`` (straight), in m."""
        curved = skfem.MeshTri2.from_mesh(mesh) if not isinstance(mesh, skfem.MeshTri2) else mesh
        return cls(curved.doflocs.T, skfem.Dofs(curved, skfem.ElementTriP2()).element_dofs.T)

    @classmethod
    def circle(cls, radius: float, rings: int = 4) -> MeshedSection:
        """A circle of that radius, m, of 6 rings^2 triangles, its nodes on concentric circles."""
        positive_numbers("radius", radius, "m")
        return _from_map(_hexagon(_whole("rings", rings)), lambda hexagon: _disc(hexagon, radius))

    @classmethod
    def rectangle(cls, width: float, height: float, columns: int = 8, rows: int = 8) -> MeshedSection:
        """A rectangle of that width and height, m, of 2 columns rows triangles."""
        size = np.array([float(positive_numbers("width", width, "m")), float(positive_numbers("height", height, "m"))])
        mesh = skfem.MeshTri.init_tensor(
            np.linspace(0, 1, _whole("columns", columns) + 1), np.linspace(0, 1, _whole("rows", rows) + 1)
        )
        return _from_map((mesh.p.T, mesh.t.T), lambda unit: unit * size)

    @classmethod
    def triangle(cls, corners: ArrayLike, divisions: int = 8) -> MeshedSection:
        """A triangle with the given corners, (3, 2) float64 in m, of divisions^2 triangles."""
        places = np.asarray(corners, dtype=np.float64)
        if places.shape != (3, 2):
            raise Refusal(f"has shape {places.shape}; it must be (3, 2)", kind=Kind.WRONG_TYPE, field="corners")
        edges = np.stack([places[1] - places[0], places[2] - places[0]])
        return _from_map(_triangle_grid(_whole("divisions", divisions)), lambda unit: places[0] + unit @ edges)

    @property
    def area(self) -> float:
        """Area of the meshed section, m^2."""
        return self._discrete.area * self._extent**2

    def mean_field(self, rate: ComplexArray) -> ComplexArray:
        """Galerkin's mean <Psi> of the field: shape of the rate (1/m^2), complex128.

        All rates come from a few solves (:mod:`acoustic_fem.numerics.rational_sweep`, to 1e-9).
        """
        discrete = self._discrete
        rates = np.abs(np.asarray(rate)).ravel() * self._extent**2
        layer = np.sqrt(2 / rates.max())
        if layer < RESOLVED_LAYER * discrete.wall_edge:
            warn_caller(
                f"the wall layer of {layer * self._extent:.3g} m is thinner than the elements along the wall "
                f"({discrete.wall_edge * self._extent:.3g} m): refine the mesh",
            )

        def theta(rates: Array) -> ComplexArray:
            return np.column_stack([np.ones_like(rates), 1j * rates])

        def phi(rates: Array) -> ComplexArray:
            return np.ones((len(rates), 1), dtype=np.complex128)

        model = reduce_system(
            [discrete.stiffness, discrete.mass],
            theta,
            [discrete.load[:, None]],
            phi,
            (float(rates.min()), float(rates.max())),
            tolerance=1e-9,
        )
        response = model.response(theta(rates), phi(rates))[:, 0, 0]
        return (1j * rates * response / discrete.area).reshape(np.shape(rate))

    @cached_property
    def _extent(self) -> float:
        """Largest side of the bounding box, m: the unit of length of the solve."""
        return float(np.ptp(self.points, axis=0).max())

    @cached_property
    def _discrete(self) -> _Discrete:
        mesh = skfem.MeshTri2(self.points.T / self._extent, np.asarray(self.triangles, dtype=np.int64).T)
        basis = skfem.Basis(mesh, skfem.ElementTriP2(), intorder=6)
        inner = np.setdiff1d(np.arange(basis.N), basis.get_dofs().all())
        stiffness, mass = _stiffness.assemble(basis).tocsr(), _mass.assemble(basis).tocsr()
        ends = mesh.p[:, mesh.facets[:, mesh.boundary_facets()]]
        return _Discrete(
            stiffness=sp.csr_array(stiffness[inner][:, inner]),
            mass=sp.csr_array(mass[inner][:, inner]),
            load=np.asarray(mass @ np.ones(basis.N))[inner],
            area=float(mass.sum()),
            wall_edge=float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=0).max()),
        )


@dataclass(frozen=True, eq=False)
class _Discrete:
    """Matrices of the nodes off the wall; lengths in units of the largest extent."""

    stiffness: sp.csr_array
    mass: sp.csr_array
    load: Array
    area: float
    wall_edge: float


@skfem.BilinearForm
def _stiffness(u: Any, v: Any, _: Any) -> Any:
    return dot(grad(u), grad(v))


@skfem.BilinearForm
def _mass(u: Any, v: Any, _: Any) -> Any:
    return u * v


def _corner_areas(places: Array) -> Array:
    """Twice the signed areas of the straight triangles, (m,)."""
    one, two = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]
    return np.asarray(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0])


def _jacobians(places: Array) -> Array:
    """(m, 6) Jacobian determinants of second-order triangles (m, 6, 2) at their nodes."""
    nodes = np.array([[0, 0], [1, 0], [0, 1], [0.5, 0], [0.5, 0.5], [0, 0.5]])
    x, y = nodes.T
    zero = np.zeros(6)
    by_x = np.array([4 * (x + y) - 3, 4 * x - 1, zero, 4 - 8 * x - 4 * y, 4 * y, -4 * y])
    by_y = np.array([4 * (x + y) - 3, zero, 4 * y - 1, -4 * x, 4 * x, 4 - 4 * x - 8 * y])
    dx, dy = np.einsum("in,mic->mnc", by_x, places), np.einsum("in,mic->mnc", by_y, places)
    return np.asarray(dx[..., 0] * dy[..., 1] - dx[..., 1] * dy[..., 0])


def _from_map(reference: tuple[Array, NDArray[np.int64]], place: Callable[[Array], Array]) -> MeshedSection:
    """A straight mesh (points, corners) with its corners and edge middles moved by a smooth map."""
    points, corners = reference
    pairs = np.sort(corners[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, number = np.unique(pairs, axis=0, return_inverse=True)
    middles = points[edges].mean(axis=1)
    triangles = np.hstack([corners, len(points) + number.reshape(-1, 3)])
    return MeshedSection(place(np.vstack([points, middles])), triangles.astype(np.int64))


def _triangle_grid(divisions: int) -> tuple[Array, NDArray[np.int64]]:
    """The unit triangle in divisions^2 triangles."""
    i, j = np.mgrid[: divisions + 1, : divisions + 1]
    inside = i + j <= divisions
    number = np.cumsum(inside).reshape(inside.shape) - 1
    up, down = inside[1:, :-1], inside[1:, 1:]
    lower = np.column_stack([number[:-1, :-1][up], number[1:, :-1][up], number[:-1, 1:][up]])
    upper = np.column_stack([number[1:, 1:][down], number[:-1, 1:][down], number[1:, :-1][down]])
    return np.column_stack([i[inside], j[inside]]) / divisions, np.vstack([lower, upper]).astype(np.int64)


def _hexagon(rings: int) -> tuple[Array, NDArray[np.int64]]:
    """A regular hexagon of radius 1 in 6 rings^2 triangles."""
    unit, corners = _triangle_grid(rings)
    angle = np.arange(7) * np.pi / 3
    spokes = np.column_stack([np.cos(angle), np.sin(angle)])
    points = np.vstack([unit @ spokes[k : k + 2] for k in range(6)])
    _, first, number = np.unique(
        np.round(points * 1e6).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    triangles = np.vstack([corners + k * len(unit) for k in range(6)])
    return points[first], number.reshape(-1)[triangles]


def _disc(points: Array, radius: float) -> Array:
    """The hexagon of radius 1 onto a disc: its rings become circles."""
    angle = np.arctan2(points[:, 1], points[:, 0])
    sector = np.floor(angle / (np.pi / 3)) * np.pi / 3
    # in the sector's oblique coordinates, along its two spokes
    second = np.sin(angle - sector) * np.hypot(*points.T) / np.sin(np.pi / 3)
    ring = np.cos(angle - sector) * np.hypot(*points.T) + second / 2
    angle = sector + np.pi / 3 * second / np.where(ring > 0, ring, 1)
    return radius * ring[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])


def _whole(name: str, count: int) -> int:
    return int(check_range(name, count, 1, whole=True))
