"""Complex-symmetric solves: both backends, residuals, reuse of the analysis."""

import numpy as np
import pytest
import scipy.sparse as sp
from refusals import refused

from acoustic_fem.numerics import linear_solver
from acoustic_fem.numerics.linear_solver import LinearSolverError, SymmetricSolver
from geometry.ground.refusal import Kind


def saddle_point(n=400, m=120, seed=0):
    """A symmetric matrix with a nearly empty pressure block, as Taylor-Hood elements make it."""
    rng = np.random.default_rng(seed)
    laplace = sp.diags_array([-1.0, 2.1, -1.0], offsets=[-1, 0, 1], shape=(n, n))
    coupling = sp.random_array((m, n), density=0.05, rng=rng)
    tiny = -1e-9j * sp.eye_array(m)
    viscous = sp.csr_array(laplace).astype(complex) + 0.3j * sp.eye_array(n, format="csr")
    return sp.csr_array(sp.block_array([[viscous, coupling.T], [coupling, tiny]]))


@pytest.fixture(params=["pardiso", "superlu"])
def backend(request, monkeypatch):
    if request.param == "superlu":
        monkeypatch.setattr(linear_solver, "_mkl_library", lambda: None)
    elif linear_solver.backend() != "pardiso":
        pytest.skip("the mkl wheel is not installed")
    return request.param


def test_solution_matches_dense_algebra(backend):
    assert linear_solver.backend() == backend
    matrix = saddle_point()
    rhs = np.random.default_rng(1).standard_normal((matrix.shape[0], 3)) * (1 + 2j)
    with SymmetricSolver(len(rhs)) as solver:
        solution = solver.solve(matrix, rhs)
        np.testing.assert_allclose(solution, np.linalg.solve(matrix.toarray(), rhs), rtol=1e-8, atol=1e-10)
        # The second matrix uses the ordering of the first.
        other = sp.csr_array(matrix * (2 - 1j))
        np.testing.assert_allclose(solver.solve(other, rhs), solution / (2 - 1j), rtol=1e-8, atol=1e-10)


def test_singular_matrix_is_an_error_and_never_a_silent_answer(backend):
    matrix = sp.csr_array(np.array([[1.0, 1.0, 0], [1.0, 1.0, 0], [0, 0, 1.0]]).astype(complex))
    with SymmetricSolver(3) as solver, pytest.raises((LinearSolverError, RuntimeError)):
        solver.solve(matrix, np.array([[1.0], [2.0], [0.0]], dtype=complex))


def test_matrix_of_another_size_is_refused(backend):
    with SymmetricSolver(520) as solver, refused(Kind.MISMATCH, "matrix"):
        solver.solve(sp.csr_array(sp.eye_array(10, dtype=complex)), np.ones((10, 1), dtype=complex))


def test_a_matrix_that_needs_its_columns_matched_is_solved_too(backend, monkeypatch):
    """A saddle point without a diagonal, rows of six decades: without matching PARDISO's answer is worth nothing."""
    side = 60
    line = sp.diags_array([-1.0, 4.0, -1.0], offsets=[-1, 0, 1], shape=(side, side))
    beside = sp.diags_array([-1.0, -1.0], offsets=[-1, 1], shape=(side, side))
    grid = sp.kron(sp.eye_array(side), line) + sp.kron(beside, sp.eye_array(side))
    rng = np.random.default_rng(0)
    grid = sp.diags_array(10.0 ** rng.uniform(-6, 6, side**2)) @ grid
    matrix = sp.csr_array(sp.block_array([[None, grid], [grid.T, None]]))
    rhs = matrix @ rng.standard_normal((2 * side**2, 2))
    if backend == "pardiso":
        with monkeypatch.context() as only, SymmetricSolver(len(rhs)) as solver:
            only.setattr(linear_solver._Pardiso, "match", lambda self: None)
            with refused(Kind.NO_RESULT, error=LinearSolverError):
                solver.solve(matrix, rhs)
    with SymmetricSolver(len(rhs)) as solver:
        found = solver.solve(matrix, rhs)
    assert np.linalg.norm(matrix @ found - rhs) < 1e-10 * np.linalg.norm(rhs)
