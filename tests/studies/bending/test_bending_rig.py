"""The rig of the publication and the verb bend: what it writes, and what it refuses."""

from __future__ import annotations

import csv
import json
import sys

import numpy as np
import pytest
from toroidal_bore import compliance_change, conductance_change

from acoustic_fem.duct import plane_wave
from acoustic_fem.quantities.medium import Medium
from geometry.design.design_file import prototype
from studies.bending.bending_rig import BendingRig
from studies.bending.solution import end_load
from studies.cli import app

BORE, BEND = 0.25, 5.8  # radii of the publication's rig, mm


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


# -- the rig and the verb -----------------------------------------------------------------------------------
def bend(monkeypatch, capsys, *words):
    """Exit code, stdout and stderr of ``acoustic-fem bend``."""
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "bend", *map(str, words)])
    capsys.readouterr()
    with pytest.raises(SystemExit) as ended:
        app.main()
    told = capsys.readouterr()
    return int(ended.value.code or 0), told.out, told.err


@pytest.mark.slow
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
    assert f"largest difference from the straight tube: {level[-1]:.3g} dB, {phase[-1]:.3g} degrees" in out
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
    ("words", "code", "option"),
    [
        ("--angles -1", 1, "--angles = -1 degrees"),
        ("--angles 3601", 1, "--angles = 3601 degrees"),
        ("--angles nan", 1, "--angles = nan degrees"),
        ("--angles 90,90", 1, "--angles = (90.0, 90.0)"),
        ("--angles 1,2,3,4,5,6,7,8,9,10,11,12,13", 1, "--angles"),
        ("--angles 90;180", 2, "--angles"),
        ("--bore 0", 1, "--bore = 0 mm"),
        ("--bore 4 --diameter 3", 1, "--bore = 4 mm"),
        ("--bore 1", 1, "--outside = 0.9 mm"),
        ("--length 36", 1, "--length = 36 mm"),
        ("--fidelity lumped", 1, "--fidelity = 'lumped'"),
        ("--frequencies 100:1:5", 1, "--frequencies"),
        ("--frequencies 1:2000:5", 1, "--frequencies = 2000 Hz"),
        ("--end open", 2, "--end"),
    ],
)
def test_bad_input_ends_in_one_line_before_any_work(monkeypatch, capsys, tmp_path, words, code, option):
    ended, out, err = bend(monkeypatch, capsys, "--out", tmp_path / "bending", *words.split())
    assert (ended, out, err.count("\n")) == (code, "", 1)
    assert option in err
    assert not (tmp_path / "bending").exists()
