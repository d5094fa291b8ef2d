"""Tables on narrow terminals: no word is cut, no column is a word wide."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any, cast

import pytest

from geometry.design.design_file import prototype
from studies.cli.check_tables import show_check
from studies.cli.localizers import _show_evaluations
from studies.cli.terminal_tables import show, show_fields, show_findings, table_of
from studies.run.check import check_design


@pytest.fixture(autouse=True)
def _eighty_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


def test_columns_that_do_not_fit_follow_beneath_with_the_first_one_again(capsys: pytest.CaptureFixture[str]) -> None:
    heads = [f"parameter_number_{k} (mm^3)" for k in range(6)]
    table = table_of("design", *heads, numbers=tuple(range(7)))
    table.add_row("17", *map(str, range(100, 106)))
    show(table)
    told = capsys.readouterr().out
    assert max(map(len, told.splitlines())) <= 80
    assert [told.count(word) for word in ("design", "17 ", *(head.split()[0] for head in heads))] == [2, 2] + 6 * [1]
    assert "…" not in told


def test_long_texts_are_broken_between_words_and_go_on_as_far_in(capsys: pytest.CaptureFixture[str]) -> None:
    table = table_of("what is assumed", "value", numbers=(1,))
    table.add_row("a name\n  " + 12 * "meaningful ", "5729 Hz")
    show(table)
    lines = capsys.readouterr().out.splitlines()
    assert [line.split().count("meaningful") for line in lines if "meaningful" in line] == [6, 6]
    assert all(line.startswith("   meaningful") for line in lines if "meaningful" in line)


def test_the_list_of_fields_fits(capsys: pytest.CaptureFixture[str]) -> None:
    show_fields()
    told = capsys.readouterr().out
    assert max(map(len, told.splitlines())) <= 80
    assert "microphone.diaphragm_equivalent_volume" in told
    assert "…" not in told


def test_into_a_file_lines_are_not_broken_to_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("COLUMNS")
    table = table_of("prototype", "description")
    table.add_row("a", 40 * "meaningful ")
    show(table)
    assert "a           " + 39 * "meaningful " + "meaningful" in capsys.readouterr().out


def test_a_check_fits_and_says_of_a_wiring_what_its_figures_compare_with(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("studies.run.check.is_installed", lambda extra: False)  # drawing the parts takes seconds
    found = check_design(prototype("array-2x6"))
    show_check(found, full=True)
    told = capsys.readouterr().out
    assert max(len(line) for line in told.splitlines() if "pip install" not in line) <= 80
    assert " ".join(told.split()).count("navier-stokes, the default about") == 1
    assert re.search(r"microphones joined by 1 line +2\b", told)
    assert re.search(r"compared with one microphone per point +6 times", told)
    show_check(found)
    folded = capsys.readouterr().out
    assert max(len(line) for line in folded.splitlines() if "pip install" not in line) <= 80
    assert "navier-stokes, the default" not in folded
    assert re.search(r"model limits +all 6 kept; nearest: ", folded)
    assert re.search(r"parts to buy +all \d+ in the catalogue", folded)
    assert re.search(r"wiring +12 points on 1 line, 6 points per microphone", folded)
    first = [line.split()[0] for line in folded.splitlines() if line.strip()]
    assert first.index("array-2x6:") < first.index("smallest") < first.index("more,") < first.index("coverage")


def test_tables_of_a_check_are_narrow_in_a_file_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("COLUMNS")
    monkeypatch.setattr("studies.run.check.is_installed", lambda extra: False)
    show_check(check_design(prototype("array-2x6"), quality=False), full=True)
    told = capsys.readouterr().out
    assert "the models assume" in told
    assert max(len(line) for line in told.splitlines() if "pip install" not in line) <= 80


def headline(signals: str, *beside: tuple[str, float | None]) -> Any:
    """A headline as :func:`studies.cli.localizers._show_evaluations` reads it."""
    shares = {"top1": 0.998, "top2": 1.0, "within_one": 1.0}
    others = [(name, SimpleNamespace(**shares, expected_calibration_error=0.1, worst=w)) for name, w in beside]
    error = SimpleNamespace(expected_error=0.001)
    return SimpleNamespace(
        signals=signals, hardest_pair=(3, 14, 0.0123), **shares, reliability=error, beside=others, unscattered="",
        worst=0.86,
    )  # fmt: skip


def test_an_evaluation_has_a_row_for_each_kind_of_touches(capsys: pytest.CaptureFixture[str]) -> None:
    beside = ("multi-sine, 20 as-built sensors", 0.77), ("multi-sine, nominal sensor", None)
    first = "taps and presses, as built"
    _show_evaluations({name: headline(first, *beside) for name in ("network", "decoder")})
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert max(map(len, lines)) <= 80
    figures = ["99.8", "100.0", "100.0"]
    remarks = "most confused: 3 and 14, 1.2 %", "the worst sensor: 86.0 % correct", "the worst sensor: 77.0 % correct"
    for words in ("network", "decoder", *remarks):
        assert words in lines
    for words, error in ((first, "0.1"), *((name, "10.0") for name, _ in beside)):
        rows = [line.removeprefix(words).split() for line in lines if line.startswith(words)]
        assert rows == 2 * [[*figures, error]]


def test_a_print_rule_has_its_figures_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    finding = SimpleNamespace(
        part="shell-corner-237.1-0.18x0.55-0.44x0.8", rule="narrowest hole", value=0.18, unit="mm",
        relation="at least", limit=0.2, place=(0.9, 0.0, 0.65), verdict="warn",
    )  # fmt: skip
    show_findings(cast(Any, SimpleNamespace(process=SimpleNamespace(title="SLA"), verdict="warn", problems=[finding])))
    lines = [line.strip() for line in capsys.readouterr().out.splitlines()]
    assert "shell-corner-237.1-0.18x0.55-0.44x0.8   0.18 mm   at least 0.2 mm   warn" in lines
    assert "narrowest hole at 0.9, 0, 0.65" in lines
