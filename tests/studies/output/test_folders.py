"""Folders of results: other people's stay as they are, old results go before new ones come, and none is half."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from refusals import check_messages, refused

from geometry import Kind
from studies.output import folders
from studies.output.folders import (
    FILES,
    MARK,
    check_folder,
    check_new_file,
    check_new_library,
    claim_folder,
    claimed_file,
    claimed_folder,
    replaced_files,
    replaced_folder,
)


def earlier_run(folder: Path, design: str) -> None:
    """Files of a finished run of a design, and one of the user."""
    claim_folder(folder, design)
    for name in ("report.html", "results.json", "library.nc", "notes.txt"):
        (folder / name).write_text("old")
    for name in ("parts", "localizer", "figures"):
        (folder / name).mkdir()
        (folder / name / "file").write_text("old")


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_a_new_run_of_the_same_design_takes_the_old_report_away_first(tmp_path: Path) -> None:
    earlier_run(tmp_path, "one")
    claim_folder(tmp_path, "one")
    assert names(tmp_path) == {MARK, "design.toml", "library.nc", "parts", "localizer", "figures", "notes.txt"}


def test_a_new_run_of_another_design_takes_all_earlier_results_away_first(tmp_path: Path) -> None:
    earlier_run(tmp_path, "one")
    claim_folder(tmp_path, "two")
    assert names(tmp_path) == {MARK, "design.toml", "notes.txt"}
    assert (tmp_path / "design.toml").read_text() == "two"


def test_no_state_of_a_folder_mixes_two_designs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Killed(BaseException):
        pass

    remove, killed_at = folders._remove, 0

    def killed(path: Path) -> None:
        nonlocal left
        if left == 0:
            raise Killed
        left -= 1
        remove(path)

    monkeypatch.setattr(folders, "_remove", killed)
    for killed_at in range(20):
        folder, left = tmp_path / str(killed_at), 10**6
        earlier_run(folder, "one")
        left = killed_at
        try:
            claim_folder(folder, "two")
        except Killed:
            results_left = names(folder) - {MARK, "notes.txt", "design.toml"}
            of_design = (folder / "design.toml").read_text() if (folder / "design.toml").exists() else None
            assert of_design == "one" or not results_left
        else:
            break
    assert killed_at == 8  # every step was tried


def test_a_folder_is_replaced_only_when_all_went_well(tmp_path: Path) -> None:
    target = tmp_path / "parts"
    target.mkdir()
    (target / "old.stl").write_text("old")

    def fail() -> None:
        with replaced_folder(target) as fresh:
            (fresh / "half.stl").write_text("half")
            raise ValueError("broken")

    with pytest.raises(ValueError, match="broken"):
        fail()
    assert [path.name for path in target.iterdir()] == ["old.stl"]
    assert names(tmp_path) == {"parts"}
    with replaced_folder(target) as fresh:
        (fresh / "new.stl").write_text("new")
    assert [path.name for path in target.iterdir()] == ["new.stl"]
    assert names(tmp_path) == {"parts"}


def test_the_old_folder_stays_where_the_new_one_cannot_be_put_in_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "parts"
    target.mkdir()
    (target / "old.stl").write_text("old")
    replace = os.replace

    def refused(source: Path, goal: Path) -> None:
        if source.name == ".parts.new":
            raise OSError(28, "No space left on device", str(goal))
        replace(source, goal)

    monkeypatch.setattr(os, "replace", refused)
    with pytest.raises(OSError, match="No space left"), replaced_folder(target) as fresh:
        (fresh / "new.stl").write_text("new")
    assert names(tmp_path) == {"parts"}
    assert names(target) == {"old.stl"}


def test_places_that_cannot_be_written_are_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with refused(Kind.EXISTS, "record", file=tmp_path):
        check_new_file(tmp_path, option="record")
    with refused(Kind.MISSING, "out", file=tmp_path / "none" / "library.nc"):
        check_new_file(tmp_path / "none" / "library.nc")
    check_new_file(tmp_path / "file")  # replaced, where it is not kept
    with refused(Kind.EXISTS, "out", file=tmp_path / "file"):
        check_new_file(tmp_path / "file", kept="a design")
    for place in (tmp_path / "file", tmp_path / "file" / "deeper"):
        with refused(Kind.EXISTS, "out", file=place):
            check_folder(place)
    check_folder(tmp_path / "new" / "deeper")
    assert names(tmp_path) == {"file"}


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="needs a file system in which nothing can be made")
def test_a_file_system_in_which_nothing_can_be_made_is_refused() -> None:
    for check, place in ((check_folder, Path("/proc/foo")), (check_new_file, Path("/proc/foo.nc"))):
        with refused(Kind.UNREADABLE, "out", file=place):
            check(place)


@pytest.mark.parametrize("replaced", [replaced_files, replaced_folder])
def test_a_file_that_cannot_be_written_is_called_as_it_would_be(
    tmp_path: Path, replaced: Callable[[Path], AbstractContextManager[Path]]
) -> None:
    def write() -> None:
        with replaced(tmp_path / "parts") as fresh:
            raise OSError(errno.ENOSPC, "No space left on device", str(fresh / "shell.stl"))

    with pytest.raises(OSError, match="No space left") as told:
        write()
    assert told.value.filename == str(tmp_path / "parts" / "shell.stl")


def test_the_messages_of_outputs(tmp_path: Path) -> None:
    file, folder, listed, run = (tmp_path / name for name in ("notes.txt", "others", "parts", "run"))
    file.write_text("mine")
    for place in (folder, listed):
        place.mkdir()
    (folder / "thesis.txt").write_text("mine")
    (listed / FILES).write_text("../precious\n")
    (tmp_path / "link").symlink_to(tmp_path / "gone")
    claim_folder(run, "one")
    (run / "design.toml").write_text("changed")

    calls = {
        "a folder in place of a file": lambda: check_new_file(folder),
        "a design that is kept": lambda: check_new_file(file, kept="a design"),
        "a file that is read": lambda: check_new_file(file, reads=(file,)),
        "a file of another kind": lambda: check_new_file(file, ".nc"),
        "no folder for it": lambda: check_new_file(tmp_path / "none" / "a.nc", option="record"),
        "no library": lambda: check_new_library(file, (".nc", ".csv")),
        "a file in place of a folder": lambda: check_folder(file),
        "a link to nothing": lambda: check_folder(tmp_path / "link"),
        "a folder that holds what is read": lambda: check_folder(folder, reads=(folder / "thesis.txt",)),
        "a folder of others": lambda: check_folder(folder, "run", MARK),
        "a design changed by hand": lambda: claim_folder(run, "two"),
        "an address": lambda: check_folder(Path("s3://bucket/a")),
        "a list that names others": lambda: replaced_files(listed).__enter__(),
    }
    check_messages(Path(__file__).parent / "messages.txt", calls, {f"{tmp_path}{os.sep}": ""})


#: Folders that a killed command leaves: what lies in it, and the marks by which the command knows its own.
KILLED = {
    "parts, while they are drawn": ((".files.new/half.stl",), (FILES,)),
    "parts, while the list is written": ((".files.new/a.stl", ".files.4711.txt"), (FILES,)),
    "a decoder, before its header is there": ((".decoder-files.new/a.c",), ("decoder-files.txt", "touch_decoder.h")),
    "a run, while it marks its folder": ((f".{MARK}.4711",), (MARK,)),
    "a training, while it writes its checkpoint": ((".checkpoint.12.safetensors",), ("checkpoint.safetensors",)),
    "a study, while it writes its summary": ((".tolerance.12.json",), ("tolerance.json",)),
}


@pytest.mark.parametrize("killed", KILLED)
def test_a_folder_that_a_killed_command_left_is_taken_up_and_cleared(tmp_path: Path, killed: str) -> None:
    left, marks = KILLED[killed]
    for name in left:
        (tmp_path / "out" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "out" / name).write_text("half")
    check_folder(tmp_path / "out", "maker", *marks)
    with claimed_folder(tmp_path / "out", "maker", *marks):
        assert names(tmp_path / "out") == set()


@pytest.mark.parametrize(
    "name", ["notes.txt", ".files.new.txt", ".checkpoint.old.safetensors", ".files.txt", "files.new"]
)
def test_what_no_killed_command_left_is_somebodys(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("mine")
    (tmp_path / ".files.new").mkdir()
    with refused(Kind.EXISTS, "out", file=tmp_path), claimed_folder(tmp_path, "parts", FILES, "checkpoint.safetensors"):
        raise AssertionError
    assert names(tmp_path) == {name, ".files.new"}


def test_a_folder_that_was_made_for_nothing_is_gone_and_one_that_was_there_stays(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    for name in ("mine", "new"):
        with claimed_folder(tmp_path / name, "bend", "bending.json"):
            assert (tmp_path / name).is_dir()
            with refused(Kind.EXISTS, file=tmp_path / name), claimed_folder(tmp_path / name, "bend", "bending.json"):
                raise AssertionError
    assert names(tmp_path) == {"mine"}


@pytest.mark.parametrize("name", ["library.nc", "x" * 250 + ".nc", "\N{GREEK SMALL LETTER ALPHA}" * 120 + ".nc"])
def test_a_file_is_written_by_one_at_a_time_and_its_lock_goes_with_the_writer(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    with claimed_file(path, lambda: None):
        with refused(Kind.EXISTS), claimed_file(path, lambda: None):
            raise AssertionError
        with claimed_file(tmp_path / "another.nc", lambda: None):
            pass
    assert names(tmp_path) == set()
    with claimed_file(path, lambda: None):  # the lock of a process that was killed is taken over
        (lock,) = tmp_path.iterdir()
    lock.write_text("")
    with claimed_file(path, lambda: None):
        pass
    assert names(tmp_path) == set()


def test_what_another_process_wrote_in_the_meantime_is_kept(tmp_path: Path) -> None:
    path, calls = tmp_path / "measured.nc", []

    def check() -> None:
        check_new_file(path, kept="a measured library")
        if not calls:  # another process ends between the check and the lock
            path.write_text("measured")
        calls.append(path)

    with refused(Kind.EXISTS, "out", file=path), claimed_file(path, check):
        raise AssertionError
    assert path.read_text() == "measured"
    assert names(tmp_path) == {"measured.nc"}
