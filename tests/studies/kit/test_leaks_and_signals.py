"""Leak tests and expected signals: against their own physics, integrated and solved in other ways."""

from __future__ import annotations

import math

import numpy as np
import pytest

import acoustic_fem
import geometry
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.membrane import bulge, design_membrane
from studies.kit import leak_tests
from studies.kit.expected_signals import FREQUENCY, HOLE, HOLE_LENGTH, LEAK_FREQUENCY, expected_signals
from studies.kit.leak_testing import GAUGE_BORE, LARGEST_CORNER, WATCHED

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
        level -= 1e3 * test.largest_conductance * level / 1e3 * 9810 / area * WATCHED / steps
    assert test.water - level == pytest.approx(test.largest_fall, rel=0.02)
    assert test.pressure == pytest.approx(9.81 * test.water)


@pytest.mark.slow
def test_every_kind_of_point_has_its_test() -> None:
    graded = geometry.load_design("docs/examples/graded-line-36.toml")
    assert [test.kind for test in leak_tests(graded)] == list(graded.kinds)


def test_expected_levels_are_those_of_the_library() -> None:
    signals = expected_signals(DESIGN)
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
    (signal,) = expected_signals(one)
    assert signal.leak == pytest.approx(20 * np.log10(levels[1] / levels[0]), abs=0.02)
    assert signal.leak is not None
    assert signal.leak < -0.1
