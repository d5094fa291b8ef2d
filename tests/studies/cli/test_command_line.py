"""Wrong command lines end in one line that says where help is, with exit code 2."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from studies.cli import app


def ended(words: list[str], monkeypatch: pytest.MonkeyPatch) -> int:
    """Exit code of ``acoustic-fem`` with these words."""
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", *words])
    with pytest.raises(SystemExit) as end:
        app.main()
    return int(end.value.code or 0)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["solved"], "No such command 'solved'. Did you mean 'solve', 'live'?; try acoustic-fem --help"),
        (["solve", "array-2x6"], "Missing option '--out'; try acoustic-fem solve --help"),
        (["best", "--nope"], "No such option: --nope; try acoustic-fem best --help"),
        (
            ["best", "results.zarr", "--", "-1"],
            "--out is missing: its design file, such as design-17.toml; DESIGN must be a number that the list shows, "
            "0 or more, or neither given; try acoustic-fem best --help",
        ),
        (["check"], "give a DESIGN, or --fields; try acoustic-fem check --help"),
        (["check", ""], "DESIGN is empty; try acoustic-fem check --help"),
        (["check", "array-2x6", "--out", ""], "--out is empty; try acoustic-fem check --help"),
        (["solve", "glove", "--out", "a.nc", "--out", "b.nc"], "--out is given twice; try acoustic-fem solve --help"),
        (["recalibrate", "a.nc", "", "--out", "c.nc"], "RECORDINGS is empty; try acoustic-fem recalibrate --help"),
    ],
)  # fmt: skip
def test_a_wrong_command_line_ends_in_one_line(
    words: list[str],
    told: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert ended(words, monkeypatch) == 2
    assert capsys.readouterr() == ("", f"acoustic-fem: {told}\n")
    assert not list(tmp_path.iterdir())


def test_what_may_be_given_more_than_once_may(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["train", "none.nc", "--out", "x", "--stimuli", "taps", "--stimuli", "friction"]
    assert ended(words, monkeypatch) == 1
    assert capsys.readouterr().err == "acoustic-fem: none.nc: no such file\n"


@pytest.mark.parametrize("words", [[], ["--help"], ["best", "--help"], ["--version"]])
def test_help_and_version_are_no_errors(
    words: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert ended(words, monkeypatch) == 0
    told = capsys.readouterr()
    assert ("acoustic-fem" in told.out, told.err) == (True, "")
