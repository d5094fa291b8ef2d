"""The study of the paper's table: the page shows the stored rows, and rows that are there are not made again."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import typer

from benchmarks import paper_table
from benchmarks.paper_table import BEGIN, END, FULL_BEGIN, FULL_END, Row, full_table, solved, table

PAGE = Path(__file__).parents[2] / "docs" / "studies" / "paper_table" / "README.md"
STORED = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(PAGE.parent.glob("line-*.json"))]
ROWS, FULL_ROWS = ([row for row in STORED if row["full"] == full] for full in (False, True))


@pytest.mark.parametrize(
    ("begin", "end", "of", "rows"), [(BEGIN, END, table, ROWS), (FULL_BEGIN, FULL_END, full_table, FULL_ROWS)]
)
def test_the_tables_of_the_page_are_those_of_the_stored_rows(begin, end, of, rows):
    shown = PAGE.read_text(encoding="utf-8").partition(begin)[2].partition(end)[0].strip()
    assert shown == of(rows)
    assert len(shown.splitlines()) == 2 + len(rows)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row['design']}-{row['points_per_line']}-{row['noise']:g}")
def test_a_row_was_trained_and_is_shown_as_its_file_says(row):
    assert row["plan"]["microphone_noise"] == row["noise"]
    trained = row["network"]["training"]["touches"] // row["points"]
    assert f"| {row['points']} | {1e3 * row['noise']:g} | " in table([row])
    assert f" | {trained} | " in table([row])


def test_a_row_of_the_papers_plan_says_how_far_it_was_trained():
    training = ROWS[0]["network"]["training"] | {"touches": 67_200, "held_out_accuracy": [0.5], "held_out_touches": 100}
    row = ROWS[0] | {"points": 12, "touches": 100, "plan": {"seconds_per_point": 11_200}}
    row["network"] = row["network"] | {"training": training}
    assert "| 2 | 12 | 0.5 | 67,200 | 50.0 (40.4 to 59.6) | " in full_table([row])


@pytest.mark.parametrize(("design", "lines"), [("line-2", 1), ("line-3", 3), ("line-4", 6)])
def test_the_arrays_have_so_many_points_on_every_line(design, lines):
    response = solved(Row(design, 4, 0.0))
    assert np.bincount(response.line).tolist() == [4] * lines


def test_rows_that_are_stored_are_not_made_again(tmp_path, monkeypatch, capsys):
    made = []

    def measured(row, full, folder, seconds):
        made.append(row.name)
        return ROWS[0] | {"design": row.design, "points_per_line": row.points_per_line, "noise": row.noise}

    monkeypatch.setattr(paper_table, "measure", measured)
    for points in ([12], [12, 24]):
        paper_table.main(tmp_path, False, ["line-2"], points)
    assert made == [f"line-2-{points}-noise-{noise}" for points in (12, 24) for noise in ("0", "0.001")]
    assert (tmp_path / "table.md").read_text(encoding="utf-8").count("\n") == 2 + 4


@pytest.mark.parametrize(("design", "points"), [(["line-5"], None), (None, [1]), (None, [65])])
def test_arrays_out_of_range_are_refused(tmp_path, design, points):
    with pytest.raises(typer.BadParameter, match="must be"):
        paper_table.main(tmp_path / "none", False, design, points)
    assert not (tmp_path / "none").exists()
