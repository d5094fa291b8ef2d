"""Wirings: what connects, and how many points a microphone serves."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, strategies as st

from geometry.plan.wiring_graph import check_topology, wiring_counts


@given(st.integers(2, 12), st.integers(1, 200))
def test_fully_connected_wirings_have_the_papers_ratios(microphones: int, points: int) -> None:
    lines = microphones * (microphones - 1) // 2
    counts = wiring_counts(microphones, [points] * lines)
    assert counts.lines == counts.most_lines == lines
    assert counts.points == points * lines
    assert counts.gain_over_one_transducer_per_point == pytest.approx(points * (microphones - 1) / 2)
    assert counts.gain_over_row_column == pytest.approx((microphones - 1) * (microphones + points) / (2 * microphones))


def test_lines_of_different_lengths_count_by_their_mean() -> None:
    counts = wiring_counts(3, [4, 8])
    assert (counts.points, counts.points_per_microphone) == (12, 4.0)
    assert counts.gain_over_row_column == pytest.approx(12 / 3 * (3 + 6) / (3 * 6))


@pytest.mark.parametrize(
    ("microphones", "points", "message"),
    [
        (0, [], "microphones = 0 must be at least 2"),
        (1, [5], "microphones = 1 must be at least 2"),
        (-2, [5], "microphones = -2 must be at least 2"),
        (3, [5], r"points_per_line has 1 line; it must have M-1 = 2 to M\(M-1\)/2 = 3 for 3 microphones"),
        (3, [5] * 10, "points_per_line has 10 lines"),
        (2, [0], r"points_per_line = \[0\] must be at least 1 each"),
    ],
)
def test_wirings_that_cannot_be_are_not_counted(microphones: int, points: list[int], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{message}"):
        wiring_counts(microphones, points)


@given(st.integers(2, 8), st.data())
def test_every_connected_wiring_is_accepted_and_every_other_is_refused(microphones: int, data: st.DataObject) -> None:
    names = [f"M{k}" for k in range(microphones)]
    pairs = data.draw(st.lists(st.sampled_from(list(combinations(names, 2))), unique=True))
    reached = {names[0]}
    for _ in names:
        reached |= {name for pair in pairs for name in pair if reached & set(pair)}
    lines = [(pair, 1) for pair in pairs]
    if reached == set(names):
        check_topology(names, lines)
    else:
        with pytest.raises(ValueError, match=r"^microphones: 'M\d' (?:is on no line|cannot be reached)"):
            check_topology(names, lines)


def test_more_lines_than_pairs_are_refused() -> None:
    with pytest.raises(ValueError, match=r"lines = 2 lines must be at most M\(M-1\)/2 = 1 for 2 microphones"):
        check_topology(["A", "B"], [(("A", "B"), 1), (("B", "A"), 1)])
