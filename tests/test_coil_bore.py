"""The ribbed bore of a close-wound spring: the smooth bore, slow ribs, convergence, limits."""

import numpy as np
import pytest
from reference_data import AIR

from acoustic_fem import duct
from acoustic_fem.coil_bore import CoilBore, _response, flow_system, half_pitch_mesh, heat_system
from acoustic_fem.section import CircularSection

#: Outer diameter and wire of the two springs, m.
SPRINGS = [(0.6e-3, 0.08e-3), (0.28e-3, 0.05e-3)]
FREQUENCY = np.array([0.1, 10.0, 100.0, 500.0])


@pytest.mark.parametrize("system", [flow_system, heat_system])
def test_a_smooth_bore_is_poiseuille_flow_and_the_exact_duct(system):
    half_pitch, rates = 0.2, np.array([1e-6, 1.0, 30.0])
    matrices, load = system(half_pitch_mesh(half_pitch, 0.0, 6))
    mean = 1j * rates * _response(matrices, load, rates) / (np.pi * half_pitch)
    exact = duct.round_mean(2, 1.0, 1j * rates)
    np.testing.assert_allclose(mean, exact, rtol=2e-6)
    assert mean[0].imag == pytest.approx(exact[0].imag, rel=1e-11)


def test_long_shallow_ribs_tend_to_the_duct_of_varying_section():
    """Elliptic arcs 100 times longer than high: slope^2 is what the one-dimensional theory leaves out."""
    half_pitch, height, rate = 4.0, 0.04, np.array([5.0])
    matrices, load = flow_system(half_pitch_mesh(half_pitch, height, 16))
    flux = _response(matrices, load, rate)[0] / half_pitch
    frequency = rate * AIR.kinematic_viscosity / (2 * np.pi)

    angle, weight = np.polynomial.legendre.leggauss(40)
    angle = np.pi / 4 * (angle + 1)
    radius = 1 + height * (1 - np.cos(angle))
    series = duct.series_impedance(radius, frequency, AIR) @ (weight * np.pi / 4 * np.cos(angle))
    assert AIR.viscosity / flux == pytest.approx(series, rel=2e-4)
    smooth = duct.series_impedance(1.0, frequency, AIR)[0]
    assert abs(series / smooth - 1) > 0.02


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_the_effective_bore_converges_with_the_mesh(outer, wire):
    radii = [CoilBore(outer, wire, refinement).effective_radius for refinement in (4, 8, 16, 24)]
    steps = np.abs(np.array(radii[:-1]) / radii[-1] - 1)
    assert (steps[:-1] / steps[1:] > 8).all()
    # 4 times that in resistance; the default lies between the second and the third
    assert steps[1] < 2e-5
    assert steps[2] < 1.5e-6


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_where_the_cusp_between_the_wires_is_cut_does_not_matter(outer, wire):
    radii = [CoilBore(outer, wire, 16, cusp).effective_radius for cusp in (0.3, 0.15, 0.08)]
    assert np.ptp(radii) < 2e-6 * radii[0]


@pytest.mark.parametrize(("outer", "wire", "resistance"), [(*SPRINGS[0], -0.0587), (*SPRINGS[1], -0.0890)])
def test_the_ribs_lower_the_resistance_by_six_and_nine_percent(outer, wire, resistance):
    """Against outer diameter - 2 wire; between the crests and the lossless mean of the radius."""
    spring = CoilBore(outer, wire)
    assert spring.crest_radius < spring.effective_radius < spring.crest_radius + wire / 2 * (1 - np.pi / 4)
    smooth = duct.series_impedance(spring.crest_radius, 0.1, AIR).real
    assert spring.series_impedance(0.1, AIR).real / smooth - 1 == pytest.approx(resistance, abs=1e-4)
    assert (spring.crest_radius / spring.effective_radius) ** 4 - 1 == pytest.approx(resistance, abs=1e-4)


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_compliance_goes_from_isothermal_to_adiabatic_over_the_volume_with_grooves(outer, wire):
    spring = CoilBore(outer, wire)
    low = spring.shunt_admittance(0.01, AIR).imag / (2 * np.pi * 0.01)
    assert low == pytest.approx(spring.volume_per_length / AIR.pressure, rel=1e-6)
    compliance = spring.shunt_admittance(np.array([1e3, 1e5]), AIR).imag / (2 * np.pi * np.array([1e3, 1e5]))
    assert (np.diff(compliance) < 0).all()
    assert (compliance > spring.volume_per_length / (AIR.gamma * AIR.pressure)).all()


def test_the_volume_per_length_is_the_integral_over_the_arcs():
    spring = CoilBore(0.6e-3, 0.08e-3)
    angle, weight = np.polynomial.legendre.leggauss(60)
    angle = np.pi / 4 * (angle + 1)
    radius = spring.crest_radius + spring.wire_diameter / 2 * (1 - np.cos(angle))
    mean = np.pi * radius**2 @ (weight * np.pi / 4 * np.cos(angle))
    assert spring.volume_per_length == pytest.approx(mean, rel=1e-12)


def test_a_spring_is_a_passive_reciprocal_line():
    spring = CoilBore(*SPRINGS[0])
    admittance = spring.port_admittance(0.0125, FREQUENCY, AIR)
    assert admittance.shape == (4, 2, 2)
    np.testing.assert_array_equal(admittance[:, 0, 1], admittance[:, 1, 0])
    assert (np.linalg.eigvalsh(admittance.real).min(axis=-1) >= -1e-9 * np.abs(admittance[:, 0, 0])).all()


def test_a_smooth_bore_of_the_effective_radius_is_the_spring_but_for_its_grooves():
    spring = CoilBore(*SPRINGS[0])
    smooth = CircularSection(spring.effective_radius)
    ratio = spring.series_impedance(FREQUENCY, AIR) / smooth.series_impedance(FREQUENCY, AIR)
    np.testing.assert_allclose(ratio, 1, atol=2e-3)
    stored = spring.shunt_admittance(FREQUENCY, AIR) / smooth.shunt_admittance(FREQUENCY, AIR)
    np.testing.assert_allclose(stored, 1.05, atol=6e-3)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.6e-3, 0.0), "wire_diameter = 0 m"),
        ((0.6e-3, 0.2e-3), "must be below a quarter of outer_diameter"),
        ((0.6e-3, 0.08e-3, 1), "refinement = 1"),
        ((0.6e-3, 0.08e-3, 8, 0.0), "cusp = 0 rad"),
    ],
)
def test_an_impossible_spring_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        CoilBore(*arguments)
