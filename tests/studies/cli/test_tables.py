"""Tables on narrow terminals: no word is cut, no column is a word wide."""

from __future__ import annotations

import pytest

from studies.cli.tables import show, show_fields, table_of


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
    table.add_row("a", 12 * "meaningful ")
    show(table)
    assert "a           " + 11 * "meaningful " + "meaningful" in capsys.readouterr().out
