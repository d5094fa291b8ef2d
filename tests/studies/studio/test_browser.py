"""The studio's page in a real browser: what a designer does, and what is then painted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import (
    PAINTED,
    ROOT,
    Studio,
    downloaded,
    field,
    figure_of,
    give,
    lit,
    opened,
    panel,
    shown,
    studio,
    until,
    until_lit,
)

from geometry import load_design, prototype
from studies.panels.points import point_figures

pytestmark = pytest.mark.slow
#: Whether this page has kept the design with a length of the tubes.
KEPT = "JSON.parse(sessionStorage.getItem('acoustic-fem-studio')).stated.tube.length === {}"
SCRIPT = "<img src=x onerror=\"document.title='broken'\"><script>document.title='broken'</script>"


def lit_pixels(picture: bytes) -> int:
    return int(lit(picture).sum())


def length(page: Any) -> str:
    return str(field(page, "tube.length").input_value())


def test_a_changed_field_is_painted(page: Any) -> None:
    before = page.locator("#plots canvas").first.screenshot()
    give(page, "tube.length", "18")
    until(page, f"document.documentElement.dataset.revision === '1' && {PAINTED}")
    assert page.locator("#plots canvas").first.screenshot() != before


@pytest.mark.parametrize("name", ["glove", "line-2"])
def test_every_panel_shows_a_design_and_a_click_lights_its_point(
    browser: Any, running: Studio, tmp_path: Path, name: str
) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    page.select_option("#prototypes", name)
    until(page, f"{ROOT}.revision === '1'")
    page.click("#pin")
    shown(page, "points", "model", "as_built", "check", "surface")
    panel(page, "sound")
    design = prototype(name)
    figures = point_figures(design)
    assert page.locator("#points-table tbody tr").count() == design.point_count
    for figure, value in figures["figures"].items():
        text = page.locator(f"#figures [data-figure='{figure}'] dd").inner_text()
        assert figure_of(text)[0] == pytest.approx(value, rel=1e-3)
    before = page.locator("#space canvas").screenshot()
    page.locator("tr[data-point='3']").click()
    assert page.locator("#point").input_value() == "3"
    until_lit(page.locator("#space canvas"), lit_pixels(before) + 100)
    assert page.locator("#point-card dt").count() > 4
    panel(page, "make")
    assert page.locator("#print-verdict").inner_text().startswith("Can be built:")
    panel(page, "study")
    assert page.locator("#compared-figures tr").count() == len(figures["figures"])
    assert page.locator("#differences").inner_text() == "no field differs"
    panel(page, "sound")
    assert (
        page.locator("#as-built").inner_text().startswith("Taps and presses on 64 as-built sensors, not calibrated: ")
    )
    panel(page, "touch")
    page.click("#game")
    mole = int(page.locator("#score").get_attribute("data-mole"))
    page.locator("#touch-points button").nth(mole - 1).click()
    until(page, "document.getElementById('score').textContent.endsWith('still to come: 9.')", 240)
    assert page.locator("#answer").inner_text().startswith(f"A tap on point {mole}; located: point ")
    panel(page, "study")
    page.select_option("#study-add", "tube.length")
    page.fill("#study-designs", "4")
    page.click("#study-run")
    until(page, f"{ROOT}.shown_study === '1'", 240)
    assert page.locator("#study-effects canvas").count() == 1
    panel(page, "make")
    saved = downloaded(page, lambda: page.click("[data-export='design.toml']"), tmp_path)
    assert load_design(saved) == design
    assert page.problems == []
    context.close()


def test_a_touch_lights_the_membrane_that_is_named_and_the_game_is_played_to_its_end(page: Any) -> None:
    shown(page, "surface")
    before = lit_pixels(page.locator("#plan").screenshot())
    page.locator("#touch-points button").nth(4).click()
    until(page, "document.getElementById('answer').dataset.named", 120)
    assert page.locator("#answer").get_attribute("data-named") == "5"
    assert lit_pixels(page.locator("#plan").screenshot()) > before + 100
    page.click("#game")
    for left in range(10, 0, -1):
        assert page.locator("#score").inner_text().endswith(f"still to come: {left}.")
        mole = int(page.locator("#score").get_attribute("data-mole"))
        page.locator("#touch-points button").nth(mole - 1).click()
        until(page, f"!document.getElementById('score').textContent.endsWith('still to come: {left}.')")
    assert "of 10 moles hit" in page.locator("#score").inner_text()


def test_what_is_refused_stands_at_its_field_and_one_click_mends_it(page: Any) -> None:
    give(page, "tube.length", "5000")
    refusal = page.locator("[data-name='tube.length'] .refusal")
    until(page, "document.querySelector(`[data-name='tube.length'] .refusal`).textContent")
    assert "tube.length = 5000 mm must be between 0.5 and 1000 mm" in refusal.inner_text()
    assert field(page, "tube.length").get_attribute("aria-invalid") == "true"
    refusal.locator("button").click()
    until(page, PAINTED + " && document.documentElement.dataset.revision === '1'")
    assert length(page) == "1000"
    assert refusal.inner_text() == ""


def test_undo_redo_and_the_mark_of_what_is_not_saved_by_keyboard(page: Any, tmp_path: Path) -> None:
    give(page, "tube.length", "14")
    until(page, "!document.getElementById('unsaved').hidden")
    page.locator("#theme").focus()
    page.keyboard.press("Control+z")
    until(page, "document.getElementById('unsaved').hidden")
    assert length(page) == "12.5"
    page.keyboard.press("Control+y")
    until(page, "!document.getElementById('unsaved').hidden")
    assert length(page) == "14"
    with page.expect_download() as download:
        page.keyboard.press("Control+s")
    download.value.save_as(tmp_path / "mine.toml")
    assert load_design(tmp_path / "mine.toml") == prototype("array-2x6").with_values({"tube.length": 14.0})
    until(page, "document.getElementById('unsaved').hidden")


def test_script_in_any_text_of_a_design_is_shown_as_text(page: Any) -> None:
    names = page.evaluate(
        "[...document.querySelectorAll('.field:not([hidden]):has(.text)')].map((each) => each.dataset.name)"
    )
    assert {"name", "description", "microphone.model", "microphone.source"} <= {*names}
    for name in names:
        before = page.evaluate(f"{ROOT}.revision")
        give(page, name, SCRIPT)
        refused = f"document.querySelector(`[data-name='{name}'] .refusal`).textContent.includes('<script>')"
        until(page, refused if name == "name" else f"{ROOT}.revision !== '{before}' || {refused}")
    assert field(page, "description").input_value() == SCRIPT
    assert "broken" not in page.title()
    assert page.locator("img, body script, [onerror]").count() == 0


def test_two_browsers_keep_two_designs_and_a_reloaded_page_its_own(browser: Any, running: Studio) -> None:
    contexts = [browser.new_context() for _ in range(2)]
    pages = [opened(context, running) for context in contexts]
    for page, value in zip(pages, ("13", "14"), strict=True):
        give(page, "tube.length", value)
        until(page, "document.documentElement.dataset.revision === '1'")
    until(pages[0], KEPT.format(13))  # a moment after the last change
    pages[0].reload()
    until(pages[0], f"document.documentElement.dataset.painted && {PAINTED}")
    assert [length(page) for page in pages] == ["13", "14"]
    for context in contexts:
        context.close()


def test_a_link_restores_the_design(browser: Any, running: Studio) -> None:
    context = browser.new_context()
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = opened(context, running)
    give(page, "tube.length", "17")
    until(page, "document.documentElement.dataset.revision === '1'")
    page.click("#address")
    until(page, "!document.getElementById('notice').hidden")
    other = context.new_page()
    other.goto(page.evaluate("navigator.clipboard.readText()"))
    until(other, f"document.documentElement.dataset.painted && {PAINTED}")
    assert length(other) == "17"
    context.close()


def test_a_studio_that_was_killed_loses_no_design_and_says_what_happened(browser: Any) -> None:
    context = browser.new_context()
    with studio() as first:
        page = opened(context, first)
        give(page, "tube.length", "15")
        until(page, "document.documentElement.dataset.revision === '1'")
        until(page, KEPT.format(15))
        first.kill()
        until(page, "document.getElementById('lost').textContent.includes('does not answer')")
    with studio(port=first.port) as second:
        until(page, "document.getElementById('lost').textContent.includes('Open the address')")
        other = context.new_page()
        other.goto(second.take_address())
        until(page, f"document.getElementById('lost').hidden && {PAINTED}")
        assert length(page) == "15"
        assert page.locator("#unsaved").is_visible()
    context.close()
