"""CSV files are read row by row, and refused where they are none."""

from __future__ import annotations

from pathlib import Path

import pytest
from refusals import refused

from geometry.ground.csv_files import Table, read_csv
from geometry.ground.refusal import Kind, Refusal


def table(path: Path, content: bytes) -> Table:
    path.write_bytes(content)
    return read_csv(path, "a CSV file", Refusal)


@pytest.mark.parametrize("content", [b"\xef\xbb\xbf# a: 1\n# b\r\nx,y\n\n1,2\r\n3", b'# a: 1\n# b\n"x","y"\n1,2\n3\n'])
def test_remarks_head_and_rows_are_told_apart(content: bytes, tmp_path: Path) -> None:
    found = table(tmp_path / "given.csv", content)
    assert (found.remarks, found.head) == (("a: 1", "b"), ("x", "y"))
    assert list(found.rows) == [["1", "2"], ["3"]]


def test_an_empty_file_has_no_head(tmp_path: Path) -> None:
    found = table(tmp_path / "given.csv", b"")
    assert (found.remarks, found.head, list(found.rows)) == ((), (), [])


@pytest.mark.parametrize("content", [b"x,y\n\xff\xfe\n", b"x" * 4_000_001, b"x,y\n" + b"z" * 200_000])
def test_what_is_no_table_is_refused_where_it_is_read(content: bytes, tmp_path: Path) -> None:
    with refused(Kind.UNREADABLE, file="given.csv"):
        list(table(tmp_path / "given.csv", content).rows)
