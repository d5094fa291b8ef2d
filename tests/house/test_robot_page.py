"""The page on bodies says what the fits of its examples found and what the gallery predicts of them."""

import json
import re
from pathlib import Path

import pytest

import geometry
from geometry.layout import lay_out
from geometry.surface import plan_in_space

DOCS = Path("docs")
PAGE = (DOCS / "robot.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["fingertip", "handle", "palm"])
def test_the_table_of_examples_has_the_figures_of_their_places(name):
    design = geometry.load_design(DOCS / "examples/robot" / f"{name}.toml")
    frozen = design.layout.frozen
    (row,) = re.findall(rf"^\| `{name}\.toml` \|.*\|$", PAGE, re.MULTILINE)
    points, spacing, _, error = (float(cell) for cell in row.split("|")[3:7])
    assert points == design.point_count
    assert any(each.startswith(f"{points:.0f} points, {spacing:.1f}") for each in frozen.findings)
    stretch = plan_in_space(design, lay_out(design)).stretch
    assert error == pytest.approx(100 * stretch, abs=0.051)
    assert f"the unrolled plan is off by {error:.1f} % between neighbours" in frozen.findings
    assert name == "handle" or f"{error:g} %" in PAGE.split("## Limits")[1]


def test_the_page_shows_what_the_fit_of_the_fingertip_said():
    design = geometry.load_design(DOCS / "examples/robot/fingertip.toml")
    assert "".join(f"- {each}\n" for each in design.layout.frozen.findings) in PAGE


def test_the_figures_of_the_fingertip_are_those_of_the_gallery():
    rows = {row["name"]: row for row in json.loads((DOCS / "gallery.json").read_text(encoding="utf-8"))}
    own = rows["robot-fingertip"]
    assert f"fingertip is {own['as_built']:.0f} %, against {own['nominal']:.0f} % for the nominal sensor" in PAGE
    worked = (DOCS / "applications/fingertip.md").read_text(encoding="utf-8")
    assert f"| taps of the target, as built, predicted | {own['taps']} % |" in worked
    assert all(each in worked for each in own["broken"])
    evidence = (DOCS / "evidence/bodies.md").read_text(encoding="utf-8")
    for name in ("robot-fingertip", "robot-handle", "robot-palm"):
        row = rows[name]
        assert f"| `{name}` | {row['as_built']} | {row['worst']} | {row['nominal']} |" in evidence
