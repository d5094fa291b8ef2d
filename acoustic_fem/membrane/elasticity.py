"""A disc of rubber in axisymmetric mixed elasticity: displacement and pressure, Q2-Q1.

Everything is dimensionless: lengths by the radius a of the opening, stresses by Young's modulus E,
masses by rho a^3. The mixed form does not lock as Poisson's ratio goes to 1/2 (Herrmann 1965; Hughes,
The Finite Element Method (1987), chapter 4). An equi-biaxial stress s in the plane of the disc adds
the stiffness int s (grad u e_i).(grad v e_i) over both directions i of the plane (Bathe, Finite Element
Procedures (1996), chapter 6).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import eigh
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from acoustic_fem.membrane.half_section import DiscShape, half_section
from geometry.ground.typed import Array

#: Steps per thickness; 1e-4 in compliance against refinement 6 (tests/acoustic_fem/membrane/test_disc.py).
REFINEMENT = 4

#: Axisymmetric modes that are computed.
MODES = 4

#: Relative residual of the modes. The relative error of eigenvalues and responses is about its square.
_CONVERGED = 1e-8


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
    section = half_section(shape, refinement)
    loads = section.loads()
    system, mass, geometric = section.matrices()
    # Elimination without a search for pivots is stable, because the matrix is quasi-definite: positive on displacements
    # and negative on pressures (Vanderbei, SIAM J. Optim. 5 (1995) 100). It takes a third of the time.
    factor = splu(system, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    static: Array = factor.solve(loads[:, :2])
    columns = _modes_and_static(system, mass, factor, static, modes)
    values, mix = eigh(columns.T @ (system @ columns), columns.T @ (mass @ columns))
    columns = columns @ mix
    columns *= np.where(columns.T @ loads[:, 0] < 0, -1.0, 1.0)  # outwards
    face, radius = section.opening

    def on_face(solution: Array) -> Array:
        held = np.zeros((1, *solution.shape[1:]))
        result: Array = np.concatenate([solution, held])[face].T
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
        unknowns=section.unknowns,
    )


def _modes_and_static(system: Any, mass: Any, factor: Any, static: Array, count: int) -> Array:
    """The first modes, then the static solutions freed of them: columns, orthonormal in mass."""
    inverse = LinearOperator(factor.shape, matvec=factor.solve, dtype=np.float64)
    start = static[:, 0]  # close to the first mode; also makes the iteration repeatable
    size = 2 * count + 4  # vectors between two restarts; the iteration makes at least so many
    _, modes = eigsh(system, k=count, M=mass, sigma=0.0, OPinv=inverse, v0=start, ncv=size, tol=_CONVERGED)
    inertia, freed = mass @ modes, static
    for _ in range(2):  # twice is enough (Parlett, The Symmetric Eigenvalue Problem (1980), 6.9)
        freed = freed - modes @ (inertia.T @ freed)
    first, second = (freed / np.sqrt(np.einsum("ij,ij->j", freed, mass @ freed))).T
    second = second - first * (first @ (mass @ second))
    return np.column_stack([modes, first, second / np.sqrt(second @ (mass @ second))])
