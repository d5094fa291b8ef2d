"""The pinned and the current design side by side, by the rules of every comparison."""

from __future__ import annotations

from pathlib import Path

import pytest

import studies
from geometry import prototype
from studies.panels.pinned_panel import field_rows, figure_rows, make_comparison
from studies.panels.points import point_figures

ARRAY = prototype("array-2x6")
LONGER = ARRAY.with_values({"tube.length": 14.0, "name": "other"})


def test_fields_that_differ_stand_side_by_side() -> None:
    assert field_rows(ARRAY, ARRAY) == []
    assert field_rows(LONGER, ARRAY) == [{"name": "tube.length", "unit": "mm", "here": 14.0, "there": 12.5}]


def test_figures_are_those_of_compare_and_so_is_the_better_one() -> None:
    now, pinned = (point_figures(design)["figures"] for design in (LONGER, ARRAY))
    rows = {row["name"]: row for row in figure_rows(now, pinned)}
    found = studies.compare(ARRAY, LONGER, printing=False)
    for figure in found.figures:
        if row := rows.pop(figure.quantity.name, None):
            assert (row["there"], row["here"]) == figure.values
            assert row["texts"] == list(figure.written)
            assert row["better"] == {(): "", (0,): "worse", (1,): "better"}[figure.best]
    assert rows == {}


def test_a_figure_that_is_not_known_has_no_better_side() -> None:
    (row,) = figure_rows({"cost": 3.0}, {"cost": None})
    assert (row["texts"], row["better"]) == (["", "3 USD"], "")


@pytest.mark.slow
def test_the_page_of_both_is_that_of_compare(tmp_path: Path) -> None:
    told: list[str] = []
    path = Path(make_comparison(LONGER, ARRAY, str(tmp_path), told.append))
    page = path.read_text(encoding="utf-8")
    assert path.name == "comparison.html"
    assert "Comparison of array-2x6-pinned, other-now" in page
    assert any(line.startswith("other-now (2 of 2)") for line in told)
