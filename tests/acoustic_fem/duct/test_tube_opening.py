"""Entrance losses against Navier-Stokes tables."""

import numpy as np
import pytest
from reference_data import AIR, rows

from acoustic_fem.atlas.cell_table import Opening, cell_atlas
from acoustic_fem.duct.plane_wave import series_impedance
from acoustic_fem.duct.tube_opening import LARGEST_SHEAR_NUMBER, entrance_impedance
from acoustic_fem.quantities.local_air import design_air
from geometry.air.cells import cell_catalogue
from geometry.design.design_file import prototype, prototype_names
from geometry.layout.arrangement import place_housings

WIDE = [row for row in rows("entrance") if row["duct_radius"] == 50 * row["radius"]]
NARROW = [row for row in rows("entrance") if row["duct_radius"] == 5 * row["radius"]]


def excess(row):
    return entrance_impedance(row["radius"], row["frequency"], AIR) * row["radius"] ** 3 / AIR.viscosity


@pytest.mark.parametrize("row", WIDE, ids=lambda row: f"{row['frequency']:g} Hz")
def test_opening_into_a_wide_cavity_agrees_with_navier_stokes(row):
    assert excess(row).real == pytest.approx(row["excess"][0], rel=0.04, abs=0)
    assert excess(row).imag == pytest.approx(row["excess"][1], rel=0.095, abs=0)


@pytest.mark.parametrize("row", NARROW, ids=lambda row: f"{row['frequency']:g} Hz")
def test_opening_into_a_cavity_of_five_bore_radii_has_less_inertance(row):
    assert excess(row).real == pytest.approx(row["excess"][0], rel=0.04, abs=0)
    assert row["excess"][1] / excess(row).imag == pytest.approx(0.76, abs=0.03)


def test_a_warning_with_numbers_comes_above_the_checked_shear_number():
    with pytest.warns(UserWarning, match=r"shear number .* = 5\.1 is above 5,.*bore radius 0\.25 mm, up to 1000 Hz"):
        entrance_impedance(2.5e-4, [1.0, 1000.0], AIR)


def test_up_to_the_largest_shear_number_a_tube_of_60_radii_is_within_04_percent_of_the_atlas():
    for name in prototype_names():
        design = prototype(name)
        air, table = design_air(design), cell_atlas()
        for cell in cell_catalogue(design, place_housings(design)).distinct:
            for port in cell.ports:
                a = port.bore_diameter / 2e3
                square = np.linspace(0.1, LARGEST_SHEAR_NUMBER, 50) ** 2
                frequency = square * air.kinematic_viscosity / a**2 / (2 * np.pi)
                hole = cell.opening_diameter / 2e3 if cell.kind == "microphone" else None
                sizes = cell.diameter / 2e3, cell.height / 1e3, cell.height_of(port) / 1e3
                own = air.viscosity / a**3 * table.impedance(cell.kind, Opening(a, *sizes, hole), square)
                off = np.abs(entrance_impedance(a, frequency, air) - own)
                assert (off < 0.004 * np.abs(60 * a * series_impedance(a, frequency, air))).all()
