"""A disc of rubber in axisymmetric mixed elasticity: displacement and pressure, Q2-Q1.

Everything is dimensionless: lengths by the radius a of the opening, stresses by Young's modulus E,
masses by rho a^3. The mixed form does not lock as Poisson's ratio goes to 1/2 (Herrmann 1965; Hughes,
The Finite Element Method (1987), chapter 4). An equi-biaxial stress s in the plane of the disc adds
the stiffness int s (grad u e_i).(grad v e_i) over both directions i of the plane (Bathe, Finite Element
Procedures (1996), chapter 6).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import skfem
from numpy.typing import NDArray
from scipy.linalg import eigh
from scipy.sparse import bmat, csc_array
from scipy.sparse.linalg import LinearOperator, eigsh, splu
from skfem.helpers import dot

from geometry.ground.typed import Array

#: Steps per thickness; 1e-4 in compliance against refinement 6 (tests/acoustic_fem/membrane/test_disc.py).
REFINEMENT = 4

#: Axisymmetric modes that are computed.
MODES = 4

#: Radial steps are at most max(thickness, this) / refinement.
_RADIAL_SCALE = 0.1


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


@dataclass(frozen=True, eq=False)
class ElasticDisc:
    """Static solutions and a small dynamic model of a disc, without dimensions.

    The columns of the model are the first modes in vacuo and, behind them, what the static answers to the
    pressure on the lower face and to the force on the patch have beyond those modes. All columns are
    orthogonal in mass and in stiffness and scaled to unit mass, rho a^3.
    """

    modes: int
    """Number of true modes among the columns."""
    eigenvalues: Array
    """Stiffness of the columns, for modes w^2, (modes + 2,) float64, in E / (rho a^2), ascending."""
    geometric: Array
    """Part of the pre-stress in their stiffness, (modes + 2, modes + 2) float64, in E / (rho a^2)."""
    swept: Array
    """Volume swept by the lower face r < 1, outwards, (modes + 2,) float64."""
    swept_above: Array
    """Volume swept by the whole upper face, outwards, (modes + 2,) float64."""
    patch: Array
    """Mean displacement of the patch, outwards, (modes + 2,) float64."""
    radius: Array
    """Radii at which shapes are given, (n,) float64, 0 to 1."""
    shapes: Array
    """Displacement of the lower face along its inner normal, (modes + 2, n) float64."""
    compliance: float
    """Volume swept by the lower face r < a per pressure on it, in units of a^3 / E."""
    deflection: Array
    """Displacement of the lower face along its inner normal, (n,) float64, in a per pressure / E."""
    volume_per_force: float
    """Volume swept by the lower face per force on the patch, in units of a / E."""
    displacement_per_force: float
    """Mean displacement of the patch per force on it, in units of 1 / (E a)."""
    unknowns: int
    """Number of unknowns of the system."""


def solve_dimensionless(shape: DiscShape, refinement: int = REFINEMENT, modes: int = MODES) -> ElasticDisc:
    """Static deflections under pressure and under a force on the patch, and the first axisymmetric modes.

    Args:
        shape: the disc.
        refinement: steps per thickness; the smallest step at the edge of the clamp is 4^-(refinement + 1)
            thickness, so that each refinement divides the error by 2.5 or more.
        modes: how many.
    """
    mesh = _mesh(shape, refinement)
    displacement = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
    pressure = displacement.with_element(skfem.ElementQuad1())

    ratio = shape.poisson_ratio
    bulk_compliance = (1 + ratio) * (1 - 2 * ratio) / ratio
    prestress = shape.prestress * _prestress_form.assemble(displacement)
    stiffness = _shear_form.assemble(displacement, shear=1 / (2 * (1 + ratio))) + prestress
    divergence = _divergence_form.assemble(displacement, pressure)
    volumetric = _mass_form.assemble(pressure)
    system: Any = csc_array(bmat([[stiffness, -divergence.T], [-divergence, -bulk_compliance * volumetric]]))
    size = displacement.N + pressure.N

    held = np.concatenate([displacement.get_dofs("held").flatten(), displacement.get_dofs("axis").all("u^1")])
    free = np.setdiff1d(np.arange(size), held)
    face, radius = _axial(displacement, "loaded")
    loads = np.zeros((size, 3))
    loads[face, 0] = _ring_areas(radius)
    nodes, radii = _axial(displacement, "patch")
    loads[nodes, 1] = _ring_areas(radii) / (np.pi * shape.contact**2)
    for name in ("upper", "raised"):
        if len(mesh.boundaries[name]):
            nodes, radii = _axial(displacement, name)
            loads[nodes, 2] += _ring_areas(radii)
    if shape.raised is not None and len(mesh.boundaries["step"]):
        start, end, _ = shape.raised
        nodes, heights = _along(displacement, "step", "u^1", 1)
        loads[nodes, 2] += 2 * np.pi * (end if start == 0 else -start) * _lengths(heights)
    loads = loads[free]
    system = 2 * np.pi * system[np.ix_(free, free)]
    mass = 2 * np.pi * _padded(_inertia_form.assemble(displacement), size)[np.ix_(free, free)]
    geometric = 2 * np.pi * _padded(prestress, size)[np.ix_(free, free)]

    factor = splu(system)
    static: Array = factor.solve(loads[:, :2])
    columns = _modes_and_static(system, mass, factor, static, modes)
    values, mix = eigh(columns.T @ (system @ columns), columns.T @ (mass @ columns))
    columns = columns @ mix
    columns *= np.where(columns.T @ loads[:, 0] < 0, -1.0, 1.0)  # outwards

    def on_face(solution: Array) -> Array:
        full = np.zeros((size, *solution.shape[1:]))
        full[free] = solution
        result: Array = full[face].T
        return result

    static_response = loads[:, :2].T @ static
    return ElasticDisc(
        modes=modes,
        eigenvalues=values,
        geometric=columns.T @ (geometric @ columns),
        swept=columns.T @ loads[:, 0],
        swept_above=columns.T @ loads[:, 2],
        patch=columns.T @ loads[:, 1],
        radius=radius,
        shapes=on_face(columns),
        compliance=float(static_response[0, 0]),
        deflection=on_face(static[:, 0]),
        volume_per_force=float(static_response[0, 1]),
        displacement_per_force=float(static_response[1, 1]),
        unknowns=len(free),
    )


def _modes_and_static(system: Any, mass: Any, factor: Any, static: Array, count: int) -> Array:
    """The first modes, then the static solutions freed of them: columns, orthonormal in mass."""
    inverse = LinearOperator(factor.shape, matvec=factor.solve, dtype=np.float64)
    start = static[:, 0]  # close to the first mode; also makes the iteration repeatable
    _, modes = eigsh(system, k=count, M=mass, sigma=0.0, OPinv=inverse, v0=start)
    columns = list(modes.T)
    for solution in static.T:
        for _ in range(2):  # twice is enough (Parlett, The Symmetric Eigenvalue Problem (1980), 6.9)
            for column in columns:
                solution = solution - column * (column @ (mass @ solution)) / (column @ (mass @ column))
        columns.append(solution / np.sqrt(solution @ (mass @ solution)))
    return np.stack(columns, axis=1)


@skfem.BilinearForm
def _shear_form(u: Any, v: Any, w: Any) -> Any:
    """2 mu e(u):e(v) r with e_tt = u_r / r."""
    r = w.x[0]
    du, dv = u.grad, v.grad
    shear = (du[0, 1] + du[1, 0]) * (dv[0, 1] + dv[1, 0]) / 2
    return 2 * w["shear"] * (du[0, 0] * dv[0, 0] + du[1, 1] * dv[1, 1] + u[0] * v[0] / r**2 + shear) * r


@skfem.BilinearForm
def _prestress_form(u: Any, v: Any, w: Any) -> Any:
    """Gradients along r and around the axis, where e_r u_r turns: u_r / r."""
    r = w.x[0]
    return (u.grad[0, 0] * v.grad[0, 0] + u.grad[1, 0] * v.grad[1, 0] + u[0] * v[0] / r**2) * r


@skfem.BilinearForm
def _divergence_form(u: Any, q: Any, w: Any) -> Any:
    return (u.grad[0, 0] + u.grad[1, 1] + u[0] / w.x[0]) * q * w.x[0]


@skfem.BilinearForm
def _mass_form(p: Any, q: Any, w: Any) -> Any:
    return p * q * w.x[0]


@skfem.BilinearForm
def _inertia_form(u: Any, v: Any, w: Any) -> Any:
    return dot(u, v) * w.x[0]


def _padded(matrix: Any, size: int) -> Any:
    """The matrix of the displacements with empty rows and columns for the pressures."""
    entries = matrix.tocoo()
    return csc_array((entries.data, (entries.row, entries.col)), shape=(size, size))


def _axial(displacement: skfem.Basis, face: str) -> tuple[NDArray[np.int64], Array]:
    """Axial unknowns of a horizontal face and their radii, outwards: corner, middle, corner, ..."""
    return _along(displacement, face, "u^2", 0)


def _along(displacement: skfem.Basis, face: str, component: str, axis: int) -> tuple[NDArray[np.int64], Array]:
    """Unknowns of one component on a straight face and their places along it, ascending."""
    nodes = displacement.get_dofs(face).all(component)
    place = displacement.doflocs[axis, nodes]
    order = np.argsort(place)
    return nodes[order], place[order]


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


def _mesh(shape: DiscShape, refinement: int) -> skfem.MeshQuad:
    """Rectangles, graded towards singular stresses: the edges of the clamp, the patch and a raised part."""
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
        parts.append(inner + _graded_from_both(outer - inner, edges[inner], edges[outer], radial)[1:])
    if rim and shape.glue < rim:
        parts.append(1 + _graded_from_both(shape.glue, finest, finest, radial)[1:])
        parts.append(1 + shape.glue + _graded(rim - shape.glue, finest, radial)[1:])
    elif rim:
        parts.append(1 + _graded(rim, finest, radial)[1:])
    at_top = finest if height else at_patch if rim else finest
    heights = _graded_from_both(thickness, finest, at_top, thickness / refinement)
    if height:
        at_patch = min(at_patch, height) if boss < 1 else finest
        above = _graded_from_both(height, finest, at_patch, max(thickness, height) / refinement)
        heights = np.concatenate([heights, thickness + above[1:]])
    mesh = skfem.MeshQuad.init_tensor(np.concatenate(parts), heights)
    if height:
        r, z = mesh.p[:, mesh.t].mean(axis=1)
        mesh = mesh.restrict(np.flatnonzero((z < thickness) | ((r > start) & (r < end))))

    tiny = 1e-9 * min(thickness, 1.0)
    middle = thickness + (height if boss else 0.0)
    return mesh.with_boundaries(
        {
            "axis": lambda x: x[0] < tiny,
            "loaded": lambda x: (x[1] < tiny) & (x[0] < 1),
            "patch": lambda x: (x[1] > middle - tiny) & (x[0] < contact),
            "upper": lambda x: np.abs(x[1] - thickness) < tiny,
            "raised": lambda x: x[1] > thickness + height - tiny if height else np.zeros(x.shape[1:], bool),
            "step": lambda x: (x[1] > thickness + tiny) & (np.abs(x[0] - (boss or 1.0)) < tiny) & (boss < 1),
            "held": (lambda x: (x[1] < tiny) & (x[0] > 1) & (x[0] < 1 + shape.glue))
            if rim
            else (lambda x: x[0] > 1 - tiny),
        }
    )


def _graded(length: float, first: float, largest: float) -> Array:
    """Nodes from 0 to length: steps double from ``first`` up to ``largest``."""
    steps = [first]
    while sum(steps) < length:
        steps.append(min(2 * steps[-1], largest))
    return _nodes(steps, length)


def _graded_from_both(length: float, first: float, last: float, largest: float) -> Array:
    """Nodes from 0 to length: steps double from both ends up to ``largest``."""
    front, back = [first], [last]
    while sum(front) + sum(back) < length:
        shorter = front if front[-1] <= back[-1] else back
        shorter.append(min(2 * shorter[-1], largest))
    return _nodes([*front, *back[::-1]], length)


def _nodes(steps: list[float], length: float) -> Array:
    nodes = np.concatenate([[0.0], np.cumsum(steps)])
    result: Array = nodes * (length / nodes[-1])
    result[-1] = length
    return result
