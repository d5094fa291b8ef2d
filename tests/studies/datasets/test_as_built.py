"""As-built sensors as a source of data sets: the same sensors as of the scatter, each by its number."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refused

import localize
import studies
from acoustic_fem import LocalAir
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors
from acoustic_fem.scatter.tolerances import TOLERANCES, ScatteredDesign
from geometry import Kind, prototype

GRID = np.arange(1.0, 121.0)


@pytest.fixture(scope="module")
def sensors() -> studies.AsBuiltArrays:
    return studies.as_built("array-2x6", 6, 5, frequency=GRID)


def test_each_is_the_sensor_of_its_number_in_the_scatter(sensors):
    design = prototype("array-2x6")
    scattered = ScatteredDesign(design, TOLERANCES)
    draws = scattered.draws(0, 6, 5)
    expected = AsBuiltSensors(scattered, GRID, design_air(design), "atlas").transfer_functions(draws)
    assert sensors.fidelity == "atlas"
    for found, wanted in zip(sensors.arrays([4, 0]), expected[[4, 0]], strict=True):
        np.testing.assert_allclose(found.transfer_function, wanted, rtol=1e-12)
    named = dict(zip(sensors.parameter_names, sensors.parameter_values(4), strict=True))
    assert named["bore 3"] == draws["bore"][4, 2]
    assert named["modulus_of_batch 1"] == draws["modulus_of_batch"][4, 0]
    assert "ovality 1" not in named


def test_touches_are_drawn_on_them_and_split_by_sensor(sensors):
    data = localize.TouchDataset(sensors, touches=30, batch_size=64, ambient=(40.0, 50.0))
    batches = list(data)
    assert sum(len(batch["point"]) for batch in batches) == 180
    assert batches[0]["parameters"].shape == (30, len(sensors.parameter_names))
    nominal = localize.TouchDataset(sensors.nominal, touches=30, mix={"taps": 1}, microphone_noise=0.0)
    of_one = localize.TouchDataset(sensors, touches=30, mix={"taps": 1}, microphone_noise=0.0)
    assert nominal.sample(0, 2)["signals"].shape == of_one.sample(0, 2)["signals"].shape
    assert not np.allclose(nominal.sample(0, 2)["signals"], of_one.sample(0, 2)["signals"], rtol=1e-3)


def test_they_are_in_the_air_that_is_asked_for(sensors):
    high = studies.as_built("array-2x6", 1, 5, frequency=GRID, air=LocalAir(altitude=2000))
    assert not np.allclose(high.arrays([0])[0].transfer_function, sensors.arrays([0])[0].transfer_function, rtol=1e-3)
    assert high.design.air.pressure < sensors.design.air.pressure


@pytest.mark.parametrize(
    ("arguments", "field"), [({"count": 0}, "count"), ({"seed": -1}, "seed"), ({"fidelity": "coarse"}, "fidelity")]
)
def test_a_bad_argument_is_refused(arguments, field):
    with refused(Kind.OUT_OF_RANGE, field):
        studies.as_built("array-2x6", **{"count": 2, "frequency": GRID, **arguments})


def test_a_sensor_that_was_not_drawn_is_refused(sensors):
    with refused(Kind.OUT_OF_RANGE, "case", 6):
        sensors.arrays([6])
