"""The check of prose: it finds what it is for, and today's pages, docstrings, help and messages pass it."""

from __future__ import annotations

from pathlib import Path

import pytest

from docs import prose

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    "text", ["Left out are two rows.", "It was not told of it.", "Of the sensor only the tube is new."]
)
def test_a_planted_fault_is_found(text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(prose, "ROOT", tmp_path)
    page, module = tmp_path / "page.md", tmp_path / "module.py"
    page.write_text(f"# Page\n\nA good sentence stands here. {text}\n")
    module.write_text(f'"""A module.\n\n{text}\n"""\nproblem = f"the tube of {{name}} mm is too long. {text}"\n')
    assert len(prose.page_faults(page, "Design")) == 1
    assert [fault.place for fault in prose.source_faults(module)] == ["module.py:1", "module.py:5"]


def test_code_links_and_tables_are_not_read_as_sentences() -> None:
    text = "# Of a heading\n\n| Of | a table |\n\n```sh\nOf code.\n```\n\nRead `Of this` on [a page](of-it.md) today.\n"
    assert prose.sentences_of(prose.prose_of(text)) == ["Read CODE on a page today."]


@pytest.mark.parametrize(
    ("figure", "sentence"),
    [
        ("words a sentence", "This sentence goes on " + "and on " * 20 + "because nobody ends it, so it is long."),
        ("numbers", "If 4 of 5 tubes are 3 mm long then 2 are not 3 mm long so they leak."),
        ("connectives", "The tube is long. The bore is wide."),
        ("; and :", "If so: it is long; so it is wide; then it is stiff; but it is light."),
        ("commas", "If so, then, but, since, it is long, wide, stiff, light, and cheap."),
    ],
)
def test_each_limit_of_guides_is_kept_on_long_pages_alone(
    figure: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(prose, "ROOT", tmp_path)
    page = tmp_path / "page.md"
    page.write_text(f"{sentence}\n\n" * 60)
    assert any(figure in fault.says for fault in prose.page_faults(page, "Make"))
    page.write_text(f"{sentence}\n")
    assert prose.page_faults(page, "Make") == []


def test_the_side_bar_says_which_pages_are_guides() -> None:
    groups = prose.groups()
    assert groups[ROOT / "README.md"] in prose.GUIDES
    assert groups[ROOT / "docs/parts.md"] in prose.GUIDES
    assert groups[ROOT / "docs/verification.md"] == "Evidence"


def test_pages_docstrings_help_and_messages_keep_the_limits(capsys: pytest.CaptureFixture[str]) -> None:
    assert prose.main([]) == 0, capsys.readouterr().out
