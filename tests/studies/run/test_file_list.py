"""The list of a run's files: complete, and changed, missing and extra files are found by it."""

from __future__ import annotations

import json
import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from refusals import refused
from small_run import PLAN, small_design, small_run

from geometry.ground.record import SEAL, sealed
from geometry.ground.refusal import Kind
from geometry.ground.stated_times import VARIABLE
from studies.output.folders import MANIFEST
from studies.run.file_list import verify_run, write_file_list
from studies.run.pipeline import run_design

#: Time in a PDF.
DATE = re.compile(rb"/(?:Creation|Mod)Date \([^)]*\)")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with two listed files, of which one lies in a folder."""
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "lid.stl").write_bytes(b"solid")
    (tmp_path / "design.toml").write_bytes(b"name = 'row'\n")
    write_file_list(tmp_path, ("design.toml", "parts"))
    return tmp_path


def changed(folder: Path, change: Callable[[dict[str, Any]], None]) -> None:
    """Change the list of files and seal it again, as somebody could who knows how."""
    content = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    change(content)
    content.pop(SEAL)
    (folder / MANIFEST).write_text(json.dumps(sealed(content)), encoding="utf-8")


def test_every_file_of_a_run_is_listed() -> None:
    found = verify_run(small_run().folder)
    assert found.complete
    on_disk = {path.relative_to(found.folder).as_posix() for path in found.folder.rglob("*") if path.is_file()}
    assert set(found.unchanged) == on_disk - {MANIFEST}


def test_a_folder_as_it_was_written_is_complete(folder: Path) -> None:
    assert verify_run(folder).unchanged == ("design.toml", "parts/lid.stl")
    assert verify_run(folder).complete


@pytest.mark.parametrize("content", [b"", b"soliD", b"solid ", b"solid" * 1000])
def test_other_content_is_a_change(folder: Path, content: bytes) -> None:
    (folder / "parts" / "lid.stl").write_bytes(content)
    assert verify_run(folder).changed == ("parts/lid.stl",)
    assert not verify_run(folder).complete


def test_one_bit_of_every_byte_is_a_change(folder: Path) -> None:
    path = folder / "design.toml"
    content = path.read_bytes()
    for place in range(len(content)):
        path.write_bytes(content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :])
        assert verify_run(folder).changed == ("design.toml",)


def test_links_and_pipes_are_changes_and_are_not_opened(folder: Path) -> None:
    path = folder / "parts" / "lid.stl"
    path.rename(folder.parent / "lid.stl")
    path.symlink_to(folder.parent / "lid.stl")
    (folder / "design.toml").unlink()
    os.mkfifo(folder / "design.toml")
    assert verify_run(folder).changed == ("design.toml", "parts/lid.stl")


def test_missing_and_extra_files_are_named(folder: Path) -> None:
    (folder / "design.toml").unlink()
    (folder / "parts" / "notes.txt").touch()
    (folder / "more").symlink_to("/")
    found = verify_run(folder)
    assert (found.missing, found.extra) == (("design.toml",), ("more", "parts/notes.txt"))


def test_a_folder_without_a_list_is_not_accepted(tmp_path: Path) -> None:
    with refused(Kind.MISSING, file=MANIFEST):
        verify_run(tmp_path)
    with refused(Kind.MISSING, file="nowhere"):
        verify_run(tmp_path / "nowhere")
    (tmp_path / "file").touch()
    with refused(Kind.WRONG_TYPE, file="file"):
        verify_run(tmp_path / "file")


def test_a_damaged_list_is_not_accepted(folder: Path) -> None:
    text = (folder / MANIFEST).read_text(encoding="utf-8")
    for damaged in (text.replace("design.toml", "design.tomk"), text.replace('"bytes": 5', '"bytes": 6'), "{}", "[]"):
        (folder / MANIFEST).write_text(damaged, encoding="utf-8")
        with refused(Kind.DAMAGED, file=MANIFEST):
            verify_run(folder)
    for unreadable in ("", text[:40], "[" * 3000, "9" * 5000):
        (folder / MANIFEST).write_text(unreadable, encoding="utf-8")
        with refused(Kind.UNREADABLE, file=MANIFEST):
            verify_run(folder)


def test_a_list_of_another_version_is_not_accepted(folder: Path) -> None:
    changed(folder, lambda content: content.update(format=2))
    with refused(Kind.MISMATCH, "format", 2):
        verify_run(folder)


@pytest.mark.parametrize("entry", [None, 5, {}, {"bytes": -1, "sha256": "0" * 64}, {"bytes": 5, "sha256": "0"}])
def test_an_entry_without_size_and_hash_is_not_accepted(folder: Path, entry: object) -> None:
    changed(folder, lambda content: content["files"].update(x=entry))
    with refused(Kind.WRONG_TYPE, "files.x"):
        verify_run(folder)


def test_names_outside_the_folder_are_missing_and_are_not_read(folder: Path) -> None:
    (folder.parent / "outside").write_bytes(b"solid")
    entry = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))["files"]["parts/lid.stl"]
    changed(folder, lambda content: content["files"].update({"../outside": entry, "/etc/passwd": entry}))
    assert verify_run(folder).missing == ("../outside", "/etc/passwd")


@pytest.mark.slow
def test_two_runs_with_the_clock_stopped_write_equal_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "1700000000")
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cells"))  # empty for the first, full for the second
    for name in ("first", "second"):
        run_design(small_design(), tmp_path / name, fidelity="navier-stokes", frequency="1:100:8", plan=PLAN)
        shutil.move(tmp_path / name, tmp_path / f"moved {name}")
    first, second = (
        {path.relative_to(top).as_posix(): path.read_bytes() for path in top.rglob("*") if path.is_file()}
        for top in (tmp_path / "moved first", tmp_path / "moved second")
    )
    assert len(first) > 35
    assert first.keys() == second.keys()
    assert [name for name in first if first[name] != second[name]] == []
    assert verify_run(tmp_path / "moved first").complete


@pytest.mark.slow
def test_two_runs_differ_only_where_times_are_stated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)
    first, second = small_run().folder, tmp_path / "second"
    run_design(small_design(), second, fidelity="lumped", plan=PLAN)
    timed = {"library.nc", "localizer/localizer.json", "report.html", "results.json", MANIFEST}
    differing = {
        name for name in verify_run(first).unchanged if (first / name).read_bytes() != (second / name).read_bytes()
    }
    steps = {name for name in differing if name.endswith(".step")}
    documents = {name for name in differing if name.endswith(".pdf")}
    assert differing - steps - documents <= timed
    for name in documents:
        one, other = (DATE.sub(b"", (top / name).read_bytes()) for top in (first, second))
        assert one == other, name
    for name in steps:  # the line with the time, and no other
        lines = [(top / name).read_text(encoding="utf-8").splitlines() for top in (first, second)]
        assert sum(one != other for one, other in zip(*lines, strict=True)) == 1
