"""Results of calls show themselves in a few lines, as text in a session and as a table in a notebook."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from libraries import three_points
from small_run import small_design

import studies
from geometry.ground.shown import LONGEST_LINE, MOST_LINES, Shown

VARY: Any = {"tube.length": (12.0, 14.0)}
SEARCH = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:12"
metrics = ["volume"]
[vary]
"tube.length" = { from = 12.0, to = 14.0 }
[optimize]
trials = 4
[[optimize.objectives]]
metric = "volume"
"""


def check(found: Shown, *words: str) -> None:
    """The texts are short and hold some words."""
    lines = repr(found).splitlines()
    assert 3 <= len(lines) <= MOST_LINES
    assert max(map(len, lines)) <= LONGEST_LINE
    for each in words:
        assert each in repr(found)
        assert each.rpartition(": ")[2] in found._repr_html_()


def test_a_plan_and_a_tolerance_study(tmp_path: Path) -> None:
    study = studies.Study("array-2x6", VARY, metrics=["volume"], fidelity="lumped", cases=8, sampling="random")
    check(studies.plan_sweep(study, workers=1), "cases: 8", "with 1 worker")
    found = studies.tolerance_study(small_design(), tmp_path / "scatter", samples=3, base_samples=0)
    check(found, "sensors: 3", f"mean {found.result.accuracy['nominal'].mean():.1%}")


def test_a_calibration_says_which_point_to_measure_next() -> None:
    library, expected = three_points(), np.array([0.5, 0.9])
    nothing: Any = None
    found = studies.SensorCalibration(Path("own.nc"), Path("own.png"), library, nothing, None, expected, 3)
    check(found, "library: own.nc", "70.0%, worst 50.0%", "measure next: point 3")


@pytest.mark.slow
def test_parts_and_a_search(tmp_path: Path) -> None:
    parts = studies.export_parts(small_design(), tmp_path / "parts", formats=("stl",))
    check(parts, f"files: {len(parts.files)}", f"{parts.bill.cost:.2f} USD")
    (tmp_path / "search.toml").write_text(SEARCH, encoding="utf-8")
    search = studies.optimize(tmp_path / "search.toml", tmp_path / "search", workers=1)
    check(search, "4 computed", "volume smaller", "with: tube.length")
