"""Fixtures that tests of the command line share."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from command import Command, Outcome
from small_run import small_design

import geometry
from studies.cli import app


@pytest.fixture
def command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """Runs ``acoustic-fem`` with arguments, in this process."""

    def run(*arguments: object) -> Outcome:
        monkeypatch.setattr(sys, "argv", ["acoustic-fem", *map(str, arguments)])
        monkeypatch.setenv("COLUMNS", "200")  # what is told here, not how it is laid out
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            app.main()
        told = capsys.readouterr()
        return Outcome(int(ended.value.code or 0), told.out, told.err)

    return run


@pytest.fixture
def row(tmp_path: Path) -> Path:
    """A design file of three points in one row."""
    path = tmp_path / "row-3.toml"
    geometry.save_design(small_design(), path)
    return path
