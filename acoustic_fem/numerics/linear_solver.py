"""Symmetric sparse systems, real or complex: factorise once, solve for many right-hand sides, check every residual.

Those of a cell's flow at a real shift are quasi-definite, positive for velocities and, if barely, negative for
pressures: they have factors in any ordering (Vanderbei, SIAM J. Optim. 5 (1995) 100). So the one of least fill is taken
first; where its residuals do not do, columns are matched to rows of large entries, which costs a third more.

Two backends: MKL PARDISO through the plain ``mkl`` wheel (the extra ``fast``), and SciPy's SuperLU, which
is always there and several times slower.
"""

from __future__ import annotations

import ctypes
import importlib.metadata
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spla
from numpy.typing import NDArray

from geometry.ground.refusal import Kind, Refusal

#: A solution whose relative residual is larger is refused, never returned.
RESIDUAL_LIMIT = 1e-8
#: One whose residual is larger is improved by a second solve with the same factors.
_IMPROVED_ABOVE = 1e-10

#: PARDISO's matrix types: real symmetric indefinite; complex and symmetric (not Hermitian).
_REAL, _COMPLEX = -2, 6
_ANALYSE, _FACTORISE, _SOLVE, _RELEASE = 11, 22, 33, -1


class LinearSolverError(Refusal):
    """A system that could not be solved to the residual limit."""


def backend() -> str:
    """Name of the backend in use: ``"pardiso"`` or ``"superlu"``."""
    return "superlu" if _mkl_library() is None else "pardiso"


class SymmetricSolver:
    """Solver for symmetric matrices of one size.

    The analysis (fill-reducing ordering) is done at the first matrix and used again for all others of its pattern and
    type; the factors are kept until another matrix comes.

    Args:
        size: n, the number of unknowns.

    Use as a context manager, so that the factors are given back.
    """

    def __init__(self, size: int) -> None:
        self._pardiso = _Pardiso() if _mkl_library() is not None else None
        self._shape = size, size
        self._superlu: tuple[sp.csr_array, Any] | None = None

    def __enter__(self) -> SymmetricSolver:
        return self

    def __exit__(self, *_: object) -> None:
        if self._pardiso is not None:
            self._pardiso.release()

    def solve(self, matrix: sp.csr_array, right_hand_sides: NDArray) -> NDArray:
        """Solve for all columns.

        Args:
            matrix: (n, n) float64 or complex128, symmetric.
            right_hand_sides: (n, m) of the same type.

        Returns:
            (n, m) of the same type.

        Raises:
            LinearSolverError: the relative residual of a column exceeds ``RESIDUAL_LIMIT``.
        """
        right_hand_sides = np.ascontiguousarray(right_hand_sides, dtype=matrix.dtype)
        if matrix.shape != self._shape:
            raise LinearSolverError(
                f"has shape {matrix.shape}, the solver was made for {self._shape}", kind=Kind.MISMATCH, field="matrix"
            )
        backend_solve = self._superlu_solve if self._pardiso is None else self._pardiso.solve
        if self._pardiso is not None and not self._pardiso.matched:
            with suppress(LinearSolverError):
                solution, relative = _refined(backend_solve, matrix, right_hand_sides)
                if relative <= RESIDUAL_LIMIT:
                    return solution
            self._pardiso.match()
        solution, relative = _refined(backend_solve, matrix, right_hand_sides)
        if not relative <= RESIDUAL_LIMIT:
            raise LinearSolverError(
                f"{backend()} returned a solution with relative residual {relative:.2g}, above {RESIDUAL_LIMIT:g}",
                kind=Kind.NO_RESULT,
            )
        return solution

    def _superlu_solve(self, matrix: sp.csr_array, right_hand_sides: NDArray) -> NDArray:
        if self._superlu is None or self._superlu[0] is not matrix:
            factors = spla.splu(
                matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.01, options={"SymmetricMode": True}
            )
            self._superlu = matrix, factors
        solution: NDArray = self._superlu[1].solve(right_hand_sides)
        return solution


def _refined(
    backend_solve: Callable[[sp.csr_array, NDArray], NDArray], matrix: sp.csr_array, right_hand_sides: NDArray
) -> tuple[NDArray, float]:
    """Solution, improved with the same factors where it must be, and the largest relative residual of a column."""
    scale = np.linalg.norm(right_hand_sides, axis=0)
    scale[scale == 0] = 1.0
    solution, residual, relative = np.zeros_like(right_hand_sides), right_hand_sides, np.inf
    for _ in range(3):
        solution = solution + backend_solve(matrix, residual)
        residual = right_hand_sides - np.asarray(matrix @ solution)
        relative = float(np.max(np.linalg.norm(residual, axis=0) / scale, initial=0.0))
        if relative <= _IMPROVED_ABOVE:
            break
    return solution, relative


@cache
def _mkl_library() -> ctypes.CDLL | None:
    """The MKL runtime of the ``mkl`` wheel, or None where the wheel is not installed."""
    try:
        files = importlib.metadata.files("mkl") or []
    except importlib.metadata.PackageNotFoundError:
        return None
    names = [file for file in files if file.name.startswith(("libmkl_rt.so", "mkl_rt.", "libmkl_rt."))]
    for file in names:
        path = Path(str(file.locate())).resolve()
        if path.suffix == ".lib" or not path.exists():
            continue
        try:
            # MKL's thread runtime lies beside it, where the loader does not look by itself.
            for runtime in ("libiomp5.so", "libiomp5.dylib"):
                if (path.parent / runtime).exists():
                    ctypes.CDLL(str(path.parent / runtime), mode=ctypes.RTLD_GLOBAL)
            return ctypes.CDLL(str(path), mode=getattr(ctypes, "RTLD_GLOBAL", 0))
        except OSError as error:
            print(f"acoustic-fem: {path.name} does not load ({error}); using SuperLU", file=sys.stderr)
    return None


class _Pardiso:
    """One PARDISO handle: the plain C interface with 64-bit pointers and 32-bit integers."""

    def __init__(self) -> None:
        self._handle = np.zeros(64, dtype=np.int64)
        self._parameters = np.zeros(64, dtype=np.int32)
        p = self._parameters
        p[0] = 1  # not the defaults
        p[1] = 2  # nested dissection
        p[7] = 0  # steps of iterative refinement: the caller looks at residuals and improves where it must
        p[9] = 8  # pivot perturbation 1e-8
        p[10] = p[12] = 0  # no scaling and no weighted matching, see match()
        p[20] = 1  # Bunch-Kaufman pivoting
        p[34] = 1  # zero-based indices
        self._type = _REAL
        self._matrix: sp.csr_array | None = None
        self._pattern: tuple[NDArray[np.int32], NDArray[np.int32]] | None = None
        self._values: NDArray | None = None

    @property
    def matched(self) -> bool:
        """True if columns are matched to rows."""
        return bool(self._parameters[12])

    def match(self) -> None:
        """Scale, and match columns to rows, from now on."""
        self.release()
        self._parameters[10] = self._parameters[12] = 1

    def solve(self, matrix: sp.csr_array, right_hand_sides: NDArray) -> NDArray:
        if self._matrix is not matrix:
            self._factorise(matrix)
        rhs = np.asfortranarray(right_hand_sides)
        solution = np.zeros_like(rhs, order="F")
        self._call(_SOLVE, rhs, solution)
        return np.ascontiguousarray(solution)

    def _factorise(self, matrix: sp.csr_array) -> None:
        upper = sp.triu(matrix, format="csr")
        upper.sort_indices()
        rows, columns = upper.indptr.astype(np.int32), upper.indices.astype(np.int32)
        kind = _COMPLEX if np.iscomplexobj(upper.data) else _REAL
        same = (
            self._pattern is not None
            and kind == self._type
            and np.array_equal(rows, self._pattern[0])
            and np.array_equal(columns, self._pattern[1])
        )
        if not same:
            self.release()
        self._type, self._pattern, self._matrix = kind, (rows, columns), matrix
        self._values = np.ascontiguousarray(upper.data)
        # A matching depends on the values, so the analysis sees them; it is kept while it serves.
        if not same:
            self._call(_ANALYSE)
        self._call(_FACTORISE)

    def release(self) -> None:
        if self._pattern is not None:
            self._call(_RELEASE)
            self._pattern = self._matrix = None

    def _call(self, phase: int, rhs: NDArray | None = None, solution: NDArray | None = None) -> None:
        library = _mkl_library()
        if library is None or self._pattern is None or self._values is None:
            raise LinearSolverError("PARDISO was called before it had a matrix", kind=Kind.NO_RESULT)
        rows, columns = self._pattern
        count = 1 if rhs is None else rhs.shape[1]
        error = ctypes.c_int32(0)
        permutation = np.zeros(1, dtype=np.int32)

        def integer(value: int) -> object:
            return ctypes.byref(ctypes.c_int32(value))

        def array(values: NDArray | None) -> object:
            return None if values is None else values.ctypes.data_as(ctypes.c_void_p)

        library.pardiso(
            array(self._handle),
            integer(1),
            integer(1),
            integer(self._type),
            integer(phase),
            integer(len(rows) - 1),
            array(self._values),
            array(rows),
            array(columns),
            array(permutation),
            integer(count),
            array(self._parameters),
            integer(0),
            array(rhs),
            array(solution),
            ctypes.byref(error),
        )
        if error.value != 0:
            raise LinearSolverError(f"PARDISO phase {phase} failed with error {error.value}", kind=Kind.NO_RESULT)
