"""Presses that are held: they neither fade nor stay where air leaks out, and rubber creeps after them."""

import numpy as np
import pytest

import acoustic_fem
import geometry
from acoustic_fem.library.closed_form import ClosedForm
from benchmarks.held_presses import BEGIN, CASES, HOLD, LEAKS, RISE, held_press
from localize.contacts.relaxation_series import SLOW, RelaxationSeries
from localize.signals import response_of

RELEASED = BEGIN + 2 * RISE + HOLD


def relaxing(frequency, corner, exponent=1.0):
    return 1 / (1 + (1j * frequency / corner) ** exponent)


@pytest.mark.parametrize("corner", [0.0013, 0.02, 0.31, 4.4])
def test_rates_that_are_chosen_beforehand_follow_a_relaxation_at_any_rate(corner):
    grid = np.geomspace(1e-3, 30, 80)
    series = RelaxationSeries.of(relaxing(grid, corner), grid)
    between = np.geomspace(1.1e-3, 29, 333)
    assert np.abs(series.at(between) / relaxing(between, corner) - 1).max() < 1e-4


def test_a_series_follows_a_spring_pot_over_four_decades():
    grid = np.geomspace(1e-3, 30, 80)
    series = RelaxationSeries.of((1j * grid) ** -0.063, grid)
    between = np.geomspace(1.1e-3, 29, 333)
    assert np.abs(series.at(between) / (1j * between) ** -0.063 - 1).max() < 1e-4


def test_a_recursion_is_the_convolution_with_the_exponentials_and_knows_its_own_spectrum():
    rate, sample_rate = np.array([0.02, 0.7]), 100.0
    series = RelaxationSeries(rate, np.array([[[1.0, -3.0]], [[0.5, 2.0]]]), np.zeros((2, 1)))
    drive = np.zeros((2, 5000))
    drive[:, 100] = 1.0
    time = np.arange(5000 - 100) / sample_rate
    expected = ((series.weight.sum(axis=0)[0, :, None] * np.exp(-rate[:, None] * time)).sum(axis=0)) / sample_rate
    expected[0] /= 2  # a jump counts half
    found = series.through(drive, sample_rate)[0, 100:]
    np.testing.assert_allclose(found, expected, rtol=1e-10)

    steady = RelaxationSeries(np.array([30.0]), np.array([[[2.0]]]), np.zeros((1, 1)))
    tone = np.cos(2 * np.pi * 5.0 * np.arange(1000) / sample_rate)[None]
    spectrum = steady.sampled_at(np.array([5.0]), sample_rate)[0, 0, 0]
    end = slice(500, 1000)
    expected = (spectrum * np.exp(2j * np.pi * 5.0 * np.arange(1000) / sample_rate)).real
    np.testing.assert_allclose(steady.through(tone, sample_rate)[0, end], expected[end], atol=1e-12)


def test_slow_exponentials_are_those_that_outlast_a_period():
    grid = np.geomspace(1e-3, 30, 80)
    slow = RelaxationSeries.of(relaxing(grid, 0.1), grid).slow()
    assert slow.rate.max() <= 2 * np.pi * SLOW
    assert slow.constant == 0


@pytest.mark.parametrize("leak", [0.0, 0.05])
def test_a_press_that_is_held_for_ten_seconds_is_the_inverse_transform_of_the_network_from_1_mhz(leak):
    found = held_press("array-2x6", "lumped", 5, leak)
    assert found.largest < 3e-4
    for time in (3.0, 9.0, RELEASED + 1.0, RELEASED + 9.0):
        assert found.error_at(time)[1] < 5e-3
    held, _ = found.error_at(9.0)
    assert abs(held) > 20 if leak == 0 else abs(held) < 0.1
    # Rubber creeps: it holds the membrane in for seconds after the finger has left.
    crept, _ = found.error_at(RELEASED + 1.0)
    assert abs(crept) > 0.03 * np.abs(found.reference).max()


@pytest.mark.slow
@pytest.mark.parametrize(("name", "fidelity", "point"), CASES)
@pytest.mark.parametrize("leak", LEAKS)
def test_presses_are_held_and_leak_away_as_the_evidence_says(name, fidelity, point, leak):
    found = held_press(name, fidelity, point, leak)
    assert found.largest < 1e-3
    assert all(found.error_at(time)[1] < 1e-2 for time in (3.0, 9.0))


def test_a_design_that_leaks_is_not_sealed_and_its_transfer_functions_fall_short_of_one():
    tight, leaky = (
        acoustic_fem.solve(
            geometry.prototype("array-2x6").with_values({"resonator.leak_diameter": leak}), [1, 2, 3, 50, 100], "lumped"
        )
        for leak in (0.0, 0.1)
    )
    assert response_of(tight).sealed
    assert not response_of(leaky).sealed
    still = [response_of(each).between(np.zeros(1))[0][..., 0] for each in (tight, leaky)]
    solved = acoustic_fem.solve(leaky.design, [1e-3], "lumped").transfer_function.values[..., 0]
    np.testing.assert_allclose(still[0], 1, atol=1e-3)
    np.testing.assert_allclose(still[1], solved, atol=1e-3)
    assert np.abs(still[1]).min() < 0.6


def test_between_its_frequencies_a_library_follows_the_closed_forms_and_at_them_itself():
    design = geometry.prototype("line-2")
    coarse = acoustic_fem.solve(design, np.arange(1.0, 101.0), "lumped")
    response = response_of(coarse)
    between = np.array([0.01, 0.3, 1.5, 2.25, 37.7])
    transfer, cavity = response.between(between)
    closed = ClosedForm(design, coarse.medium).at(between)
    known, known_cavity = closed["transfer_function"], closed["cavity_response"]
    np.testing.assert_allclose(transfer, known, rtol=1e-9)
    np.testing.assert_allclose(cavity, known_cavity, rtol=1e-9)
    # a spline alone is not as near
    assert np.abs(response.at(between[1:]) / known[..., 1:] - 1).max() > 1e-3

    better = acoustic_fem.solve(design, np.arange(1.0, 101.0), "atlas")
    exact = acoustic_fem.solve(design, np.array([1.5, 2.25, 37.7]), "atlas")
    found = response_of(better).between(np.array([1.5, 2.25, 37.7]))[0]
    np.testing.assert_allclose(found, exact.transfer_function.values, rtol=1e-5)
    np.testing.assert_allclose(
        response_of(better).between(better.frequency)[0], better.transfer_function.values, rtol=1e-12
    )
