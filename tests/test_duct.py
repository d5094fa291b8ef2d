"""Ducts: reference numbers, limits, invariances."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from reference_data import AIR, column

from acoustic_fem import duct

radii = st.floats(5e-5, 2.5e-3)
lengths = st.floats(1e-5, 1.0)
frequencies = st.floats(1e-3, 1e4)


def in_series(first, second):
    """Two two-ports with their common node eliminated."""
    between = first[1, 1] + second[0, 0]
    return np.array(
        [
            [first[0, 0] - first[0, 1] * first[1, 0] / between, -first[0, 1] * second[0, 1] / between],
            [-second[1, 0] * first[1, 0] / between, second[1, 1] - second[1, 0] * second[0, 1] / between],
        ]
    )


def test_impedance_and_admittance_per_length_agree_with_the_reference():
    radius, frequency = column("duct_per_length", "radius"), column("duct_per_length", "frequency")
    np.testing.assert_allclose(duct.series_impedance(radius, frequency, AIR), column("duct_per_length", "Z"), rtol=1e-9)
    np.testing.assert_allclose(duct.shunt_admittance(radius, frequency, AIR), column("duct_per_length", "Y"), rtol=1e-9)


def test_port_admittance_agrees_with_the_reference():
    radius, length, frequency = (column("duct_two_port", name) for name in ("radius", "length", "frequency"))
    admittance = duct.port_admittance(radius, length, frequency, AIR)
    assert admittance.shape == (len(frequency), 2, 2)
    np.testing.assert_allclose(admittance[:, 0, 0], column("duct_two_port", "Y11"), rtol=1e-9)
    np.testing.assert_allclose(admittance[:, 0, 1], column("duct_two_port", "Y12"), rtol=1e-9)


@given(radii)
def test_series_impedance_tends_to_poiseuille_flow_and_four_thirds_of_the_mass(radius):
    frequency = 1e-3
    impedance = duct.series_impedance(radius, frequency, AIR)
    assert impedance.real == pytest.approx(8 * AIR.viscosity / (np.pi * radius**4), rel=1e-4)
    mass = 4 * AIR.density / (3 * np.pi * radius**2)
    assert impedance.imag == pytest.approx(2 * np.pi * frequency * mass, rel=1e-3)


@given(radii)
def test_shunt_admittance_tends_to_isothermal_compression(radius):
    frequency = 1e-3
    admittance = duct.shunt_admittance(radius, frequency, AIR)
    isothermal = 2 * np.pi * frequency * np.pi * radius**2 / AIR.pressure
    assert admittance.imag == pytest.approx(isothermal, rel=1e-4)
    # first order of 1 - J: (kt a)^2 / 8, which double precision must not lose
    slow = 2 * np.pi * frequency * radius**2 / AIR.thermal_diffusivity / 8
    assert admittance.real == pytest.approx(isothermal * (AIR.gamma - 1) / AIR.gamma * slow, rel=1e-3)


def test_wide_ducts_tend_to_the_lossless_wave():
    radius, frequency = 0.05, 1e4
    omega, section = 2 * np.pi * frequency, np.pi * radius**2
    impedance = duct.series_impedance(radius, frequency, AIR)
    admittance = duct.shunt_admittance(radius, frequency, AIR)
    assert impedance == pytest.approx(1j * omega * AIR.density / section, rel=2e-3)
    assert admittance == pytest.approx(1j * omega * section / (AIR.gamma * AIR.pressure), rel=2e-3)


@given(radii, lengths, frequencies, st.floats(0.01, 0.99))
def test_a_duct_cut_in_two_is_the_same_duct(radius, length, frequency, cut):
    whole = duct.port_admittance(radius, length, frequency, AIR)
    parts = [duct.port_admittance(radius, part * length, frequency, AIR) for part in (cut, 1 - cut)]
    joined = in_series(*parts)
    np.testing.assert_allclose(joined, whole, rtol=1e-9, atol=1e-12 * abs(whole[0, 0]))


@given(radii, lengths, frequencies)
def test_a_duct_is_reciprocal_and_passive(radius, length, frequency):
    admittance = duct.port_admittance(radius, length, frequency, AIR)
    assert admittance[0, 1] == admittance[1, 0]
    assert np.linalg.eigvalsh(admittance.real).min() >= -1e-12 * abs(admittance[0, 0])


def test_very_short_and_very_long_ducts_stay_finite():
    short = duct.port_admittance(2.5e-4, 1e-9, 10.0, AIR)
    np.testing.assert_allclose(short[0, 0], 1 / (duct.series_impedance(2.5e-4, 10.0, AIR) * 1e-9), rtol=1e-12)
    long = duct.port_admittance(2.5e-4, 1e6, 1e4, AIR)
    characteristic = np.sqrt(duct.shunt_admittance(2.5e-4, 1e4, AIR) / duct.series_impedance(2.5e-4, 1e4, AIR))
    assert long[0, 0] == pytest.approx(characteristic, rel=1e-14)
    assert long[0, 1] == 0


def test_radius_length_and_frequency_broadcast():
    radius = np.array([1e-4, 3e-4])[:, None]
    frequency = np.array([1.0, 10.0, 100.0])
    admittance = duct.port_admittance(radius, 0.01, frequency, AIR)
    assert admittance.shape == (2, 3, 2, 2)
    np.testing.assert_allclose(admittance[1, 2], duct.port_admittance(3e-4, 0.01, 100.0, AIR), rtol=1e-14)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 0.01, 10.0), "radius = 0 m"),
        ((1e-4, -0.01, 10.0), "length = -0.01 m"),
        ((1e-4, 0.01, [1.0, 0.0]), "frequency = 0 Hz"),
        ((1e-4, 0.01, float("nan")), "frequency = nan Hz"),
    ],
)
def test_a_value_that_is_not_positive_is_refused_by_name(arguments, message):
    with pytest.raises(ValueError) as error:
        duct.port_admittance(*arguments, AIR)
    assert message in str(error.value)
