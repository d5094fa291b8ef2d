"""The verb ``new``: it asks on a terminal, and takes what is usual elsewhere."""

from __future__ import annotations

import itertools

import geometry


def test_the_verb_asks_on_a_terminal_alone(command, tmp_path, monkeypatch):
    told = command("new", "mine", "--out", tmp_path / "a.toml")  # no terminal: nothing is asked
    assert told.code == 0, told.err
    assert "acoustic-fem check" in told.out
    asked = itertools.chain(["wrist", "16", "15", "2", "70"])
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("typer.prompt", lambda question, default, type: type(next(asked)))
    assert command("new", "mine", "--out", tmp_path / "b.toml").code == 0
    design = geometry.load_design(tmp_path / "b.toml")
    assert (design.layout.kind, design.point_count, design.tube.length) == ("cylinder", 16, 10.135)
    assert design.layout.diameter == 70


def test_what_has_no_room_is_refused_with_what_has_and_leaves_no_file(command, tmp_path):
    told = command("new", "mine", "--place", "wrist", "--points", 500, "--out", tmp_path / "mine.toml")
    assert told.code == 1
    assert "points = 500" in told.err
    assert "points = 160" in told.err
    assert list(tmp_path.iterdir()) == []
    told = command("new", "mine", "--place", "wrist", "--points", 160, "--out", tmp_path / "mine.toml")
    assert told.code == 0, told.err
