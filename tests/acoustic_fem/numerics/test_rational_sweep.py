"""The reduced model of a system against solving it at every frequency."""

import numpy as np
import pytest
import scipy.sparse as sp
from refusals import refused

from acoustic_fem.numerics.rational_sweep import RationalFitError, passivity_margin, reduce_system, require_passive
from geometry.ground.refusal import Kind

N = 300
STIFFNESS = sp.csr_array(sp.diags_array([-1.0, 2.0, -1.0], offsets=[-1, 0, 1], shape=(N, N)) * N)
MASS = sp.csr_array(sp.eye_array(N) / N)
LOAD = np.zeros((N, 2))
LOAD[0, 0] = LOAD[N // 3, 1] = 1.0
GRID = np.geomspace(1, 1000, 40)


def theta(frequency):
    return np.column_stack([np.ones(len(frequency), dtype=complex), 2j * np.pi * frequency])


def phi(frequency):
    return np.ones((len(frequency), 1), dtype=complex)


def full(frequency):
    return np.stack([LOAD.T @ np.linalg.solve((STIFFNESS + 2j * np.pi * f * MASS).toarray(), LOAD) for f in frequency])


def test_reduced_diffusion_line_matches_the_full_solve_at_every_frequency():
    model = reduce_system([STIFFNESS, MASS], theta, [LOAD], phi, (1.0, 1000.0), tolerance=1e-7)
    exact, reduced = full(GRID), model.response(theta(GRID), phi(GRID))
    scale = np.sqrt(np.abs(exact[:, 0, 0] * exact[:, 1, 1]))[:, None, None]
    assert np.max(np.abs(reduced - exact) / scale) < 1e-6
    assert len(model.sampled) <= 10
    assert model.error <= 1e-7


@pytest.mark.parametrize("half", [0.2e-3, 1e-3, 2e-3, 3e-3, 0.03, 0.1], ids=lambda half: f"{half * 1e3:g} mm")
@pytest.mark.parametrize("band", [(1.0, 500.0), (0.01, 2000.0), (1e-3, 2000.0)], ids=lambda band: f"{band[0]:g} Hz")
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_what_is_stated_holds_for_slabs_thin_and_thick_over_wide_bands(half, band, tolerance):
    """Heat in air between two walls: derivatives at one shift are soon combinations of each other, or bring little."""
    at = np.concatenate([[0.0], np.geomspace(1e-6, half, 400)])
    step = np.diff(at)
    inner = step + np.append(step[1:], 0.0)
    conduction = sp.csr_array(
        sp.diags_array([1 / step + np.append(1 / step[1:], 0.0), -1 / step[1:], -1 / step[1:]], offsets=[0, 1, -1])
    )
    storage = sp.csr_array(sp.diags_array([inner / 3, step[1:] / 6, step[1:] / 6], offsets=[0, 1, -1]))
    load = inner[:, None] / 2
    diffusivity = 2.1e-5

    def heat(frequency):
        return np.column_stack([np.full(len(frequency), diffusivity, complex), 2j * np.pi * frequency])

    model = reduce_system([conduction, storage], heat, [load], phi, band, tolerance=tolerance)
    grid = np.geomspace(*band, 25)
    found = model.response(heat(grid), phi(grid))[:, 0, 0]
    systems = diffusivity * conduction.toarray() + 2j * np.pi * grid[:, None, None] * storage.toarray()
    exact = (np.linalg.solve(systems, load.astype(complex)[None])[:, :, 0] * load[:, 0]).sum(axis=1)
    assert np.abs(found / exact - 1).max() <= max(model.error, 1e-9)
    assert model.error <= tolerance


def test_response_is_symmetric_and_passive():
    model = reduce_system([STIFFNESS, MASS], theta, [LOAD], phi, (1.0, 1000.0))
    response = model.response(theta(GRID), phi(GRID))
    np.testing.assert_array_equal(response, response.transpose(0, 2, 1))
    assert np.linalg.eigvalsh(response.real).min() > 0


def test_kept_basis_recovers_the_field():
    model = reduce_system([STIFFNESS, MASS], theta, [LOAD], phi, (1.0, 1000.0), keep_basis=True)
    coordinates, _ = model.coordinates(theta(GRID[:1]), phi(GRID[:1]))
    field = model.basis @ coordinates[0]
    np.testing.assert_allclose((STIFFNESS + 2j * np.pi * GRID[0] * MASS) @ field, LOAD, atol=1e-4)


def test_a_band_with_too_many_resonances_is_an_error_with_its_numbers():
    def resonant(frequency):
        omega = 2 * np.pi * frequency
        return np.column_stack([np.ones_like(omega), -(omega**2) + 0.01j * omega])

    with pytest.raises(
        RationalFitError, match=r"12 solves between 1 and 1000 Hz leave an error of .* above the tolerance"
    ):
        reduce_system([STIFFNESS, MASS], resonant, [LOAD], phi, (1.0, 1000.0))


def test_a_passive_model_has_a_margin_and_an_active_one_is_refused_at_its_worst_frequency():
    model = reduce_system([STIFFNESS, MASS], theta, [LOAD], phi, (1.0, 1000.0))
    response = model.response(theta(GRID), phi(GRID))
    margin = require_passive(response, GRID)
    assert 0 < margin == passivity_margin(response).min()

    def pumped(frequency):  # storage that gives back more than it took, most so at 100 Hz
        gain = 0.6 * np.exp(-(np.log(frequency / 100) ** 2))
        return theta(frequency) * np.exp(1j * np.pi * gain)[:, None]

    active = model.response(pumped(GRID), phi(GRID))
    assert passivity_margin(active)[0] > 0 > passivity_margin(active).min()
    with pytest.raises(
        RationalFitError, match=r"at \d+(\.\d+)? Hz gives energy: the least eigenvalue of Re Y is -0\.\d+"
    ):
        require_passive(active, GRID)


def test_the_margin_is_the_conductance_between_two_ports_by_hand():
    conductor = np.array([[1, -1], [-1, 1]], dtype=complex)
    assert passivity_margin(np.stack([conductor, conductor + 0.5j * np.eye(2)])) == pytest.approx(0, abs=1e-15)
    # a gyrator neither takes nor gives power; -0.1 S between large ports is seen at the small one's own scale
    gyrator = np.array([[0, 1], [-1, 0]], dtype=complex)
    small = np.diag([1e6, -1e-6]).astype(complex)
    np.testing.assert_allclose(passivity_margin(np.stack([gyrator, small])), [0, -1], atol=1e-15)


def test_a_response_that_is_not_finite_or_not_square_is_refused():
    broken = np.full((1, 2, 2), complex(np.nan, 0))
    with refused(Kind.NO_RESULT, error=RationalFitError):
        require_passive(broken, np.array([5.0]))
    with refused(Kind.WRONG_TYPE, "admittance"):
        passivity_margin(np.eye(2))
