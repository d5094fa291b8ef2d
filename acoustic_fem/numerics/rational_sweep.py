r"""Adaptive frequency sweep: a few full solves, then a small rational model for every other frequency.

The system is affine in functions of frequency, K(f) = sum_k theta_k(f) K_k with real symmetric K_k, and so
is its excitation R(f) = sum_k phi_k(f) R_k. Diffusion has its poles on the negative real axis of s = j 2 pi f, so
the sweep solves at *real* s: the matrices are then real, and a factorisation costs a quarter of a complex one.
At each of these shifts the first derivatives of the solution follow from the same factors. Together they span a
real basis V; the projected system V^T K V answers at any frequency in microseconds. The response H = R^T K^-1 R
of a symmetric system is reproduced to second order in the error of the basis (moment matching; Villemagne and
Skelton 1987; real shifts for diffusive systems: Druskin, Knizhnerman and Zaslavsky 2009).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from acoustic_fem.numerics.linear_solver import SymmetricSolver
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Frequency (n_freq,) in Hz -> coefficients (n_freq, n_term) complex. They are analytic functions of s = j 2 pi f,
#: real where s is real and positive, and are asked for there as well, at f = -j s / (2 pi).
Coefficients = Callable[[NDArray], ComplexArray]

#: Solution and derivatives taken at the first shift, more there where they do not do, then at each of others; and the
#: most shifts. A derivative costs a twentieth of a factorisation of a large system.
_MOMENTS, _MORE_MOMENTS, _OTHER_MOMENTS = 10, 4, 6
_MOST_SHIFTS = 12
#: Frequencies at which changes are looked at, and shifts may lie.
_CANDIDATES = 61
#: Where the first shift lies in the band, in parts of its logarithm.
_FIRST_SHIFT = 0.75
#: How much may be left, in changes with the last derivatives: far from a shift one more brings little. Twice the change
#: was found in slabs of 30 and 100 mm, less than it in five cells.
_LEFT = 3.0
#: Numbers of the frequencies at the ends, where shifts are taken if changes tell nothing.
_ENDS = (_CANDIDATES - 1, 0)
#: Taylor coefficients come from values on a circle around the shift of this radius, relative to it.
_CIRCLE = 0.5
_ON_CIRCLE = 32


#: Smallest eigenvalue of a passive admittance's real part, relative to its diagonal, that counts as rounding.
PASSIVITY_TOLERANCE = 1e-9


class RationalFitError(Refusal):
    """The reduced model did not reach its tolerance, or gives energy."""


@dataclass(frozen=True)
class ReducedModel:
    """Projected matrices of one system; valid from ``lowest`` to ``highest`` (Hz)."""

    matrices: Array
    """Projected terms of the system, (n_term, r, r) float64, in their units."""
    excitations: Array
    """Projected terms of the excitation, (n_excitation_term, r, m) float64."""
    basis: Array | None
    """Basis of the projection, without a unit, (n, r) float64, where the field itself is wanted; else None."""
    sampled: tuple[float, ...]
    """Shifts s / (2 pi) of the full solves, Hz; of the one frequency, where there is but one."""
    error: float
    """Relative error of the response, three times its largest change with the last derivatives; what rounding leaves,
    up to 1e-7, is not in it."""
    lowest: float
    """Lowest frequency of the band, Hz."""
    highest: float
    """Highest frequency of the band, Hz."""

    def coordinates(self, theta: NDArray, phi: NDArray) -> tuple[NDArray, NDArray]:
        """Solution in the basis and excitation, (n_freq, r, m) complex128 each.

        Takes theta (n_freq, n_term) and phi (n_freq, n_excitation_term), as for :meth:`response`.
        """
        excitation = np.einsum("fk,krm->frm", phi, self.excitations)
        return np.linalg.solve(np.einsum("fk,krs->frs", theta, self.matrices), excitation), excitation

    def leading(self, size: int) -> ReducedModel:
        """The model on the first functions of the basis."""
        return replace(
            self,
            matrices=self.matrices[:, :size, :size],
            excitations=self.excitations[:, :size],
            basis=None if self.basis is None else self.basis[:, :size],
        )

    def response(self, theta: NDArray, phi: NDArray) -> ComplexArray:
        """Response R^T K^-1 R, symmetric.

        Args:
            theta: (n_freq, n_term) coefficients of the system, in the units that its terms ask for.
            phi: (n_freq, n_excitation_term) coefficients of the excitation, likewise.

        Returns:
            (n_freq, m, m) complex128.
        """
        solution, excitation = self.coordinates(theta, phi)
        response = np.einsum("frm,frn->fmn", excitation, solution)
        return (response + response.transpose(0, 2, 1)) / 2


def reduce_system(
    matrices: Sequence[sp.csr_array],
    theta: Coefficients,
    excitations: Sequence[Array],
    phi: Coefficients,
    band: tuple[float, float],
    tolerance: float = 1e-6,
    keep_basis: bool = False,
    progress: Callable[[float], None] | None = None,
) -> ReducedModel:
    """Build the reduced model of a system over a band of frequencies.

    Shifts are added where the response changes most with the last derivative, until it changes no more. At a
    band of one frequency the system is solved there, in complex numbers.

    Args:
        matrices: real symmetric (n, n) terms of the system.
        theta: their coefficients.
        excitations: (n, m) float64 terms of the excitation.
        phi: their coefficients.
        band: lowest and highest frequency, Hz.
        tolerance: of one, on the error of H_ij / sqrt(|H_ii H_jj|) as :attr:`ReducedModel.error` has it.
        keep_basis: store the basis, to recover the field.
        progress: called with the fraction done, estimated from the decay of the error.

    Raises:
        RationalFitError: 12 shifts do not reach the tolerance.
        LinearSolverError: a solve fails its residual check.
    """
    lowest, highest = band
    terms = np.stack(excitations)
    size = len(terms[0])
    if lowest == highest:
        at = np.array([lowest])
        with SymmetricSolver(size) as solver:
            solution = solver.solve(_combined(theta(at)[0], matrices), np.einsum("k,knm->nm", phi(at)[0], terms))
        basis = _extended(np.zeros((len(solution), 0)), np.hstack([solution.real, solution.imag]))
        return _model(map(_Part.of, matrices), terms, basis, keep_basis, (lowest,), 0.0, band)
    parts = [_Part.of(matrix) for matrix in matrices]
    candidates = np.geomspace(lowest, highest, _CANDIDATES)
    system_at, excitation_at = theta(candidates), phi(candidates)
    taken = [round(_FIRST_SHIFT * (_CANDIDATES - 1))]
    with SymmetricSolver(size) as solver:

        def moments_at(candidate: int) -> Iterator[Array]:
            return _moments(float(candidates[candidate]), matrices, parts, theta, terms, phi, solver)

        first = moments_at(taken[0])
        solutions = [list(islice(first, _MOMENTS))]
        while True:
            basis = _extended(np.zeros((size, 0)), np.hstack([each for at in solutions for each in at[:-1]]))
            shorter = basis.shape[1]
            model = _model(
                parts,
                terms,
                _extended(basis, np.hstack([at[-1] for at in solutions])),
                keep_basis,
                tuple(sorted(float(candidates[k]) for k in taken)),
                np.inf,
                band,
            )
            response = model.response(system_at, excitation_at)
            change = _change(model.leading(shorter).response(system_at, excitation_at), response)
            error = _LEFT * float(change.max())
            # Derivatives that are combinations of earlier ones, but for rounding, say nothing about the residual.
            reliable = model.matrices.shape[1] > shorter or len(taken) > len(_ENDS)
            if progress is not None:
                done = np.log(max(error, tolerance)) / np.log(tolerance) if np.isfinite(error) else 0.0
                progress(float(np.clip(max(done, len(taken) / 6), 0, 0.95)))
            if error <= tolerance and reliable:
                return replace(model, error=error)
            if len(taken) >= _MOST_SHIFTS:
                raise RationalFitError(
                    f"{len(taken)} solves between {lowest:g} and {highest:g} Hz leave an error of {error:.2g}, "
                    f"above the tolerance {tolerance:g}",
                    kind=Kind.NO_RESULT,
                )
            if reliable and len(taken) == 1 and len(solutions[0]) == _MOMENTS:
                solutions[0] += islice(first, _MORE_MOMENTS)
                continue
            change[taken] = 0.0
            taken.append(int(np.argmax(change)) if reliable else _ENDS[len(taken) - 1])
            solutions.append(list(islice(moments_at(taken[-1]), _OTHER_MOMENTS)))


@dataclass(frozen=True)
class _Part:
    """Symmetric term of a system without the rows and columns before and after it, which are empty."""

    place: slice
    """Rows and columns that it has."""
    matrix: sp.csr_array
    """Its entries there."""

    @classmethod
    def of(cls, matrix: sp.csr_array) -> _Part:
        rows = np.flatnonzero(np.diff(matrix.indptr))
        place = slice(int(rows[0]), int(rows[-1]) + 1) if len(rows) else slice(0, 0)
        return cls(place, matrix[place, place])


def _moments(
    frequency: float,
    matrices: Sequence[sp.csr_array],
    parts: Sequence[_Part],
    theta: Coefficients,
    excitations: Array,
    phi: Coefficients,
    solver: SymmetricSolver,
) -> Iterator[Array]:
    """Solution at s = 2 pi frequency, then its scaled derivatives there one by one, (n, m) each.

    With K = sum K_j z^j and R = sum R_j z^j around the shift,
    K_0 x_i = R_i - sum_{j>0} K_j x_{i-j}.
    """
    system, excitation = (_taylor(function, frequency) for function in (theta, phi))
    shifted = _combined(system[0], matrices)
    moments: list[Array] = []
    for order in range(len(system)):
        load = np.einsum("k,knm->nm", excitation[order], excitations)
        for earlier, moment in enumerate(moments):
            for coefficient, part in zip(system[order - earlier], parts, strict=True):
                if coefficient != 0:
                    load[part.place] -= coefficient * (part.matrix @ moment[part.place])
        moments.append(solver.solve(shifted, load))
        yield moments[-1]


def _taylor(function: Coefficients, frequency: float) -> Array:
    """Real Taylor coefficients around a shift in units of the circle's radius, (``_ON_CIRCLE`` / 2, n_term); Cauchy."""
    around = 1 + _CIRCLE * np.exp(2j * np.pi * np.arange(_ON_CIRCLE) / _ON_CIRCLE)
    values = function(-1j * frequency * around)
    coefficients = np.fft.fft(values, axis=0)[: _ON_CIRCLE // 2].real / _ON_CIRCLE
    coefficients[np.abs(coefficients) < 1e-12 * np.abs(coefficients).max(axis=0)] = 0
    return np.asarray(coefficients)


def _change(shorter: ComplexArray, longer: ComplexArray) -> Array:
    """Largest difference of two responses per frequency, each entry against its row and column."""
    scale = np.sqrt(np.abs(np.einsum("fmm->fm", longer)))
    change: Array = np.max(np.abs(longer - shorter) / (scale[:, :, None] * scale[:, None, :]), axis=(1, 2))
    return change


def passivity_margin(admittance: ComplexArray) -> Array:
    """How far a network of ports is from giving energy, per frequency.

    The power it takes at port pressures p is p^H (Y + Y^H) p / 4 (peak values), so the least eigenvalue of
    (Y + Y^H) / 2 must not be negative (Anderson and Vongpanitlerd, Network Analysis and Synthesis (1973),
    section 2.3); for a reciprocal network that is Re Y. Rows and columns are scaled to |Y_ii| = 1 first, so
    that no small port hides behind a large one.

    Args:
        admittance: (n_freq, m, m) complex128, m^3/(Pa s); impedances serve as well.

    Returns:
        (n_freq,) float64: the least eigenvalue, at most 1; -inf where a value is not finite.
    """
    values = np.asarray(admittance, dtype=np.complex128)
    if values.ndim != 3 or values.shape[1] != values.shape[2] or values.shape[1] == 0:
        raise Refusal(f"has shape {values.shape}; it must be (n_freq, m, m)", kind=Kind.WRONG_TYPE, field="admittance")
    finite = np.isfinite(values).all(axis=(1, 2))
    hermitian = (values + values.conj().transpose(0, 2, 1))[finite] / 2
    diagonal = np.abs(np.einsum("fii->fi", values[finite]))
    scale = np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    margin = np.full(len(values), -np.inf)
    margin[finite] = np.linalg.eigvalsh(hermitian / (scale[:, :, None] * scale[:, None, :])).min(axis=1)
    return margin


def require_passive(admittance: ComplexArray, frequency: Array) -> float:
    """Refuse an admittance that gives energy at any of the frequencies.

    Args:
        admittance: (n_freq, m, m) complex128, m^3/(Pa s).
        frequency: (n_freq,) float64, Hz.

    Returns:
        The smallest margin.

    Raises:
        RationalFitError: not passive, or not finite, with the worst frequency.
    """
    margin = passivity_margin(admittance)
    worst = int(np.argmin(margin))
    if not np.isfinite(margin[worst]):
        raise RationalFitError(f"the response at {frequency[worst]:g} Hz is not finite", kind=Kind.NO_RESULT)
    if margin[worst] < -PASSIVITY_TOLERANCE:
        raise RationalFitError(
            f"the response at {frequency[worst]:g} Hz gives energy: the least eigenvalue of Re Y is "
            f"{margin[worst]:.2g} of its diagonal, below -{PASSIVITY_TOLERANCE:g}",
            kind=Kind.NO_RESULT,
        )
    return float(margin[worst])


def _combined(coefficients: NDArray, matrices: Sequence[sp.csr_array]) -> sp.csr_array:
    # The sparse ones first: a sum costs what its larger term holds.
    first, *others = np.argsort([matrix.nnz for matrix in matrices])
    total = matrices[first] * coefficients[first]
    for number in others:
        total = total + matrices[number] * coefficients[number]
    return sp.csr_array(total)


def _extended(basis: Array, new: Array) -> Array:
    """Orthonormal basis with the columns added, where they are new."""
    norms = np.linalg.norm(new, axis=0)
    new = new[:, norms > 0] / norms[norms > 0]
    for _ in range(2):  # the second pass restores orthogonality lost to cancellation
        new = new - basis @ (basis.T @ new)
    q, singular, _ = np.linalg.svd(new, full_matrices=False)
    return np.hstack([basis, q[:, singular > 1e-11]])


def _model(
    parts: Iterable[_Part],
    excitations: Array,
    basis: Array,
    keep_basis: bool,
    sampled: tuple[float, ...],
    error: float,
    band: tuple[float, float],
) -> ReducedModel:
    """The system of these parts projected on a basis."""
    return ReducedModel(
        matrices=np.stack([basis[part.place].T @ (part.matrix @ basis[part.place]) for part in parts]),
        excitations=np.stack([basis.T @ excitation for excitation in excitations]),
        basis=basis if keep_basis else None,
        sampled=sampled,
        error=error,
        lowest=band[0],
        highest=band[1],
    )
