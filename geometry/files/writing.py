"""Files that appear whole or not at all: written beside, then renamed."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from geometry.refusal import Refusal


@contextmanager
def whole_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Where to write what shall take the place of a file; it does so when the block ends without an error.

    The name keeps the suffix, from which libraries infer the format. Whatever stops the block, an earlier file
    stays as it was and nothing is left beside it.

    Args:
        path: the file; its folder must exist.
    """
    path = Path(path)
    with suppress(FileNotFoundError):
        path.lstat()  # a name that is too long is told of the file itself, before anything is written
    # Of a name that is as long as can be only a part: nothing could be added to it.
    beside = path.with_name(f".{path.stem[:40]}.{os.getpid()}{path.suffix}")
    try:
        yield beside
        # Without this a power cut may leave the new name before its content.
        with open(beside, "rb") as written:
            os.fsync(written.fileno())
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write a text in UTF-8, whole or not at all; lines end with a line feed on every system."""
    with whole_file(path) as beside:
        beside.write_text(text, encoding="utf-8", newline="\n")


def replace_section(path: str | os.PathLike[str], begin: str, end: str, lines: Sequence[str]) -> None:
    """Put lines between two marks of a text, in place of what stands there; the marks stay.

    Raises:
        Refusal: the marks do not stand in the text once each, in this order.
    """
    text = Path(path).read_text(encoding="utf-8")
    before, found, rest = text.partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed or begin in rest:
        raise Refusal(f"{path}: {begin!r} and then {end!r} must each stand in it once")
    write_text(path, "\n".join([before + begin, *lines, end + after]))
