"""The counting rules as a table and a picture, for any number of microphones and points."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, strategies as st
from matplotlib.image import imread
from refusals import refused

from geometry import Kind
from studies.run.wiring import draw_wirings, wirings


@given(st.integers(2, 16), st.integers(1, 1000))
def test_there_is_a_wiring_for_every_number_of_lines_from_a_chain_to_every_pair(microphones: int, points: int) -> None:
    found = wirings(microphones, points)
    assert len(found) == (microphones * (microphones - 3) + 4) / 2
    assert [counts.lines for counts in found] == list(range(microphones - 1, microphones * (microphones - 1) // 2 + 1))
    assert all(counts.points == counts.lines * points for counts in found)
    last = found[-1]
    assert last.gain_over_one_transducer_per_point == pytest.approx(points * (microphones - 1) / 2)
    assert last.gain_over_row_column == pytest.approx((microphones - 1) * (microphones + points) / (2 * microphones))


@pytest.mark.parametrize(("microphones", "points"), [(2, 1), (16, 36)])
def test_a_picture_is_drawn_for_the_fewest_and_the_most_microphones(
    tmp_path: Path, microphones: int, points: int
) -> None:
    picture = imread(draw_wirings(tmp_path / "wiring.png", microphones, points))
    assert picture.shape[1] > 1000
    assert (picture[..., :3] < 0.9).any(axis=2).mean() > 0.01


@pytest.mark.parametrize(
    ("microphones", "points", "field", "value"),
    [(1, 5, "microphones", 1), (17, 5, "microphones", 17), (2, 0, "points_per_line", 0)],
)
def test_numbers_out_of_range_are_refused_by_name(microphones: int, points: int, field: str, value: int) -> None:
    with refused(Kind.OUT_OF_RANGE, field, value):
        wirings(microphones, points)
