"""Closed cavities: reference numbers, exact limits, brute-force series."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from reference_data import AIR, rows
from refusals import refused
from scipy.special import jn_zeros

import acoustic_fem
import geometry
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.cavity import closed_forms
from acoustic_fem.cavity.shaped import shaped_cavity_compliance
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.lumped import lumped_admittance
from geometry.air.cells import Cell
from geometry.ground.refusal import Kind
from geometry.schema.cavity_shapes import Box, Dome
from geometry.schema.ports import CellPort

BAND = np.logspace(-3, 4, 15)
sizes = st.floats(3e-4, 2.5e-2)


@pytest.mark.parametrize("row", rows("closed_cylinder"), ids=lambda row: f"{row['frequency']:g} Hz")
def test_cylinder_agrees_with_the_reference(row):
    compliance = closed_forms.closed_cylinder_compliance(row["radius"], row["height"], row["frequency"], AIR)
    volume = np.pi * row["radius"] ** 2 * row["height"]
    expected = volume * complex(*row["gamma_eff"]) / (AIR.gamma * AIR.pressure)
    assert compliance == pytest.approx(expected, rel=1e-6, abs=0)


@pytest.mark.parametrize(("radius", "height"), [(3e-3, 2.5e-3), (5e-4, 2e-2), (1.2e-2, 5e-4)])
def test_cylinder_agrees_with_a_brute_force_sum_over_both_axes(radius, height):
    # eigenfunctions J0(l r/R) cos(m pi z/H), m odd, of the closed cylinder; 1/m^2 convergence, extrapolated
    frequency = 10.0
    rate = 2j * np.pi * frequency / AIR.thermal_diffusivity
    radial = jn_zeros(0, 1000)[:, None]

    def mean(terms):
        axial = 2 * np.arange(terms)[None, :] + 1
        eigenvalue = (radial / radius) ** 2 + (axial * np.pi / height) ** 2
        return np.sum(32 / (np.pi**2 * axial**2 * radial**2) * rate / (eigenvalue + rate))

    volume = np.pi * radius**2 * height
    expected = volume * (AIR.gamma - (AIR.gamma - 1) * mean(1500)) / (AIR.gamma * AIR.pressure)
    assert closed_forms.closed_cylinder_compliance(radius, height, frequency, AIR) == pytest.approx(
        expected, rel=1e-6, abs=0
    )


@given(sizes, sizes)
def test_every_cavity_goes_from_isothermal_to_adiabatic(radius, height):
    shapes = {
        "cylinder": (np.pi * radius**2 * height, closed_forms.closed_cylinder_compliance(radius, height, BAND, AIR)),
        "sphere": (4 / 3 * np.pi * radius**3, closed_forms.closed_sphere_compliance(radius, BAND, AIR)),
    }
    for volume, compliance in shapes.values():
        relative = compliance * AIR.pressure / volume
        assert relative[0] == pytest.approx(1, abs=0.02)
        assert np.all((relative.real < 1 + 1e-12) & (relative.real > 1 / AIR.gamma - 1e-12))
        assert np.all(relative.imag < 0)  # heat conduction only takes energy
        assert np.all(np.diff(relative.real) < 0)


def test_low_frequency_is_isothermal_and_high_frequency_adiabatic_but_for_the_boundary_layer():
    radius, height = 3e-3, 2.5e-3
    volume, surface = np.pi * radius**2 * height, 2 * np.pi * radius * (radius + height)
    low, high = closed_forms.closed_cylinder_compliance(radius, height, [1e-3, 1e4], AIR)
    assert low * AIR.pressure / volume == pytest.approx(1, abs=1e-4)
    layer = surface / volume / np.sqrt(2j * np.pi * 1e4 / AIR.thermal_diffusivity)
    # the next term, of edges and curvature, is of the order of the layer squared
    adiabatic = (AIR.gamma - (AIR.gamma - 1) * (1 - layer)) / AIR.gamma
    assert abs(high * AIR.pressure / volume / adiabatic - 1) < abs(layer) ** 2


def test_flat_and_long_cylinders_tend_to_the_slab_and_the_infinite_duct():
    from acoustic_fem.duct.plane_wave import shunt_admittance

    flat = closed_forms.closed_cylinder_compliance(0.1, 1e-4, BAND, AIR)
    x = 1e-4 / 2 * np.sqrt(2j * np.pi * BAND / AIR.thermal_diffusivity)
    slab = np.pi * 1e-6 * (AIR.gamma - (AIR.gamma - 1) * (1 - np.tanh(x) / x)) / (AIR.gamma * AIR.pressure)
    np.testing.assert_allclose(flat, slab, rtol=3e-4)
    long = closed_forms.closed_cylinder_compliance(1e-4, 1.0, BAND, AIR)
    np.testing.assert_allclose(long, shunt_admittance(1e-4, BAND, AIR) / (2j * np.pi * BAND), rtol=3e-5)


def test_the_sphere_is_its_textbook_formula():
    rate = np.sqrt(2j * np.pi * 10.0 / AIR.thermal_diffusivity)
    x = 2e-3 * rate
    mean = 1 - 3 * (x / np.tanh(x) - 1) / x**2
    expected = 4 / 3 * np.pi * 8e-9 * (AIR.gamma - (AIR.gamma - 1) * mean) / (AIR.gamma * AIR.pressure)
    assert closed_forms.closed_sphere_compliance(2e-3, 10.0, AIR) == pytest.approx(expected, rel=1e-12, abs=0)


def test_the_shape_of_the_frequency_is_kept():
    assert closed_forms.closed_cylinder_compliance(1e-3, 1e-3, np.ones((2, 3)), AIR).shape == (2, 3)
    assert closed_forms.closed_cylinder_compliance(1e-3, 1e-3, 1.0, AIR).shape == ()


@pytest.mark.parametrize(
    ("arguments", "field", "value"),
    [((-1e-3, 1e-3, 1.0), "radius", -1e-3), ((1e-3, 0, 1.0), "height", 0), ((1e-3, 1e-3, 0), "frequency", 0)],
)
def test_a_value_that_is_not_positive_is_refused_by_name(arguments, field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        closed_forms.closed_cylinder_compliance(*arguments, AIR)


# -- shapes without a closed form -----------------------------------------------------------------------


def shaped_cell(shape, angles=(0.0, 180.0), size=(1.6, 1.3, 0.18)):
    diameter, height, bore = size
    ports = tuple(CellPort(angle, bore) for angle in angles)
    return Cell("resonator", diameter, height, height / 2, ports, diameter, 0.0, shape=shape)


def differences(cell, fidelity="navier-stokes"):
    """Deviation of the lumped from the 3-D cell: largest of its admittances, relative to rows and columns, beyond the
    error that the 3-D cell states of itself; compliance.
    """
    frequency = np.geomspace(1, 100, 5)
    solution = solve_cells([cell], frequency, AIR, fidelity)[cell]
    solved = solution.admittance
    lumped = lumped_admittance(cell, frequency, AIR)
    scale = np.sqrt(np.abs(np.einsum("fii->fi", solved)))
    apart = np.abs(lumped - solved) / (scale[:, :, None] * scale[:, None, :])
    return apart.max() - solution.mesh_error, np.abs(lumped.sum((1, 2)) / solved.sum((1, 2)) - 1).max()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "angles", "accuracy"),
    [(Box(1.2, 0.8, 0.16, 0.26), (0.0,), 2e-3), (Dome(0.8), (0.0, 180.0), 8e-3)],
    ids=["box", "dome"],
)
def test_lumped_boxes_and_domes_agree_with_navier_stokes(shape, angles, accuracy):
    admittance, compliance = differences(shaped_cell(shape, angles))
    assert admittance < accuracy
    assert compliance < 1e-3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "angles", "accuracy"),
    [
        (Box(4.17, 4.17, 0.6, 0.5), (0.0, 180.0), 2e-3),
        (Box(4.17, 4.17, 0.6, 0.5), (0.0, 130.0), 1.3e-2),
        (Dome(0.8333), (0.0, 180.0), 8e-3),
        (Dome(2.5), (0.0, 180.0), 3e-2),
    ],
    ids=["box", "a port in the corner of a box", "dome", "ports in a bowl"],
)
def test_lumped_boxes_and_domes_of_six_millimetres_agree_with_navier_stokes(shape, angles, accuracy):
    admittance, compliance = differences(shaped_cell(shape, angles, (6.0, 2.5, 0.44)))
    assert admittance < accuracy
    assert compliance < 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("shape", [Box(1.1, 1.1, 0.16, 0.26), Dome(0.4), Dome(0.8)], ids=repr)
def test_boxes_and_domes_go_from_isothermal_to_adiabatic(shape):
    volume = shape.volume(0.8, 1.3) * 1e-9
    compliance = shaped_cavity_compliance(shape, 0.8e-3, 1.3e-3, np.geomspace(1, 500, 9), AIR)
    relative = compliance * AIR.pressure / volume
    assert relative[0] == pytest.approx(1, abs=0.01)
    assert np.all(relative.imag < 0)
    assert np.all(np.diff(relative.real) < 0)
    assert relative[-1].real > 1 / AIR.gamma
    # Inside the cylinder around it every place is nearer to a wall: nearer to isothermal.
    cylinder = closed_forms.closed_cylinder_compliance(0.8e-3, 1.3e-3, 50.0, AIR) / (np.pi * 0.8e-3**2 * 1.3e-3)
    own = shaped_cavity_compliance(shape, 0.8e-3, 1.3e-3, 50.0, AIR) / volume
    assert own.shape == ()
    assert cylinder.real < own.real


def test_a_batch_refuses_a_cavity_that_is_no_cylinder_by_name():
    design = geometry.prototype("array-2x6").with_values({"resonator.shape": "dome"})
    with refused(Kind.OUT_OF_RANGE, "resonator.shape", "dome"):
        ArrayParameters.from_design(design)


def test_lumped_solutions_of_a_design_feel_its_shape():
    """A third less air: a stiffer cavity at every point."""
    frequency, responses = np.array([5.0]), {}
    for shape in ("cylinder", "box"):
        design = geometry.prototype("fingertip-3x4").with_values({"resonator.shape": shape})
        responses[shape] = acoustic_fem.solve(design, frequency, fidelity="lumped").point_impedance.values
    assert np.all(np.abs(responses["box"]) > 1.001 * np.abs(responses["cylinder"]))
