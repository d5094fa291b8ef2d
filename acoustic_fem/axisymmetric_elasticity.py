"""A disc of rubber in axisymmetric mixed elasticity: displacement and pressure, Q2-Q1.

Everything is dimensionless: lengths by the radius a of the opening, stresses by Young's modulus E,
masses by rho a^3. The mixed form does not lock as Poisson's ratio goes to 1/2 (Herrmann 1965; Hughes,
The Finite Element Method (1987), chapter 4).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import skfem
from numpy.typing import NDArray
from scipy.sparse import bmat, csc_array
from scipy.sparse.linalg import LinearOperator, eigsh, splu
from skfem.helpers import dot

#: Steps per thickness; 1e-4 in compliance against refinement 6 (tests/test_membrane.py).
REFINEMENT = 4

#: Radial steps are at most max(thickness, this) / refinement.
_RADIAL_SCALE = 0.1


@dataclass(frozen=True, eq=False)
class ElasticDisc:
    """Result of :func:`solve_dimensionless`.

    Attributes:
        compliance: volume swept by the lower face r < a per pressure on it, in a^3 / E.
        eigenvalue: w^2 of the first mode in vacuo, in E / (rho a^2).
        modal_mass: mass of the first mode scaled to sweep the volume a^3, in rho a^3.
        radius: (n,) where the shape is given, 0 to 1.
        deflection: (n,) displacement of the lower face along its inner normal, in a per pressure / E.
        unknowns: size of the system.
    """

    compliance: float
    eigenvalue: float
    modal_mass: float
    radius: NDArray[np.float64]
    deflection: NDArray[np.float64]
    unknowns: int


def solve_dimensionless(
    thickness: float, poisson_ratio: float, rim: float, refinement: int = REFINEMENT
) -> ElasticDisc:
    """Static deflection under pressure on the lower face r < 1, and the first axisymmetric mode.

    Args:
        thickness: h / a.
        poisson_ratio: above 0, below 1/2.
        rim: 0: the lateral face r = 1 is clamped; above 0: the disc reaches to r = 1 + rim and its lower
            face is held on 1 < r < 1 + rim, all other faces are free.
        refinement: steps per thickness; the smallest step at the edge of the clamp is 4^-(refinement + 1)
            thickness, so that each refinement divides the error by 2.5 or more.
    """
    mesh = _mesh(thickness, rim, refinement)
    displacement = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
    pressure = displacement.with_element(skfem.ElementQuad1())

    shear = 1 / (2 * (1 + poisson_ratio))
    bulk_compliance = (1 + poisson_ratio) * (1 - 2 * poisson_ratio) / poisson_ratio
    stiffness = _shear_form.assemble(displacement, shear=shear)
    divergence = _divergence_form.assemble(displacement, pressure)
    volumetric = _mass_form.assemble(pressure)
    system: Any = csc_array(bmat([[stiffness, -divergence.T], [-divergence, -bulk_compliance * volumetric]]))
    inertia = _inertia_form.assemble(displacement)
    size = displacement.N + pressure.N

    held = np.concatenate([displacement.get_dofs("held").flatten(), displacement.get_dofs("axis").all("u^1")])
    free = np.setdiff1d(np.arange(size), held)
    face, radius = _lower_face(displacement)
    load = np.zeros(size)
    load[face] = _ring_areas(radius)
    system = system[np.ix_(free, free)]
    factor = splu(system)
    solution = np.zeros(size)
    solution[free] = factor.solve(load[free])

    mass: Any = csc_array(bmat([[inertia, None], [None, 0 * volumetric]]))
    mass = mass[np.ix_(free, free)]
    inverse = LinearOperator(factor.shape, matvec=factor.solve, dtype=np.float64)
    start = solution[free]  # close to the first mode; also makes the iteration repeatable
    values, modes = eigsh(system, k=1, M=mass, sigma=0.0, OPinv=inverse, v0=start)
    mode = modes[:, 0]
    swept = 2 * np.pi * load[free] @ mode

    return ElasticDisc(
        compliance=float(2 * np.pi * load @ solution),
        eigenvalue=float(values[0]),
        modal_mass=float(2 * np.pi * mode @ mass @ mode / swept**2),
        radius=radius,
        deflection=solution[face],
        unknowns=len(free),
    )


@skfem.BilinearForm
def _shear_form(u: Any, v: Any, w: Any) -> Any:
    """2 mu e(u):e(v) r with e_tt = u_r / r."""
    r = w.x[0]
    du, dv = u.grad, v.grad
    shear = (du[0, 1] + du[1, 0]) * (dv[0, 1] + dv[1, 0]) / 2
    return 2 * w["shear"] * (du[0, 0] * dv[0, 0] + du[1, 1] * dv[1, 1] + u[0] * v[0] / r**2 + shear) * r


@skfem.BilinearForm
def _divergence_form(u: Any, q: Any, w: Any) -> Any:
    return (u.grad[0, 0] + u.grad[1, 1] + u[0] / w.x[0]) * q * w.x[0]


@skfem.BilinearForm
def _mass_form(p: Any, q: Any, w: Any) -> Any:
    return p * q * w.x[0]


@skfem.BilinearForm
def _inertia_form(u: Any, v: Any, w: Any) -> Any:
    return dot(u, v) * w.x[0]


def _lower_face(displacement: skfem.Basis) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Axial unknowns of the loaded face and their radii, outwards: corner, middle, corner, ..."""
    nodes = displacement.get_dofs("loaded").all("u^2")
    radius = displacement.doflocs[0, nodes]
    order = np.argsort(radius)
    return nodes[order], radius[order]


def _ring_areas(radius: NDArray[np.float64]) -> NDArray[np.float64]:
    """Integrals of N r dr for quadratic shape functions: cubic integrands, so Simpson's rule is exact."""
    steps = radius[2::2] - radius[:-2:2]
    weights = np.zeros_like(radius)
    weights[:-2:2] += steps / 6
    weights[1::2] += 4 * steps / 6
    weights[2::2] += steps / 6
    result: NDArray[np.float64] = radius * weights
    return result


def _mesh(thickness: float, rim: float, refinement: int) -> skfem.MeshQuad:
    """Rectangles, graded towards the edge of the clamp, where the stress is singular."""
    finest = min(thickness, 1.0) * 0.5 ** (2 * refinement + 2)
    radial = max(thickness, _RADIAL_SCALE) / refinement
    inside = 1 - _graded(1.0, finest, radial)[::-1]
    if rim:
        radii = np.concatenate([inside, 1 + _graded(rim, finest, radial)[1:]])
        heights = _graded(thickness, finest, thickness / refinement)
    else:
        radii = inside
        lower = _graded(thickness / 2, finest, thickness / refinement)
        heights = np.concatenate([lower, thickness - lower[-2::-1]])
    mesh = skfem.MeshQuad.init_tensor(radii, heights)

    tiny = 1e-9 * min(thickness, 1.0)
    return mesh.with_boundaries(
        {
            "axis": lambda x: x[0] < tiny,
            "loaded": lambda x: (x[1] < tiny) & (x[0] < 1),
            "held": (lambda x: (x[1] < tiny) & (x[0] > 1)) if rim else (lambda x: x[0] > 1 - tiny),
        }
    )


def _graded(length: float, first: float, largest: float) -> NDArray[np.float64]:
    """Nodes from 0 to length: steps double from ``first`` up to ``largest``."""
    steps = [first]
    while sum(steps) < length:
        steps.append(min(2 * steps[-1], largest))
    nodes = np.concatenate([[0.0], np.cumsum(steps)])
    result: NDArray[np.float64] = nodes * (length / nodes[-1])
    return result
