"""A bent bore: 3-D finite elements against the flow in a torus, a whole bend, the CAD solid; the rig; the verb."""

from __future__ import annotations

import csv
import json
import sys

import cadquery as cq
import numpy as np
import pytest
from hypothesis import given, strategies as st
from reference_data import AIR
from toroidal_bore import compliance_change, conductance_change

from acoustic_fem.cell.bent_bore import LAYERS_PER_RING, PIECE, solve_bent_bores
from acoustic_fem.cell.condensed import condense
from acoustic_fem.cell.solid import port_admittance
from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.meshed_section import MeshedSection
from acoustic_fem.quantities.medium import Medium
from geometry.air.mesh import WALL, InvertedElementsError
from geometry.air.wound_tube import FIRST, LAST, Winding, closest_pitch, swept_mesh
from geometry.design.design_file import prototype
from studies.bending.rig import BendingRig, end_load
from studies.cli import app

BORE, BEND = 0.25, 5.8  # radii of the publication's rig, mm
FLAT = Winding(2 * BEND, 90.0)
HELIX = Winding(2 * BEND, 90.0, closest_pitch(2 * BEND, 0.9))
FREQUENCY = np.array([1.0, 10.0, 100.0, 400.0, 1800.0])


def solved(winding, along, rings, frequency=FREQUENCY):
    """Admittance between the ends of a swept bore, by 3-D finite elements."""
    section = MeshedSection.circle(BORE, rings)
    mesh = swept_mesh(section.points, section.triangles, winding, along)
    band = (frequency[0], frequency[-1])
    return condense(mesh, mesh, (FIRST, LAST), (), None, AIR, band, tolerance=1e-9).nodal_admittance(frequency)


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


# -- the bent bore ------------------------------------------------------------------------------------------
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


# -- the wound tube -----------------------------------------------------------------------------------------
@given(st.floats(1, 50), st.floats(1, 720), st.floats(0, 30))
def test_a_winding_has_the_curvature_and_torsion_it_names(diameter, angle, pitch):
    winding = Winding(diameter, angle, pitch)
    step = 1e-3 * diameter
    s = winding.arc_length / 2 + step * np.arange(-1, 2) if winding.arc_length > 3 * step else None
    if s is None:
        return
    points, frames = winding.at(s)
    np.testing.assert_allclose((points[2] - points[0]) / (2 * step), frames[1, 2], atol=1e-5)
    turning = (frames[2] - frames[0]) / (2 * step)
    # Frenet: dT/ds = -k (away from the axis); d(across)/ds = torsion times away from the axis.
    np.testing.assert_allclose(turning[2], -winding.curvature * frames[1, 0], atol=1e-4 * winding.curvature + 1e-9)
    np.testing.assert_allclose(np.abs(turning[1] @ frames[1, 0]), winding.torsion, rtol=1e-4, atol=1e-9)
    np.testing.assert_allclose(frames @ frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), (3, 3, 3)), atol=1e-12)


def test_the_ends_of_a_winding_are_straight_and_continue_it():
    points, frames = HELIX.at(np.array([-2.0, 0.0, HELIX.arc_length, HELIX.arc_length + 3.0]))
    np.testing.assert_allclose(points[1] - points[0], 2 * frames[1, 2], atol=1e-12)
    np.testing.assert_allclose(points[3] - points[2], 3 * frames[2, 2], atol=1e-12)


@pytest.mark.parametrize("angle", [190.0, 225.0, 270.0, 330.0, 360.0, 720.0])
def test_a_tube_wound_over_more_than_half_a_turn_does_not_run_into_itself(angle):
    rig = BendingRig(length=200.0, angles=(angle,))
    winding = rig.winding(angle)
    rest = (rig.length - winding.arc_length) / 2
    along = np.linspace(-rest, winding.arc_length + rest, 2000)
    points = winding.at(along)[0]
    distance = np.linalg.norm(points[:, None] - points[None], axis=2)
    distance[np.abs(along[:, None] - along) < 3 * rig.outside] = np.inf
    assert distance.min() > 0.99 * rig.outside


def test_a_swept_mesh_lies_on_the_cad_sweep_and_has_its_volume():
    section = MeshedSection.circle(BORE, 4)
    along = np.linspace(0, HELIX.arc_length, 61)
    mesh = swept_mesh(section.points, section.triangles, HELIX, along)
    path = cq.Wire.makeHelix(HELIX.pitch, HELIX.pitch / 4, BEND)
    start = HELIX.at(np.zeros(1))
    plane = cq.Plane(start[0][0].tolist(), start[1][0, 0].tolist(), start[1][0, 2].tolist())
    solid = cq.Workplane(plane).circle(BORE).sweep(cq.Workplane(path), isFrenet=True).val()
    assert mesh.volume == pytest.approx(solid.Volume(), rel=1e-5)
    assert mesh.mesh_volume == pytest.approx(solid.Volume(), rel=3e-5)
    wall = mesh.nodes[np.unique(mesh.faces[WALL])][::40]
    shell = solid.Shells()[0]
    assert max(shell.distance(cq.Vertex.makeVertex(*node)) for node in wall) < 1e-4 * BORE


def test_a_bend_too_tight_for_its_layers_is_refused():
    section = MeshedSection.circle(BORE, 1)
    with pytest.raises(InvertedElementsError, match="inverted"):
        swept_mesh(section.points, section.triangles, Winding(0.6, 360.0), np.linspace(0, 1.8, 2))


def test_a_tube_as_wide_as_the_circumference_of_its_cylinder_has_no_pitch():
    with pytest.raises(ValueError, match=r"outside = 4 mm must be below the circumference 3\.14159 mm"):
        closest_pitch(1.0, 4.0)


@pytest.mark.parametrize(
    ("radius", "frequency", "reason"),
    [
        (6e-3, [1.0], r"radius = 0\.006 m must be below the bend's radius 0\.0058 m"),
        (2.5e-4, [1.0, 1900.0], r"frequency = 1900 Hz must be at most 18\d\d Hz for a bore of radius 0\.00025 m"),
        (2.5e-4, [0.0, 1.0], "frequency = 0 Hz must be between"),
        (-1.0, [1.0], "radius = -1 m must be finite and above 0 m"),
    ],
)
def test_a_bore_that_the_piece_does_not_cover_is_refused(radius, frequency, reason):
    with pytest.raises(ValueError, match=reason):
        solve_bent_bores(radius, [FLAT], frequency, AIR)


# -- the rig and the verb -----------------------------------------------------------------------------------
def bend(monkeypatch, capsys, *words):
    """Exit code, stdout and stderr of ``acoustic-fem bend``."""
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "bend", *map(str, words)])
    capsys.readouterr()
    with pytest.raises(SystemExit) as ended:
        app.main()
    told = capsys.readouterr()
    return int(ended.value.code or 0), told.out, told.err


def test_the_publications_rig_transmits_the_same_however_it_is_bent(monkeypatch, capsys, tmp_path):
    code, out, err = bend(monkeypatch, capsys, "--out", tmp_path / "bending", "--frequencies", "1:100:3")
    assert code == 0, err
    folder = tmp_path / "bending"
    assert {path.name for path in folder.iterdir()} == {"bending.png", "bending.csv", "bending.json"}
    assert (folder / "bending.png").read_bytes().startswith(b"\x89PNG")
    found = json.loads((folder / "bending.json").read_text(encoding="utf-8"))
    assert found["rig"]["angles"] == [0, 90, 180, 270, 360]
    assert found["made_by"]["libraries"]["scikit-fem"] != "not installed"
    assert found["mesh_error_of_the_differences"] < 0.01
    level, phase = found["largest_difference_db"], found["largest_difference_deg"]
    assert level[0] == phase[0] == 0
    assert level == sorted(level)
    assert phase == sorted(phase)
    assert level[-1] < 1e-4
    assert phase[-1] < 3e-4
    assert f"largest difference to the straight tube: {level[-1]:.3g} dB, {phase[-1]:.3g} degrees" in out
    assert "Bending: bent bore, 96 elements a section" in err

    # The same from the section of the torus and transmission lines alone, the microphone at the end.
    design = prototype("array-2x6")
    medium = Medium.at(design.air.temperature, design.air.humidity, design.air.pressure)
    frequency = np.linspace(1, 100, 3)
    line = [
        plane_wave.series_impedance(BORE * 1e-3, frequency, medium),
        plane_wave.shunt_admittance(BORE * 1e-3, frequency, medium),
    ]
    changes = (conductance_change, compliance_change)
    bent = [1 + change(BORE * 1e-3, BEND * 1e-3, frequency, medium) for change in changes]
    load = end_load("microphone", design.microphone, frequency, medium)
    transfer = []
    for angle in (0.0, 90.0, 180.0):
        arc = np.radians(angle) * BEND
        pieces = [((120 - arc) / 2, (1.0, 1.0)), (arc, bent), ((120 - arc) / 2, (1.0, 1.0))]
        flow, pressure = load, np.ones(3, dtype=complex)  # at the far end
        for length, (conductance, compliance) in pieces:
            series, shunt = line[0] / conductance, line[1] * compliance
            x, zc = np.sqrt(series * shunt) * length * 1e-3, np.sqrt(series / shunt)
            pressure, flow = (
                pressure * np.cosh(x) + flow * zc * np.sinh(x),
                flow * np.cosh(x) + pressure / zc * np.sinh(x),
            )
        transfer.append(1 / pressure)
    computed = np.array(found["transfer_function"]["real"]) + 1j * np.array(found["transfer_function"]["imaginary"])
    np.testing.assert_allclose(computed[:3], transfer, rtol=1e-7)
    by_torus, by_fem = np.array(transfer[1:]) - transfer[0], computed[1:3] - computed[0]
    assert np.all(np.abs(by_fem - by_torus) < 0.01 * np.abs(by_torus))

    with (folder / "bending.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(float(row["angle_deg"]), float(row["frequency_hz"])) for row in rows] == [
        (angle, f) for angle in found["rig"]["angles"] for f in frequency
    ]
    assert float(rows[-1]["level_db"]) == pytest.approx(20 * np.log10(abs(computed[-1, -1])))
    assert abs(float(rows[-1]["level_difference_db"])) == pytest.approx(level[-1])


def test_a_closed_straight_tube_has_its_exact_transfer_function(monkeypatch, capsys, tmp_path):
    """Far over near pressure 1 / cosh(Gamma L); nothing is bent, so nothing is solved in 3-D."""
    code, _, err = bend(
        monkeypatch, capsys, "--out", tmp_path, "--angles", 0, "--end", "closed", "--frequencies", "1:900:4"
    )
    assert code == 0, err
    found = json.loads((tmp_path / "bending.json").read_text(encoding="utf-8"))
    assert found["unknowns"] == 0
    medium = Medium(**found["medium"])
    frequency = np.array(found["frequency_hz"])
    series, shunt = (
        f(BORE * 1e-3, frequency, medium) for f in (plane_wave.series_impedance, plane_wave.shunt_admittance)
    )
    exact = 1 / np.cosh(np.sqrt(series * shunt) * 0.12)
    np.testing.assert_allclose(found["transfer_function"]["real"], exact.real[None], rtol=1e-11)
    np.testing.assert_allclose(found["transfer_function"]["imaginary"], exact.imag[None], rtol=1e-11)


@pytest.mark.parametrize(
    ("words", "code", "reason"),
    [
        ("--angles -1", 1, "--angles = -1 degrees must be between 0 and 3600 degrees"),
        ("--angles 3601", 1, "--angles = 3601 degrees must be between 0 and 3600 degrees"),
        ("--angles nan", 1, "--angles = nan degrees must be between"),
        ("--angles 90,90", 1, "--angles = 90, 90 must differ"),
        ("--angles 1,2,3,4,5,6,7,8,9,10,11,12,13", 1, "--angles holds 13 values; it must hold 1 to 12"),
        ("--angles 90;180", 2, "must be numbers of degrees with commas"),
        ("--bore 0", 1, "--bore = 0 mm must be between 0.05 and 5 mm"),
        ("--bore 4 --diameter 3", 1, "--bore = 4 mm must be below diameter, the cylinder's 3 mm"),
        ("--bore 1", 1, "--outside = 0.9 mm must be above bore (1 mm) and below diameter (11.6 mm)"),
        ("--length 36", 1, "--length = 36 mm must be at least the arc of 360 degrees, 36.45 mm"),
        ("--fidelity lumped", 1, "--fidelity = 'lumped' must be one of navier-stokes, helmholtz"),
        ("--frequencies 100:1:5", 1, "--frequencies must ascend"),
        ("--frequencies 1:2000:5", 1, "--frequencies = 2000 Hz must be at most"),
        ("--end open", 2, "open"),
    ],
)
def test_bad_input_ends_in_one_line_before_any_work(monkeypatch, capsys, tmp_path, words, code, reason):
    ended, out, err = bend(monkeypatch, capsys, "--out", tmp_path / "bending", *words.split())
    assert ended == code
    assert reason in " ".join(err.replace("│", " ").split())
    assert "elements a section" not in err
    assert not out
    assert not (tmp_path / "bending").exists()
    if code == 1:
        assert err.count("\n") == 1
