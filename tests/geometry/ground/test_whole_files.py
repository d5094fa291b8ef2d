"""Files appear whole or not at all, and a section is replaced only where its marks stand."""

from __future__ import annotations

import errno
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from refusals import refused

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import replace_section, temporary_folder, whole_file, whole_lines, writing

resource = pytest.importorskip("resource")


@contextmanager
def no_room_beyond(count: int) -> Iterator[None]:
    """Files that grow to at most so many bytes, as on a disk that is full."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (count, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


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


@pytest.mark.parametrize("said", [RuntimeError("HDF error"), PermissionError(13, "Permission denied"), None])
def test_a_full_disk_is_told_whatever_a_library_says_of_it(tmp_path: Path, said: Exception | None) -> None:
    path = tmp_path / "a.nc"
    path.write_text("old")

    def half() -> None:
        with whole_file(path) as beside:
            if said is None:
                beside.write_bytes(bytes(10_000))
            raise said or AssertionError("written")

    with no_room_beyond(5000), pytest.raises(OSError, match="File too large") as caught:
        half()
    assert (caught.value.errno, caught.value.filename) == (errno.EFBIG, str(path))
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.nc"]


@pytest.mark.parametrize("said", [RuntimeError("no shape was read"), OSError(errno.ENOSPC, "No space"), None])
def test_a_full_folder_for_temporary_files_is_named_whatever_a_library_says_of_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: Exception | None
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))

    def half() -> None:
        with temporary_folder() as folder:
            if said is not None:
                raise said
            (folder / "a").write_bytes(bytes(10_000))

    with no_room_beyond(5000), pytest.raises(OSError, match="set TMPDIR") as caught:
        half()
    assert caught.value.errno in (errno.EFBIG, errno.ENOSPC)
    assert caught.value.filename == str(tmp_path)
    assert [*tmp_path.iterdir()] == []


def test_a_folder_for_temporary_files_with_room_changes_no_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    for error in (RuntimeError("a mistake"), Refusal("is no design", kind=Kind.UNSUITABLE)):
        with pytest.raises(type(error)) as caught, temporary_folder():
            raise error
        assert caught.value is error
    assert [*tmp_path.iterdir()] == []


def test_without_any_folder_for_temporary_files_one_line_says_what_to_set(monkeypatch: pytest.MonkeyPatch) -> None:
    def none() -> str:
        raise FileNotFoundError(errno.ENOENT, "No usable temporary directory found in ['/tmp']")

    monkeypatch.setattr(tempfile, "gettempdir", none)
    monkeypatch.setenv("TMPDIR", "/full")
    with pytest.raises(OSError, match="set TMPDIR") as caught, temporary_folder():
        pass
    assert (caught.value.errno, caught.value.filename) == (errno.ENOSPC, "/full")


def test_what_the_system_says_of_a_full_disk_gets_the_name_that_it_lacks(tmp_path: Path) -> None:
    for number, name, shown in (
        (errno.ENOSPC, None, "store"),
        (errno.ENOSPC, "other", "other"),
        (errno.ECONNREFUSED, None, None),
    ):
        with pytest.raises(OSError) as caught, writing("store"):
            raise OSError(number, "why", name)
        assert caught.value.filename == shown


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
    with refused(Kind.UNSUITABLE, file="page.md"):
        replace_section(page, "<a>", "</a>", ["new"])
    assert page.read_text() == text


def test_a_line_for_which_there_is_no_room_is_not_begun(tmp_path: Path) -> None:
    path = tmp_path / "touches.jsonl"

    def two_lines() -> None:
        with whole_lines(path) as write:
            write("twelve bytes")
            write("twelve bytes")

    with pytest.raises(OSError, match="File too large") as caught, no_room_beyond(20):
        two_lines()
    assert caught.value.filename == str(path)
    assert path.read_text() == "twelve bytes\n"


def test_lines_take_the_place_of_a_link_and_leave_its_file(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("years of work")
    (tmp_path / "touches.jsonl").symlink_to(tmp_path / "thesis.tex")
    with whole_lines(tmp_path / "touches.jsonl") as write:
        write("new")
        assert (tmp_path / "touches.jsonl").read_text() == "new\n"  # at once
    assert (tmp_path / "thesis.tex").read_text() == "years of work"
