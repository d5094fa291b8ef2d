"""Ducts: reference numbers, limits, invariances."""

import json
from pathlib import Path

import mpmath
import numpy as np
import openwind_ladder
import pytest
from hypothesis import given, strategies as st
from reference_data import AIR, column
from refusals import refused

from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.quantities.medium import Medium
from geometry.ground.refusal import Kind

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
    np.testing.assert_allclose(
        plane_wave.series_impedance(radius, frequency, AIR), column("duct_per_length", "Z"), rtol=1e-9
    )
    np.testing.assert_allclose(
        plane_wave.shunt_admittance(radius, frequency, AIR), column("duct_per_length", "Y"), rtol=1e-9
    )


def test_port_admittance_agrees_with_the_reference():
    radius, length, frequency = (column("duct_two_port", name) for name in ("radius", "length", "frequency"))
    admittance = plane_wave.port_admittance(radius, length, frequency, AIR)
    assert admittance.shape == (len(frequency), 2, 2)
    np.testing.assert_allclose(admittance[:, 0, 0], column("duct_two_port", "Y11"), rtol=1e-9)
    np.testing.assert_allclose(admittance[:, 0, 1], column("duct_two_port", "Y12"), rtol=1e-9)


@pytest.mark.parametrize("count", [3, 2000])
def test_each_radius_length_grid_and_gas_has_its_own_duct(count):
    for _ in range(2):
        for medium in (AIR, Medium.at(30, 0.5)):
            for radius, length in ((2e-4, 0.01), (2e-4, 0.02), (3e-4, 0.01)):
                for grid in (np.linspace(1, 100, count), np.linspace(1, 101, count)):
                    duct = plane_wave.port_admittance(radius, length, grid, medium)
                    series = plane_wave.series_impedance(radius, grid, medium)
                    shunt = plane_wave.shunt_admittance(radius, grid, medium)
                    np.testing.assert_array_equal(duct, plane_wave.two_port(series, shunt, length))
                    duct[:] = 0  # what is kept is another array


@given(radii)
def test_series_impedance_tends_to_poiseuille_flow_and_four_thirds_of_the_mass(radius):
    frequency = 1e-3
    impedance = plane_wave.series_impedance(radius, frequency, AIR)
    assert impedance.real == pytest.approx(8 * AIR.viscosity / (np.pi * radius**4), rel=1e-4, abs=0)
    mass = 4 * AIR.density / (3 * np.pi * radius**2)
    assert impedance.imag == pytest.approx(2 * np.pi * frequency * mass, rel=1e-3, abs=0)


@given(radii)
def test_shunt_admittance_tends_to_isothermal_compression(radius):
    frequency = 1e-3
    admittance = plane_wave.shunt_admittance(radius, frequency, AIR)
    isothermal = 2 * np.pi * frequency * np.pi * radius**2 / AIR.pressure
    assert admittance.imag == pytest.approx(isothermal, rel=1e-4, abs=0)
    # first order of 1 - J: (kt a)^2 / 8, which double precision must not lose
    slow = 2 * np.pi * frequency * radius**2 / AIR.thermal_diffusivity / 8
    assert admittance.real == pytest.approx(isothermal * (AIR.gamma - 1) / AIR.gamma * slow, rel=1e-3, abs=0)


def test_wide_ducts_tend_to_the_lossless_wave():
    radius, frequency = 0.05, 1e4
    omega, section = 2 * np.pi * frequency, np.pi * radius**2
    impedance = plane_wave.series_impedance(radius, frequency, AIR)
    admittance = plane_wave.shunt_admittance(radius, frequency, AIR)
    assert impedance == pytest.approx(1j * omega * AIR.density / section, rel=2e-3, abs=0)
    assert admittance == pytest.approx(1j * omega * section / (AIR.gamma * AIR.pressure), rel=2e-3, abs=0)


@given(radii, lengths, frequencies, st.floats(0.01, 0.99))
def test_a_duct_cut_in_two_is_the_same_duct(radius, length, frequency, cut):
    whole = plane_wave.port_admittance(radius, length, frequency, AIR)
    parts = [plane_wave.port_admittance(radius, part * length, frequency, AIR) for part in (cut, 1 - cut)]
    joined = in_series(*parts)
    np.testing.assert_allclose(joined, whole, rtol=1e-9, atol=1e-12 * abs(whole[0, 0]))


@given(radii, lengths, frequencies)
def test_a_duct_is_reciprocal_and_passive(radius, length, frequency):
    admittance = plane_wave.port_admittance(radius, length, frequency, AIR)
    assert admittance[0, 1] == admittance[1, 0]
    assert np.linalg.eigvalsh(admittance.real).min() >= -1e-12 * abs(admittance[0, 0])


def test_very_short_and_very_long_ducts_stay_finite():
    short = plane_wave.port_admittance(2.5e-4, 1e-9, 10.0, AIR)
    np.testing.assert_allclose(short[0, 0], 1 / (plane_wave.series_impedance(2.5e-4, 10.0, AIR) * 1e-9), rtol=1e-12)
    long = plane_wave.port_admittance(2.5e-4, 1e6, 1e4, AIR)
    characteristic = np.sqrt(
        plane_wave.shunt_admittance(2.5e-4, 1e4, AIR) / plane_wave.series_impedance(2.5e-4, 1e4, AIR)
    )
    assert long[0, 0] == pytest.approx(characteristic, rel=1e-14, abs=0)
    assert long[0, 1] == 0


def test_radius_length_and_frequency_broadcast():
    radius = np.array([1e-4, 3e-4])[:, None]
    frequency = np.array([1.0, 10.0, 100.0])
    admittance = plane_wave.port_admittance(radius, 0.01, frequency, AIR)
    assert admittance.shape == (2, 3, 2, 2)
    np.testing.assert_allclose(admittance[1, 2], plane_wave.port_admittance(3e-4, 0.01, 100.0, AIR), rtol=1e-14)


@pytest.mark.parametrize(
    ("arguments", "field"),
    [
        ((0.0, 0.01, 10.0), "radius"),
        ((1e-4, -0.01, 10.0), "length"),
        ((1e-4, 0.01, [1.0, 0.0]), "frequency"),
        ((1e-4, 0.01, float("nan")), "frequency"),
    ],
)
def test_a_value_that_is_not_positive_is_refused_by_name(arguments, field):
    with refused(Kind.OUT_OF_RANGE, field):
        plane_wave.port_admittance(*arguments, AIR)


def exact_per_length(radius, frequency):
    """Z' and Y' of a round bore with 40 digits."""
    a, omega = mpmath.mpf(radius), 2 * mpmath.pi * mpmath.mpf(frequency)
    section, density, gamma = mpmath.pi * a**2, mpmath.mpf(AIR.density), mpmath.mpf(AIR.gamma)

    def mean(diffusivity):
        argument = a * mpmath.sqrt(-1j * omega / diffusivity)
        return -mpmath.besselj(2, argument) / mpmath.besselj(0, argument)

    viscous = mean(mpmath.mpf(AIR.viscosity) / density)
    thermal = mean(mpmath.mpf(AIR.conductivity) / (density * mpmath.mpf(AIR.heat_capacity)))
    stored = gamma - (gamma - 1) * thermal
    return 1j * omega * density / (section * viscous), 1j * omega * section / (gamma * AIR.pressure) * stored


def relative_error(value, exact):
    return float(abs(mpmath.mpmathify(value.item()) - exact) / abs(exact))


@pytest.fixture
def forty_digits():
    with mpmath.workdps(40):
        yield


@pytest.mark.usefixtures("forty_digits")
@pytest.mark.parametrize("radius", np.geomspace(2.5e-5, 2.5e-3, 7))
def test_per_length_values_hold_1e_12_against_high_precision_bessel_functions(radius):
    """Modulus, real and imaginary part each; bores 0.05 to 5 mm, 0.01 Hz to 20 kHz."""
    for frequency in np.geomspace(0.01, 2e4, 15):
        for value, exact in zip(
            (plane_wave.series_impedance(radius, frequency, AIR), plane_wave.shunt_admittance(radius, frequency, AIR)),
            exact_per_length(radius, frequency),
            strict=True,
        ):
            assert relative_error(value, exact) < 5e-15
            assert relative_error(value.real, exact.real) < 1e-13
            assert relative_error(value.imag, exact.imag) < 1e-13


@pytest.mark.usefixtures("forty_digits")
@pytest.mark.parametrize("length", [1e-9, 1e-5, 1e-3, 0.0125, 0.12, 1.0, 30.0, 1e3])
def test_two_ports_hold_1e_12_against_high_precision_hyperbolic_functions(length):
    """Up to |Gamma L| = 1000, and 1e-15 |Gamma L| beyond: what rounding the length costs. No overflow."""
    for radius in np.geomspace(2.5e-5, 2.5e-3, 4):
        for frequency in np.geomspace(0.01, 2e4, 7):
            series, shunt = exact_per_length(radius, frequency)
            exponent, characteristic = mpmath.sqrt(series * shunt) * mpmath.mpf(length), mpmath.sqrt(series / shunt)
            admittance = plane_wave.port_admittance(radius, length, frequency, AIR)
            assert np.isfinite(admittance).all()
            tolerance = 1e-12 * max(1.0, float(abs(exponent)) / 1000)
            assert relative_error(admittance[0, 0], mpmath.coth(exponent) / characteristic) < tolerance
            transfer = -1 / (mpmath.sinh(exponent) * characteristic)
            if abs(transfer) > 1e-290:
                assert relative_error(admittance[0, 1], transfer) < tolerance
            else:
                assert abs(admittance[0, 1]) < 1e-289


def test_a_lossless_line_gives_the_cotangent():
    admittance = plane_wave.two_port(2e5j, 1e-6j, [0.1, 1.0, 10.0])
    angle, characteristic = np.sqrt(0.2) * np.array([0.1, 1.0, 10.0]), np.sqrt(1e-6 / 2e5)
    np.testing.assert_allclose(admittance[:, 0, 0], -1j * characteristic / np.tan(angle), rtol=1e-12)
    np.testing.assert_allclose(admittance[:, 0, 1], 1j * characteristic / np.sin(angle), rtol=1e-12)


def test_a_user_line_with_the_constants_of_a_bore_is_that_bore():
    frequency = np.array([1.0, 30.0, 1000.0])
    bore = CircularSection(2.2e-4)
    expected = plane_wave.port_admittance(2.2e-4, 0.0125, frequency, AIR)
    np.testing.assert_allclose(bore.port_admittance(0.0125, frequency, AIR), expected, rtol=1e-14)
    given_values = plane_wave.UserLine(bore.propagation(frequency, AIR), bore.characteristic_impedance(frequency, AIR))
    given_functions = plane_wave.UserLine(
        lambda f: bore.propagation(f, AIR), lambda f: bore.characteristic_impedance(f, AIR)
    )
    for line in (given_values, given_functions):
        np.testing.assert_allclose(line.port_admittance(0.0125, frequency, AIR), expected, rtol=1e-13)


def test_a_user_line_refuses_gain_and_values_for_other_frequencies():
    with refused(Kind.OUT_OF_RANGE, "gamma", -1.0):
        plane_wave.UserLine(-1.0, 1e8).series_impedance(10.0, AIR)
    with refused(Kind.MISMATCH, "zc"):
        plane_wave.UserLine(1.0, [1e8, 2e8]).shunt_admittance([1.0, 2.0, 3.0], AIR)


@pytest.mark.parametrize(("series", "shunt", "name"), [(0.0, 1e-9, "series"), (1e8, np.nan, "shunt")])
def test_a_two_port_refuses_values_without_meaning(series, shunt, name):
    with refused(Kind.OUT_OF_RANGE, name):
        plane_wave.two_port(series, shunt, 0.01)


def test_a_compliant_wall_adds_its_compliance_and_its_losses():
    frequency = np.array([1.0, 100.0])
    rigid = CircularSection(2.5e-4)
    wall = plane_wave.tube_compliance(2.5e-4, 5e-4, 1e7, loss_factor=0.1)
    soft = plane_wave.CompliantWall(rigid, wall)
    added = soft.shunt_admittance(frequency, AIR) - rigid.shunt_admittance(frequency, AIR)
    np.testing.assert_allclose(added, 2j * np.pi * frequency * wall, rtol=1e-9)
    assert (added.real > 0).all()
    np.testing.assert_array_equal(soft.series_impedance(frequency, AIR), rigid.series_impedance(frequency, AIR))


def test_a_thin_tube_tends_to_two_pi_a_cubed_over_e_h():
    a, h, modulus = 1e-3, 1e-7, 1e8
    thin = 2 * np.pi * a**3 / (modulus * h)
    assert plane_wave.tube_compliance(a, a + h, modulus, 0.3, axial="free") == pytest.approx(thin, rel=3e-4, abs=0)
    assert plane_wave.tube_compliance(a, a + h, modulus, 0.3) == pytest.approx(thin * (1 - 0.3**2), rel=3e-4, abs=0)


def test_a_very_thick_tube_tends_to_a_hole_in_an_infinite_body():
    compliance = plane_wave.tube_compliance(1e-3, 1.0, 1e8, 0.49)
    assert compliance == pytest.approx(2 * np.pi * 1e-6 * 1.49 / 1e8, rel=1e-5, abs=0)


@pytest.mark.parametrize(
    ("arguments", "field", "value"),
    [
        ((1e-3, 1e-3, 1e8), "outer_radius", 1e-3),
        ((1e-3, 2e-3, 1e8, 0.6), "poisson_ratio", 0.6),
        ((1e-3, 2e-3, 1e8, 0.4, 0.0, "loose"), "axial", "loose"),
    ],
)
def test_an_impossible_tube_wall_is_refused(arguments, field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        plane_wave.tube_compliance(*arguments)


def test_a_wall_that_gives_energy_is_refused():
    with refused(Kind.OUT_OF_RANGE, "compliance", 1e-12 + 1e-13j):
        plane_wave.CompliantWall(CircularSection(1e-3), 1e-12 + 1e-13j)


OPENWIND = json.loads((Path(__file__).parents[2] / "reference" / "openwind.json").read_text())


@pytest.mark.parametrize("case", OPENWIND["cases"], ids=[case["name"] for case in OPENWIND["cases"]])
def test_tubes_agree_with_openwind(case):
    """To 1e-12; the cone to 1e-9, where the input impedance at 0.01 Hz is a difference of admittances."""
    impedance = openwind_ladder.driven_impedance(
        case["pieces"], np.array(OPENWIND["frequency"]), Medium(**OPENWIND["air"])
    )
    stored = np.array([complex(*pair) for pair in case["impedance"]])
    np.testing.assert_allclose(impedance, stored, rtol=1e-9 if case["name"].startswith("cone") else 1e-12)


def test_the_stored_numbers_are_those_of_openwind():
    pytest.importorskip("openwind")
    live = openwind_ladder.reference()
    assert live["air"] == pytest.approx(OPENWIND["air"], rel=1e-12, abs=0)
    for now, stored in zip(live["cases"], OPENWIND["cases"], strict=True):
        np.testing.assert_allclose(now["impedance"], stored["impedance"], rtol=1e-9, err_msg=stored["name"])
