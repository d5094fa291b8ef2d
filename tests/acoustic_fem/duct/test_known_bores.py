"""Bores from memory are those that would be worked out."""

import numpy as np
import pytest

from acoustic_fem.duct.known_bores import known_port_admittance
from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.quantities.medium import Medium
from geometry.ground.refusal import Refusal

AIR, OTHER = Medium.at(20, 0.5), Medium.at(30, 0.5)


@pytest.mark.parametrize("count", [3, 2000])
def test_each_radius_length_grid_and_gas_has_its_own(count):
    grids = [np.linspace(1, 100, count), np.linspace(1, 101, count)]
    for _ in range(2):
        for medium in (AIR, OTHER):
            for radius, length in ((2e-4, 0.01), (2e-4, 0.02), (3e-4, 0.01)):
                for grid in grids:
                    known = known_port_admittance(radius, length, grid, medium)
                    np.testing.assert_array_equal(known, port_admittance(radius, length, grid, medium))


def test_what_is_kept_cannot_be_written_to():
    known = known_port_admittance(2e-4, 0.01, np.array([1.0, 10.0]), AIR)
    with pytest.raises(ValueError, match="read-only"):
        known[0] = 0


@pytest.mark.parametrize(("radius", "length"), [(-1.0, 0.01), (2e-4, 0.0)])
def test_a_bad_bore_is_refused_every_time(radius, length):
    for _ in range(2):
        with pytest.raises(Refusal, match="must be finite and above 0"):
            known_port_admittance(radius, length, np.array([1.0]), AIR)
