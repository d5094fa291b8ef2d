"""One check before any file is read: what is no ordinary file of a stated size is refused at once, by its name."""

from __future__ import annotations

import os
import socket
from collections.abc import Callable
from pathlib import Path

import pytest

from geometry.ground.file_checks import library_reads, ordinary_file, read_bytes
from geometry.ground.refusal import Refusal
from geometry.ground.text_files import read_toml


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


NO_FILES: dict[str, tuple[Callable[[Path], None], str]] = {
    "folder": (folder, "is a folder, not a test"),
    "pipe": (pipe, "is a pipe, not a test"),
    "socket": (listening, "is a socket, not a test"),
    "device": (device, "is a device, not a test"),
    "circle": (circle, "cannot be read: Too many levels of symbolic links"),
    "large": (large, "101 bytes must be at most 100 for a test"),
    "none": (lambda path: None, "no such file"),
}


@pytest.mark.parametrize("read", [ordinary_file, read_bytes])
@pytest.mark.parametrize("kind", NO_FILES)
def test_what_is_no_ordinary_file_is_refused_by_what_it_is(
    read: Callable[..., object], kind: str, tmp_path: Path
) -> None:
    make, message = NO_FILES[kind]
    path = tmp_path / "given"
    make(path)
    with pytest.raises(Refusal) as refused:
        read(path, "a test", Refusal, 100)
    assert str(refused.value) == f"{path}: {message}"


@pytest.mark.parametrize(("name", "message"), [("a\0b", "holds a NUL byte"), ("a" * 300, "File name too long")])
def test_a_name_that_no_file_can_have_is_refused(name: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(Refusal, match=message):
        read_toml(tmp_path / name, "a test", Refusal)


def test_a_file_that_may_not_be_read_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "given"
    path.write_bytes(b"x")

    def denied(*_: object) -> None:  # whoever runs the tests may be allowed to read everything
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "open", denied)
    with pytest.raises(Refusal, match=r"given: cannot be read: Permission denied"):
        ordinary_file(path, "a test", Refusal)


@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="a file without a stated length")
def test_what_is_read_is_bounded_where_the_file_states_no_length() -> None:
    with pytest.raises(Refusal, match=r"must be at most 10 bytes"):
        read_bytes("/proc/self/status", "a test", Refusal, 10)


def test_an_ordinary_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "given"
    path.write_bytes(b"x" * 100)
    assert ordinary_file(str(path), "a test", Refusal, 100) == path
    assert read_bytes(path, "a test", Refusal, 100) == read_bytes(path, "a test", Refusal) == b"x" * 100


@pytest.mark.parametrize("error", [KeyError("x"), MemoryError(), RecursionError("deep"), OSError(5, "x")])
def test_whatever_a_library_raises_is_a_refusal(error: Exception) -> None:
    with (
        pytest.raises(Refusal, match=r"^f\.mat: cut short or not a MAT file: ."),
        library_reads("f.mat", "a MAT file", Refusal),
    ):
        raise error


def test_a_refusal_and_a_wish_to_stop_pass_the_library() -> None:
    with pytest.raises(Refusal, match=r"^as it was$"), library_reads("f.mat", "a MAT file", Refusal):
        raise Refusal("as it was")
    with pytest.raises(KeyboardInterrupt), library_reads("f.mat", "a MAT file", Refusal):
        raise KeyboardInterrupt
