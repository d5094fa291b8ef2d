"""The lumped cell against 3-D Navier-Stokes tables, and its limits."""

import numpy as np
import pytest
from reference_data import AIR, column

from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.duct.plane_wave import port_admittance
from geometry.air.cells import Cell
from geometry.schema.ports import CellPort

CELL = Cell("resonator", 6.0, 2.5, 1.25, (CellPort(0.0, 0.5), CellPort(180.0, 0.5)), 6.0, 0.0)


CHAMBER = Cell("microphone", 3.0, 2.0, 1.0, (CellPort(0.0, 0.44), CellPort(90.0, 0.3)), 0.5, 0.3)


BAND = np.logspace(-2, 2.5, 12)


def test_lumped_resonator_cell_agrees_with_3d_navier_stokes():
    frequency = column("resonator_cell", "frequency")
    nodal = lumped_admittance(CELL, frequency, AIR)
    # the rigid top: no flow through the opening; the rest of the tubes: 6.25 mm less the stub of 4 radii
    condensed = nodal[:, :2, :2] - nodal[:, :2, 2:] @ nodal[:, 2:, :2] / nodal[:, 2:, 2:]
    duct = port_admittance(2.5e-4, 5.25e-3, frequency, AIR)
    own, transfer = duct[:, :1, :1] * np.eye(2), duct[:, :1, 1:] * np.eye(2)
    cell = own - transfer @ np.linalg.solve(condensed + own, transfer)
    np.testing.assert_allclose(cell[:, 0, 0], column("resonator_cell", "Y11"), rtol=2e-3)
    np.testing.assert_allclose(cell[:, 0, 1], column("resonator_cell", "Y12"), rtol=2e-3)
    compliance = cell.sum((1, 2))
    expected = 2 * (column("resonator_cell", "Y11") + column("resonator_cell", "Y12"))
    np.testing.assert_allclose(compliance, expected, rtol=2e-3)


def test_leaving_out_the_entrance_is_the_main_error():
    frequency = np.array([1.0])
    nodal = lumped_admittance(CELL, frequency, AIR)
    bare = port_admittance(2.5e-4, 1e-3, frequency, AIR)
    assert abs(nodal[0, 0, 2] / bare[0, 0, 1] - 1) == pytest.approx(
        1.5 * np.pi / 8 / (4 + 1.5 * np.pi / 8), rel=0.02, abs=0
    )


@pytest.mark.parametrize("cell", [CELL, CHAMBER], ids=["resonator", "microphone"])
def test_a_lumped_cell_is_reciprocal_and_passive(cell):
    nodal = lumped_admittance(cell, BAND, AIR)
    assert nodal.shape[1:] == (3, 3)
    np.testing.assert_allclose(nodal, np.swapaxes(nodal, 1, 2), rtol=1e-12)
    assert np.linalg.eigvalsh(nodal.real).min() >= -1e-12 * np.abs(nodal).max()


@pytest.mark.parametrize("cell", [CELL, CHAMBER], ids=["resonator", "microphone"])
def test_at_low_frequency_a_cell_holds_its_isothermal_volume(cell):
    frequency = np.array([0.01])
    volume = np.pi / 4 * cell.diameter**2 * cell.height
    volume += sum(np.pi / 4 * port.bore_diameter**2 * port.stub_length for port in cell.ports)
    volume += np.pi / 4 * cell.opening_diameter**2 * cell.opening_length
    total = lumped_admittance(cell, frequency, AIR).sum()
    assert total.imag == pytest.approx(2 * np.pi * 0.01 * volume * 1e-9 / AIR.pressure, rel=1e-4, abs=0)
