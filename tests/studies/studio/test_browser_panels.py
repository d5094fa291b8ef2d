"""Panels of the studio's page in a real browser: their figures are those of Python, and what they hand out opens."""

from __future__ import annotations

import csv
import re
from collections import Counter
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np
import pytest
import sofar
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
    until,
    until_lit,
)
from scipy.io import wavfile

import acoustic_fem
from geometry import prototype, save_design
from geometry.layout.arrangement import lay_out
from geometry.layout.size import array_size
from studies.comparison import differing_fields, figure_words
from studies.panels.cad_panel import check_figures, model_of_array
from studies.panels.curves import CURVES, curves_of, quick_library
from studies.panels.exploring import run_study, study_figures
from studies.panels.pinned_panel import figure_rows
from studies.panels.points import as_built_figures, point_figures
from studies.panels.touching import simulate_touch
from studies.study import METRICS, load_study

pytestmark = pytest.mark.slow
#: Four points: their parts are drawn and checked in a few seconds.
ARRAY = prototype("array-2x6").with_values({"lines": [{"between": ["A", "B"], "points": 4}], "layout.columns": 2})
#: Two points: the whole chain, with its localizer, takes half a minute.
PAIR = ARRAY.with_values({"lines": [{"between": ["A", "B"], "points": 2}]})
LONGER = ARRAY.with_values({"tube.length": 14.0})
#: Units as the page writes them, where it writes them otherwise.
SHOWN_UNITS = {"um": "µm", "mm^2": "mm²", "mm^3": "mm³", "1": ""}
#: Gathers what the page says of its link, whenever it is lost.
LOSSES = """() => {
  const said = document.getElementById("lost");
  window.losses = [];
  const watch = () => { if (said.textContent) window.losses.push(said.textContent); };
  new MutationObserver(watch).observe(said, { childList: true });
}"""


def table(page: Any, button: str, folder: Path) -> list[list[str]]:
    """The CSV file of a panel, without its first row."""
    path = downloaded(page, lambda: page.click(button), folder)
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.reader(file))[1:]


def numbers(text: str) -> list[float]:
    """Numbers in a text of the page."""
    plain = text.replace("\N{MINUS SIGN}", "-")
    return [float(word) for word in plain.split() if word.replace(".", "", 1).lstrip("-").isdecimal()]


def first_number(text: str) -> float:
    """The number that a text begins with."""
    return float(text.split()[0].strip(",").replace("\N{MINUS SIGN}", "-"))


def test_all_figures_of_the_page_are_those_of_python(browser: Any, running: Studio, tmp_path: Path) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    save_design(ARRAY, tmp_path / "small.toml")
    page.set_input_files("#open", tmp_path / "small.toml")
    until(page, f"{ROOT}.revision === '1'")
    page.click("#pin")
    give(page, "tube.length", "14")
    until(page, f"{ROOT}.revision === '2'")
    shown(page, "points", "as_built", "model", "check")
    panel(page, "sound")

    transfer = quick_library(LONGER)[0].transfer_function
    for quantity, title in CURVES.items():
        page.select_option("#quantity", quantity)
        until(page, f"document.querySelector('#plots figcaption').textContent.startsWith({title!r})")
        found = np.array(table(page, "#curves-csv", tmp_path), float)
        expected = curves_of(transfer, quantity)
        np.testing.assert_allclose(found[:, 0], expected.frequency, rtol=1e-6)
        curves = found[:, 1:].T.reshape(expected.values.shape)
        np.testing.assert_allclose(curves, expected.values, rtol=2e-6, atol=1e-4)
        plot = page.locator("#plots .u-over").nth(0)
        low, high = expected.values.min(), expected.values.max()
        room = max((high - low) * 0.05, 0.1)
        box = plot.bounding_box()
        down = box["height"] * (high + room - expected.values[1, 0, -1]) / (high - low + 2 * room)
        plot.hover(position={"x": box["width"] - 1, "y": min(max(down, 1), box["height"] - 1)})
        point, name, value = re.fullmatch(
            r"point (\d+) at ([^:]+): (\S+) \S+ at 100 Hz", page.locator("#pointed-curve").inner_text()
        ).groups()
        own = expected.values[int(point) - 1, expected.heard_by.index(name), -1]
        assert first_number(value) == pytest.approx(own, rel=1e-3, abs=1e-3)

    here, there = point_figures(LONGER), point_figures(ARRAY)
    keys = ("number", "named", "nearest", "distance", "level", "phase", "force", "loudest", "coverage")
    rows = [
        [*(point[key] for key in keys), *counts]
        for point, counts in zip(here["points"], here["confusion"], strict=True)
    ]
    np.testing.assert_allclose(np.array(table(page, "#points-csv", tmp_path), float), rows, rtol=1e-12)
    words = figure_words()
    for name, value in here["figures"].items():
        text = page.locator(f"#figures [data-figure='{name}'] dd").inner_text()
        written, unit = figure_of(text)
        assert written == pytest.approx(value, rel=1e-3)
        assert unit == SHOWN_UNITS.get(words[name]["unit"], words[name]["unit"])
    panel(page, "study")
    rows = figure_rows(here["figures"], there["figures"])
    assert {row["name"] for row in rows} == here["figures"].keys()
    for row in rows:
        cells = page.locator(f"#compared-figures [data-figure='{row['name']}'] td").all_inner_texts()
        assert cells == [*row["texts"], row["better"]]
    panel(page, "sound")
    hardest = "; ".join(" and ".join(map(str, pair)) for pair in here["hardest"])
    assert page.locator("#hardest").inner_text() == f"Hardest to tell apart: {hardest}."
    for row, point in zip(page.locator("#points-table tbody tr").all(), here["points"], strict=True):
        written = [first_number(cell) for cell in row.locator("td").all_inner_texts()]
        factors = {"named": 100, "force": 1e9}
        own = [factors.get(key, 1) * point[key] for key in keys[:7]]
        assert written == pytest.approx(own, rel=1e-2)
    assert page.locator("#points-table th").last.inner_text() == "smallest detectable force (nN)"
    page.evaluate("document.querySelector('.stage .pop').open = true")
    kinds = Counter(part["kind"] for part in model_of_array(LONGER)["parts"])
    shown_kinds = [int(text.rsplit("(", 1)[1][:-1]) for text in page.locator("#kinds label").all_inner_texts()]
    assert sorted(shown_kinds) == sorted(kinds.values())
    made = as_built_figures(LONGER)
    shares = [made["sensors"], *(100 * each for each in (made["mean"], made["interval"][1], made["worst"]))]
    shares.append(100 * made["multi_sines"])
    assert numbers(page.locator("#as-built").inner_text()) == pytest.approx(shares, rel=1e-2)
    x, y, z = array_size(LONGER, lay_out(LONGER))
    page.check("#dimensions")
    page.evaluate("document.getElementById('exploded').value = 80")
    page.evaluate("document.getElementById('exploded').dispatchEvent(new Event('input'))")
    measured = [float(each) for each in page.locator("#space").get_attribute("data-measured").split()]
    assert sorted(measured) == pytest.approx(sorted([x, y, z]), rel=2e-3)  # of the array, not of its lifted parts
    assert numbers(page.locator("#size").inner_text()) == pytest.approx([max(x, y), min(x, y), z], rel=1e-3)

    panel(page, "study")
    compared = {row[0]: row[2:] for row in table(page, "#compare-csv", tmp_path)}
    for each in differing_fields([ARRAY, LONGER]):
        assert [float(value) for value in compared.pop(each.name)] == list(each.values)
    assert {name: [float(value) for value in row] for name, row in compared.items()} == {
        name: pytest.approx([there["figures"][name], value], rel=1e-12) for name, value in here["figures"].items()
    }

    panel(page, "make")
    check = check_figures(LONGER)
    findings = [(each["part"], each["rule"], each["verdict"]) for each in check["printing"]["findings"]]
    findings += [("model", each["assumption"], "ok" if each["holds"] else "fail") for each in check["validity"]]
    values = [[each["value"], each["limit"]] for each in (*check["printing"]["findings"], *check["validity"])]
    printed = table(page, "#print-csv", tmp_path)
    assert [(row[0], row[1], row[6]) for row in printed] == findings
    np.testing.assert_allclose(np.array([[row[2], row[4]] for row in printed], float), values, rtol=1e-6)

    counts = Counter(each["verdict"] for each in check["printing"]["findings"])
    said = f": {counts['fail']} failed, {counts['warn']} to look at, {counts['ok']} in order."
    assert page.locator("#print-verdict").inner_text().endswith(said)
    for place, verdicts in (("#findings", ("fail", "warn")), ("#in-order", ("ok",))):
        page.evaluate(f"document.querySelector('{place}').closest('details')?.setAttribute('open', '')")
        texts = page.locator(f"{place} .finding").all_inner_texts()
        own = [each for verdict in verdicts for each in check["printing"]["findings"] if each["verdict"] == verdict]
        for text, each in zip(texts, own, strict=True):
            assert text.startswith(f"{each['part']}: {each['rule']} ")
            value, limit = text[len(f"{each['part']}: {each['rule']} ") :].split(f"{each['relation']} ", 1)
            assert first_number(value) == pytest.approx(each["value"], rel=1e-2)
            assert first_number(limit) == pytest.approx(each["limit"], rel=1e-2)

    heard = simulate_touch(LONGER, 3, "tap", 1)
    shown(page, "surface")
    page.locator("#touch-points button").nth(2).click()
    until(page, "document.getElementById('answer').dataset.named")
    (start, end, point, probability, _level) = heard["touches"][0]
    said = page.locator("#answer").inner_text().split("located: ")[1]
    assert said.startswith(f"point {point} from ")
    assert numbers(said.replace("(", " "))[:4] == pytest.approx([point, start, end, 100 * probability], rel=2e-2)
    signals_shown = np.array([row[1:3] for row in table(page, "#touch-csv", tmp_path)], float)
    signals = np.frombuffer(heard["signals"], "<f4").reshape(2, -1)
    np.testing.assert_allclose(signals_shown.T, signals, rtol=1e-6)
    assert page.problems == []
    context.close()


def test_a_study_is_run_and_a_click_on_its_front_loads_that_design(page: Any, tmp_path: Path) -> None:
    panel(page, "study")
    page.select_option("#study-add", "tube.length")
    page.select_option("#study-metrics select >> nth=0", "distance_smallest")
    page.fill("#study-designs", "16")
    page.select_option("#study-limit-add", "cost")
    page.fill("[data-limit='cost'] input", "1000")
    with ZipFile(downloaded(page, lambda: page.click("#study-file"), tmp_path)) as archive:
        archive.extractall(tmp_path)
    study = load_study(tmp_path / "study.toml")
    assert [each.name for each in study.parameters] == ["tube.length"]
    assert study.metrics == ("distance_smallest", "volume", "cost")
    page.click("#study-run")
    until(page, f"{ROOT}.shown_study === '0'")
    rows = table(page, "#study-csv", tmp_path)
    assert len(rows) == 16
    assert page.locator("#study-said").inner_text().endswith("; 16 keep the limits (cost at most 1000 USD).")
    shown(page, "points")
    assert page.locator("#study-front").get_attribute("data-marks") == "this design"
    assert page.locator("#study-front").get_attribute("data-crosses") == "0"
    found = study_figures(run_study(study.base, (tmp_path / "study.toml").read_text()))
    np.testing.assert_allclose([float(row[2]) for row in rows], found["metrics"][0]["values"], rtol=1e-9)
    shares = [float(each.get_attribute("data-share")) for each in page.locator("#study-effects canvas").all()]
    assert shares == pytest.approx([each["share"] for each in found["effects"][0]], rel=1e-9)
    best = page.locator("#study-best tbody tr").all()
    listed = {row[0]: float(row[2]) for row in rows}
    assert [first_number(each.locator("td").nth(1).inner_text()) for each in best] == pytest.approx(
        [listed[each.get_attribute("data-design")] for each in best], rel=1e-3
    )
    assert listed[best[0].get_attribute("data-design")] == max(listed.values())
    responses = [study.base.with_values({"tube.length": float(row[1])}) for row in rows[:3]]
    expected = [
        METRICS["distance_smallest"].of_library(acoustic_fem.solve(each, study.frequency, study.fidelity))
        for each in responses
    ]
    np.testing.assert_allclose([float(row[2]) for row in rows[:3]], expected, rtol=1e-4)
    cloud = page.locator("#study-front")
    cloud.scroll_into_view_if_needed()
    down, along = (int(places[0]) for places in np.nonzero(lit(cloud.screenshot())))
    cloud.click(position={"x": along, "y": down + 4})
    until(page, f"{ROOT}.revision === '1' && {PAINTED}")
    number = page.locator("#name").inner_text().rsplit("-", 1)[1]
    assert [float(row[1]) for row in rows if row[0] == number] == [float(field(page, "tube.length").input_value())]
    page.click("#undo")
    until(page, f"{ROOT}.revision === '2'")
    assert field(page, "tube.length").input_value() == "12.5"


def test_a_study_that_is_stopped_shows_what_it_has_and_goes_on(page: Any) -> None:
    panel(page, "study")
    page.select_option("#study-add", "resonator.cavity_height")
    page.select_option("#study-fidelity", "lumped")
    page.select_option("#study-metrics select >> nth=0", "distance_smallest")
    page.fill("#study-designs", "4096")
    page.click("#study-run")
    until(page, "document.querySelector('[data-status=study]').textContent.includes(' of 4096 cases')")
    page.click("#study-stop")
    until(page, f"{ROOT}.shown_study === '0'")
    done = numbers(page.locator("#study-said").inner_text().split("lumped:")[1])
    assert 0 < done[0] < 4096
    assert "not yet: Run goes on" in page.locator("#study-said").inner_text()
    page.click("#study-run")
    before = until(page, "document.querySelector('[data-status=study]').textContent.match(/[0-9]+ of 4096/)?.[0]")
    assert int(before.split()[0]) > done[0]
    page.click("#study-stop")
    until(page, "document.querySelector('#study-stop').disabled")


def test_what_is_handed_out_opens_and_what_takes_long_is_stopped(page: Any, tmp_path: Path) -> None:
    panel(page, "make")
    sofa = downloaded(page, lambda: page.click("[data-export='library.sofa']"), tmp_path)
    assert sofar.read_sofa(str(sofa), verbose=False).GLOBAL_SOFAConventions == "GeneralTF-E"
    page.click("[data-export='parts.zip']")
    until(page, "document.querySelector('[data-status=export]').textContent.length > 6")
    page.click("#stop-export")
    until(page, "document.querySelector(`[data-problem='export']`).textContent === 'stopped'")
    assert page.locator("#name").inner_text() == "array-2x6"


def test_parts_and_the_report_are_handed_out_whole(browser: Any, running: Studio, tmp_path: Path) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, running)
    save_design(PAIR, tmp_path / "small.toml")
    page.set_input_files("#open", tmp_path / "small.toml")
    until(page, f"{ROOT}.revision === '1'")
    panel(page, "make")
    with ZipFile(downloaded(page, lambda: page.click("[data-export='parts.zip']"), tmp_path, 600)) as archive:
        assert archive.testzip() is None
        names = set(archive.namelist())
        said = archive.read("files.txt").decode()
    made = {"2-print/parts/mold-base.stl", "3-cast/reference/membrane.3mf", "2-print/plate-1-molds.3mf"}
    assert {"1-buy/bill.csv", "5-build/assembly.csv", "5-build/manual.html", *made} <= names
    assert all(Path(name).name in said for name in names if name.endswith((".stl", ".csv")))
    report = downloaded(page, lambda: page.click("[data-export='report.html']"), tmp_path, 900)
    text = report.read_text(encoding="utf-8")
    assert PAIR.name in text
    assert text.rstrip().endswith("</html>")
    assert page.problems == []
    context.close()


def test_a_letter_is_written_and_its_line_is_drawn(page: Any) -> None:
    page.select_option("#prototypes", "fingertip-3x4")
    until(page, f"{ROOT}.revision === '1'")
    panel(page, "touch")
    until(page, f"{ROOT}.shown_surface === '1'")
    before = lit(page.locator("#plan").screenshot()).sum()
    page.select_option("#touch-kind", "letter")
    page.fill("#letter", "l")
    page.click("#write")
    until(page, "document.getElementById('answer').dataset.pictures", 240)
    said = page.locator("#answer").inner_text()
    assert said.startswith("A letter: ")
    assert said.endswith("to recognize the letter, load a recognizer of this array")
    assert lit(page.locator("#plan").screenshot()).sum() > before + 30


def test_a_finding_lights_its_part_and_a_recording_is_replayed(page: Any, tmp_path: Path) -> None:
    touch = simulate_touch(prototype("array-2x6"), 7, "tap", 3)
    heard = np.frombuffer(touch["signals"], "<f4").reshape(len(touch["microphones"]), -1)
    wavfile.write(tmp_path / "touch.wav", 1000, np.ascontiguousarray((heard / 8).T))
    panel(page, "touch")
    (tmp_path / "touches.toml").write_text("full_scale = 8.0\n[[recordings]]\nfile = 'touch.wav'\npoint = 7\n")
    page.set_input_files("#replay", [tmp_path / "touch.wav", tmp_path / "touches.toml"])
    until(page, "document.getElementById('answer').dataset.named")
    named = ",".join(str(each[2]) for each in touch["touches"])
    assert page.locator("#answer").get_attribute("data-named") == named == "7"
    assert page.locator("#full-scale").input_value() == "8"
    assert page.locator("#touch-played").inner_text() == "Plays the recording touch.wav, with a full scale of 8 Pa."
    assert page.locator("#timeline").get_attribute("aria-label").startswith("1 touches located within ")
    page.locator("#timeline").click(position={"x": 5, "y": 5})  # it plays again from there
    until(page, "document.getElementById('answer').dataset.pictures")
    panel(page, "make")
    until(page, f"{ROOT}.shown_check === '0' && {ROOT}.shown_model === '0'")
    page.locator("#findings .finding").first.click()
    until_lit(page.locator("#space canvas"), 100)


def test_a_dropped_and_a_half_open_link_lose_no_change(browser: Any, running: Studio) -> None:
    context = browser.new_context()
    links: list[Any] = []
    silent = False

    def join(link: Any) -> None:
        server = link.connect_to_server()
        links.append(link)
        link.on_message(lambda message: None if silent else server.send(message))
        server.on_message(lambda message: None if silent else link.send(message))

    context.route_web_socket("**/session", join)
    page = opened(context, running)
    page.evaluate(LOSSES)  # one may be over before somebody asks
    give(page, "tube.length", "13")
    until(page, f"{ROOT}.revision === '1'")
    links[-1].close()
    until(page, "window.losses.length")
    assert "The design is kept" in page.evaluate("window.losses[0]")
    until(page, f"document.getElementById('lost').hidden && {ROOT}.revision === '1'")
    before = page.evaluate("window.losses.length")
    silent = True
    give(page, "tube.length", "16")
    until(page, f"window.losses.length > {before}")
    silent = False
    until(page, f"{ROOT}.revision === '2' && {PAINTED}")
    assert field(page, "tube.length").input_value() == "16"
    page.click("#undo")
    until(page, f"{ROOT}.revision === '3'")
    assert field(page, "tube.length").input_value() == "13"
    context.close()
