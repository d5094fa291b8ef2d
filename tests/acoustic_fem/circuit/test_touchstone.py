"""Touchstone files hold the impedances of the library, in the order and the lines of the format."""

from pathlib import Path

import numpy as np
from libraries import library_of
from refusals import refused

import acoustic_fem
import studies
from acoustic_fem.circuit import port_impedances, save_touchstone, sensor_circuit
from geometry import Kind

GRID = np.array([2.0, 20.0, 90.0])
MM3 = 1e-9  # m^3


def read(path: Path, ports: int) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies and Z parameters of a Touchstone file of version 1."""
    lines = path.read_text(encoding="ascii").splitlines()
    assert [line for line in lines if line.startswith("#")] == ["# HZ Z RI R 1"]
    numbers = np.array(" ".join(line for line in lines if line[0] not in "!#").split(), float)
    table = numbers.reshape(-1, 1 + 2 * ports**2)
    return table[:, 0], (table[:, 1::2] + 1j * table[:, 2::2]).reshape(-1, ports, ports)


def array(points: int) -> acoustic_fem.Library:
    design = library_of("array-2x6", **{"lines.0.points": points, "layout.columns": points}).design
    return acoustic_fem.solve(design, GRID, "lumped")


def test_the_impedances_are_those_of_the_library(tmp_path):
    library = array(3)
    acoustic_fem.save(library, tmp_path / "library.nc")
    studies.convert_library(tmp_path / "library.nc", tmp_path / "sensor.s5p")
    frequency, found = read(tmp_path / "sensor.s5p", 5)
    np.testing.assert_array_equal(frequency, GRID)
    np.testing.assert_allclose(found, found.transpose(0, 2, 1), rtol=1e-6)  # reciprocal
    expected = {
        "point": (found[:, range(3), range(3)], library.point_impedance.transpose("frequency", "point").values),
        "source": (found[:, :3, 3:], library.source_response.transpose("frequency", "point", "microphone").values),
        "front": (
            found[:, 3:, 3:],
            library.microphone_impedance.transpose("frequency", "microphone", "microphone_2").values,
        ),
    }
    for name, (values, exact) in expected.items():
        np.testing.assert_allclose(values / MM3, exact, rtol=2e-3, err_msg=name)
    least = np.linalg.eigvalsh((found + found.conj().transpose(0, 2, 1)) / 2).min()
    assert least > -1e-12 * np.abs(found).max()  # passive
    remarks = [line for line in (tmp_path / "sensor.s5p").read_text().splitlines() if line.startswith("! Port")]
    assert remarks[0] == "! Port[1] = cavity of point 1"
    assert remarks[-1] == "! Port[5] = front of microphone B"


def test_lines_have_four_numbers_at_most_and_frequencies_begin_one(tmp_path):
    sensor = sensor_circuit(array(3))
    save_touchstone(sensor, GRID, tmp_path / "sensor.s5p")
    rows = [line for line in (tmp_path / "sensor.s5p").read_text().splitlines() if line[0] not in "!#"]
    assert max(len(row.split()) for row in rows) == 9
    assert sum(not row.startswith(" ") for row in rows) == len(GRID)
    assert port_impedances(sensor, GRID).shape == (3, 5, 5)


def test_a_name_with_another_number_of_ports_is_refused_with_the_right_one(tmp_path):
    library = array(3)
    acoustic_fem.save(library, tmp_path / "library.nc")
    with refused(Kind.MISMATCH, "out", file="sensor.s2p") as found:
        studies.convert_library(tmp_path / "library.nc", tmp_path / "sensor.s2p")
    assert "must be a name that ends with .s5p, for 3 points and 2 microphones" in str(found.value)
    (tmp_path / "measured.s5p").write_text("! measured")
    with refused(Kind.EXISTS, "out", file="measured.s5p"):
        studies.convert_library(tmp_path / "library.nc", tmp_path / "measured.s5p")
    assert (tmp_path / "measured.s5p").read_text() == "! measured"
