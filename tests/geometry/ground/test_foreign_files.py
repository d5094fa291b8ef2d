"""Files read apart: whatever a reader does, the answer is bytes or one refusal that names the file."""

import os
import signal
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from refusals import refused

from geometry import Kind, Refusal
from geometry.ground.foreign_files import read_apart


def size_of(path: str) -> bytes:
    return str(os.path.getsize(path)).encode()


def loop(path: str) -> bytes:
    while True:
        pass


def sleep(path: str) -> bytes:
    time.sleep(1000)
    return b""


def crash(path: str) -> bytes:
    os.kill(os.getpid(), signal.SIGSEGV)
    return b""


def take_all_memory(path: str) -> bytes:
    return b"x" * 10**10


def recurse(path: str) -> bytes:
    return recurse(path)


def leave(path: str) -> bytes:
    raise SystemExit(0)


def test_the_bytes_that_the_reader_makes_come_back(tmp_path: Path) -> None:
    path = tmp_path / "file.x"
    path.write_bytes(b"12345")
    assert read_apart(size_of, path, "a file", Refusal, 10**8) == b"5"


@pytest.mark.parametrize("read", [sleep, loop, crash, take_all_memory, recurse, leave])
def test_a_reader_that_does_not_come_back_is_refused_with_the_file(
    read: Callable[[str], bytes], tmp_path: Path
) -> None:
    path = tmp_path / "file.x"
    path.write_bytes(b"12345")
    began = time.monotonic()
    with refused(Kind.UNREADABLE, file=path):
        read_apart(read, path, "a file", Refusal, 10**8, 1.0 if read in (sleep, loop) else 20.0)
    assert time.monotonic() - began < 60
