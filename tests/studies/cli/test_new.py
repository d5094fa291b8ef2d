"""The verb ``new``: it asks on a terminal, and takes what is usual elsewhere."""

from __future__ import annotations

import itertools

import geometry


def test_the_verb_asks_on_a_terminal_alone(command, tmp_path, monkeypatch):
    told = command("new", "mine", "--out", tmp_path / "a.toml")  # no terminal: nothing is asked
    assert told.code == 0, told.err
    assert "acoustic-fem check" in told.out
    asked = itertools.chain(["wrist", "16", "15", "2"])
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("typer.prompt", lambda question, default, type: type(next(asked)))
    assert command("new", "mine", "--out", tmp_path / "b.toml").code == 0
    design = geometry.load_design(tmp_path / "b.toml")
    assert (design.layout.kind, design.point_count, design.tube.length) == ("cylinder", 16, 10.135)
