"""The verb that lists the catalogue, and a user's own parts for one verb alone."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

from geometry import Refusal, prototype, save_design
from geometry.stock import KINDS, VARIABLE, catalogue
from studies.cli.app import app

OWN = """
replace = ["spring"]

[[spring]]
maker = "drawer"
part_number = "three"
outer_diameter = 0.55
wire_diameter = 0.07
price = 12.0
price_date = "2026"
source = "measured"
"""


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delenv(VARIABLE, raising=False)
    return lambda *words: CliRunner().invoke(app, [*words])


def test_the_catalogue_is_listed_by_kind_with_makers_and_sources(run) -> None:
    told = run("stock", "microphone")
    assert told.exit_code == 0
    for part in catalogue().listed("microphone"):
        assert part.part_number in told.output
        assert part.maker in told.output
    assert len(run("stock").output.splitlines()) > len(catalogue().parts)


def test_an_unknown_kind_is_refused_with_those_that_there_are(run) -> None:
    told = run("stock", "rope")
    assert told.exit_code == 1
    assert isinstance(told.exception, Refusal)
    assert (told.exception.field, told.exception.value) == ("kind", "rope")
    assert told.exception.allowed == KINDS


def test_the_parts_of_a_design_are_listed_and_what_nobody_sells(run, tmp_path: Path) -> None:
    told = run("stock", "--design", "fingertip-3x4", "--out", str(tmp_path / "fit.json"))
    assert told.exit_code == 0
    assert "made to order" in told.output
    content = json.loads((tmp_path / "fit.json").read_text(encoding="utf-8"))
    assert content == catalogue().fit("fingertip-3x4").to_dict()
    assert "made to order" not in run("stock", "--design", "array-2x6").output


@pytest.mark.slow
def test_own_parts_are_those_of_the_option_or_of_the_file_beside_the_design(run, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    for place in (tmp_path / "stock.toml", tmp_path / "mine" / "parts.toml"):
        place.write_text(OWN, encoding="utf-8")
    save_design(prototype("array-2x6"), tmp_path / "pad.toml")
    for words in (
        ("stock", "spring", "--stock", str(tmp_path / "mine")),
        ("stock", "--design", str(tmp_path / "pad.toml")),
        ("check", str(tmp_path / "pad.toml"), "--stock", str(tmp_path / "mine" / "parts.toml")),
    ):
        told = run(*words)
        assert "drawer three" in told.output or ("drawer" in told.output and "three" in told.output), told.output
        assert VARIABLE not in os.environ
    assert "drawer" not in run("stock", "spring").output


def test_a_wrong_file_is_refused_by_its_name(run, tmp_path: Path) -> None:
    (tmp_path / "bad.toml").write_text(OWN.replace("0.07", "0.7"), encoding="utf-8")
    told = run("stock", "--stock", str(tmp_path / "bad.toml"))
    assert told.exit_code == 1
    assert isinstance(told.exception, Refusal)
    assert Path(str(told.exception.file)) == tmp_path / "bad.toml"
    assert told.exception.field == "spring.0.outer_diameter"
