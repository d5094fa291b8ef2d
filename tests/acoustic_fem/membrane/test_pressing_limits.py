"""How hard a membrane may be pressed: each limit is where the response says so."""

from __future__ import annotations

import math

import pytest
from refusals import refused

from acoustic_fem.membrane import SoftPatch, Sphere, design_membrane, press_curve, press_limits
from geometry import Kind
from geometry.schema.materials import MATERIALS, TEAR_LIMITS


def test_limits_are_where_the_response_reaches_them():
    limits = press_limits("array-2x6")
    curve = press_curve(design_membrane("array-2x6"), SoftPatch())
    small = curve.response(0.0).volume_per_force
    assert curve.volume_fraction(limits.linear_force) == pytest.approx(0.9, abs=0.01)
    assert curve.response(limits.saturation_force).volume_per_force == pytest.approx(0.1 * small, rel=0.1)
    assert curve.response(limits.tear_force).stretch == pytest.approx(4.6, rel=0.05)
    assert limits.force_at_floor == curve.force_at_floor
    assert limits.usable_force == limits.saturation_force < limits.force_at_floor < limits.tear_force
    assert limits.stretch == pytest.approx(float(curve.response(limits.usable_force).stretch))
    assert limits.elongation == pytest.approx((limits.stretch - 1) / 3.6)
    assert limits.dynamic_range(limits.usable_force / 1000) == pytest.approx(60)


@pytest.mark.slow
def test_a_blunt_finger_saturates_long_before_a_patch():
    assert press_limits("array-2x6", Sphere(8e-3)).usable_force < 0.3 * press_limits("array-2x6").usable_force


def test_a_weak_rubber_tears_first():
    weak = press_limits("array-2x6", elongation_at_break=0.2)
    assert weak.usable_force == weak.tear_force < weak.saturation_force
    assert weak.stretch == pytest.approx(1.2, rel=0.02)


def test_every_silicone_has_a_tear_limit_with_a_source():
    assert {name for name in MATERIALS if name.startswith("silicone")} == set(TEAR_LIMITS)
    assert all(limit.source and limit.elongation_at_break > 0 for limit in TEAR_LIMITS.values())


@pytest.mark.parametrize("elongation", [0.0, 21.0, math.nan])
def test_an_elongation_out_of_range_is_refused(elongation):
    with refused(Kind.OUT_OF_RANGE, "elongation_at_break"):
        press_limits("array-2x6", elongation_at_break=elongation)
