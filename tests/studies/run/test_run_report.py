"""The report says what the run found, stands alone, and its figures hold something."""

from __future__ import annotations

import base64
import json
import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
from PIL import Image
from small_run import small_design, small_run

from geometry.printing.print_rules import Finding
from geometry.printing.printability import PrintReport
from localize import BayesDecoder
from localize.signals.array_response import response_of
from localize.signals.noise_model import microphone_noise
from studies.evaluation.headline import HeadlineTouches
from studies.metrics.pairs import Disagreement
from studies.metrics.separation import Separability
from studies.output.report_texts import percent, with_worst
from studies.run.findings import (
    AccuracyRow,
    accuracy_rows,
    agreement_sentence,
    confusion_sentence,
    key_figures,
    noise_sentence,
    printing_sentence,
    summary,
    training_sentence,
)
from studies.run.run_report import render

VOID = {"meta", "img", "br", "link", "input", "hr"}


class Page(HTMLParser):
    """Tags in balance, all addresses, all ids, all text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.addresses: list[str] = []
        self.ids: set[str] = set()
        self.tags: set[str] = set()
        self.words: list[str] = []
        self.scripts: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        for name, value in attrs:
            if name in ("src", "href"):
                self.addresses.append(value or "")
            if name == "id":
                self.ids.add(value or "")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "script" in self.open:
            self.scripts.append(data)
        elif "style" not in self.open:
            self.words.append(data)

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.words).split())


@pytest.fixture(scope="module")
def page() -> Page:
    return Page((small_run().folder / "report.html").read_text(encoding="utf-8"))


def test_the_page_is_well_formed_and_needs_nothing_else(page: Page) -> None:
    assert page.open == []
    assert not page.tags & {"link", "iframe"}
    assert len(page.scripts) == 2  # data, and the script of all reports
    for address in page.addresses:
        assert address.startswith(("data:image/png;base64,", "#"))
        assert not address.startswith("#") or address[1:] in page.ids
    assert "url(" not in (small_run().folder / "report.html").read_text(encoding="utf-8")


def test_the_page_shows_every_figure_of_the_run(page: Page) -> None:
    shown = [base64.b64decode(a.partition(",")[2]) for a in page.addresses if a.startswith("data:")]
    files = [path.read_bytes() for path in small_run().figures.values()]
    assert sorted(shown) == sorted(files)
    assert len(files) == 6  # array, point, transfer functions, differences, separability, confusion


def test_no_figure_is_blank() -> None:
    for name, path in small_run().figures.items():
        pixels = np.asarray(Image.open(path).convert("L"), float)
        assert pixels.shape[1] >= 700, name
        assert pixels.std() > 10, name


def test_the_page_names_the_hardest_pair_first(page: Page) -> None:
    first, second = small_run().separability.hardest_pairs[0]
    assert f"The points that are hardest to tell apart are {first} and {second}" in page.text
    assert page.text.index("hardest to tell apart") < page.text.index("Key figures")


def test_the_page_has_every_part_point_and_cell(page: Page) -> None:
    result = small_run()
    for part in result.part_counts:
        assert part in page.text
    for cell in result.library.provenance["cells"]:
        assert cell["cell"] in page.text
    for item in result.validity:
        assert item.assumption in page.text
    assert "no datasheet figure found" in page.text
    assert "row-3" in page.text
    assert re.search(r"between points of line 1 2 11\.5 11\.5 144 0\.44", page.text)


def test_the_key_figures_are_those_of_the_run() -> None:
    result = small_run()
    found = {figure.name: figure.value for figure in key_figures(result)}
    assert found["points"] == "3"
    assert found["bore"] == "0.44 mm"
    assert found["print verdict"] == result.printing.verdict
    assert found["localizer, top-1"] == with_worst(result.network.top1, result.network.worst)
    weakest = 20 * np.log10(np.abs(result.library.transfer_function.values[0, 1, 99]))
    assert found["weakest signal at 100 Hz"] == f"{weakest:z.1f} dB".replace("-", "−")


ROWS = (
    "taps and presses on 20 as-built sensors",
    "taps on 20 as-built sensors",
    "presses on 20 as-built sensors",
    "taps and presses on 8 virtual rigs",
    "taps and presses on the nominal sensor",
    "multi-sine touches on 20 as-built sensors",
    "multi-sine touches on the nominal sensor",
)


def test_the_headline_is_of_taps_and_presses_as_built_and_a_table_has_the_other_touches(page: Page) -> None:
    result = small_run()
    text, figures = summary(result), {figure.name: figure for figure in key_figures(result)}
    assert text in page.text
    assert f"{percent(result.network.top1)} of held-out {ROWS[0]}" in text
    assert text.count("%") == 1
    assert ROWS[0] in figures["localizer, top-1"].remark
    rows = accuracy_rows(result)
    assert tuple(row.touches for row in rows) == ROWS
    assert result.tolerant is not None
    decoders = (result.network, result.bayes, result.tolerant)
    assert rows[0] == AccuracyRow(ROWS[0], *(with_worst(each.top1, each.worst) for each in decoders))
    for row, *outcomes in zip(rows[1:], *(each.outcomes for each in decoders), strict=True):
        for cell, outcome in zip((row.localizer, row.bayes, row.tolerant), outcomes, strict=True):
            assert cell == with_worst(outcome.top1, outcome.worst)
            assert ("worst" in cell) == ("nominal" not in row.touches)
        assert f"{row.touches} {row.localizer} {row.bayes} {row.tolerant}" in page.text
    assert {row.tolerant for row in accuracy_rows(replace(result, tolerant=None))} == {"not known"}


def test_the_headline_is_the_mean_over_its_sensors_and_over_taps_and_presses() -> None:
    for each in (small_run().network, small_run().bayes):
        assert np.mean([own.top1 for own in each.of_sensors]) == pytest.approx(each.top1)
        assert sum(own.touches for own in each.of_sensors) == each.touches
        assert sum(own.confusion for own in each.of_sensors).tolist() == each.confusion.tolist()
        taps, presses, *_ = each.outcomes
        assert (taps.signals, presses.signals) == ("taps", "presses")
        assert (taps.top1 + presses.top1) / 2 == pytest.approx(each.top1)
        low, high = each.interval()
        assert low < each.top1 < high
    assert small_run().bayes.outcomes[4].top1 > 0.9


def test_a_headline_without_as_built_sensors_is_of_the_nominal_sensor_and_says_why() -> None:
    result = small_run()
    library, box = result.library, small_design().with_values({"resonator.shape": "box"})
    other = replace(library, design=box)
    held_out = HeadlineTouches(other, response_of(library), 20, 1e-3, 0)
    found = held_out.headline(BayesDecoder(library, 1e-3))
    assert [name for name, _ in found.beside] == [
        "taps on the nominal sensor", "presses on the nominal sensor", "multi-sine touches on the nominal sensor"
    ]  # fmt: skip
    assert (found.signals, found.worst, found.touches) == ("taps and presses on the nominal sensor", None, 60)
    told = summary(replace(result, network=found))
    assert f"{percent(found.top1)} of held-out taps and presses on the nominal sensor" in told
    assert f"As-built sensors are left out: {found.unscattered}." in told
    assert "resonator.shape" in found.unscattered


def test_the_touches_of_a_training_are_those_of_its_plan(page: Page) -> None:
    result = small_run()
    sensors = result.training["sensors"]
    assert sensors > 1000
    assert f"on multi-sines, tap-strokes, press-strokes, slide-strokes on {sensors} as-built sensors." in page.text
    plan = {**result.training["plan"], "stimuli": ["multi-sines"]}
    alone = render(replace(result, training={**result.training, "plan": plan, "sensors": 1}))
    assert "This one was trained on multi-sines on the nominal sensor." in alone


def test_a_comparison_outside_the_limits_is_explained() -> None:
    far = Disagreement(0.03, (3, "A", 90.0), 0.4, (1, "B", 100.0))
    text = agreement_sentence(replace(small_run(), disagreement=far))
    assert "3 % in magnitude (point 3, microphone A, 90 Hz)" in text
    assert "outside" in text
    assert "from point 3 to microphone A" in text
    near = Disagreement(0.003, (3, "A", 90.0), 0.4, (1, "B", 100.0))
    assert "Lumped is within them" in agreement_sentence(replace(small_run(), disagreement=near))


def test_what_the_localizer_confuses_is_set_against_the_distances() -> None:
    result = small_run()
    pairs = result.separability.hardest_pairs

    def judged(confusion: np.ndarray) -> str:
        return confusion_sentence(replace(result, network=replace(result.network, confusion=confusion)))

    assert "missed none" in judged(np.diag([100, 100, 100]))
    wrong = np.diag([100, 100, 100])
    i, j = pairs[0]
    wrong[i - 1, j - 1] = 10
    assert f"points {i} and {j}: it assigns 4.8 %" in judged(wrong)
    assert "also the hardest pair by distance" in judged(wrong)
    other = np.diag([100, 100, 100])
    i, j = pairs[-1]
    other[j - 1, i - 1] = 10
    assert "By distance this pair is number 3 of 3" in judged(other)


def test_a_training_cut_short_is_said() -> None:
    result = small_run()
    assert f"{result.training['touches']} touches" in training_sentence(result)
    assert "reached its limit" not in training_sentence(result)
    plan = {**result.training["plan"], "time_limit": 7.0}
    short = replace(result, training={**result.training, "touches": 450, "cut_short": True, "plan": plan})
    assert "450 touches" in training_sentence(short)
    assert "The plan had 540 touches, but the training reached its limit of 7 s." in training_sentence(short)


def test_the_page_says_which_noise_was_used_and_that_its_figures_are_assumed(page: Page) -> None:
    result = small_run()
    rms = microphone_noise(result.design.microphone, result.library.medium).rms
    assert result.network.microphone_noise == result.bayes.microphone_noise == rms
    assert f"the noise of the design's microphone, {rms:.2g} Pa rms over 1 to 500 Hz" in page.text
    assert "Source of the data of SPH1878LR5H-C: no datasheet figure found; all assumed." in page.text
    white = replace(result.network, microphone_noise=1e-3, noise_source="white")
    told = noise_sentence(replace(result, network=white))
    assert "white microphone noise of 0.001 Pa rms over 0 to 500 Hz, not that of the design's microphone" in told


def test_equally_hard_pairs_that_are_not_named_are_counted() -> None:
    result = small_run()
    for count, words in ((2, "(and equally 2 and 3)"), (4, "3 and 4, 4 and 5)"), (7, "4 and 5 and 3 more pairs)")):
        even = np.abs(np.subtract.outer(np.arange(count + 1.0), np.arange(count + 1.0)))
        distances = Separability(tuple(range(1, count + 2)), even, np.zeros_like(even))
        assert len(distances.equally_hard) == count
        assert words in summary(replace(result, separability=distances))
    five = np.abs(np.subtract.outer(np.arange(6.0), np.arange(6.0)))
    told = summary(replace(result, separability=Separability(tuple(range(1, 7)), five, np.zeros_like(five))))
    assert "4 and 5 and 1 more pair)" in told


def test_the_pictures_have_no_wide_margin_and_the_point_is_not_too_tall() -> None:
    for name in ("array", "point"):
        inked = (np.asarray(Image.open(small_run().figures[name]).convert("RGB")) < 255).any(axis=2)
        for axis in (0, 1):
            used = np.flatnonzero(inked.any(axis=axis))
            assert used[0] <= 16, name
            assert inked.shape[1 - axis] - 1 - used[-1] <= 16, name
    assert Image.open(small_run().figures["point"]).height <= 700


def test_figures_are_there_as_data_too(page: Page) -> None:
    result = small_run()
    found = json.loads(page.scripts[0])
    assert set(found) == set(result.figures) - {"array", "point"}
    curves = found["transfer-functions"]
    response = result.library.transfer_function
    inside = (response.frequency >= 1) & (response.frequency <= 100)
    assert curves["frequency"] == pytest.approx(response.frequency[inside].values, rel=1e-4)
    level = 20 * np.log10(np.abs(response.sel(microphone="B").values[:, inside.values]))
    own = next(panel for panel in curves["panels"] if panel["title"] == "microphone B: level")
    np.testing.assert_allclose(own["values"], level, rtol=1e-4, atol=1e-4)
    shares = np.array(found["confusion"]["values"])
    np.testing.assert_allclose(shares.sum(axis=1), 100, rtol=1e-3)
    distance = np.array(found["separability"]["values"], float)
    off = ~np.eye(len(distance), dtype=bool)
    np.testing.assert_allclose(distance[off], result.separability.combined[off], rtol=1e-4)


def test_every_table_with_column_names_has_a_head(page: Page) -> None:
    text = render(small_run())
    for table in text.split("<table")[1:]:
        table = table.split("</table>")[0]
        if "<th" in table:
            assert "<thead>" in table, table[:200]


def test_a_failing_part_is_named_at_the_top() -> None:
    result = small_run()
    finding = Finding("shell-straight", "thinnest wall", 0.1, 0.2, "mm", "fail", "a rule")
    bad = replace(result, printing=PrintReport(result.printing.process, (finding,)))
    assert "cannot be printed" in printing_sentence(bad)
    assert "shell-straight" in summary(bad)
    text = Page(render(bad)).text
    assert "thinnest wall 0.1 0.2 mm fail a rule" in text


def test_names_of_the_user_cannot_break_the_page() -> None:
    result = small_run()
    text = render(replace(result, layout_notes=("<script>alert(1)</script> & more",)))
    assert len(Page(text).scripts) == 2
    assert "&lt;script&gt;" in text
