r"""Adaptive frequency sweep: a few full solves, then a small rational model for every other frequency.

The system is affine in functions of frequency, K(f) = sum_k theta_k(f) K_k with real symmetric K_k, and so
is its excitation R(f) = sum_k phi_k(f) R_k. The solutions at a few frequencies span a real basis V; the
projected system V^T K V answers at any other frequency in microseconds. The response H = R^T K^-1 R of a
symmetric system is reproduced to second order in the error of the basis, and exactly, with its slope, at
every sampled frequency (moment matching; Villemagne and Skelton 1987).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from acoustic_fem.linear_solver import SymmetricSolver

#: Frequency (n_freq,) in Hz -> coefficients (n_freq, n_term) complex.
Coefficients = Callable[[NDArray[np.float64]], NDArray[np.complex128]]


#: Smallest eigenvalue of a passive admittance's real part, relative to its diagonal, that counts as rounding.
PASSIVITY_TOLERANCE = 1e-9


class SweepError(RuntimeError):
    """The reduced model did not reach its tolerance, or gives energy."""


@dataclass(frozen=True)
class ReducedModel:
    """Projected matrices of one system; valid from ``lowest`` to ``highest`` (Hz)."""

    matrices: NDArray[np.float64]
    """(n_term, r, r)."""
    excitations: NDArray[np.float64]
    """(n_excitation_term, r, m)."""
    basis: NDArray[np.float64] | None
    """(n, r), where the field itself is wanted."""
    sampled: tuple[float, ...]
    """Frequencies of the full solves."""
    error: float
    """Largest relative change of the response when the last sample was added."""
    lowest: float
    highest: float

    def coordinates(self, theta: NDArray, phi: NDArray) -> tuple[NDArray, NDArray]:
        """Solution in the basis and excitation, (n_freq, r, m) each."""
        excitation = np.einsum("fk,krm->frm", phi, self.excitations)
        return np.linalg.solve(np.einsum("fk,krs->frs", theta, self.matrices), excitation), excitation

    def response(self, theta: NDArray, phi: NDArray) -> NDArray[np.complex128]:
        """R^T K^-1 R, (n_freq, m, m), symmetric."""
        solution, excitation = self.coordinates(theta, phi)
        response = np.einsum("frm,frn->fmn", excitation, solution)
        return (response + response.transpose(0, 2, 1)) / 2


def reduce_system(
    matrices: Sequence[sp.csr_array],
    theta: Coefficients,
    excitations: Sequence[NDArray[np.float64]],
    phi: Coefficients,
    band: tuple[float, float],
    tolerance: float = 1e-6,
    keep_basis: bool = False,
    progress: Callable[[float], None] | None = None,
) -> ReducedModel:
    """Build the reduced model of a system over a band of frequencies.

    Full solves are added where the response of two successive models differs most, until they agree.

    Args:
        matrices: real symmetric (n, n) terms of the system.
        theta: their coefficients.
        excitations: (n, m) terms of the excitation.
        phi: their coefficients.
        band: lowest and highest frequency, Hz.
        tolerance: on the change of H_ij / sqrt(|H_ii H_jj|).
        keep_basis: store the basis, to recover the field.
        progress: called with the fraction done, estimated from the decay of the error.

    Raises:
        SweepError: 16 solves do not reach the tolerance.
        LinearSolverError: a solve fails its residual check.
    """
    lowest, highest = band
    candidates = np.geomspace(lowest, highest, 61) if highest > lowest else np.array([lowest])
    system_at, excitation_at = theta(candidates), phi(candidates)
    pattern = _combined(np.ones(len(matrices)), [abs(matrix) for matrix in matrices])
    order = [0, len(candidates) - 1, len(candidates) // 2] if len(candidates) > 1 else [0]
    taken: list[int] = []
    basis = np.zeros((matrices[0].shape[0], 0))
    previous: NDArray | None = None
    error = np.inf
    with SymmetricSolver(pattern) as solver:
        while True:
            k = order.pop(0)
            taken.append(k)
            rhs = np.einsum("k,knm->nm", excitation_at[k], np.stack(excitations))
            basis = _extended(basis, solver.solve(_combined(system_at[k], matrices), rhs))
            model = _project(matrices, excitations, basis)
            response = model.response(system_at, excitation_at)
            scale = np.sqrt(np.abs(np.einsum("fmm->fm", response)))
            scale = scale[:, :, None] * scale[:, None, :]
            if previous is not None:
                change = np.max(np.abs(response - previous) / scale, axis=(1, 2))
                error = float(change.max())
                if not order:
                    change[taken] = 0.0
                    order = [int(np.argmax(change))]
            previous = response
            if progress is not None:
                done = 0.0 if not np.isfinite(error) else np.log(max(error, tolerance)) / np.log(tolerance)
                progress(float(np.clip(max(done, len(taken) / 8), 0, 0.95)))
            if error <= tolerance or len(candidates) == 1:
                break
            if len(taken) >= 16:
                raise SweepError(
                    f"{len(taken)} solves between {lowest:g} and {highest:g} Hz leave a change of {error:.2g}, "
                    f"above the tolerance {tolerance:g}"
                )
    return ReducedModel(
        matrices=model.matrices,
        excitations=model.excitations,
        basis=basis if keep_basis else None,
        sampled=tuple(sorted(float(candidates[k]) for k in taken)),
        error=error if len(candidates) > 1 else 0.0,
        lowest=lowest,
        highest=highest,
    )


def passivity_margin(admittance: NDArray[np.complex128]) -> NDArray[np.float64]:
    """How far a network of ports is from giving energy, per frequency.

    The power it takes at port pressures p is p^H (Y + Y^H) p / 4 (peak values), so the least eigenvalue of
    (Y + Y^H) / 2 must not be negative (Anderson and Vongpanitlerd, Network Analysis and Synthesis (1973),
    section 2.3); for a reciprocal network that is Re Y. Rows and columns are scaled to |Y_ii| = 1 first, so
    that no small port hides behind a large one.

    Args:
        admittance: (n_freq, m, m), m^3/(Pa s); impedances serve as well.

    Returns:
        (n_freq,) the least eigenvalue, at most 1; -inf where a value is not finite.
    """
    values = np.asarray(admittance, dtype=np.complex128)
    if values.ndim != 3 or values.shape[1] != values.shape[2] or values.shape[1] == 0:
        raise ValueError(f"admittance has shape {values.shape}; it must be (n_freq, m, m)")
    finite = np.isfinite(values).all(axis=(1, 2))
    hermitian = (values + values.conj().transpose(0, 2, 1))[finite] / 2
    diagonal = np.abs(np.einsum("fii->fi", values[finite]))
    scale = np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    margin = np.full(len(values), -np.inf)
    margin[finite] = np.linalg.eigvalsh(hermitian / (scale[:, :, None] * scale[:, None, :])).min(axis=1)
    return margin


def require_passive(
    admittance: NDArray[np.complex128], frequency: NDArray[np.float64], tolerance: float = PASSIVITY_TOLERANCE
) -> float:
    """Refuse an admittance that gives energy at any of the frequencies.

    Args:
        admittance: (n_freq, m, m).
        frequency: (n_freq,) Hz.
        tolerance: on the negative side of :func:`passivity_margin`.

    Returns:
        The smallest margin.

    Raises:
        SweepError: not passive, or not finite, with the worst frequency.
    """
    margin = passivity_margin(admittance)
    worst = int(np.argmin(margin))
    if not np.isfinite(margin[worst]):
        raise SweepError(f"the response at {frequency[worst]:g} Hz is not finite")
    if margin[worst] < -tolerance:
        raise SweepError(
            f"the response at {frequency[worst]:g} Hz gives energy: the least eigenvalue of Re Y is "
            f"{margin[worst]:.2g} of its diagonal, below -{tolerance:g}"
        )
    return float(margin[worst])


def _combined(coefficients: NDArray, matrices: Sequence[sp.csr_array]) -> sp.csr_array:
    total = matrices[0] * coefficients[0]
    for coefficient, matrix in zip(coefficients[1:], matrices[1:], strict=True):
        total = total + matrix * coefficient
    return sp.csr_array(total)


def _extended(basis: NDArray[np.float64], solution: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Orthonormal basis with the real and imaginary parts of the solutions added, where they are new."""
    new = np.hstack([solution.real, solution.imag])
    norms = np.linalg.norm(new, axis=0)
    new = new[:, norms > 0] / norms[norms > 0]
    for _ in range(2):  # the second pass restores orthogonality lost to cancellation
        new = new - basis @ (basis.T @ new)
    q, singular, _ = np.linalg.svd(new, full_matrices=False)
    return np.hstack([basis, q[:, singular > 1e-11]])


def _project(
    matrices: Sequence[sp.csr_array], excitations: Sequence[NDArray[np.float64]], basis: NDArray[np.float64]
) -> ReducedModel:
    return ReducedModel(
        matrices=np.stack([basis.T @ (matrix @ basis) for matrix in matrices]),
        excitations=np.stack([basis.T @ excitation for excitation in excitations]),
        basis=None,
        sampled=(),
        error=np.inf,
        lowest=0.0,
        highest=0.0,
    )
