"""What is done to good files: bits turned, ends cut off, places replaced, files that are none."""

from __future__ import annotations

import os
import random
import zipfile
from collections.abc import Callable
from pathlib import Path

#: Changes the files of a folder; draws what it needs from the given source.
Change = Callable[[Path, random.Random], None]


def bit_flips(name: str, first: int = 0, last: int | None = None, count: int = 1) -> Change:
    """Turns ``count`` bits of a file, or of a file drawn from a folder, between two bytes."""

    def change(folder: Path, draw: random.Random) -> None:
        path = _one_file(folder / name, draw)
        data = bytearray(path.read_bytes())
        for _ in range(count):
            place = draw.randrange(first, min(last or len(data), len(data)))
            data[place] ^= 1 << draw.randrange(8)
        path.write_bytes(data)

    return change


def cut_off(name: str) -> Change:
    """Takes a random part of a file's end away."""

    def change(folder: Path, draw: random.Random) -> None:
        path = _one_file(folder / name, draw)
        path.write_bytes(path.read_bytes()[: draw.randrange(path.stat().st_size)])

    return change


def noise_written(name: str) -> Change:
    """Overwrites a block of a file with noise."""

    def change(folder: Path, draw: random.Random) -> None:
        path = _one_file(folder / name, draw)
        data = bytearray(path.read_bytes())
        place = draw.randrange(len(data))
        length = min(draw.randrange(1, 512), len(data) - place)
        data[place : place + length] = draw.randbytes(length)
        path.write_bytes(data)

    return change


def one_removed(name: str) -> Change:
    """Takes one file of a folder away."""

    def change(folder: Path, draw: random.Random) -> None:
        _one_file(folder / name, draw).unlink()

    return change


def replaced(name: str, old: str, new: str) -> Change:
    """Puts a text in the place of another that the file must have."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / name
        text = path.read_text(encoding="utf-8")
        assert old in text, (name, old)
        path.write_text(text.replace(old, new, 1), encoding="utf-8")

    return change


def written(name: str, data: str | bytes) -> Change:
    """Puts a text or bytes in the place of all that a file holds."""

    def change(folder: Path, draw: random.Random) -> None:
        (folder / name).write_bytes(data.encode() if isinstance(data, str) else data)

    return change


def no_file(name: str, kind: str) -> Change:
    """Puts something that is no ordinary file in its place: a folder, a FIFO, a device, nothing, a dangling link."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / name
        path.unlink()
        match kind:
            case "folder":
                path.mkdir()
            case "fifo":
                os.mkfifo(path)
            case "zeros":
                path.symlink_to("/dev/zero")
            case "link":
                path.symlink_to(folder / "nowhere")
            case "itself":
                path.symlink_to(path)
            case "empty":
                path.touch()
            case "nothing":
                pass
            case _:
                raise AssertionError(kind)

    return change


def without_member(name: str, member: str) -> Change:
    """Takes a member of an archive away."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / name
        with zipfile.ZipFile(path) as archive:
            kept = {entry: archive.read(entry) for entry in archive.namelist() if entry != member}
            assert len(kept) < len(archive.namelist()), archive.namelist()
        with zipfile.ZipFile(path, "w") as archive:
            for entry, data in kept.items():
                archive.writestr(entry, data)

    return change


def _one_file(path: Path, draw: random.Random) -> Path:
    if path.is_file():
        return path
    return draw.choice(sorted(each for each in path.rglob("*") if each.is_file() and each.stat().st_size))
