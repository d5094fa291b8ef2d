"""Whole kits: complete, sliced by a foreign slicer, printed without a cut, read by a screen reader's rules."""

from __future__ import annotations

import base64
import csv
import html
import json
import re
import shutil
import zipfile
from collections import Counter
from collections.abc import Iterator
from html.parser import HTMLParser
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from prusa_slicer import FINEST, slice_file

import studies
from acoustic_fem.calibration import read_manifest
from geometry.formats.three_mf import read_3mf
from geometry.layout import cutting_list
from geometry.molds import molds_of
from geometry.schema.print_processes import process_of
from geometry.solids.membrane import build_membrane
from studies.kit import JOBS
from studies.kit.jobs import BUILD, BUY, CAST, CUT, PRINT

#: Designs of which whole kits are made: prototypes, and an example.
DESIGNS = ("array-2x6", "fingertip-4x6", "glove", "large-area-64", "docs/examples/wristband-16.toml")
#: Inside of a printed page, mm: paper less the margins of the page.
INSIDE = {"A4": (210 - 26, 297 - 28), "Letter": (215.9 - 26, 279.4 - 28)}
#: Pixels of CSS a millimetre.
PIXELS = 96 / 25.4
#: Files of every kit.
FILES = {
    BUY: ("order-list.csv", "order-tubes.txt", "costs.csv", "work-hours.csv", "bill.csv", "bill.json", "bill.txt"),
    PRINT: ("plate-1-molds.3mf", "print-report.html", "print-report.json", "parts/mold-base.stl"),
    CAST: ("mold-section.png", "mold-open.png", "casting.txt", "casting.csv", "reference/membrane.stl"),
    CUT: ("cutting-list.csv", "cutting-template.dxf", "cutting-template-a4.pdf", "cutting-template-letter.pdf"),
    BUILD: (
        *("manual.html", "assembly.txt", "assembly.csv", "assembly.step", "array.glb", "array.html", "top-view.png"),
        *("exploded-view.png", "record.toml", "calibration.toml", "design.toml", "reference/microphone-board.stl"),
    ),
}

pytestmark = [pytest.mark.slow]


@pytest.fixture(scope="module", params=DESIGNS, ids=lambda name: Path(name).stem)
def kit(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> studies.MadeParts:
    folder = tmp_path_factory.mktemp("kit") / "parts"
    return studies.export_parts(request.param, folder, formats=("stl",))


class _Reader(HTMLParser):
    """Texts of a page, and everything that it would load."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.loads: list[str] = []
        self.anchors: set[str] = set()
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if name in ("src", "href") and value and not value.startswith(("data:", "#")):
                self.loads.append(value)
            if name == "id" and value:
                self.anchors.add(value)

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def test_the_folder_has_the_five_jobs_and_all_their_files(kit: studies.MadeParts) -> None:
    folders = sorted(path.name for path in kit.folder.iterdir() if path.is_dir())
    assert tuple(folders) == JOBS  # names sort in the order of work
    for job, names in FILES.items():
        for name in names:
            assert (kit.folder / job / name).stat().st_size > 40, f"{job}/{name}"
    plates = [path.stem for path in (kit.folder / PRINT).glob("plate-*.3mf")]
    assert any(not stem.endswith("-molds") for stem in plates)  # of large molds there are two plates
    first = (kit.folder / "READ-ME-FIRST.txt").read_text(encoding="utf-8")
    assert [line.split()[0] for line in first.splitlines()[4:9]] == list(JOBS)
    assert "acoustic-fem solve 5-build/design.toml" in first
    listed = (kit.folder / "files.txt").read_text(encoding="utf-8").split()
    written = {path.relative_to(kit.folder).as_posix() for path in kit.folder.rglob("*") if path.is_file()}
    assert set(listed) == written
    printed = {path.stem for path in (kit.folder / PRINT / "parts").iterdir()}
    assert not printed & {"membrane", "microphone-board"}  # what is not printed does not lie among what is
    assert kit.manual == kit.folder / BUILD / "manual.html"


def test_the_plates_hold_every_printed_part_as_often_as_it_is_needed(kit: studies.MadeParts) -> None:
    counts: dict[str, int] = {}
    for path in sorted((kit.folder / PRINT).glob("plate-*.3mf")):
        names = read_3mf(path)
        assert all(name.startswith("mold-") for name in names) == path.stem.endswith("-molds")
        with zipfile.ZipFile(path) as archive:
            model = archive.read("3D/3dmodel.model").decode("utf-8")
        for item in re.findall(r"<item objectid=\"(\d+)\"", model):
            name = re.search(rf'<object id="{item}"[^>]* name="([^"]+)"', model)
            assert name is not None
            counts[name[1]] = counts.get(name[1], 0) + 1
    needed = {file.part: file.count for file in kit.files if file.path.parts[-3] == PRINT and file.count}
    spare = {name: counts[name] - count for name, count in needed.items() if name not in kit.too_large}
    assert set(counts) == set(spare)
    assert all(number >= 0 for number in spare.values())
    assert not any(number for name, number in spare.items() if name.startswith("mold-"))
    page = kit.manual.read_text(encoding="utf-8")
    assert all(f"{number} x {name}" in page for name, number in spare.items() if number)


def test_the_manual_opens_offline_and_its_links_lead_somewhere(kit: studies.MadeParts) -> None:
    page = kit.manual.read_text(encoding="utf-8")
    read = _Reader(page)
    assert read.loads == []
    assert "http-equiv" not in page
    assert "@import" not in page
    assert set(re.findall(r'href="#([^"]+)"', page)) <= read.anchors
    steps = re.findall(r'<section class="step" id="step-(\d+)">(.*?)</section>', page, re.DOTALL)
    assert [int(number) for number, _ in steps] == list(range(1, 15))
    for number, text in steps:
        assert text.count("<figure>") == 1, number  # one picture a step
        assert 'type="checkbox"' in text
        assert "Tools and materials:" in text
    for picture in re.findall(r"data:image/png;base64,([A-Za-z0-9+/=]+)", page):
        image = Image.open(BytesIO(base64.b64decode(picture)))
        assert np.asarray(image.convert("L")).std() > 5  # something is drawn


def test_the_folder_answers_the_questions_of_a_maker(kit: studies.MadeParts) -> None:
    """Answers are read from the page, and compared with the design by calls that the page does not use."""
    page = kit.manual.read_text(encoding="utf-8")
    rows = re.findall(r'<th scope="row">([^<]+\?)</th><td>(.*?)</td><td class="n"><a href="#([\w-]+)"', page)
    answers = {html.unescape(question): html.unescape(answer) for question, answer, _ in rows}
    assert len(rows) == len(answers) == 33
    assert all(len(answer) > 3 for answer in answers.values())
    design = kit.design
    cuts = cutting_list(design)
    length = answers["Which length do I cut?"]
    assert all(f"{cut.cut_length:g} mm" in length for cut in cuts)
    assert sum(map(int, re.findall(r"(\d+) x (?:sheath|spring)", length))) == 2 * sum(cut.count for cut in cuts)
    first = page.partition('id="step-1"')[2].partition("</section>")[0]
    for plate in (kit.folder / PRINT).glob("plate-*-molds.3mf"):  # all are cast with, so all come before the array
        assert plate.name in answers["What do I print first?"]
        assert f"<code>{plate.name}</code>" in first
    bill = {item.item: item for item in kit.bill.items}
    for joint in ("tube", "membrane", "board"):
        part = bill[f"glue of {joint} joints"].part if f"glue of {joint} joints" in bill else None
        name = {"tube": "tubes", "membrane": "membranes", "board": "microphone boards"}[joint]
        assert part is None or part.name in answers[f"Which glue for the {name}?"]
    volume = sum(item.quantity for item in kit.bill.items if item.use == "cast")
    casts = answers["How many casts?"]
    mixed = [float(value) for value in re.findall(r"([\d.e-]+) ml", answers["How much silicone do I mix?"])]
    numbers = [int(value) for value in re.findall(r"(\d+) of membrane", casts)]
    poured = sum(a * b for a, b in zip(mixed, numbers, strict=True))
    assert "5 g" in answers["How much silicone do I mix?"] or min(mixed) > 4
    assert poured >= 0.9 * volume  # cavities in excess of the points are poured too
    assert "glued points up" in answers["Which way up does the membrane lie in the mold?"]
    assert design.microphone.model.upper() in answers["Where does pin 2 go?"].upper()
    assert f"{kit.order.hours:.1f} h of work" in answers["How long does it take?"]
    assert f"{design.membrane.thickness:g} mm" in answers["How thick must a membrane be?"]


def test_the_silicone_of_a_cast_adds_up(kit: studies.MadeParts) -> None:
    rows = list(csv.DictReader((kit.folder / CAST / "casting.csv").open(encoding="utf-8")))
    molds = molds_of(kit.design)
    assert [row["membrane"] for row in rows] == list(molds)
    words = (kit.folder / CAST / "casting.txt").read_text(encoding="utf-8")
    page = kit.manual.read_text(encoding="utf-8")
    for row, alike in zip(rows, molds.values(), strict=True):
        own = build_membrane(alike).val().Volume() / 1000
        in_cavities, over, left, mixed = (
            float(row[f"{name}_ml"]) for name in ("in_cavities", "overflow", "in_cup", "mixed")
        )
        assert in_cavities == pytest.approx(int(row["cavities"]) * own / 0.999**3, rel=1e-3)
        assert in_cavities + over + left == pytest.approx(mixed, rel=1e-3)
        assert left > 0.1 * mixed
        assert int(row["casts"]) * int(row["cavities"]) >= int(row["needed"])
        kept = int(row["needed"]) * own / (int(row["casts"]) * float(row["batch_ml"]))
        assert float(row["wasted"]) == pytest.approx(1 - kept, abs=1e-3)
        assert f"{float(row['mixed_ml']):.3g} ml" in words
        assert f"Mix {float(row['batch_g']):.3g} g ({float(row['batch_ml']):.3g} ml)" in words
        assert float(row["batch_g"]) >= float(row["mixed_g"])
        assert int(row["spare"]) == int(row["casts"]) * int(row["cavities"]) - int(row["needed"])
        assert f"{float(row['opening_force_n']):.0f} N at most" in page


def test_what_calibrate_reads_back_lies_in_the_kit(kit: studies.MadeParts) -> None:
    manifest = read_manifest(kit.folder / BUILD / "calibration.toml")
    assert manifest.design.completed() == kit.design.completed()
    assert manifest.record is not None
    assert not manifest.record.says_something


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        pytest.skip("there is no chromium; Debian: apt install chromium")
    api = pytest.importorskip("playwright.sync_api")
    with api.sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.mark.end_to_end
def test_no_table_or_step_is_cut_and_no_heading_stands_alone(kit: studies.MadeParts, browser: Any) -> None:
    """Blocks that must not break fit on a page each, so that Chromium never has to break one; headings take the block
    that follows with them.
    """
    for paper, (width, height) in INSIDE.items():
        page = browser.new_page(viewport={"width": int(width * PIXELS), "height": int(height * PIXELS)})
        page.emulate_media(media="print")
        page.goto(kit.manual.as_uri())
        heights = page.evaluate(
            """() => [...document.querySelectorAll("table, section.step, figure, .keep")].map(
                block => [block.tagName, block.getBoundingClientRect().height])"""
        )
        together = page.evaluate(
            """() => [...document.querySelectorAll("h2")].map(heading => {
                let last = heading.nextElementSibling;
                while (["P", "UL"].includes(last.tagName) && last.nextElementSibling) last = last.nextElementSibling;
                return [heading.textContent, last.getBoundingClientRect().bottom - heading.getBoundingClientRect().top];
            })"""
        )
        for name, size in [*heights, *together]:
            assert size <= height * PIXELS, f"{paper}: {name} is {size / PIXELS:.0f} mm high"
        assert page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth") <= 0
        printed = page.pdf(format=paper, print_background=True)
        assert len(re.findall(rb"/Type /Page\b", printed)) >= 12
        page.close()


@pytest.mark.end_to_end
def test_axe_finds_nothing_serious_in_the_manual(kit: studies.MadeParts, browser: Any) -> None:
    pytest.importorskip("axe_playwright_python")
    for width, colours in ((1280, "light"), (390, "dark")):
        context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=colours, offline=True)
        page = context.new_page()
        errors: list[str] = []
        page.on("console", lambda message, errors=errors: errors.append(message.text))
        page.goto(kit.manual.as_uri())
        page.evaluate(files("axe_playwright_python").joinpath("axe.min.js").read_text("utf-8"))
        found = page.evaluate("axe.run()")["violations"]
        serious = [
            f"{each['id']}: {each['nodes'][0]['target']}" for each in found if each["impact"] in ("serious", "critical")
        ]
        assert serious == []
        assert errors == []
        wider = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
        assert wider <= 0, f"{wider} px wider than a window of {width} px"
        context.close()


def test_prusaslicer_slices_every_plate_without_error_repair_or_empty_layer(
    kit: studies.MadeParts, tmp_path: Path
) -> None:
    """The plates are closed bodies without an edge to repair, which the slicer would tell."""
    process = process_of(kit.design.printing)
    report = json.loads((kit.folder / PRINT / "print-report.json").read_text(encoding="utf-8"))
    assert report["process"]["name"] == process.name
    islands = {found["part"]: found["value"] for found in report["findings"] if found["rule"] == "islands"}
    for plate in sorted((kit.folder / PRINT).glob("plate-*.3mf")):
        sliced = slice_file(plate, process, tmp_path)
        for word in ("error", "repair", "warning", "empty layer", "outside", "not manifold"):
            assert word not in sliced.said, f"{plate.name}: {word}"
        assert (sliced.lit > 0).all(), plate.name
        top = max(float(body.vertices[:, 2].max()) for body in _bodies(plate))
        assert abs(len(sliced.lit) * process.layer - top) < 1.5 * process.layer
        copies = Counter(_names(plate))
        assert copies.keys() <= islands.keys()
        if process.pixel >= FINEST:  # pictures of finer machines are coarsened
            assert sliced.islands == sum(islands[name] * count for name, count in copies.items())


def _names(plate: Path) -> list[str]:
    """Name of the part of each copy that lies on a plate."""
    import trimesh

    scene = trimesh.load_scene(plate)
    return [scene.graph[node][1] for node in scene.graph.nodes_geometry]


def _bodies(plate: Path) -> list[Any]:
    import trimesh

    return [trimesh.load_scene(plate).to_geometry()]
