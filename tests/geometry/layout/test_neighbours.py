"""Places close together are those that a tree finds."""

import numpy as np
from hypothesis import given, strategies as st
from scipy.spatial import cKDTree

from geometry.layout.neighbours import near_pairs


@given(st.integers(0, 2**32 - 1), st.integers(1, 60), st.integers(1, 60), st.floats(0.05, 200.0))
def test_pairs_are_those_of_a_tree(seed, here, there, reach):
    random = np.random.default_rng(seed)
    size = random.uniform(0.0, 100.0, 3)
    first, second = (random.uniform(-size, size, (count, 3)) for count in (here, there))
    found = near_pairs(first, second, reach)
    near = cKDTree(second).query_ball_point(first, reach)
    assert sorted(map(tuple, found.tolist())) == [(i, j) for i, each in enumerate(near) for j in sorted(each)]


def test_places_exactly_as_far_apart_as_asked_are_near():
    corners = np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 2.0) for z in (0.0, 2.0)])
    assert len(near_pairs(corners, corners, 2.0)) == 8 + 2 * 12
