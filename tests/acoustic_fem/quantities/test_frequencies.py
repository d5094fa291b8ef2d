"""Frequencies as a text: even steps, a constant ratio, a file; and what is none of these."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import acoustic_fem
import geometry
from acoustic_fem.quantities.checks import frequency_grid
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
    ],
)
def test_another_text_is_refused(text: str, kind: Kind) -> None:
    with pytest.raises(Refusal) as refused:
        frequency_grid(text)
    assert (refused.value.kind, refused.value.field) == (kind, "frequency")


@pytest.mark.parametrize(
    ("content", "kind", "field"),
    [(b"", Kind.OUT_OF_RANGE, ""), (b"1 2 x", Kind.WRONG_TYPE, "frequency"), (b"\xff\xff1", Kind.UNREADABLE, ""),
     (b"3 2 1", Kind.OUT_OF_RANGE, "frequency"), (b"1 nan", Kind.OUT_OF_RANGE, "frequency")],
)  # fmt: skip
def test_a_bad_list_is_refused(tmp_path: Path, content: bytes, kind: Kind, field: str) -> None:
    path = tmp_path / "grid.txt"
    path.write_bytes(content)
    with pytest.raises(Refusal) as refused:
        frequency_grid(str(path))
    assert (refused.value.kind, refused.value.field) == (kind, field)
    with pytest.raises(Refusal) as refused:
        frequency_grid(str(tmp_path / "none.txt"))
    assert refused.value.kind is Kind.MISSING
