"""Sensors that are drawn for training: about the design, each the same whenever it is asked for."""

import numpy as np
import pytest

import geometry
import localize
from acoustic_fem import solve
from acoustic_fem.scatter.air_and_rubber import UNKNOWN_AIR_AND_RUBBER
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign
from localize.signals.array_response import response_of
from localize.signals.as_built_draws import AsBuiltDraws


@pytest.fixture(scope="module")
def library():
    return solve(geometry.prototype("array-2x6"), "1:500:500", fidelity="lumped")


def draws(library, count=120, share=0.0):
    return AsBuiltDraws(library, response_of(library), count, 7, share)


def test_drawn_sensors_are_those_of_the_scatter_between_the_frequencies_that_were_solved(library):
    sensors = draws(library).sensors(48, 5)  # across a block's end
    frequency = np.array([1.0, 3.0, 10.0, 31.0, 100.0, 300.0])
    scattered = ScatteredDesign(library.design, UNCALIBRATED)
    exact = scatter_factors(scattered, library.medium, frequency, 5, 7, first=48, air_and_rubber=UNKNOWN_AIR_AND_RUBBER)
    at = frequency.astype(int) - 1
    found = sensors[..., at] / response_of(library).transfer_function[..., at]
    assert np.abs(found / exact - 1)[..., :5].max() < 2e-3
    assert np.abs(exact - 1).max() > 0.05


def test_a_share_of_the_sensors_is_the_design(library):
    sensors = draws(library, share=1 / 6).sensors(0, 60)
    is_designed = np.abs(sensors / response_of(library).transfer_function - 1).max((1, 2, 3)) < 1e-6
    assert is_designed.sum() == 10


def test_a_sensor_is_the_same_whatever_was_asked_for_before(library):
    one, other = draws(library), draws(library)
    other.sensors(0, 3)
    assert np.array_equal(one.sensors(77, 2), other.sensors(76, 3)[1:])


class Stored:
    """The same sensors, as a store has them: without factors."""

    def __init__(self, drawn):
        self.frequency, self.sensor_count, self.sensors = drawn.frequency, drawn.sensor_count, drawn.sensors


def test_touches_by_factors_are_those_by_transfer_functions(library):
    drawn = draws(library, share=1 / 6)
    by_factors, by_transfer_functions = (
        localize.TouchGenerator(response_of(library), 3, "evaluation", source=source).samples(0, 48).signals
        for source in (drawn, Stored(drawn))
    )
    assert (by_factors - by_transfer_functions).abs().max() < 1e-3 * by_factors.abs().max()
