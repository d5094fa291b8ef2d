"""Changes of a design in the browser: none is lost on its way, and nothing stays on the page that is not so."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import PAINTED, ROOT, Studio, downloaded, field, give, opened, panel, shown, studio, until

from geometry import prototype
from geometry.design.array_design import validated
from geometry.stock import catalogue
from studies.comparison import differing_fields
from studies.panels.curve_validity import validity
from studies.panels.curves import quick_library
from studies.panels.form import form_of
from studies.panels.form_hints import values_in_use

pytestmark = pytest.mark.slow
#: What this page keeps of its design.
KEPT = "JSON.parse(sessionStorage.getItem('acoustic-fem-studio')).stated"
#: Types values into fields, faster than any studio answers.
HURRY = """(values) => {
  for (const [name, value] of values) {
    const box = document.querySelector(`[data-name='${name}'] .value`);
    box.value = value;
    box.dispatchEvent(new Event("change", { bubbles: true }));
  }
}"""


def test_changes_that_come_at_once_are_all_made_in_their_order(page: Any) -> None:
    page.evaluate(
        HURRY, [["membrane.thickness", "0.7"], ["membrane.rim_width", "1.6"], ["resonator.cavity_height", "3"]]
    )
    until(page, f"{ROOT}.revision === '3'")
    page.evaluate("[...Array(3)].forEach(() => document.getElementById('undo').click())")
    until(page, f"{ROOT}.revision === '6'")
    assert page.locator("#unsaved").is_hidden()
    page.evaluate("[...Array(3)].forEach(() => document.getElementById('redo').click())")
    until(page, f"{ROOT}.revision === '9' && {PAINTED}")
    shown = {name: field(page, name).input_value() for name in ("membrane.rim_width", "resonator.cavity_height")}
    assert shown == {"membrane.rim_width": "1.6", "resonator.cavity_height": "3"}


def test_a_value_that_was_refused_does_not_stay_as_if_it_were_the_designs(page: Any) -> None:
    give(page, "tube.length", "5000")
    until(page, "document.querySelector(`[data-name='tube.length'] .refusal`).textContent")
    assert field(page, "tube.length").input_value() == "5000"
    give(page, "membrane.thickness", "0.6")
    until(page, f"{ROOT}.revision === '1'")
    assert field(page, "tube.length").input_value() == "12.5"


def test_a_slider_of_a_bought_part_goes_from_size_to_size_by_the_arrow_keys(page: Any) -> None:
    sizes, stock = catalogue().sizes("tube.inner_diameter"), catalogue()
    slider = page.locator("[data-name='tube.inner_diameter'] .slider")
    assert slider.get_attribute("max") == str(len(sizes) - 1)
    assert page.locator("[data-name='tube.inner_diameter'] datalist option").count() == len(sizes)
    slider.focus()
    place = sizes.index(0.44)
    for step in (1, 2, 3):
        page.keyboard.press("ArrowRight")
        until(page, f"{ROOT}.revision === '{step}'")
        assert field(page, "tube.inner_diameter").input_value() == f"{sizes[place + step]:g}"
        until(page, f"{KEPT}.tube.inner_diameter === {sizes[place + step]}")
        kept = validated(page.evaluate(KEPT), "page")
        assert stock.fit(kept).bought, stock.fit(kept)
    page.locator("#bought-only").uncheck()
    assert slider.get_attribute("max") == "1000"


def test_every_arrow_key_on_every_slider_changes_its_value(page: Any) -> None:
    """All sliders in both ways, without the studio, which would refuse some of the values: the page asks for them."""
    kept = page.evaluate(
        """() => {
          const stayed = [];
          for (const only of [true, false]) {
            const box = document.getElementById("bought-only");
            if (box.checked !== only) box.click();
            for (const slider of document.querySelectorAll("#fields .slider:not(:disabled)")) {
              const row = slider.closest(".field"), number = row.querySelector(".value");
              for (const key of ["ArrowRight", "ArrowUp", "PageUp", "ArrowLeft", "ArrowDown", "PageDown"]) {
                const before = Number(number.value);
                slider.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
                const up = key.endsWith("Right") || key.endsWith("Up"), moved = Number(number.value) - before;
                if (up ? moved <= 0 : moved >= 0) stayed.push([row.dataset.name, key, before, only]);
                slider.dispatchEvent(new KeyboardEvent("keyup", { key, bubbles: true }));
              }
            }
          }
          return stayed;
        }"""
    )
    fields = {each["name"]: each for each in form_of(prototype("array-2x6"))}
    sold = catalogue()
    for name, key, before, only in kept:  # only where the way or the range of the field ends
        ends = [fields[name]["lowest"], fields[name]["highest"]]
        ends += [sold.sizes(name)[0], sold.sizes(name)[-1]] if only and sold.has_sizes(name) else []
        assert before in ends, (name, key, before)


def test_eight_arrow_keys_make_a_tube_longer(page: Any) -> None:
    panel(page, "design")
    page.evaluate("document.querySelector(`[data-group='tube']`).open = true")
    page.locator("[data-name='tube.length'] .slider").focus()
    for step in range(1, 9):
        page.keyboard.press("ArrowRight")
        until(page, f"{ROOT}.revision === '{step}'")
    assert field(page, "tube.length").input_value() == "13.3"


def test_fields_that_do_not_apply_are_hidden_and_defaults_show_their_value(page: Any) -> None:
    box = page.locator("[data-name='resonator.box_length']")
    assert box.is_hidden()
    assert field(page, "resonator.port_height").get_attribute("placeholder") == "(1.25)"
    field(page, "resonator.shape").select_option("box")
    until(page, f"{ROOT}.revision === '1'")
    assert box.is_visible()
    expected = values_in_use(prototype("array-2x6").with_values({"resonator.shape": "box"}))["resonator.box_length"]
    assert box.locator(".value").get_attribute("placeholder") == f"({expected:.4g})"


def test_a_dimension_of_the_section_is_typed_on_its_line(page: Any) -> None:
    panel(page, "design")
    dimension = page.locator("[data-dimension='membrane.thickness']")
    assert dimension.input_value() == "0.5"
    dimension.fill("0.4")
    dimension.press("Enter")
    until(page, f"{ROOT}.revision === '1'")
    assert field(page, "membrane.thickness").input_value() == "0.4"
    dimension.fill("99")
    dimension.press("Enter")
    until(page, "document.querySelector(`[data-name='membrane.thickness'] .refusal`).textContent")
    dimension.blur()
    give(page, "tube.length", "14")
    until(page, f"{ROOT}.revision === '2'")
    assert dimension.input_value() == "0.4"


def test_curves_are_solved_in_3d_on_demand(page: Any) -> None:
    give(page, "tube.length", "15.25")  # a design of no other test
    until(page, f"{ROOT}.revision === '1' && {PAINTED}")
    library, fidelity = quick_library(prototype("array-2x6").with_values({"tube.length": 15.25}))
    known = validity(library.transfer_function, fidelity)
    assert page.locator("#validity-words").inner_text() == known.words
    page.click("#validity-words")
    assert page.locator("#validity-reason").inner_text() == known.reason
    page.click("#solve")
    until(page, "document.getElementById('validity-words').textContent === '3-D'", 400)
    until(page, "document.getElementById('validity-reason').textContent.startsWith('Solved in 3-D.')")
    assert not page.locator("#solve").is_visible()


def test_a_refusal_is_in_sight_where_there_is_little_room(page: Any) -> None:
    page.set_viewport_size({"width": 820, "height": 1180})
    give(page, "tube.length", "5000")
    until(page, "document.querySelector(`[data-name='tube.length'] .refusal`).textContent")
    until(
        page,
        "document.querySelector('.refused .mend').getBoundingClientRect().bottom <= innerHeight",
    )


def test_undo_by_keyboard_is_that_of_the_design_once_a_value_was_taken(page: Any) -> None:
    give(page, "tube.length", "14")
    until(page, f"{ROOT}.revision === '1'")
    page.keyboard.press("Control+z")
    until(page, f"{ROOT}.revision === '2'")
    assert field(page, "tube.length").input_value() == "12.5"
    page.keyboard.type("9")  # a text that is being typed is the browser's own
    page.keyboard.press("Control+z")
    assert page.evaluate(f"{ROOT}.revision") == "2"


def test_a_new_form_leaves_the_keyboard_where_it_was(page: Any) -> None:
    panel(page, "design")
    page.locator("#add-table").focus()
    page.select_option("#add-table", "lines.0.tube")
    until(page, f"{ROOT}.revision === '1'")
    assert page.evaluate("document.activeElement.id") == "add-table"


def test_controls_say_where_they_belong(page: Any) -> None:
    for name in ("PNG, Curves", "CSV, Touch", "Stop, Export", "touch point 3"):
        assert page.get_by_role("button", name=name, exact=True).count() <= 1
    panel(page, "touch")
    assert page.get_by_role("combobox", name="kind of touch", exact=True).count() == 1
    panel(page, "design")
    for role, name in (("button", "PNG, Curves"), ("slider", "tube length, slider")):
        assert page.get_by_role(role, name=name, exact=True).count() == 1, name
    nameless = """[...document.querySelectorAll("button, input, select")].filter((each) => !(each.labels?.length
        || each.getAttribute("aria-label") || each.textContent.trim())).map((each) => each.outerHTML)"""
    assert page.evaluate(nameless) == []


def test_an_address_without_a_design_says_so(browser: Any, running: Studio) -> None:
    context = browser.new_context()
    page = opened(context, running)
    for broken in ("", "%%%", "q1YqSy0qzszPU7JSSk4sTkxPVdJRSsxJTs0rUbKKrlYqS8wpTQUA"):
        page.evaluate(f"location.hash = '#design={broken}'")
        until(page, "document.getElementById('notice').textContent.includes('not hold a readable design')")
        page.locator("#notice button").click()
    assert page.locator("#name").inner_text() == "array-2x6"
    assert page.problems == []
    context.close()


def test_a_page_that_is_loaded_again_has_its_pinned_design_as_before(page: Any) -> None:
    page.click("#pin")
    until(page, "document.querySelector('#pin[aria-pressed=true]')")
    give(page, "tube.length", "14")
    until(page, f"{ROOT}.revision === '1' && {KEPT}.tube.length === 14")
    page.reload()
    until(page, f"{ROOT}.painted && {PAINTED}")
    panel(page, "study")
    until(page, "document.querySelectorAll('#compared-figures tr').length")
    assert page.locator("#differences tr").count() == 1


def test_a_studio_that_was_started_again_shows_all_panels_of_the_design_and_the_pinned_one(browser: Any) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    with studio() as first:
        page = opened(context, first)
        page.click("#pin")
        for length in (13, 14, 15):
            give(page, "tube.length", str(length))
            until(page, f"{KEPT}.tube.length === {length} && {PAINTED}")
        shown(page, "points", "surface")
        first.kill()
        give(page, "membrane.thickness", "0.6")  # while nobody hears it
        until(page, "document.getElementById('lost').textContent.includes('does not answer')")
    with studio(port=first.port) as second:
        until(page, "document.getElementById('lost').textContent.includes('Open the address')")
        other = context.new_page()
        other.goto(second.take_address())
        until(page, f"document.getElementById('lost').hidden && {PAINTED} && {KEPT}.membrane.thickness === 0.6")
        for stage in ("points", "surface"):
            shown(page, stage)
            place = {"points": "points-shown", "surface": "touch-shown"}[stage]
            until(page, f"!document.getElementById('{place}').classList.contains('stale')")
        until(page, "document.querySelectorAll('#compared-figures tr').length")
        panel(page, "study")
        differ = [each.split("\t") for each in page.locator("#differences").inner_text().splitlines()]
        here = prototype("array-2x6").with_values({"tube.length": 15.0, "membrane.thickness": 0.6})
        assert [each[0] for each in differ] == [each.name for each in differing_fields([here, prototype("array-2x6")])]
    context.close()


def test_the_link_of_a_page_that_sleeps_is_not_taken_for_lost(browser: Any, running: Studio) -> None:
    context = browser.new_context()
    page = context.new_page()
    page.clock.install()
    page.goto(running.take_address())
    until(page, f"{ROOT}.painted !== undefined")
    page.evaluate("""() => {
      window.losses = 0;
      new MutationObserver(() => { window.losses += 1; }).observe(document.getElementById("lost"), { childList: true });
    }""")
    for _ in range(3):
        page.clock.fast_forward(60_000)  # timers of a hidden page go once a minute
        page.evaluate("fetch('/studio.css', { method: 'HEAD' })")  # by then the answer to a ping has come
    assert page.evaluate("window.losses") == 0
    context.close()


def test_what_was_heard_of_another_design_goes_and_what_is_shown_can_be_had(page: Any, tmp_path: Path) -> None:
    panel(page, "touch")
    until(page, f"{ROOT}.shown_surface === '0'")
    page.locator("#touch-points button").nth(4).click()
    until(page, "document.getElementById('answer').dataset.named")
    table = downloaded(page, lambda: page.click("#touch-csv"), tmp_path).read_text().splitlines()
    assert table[0] == "time (s),A (Pa),B (Pa),located point"
    values = np.array([row.split(",")[:3] for row in table[1:]], float)
    np.testing.assert_allclose(values[:, 0], np.arange(len(values)) / 1000)
    assert np.abs(values[:, 1:]).max() > 0.1
    assert {row.split(",")[3] for row in table[1:]} == {"", "5"}
    picture = downloaded(page, lambda: page.click("#touch-png"), tmp_path)
    assert picture.read_bytes().startswith(b"\x89PNG")
    give(page, "tube.length", "14")
    shown(page, "surface")
    assert page.locator("#answer").inner_text().startswith("Click a membrane")
