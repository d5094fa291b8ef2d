"""Leak tests and expected signals: against their own physics, integrated and solved in other ways."""

from __future__ import annotations

import math

import numpy as np
import pytest

import acoustic_fem
import geometry
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.membrane import bulge, design_membrane
from localize.diagnosis import SensorFault
from studies.kit import leak_tests
from studies.kit.expected_signals import FREQUENCY, HOLE, HOLE_LENGTH, LEAK_FREQUENCY, as_built_levels, expected_signals
from studies.kit.leak_testing import GAUGE_BORE, LARGEST_CORNER, WATCHED
from studies.kit.touch_leak_test import FEWEST_TOUCHES, TOUCHED_HOLE, leak_signs, touch_order
from studies.test_rig.faulty_rig import FaultyRig

DESIGN = geometry.prototype("array-2x6")


def test_the_largest_leak_has_the_stated_corner_and_is_the_stated_hole() -> None:
    (test,) = leak_tests(DESIGN)
    hole = leak_conductance(test.hole / 2000, 1e-3, acoustic_fem.LocalAir())
    assert hole == pytest.approx(test.largest_conductance, rel=0.01)
    # By the network: a leak beside a tight cell, whose response to a displaced volume is a high-pass of first order.
    air, radius = math.pi * 0.003**2 * 0.0025 / 101325, 0.003
    membrane = float(bulge(design_membrane(DESIGN), 1.0).compliance)
    corner = test.largest_conductance / (2 * math.pi * (air + membrane))
    assert corner == pytest.approx(LARGEST_CORNER, rel=0.02)
    assert test.bulge < 0.15 * 1e3 * radius


def test_the_water_falls_as_stated() -> None:
    (test,) = leak_tests(DESIGN)
    area, level = math.pi / 4 * GAUGE_BORE**2, test.water
    steps = 30_000
    for _ in range(steps):  # the gauge alone drives the leak: what the cell gives is a hundredth of it
        # One level of the U sinks and the other rises, so the height falls by twice the volume over the section.
        level -= 2 * 1e3 * test.largest_conductance * level / 1e3 * 9810 / area * WATCHED / steps
    assert test.water - level == pytest.approx(test.largest_fall, rel=0.02)
    assert test.pressure == pytest.approx(9.81 * test.water)


def test_the_water_falls_more_slowly_beside_more_points() -> None:
    """The leak empties gauge and points together: integrated step by step, with the points' own compliance."""
    (test,) = leak_tests(DESIGN)
    points, gauge = 64, math.pi / 4 * GAUGE_BORE**2 / 9810 / 2
    pressure, steps = test.pressure, 30_000
    for _ in range(steps):
        pressure -= test.largest_conductance * pressure / (gauge + points * test.cell) * WATCHED / steps
    assert float(test.fall_of(points)) == pytest.approx((test.pressure - pressure) / 9.81, abs=0.6)
    assert float(test.fall_of(points)) < float(test.fall)
    assert test.fall_of(1) == test.fall


@pytest.mark.slow
def test_every_kind_of_point_has_its_test() -> None:
    graded = geometry.load_design("docs/examples/graded-line-36.toml")
    assert [test.kind for test in leak_tests(graded)] == list(graded.kinds)


def test_expected_levels_are_those_of_the_library() -> None:
    signals = expected_signals(DESIGN, as_built_levels(DESIGN))
    h = acoustic_fem.solve(DESIGN, np.array([FREQUENCY]), fidelity="lumped").transfer_function
    for signal in signals:
        level = np.abs(h.sel(point=h.point[signal.point - 1]).values[..., 0]).ravel()
        assert signal.level == pytest.approx(level.max())
        assert signal.difference == pytest.approx(20 * np.log10(level.max() / level.min()))
    assert [signal.louder for signal in signals] == ["A"] * 6 + ["B"] * 6
    assert all(signal.spread is not None and 0.1 < signal.spread < 5 for signal in signals)


def test_a_hole_lowers_the_signal_of_its_point_as_the_design_with_that_leak_says() -> None:
    """The design states one leak for all cavities; an array of one point has only its own."""
    one = geometry.prototype("line-2").with_values({"lines.0.points": 1})
    leaky = one.with_values({"resonator.leak_diameter": 1e3 * HOLE, "resonator.leak_length": 1e3 * HOLE_LENGTH})
    levels = [
        np.abs(acoustic_fem.solve(each, np.array([LEAK_FREQUENCY]), fidelity="lumped").source_response.values).max()
        for each in (one, leaky)
    ]
    (signal,) = expected_signals(one, None)
    assert signal.leak == pytest.approx(20 * np.log10(levels[1] / levels[0]), abs=0.02)
    assert signal.leak is not None
    assert signal.leak < -0.1


def test_touches_go_over_all_points_until_there_are_enough() -> None:
    assert touch_order(DESIGN) == (*range(1, 13), *range(1, 13))
    assert touch_order(geometry.prototype("line-2")) == tuple(range(1, 37))
    assert len(touch_order(DESIGN.with_values({"lines.0.points": 5, "layout.columns": 5}))) >= FEWEST_TOUCHES


@pytest.mark.physics
def test_the_signs_of_a_leak_are_those_of_a_sensor_that_leaks() -> None:
    """Rigs have other bores, cavities, rubber and air than the design, and the change of the level stays."""
    signs = leak_signs(DESIGN, as_built_levels(DESIGN))
    assert [sign.point for sign in signs] == list(range(1, 13))
    for sign in signs[1::5]:
        assert sign.touched != sign.point
        assert sign.smallest_hole is not None
        index = [DESIGN.microphones.index(name) for name in (sign.one, sign.other)]
        changes = []
        for seed in (46931, 46932):
            levels = []
            for fault in (None, SensorFault("leak", (sign.point,), TOUCHED_HOLE)):
                h = FaultyRig(DESIGN, seed, fault, fidelity="lumped").transfer_function([FREQUENCY])
                level = 20 * np.log10(np.abs(h[sign.touched - 1, index, 0]))
                levels.append(level[0] - level[1])
            changes.append(levels[1] - levels[0])
        assert np.mean(changes) == pytest.approx(sign.leaking - sign.tight, rel=0.25)
        assert abs(sign.leaking - sign.tight) > sign.spread


def test_a_larger_hole_than_the_smallest_shows_and_a_smaller_one_does_not() -> None:
    signs = leak_signs(DESIGN, as_built_levels(DESIGN))
    assert all(sign.smallest_hole is not None and 0.03 <= sign.smallest_hole < TOUCHED_HOLE for sign in signs)
    assert leak_signs(DESIGN, None) == ()
