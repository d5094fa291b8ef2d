"""A disc that was solved once is the same from memory and from disk, and a damaged file is solved again."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

from acoustic_fem.membrane import solved_discs
from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.numerics.disk_cache import CacheWarning

SHAPE = DiscShape(0.3, 0.49, 0.4, 0.4, 0.0, 0.25)


def same(one: ElasticDisc, other: ElasticDisc) -> bool:
    return all(np.array_equal(getattr(one, each.name), getattr(other, each.name)) for each in fields(one))


def test_a_disc_from_disk_is_the_one_that_was_solved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[DiscShape] = []

    def counted(shape: DiscShape, refinement: int) -> ElasticDisc:
        asked.append(shape)
        return solve_dimensionless(shape, refinement)

    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    monkeypatch.setattr(solved_discs, "solve_dimensionless", counted)
    found = solved_discs.solved_disc.__wrapped__  # without the memory of this process
    first, again, coarser = found(SHAPE, 2), found(SHAPE, 2), found(SHAPE, 1)
    assert same(first, again)
    assert not same(first, coarser)
    assert len(asked) == 2
    for file in tmp_path.iterdir():
        file.write_bytes(file.read_bytes()[:-9])
    with pytest.warns(CacheWarning, match="is damaged"):
        assert same(found(SHAPE, 2), first)
    assert len(asked) == 3
