"""The ribbed bore of a close-wound spring: the smooth bore, slow ribs, convergence, limits."""

import numpy as np
import pytest
import scipy.sparse as sp
import skfem
from reference_data import AIR
from refusals import refused
from scipy.sparse.linalg import spsolve

from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.coil_bore import (
    CUSP,
    CoilBore,
    _axial,
    _divergence,
    _response,
    _viscous,
    flow_system,
    half_pitch_mesh,
    heat_system,
)
from acoustic_fem.duct.sections import CircularSection
from geometry.ground.refusal import Kind

#: Outer diameter and wire of the two springs, m.
SPRINGS = [(0.6e-3, 0.08e-3), (0.28e-3, 0.05e-3)]
FREQUENCY = np.array([0.1, 10.0, 100.0, 500.0])


@pytest.mark.parametrize("system", [flow_system, heat_system])
def test_a_smooth_bore_is_poiseuille_flow_and_the_exact_duct(system):
    half_pitch, rates = 0.2, np.array([1e-6, 1.0, 30.0])
    matrices, load = system(half_pitch_mesh(half_pitch, 0.0, 6))
    mean = 1j * rates * _response(matrices, load, rates) / (np.pi * half_pitch)
    exact = plane_wave.round_mean(2, 1.0, 1j * rates)
    np.testing.assert_allclose(mean, exact, rtol=2e-6)
    assert mean[0].imag == pytest.approx(exact[0].imag, rel=1e-11, abs=0)


def test_long_shallow_ribs_tend_to_the_duct_of_varying_section():
    """Elliptic arcs 100 times longer than high: slope^2 is what the one-dimensional theory leaves out."""
    half_pitch, height, rate = 4.0, 0.04, np.array([5.0])
    matrices, load = flow_system(half_pitch_mesh(half_pitch, height, 16))
    flux = _response(matrices, load, rate)[0] / half_pitch
    frequency = rate * AIR.kinematic_viscosity / (2 * np.pi)

    angle, weight = np.polynomial.legendre.leggauss(40)
    angle = np.pi / 4 * (angle + 1)
    radius = 1 + height * (1 - np.cos(angle))
    series = plane_wave.series_impedance(radius, frequency, AIR) @ (weight * np.pi / 4 * np.cos(angle))
    assert AIR.viscosity / flux == pytest.approx(series, rel=2e-4, abs=0)
    smooth = plane_wave.series_impedance(1.0, frequency, AIR)[0]
    assert abs(series / smooth - 1) > 0.02


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_the_effective_bore_converges_with_the_mesh(outer, wire):
    radii = [CoilBore(outer, wire, refinement).effective_radius for refinement in (4, 8, 16, 24)]
    steps = np.abs(np.array(radii[:-1]) / radii[-1] - 1)
    assert (steps[:-1] / steps[1:] > 8).all()
    # 4 times that in resistance; the default lies between the second and the third
    assert steps[1] < 2e-5
    assert steps[2] < 1.5e-6


def effective_radius_of_a_full_pitch(outer, wire, count):
    """The same bore on P2-P1 triangles over a whole pitch, its ends tied to each other: no mirror planes."""
    crest = outer / 2 - wire
    half = wire / 2 / crest
    core = 1 - 3 * half
    rows = np.concatenate([np.linspace(0, core, count // 2 + 1), np.linspace(core, 1, 2 * count + 1)[1:]])
    arc = np.linspace(0, np.pi / 2 - CUSP, count + 1)
    angles = np.concatenate([arc, arc[-1:], arc[::-1]])
    columns = np.arange(len(angles), dtype=float)
    straight = skfem.MeshTri2.from_mesh(skfem.MeshTri.init_tensor(rows, columns))
    row, column = straight.doflocs
    angle = np.interp(column, columns, angles)
    bottom = half + (column - count - 1) * half * (1 - np.cos(CUSP))
    arcs = [half * np.sin(angle), 2 * half - half * np.sin(angle)]
    z = np.select([column <= count, column >= count + 2], arcs, bottom)
    wall = 1 + half * (1 - np.cos(angle))
    r = np.where(row <= core, row, core + (row - core) / (1 - core) * (wall - core))
    curved = skfem.MeshTri2(np.stack([r, z]), straight.t)

    velocity = skfem.Basis(curved, skfem.ElementVector(skfem.ElementTriP2()), intorder=6)
    pressure = velocity.with_element(skfem.ElementTriP1())
    divergence = _divergence.assemble(velocity, pressure)
    system = sp.block_array([[_viscous.assemble(velocity), -divergence.T], [-divergence, None]], format="csr")
    load = np.concatenate([_axial.assemble(velocity), np.zeros(pressure.N)])

    # where each unknown lies on the straight mesh: row, column and component (2: pressure)
    flat = skfem.Basis(straight, velocity.elem)
    component = np.full(flat.N, 1)
    component[flat.get_dofs(elements=True).all("u^1")] = 0
    places = np.hstack([flat.doflocs, flat.with_element(skfem.ElementTriP1()).doflocs])
    component = np.concatenate([component, np.full(pressure.N, 2)])
    tied = np.column_stack([places[0], places[1] % columns[-1], component]).round(9)
    _, group = np.unique(tied, axis=0, return_inverse=True)
    held = (component < 2) & (places[0] > 1 - 1e-9) | (component == 0) & (places[0] < 1e-9)
    held[velocity.N] = True  # one pressure, else free up to a constant
    free = np.setdiff1d(np.arange(group.max() + 1), group[held])
    tie = sp.csr_array((np.ones(len(group)), (np.arange(len(group)), group.ravel())))[:, free]
    solution = spsolve((tie.T @ system @ tie).tocsc(), tie.T @ load)
    return crest * (8 * 2 * (tie.T @ load) @ solution / (2 * half)) ** 0.25


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_a_whole_pitch_with_tied_ends_on_triangles_has_the_same_effective_bore(outer, wire):
    radius = effective_radius_of_a_full_pitch(outer, wire, 12)
    assert radius == pytest.approx(CoilBore(outer, wire, 16).effective_radius, rel=5e-5, abs=0)


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_where_the_cusp_between_the_wires_is_cut_does_not_matter(outer, wire):
    radii = [CoilBore(outer, wire, 16, cusp).effective_radius for cusp in (0.3, 0.15, 0.08)]
    assert np.ptp(radii) < 2e-6 * radii[0]


@pytest.mark.parametrize(("outer", "wire", "resistance"), [(*SPRINGS[0], -0.0587), (*SPRINGS[1], -0.0890)])
def test_the_ribs_lower_the_resistance_by_six_and_nine_percent(outer, wire, resistance):
    """Against outer diameter - 2 wire; between the crests and the lossless mean of the radius."""
    spring = CoilBore(outer, wire)
    assert spring.crest_radius < spring.effective_radius < spring.crest_radius + wire / 2 * (1 - np.pi / 4)
    smooth = plane_wave.series_impedance(spring.crest_radius, 0.1, AIR).real
    assert spring.series_impedance(0.1, AIR).real / smooth - 1 == pytest.approx(resistance, abs=1e-4)
    assert (spring.crest_radius / spring.effective_radius) ** 4 - 1 == pytest.approx(resistance, abs=1e-4)


@pytest.mark.parametrize(("outer", "wire"), SPRINGS)
def test_compliance_goes_from_isothermal_to_adiabatic_over_the_volume_with_grooves(outer, wire):
    spring = CoilBore(outer, wire)
    low = spring.shunt_admittance(0.01, AIR).imag / (2 * np.pi * 0.01)
    assert low == pytest.approx(spring.volume_per_length / AIR.pressure, rel=1e-6, abs=0)
    compliance = spring.shunt_admittance(np.array([1e3, 1e5]), AIR).imag / (2 * np.pi * np.array([1e3, 1e5]))
    assert (np.diff(compliance) < 0).all()
    assert (compliance > spring.volume_per_length / (AIR.gamma * AIR.pressure)).all()


def test_the_volume_per_length_is_the_integral_over_the_arcs():
    spring = CoilBore(0.6e-3, 0.08e-3)
    angle, weight = np.polynomial.legendre.leggauss(60)
    angle = np.pi / 4 * (angle + 1)
    radius = spring.crest_radius + spring.wire_diameter / 2 * (1 - np.cos(angle))
    mean = np.pi * radius**2 @ (weight * np.pi / 4 * np.cos(angle))
    assert spring.volume_per_length == pytest.approx(mean, rel=1e-12, abs=0)


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
    ("arguments", "field", "value"),
    [
        ((0.6e-3, 0.0), "wire_diameter", 0.0),
        ((0.6e-3, 0.2e-3), "wire_diameter", 0.2e-3),
        ((0.6e-3, 0.08e-3, 1), "refinement", 1),
        ((0.6e-3, 0.08e-3, 8, 0.0), "cusp", 0.0),
    ],
)
def test_an_impossible_spring_is_refused(arguments, field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        CoilBore(*arguments)
