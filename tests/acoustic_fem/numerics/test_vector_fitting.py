"""Vector fitting finds poles that are known, keeps them stable, and steps them exactly in time."""

from itertools import pairwise

import numpy as np
import pytest
from refusals import refused

from acoustic_fem.numerics import RationalFit, VectorFitError, fit_poles
from geometry import Kind

GRID = np.geomspace(0.1, 100.0, 120)
POLES = np.array([-800.0, -30.0, -2.0, -20 + 200j, -20 - 200j])


def known(seed=0, count=6, poles=POLES):
    random = np.random.default_rng(seed)
    residues = random.normal(size=(count, len(poles))) + 0j
    pairs = np.flatnonzero(poles.imag > 0)
    residues[:, pairs] += 1j * random.normal(size=(count, len(pairs)))
    residues[:, pairs + 1] = residues[:, pairs].conj()
    residues *= np.abs(poles)
    return RationalFit(poles, residues, random.normal(size=count))


@pytest.mark.parametrize("seed", range(4))
def test_poles_and_residues_of_a_rational_function_are_found_again(seed):
    exact = known(seed)
    fit = fit_poles(exact.at(GRID), GRID, len(POLES))
    np.testing.assert_allclose(np.sort_complex(fit.poles), np.sort_complex(POLES), rtol=1e-7)
    elsewhere = np.geomspace(0.01, 1000.0, 77)
    np.testing.assert_allclose(fit.at(elsewhere), exact.at(elsewhere), rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(fit.constant, exact.constant, rtol=1e-6)


def test_small_responses_are_fitted_as_well_as_large_ones():
    exact = known(3, count=2)
    scale = np.array([[1.0], [1e-6]])
    fit = fit_poles(scale * exact.at(GRID), GRID, len(POLES))
    assert fit.error(scale * exact.at(GRID), GRID) < 1e-8


def test_a_diffusive_line_is_fitted_with_an_error_that_falls_with_the_order():
    x = np.sqrt(2j * np.pi * GRID / 3.0)
    values = np.stack([1 / np.cosh(x), np.tanh(x) / x])
    errors = [fit_poles(values, GRID, order).error(values, GRID) for order in (4, 6, 8, 10)]
    assert all(later < earlier / 2 for earlier, later in pairwise(errors))
    assert errors[-1] < 1e-4


def test_poles_are_stable_and_come_in_pairs_where_the_data_is_noisy():
    random = np.random.default_rng(1)
    exact = known(1).at(GRID)
    noisy = exact * (1 + 0.02 * (random.normal(size=exact.shape) + 1j * random.normal(size=exact.shape)))
    fit = fit_poles(noisy, GRID, 16)
    assert fit.poles.real.max() < 0
    upper = fit.poles[fit.poles.imag > 0]
    np.testing.assert_array_equal(np.sort_complex(fit.poles[fit.poles.imag < 0].conj()), np.sort_complex(upper))
    assert np.abs(fit.at(np.zeros(1)).imag).max() < 1e-9 * np.abs(fit.at(np.zeros(1))).max()


@pytest.mark.parametrize("rate", [50.0, 1000.0, 48000.0])
def test_straight_lines_between_samples_are_stepped_exactly(rate):
    # Of one pole p and a ramp u = t: y = (exp(p t) - 1 - p t) / p^2.
    time = np.arange(200) / rate
    for pole in (-0.003, -5.0, -4000.0):
        fit = RationalFit(np.array([pole + 0j]), np.array([[[2.0 + 0j]]]), np.array([[0.5]]))
        found = fit.through(time[None], rate)[0]
        expected = 2 * (np.expm1(pole * time) - pole * time) / pole**2 + 0.5 * time
        np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-12 * expected.max())
    pole = -3 + 40j
    fit = RationalFit(np.array([pole, pole.conjugate()]), np.array([[[1 - 2j, 1 + 2j]]]), np.zeros((1, 1)))
    expected = 2 * ((1 - 2j) * (np.exp(pole * time) - 1 - pole * time) / pole**2).real
    np.testing.assert_allclose(fit.through(time[None], rate)[0], expected, rtol=1e-6, atol=1e-9)


def test_an_order_that_the_frequencies_cannot_hold_is_refused():
    with refused(Kind.OUT_OF_RANGE, "order", 61) as found:
        fit_poles(known().at(GRID), GRID, 61)
    assert isinstance(found.value, VectorFitError)
