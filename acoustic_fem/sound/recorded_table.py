"""Tables of samples as other programs write them: commas, semicolons or tabs, points or commas for decimals.

The separator is the one of the first row: a tab, else a semicolon, else a comma; or what a line ``sep=;`` states. Lines
of remarks begin with ``#``. Texts are UTF-8 or UTF-16, with or without a byte order mark. Columns without a name and
without values are left out.
"""

from __future__ import annotations

import csv
from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

import numpy as np

from geometry.ground.argument_checks import reads_as_number
from geometry.ground.file_checks import LARGEST_DATA, MOST_NUMBERS, library_reads, ordinary_file
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import encoding_of
from geometry.ground.typed import Array

_SEPARATORS = ("\t", ";", ",")
_LONGEST_LINE, _SHOWN = 1_000_000, 40


@dataclass(frozen=True, eq=False)
class RecordedTable:
    """Columns of numbers with their names."""

    names: tuple[str, ...]
    """Names of the columns, as the file has them without blanks around."""
    columns: Array
    """Values; (n_row, n_column) float64."""
    lines: tuple[int, ...]
    """Numbers of the first and the second line with values, from 1; fewer for fewer rows."""


def read_table(path: Path, refusal: type[Refusal]) -> RecordedTable:
    """Table of numbers with a row of names.

    Args:
        path: of the file.
        refusal: class of the errors.

    Raises:
        Refusal: by ``refusal``, with the line: no such file, too large, no table, a value that is not a number, values
            of which it is not clear where their decimals begin, or more than 2^26 numbers.
    """
    path = ordinary_file(path, "a CSV file", refusal, LARGEST_DATA)
    with path.open("rb") as file:
        encoding = encoding_of(file.read(2))
    with path.open(encoding=encoding, newline="") as file:
        return _Reader(path, refusal).table(file)


class _Reader:
    def __init__(self, path: Path, refusal: type[Refusal]) -> None:
        self._path, self._refusal = path, refusal
        self._comma: bool | None = None  # whether decimals begin with a comma, once a value shows it
        self._separator: str | None = None

    def table(self, file: IO[str]) -> RecordedTable:
        """Table of an open file."""
        rows = self._rows(file)
        number, head = next(rows, (0, []))
        names = [name.strip() for name in head]
        if not any(names):
            raise self._fault("has no row of names, so it is empty or not a CSV file")
        if len(names) == 1 and len(names[0].split()) > 1:
            raise self._fault(
                f"holds {names[0][:_SHOWN]!r} in place of names; remarks must begin with #, and names and values must "
                "be separated by commas, semicolons or tabs",
                field=f"line {number}",
            )
        values = array("d")
        lines: list[int] = []
        for line, row in rows:
            lines = [*lines, line][:2]
            values.extend(self._numbers(line, row, names))
            if len(values) > MOST_NUMBERS:
                raise self._fault(f"holds more than {MOST_NUMBERS} numbers, the most that are read", Kind.OUT_OF_RANGE)
        columns = np.frombuffer(values).reshape(-1, len(names)) if len(values) else np.empty((0, len(names)))
        used = [k for k, name in enumerate(names) if name or not np.isnan(columns[:, k]).all()]
        unnamed = [k for k in used if not names[k]]
        if unnamed:
            raise self._fault(f"has values but no name in column {unnamed[0] + 1}")
        return RecordedTable(tuple(names[k] for k in used), columns[:, used], tuple(lines))

    def _rows(self, file: IO[str]) -> Iterator[tuple[int, list[str]]]:
        """Number of the line, and values, of each row that is not empty and no remark; the first are the names."""
        text = self._lines(file)
        with library_reads(self._path, "a CSV file", self._refusal):
            number, first = next(((k, line) for k, line in text if line.strip() and line[0] != "#"), (0, ""))
            stated = first.rstrip("\r\n")
            if len(stated) == 7 and stated[0] == stated[-1] == '"':
                stated = stated[1:-1]
            if stated.lower().startswith("sep=") and len(stated) == 5:
                self._separator = stated[4]
                number, first = next(((k, line) for k, line in text if line.strip() and line[0] != "#"), (0, ""))
        if self._separator is None:
            self._separator = next((each for each in _SEPARATORS if each in first), ",")
        if not first:
            return
        yield number, self._split(number, first)
        for number, line in text:
            if line.strip() and line[0] != "#" and line.strip(f" \r\n\t{self._separator}"):
                yield number, self._split(number, line)

    def _lines(self, file: IO[str]) -> Iterator[tuple[int, str]]:
        number = 0
        while True:
            with library_reads(self._path, "a CSV file", self._refusal):
                line = file.readline(_LONGEST_LINE)
            if not line:
                return
            number += 1
            if len(line) == _LONGEST_LINE:
                raise self._fault(f"line {number} has {_LONGEST_LINE} characters or more")
            yield number, line

    def _split(self, number: int, line: str) -> list[str]:
        assert self._separator is not None
        if '"' not in line:
            return line.rstrip("\r\n").split(self._separator)
        try:
            return next(csv.reader([line], delimiter=self._separator, strict=True))
        except csv.Error:
            problem = "has a quote that does not end, or text behind one that ends"
            raise self._fault(problem, field=f"line {number}") from None

    def _numbers(self, line: int, row: list[str], names: list[str]) -> list[float]:
        """Values of a row; not a number where a column without a name is empty."""
        while len(row) > len(names) and not row[-1].strip():
            row = row[:-1]
        if len(row) != len(names):
            hint = (
                "; decimals that begin with a comma need semicolons or tabs between values"
                if self._separator == "," and len(row) >= 2 * len(names) - 1 > 1
                else ""
            )
            raise self._fault(
                f"has {counted(len(row), 'value')}; it must have {len(names)}{hint}", field=f"line {line}"
            )
        plain = self._plain(line, row, names)
        try:
            return [float(each) for each in plain]
        except ValueError:
            raise self._no_number(line, next(each for each in plain if not reads_as_number(each))) from None

    def _plain(self, line: int, row: list[str], names: list[str]) -> list[str]:
        """Values with points for decimals; only what is written in plain digits passes as a number."""
        text = "".join(row)
        if "_" in text or not text.isascii():
            strange = next(each for each in row if "_" in each or not each.isascii())
            raise self._no_number(line, strange)
        if not all(row):
            row = [each if each.strip() or name else "nan" for each, name in zip(row, names, strict=True)]
        if "," in text:
            commas = [each for each in row if "," in each]
            if self._comma is False or any("." in each or each.count(",") > 1 for each in row):
                raise self._unclear(line, commas[0])
            self._comma = True
            return [each.replace(",", ".") for each in row]
        if "." in text:
            if self._comma:
                raise self._unclear(line, next(each for each in row if "." in each))
            self._comma = False
        return row

    def _no_number(self, line: int, value: str) -> Refusal:
        problem = f"holds {value!r}; all its values must be numbers" if value else "has a value that is missing"
        return self._fault(problem, Kind.WRONG_TYPE, f"line {line}")

    def _unclear(self, line: int, value: str) -> Refusal:
        problem = f"holds {value!r}; decimals must begin with a point everywhere, or with a comma everywhere"
        return self._fault(problem, Kind.WRONG_TYPE, f"line {line}")

    def _fault(self, problem: str, kind: Kind = Kind.UNREADABLE, field: str = "") -> Refusal:
        return self._refusal(problem, kind=kind, file=self._path, field=field)
