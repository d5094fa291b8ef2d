"""Wrong command lines end in one line that says where help is, with exit code 2."""

from __future__ import annotations

from pathlib import Path

import pytest
from command import Command


@pytest.mark.parametrize(
    ("words", "named", "help"),
    [
        (["solved"], "'solved'", "acoustic-fem --help"),
        (["solve", "array-2x6"], "'--out'", "acoustic-fem solve --help"),
        (["best", "--nope"], "--nope", "acoustic-fem best --help"),
        (["best", "results.zarr", "--", "-1"], "--out", "acoustic-fem best --help"),
        (["check"], "DESIGN", "acoustic-fem check --help"),
        (["check", ""], "DESIGN", "acoustic-fem check --help"),
        (["check", "array-2x6", "--out", ""], "--out", "acoustic-fem check --help"),
        (["solve", "glove", "--out", "a.nc", "--out", "b.nc"], "--out", "acoustic-fem solve --help"),
        (["recalibrate", "a.nc", "", "--out", "c.nc"], "RECORDINGS", "acoustic-fem recalibrate --help"),
    ],
)
def test_a_wrong_command_line_ends_in_one_line(
    words: list[str], named: str, help: str, command: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    line = command(*words).refusal(code=2)
    assert named in line
    assert line.endswith(f"; try {help}")
    assert not list(tmp_path.iterdir())


def test_an_option_that_may_be_given_more_than_once_may(command: Command) -> None:
    told = command("train", "none.nc", "--out", "x", "--stimuli", "taps", "--stimuli", "friction")
    assert told.refusal() == "acoustic-fem: none.nc: no such file"


@pytest.mark.parametrize("words", [[], ["--help"], ["best", "--help"], ["--version"]])
def test_help_and_version_are_no_errors(words: list[str], command: Command) -> None:
    told = command(*words)
    assert (told.code, "acoustic-fem" in told.out, told.err) == (0, True, "")
