"""A bent bore: 3-D finite elements against the flow in a torus, a whole bend and the CAD solid."""

from __future__ import annotations

import cadquery as cq
import numpy as np
import pytest
from reference_data import AIR
from refusals import refused
from toroidal_bore import compliance_change, conductance_change

from acoustic_fem.cell.bent_bore import LAYERS_PER_RING, PIECE, solve_bent_bores
from acoustic_fem.cell.condensed import AirModel, BodyFaces, condense
from acoustic_fem.cell.solid import port_admittance
from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.meshed_section import MeshedSection
from geometry.air.wound_tube import FIRST, LAST, Winding, swept_mesh
from geometry.ground.refusal import Kind

BORE, BEND = 0.25, 5.8  # radii of the publication's rig, mm


FLAT = Winding(2 * BEND, 90.0)


FREQUENCY = np.array([1.0, 10.0, 100.0, 400.0, 1800.0])


def solved(winding, along, rings, frequency=FREQUENCY):
    """Admittance between the ends of a swept bore, by 3-D finite elements."""
    section = MeshedSection.circle(BORE, rings)
    mesh = swept_mesh(section.points, section.triangles, winding, along)
    band = (frequency[0], frequency[-1])
    body = condense(mesh, mesh, BodyFaces((FIRST, LAST)), AirModel(AIR, band), tolerance=1e-9)
    return body.nodal_admittance(frequency)


def layers(length, rings):
    """Layers as long as those of the piece that the product solves."""
    step = PIECE * BORE / (LAYERS_PER_RING * rings)
    return np.linspace(0, length, round(length / step) + 1)


def change(winding, along, rings, frequency=FREQUENCY):
    """Relative change of Y12 by the bend, its mesh against the same one unbent."""
    bent, straight = (solved(shape, along, rings, frequency)[:, 0, 1] for shape in (winding, None))
    return (bent - straight) / straight


def line_change(bore, length):
    """The same of a piece of the line, every frequency."""
    exact = plane_wave.port_admittance(BORE * 1e-3, length * 1e-3, FREQUENCY, AIR)
    return (bore.port_admittance(length * 1e-3) / exact)[:, 0, 1] - 1


@pytest.fixture(scope="module")
def flat():
    """The flat bend by rings of elements."""
    return {rings: solve_bent_bores(BORE * 1e-3, [FLAT], FREQUENCY, AIR, rings=rings)[0] for rings in (2, 4)}


def test_the_flow_in_a_torus_has_the_known_limits():
    slow, fast = conductance_change(0.01, 1.0, [1e-6, 1e9], AIR)
    assert slow == pytest.approx(0.01**2 / 48, rel=2e-3)  # Topakoglu 1967
    assert fast.real == pytest.approx(0.01**2 / 4, rel=0.1)  # potential flow, u ~ 1/r


def test_a_bent_bore_conducts_as_the_flow_in_a_torus(flat):
    exact = conductance_change(BORE * 1e-3, BEND * 1e-3, FREQUENCY, AIR)
    straight = plane_wave.series_impedance(BORE * 1e-3, FREQUENCY, AIR)
    errors = {rings: np.abs(straight / bore.series - 1 - exact) / np.abs(exact) for rings, bore in flat.items()}
    assert errors[4].max() < 0.01
    assert errors[2].max() < 0.2
    order = np.log(errors[2] / errors[4]) / np.log(2)
    assert order.min() > 3.3
    assert order.max() < 4.6


def test_the_transfer_admittance_of_a_quarter_turn_changes_as_an_independent_3d_solve_found(flat):
    low, _, high = 100 * line_change(flat[4], np.pi / 2 * BEND)[:3]
    assert round(low.real, 3) == 0.004
    assert round(abs(high), 3) == 0.013


def test_the_gas_of_a_bent_bore_yields_as_that_of_a_torus(flat):
    exact = compliance_change(BORE * 1e-3, BEND * 1e-3, FREQUENCY, AIR)
    straight = plane_wave.shunt_admittance(BORE * 1e-3, FREQUENCY, AIR)
    assert np.abs(exact).max() > 2e-6
    np.testing.assert_allclose(flat[4].shunt / straight - 1, exact, rtol=0, atol=1.5e-7)


@pytest.mark.slow
def test_a_whole_quarter_turn_in_one_mesh_is_two_eighths_and_the_line_of_the_short_piece(flat):
    rings, length, some = 2, FLAT.arc_length, FREQUENCY[2:3]
    whole = change(FLAT, layers(length, rings), rings, some)
    eighth = Winding(2 * BEND, 45.0)
    half = change(eighth, layers(eighth.arc_length, rings), rings, some)
    # A bend multiplies all entries alike but for the compliance, which counts 1e-4 of it here.
    assert np.all(np.abs(whole - half) < 2e-3 * np.abs(whole))
    assert np.all(np.abs(whole - line_change(flat[2], length)[2]) < 1e-2 * np.abs(whole))


def test_a_helix_is_the_line_of_its_short_piece_and_bends_as_a_circle_of_its_curvature():
    """The flow on a helix is not purely along it: its torsion may change the ends."""
    steep = Winding(2 * BEND, 90.0, 12.0)  # torsion a third of the curvature, 13 times that of the rig
    piece, same = solve_bent_bores(
        BORE * 1e-3, [steep, Winding(2 / steep.curvature, 90.0)], FREQUENCY[:3:2], AIR, rings=2
    )
    assert abs(steep.torsion / steep.curvature) > 0.32
    straight = plane_wave.series_impedance(BORE * 1e-3, FREQUENCY[:3:2], AIR)
    by_piece, by_circle = (straight / bore.series - 1 for bore in (piece, same))
    np.testing.assert_allclose(by_piece, by_circle, rtol=0.02)
    twice = change(steep, layers(2 * PIECE * BORE, 2), 2, FREQUENCY[:3:2])
    np.testing.assert_allclose(by_piece, twice, rtol=0.02)


@pytest.mark.slow
def test_a_joint_of_straight_and_bent_bore_counts_less_than_a_radius_of_bend():
    step = PIECE * BORE / (LAYERS_PER_RING * 3)
    bend = np.arange(0, 9) * step
    with_straight = np.concatenate([np.arange(-6, 0) * step, bend])
    lost = [-change(FLAT, along, 3, FREQUENCY[:1])[0].real * (along[-1] - along[0]) for along in (bend, with_straight)]
    per_radius = lost[0] / (bend[-1] / BORE)
    assert abs((lost[1] - lost[0]) / per_radius) < 0.5


@pytest.mark.slow
def test_a_bend_of_the_cad_kernel_agrees_within_its_mesh_error(flat):
    """Its unstructured mesh is wrong by more than the bend changes: it confirms the shape, not the change."""
    angle = 20.0
    air = cq.Workplane("XZ").center(BEND, 0).circle(BORE).revolve(angle, (-BEND, 0), (-BEND, 1)).val()
    far = (BEND * np.cos(np.radians(angle)), BEND * np.sin(np.radians(angle)), 0.0)
    admittance = port_admittance(air, {"a": (BEND, 0, 0), "b": far}, FREQUENCY[:3], AIR, accuracy=1e-3)
    line = flat[4].port_admittance(np.radians(angle) * BEND * 1e-3)[:3]
    np.testing.assert_allclose(admittance, line, rtol=1e-3)


def test_the_scalar_model_makes_the_change_thirteen_times_too_large():
    bore = solve_bent_bores(BORE * 1e-3, [FLAT], [1.0], AIR, "helmholtz", rings=3)[0]
    change_of_it = (plane_wave.series_impedance(BORE * 1e-3, [1.0], AIR) / bore.series - 1).real
    assert change_of_it == pytest.approx(13 * (BORE / BEND) ** 2 / 48, rel=0.01)


@pytest.mark.parametrize(
    ("radius", "frequency", "field", "value"),
    [
        (6e-3, [1.0], "radius", 6e-3),
        (2.5e-4, [1.0, 1900.0], "frequency", 1900.0),
        (2.5e-4, [0.0, 1.0], "frequency", 0.0),
        (-1.0, [1.0], "radius", -1.0),
    ],
)
def test_a_bore_that_the_piece_does_not_cover_is_refused(radius, frequency, field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        solve_bent_bores(radius, [FLAT], frequency, AIR)
