"""Parts that are dragged in the picture of the array, and sizes that are typed on its dimension lines."""

from __future__ import annotations

from typing import Any

import pytest
from browser import ROOT, Studio, field, opened, place_of, shown, until

pytestmark = pytest.mark.slow
DRAWN = f"{ROOT}.shown_model === {ROOT}.revision"


def found(page: Any, name: str) -> tuple[float, float]:
    """Place of the pointer at which the page names a part of the array at hand."""
    shown(page, "model")
    return place_of(page, name)


def drag(page: Any, start: tuple[float, float], across: float, down: float = 0.0) -> None:
    """Drag in steps, and leave the button pressed."""
    page.mouse.move(*start)
    page.mouse.down()
    for step in range(1, 9):
        page.mouse.move(start[0] + across * step / 8, start[1] + down * step / 8)
        page.wait_for_timeout(40)


def length(page: Any) -> float:
    return float(field(page, "tube.length").input_value())


def test_a_membrane_that_is_dragged_takes_the_array_along_in_one_step(page: Any) -> None:
    start = found(page, "membrane 6")
    drag(page, start, 60)
    until(page, "document.getElementById('drag-note').textContent.startsWith('tube.length = ')")
    assert length(page) > 12.5
    page.mouse.move(start[0] - 900, start[1])
    until(page, "document.querySelector('#drag-note.refused')")
    assert "the two walls it passes through" in page.locator("#drag-note").inner_text()
    assert length(page) == 4.01  # the nearest that is allowed
    page.mouse.up()
    until(page, DRAWN)
    page.click("#undo")
    until(page, "document.querySelector(`[data-name='tube.length'] .value`).value === '12.5'")
    assert page.locator("#undo").is_disabled()
    assert page.locator("#unsaved").is_hidden()


def test_escape_takes_a_drag_back(page: Any) -> None:
    drag(page, found(page, "membrane 6"), 60)
    until(page, "document.querySelector(`[data-name='tube.length'] .value`).value !== '12.5'")
    page.keyboard.press("Escape")
    until(page, "document.querySelector(`[data-name='tube.length'] .value`).value === '12.5'")
    page.mouse.up()


def test_a_microphone_is_dragged_to_another_side(page: Any) -> None:
    drag(page, found(page, "package A"), 30, -260)
    until(page, "document.querySelector(`[data-name='layout.microphone_side'] .value`).value === 'back'")
    page.mouse.up()
    until(page, DRAWN)


def test_parts_that_are_held_are_turned_with_the_array(page: Any) -> None:
    start = found(page, "membrane 6")
    page.evaluate("document.querySelector('.stage .pop').open = true")
    page.uncheck("#movable")
    page.evaluate("document.querySelector('.stage .pop').open = false")
    drag(page, start, 60)
    page.mouse.up()
    page.wait_for_timeout(300)
    assert page.evaluate(f"{ROOT}.revision") == "0"
    page.evaluate("document.querySelector('.stage .pop').open = true")
    page.check("#movable")
    page.evaluate("document.querySelector('.stage .pop').open = false")
    turned = found(page, "membrane 6")
    assert abs(turned[0] - start[0]) + abs(turned[1] - start[1]) > 10


def test_a_size_is_typed_on_its_dimension_line(page: Any) -> None:
    shown(page, "model")
    page.check("#dimensions")
    sizes = {each: page.locator(f"[data-size='{each}']") for each in ("x", "y", "z", "pitch")}
    shown_sizes = {each: box.input_value() for each, box in sizes.items()}
    assert shown_sizes == {"x": "117.3", "y": "28.5", "z": "4.53", "pitch": "18.5"}
    sizes["pitch"].fill("20")
    sizes["pitch"].press("Enter")
    until(page, f"{ROOT}.revision === '1' && {DRAWN}")
    assert length(page) == 14
    until(page, "document.querySelector(`[data-size='x']`).value === '124.8'")
    sizes["x"].fill("20")
    sizes["x"].press("Enter")
    until(page, "document.getElementById('size-refusal').textContent.includes('the two walls')")
    page.locator("#size-refusal button").click()
    until(page, f"{ROOT}.revision === '2' && {DRAWN}")
    assert length(page) == pytest.approx(4.01, abs=0.001)
    assert page.locator("#size-refusal").inner_text() == ""


@pytest.mark.parametrize("zoom", ["+", "-"])
def test_dimensions_keep_their_size_and_stay_in_the_picture(page: Any, zoom: str) -> None:
    shown(page, "model")
    page.check("#dimensions")
    page.locator("#space canvas").focus()
    for _ in range(8):
        page.keyboard.press(zoom)
    page.wait_for_timeout(300)
    frame = page.locator("#space").bounding_box()
    for box in page.locator("[data-size]").all():
        place = box.bounding_box()
        assert (round(place["width"]), round(place["height"])) == (54, 20)
        assert frame["x"] <= place["x"] <= frame["x"] + frame["width"] - place["width"]
        assert frame["y"] <= place["y"] <= frame["y"] + frame["height"] - place["height"]


def test_an_array_on_a_cylinder_is_dragged_and_measured(browser: Any, running: Studio) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    page.set_input_files("#open", "docs/examples/wristband-10.toml")
    until(page, f"{ROOT}.revision === '1'")
    page.check("#dimensions")
    before = length(page)
    shown(page, "model")
    drag(page, found(page, "membrane 5"), 0, 30)
    until(page, f"{ROOT}.revision !== '1'")
    assert length(page) != before
    page.mouse.up()
    until(page, DRAWN)
    assert page.problems == []
    context.close()


def test_a_part_is_named_where_it_is_before_the_array_is_drawn(page: Any) -> None:
    """A busy browser draws long after the array is turned, and the pointer may be earlier."""
    found(page, "membrane 6")
    page.evaluate("window.late = []; window.requestAnimationFrame = (draw) => window.late.push(draw); null")
    page.locator("#space canvas").focus()
    page.keyboard.press("ArrowLeft")
    before = place_of(page, "membrane 6")
    assert page.evaluate("window.late.splice(0).map((draw) => draw(0)).length") > 0
    assert place_of(page, "membrane 6") == before
