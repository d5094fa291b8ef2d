"""The circuit of a sensor is passive, is its lumped library, and is what ngspice makes of the netlist."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import acoustic_fem
import geometry
from acoustic_fem.circuit import CircuitWarning, netlist, save_netlist, sensor_circuit
from acoustic_fem.circuit.passive_circuit import Circuit
from acoustic_fem.circuit.passive_fits import fit_falling, fit_grid, fit_rising
from acoustic_fem.circuit.spice_netlist import pins
from acoustic_fem.circuit.state_space import voltage_per_pascal
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.quantities.local_air import medium_of
from benchmarks.spice import DESIGNS, Spice, burst, missing, pressed


@cache
def solved(name="array-2x6", **changes):
    design = geometry.prototype(name).with_values(changes)
    return acoustic_fem.solve(design, np.arange(1.0, 201.0), "lumped")


@cache
def made(name="array-2x6"):
    return sensor_circuit(solved(name))


def test_the_impedance_of_a_tube_and_the_compliance_of_its_air_are_sums_of_positive_relaxations():
    air, tube, grid = medium_of(None), CircularSection(0.3e-3), fit_grid(1e-3, 300.0)
    for values in (tube.series_impedance(grid, air), tube.shunt_admittance(grid, air)):
        fit = fit_rising(values, grid)
        assert fit.error < 3e-4
        assert min(fit.constant, fit.reactive) >= 0
        assert (fit.weight > 0).all()


def test_a_spring_pot_with_a_mass_is_a_sum_of_positive_relaxations():
    grid = fit_grid(1e-3, 300.0)
    s = 2j * np.pi * grid
    fit = fit_falling((s / 10) ** 0.063 * 5e11 / s + 3e4 * s, grid)
    assert fit.error < 3e-4
    assert (fit.weight > 0).all()
    assert min(fit.constant, fit.reactive, fit.elastic) >= 0


def test_a_circuit_is_solved_as_by_hand():
    circuit = Circuit()
    circuit.add("R", "in", "mid", 50.0)
    circuit.add("L", "mid", "out", 0.2)
    circuit.add("C", "out", "0", 1e-4)
    omega = 2 * np.pi * np.array([3.0, 40.0])
    found = circuit.voltages(omega / (2 * np.pi), {"in": np.array([2.0 + 0j])}, np.empty((0, 2), int), ["out"])
    expected = 2 / (1 - omega**2 * 2e-5 + 50j * omega * 1e-4)
    np.testing.assert_allclose(found[:, 0, 0], expected, rtol=1e-12)


@pytest.mark.parametrize("name", ["array-2x6", "glove", "fingertip-3x4"])
def test_the_circuit_is_the_lumped_library_to_a_thousandth(name):
    sensor = made(name)
    assert sensor.error < 1e-3
    assert all(element.value > 0 for element in sensor.circuit.elements)
    frequency = np.array([1.0, 7.0, 60.0, 200.0])
    pressure, voltage = sensor.at(frequency)
    exact = solved(name).force_response.sel(frequency=frequency).values
    assert np.abs(pressure / exact - 1).max() < 1e-3
    assert np.abs(voltage / (exact * voltage_per_pascal(solved(name), frequency)) - 1).max() < 2e-3


@pytest.mark.parametrize(
    "changes",
    [
        {"resonator.leak_diameter": 0.05},
        {"tube.sheath_material": "silicone"},
        {"resonator.floor_material": "silicone"},
    ],
)
def test_leaks_soft_sheaths_and_soft_floors_are_in_the_circuit(changes):
    design = geometry.prototype("array-2x6")
    if "silicone" in changes.values():
        changes = dict.fromkeys(changes, design.membrane.material)
    assert sensor_circuit(solved(**changes)).error < 1.5e-3


def test_a_circuit_of_another_sensor_than_the_library_is_told():
    library = solved()
    other = replace(library, source_response=library.source_response / 1.25)
    with pytest.warns(CircuitWarning, match="differs from the library by up to 25 %"):
        sensor_circuit(other)


def test_the_netlist_has_the_pins_in_their_order_and_every_element(tmp_path):
    sensor = made()
    save_netlist(sensor, tmp_path / "sensor.cir")
    text = (tmp_path / "sensor.cir").read_text(encoding="utf-8")
    assert text == netlist(sensor)
    body = text[text.index(".subckt") : text.index(".ends")].splitlines()
    heads = [line for line in body if line.startswith("+")]
    assert " ".join(line[2:] for line in heads).split() == pins(sensor)
    assert pins(sensor)[:2] + pins(sensor)[-4:] == ["f1", "f2", "front_A", "front_B", "out_A", "out_B"]
    elements = [line for line in body if line[0] in "RLC"]
    assert len(elements) == len(sensor.circuit.elements)
    assert all(float(line.split()[3]) > 0 for line in elements)
    assert sum(line[0] == "E" for line in body) == len(sensor.circuit.sources)
    assert not re.search(r"nan|inf\b", "\n".join(body))


@pytest.mark.slow
@pytest.mark.skipif(missing() is not None, reason=str(missing()))
@pytest.mark.parametrize("name", DESIGNS)
def test_ngspice_finds_the_library_in_the_netlist(name):
    library, spice = solved(name), Spice(made(name))
    points, frequency = pressed(library)[1:2], np.array([1.0, 10.0, 60.0, 200.0])
    expected = library.force_response.sel(frequency=frequency).values[points]
    assert np.abs(spice.small_signal(points, frequency) / expected - 1).max() < 2e-3
    time = np.arange(800) / 4000.0
    force = np.zeros((len(spice.sensor.forces), len(time)))
    force[points[0]] = burst(time)
    exact = library.simulate(force, 4000.0)
    found = spice.transient(points[0], time)
    assert np.abs(found - exact).max() < 2e-3 * np.abs(exact).max()
