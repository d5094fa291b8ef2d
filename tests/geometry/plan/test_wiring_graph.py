"""Wirings: what connects, and how many points a microphone serves."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, strategies as st
from refusals import refused

from geometry.ground.refusal import Kind
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
    ("microphones", "points", "kind", "field"),
    [
        *((count, points, Kind.OUT_OF_RANGE, "microphones") for count, points in ((0, []), (1, [5]), (-2, [5]))),
        *((3, [5] * lines, Kind.CONFLICT, "points_per_line") for lines in (1, 10)),
        (2, [0], Kind.OUT_OF_RANGE, "points_per_line"),
    ],
)
def test_wirings_that_cannot_be_are_not_counted(microphones: int, points: list[int], kind: Kind, field: str) -> None:
    with refused(kind, field):
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
        with refused(Kind.CONFLICT, "microphones"):
            check_topology(names, lines)


def test_more_lines_than_pairs_are_refused() -> None:
    with refused(Kind.CONFLICT, "lines"):
        check_topology(["A", "B"], [(("A", "B"), 1), (("B", "A"), 1)])
