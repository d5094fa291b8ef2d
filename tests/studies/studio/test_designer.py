"""A designer at work in the studio, from a job to the files to build from; axe-core on every panel."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import pytest
from browser import PAINTED, ROOT, Studio, downloaded, field, opened, panel, shown, until

pytestmark = [pytest.mark.slow, pytest.mark.end_to_end]
#: Of axe-core's grades.
FAULTS = ("moderate", "serious", "critical")
PANELS = ("design", "body", "sound", "touch", "make", "study")


def settled(page: Any) -> None:
    """Wait until curves, array and verdict are of the design at hand."""
    until(page, PAINTED)
    shown(page, "model", "verdict")


def click_a_line(page: Any) -> None:
    """Click the line of a snapshot on its first axis, where the pointer finds it."""
    canvas = page.locator("#parallel")
    canvas.scroll_into_view_if_needed()
    for down in range(35, 215, 4):
        canvas.hover(position={"x": 70, "y": down})
        if page.locator("#parallel-pointed").inner_text().startswith("array-2x6: "):
            return canvas.click(position={"x": 70, "y": down})
    pytest.fail("no line is found")


def test_a_designer_goes_from_a_job_to_the_files_to_build_from(browser: Any, running: Studio, tmp_path: Path) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    page.click("#new")
    until(page, "document.querySelectorAll('#job-prototypes button').length === 8")
    page.fill("#job-size", "30x30")
    page.fill("#job-points", "16")
    page.click("#job-propose")
    until(page, "document.querySelectorAll('#job-found > li').length", 400)
    cards = page.locator("#job-found > li")
    assert cards.count() == 3
    assert all("16 points" in text for text in cards.all_inner_texts())
    marginal = page.locator("#job-found > [data-outcome='marginal'] .pick")
    (marginal.first if marginal.count() else page.locator(".pick").first).click()
    until(page, f"{ROOT}.revision === '1'")
    settled(page)
    page.click("#snapshot")

    before = float(field(page, "tube.inner_diameter").input_value())
    page.evaluate("document.querySelector(`[data-group='tube']`).open = true")
    page.locator("[data-name='tube.inner_diameter'] .slider").focus()
    page.keyboard.press("ArrowRight")
    until(page, f"{ROOT}.revision === '2'")
    assert float(field(page, "tube.inner_diameter").input_value()) > before
    settled(page)
    mends = page.locator("#verdict-shown button")
    if mends.count():
        mends.first.click()
        until(page, f"{ROOT}.revision === '3'")
        settled(page)

    shown(page, "surface")
    count = page.locator("#touch-points button").count()  # a change that mends the design may leave fewer than 16
    for point in (1, count // 2, count):
        page.evaluate("delete document.getElementById('answer').dataset.named")
        page.locator("#touch-points button").nth(point - 1).click()
        until(page, "document.getElementById('answer').dataset.named !== undefined", 240)
        assert page.locator("#answer").inner_text().startswith(f"A tap on point {point}; located: ")

    panel(page, "study")
    page.locator("#snapshots button", has_text="Compare").click()
    until(page, "document.querySelectorAll('#compared-figures tr').length")
    # A change that mends the design may set the bore back, and then leaves fewer points.
    differences = page.locator("#differences").inner_text()
    assert "inner_diameter" in differences or "points" in differences
    panel(page, "make")
    with ZipFile(downloaded(page, lambda: page.click("[data-export='parts.zip']"), tmp_path, 600)) as archive:
        assert "1-buy/bill.csv" in archive.namelist()
    assert page.problems == []
    context.close()


def test_a_project_file_brings_back_the_design_its_snapshots_and_notes(page: Any, tmp_path: Path) -> None:
    shown(page, "model", "points")
    page.click("#snapshot")
    panel(page, "study")
    page.fill("#notes", "the first try")
    page.select_option("#prototypes", "line-2")
    until(page, f"{ROOT}.revision === '1'")
    click_a_line(page)
    until(page, f"{ROOT}.revision === '2'")
    assert page.locator("#name").inner_text() == "array-2x6"
    project = downloaded(page, lambda: page.click("#project"), tmp_path)
    page.locator("#snapshots button", has_text="\N{MULTIPLICATION SIGN}").click()
    assert page.locator("#snapshots li").count() == 0
    page.select_option("#prototypes", "fingertip-3x4")
    until(page, f"{ROOT}.revision === '3'")
    page.set_input_files("#open", project)
    until(page, f"{ROOT}.revision === '4'")
    assert page.locator("#name").inner_text() == "array-2x6"
    assert page.locator("#snapshots li").count() == 1
    assert page.locator("#notes").input_value() == "the first try"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_no_panel_has_a_moderate_or_serious_fault_of_axe(browser: Any, running: Studio, scheme: str) -> None:
    context = browser.new_context(viewport={"width": 1280, "height": 800}, color_scheme=scheme)
    page = opened(context, running)
    until(page, f"{ROOT}.shown_model === '0' && {ROOT}.shown_points === '0'")
    page.evaluate(files("axe_playwright_python").joinpath("axe.min.js").read_text("utf-8"))
    found = {}
    for name in PANELS:
        panel(page, name)
        for each in page.evaluate("axe.run()")["violations"]:
            if each["impact"] in FAULTS:
                found[name, each["id"]] = [node["html"] for node in each["nodes"]]
    assert not found
    unnamed = "[...document.querySelectorAll(`canvas:not([aria-label], [aria-hidden])`)]"
    assert page.evaluate(f"{unnamed}.map((each) => each.outerHTML)") == []
    context.close()
