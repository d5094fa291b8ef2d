"""Entrance losses against Navier-Stokes tables."""

import pytest
from reference_data import AIR, rows

from acoustic_fem.duct.tube_opening import entrance_impedance

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
    with pytest.warns(UserWarning, match=r"shear number .* = 3\.6 is above 3,.*bore radius 0\.25 mm, up to 500 Hz"):
        entrance_impedance(2.5e-4, [1.0, 500.0], AIR)
