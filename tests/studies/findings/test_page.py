"""The newcomer's study from the how-to, and the page about it."""

from __future__ import annotations

import json
import re
import shlex
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from geometry import load_design
from studies.cli.app import main
from studies.findings.page import LARGEST_CLOUD, render_sweep
from studies.findings.reporting import best_designs
from studies.findings.result_table import Column, ResultTable, effect, table_of_sweep, with_base_metrics
from studies.sweep.results import open_sweep

pytestmark = pytest.mark.slow  # its 256 designs are computed, judged and drawn

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "first-study.md"


def blocks(kind: str) -> list[str]:
    return re.findall(rf"^```{kind}\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def follow(folder: Path, *words: str) -> None:
    """Run ``acoustic-fem`` with the arguments in the folder."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setattr(sys, "argv", ["acoustic-fem", *words])
        with pytest.raises(SystemExit) as ended:
            main()
    assert not ended.value.code, words


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The how-to, followed to the letter in an empty folder."""
    folder = tmp_path_factory.mktemp("newcomer")
    (study,) = blocks("toml")
    (folder / "first-study.toml").write_text(study, encoding="utf-8")
    for line in "".join(blocks("sh")).splitlines():
        program, *words = shlex.split(line)
        assert program == "acoustic-fem"
        follow(folder, *words)
    return folder


@pytest.fixture(scope="module")
def table(folder: Path) -> ResultTable:
    return with_base_metrics(table_of_sweep(open_sweep(folder / "results.zarr")))


@pytest.fixture(scope="module")
def page(folder: Path) -> str:
    return (folder / "report.html").read_text(encoding="utf-8")


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    data: dict[str, Any] = json.loads(found.group(1))
    return data


def test_the_newcomers_study_has_its_256_designs(table: ResultTable) -> None:
    assert len(table.number) == 256
    assert table.failures == ()
    # a wire and a sheath of the catalogue follow each bore
    assert [column.name for column in table.free] == [
        "tube.inner_diameter", "resonator.cavity_height", "membrane.thickness",
    ]  # fmt: skip


def test_the_newcomers_answer_is_the_papers_rule(table: ResultTable) -> None:
    """Thinner tubes and softer membranes set the points apart, at the price of the loud room."""
    bore, _, thickness = table.free
    distance, loud, _ = table.metrics
    for parameter in (bore, thickness):
        means = effect(parameter, distance).mean
        assert means[0] > 2 * means[-1]
    assert effect(bore, distance).share > 0.2
    assert effect(bore, loud).mean[0] < effect(bore, loud).mean[-1]


def test_the_file_of_a_listed_design_is_that_design(folder: Path, table: ResultTable) -> None:
    design = load_design(folder / "design-0.toml")
    assert design.tube.inner_diameter == table.values(0)["tube.inner_diameter"]
    assert design.membrane.thickness == table.values(0)["membrane.thickness"]


def test_the_page_needs_no_network(page: str) -> None:
    own = re.sub(r"<script>.*?</script>", "", page, count=1, flags=re.DOTALL)  # plotly itself names addresses
    assert not re.search(r"""(src|href)\s*=\s*["'](https?:)?//""", own)
    assert "Plotly" in page
    assert len(page) > 4_000_000  # the plotting program is inside


def test_the_page_holds_the_results(page: str, table: ResultTable) -> None:
    data = data_of(page)
    assert data["cloud"]["number"] == table.number.tolist()
    np.testing.assert_allclose(data["cloud"]["metrics"][0], table.metrics[0].values, rtol=1e-4)
    for name, numbers in data["best"].items():
        column = table.metric(name)
        best = column.values.min() if column.better == "smaller" else column.values.max()
        assert column.values[list(table.number).index(numbers[0])] == best
        assert all(str(number) in data["designs"] for number in numbers)
    assert len(data["maps"]) == 3
    # the smallest distance comes first in the study, and is warned of
    assert data["metrics"][0]["caution"].startswith("Distances of points ignore noise")
    assert (data["leading"], data["metrics"][1]["caution"]) == (1, "")
    assert data["families"][0]["title"] == "the base design"
    assert len(data["families"][0]["level"]) == 12


def test_a_design_file_in_the_page_is_that_of_the_command(folder: Path, page: str, tmp_path: Path) -> None:
    data = data_of(page)
    number, text = next(iter(data["designs"].items()))
    (tmp_path / "from-page.toml").write_text(text, encoding="utf-8")
    words = shlex.split(data["command"].replace("{number}", number))
    words[-1] = str(tmp_path / "from-command.toml")
    follow(folder, *words[1:])
    assert load_design(tmp_path / "from-page.toml") == load_design(tmp_path / "from-command.toml")


def test_text_of_the_user_cannot_become_script(table: ResultTable) -> None:
    vars_of = {**vars(table), "title": "</script><script>alert(1)</script>"}
    page = render_sweep(ResultTable(**vars_of), "acoustic-fem best '</script><b>' {number}")
    assert "<script>alert" not in page
    assert "</script><b>" not in page


def test_of_many_designs_the_best_and_the_fronts_are_drawn(table: ResultTable) -> None:
    count = LARGEST_CLOUD + 500
    rows = np.resize(np.arange(len(table.number)), count)
    random = np.random.default_rng(2)
    metrics = tuple(
        Column(c.name, c.title, c.unit, c.values[rows] * random.uniform(0.9, 1, count), (), c.better)
        for c in table.metrics
    )
    parameters = tuple(Column(c.name, c.title, c.unit, c.values[rows], c.labels) for c in table.parameters)
    many = {**vars(table), "number": np.arange(count), "metrics": metrics, "parameters": parameters}
    large = ResultTable(**many)
    data = data_of(render_sweep(large, "x {number}"))
    drawn = set(data["cloud"]["number"])
    assert len(drawn) == LARGEST_CLOUD
    assert set(large.fronts().tolist()) <= drawn
    assert {number for numbers in data["best"].values() for number in numbers} <= drawn


def test_the_best_designs_are_listed_without_solving_the_base(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("acoustic_fem.solve", lambda *_, **__: pytest.fail("the base is solved for the page alone"))
    assert len(best_designs(folder / "results.zarr", count=3).rows) == 3
