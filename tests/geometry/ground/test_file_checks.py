"""One check before any file is read: what is no ordinary file of a stated size is refused at once, by its name."""

from __future__ import annotations

import os
import socket
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from refusals import check_messages, refused

from geometry.ground.csv_files import read_csv
from geometry.ground.file_checks import (
    check_local,
    check_own_file,
    library_reads,
    open_to_append,
    ordinary_file,
    read_bytes,
)
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import read_toml
from geometry.ground.whole_files import made_folder, whole_file, whole_lines, write_text


def folder(path: Path) -> None:
    path.mkdir()


def pipe(path: Path) -> None:
    os.mkfifo(path)


def listening(path: Path) -> None:
    here = os.getcwd()
    os.chdir(path.parent)  # names of sockets may have a hundred characters
    try:
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(path.name)
    finally:
        os.chdir(here)


def device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def circle(path: Path) -> None:
    path.symlink_to(path)


def large(path: Path) -> None:
    path.write_bytes(b"x" * 101)


NO_FILES: dict[str, tuple[Callable[[Path], None], Kind]] = {
    "folder": (folder, Kind.UNREADABLE),
    "pipe": (pipe, Kind.UNREADABLE),
    "socket": (listening, Kind.UNREADABLE),
    "device": (device, Kind.UNREADABLE),
    "circle": (circle, Kind.UNREADABLE),
    "large": (large, Kind.OUT_OF_RANGE),
    "none": (lambda path: None, Kind.MISSING),
}


@pytest.mark.parametrize("read", [ordinary_file, read_bytes])
@pytest.mark.parametrize("kind", NO_FILES)
def test_what_is_no_ordinary_file_is_refused_by_what_it_is(
    read: Callable[..., object], kind: str, tmp_path: Path
) -> None:
    make, why = NO_FILES[kind]
    make(tmp_path / "given")
    with refused(why, file=tmp_path / "given"):
        read(tmp_path / "given", "a test", Refusal, 100)


def test_messages(tmp_path: Path) -> None:
    for name, (make, _) in NO_FILES.items():
        make(tmp_path / name)
    cases = {name: partial(ordinary_file, tmp_path / name, "a test", Refusal, 100) for name in NO_FILES}
    check_messages(Path(__file__).with_name("messages.txt"), cases, {f"{tmp_path}/": ""})


@pytest.mark.parametrize(("name", "kind"), [("a\0b", Kind.MISSING), ("a" * 300, Kind.UNREADABLE)])
def test_a_name_that_no_file_can_have_is_refused(name: str, kind: Kind, tmp_path: Path) -> None:
    with refused(kind):
        read_toml(tmp_path / name, "a test", Refusal)


def test_a_file_that_may_not_be_read_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "given"
    path.write_bytes(b"x")

    def denied(*_: object) -> None:  # whoever runs the tests may be allowed to read everything
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "open", denied)
    with refused(Kind.UNREADABLE, file=path):
        ordinary_file(path, "a test", Refusal)


@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="a file without a stated length")
def test_what_is_read_is_bounded_where_the_file_states_no_length() -> None:
    with refused(Kind.OUT_OF_RANGE, file="/proc/self/status"):
        read_bytes("/proc/self/status", "a test", Refusal, 10)


def test_an_ordinary_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "given"
    path.write_bytes(b"x" * 100)
    assert ordinary_file(str(path), "a test", Refusal, 100) == path
    assert read_bytes(path, "a test", Refusal, 100) == read_bytes(path, "a test", Refusal) == b"x" * 100


@pytest.mark.parametrize("error", [KeyError("x"), MemoryError(), RecursionError("deep"), OSError(5, "x")])
def test_whatever_a_library_raises_is_a_refusal(error: Exception) -> None:
    with refused(Kind.UNREADABLE, file="f.mat"), library_reads("f.mat", "a MAT file", Refusal):
        raise error


def test_a_refusal_and_a_wish_to_stop_pass_the_library() -> None:
    with pytest.raises(Refusal, match=r"^as it was$"), library_reads("f.mat", "a MAT file", Refusal):
        raise Refusal("as it was", kind=Kind.OUT_OF_RANGE)
    with pytest.raises(KeyboardInterrupt), library_reads("f.mat", "a MAT file", Refusal):
        raise KeyboardInterrupt


@pytest.mark.parametrize(
    "address", ["s3://bucket/a.nc", "https://host/a", "file:///tmp/a", "memory://a", "zip::s3://b/a"]
)
def test_an_address_is_no_file_to_read_or_write(address: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for path in (address, Path(address)):
        for call in (
            lambda path=path: ordinary_file(path, "a test", Refusal),
            lambda path=path: write_text(path, "content"),
            lambda path=path: made_folder(path),
            lambda path=path: whole_lines(path).__enter__(),
        ):
            with refused(Kind.OUT_OF_RANGE) as found:
                call()
            assert found.value.file == address
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["a:b", "C:/a.nc", "s3", "s3:", "10:20/x", "./a+b/c"])
def test_a_name_with_a_colon_is_a_path(name: str) -> None:
    check_local(name)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_a_text_in_utf_16_is_named_and_a_table_read(encoding: str, tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes("name = 1".encode(encoding))
    with refused(Kind.UNREADABLE, file="a.toml") as found:
        read_toml(tmp_path / "a.toml", "a design file", Refusal)
    assert "UTF-16" in str(found.value)
    (tmp_path / "a.csv").write_bytes("# note\na,b\n1,2\n".encode(encoding))
    table = read_csv(tmp_path / "a.csv", "a CSV file", Refusal)
    assert (table.head, list(table.rows)) == (("a", "b"), [["1", "2"]])


def link(path: Path) -> None:
    path.with_name("another's").write_text("mine")
    path.symlink_to(path.with_name("another's"))


def link_to_nothing(path: Path) -> None:
    path.symlink_to(path.with_name("nothing"))


@pytest.mark.parametrize("write", [check_own_file, open_to_append])
@pytest.mark.parametrize("make", [folder, pipe, listening, device, circle, link, link_to_nothing])
def test_what_is_no_file_of_ours_is_not_written_on(
    write: Callable[..., object], make: Callable[[Path], None], tmp_path: Path
) -> None:
    make(tmp_path / "given")
    before = sorted(tmp_path.iterdir())
    with refused(Kind.EXISTS, file=tmp_path / "given"):
        write(tmp_path / "given", "a log", Refusal)
    assert sorted(tmp_path.iterdir()) == before


def test_a_log_is_written_on(tmp_path: Path) -> None:
    for line in ("one", "two"):
        with open_to_append(tmp_path / "log", "a log", Refusal) as log:
            log.write(f"{line}\n")
    assert (tmp_path / "log").read_text() == "one\ntwo\n"


@pytest.mark.parametrize("make", [pipe, link, link_to_nothing, listening])
def test_what_lies_beside_a_file_that_is_written_is_neither_opened_nor_followed(
    make: Callable[[Path], None], tmp_path: Path
) -> None:
    with whole_file(tmp_path / "file.txt") as beside:
        pass_by = beside
        make(beside)
        beside.unlink()
        beside.write_text("first")
    make(pass_by)
    write_text(tmp_path / "file.txt", "second")
    assert (tmp_path / "file.txt").read_text() == "second"
    others = tmp_path / "another's"
    assert not others.exists() or others.read_text() == "mine"
