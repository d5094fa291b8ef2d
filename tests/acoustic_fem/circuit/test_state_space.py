"""The state space of a sensor is its library, in frequency, in time and in files."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import scipy.io
import scipy.signal
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.circuit import fit_sensor, save_state_space, state_space
from acoustic_fem.circuit.state_space import PASSIVE_BAND, ROUNDING, passivity_margin, voltage_per_pascal
from acoustic_fem.numerics import RationalFit
from benchmarks.held_presses import held_press, press
from geometry import Kind


@cache
def library(name="array-2x6", fidelity="lumped"):
    return acoustic_fem.solve(geometry.prototype(name), np.arange(1.0, 201.0), fidelity)


@cache
def model(touch="force", output="pressure"):
    return fit_sensor(library(), touch=touch, output=output)


@pytest.mark.parametrize(
    ("touch", "output", "response"),
    [("force", "pressure", "force_response"), ("volume-velocity", "pressure", "source_response")],
)
def test_a_state_space_keeps_the_error_asked_for_between_the_frequencies_too(touch, output, response):
    found, between = model(touch, output), np.arange(1.5, 200, 3.7)
    exact = getattr(acoustic_fem.solve(geometry.prototype("array-2x6"), between, "lumped"), response).values
    assert np.abs(found.at(between) / exact - 1).max() < 1.2e-3
    assert found.error <= 1e-3
    assert found.order <= 20
    assert found.fit.poles.real.max() < 0


def test_its_voltage_is_the_pressure_behind_the_vent_and_the_sensitivity():
    found, frequency = model(output="voltage"), np.array([2.0, 20.0, 150.0])
    expected = library().force_response.sel(frequency=frequency).values * voltage_per_pascal(library(), frequency)
    assert np.abs(found.at(frequency) / expected - 1).max() < 1e-3
    at_corner = np.abs(voltage_per_pascal(library(), np.array([20.0, 1000.0])))
    assert at_corner[1] == pytest.approx(10 ** (-38 / 20), rel=1e-9)
    assert at_corner[0] / at_corner[1] == pytest.approx(2**-0.5, rel=0.03)


def test_it_is_passive_far_outside_the_band_and_one_that_is_not_is_found():
    found = model()
    assert found.margin is not None
    assert found.margin >= -ROUNDING
    point = found.impedances["point_impedance"]
    spoilt = {**found.impedances, "point_impedance": replace(point, constant=point.constant - point.constant.max())}
    at_last = point.at(np.array(PASSIVE_BAND[1:]))[:, 0].real
    assert (at_last > 0).all()
    margin = passivity_margin(spoilt)
    assert margin is not None
    assert margin < -ROUNDING


def test_an_error_that_no_passive_fit_keeps_is_refused_with_the_smallest_that_was_found():
    few = acoustic_fem.solve(geometry.prototype("array-2x6"), np.geomspace(1.0, 200.0, 24), "lumped")
    random = np.random.default_rng(0)
    noise = 1 + 0.05 * random.normal(size=few.transfer_function.shape)
    noisy = replace(few, transfer_function=few.transfer_function * noise)
    with refused(Kind.NO_RESULT, "tolerance", 1e-3) as found:
        fit_sensor(noisy)
    assert "is not reached for array-2x6: the smallest error is" in str(found.value)


@pytest.mark.slow
def test_an_error_that_only_fits_with_energy_keep_is_refused_with_one_that_can_be_kept(monkeypatch):
    tried = []
    fit = state_space.fit_poles
    monkeypatch.setattr(state_space, "fit_poles", lambda *given: tried.append(given[-1]) or fit(*given))
    glove = acoustic_fem.solve(geometry.prototype("glove"), np.arange(1.0, 501.0), "lumped")
    with refused(Kind.NO_RESULT, "tolerance", 1e-6) as found:
        fit_sensor(glove, tolerance=1e-6)
    assert max(tried) < 45  # of 60
    given, order = re.search(r"give tolerance (\S+), which (\d+) poles reach", str(found.value)).groups()
    assert float(given) > 1e-6
    reached = fit_sensor(glove, tolerance=float(given))
    assert reached.order <= int(order)
    assert reached.error <= float(given)


def test_noise_ends_the_search_early(monkeypatch):
    exact = library()
    random = np.random.default_rng(0)
    noise = 1 + 0.01 * random.normal(size=exact.transfer_function.shape)
    tried = []
    fit = state_space.fit_poles
    monkeypatch.setattr(state_space, "fit_poles", lambda *given: tried.append(given[-1]) or fit(*given))
    noisy = replace(exact, transfer_function=exact.transfer_function * noise)
    with refused(Kind.NO_RESULT, "tolerance", 1e-3) as found:
        fit_sensor(noisy)
    assert max(tried) <= 40  # of 60
    assert re.search(r"the smallest error is 0\.0\d+, with \d+ poles", str(found.value))


def test_the_matrices_are_the_poles_and_residues():
    found, frequency = model(), np.array([1.0, 17.0, 180.0])
    system, drive, leaving, through = found.matrices
    assert system.shape == (2 * found.order, 2 * found.order)
    assert through.shape == (2, 12)
    for k, omega in enumerate(2j * np.pi * frequency):
        response = leaving @ np.linalg.solve(omega * np.eye(len(system)) - system, drive) + through
        np.testing.assert_allclose(response.T, found.at(frequency)[..., k], rtol=1e-8)


def test_a_simulation_is_the_state_space_stepped_by_scipy():
    found, rate = model(), 4000.0
    time = np.arange(800) / rate
    force = np.zeros((12, len(time)))
    force[3], force[7] = 1e-3 * np.sin(2 * np.pi * 40 * time) ** 2, 2e-3 * time
    _, expected, _ = scipy.signal.lsim(found.matrices, force.T, time)
    signals = found.simulate(force, rate)
    assert np.abs(signals - expected.T).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.parametrize("leak", [0.0, 0.05])
def test_a_library_simulates_a_press_that_is_held_for_ten_seconds(leak):
    held = held_press("array-2x6", "lumped", 5, leak)
    design = geometry.prototype("array-2x6").with_values({"resonator.leak_diameter": leak})
    solved = acoustic_fem.solve(design, np.arange(1.0, 201.0), "lumped")
    force = np.zeros((12, len(held.time)))
    force[4] = held.force * press(held.time)
    signals = solved.simulate(force, 1000.0)
    assert np.abs(signals - held.reference).max() < 2e-3 * np.abs(held.reference).max()
    coarse = solved.simulate(force[:, ::10], 100.0)
    assert np.abs(coarse[:, 500] / signals[:, 5000] - 1).max() < 5e-3


@pytest.mark.parametrize("suffix", [".mat", ".npz"])
def test_a_file_holds_the_matrices_with_names_and_units(tmp_path, suffix):
    path = tmp_path / f"sensor{suffix}"
    save_state_space(model(), path)
    read = scipy.io.loadmat(path, simplify_cells=True) if suffix == ".mat" else np.load(path)
    for name, values in zip("ABCD", model().matrices, strict=True):
        np.testing.assert_array_equal(np.asarray(read[name]), values)
    np.testing.assert_allclose(read["residues"], model().fit.residues)
    assert str(read["input_unit"]) == "N"
    assert str(read["outputs"]).split("\n") == ["A", "B"]
    assert str(read["inputs"]).split("\n")[11] == "point 12"
    assert isinstance(model().fit, RationalFit)


def test_what_cannot_be_fitted_or_simulated_is_refused(tmp_path):
    with refused(Kind.OUT_OF_RANGE, "touch", "displacement"):
        fit_sensor(library(), touch="displacement")
    with refused(Kind.OUT_OF_RANGE, "output", "current"):
        fit_sensor(library(), output="current")
    with refused(Kind.OUT_OF_RANGE, "tolerance", 1.0):
        fit_sensor(library(), tolerance=1.0)
    with refused(Kind.OUT_OF_RANGE, "band: its highest frequency", 300.0):
        fit_sensor(library(), band=(1.0, 300.0))
    with refused(Kind.OUT_OF_RANGE, "band"):
        fit_sensor(library(), band=(150.0, 155.0))
    with refused(Kind.WRONG_TYPE, "signals"):
        model().simulate(np.zeros((3, 5)), 1000.0)
    with refused(Kind.UNSUITABLE, "signals"):
        model().simulate(np.full((12, 5), np.nan), 1000.0)
    with refused(Kind.OUT_OF_RANGE, "rate", 0):
        model().simulate(np.zeros((12, 5)), 0)
    with refused(Kind.OUT_OF_RANGE, "out: its suffix", ".json"):
        save_state_space(model(), tmp_path / "sensor.json")
