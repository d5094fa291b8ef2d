"""Stores of sweeps held against each other."""

from __future__ import annotations

import filecmp
from collections.abc import Iterator
from pathlib import Path


def assert_same_store(one: Path, other: Path) -> None:
    """Every file of two stores is the same, byte for byte."""

    def walk(compared: filecmp.dircmp[str]) -> Iterator[str]:
        yield from (*compared.left_only, *compared.right_only, *compared.funny_files)
        _, differ, broken = filecmp.cmpfiles(compared.left, compared.right, compared.common_files, shallow=False)
        yield from (*differ, *broken)
        for below in compared.subdirs.values():
            yield from walk(below)

    assert list(walk(filecmp.dircmp(one, other, ignore=[]))) == []
