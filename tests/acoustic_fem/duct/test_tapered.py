"""Ducts of varying section: exact horns, order of convergence, limits, bad input."""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from reference_data import AIR
from refusals import refused

from acoustic_fem.duct import plane_wave, tapered
from acoustic_fem.duct.sections import CircularSection, SlitSection
from geometry.ground.refusal import Kind

SERIES, SHUNT, FLARE, LENGTH = 3e11 + 1e12j, 2e-7 + 5e-6j, 80.0, 0.002


@dataclass(frozen=True)
class HornSlice(plane_wave.Line):
    """Z' falls and Y' grows with the section, exp(2 m x): solved by exponentials."""

    place: float

    def series_impedance(self, frequency, medium):
        return np.full(np.shape(frequency), SERIES * np.exp(-2 * FLARE * self.place))

    def shunt_admittance(self, frequency, medium):
        return np.full(np.shape(frequency), SHUNT * np.exp(2 * FLARE * self.place))


def exact_horn():
    """p = exp(-m x) (A exp(k x) + B exp(-k x)), k^2 = m^2 + Z'Y'; Kinsler et al. (2000), section 14.8."""
    k = np.sqrt(FLARE**2 + SERIES * SHUNT)
    rates = np.array([k - FLARE, -k - FLARE])
    far = np.exp(rates * LENGTH)
    pressure = np.array([[1, 1], far])
    flow = np.array([-rates / SERIES, rates * far / (SERIES * np.exp(-2 * FLARE * LENGTH))])
    return flow @ np.linalg.inv(pressure)


def cone(first, last, length):
    return lambda x: CircularSection(first + (last - first) * x / length)


def test_the_exponential_horn_is_met_to_the_accuracy_asked_for():
    result = tapered.solve(HornSlice, LENGTH, [1.0], AIR, accuracy=1e-10)
    np.testing.assert_allclose(result.admittance[0], exact_horn(), rtol=1e-10)
    assert result.error <= 1e-10


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_the_two_port_converges_with_twice_the_degree(degree):
    errors = []
    for count in (8, 16, 32) if degree < 3 else (4, 8, 16):
        nodes = np.linspace(0, LENGTH, count + 1)
        transfer, first, last = tapered.assemble(HornSlice, nodes, np.array([1.0]), AIR, degree)[:, 0]
        admittance = np.array([[first + transfer, -transfer], [-transfer, last + transfer]])
        errors.append(np.abs(admittance / exact_horn() - 1).max())
    order = np.log2(np.array(errors[:-1]) / errors[1:])
    assert order == pytest.approx(2 * degree, abs=0.2)


@settings(max_examples=30)
@given(st.floats(5e-5, 2e-3), st.floats(1e-3, 0.1))
def test_a_constant_section_gives_the_uniform_duct(radius, length):
    frequency = np.array([0.01, 1.0, 100.0, 2000.0])
    result = tapered.port_admittance(lambda x: CircularSection(radius), length, frequency, AIR)
    exact = plane_wave.port_admittance(radius, length, frequency, AIR)
    scale = np.abs(exact[:, :1, :1])
    np.testing.assert_allclose(result / scale, exact / scale, rtol=1e-9, atol=1e-9)


def test_the_resistance_of_a_cone_is_the_integral_of_poiseuille():
    first, last, length = 2e-4, 4.5e-4, 0.0125
    slope = (last - first) / length
    resistance = 8 * AIR.viscosity / np.pi * (first**-3 - last**-3) / (3 * slope)
    admittance = tapered.port_admittance(cone(first, last, length), length, [1e-3], AIR)
    assert 1 / admittance[0, 0, 0].real == pytest.approx(resistance, rel=1e-9, abs=0)


def test_the_compliance_of_a_cone_is_its_volume_over_the_pressure():
    first, last, length, frequency = 2e-4, 4.5e-4, 0.0125, 1e-2
    volume = np.pi * length * (first**2 + first * last + last**2) / 3
    admittance = tapered.port_admittance(cone(first, last, length), length, [frequency], AIR)[0]
    assert admittance.sum().imag == pytest.approx(2 * np.pi * frequency * volume / AIR.pressure, rel=1e-6, abs=0)


@pytest.mark.slow
@settings(max_examples=20)
@given(st.floats(1e-4, 1e-3), st.floats(1e-4, 1e-3), st.floats(0.1, 2000))
def test_a_cone_is_reciprocal_passive_and_the_same_seen_from_its_other_end(first, last, frequency):
    length = 0.02
    there = tapered.port_admittance(cone(first, last, length), length, [frequency], AIR, accuracy=1e-8)[0]
    back = tapered.port_admittance(cone(last, first, length), length, [frequency], AIR, accuracy=1e-8)[0]
    np.testing.assert_allclose(there, back[::-1, ::-1], rtol=1e-7)
    assert there[0, 1] == there[1, 0]
    assert np.linalg.eigvalsh(there.real).min() >= -1e-9 * abs(there[0, 0])


def test_a_step_at_a_break_is_two_ducts_in_a_row():
    frequency = np.array([1.0, 100.0])
    slit, bore = SlitSection(3e-4, 2e-3), CircularSection(4e-4)
    whole = tapered.port_admittance(lambda x: slit if x < 0.004 else bore, 0.01, frequency, AIR, breaks=[0.004])
    one, two = slit.port_admittance(0.004, frequency, AIR), bore.port_admittance(0.006, frequency, AIR)
    transfer = -one[:, 0, 1] * two[:, 0, 1] / (one[:, 1, 1] + two[:, 0, 0])
    np.testing.assert_allclose(whole[:, 0, 1], transfer, rtol=1e-9)


def test_a_step_without_its_break_is_refused_not_guessed(monkeypatch):
    monkeypatch.setattr(tapered, "_MAX_ELEMENTS", 64)
    with refused(Kind.NO_RESULT, error=tapered.TaperError):
        tapered.solve(lambda x: CircularSection(2e-4 if x < 0.0037 else 4e-4), 0.01, [10.0], AIR)


@pytest.mark.parametrize(
    ("field", "value", "kind"),
    [
        ("length", 0.0, Kind.OUT_OF_RANGE),
        ("frequency", [1.0, -2.0], Kind.OUT_OF_RANGE),
        ("frequency", [[1.0]], Kind.WRONG_TYPE),
        ("breaks", [0.02], Kind.OUT_OF_RANGE),
        ("accuracy", 0.0, Kind.OUT_OF_RANGE),
    ],
)
def test_bad_input_is_refused_by_name(field, value, kind):
    arguments = {"section": cone(1e-4, 2e-4, 0.01), "length": 0.01, "frequency": [1.0], "medium": AIR, field: value}
    with refused(kind, field):
        tapered.solve(**arguments)
