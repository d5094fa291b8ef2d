"""Sensors that are made with tolerances, as factors on the transfer functions of a library."""

import numpy as np
import pytest

import geometry
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter import (
    UNCALIBRATED,
    UNKNOWN_AIR_AND_RUBBER,
    AsBuiltSensors,
    DrawnSensors,
    ScatteredDesign,
    batch_of_sensors,
    scatter_factors,
)

DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})
GRID = np.array([5.0, 50.0, 200.0])


@pytest.fixture(scope="module")
def scattered() -> ScatteredDesign:
    return ScatteredDesign(DESIGN)


def factors(scattered: ScatteredDesign, count: int = 2, **more: float) -> np.ndarray:
    return scatter_factors(scattered, design_air(DESIGN), GRID, count, 3, **more)


def test_without_deviations_the_factors_are_one(scattered: ScatteredDesign) -> None:
    assert factors(scattered, fraction=0.0) == pytest.approx(1.0, abs=1e-4)


def test_a_share_of_the_deviations_does_that_share(scattered: ScatteredDesign) -> None:
    whole, tenth = (np.log(np.abs(factors(scattered, fraction=fraction))) for fraction in (0.1, 0.01))
    assert np.abs(whole - 10 * tenth).max() < 0.1 * np.abs(whole).max()


def test_a_sensor_is_the_same_whatever_is_drawn_with_it(scattered: ScatteredDesign) -> None:
    assert factors(scattered, 3)[2:] == pytest.approx(factors(scattered, 1, first=2), rel=1e-12)


def test_discs_as_thick_as_can_be_solved_are_drawn() -> None:
    diameter = DESIGN.resonator.cavity_diameter
    thick = DESIGN.with_values({"membrane.thickness": diameter})
    found = scatter_factors(ScatteredDesign(thick), design_air(thick), GRID, 8, 3)
    assert np.isfinite(found).all()
    assert 0.001 < np.abs(np.log(np.abs(found))).mean() < 0.3


def test_sensors_of_several_designs_in_one_batch_are_those_of_each_alone() -> None:
    sets = []
    for number, bore in enumerate((0.3, 0.4)):
        design = DESIGN.with_values({"tube.inner_diameter": bore})
        own = ScatteredDesign(design, UNCALIBRATED)
        air = UNKNOWN_AIR_AND_RUBBER.draws(0, 5, 1, design) if number else None
        sets.append(DrawnSensors(AsBuiltSensors(own, GRID), own.draws(0, 5, number), air))
    together = batch_of_sensors(sets)
    for one, found in zip(sets, together, strict=True):
        alone = one.sensors.transfer_functions(one.draws, one.air_and_rubber)
        assert found == pytest.approx(alone, rel=1e-9)
    assert np.abs(together[0] / together[1] - 1).max() > 0.1
