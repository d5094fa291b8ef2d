"""Facts of a manual for designs that the network of closed forms does not take, and for every way to make a tube."""

from __future__ import annotations

from typing import Any

import pytest

import geometry
from studies.kit import leak_tests
from studies.kit.cutting_template import template_strips
from studies.kit.expected_signals import as_built_levels, expected_signals

LINE = geometry.prototype("line-2").with_values({"lines.0.points": 2})


@pytest.mark.slow
@pytest.mark.parametrize(
    "values",
    [{"resonator.shape": "dome"}, {"resonator.shape": "box"}, {"membrane.stretch": 1.1}],
    ids=["dome", "box", "stretch"],
)
def test_a_design_without_closed_forms_has_leak_tests_and_levels_but_no_spread(values: dict[str, Any]) -> None:
    design = LINE.with_values(values)
    (test,) = leak_tests(design)
    (usual,) = leak_tests(LINE)
    assert 0.3 < test.largest_conductance / usual.largest_conductance < 3
    assert 0 < test.bulge < 0.2 * design.resonator.cavity_diameter
    assert test.linear == ("membrane.stretch" in values)
    signals = expected_signals(design, as_built_levels(design))
    assert [signal.louder for signal in signals] == ["A", "B"]
    assert all(signal.spread is None and signal.leak is None for signal in signals)
    assert all(signal.level > 0 for signal in signals)


def test_a_smooth_tubing_has_no_spring_to_cut() -> None:
    smooth = LINE.with_values({"tube.bore": "smooth", "microphone_tube.bore": "smooth"})
    assert {strip.what for strip in template_strips(smooth)} == {"tubing"}
    assert {strip.what for strip in template_strips(LINE)} == {"spring", "sheath"}
