"""The verb ``new``: it asks on a terminal, takes what is usual elsewhere, and asks a wrong answer again."""

from __future__ import annotations

import pytest

import geometry
from studies.proposals import proposing
from studies.proposals.design_search import Effort


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    """A search that tries little."""
    monkeypatch.setattr(proposing, "thorough", lambda points: Effort(draws=30, judged=2, near=10, rounds=1))


@pytest.mark.physics
@pytest.mark.slow
def test_the_verb_shows_proposals_and_writes_the_first(command, tmp_path):
    told = command("new", "mine", "--size", "60x30", "--points", 8, "--out", tmp_path / "mine.toml")
    assert told.code == 0, told.err
    assert "most accurate" in told.out
    assert "acoustic-fem check" in told.out
    assert told.err.startswith("search: reading")
    assert geometry.load_design(tmp_path / "mine.toml").point_count == 8


@pytest.mark.physics
def test_the_verb_asks_on_a_terminal_and_a_wrong_answer_is_asked_again(command, tmp_path, monkeypatch):
    answers = iter(["moon", "flat", "40 by 20", "60x30", "0", "8", 2, 7, 2])
    questions = []

    def prompt(words, default, type):
        questions.append(words)
        return type(next(answers))

    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("typer.prompt", prompt)
    told = command("new", "mine", "--out", tmp_path / "mine.toml")
    assert told.code == 0, told.err
    assert "place = 'moon'" in told.err
    assert "size = '40 by 20'" in told.err
    assert [words.split("?")[0] for words in questions] == [
        *["Where does it go (flat, fingertip, wrist, hand)"] * 2, *["Length x width, mm"] * 2,
        *["How many points"] * 2, "How many microphones", *["Design to write (1 to 2)"] * 2,
    ]  # fmt: skip
    design = geometry.load_design(tmp_path / "mine.toml")
    assert (design.point_count, design.target.size) == (8, (60.0, 30.0))


def test_a_wrong_option_ends_the_dialogue_before_the_first_question(command, tmp_path, monkeypatch):
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("typer.prompt", lambda *words, **more: pytest.fail("something was asked"))
    told = command("new", "mine", "--printer", "laser", "--points", "most", "--out", tmp_path / "mine.toml")
    assert "--printer" in told.refusal()


@pytest.mark.parametrize(
    ("words", "option"),
    [(["--size", "30"], "--size"), (["--points", "none"], "--points"), (["--printer", "laser"], "--printer"),
     (["--tubes-below", "x"], "--tubes-below"), (["--target", "elbow"], "--target")],
    ids=str,
)  # fmt: skip
def test_a_wrong_option_is_refused_before_any_search(command, tmp_path, words, option):
    told = command("new", "mine", *words, "--out", tmp_path / "mine.toml")
    assert option in told.refusal()
    assert "search" not in told.err
    assert list(tmp_path.iterdir()) == []
