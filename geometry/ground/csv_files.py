"""Files of comma-separated values, read row by row: a table of any length takes no more memory than its numbers."""

from __future__ import annotations

import csv
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from geometry.ground.file_checks import LARGEST_DATA, library_reads, ordinary_file
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import encoding_of

_LONGEST_LINE = 4_000_000  # characters; the longest that is written is a design in one line of text


@dataclass(frozen=True)
class Table:
    """A table as its file states it."""

    remarks: tuple[str, ...]
    """Lines ahead of the table that begin with ``# ``, without that."""
    head: tuple[str, ...]
    """First row; empty where there is none."""
    rows: Iterator[list[str]]
    """Other rows that are not empty, read when they are asked for."""


def read_csv(path: str | os.PathLike[str], what: str, refusal: type[Refusal]) -> Table:
    """The table in a CSV file in UTF-8 or UTF-16, with or without a byte order mark.

    Args:
        path: the file.
        what: such as ``a CSV file``, for messages.
        refusal: class of the errors.

    Raises:
        Refusal: of that class: no such file, too large, a line too long, or not CSV; where that is so of a
            later row, when that is asked for.
    """
    path = ordinary_file(path, what, refusal, LARGEST_DATA)
    with path.open("rb") as file:
        encoding = encoding_of(file.read(2))
    with path.open(encoding=encoding, newline="") as file:
        remarks = []
        with library_reads(path, what, refusal):
            for line in _lines(path, file, refusal):
                if not line.startswith("# "):
                    break
                remarks.append(line[2:].rstrip("\r\n"))
    rows = _rows(path, what, refusal, len(remarks), encoding)
    return Table(tuple(remarks), tuple(next(rows, [])), rows)


def _rows(path: Path, what: str, refusal: type[Refusal], remarks: int, encoding: str) -> Iterator[list[str]]:
    with path.open(encoding=encoding, newline="") as file:
        lines = _lines(path, file, refusal)
        for _ in range(remarks):
            next(lines, "")
        reader = csv.reader(lines)
        while True:
            with library_reads(path, what, refusal):
                row = next(reader, None)
            if row is None:
                return
            if row:
                yield row


def _lines(path: Path, file: IO[str], refusal: type[Refusal]) -> Iterator[str]:
    number = 0
    while line := file.readline(_LONGEST_LINE):
        number += 1
        if len(line) == _LONGEST_LINE:
            problem = f"line {number} has {_LONGEST_LINE} characters or more"
            raise refusal(problem, kind=Kind.UNREADABLE, file=path, remedy="give a CSV file, one row a line")
        yield line
