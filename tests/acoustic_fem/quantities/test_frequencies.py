"""Frequencies as a text: even steps, a constant ratio, a file; and what is none of these."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.quantities.checks import frequencies, frequency_grid
from geometry.ground.refusal import Kind, Refusal


def test_a_text_gives_even_steps_or_a_constant_ratio() -> None:
    assert np.array_equal(frequency_grid("1:100:100"), np.arange(1.0, 101.0))
    spread = frequency_grid("log:1:500:100")
    assert (spread[0], spread[-1], len(spread)) == (1.0, 500.0, 100)
    assert np.ptp(spread[1:] / spread[:-1]) < 1e-12


@pytest.mark.parametrize("text", ["1\n2.5\n# until here\n10 100\n", "1, 2.5,10 # Hz\n100"])
@pytest.mark.parametrize("name", ["grid.txt", "GRID.CSV"])
def test_a_file_lists_frequencies(tmp_path: Path, text: str, name: str) -> None:
    path = tmp_path / name
    path.write_text(text)
    assert frequency_grid(str(path)).tolist() == [1, 2.5, 10, 100]
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), str(path), "lumped")
    assert library.frequency.tolist() == [1, 2.5, 10, 100]


@pytest.mark.parametrize("text", ["40:40:1", "log:40:40:1"])
def test_one_frequency_is_stated_as_first_and_last(text: str) -> None:
    assert frequency_grid(text) == pytest.approx([40.0], rel=1e-12)


@pytest.mark.parametrize("heading", ["frequency", "Frequency (Hz)", '"frequency, Hz"', "\n# a remark\nf / Hz  # 1"])
def test_a_list_may_have_a_heading(tmp_path: Path, heading: str) -> None:
    path = tmp_path / "grid.csv"
    path.write_text(f"{heading}\n1\n2.5,\n\n10 # Hz\n")
    assert frequency_grid(str(path)).tolist() == [1, 2.5, 10]
    assert frequencies(str(path)).tolist() == [1, 2.5, 10]


def test_a_second_column_or_heading_is_refused_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "grid.csv"
    for text, value in (
        ("frequency,level\n1,2\n3,4\n", "1 2"),
        ("frequency\nHz\n1\n", "Hz"),
        ("frequency 2\n1\n", "frequency"),
    ):
        path.write_text(text)
        with refused(Kind.WRONG_TYPE, "frequency", value, file=path):
            frequency_grid(str(path))
    path.write_text("frequency\n")
    with refused(Kind.OUT_OF_RANGE, file=path):
        frequency_grid(str(path))


@pytest.mark.parametrize("content", ["1\n3\n2\n", "1\n1\n", "frequency\n1\n5000\n", "nan\n1\n"])
def test_numbers_that_are_no_grid_are_refused_with_the_file_that_lists_them(tmp_path: Path, content: str) -> None:
    path = tmp_path / "grid.csv"
    path.write_text(content)
    with refused(Kind.OUT_OF_RANGE, "frequency", file=path):
        frequency_grid(str(path))


def test_a_number_that_is_no_frequency_is_refused_with_its_file(tmp_path: Path) -> None:
    path = tmp_path / "grid.txt"
    path.write_text("3 -1 2")
    with refused(Kind.OUT_OF_RANGE, "frequency", file=path):
        frequencies(str(path))


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("1:100", Kind.WRONG_TYPE),
        ("log:1:100", Kind.WRONG_TYPE),
        ("lin:1:100:5", Kind.WRONG_TYPE),
        ("log:log:1:100:5", Kind.WRONG_TYPE),
        ("1:100:0", Kind.OUT_OF_RANGE),
        ("log:0:100:5", Kind.OUT_OF_RANGE),
        ("log:-1:-100:5", Kind.OUT_OF_RANGE),
        ("log:100:1:5", Kind.OUT_OF_RANGE),
        ("log:nan:100:5", Kind.OUT_OF_RANGE),
        ("log:1:500:1", Kind.OUT_OF_RANGE),
        ("1:500:1", Kind.OUT_OF_RANGE),
    ],
)
def test_another_text_is_refused(text: str, kind: Kind) -> None:
    with pytest.raises(Refusal) as found:
        frequency_grid(text)
    assert (found.value.kind, found.value.field) == (kind, "frequency")


@pytest.mark.parametrize(
    ("content", "kind", "field"),
    [(b"", Kind.OUT_OF_RANGE, ""), (b"1 2 x", Kind.WRONG_TYPE, "frequency"), (b"\xff\xff1", Kind.UNREADABLE, ""),
     (b"3 2 1", Kind.OUT_OF_RANGE, "frequency"), (b"1 nan", Kind.OUT_OF_RANGE, "frequency")],
)  # fmt: skip
def test_a_bad_list_is_refused(tmp_path: Path, content: bytes, kind: Kind, field: str) -> None:
    path = tmp_path / "grid.txt"
    path.write_bytes(content)
    with pytest.raises(Refusal) as found:
        frequency_grid(str(path))
    assert (found.value.kind, found.value.field) == (kind, field)
    with pytest.raises(Refusal) as found:
        frequency_grid(str(tmp_path / "none.txt"))
    assert found.value.kind is Kind.MISSING
