"""The verb compare: tables in the order of what a designer asks first, and notes on what is not compared."""

from __future__ import annotations

from pathlib import Path

from command import Command


def test_the_command_prints_fields_figures_and_notes(command: Command, tmp_path: Path) -> None:
    told = command("compare", "array-2x6", "glove", "--no-printing", "--out", tmp_path / "x.html")
    assert told.code == 0, told.err
    lines = told.out.splitlines()
    length = next(line.split() for line in lines if line.strip().startswith("tube.length"))
    assert length == ["tube.length", "12.5", "mm", "15", "mm"]
    assert next(line for line in lines if line.strip().startswith("width")).split()[-1] == "array-2x6"
    assert "glove: transfer functions are not compared" in told.out
    assert lines[-1].strip() == str(tmp_path / "x.html")


def test_files_of_other_kinds_are_refused_in_one_line(command: Command, tmp_path: Path) -> None:
    line = command("compare", "array-2x6", "glove", "--out", tmp_path / "x.png").refusal()
    assert "--out" in line
    assert ".html or .json" in line
    assert "subjects" in command("compare", "array-2x6").refusal()
