"""An array that is laid on a body in the studio: its faces are clicked, and the files are those of the command."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from zipfile import ZipFile

import pytest
import trimesh
from browser import ROOT, Studio, downloaded, opened, panel, shown, until

from geometry import load_design, prototype, save_design
from geometry.layout import lay_out
from geometry.layout.overlaps import overlaps

pytestmark = pytest.mark.slow
#: Sides of a block.
SIDES = ((0, 0, 1), (0, 0, -1), (0, -1, 0), (0, 1, 0), (1, 0, 0), (-1, 0, 0))
#: Two points, whose figures take less than those of twelve.
FEW = prototype("fingertip-3x4").with_values({"lines": [{"between": ["A", "B"], "points": 2}], "layout.columns": 2})
#: What the page says after a fit, and why there is none.
SAID = "document.getElementById('fit-said').textContent"
PROBLEM = "document.querySelector('[data-problem=fit]').textContent"


def block(path: Path) -> Path:
    """A block of 30 x 30 x 14 mm whose six sides are painted: read in a tenth of the time of a STEP file."""
    box = trimesh.creation.box((30, 30, 14))
    rows = ["v " + " ".join(map(str, place)) for place in box.vertices.tolist()]
    for number, side in enumerate(SIDES):
        own = box.faces[box.face_normals @ side > 0.9]
        rows += [f"usemtl side-{number}", *("f " + " ".join(map(str, facet + 1)) for facet in own)]
    path.write_text("\n".join(rows), encoding="utf-8")
    return path


def handed_in(page: Any, path: Path) -> None:
    """Choose the file of a body."""
    panel(page, "body")
    page.set_input_files("#body-file", path)
    until(page, f"{ROOT}.body === '{path.name}'", 240)


#: The place nearest to the middle of the picture at which the page names a part, and the name.
_FIRST = """(name) => {
  const sheet = document.querySelector("#space canvas"), frame = sheet.getBoundingClientRect();
  const said = document.getElementById("pointed-part"), steps = [0.5];
  for (let step = 1; step < 15; step++) steps.push(0.5 + 0.03 * step, 0.5 - 0.03 * step);
  for (const down of steps) for (const across of steps) {
    const [clientX, clientY] = [frame.left + across * frame.width, frame.top + down * frame.height].map(Math.round);
    sheet.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY }));
    const text = said.textContent.slice(2);
    if (text.startsWith(name)) return [clientX, clientY, text.split(":")[0]];
  }
  return null;
}"""


def clicked(page: Any, name: str) -> str:
    """Click a face or a part once the picture stands still, because two answers agree; its name."""
    before: Any = None
    for _ in range(100):
        place = page.evaluate(_FIRST, name)
        if place is not None and place == before:
            page.mouse.click(place[0], place[1])
            return str(place[2])
        before = place
        page.wait_for_timeout(100)
    pytest.fail(f"{name} is not found at one place; the last was {before}")


def test_faces_are_chosen_by_clicks_and_the_fit_is_undone_saved_and_opened_again(
    browser: Any, running: Studio, tmp_path: Path
) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    save_design(FEW, tmp_path / "few.toml")
    page.set_input_files("#open", tmp_path / "few.toml")
    until(page, f"{ROOT}.revision === '1'")
    handed_in(page, block(tmp_path / "block.obj"))
    assert page.locator("#body-said").inner_text().startswith("block.obj: 30 × 30 × 14 mm, 6 faces.")
    assert page.locator("#region-said").inner_text() == "The whole body: 100 % of the surface."
    face = clicked(page, "face ").split()[1]  # the upper side
    chosen = "document.getElementById('region-said').dataset.faces === '{}'"
    until(page, chosen.format(face))
    assert page.locator("#region-said").inner_text() == f"Face {face}: 26 % of the surface."  # 900 of 3480 mm^2
    assert clicked(page, "face ") == f"face {face}"  # and left out again
    until(page, chosen.format(""))
    clicked(page, "face ")
    until(page, chosen.format(face))

    page.click("#fit-run")
    assert page.locator("[data-problem=fit]").inner_text() == "Give a pitch, or the number of points."
    page.fill("#fit-pitch", "2")
    page.click("#fit-run")
    until(page, PROBLEM)
    assert "surface.pitch = 2 mm must be at least 2.7 mm" in page.locator("[data-problem=fit]").inner_text()
    page.fill("#fit-pitch", "8")
    page.click("#fit-run")
    assert page.locator("[data-problem=fit]").inner_text() == ""
    page.click("#fit-stop")
    until(page, f"{PROBLEM} === 'stopped'")
    assert page.locator("#fit-run").is_enabled()
    assert page.evaluate(f"{ROOT}.revision") == "1"

    page.click("#fit-run")
    until(page, SAID, 240)
    saved = downloaded(page, lambda: page.click("#fit-save"), tmp_path)
    until(page, "document.getElementById('unsaved').hidden")
    with ZipFile(saved) as packed:
        packed.extractall(tmp_path)
    design = load_design(tmp_path / "fingertip-3x4.toml")
    assert design.surface is not None
    assert design.layout.frozen is not None
    assert design.surface.region.faces == (int(face),)
    assert overlaps(design, lay_out(design)) == ()
    assert page.locator("#fit-findings li").all_inner_texts() == list(design.layout.frozen.findings)
    for part in design.layout.frozen.points:  # on its upper side alone
        assert part.at[2] == pytest.approx(7 + design.surface.base + design.resonator.floor_thickness, abs=0.05)
    page.click("#undo")
    until(page, f"{SAID} === ''")
    page.click("#redo")
    until(page, SAID, 240)

    files = [tmp_path / name for name in ("fingertip-3x4.toml", "fingertip-3x4.places.json", "block.obj")]
    page.set_input_files("#open", files)
    until(page, "document.getElementById('unsaved').hidden")
    assert page.locator("#region-said").inner_text().startswith(f"Face {face}: ")
    shown(page, "surface", "model")
    point = clicked(page, "membrane ").split()[1]
    until(page, "document.getElementById('answer').dataset.named", 240)
    assert page.locator("#answer").inner_text().startswith(f"A tap on point {point}; located: point ")
    assert page.locator("#point").input_value() == point
    page.set_input_files("#open", files[0])
    until(page, f"{SAID} === ''")
    assert "If you have fingertip-3x4.places.json, open both files together." in page.locator("#notice").inner_text()
    assert page.problems == []
    context.close()
