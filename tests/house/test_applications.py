"""The worked applications: each page has the tables of its script, and the script computes them."""

from __future__ import annotations

import importlib
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

import geometry

ROOT = Path(__file__).parents[2]


@pytest.fixture
def applications(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    module = importlib.import_module("make_applications")
    monkeypatch.delitem(sys.modules, "make_applications")
    return module


def written(page: Path, begin: str, end: str) -> list[str]:
    """Lines of a section of a page."""
    text = page.read_text(encoding="utf-8")
    assert text.count(begin) == text.count(end) == 1, f"{page.name}: {begin}"
    return text.partition(begin)[2].partition(end)[0].strip().splitlines()


def test_every_page_has_its_tables_and_pictures(applications: ModuleType) -> None:
    pages = {page.stem for page in applications.PAGES.glob("*.md")}
    assert pages == set(applications.DESIGNS)
    for name in pages:
        page = applications.PAGES / f"{name}.md"
        of_prints = name in applications.PRINTS
        wanted = ("prints",) if of_prints else ("figures", "shopping", "accuracy")
        for section in (*wanted, *(("pulse",) if name in applications.PULSE else ())):
            assert len(written(page, *applications.marks(section))) > 3, f"{name}: {section}"
        assert f"make_applications.py {name}" in page.read_text(encoding="utf-8")
        for ending in () if of_prints else ("kit", "points"):
            assert (applications.PICTURES / f"{name}-{ending}.webp").stat().st_size < 150_000


def test_a_page_tells_what_the_sensor_can_and_cannot_tell(applications: ModuleType) -> None:
    for name in set(applications.DESIGNS) - set(applications.PRINTS):
        text = (applications.PAGES / f"{name}.md").read_text(encoding="utf-8")
        for heading in ("The design in figures", "From the question to the kit", "It can tell", "It cannot tell"):
            assert re.search(rf"^## {heading}$", text, re.MULTILINE), f"{name}: {heading}"


def test_touches_of_a_rig_are_decoded_with_both_libraries(applications: ModuleType) -> None:
    design = geometry.load_design(applications.EXAMPLES / applications.DESIGNS["pulse-reader"])
    found = applications.Sensors(design, (7,)).touched(touches=3)
    for accuracies in (found.design, found.own, found.nominal):
        assert set(accuracies) == {"taps", "presses"}
        assert all(0.5 < each <= 1 for values in accuracies.values() for each in values)
    assert len(found.rows()) == 5


@pytest.mark.slow
def test_the_figures_of_a_page_are_those_of_its_script(applications: ModuleType, tmp_path: Path) -> None:
    page = applications.PAGES / "pulse-reader.md"
    found = applications.sections("pulse-reader", tmp_path)
    for section, lines in found.items():
        assert written(page, *applications.marks(section)) == lines, "python docs/make_applications.py --write"
