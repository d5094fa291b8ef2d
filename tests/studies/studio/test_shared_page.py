"""The page without a studio holds all that it shows, as data, and asks nobody."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from browser import PAINTED, ROOT, Studio, downloaded, opened, panel, shown, until

from geometry import load_design, prototype
from studies.studio.shared_page import page_of

HELD: dict[str, Any] = {
    "about": {"made": "2026-11-28", "version": "0.2.0"},
    "toml": "description = '</script><script>alert(1)</script>'",
    "messages": [{"type": "words", "text": "<!-- <script>"}],
    "curves": {},
}


def test_the_page_holds_its_data_and_no_address() -> None:
    page = page_of("a <b> & c", HELD)
    assert "<title>a &lt;b&gt; &amp; c</title>" in page
    before, _, after = page.partition('<script type="application/json" id="shared">')
    data, _, rest = after.partition("</script>")
    assert json.loads(data) == HELD
    assert rest.count("</script>") == 1  # the program itself
    assert not re.search(r'<(link|script|img)[^>]*(src|href)="(?!data:)', before)
    assert "default-src 'none'" in before


@pytest.mark.slow
@pytest.mark.end_to_end
def test_a_shared_page_shows_the_design_without_a_studio(browser: Any, running: Studio, tmp_path: Path) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    shown(page, "model", "points", "verdict", "as_built", "check")
    panel(page, "make")
    path = downloaded(page, lambda: page.click("[data-export='page.html']"), tmp_path, 240)
    texts = {name: page.locator(name).inner_text() for name in ("#verdict-shown strong", "#size", "#print-verdict")}
    figures = page.evaluate("document.getElementById('figures').textContent")
    assert page.problems == []
    context.close()

    context = browser.new_context(viewport={"width": 1440, "height": 900}, offline=True, accept_downloads=True)
    alone, problems = context.new_page(), list[str]()
    alone.on("pageerror", lambda error: problems.append(str(error)))
    alone.on("console", lambda told: problems.append(told.text) if told.type == "error" else None)
    alone.goto(path.as_uri())
    until(alone, f"{PAINTED} && {ROOT}.shown_model === '0' && {ROOT}.shown_check === '0'", 60)
    panel(alone, "make")
    assert {name: alone.locator(name).inner_text() for name in texts} == texts
    assert alone.evaluate("document.getElementById('figures').textContent") == figures
    for gone in ("#undo", "#new", "#pin", "#tab-touch", "#exports", "#solve"):
        assert not alone.locator(gone).is_visible()
    before = alone.locator("#plots canvas").first.screenshot()
    alone.select_option("#quantity", "phase")
    until(alone, "document.querySelector('#plots figcaption').textContent.includes('phase')")
    assert alone.locator("#plots canvas").first.screenshot() != before
    panel(alone, "design")
    assert alone.locator("[data-name='tube.length'] .value").input_value() == "12.5"
    assert alone.evaluate("document.getElementById('fields').inert")
    saved = downloaded(alone, lambda: alone.click("#save"), tmp_path)
    assert load_design(saved) == prototype("array-2x6")
    assert problems == []
    context.close()
