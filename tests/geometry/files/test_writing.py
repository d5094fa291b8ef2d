"""Files appear whole or not at all, and a section is replaced only where its marks stand."""

from __future__ import annotations

from pathlib import Path

import pytest

from geometry.files.writing import replace_section, whole_file


def test_a_block_that_fails_leaves_the_old_file_and_nothing_beside(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("old")

    def half() -> None:
        with whole_file(path) as beside:
            beside.write_text("half")
            raise RuntimeError("stopped")

    with pytest.raises(RuntimeError, match="stopped"):
        half()
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.txt"]


def test_lines_between_marks_are_replaced_and_nothing_else(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("before <a>\nold\nold\n</a> after </a>\n")
    for lines in (["new"], ["one", "two"]):
        replace_section(page, "<a>", "</a>", lines)
        assert page.read_text() == "before <a>\n" + "\n".join(lines) + "\n</a> after </a>\n"


def test_a_name_may_be_as_long_as_the_system_takes(tmp_path: Path) -> None:
    longest = tmp_path / ("x" * 251 + ".txt")
    with whole_file(longest) as beside:
        beside.write_text("whole")
    assert longest.read_text() == "whole"
    too_long = tmp_path / ("x" * 252 + ".txt")
    with pytest.raises(OSError, match="File name too long") as refused, whole_file(too_long) as beside:
        beside.write_text("in vain")
    assert refused.value.filename == str(too_long)
    assert list(tmp_path.iterdir()) == [longest]


@pytest.mark.parametrize("text", ["no marks", "<a> only", "</a> turned <a>", "<a> <a> twice </a>"])
def test_a_text_without_the_marks_is_refused_and_kept(tmp_path: Path, text: str) -> None:
    page = tmp_path / "page.md"
    page.write_text(text)
    with pytest.raises(ValueError, match=r"page\.md: '<a>' and then '</a>' must each stand in it once"):
        replace_section(page, "<a>", "</a>", ["new"])
    assert page.read_text() == text
