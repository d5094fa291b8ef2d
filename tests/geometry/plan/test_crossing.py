"""Circles around polygons, bows and windings fit the lengths they are made for, to rounding."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st

from geometry.plan.crossing import zero_crossing
from geometry.plan.cylinder import wound_length, wound_turn
from geometry.plan.ring import corners
from geometry.plan.routing import bow_angle


@given(st.lists(st.floats(1.0, 100.0), min_size=3, max_size=9))
def test_a_polygon_has_its_sides_and_its_corners_lie_on_one_circle(sides):
    longest = max(sides)
    assume(longest < 0.9999 * (sum(sides) - longest))
    points = corners(sides)
    found = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
    assert found == pytest.approx(sides, rel=1e-9)
    # centre and radius from the normal equations of |p|^2 = 2 c.p + r^2 - |c|^2
    matrix = np.column_stack([2 * points, np.ones(len(points))])
    x, y, rest = np.linalg.lstsq(matrix, (points**2).sum(axis=1), rcond=None)[0]
    radius = math.sqrt(rest + x**2 + y**2)
    assert np.hypot(*(points - [x, y]).T) == pytest.approx(np.full(len(points), radius), rel=1e-6)


@pytest.mark.parametrize("sides", [(3.0, 4.0, 5.0), (3.0, 4.0, 3.0, 4.0), (1.0, 1.0, 2.0 - 1e-9), (2.0,) * 6])
def test_polygons_whose_centre_lies_on_a_side_or_far_away_close_too(sides):
    points = corners(sides)
    assert np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1) == pytest.approx(sides, rel=1e-9)


@given(st.floats(0.0, 30.0), st.floats(8.0, 40.0), st.floats(1.0, 3.0))
def test_a_bowed_tube_is_as_long_as_it_is_cut(spare, distance, inner):
    outer = inner + 0.5
    length = distance - 2 * inner + spare
    turn = math.radians(bow_angle(length, distance, inner, outer))
    arc = (distance - 2 * outer * math.cos(turn)) * (turn / math.sin(turn) if turn else 1.0)
    assert 2 * (outer - inner) + arc == pytest.approx(length, rel=1e-12)


@given(st.floats(0.001, 0.999), st.floats(8.0, 60.0))
def test_a_wound_tube_is_as_long_as_it_is_cut(share, radius):
    inner, outer = (2.0, 2.0), (3.0, 3.0)
    low, high = (wound_length(turn, inner, outer, radius) for turn in (2 * math.atan(3.0 / radius), math.pi))
    length = low + share * (high - low)
    assert wound_length(wound_turn(length, inner, outer, radius), inner, outer, radius) == pytest.approx(
        length, rel=1e-13
    )


def test_a_zero_at_an_end_is_found():
    assert zero_crossing(lambda x: x, 0.0, 1.0) == 0.0
    assert zero_crossing(lambda x: x - 1.0, 0.0, 1.0) == 1.0
