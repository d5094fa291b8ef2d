"""Simulations in time keep the error that a library deserves, and warn of forces that are too fast for it."""

import warnings
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
from acoustic_fem.circuit.force_simulation import SIMULATED, default_tolerance, peak_above
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry import Kind

MEASURED = Path(__file__).parents[3] / "docs" / "examples" / "recordings" / "library.nc"
RATE = 2000.0


@cache
def library():
    return acoustic_fem.solve("array-2x6", np.arange(1.0, 126.0), "lumped")


@cache
def noisy(deviation):
    random, exact = np.random.default_rng(0), library().transfer_function
    noise = deviation * (random.normal(size=exact.shape) + 1j * random.normal(size=exact.shape))
    return replace(
        library(),
        transfer_function=exact * (1 + noise),
        transfer_function_deviation=deviation * np.abs(exact),
    )


def press(rise, rate=RATE, smooth=True):
    """Force on point 5 that rises in a time, s, and is held."""
    ramp = np.clip((np.arange(round(0.3 * rate)) / rate - 0.05) / rise, 0, 1)
    force = np.zeros((12, len(ramp)))
    force[4] = 5e-3 * (np.sin(np.pi / 2 * ramp) ** 2 if smooth else ramp)
    return force


def test_the_measured_library_of_the_examples_is_simulated():
    measured = acoustic_fem.load(MEASURED)
    assert measured.fidelity == "measured"
    signals = measured.simulate(press(0.05), RATE)
    expected = library().simulate(press(0.05), RATE)
    assert signals.shape == expected.shape
    assert np.abs(signals[:, -1] / expected[:, -1] - 1).max() < 0.3


def test_noise_of_a_measurement_does_not_stop_a_simulation_and_hardly_changes_it():
    exact = library().simulate(press(0.05), RATE)
    assert default_tolerance(library()) == SIMULATED
    assert 3 * 0.01 < default_tolerance(noisy(0.01)) < 6 * 0.01
    found = noisy(0.01).simulate(press(0.05), RATE)
    assert np.abs(found - exact).max() < 0.03 * np.abs(exact).max()


def test_the_refusal_names_an_argument_of_simulate_that_helps():
    without = replace(noisy(0.003), transfer_function_deviation=None)
    with refused(Kind.NO_RESULT, "tolerance", SIMULATED) as found:
        without.simulate(press(0.05), RATE)
    reached = float(str(found.value).partition("give tolerance ")[2].partition(",")[0])
    assert without.simulate(press(0.05), RATE, tolerance=reached).shape == (2, 600)
    with refused(Kind.OUT_OF_RANGE, "tolerance", 0.5):
        library().simulate(press(0.05), RATE, tolerance=0.5)


def test_a_library_of_too_few_frequencies_is_refused():
    few = acoustic_fem.solve("array-2x6", np.geomspace(1.0, 200.0, 11), "lumped")
    with refused(Kind.OUT_OF_RANGE, "library") as found:
        few.simulate(press(0.05), RATE)
    assert "has 11 frequencies; a simulation needs at least 12" in str(found.value)
    with refused(Kind.OUT_OF_RANGE, "band"):
        acoustic_fem.circuit.fit_sensor(few, band=(1e-3, 200.0))


def test_a_force_that_is_too_fast_for_the_library_warns_and_a_slow_one_does_not():
    with pytest.warns(ModelLimitWarning, match="above 125 Hz, the last frequency of the library, peaks at [0-9]+ %"):
        library().simulate(press(5e-4), RATE)
    with warnings.catch_warnings():
        warnings.simplefilter("error", ModelLimitWarning)
        library().simulate(press(0.05), RATE)


@pytest.mark.parametrize("rate", [100.0, 2000.0, 16000.0])
def test_the_part_above_a_frequency_is_that_of_straight_lines_at_any_rate(rate):
    # Each of the two bends of a ramp has a part that peaks at slope / (2 pi^2 f).
    expected = 1 / (2 * np.pi**2 * 125.0 * 0.1)
    assert peak_above(press(0.1, rate, smooth=False), rate, 125.0) == pytest.approx(expected, rel=0.1)


def test_a_sine_counts_if_it_is_above_and_not_if_it_is_below():
    time = np.arange(4000) / RATE
    fade = np.sin(np.pi * time / time[-1]) ** 2
    for frequency, above in ((40.0, 0.0), (250.0, 1.0)):
        force = (fade * np.sin(2 * np.pi * frequency * time))[None]
        assert peak_above(force, RATE, 125.0) == pytest.approx(above, abs=0.03)
    assert peak_above(np.zeros((12, 50)), RATE, 125.0) == 0.0
