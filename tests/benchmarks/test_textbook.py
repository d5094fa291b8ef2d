"""The textbook line fails as README and the theory say, and agrees with the program where its assumptions hold."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import acoustic_fem
import geometry
from benchmarks import textbook

DOCS = Path(__file__).parents[2] / "docs"


def test_the_level_difference_is_wrong_by_more_than_three() -> None:
    design, grid = geometry.prototype(textbook.DESIGN), textbook.FREQUENCIES
    solved = acoustic_fem.solve(design, grid, fidelity="lumped").transfer_function.values
    own = textbook.level_differences(solved)[0]
    other = textbook.level_differences(textbook.textbook_transfer_functions(design, grid))[0]
    assert own[-1] / other[-1] > 3
    assert np.all(np.abs(other[:-1]) < own[:-1] / 3)
    text = (DOCS / "theory.md").read_text(encoding="utf-8")
    section = text.partition("## Failure of textbook resonators")[2].partition("\n## ")[0]
    rows = np.array(re.findall(r"^\| (\d+) \| (-?[\d.]+) \| (-?[\d.]+) \|$", section, re.MULTILINE), dtype=float)
    assert rows[:, 0] == pytest.approx(grid)
    assert rows[:, 1] == pytest.approx(own, rel=0.03)
    assert rows[:, 2] == pytest.approx(other, abs=0.06)


def test_the_textbook_line_is_reciprocal_and_passes_all_pressure_at_low_frequency() -> None:
    design = geometry.prototype(textbook.DESIGN)
    h = textbook.textbook_transfer_functions(design, np.array([1e-3, 30.0]))
    assert np.abs(h[..., 0]) == pytest.approx(1, abs=1e-3)
    assert h[::-1, ::-1] == pytest.approx(h, rel=1e-9)  # the line is the same from both ends
