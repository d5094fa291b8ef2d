"""Arrays read without Zarr: the same values as Zarr reads, and damage that is told."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import zarr

from studies.output.checked_store import create_checked
from studies.output.plain_array import Damage, PlainArray


def opened(folder: Path) -> PlainArray | None:
    return PlainArray.of(folder, json.loads((folder / "zarr.json").read_text(encoding="utf-8")))


def made(path: Path, values: np.ndarray, kind: str, rows: int, fill: Any = None) -> Path:
    group = zarr.open_group(path, mode="w", zarr_format=3)
    dims = ("case", "more")[: values.ndim]
    create_checked(group, "values", values.shape, kind, (rows, *values.shape[1:]), dims, {}, fill)[:] = values
    return path / "values"


@pytest.mark.parametrize(
    ("values", "kind"),
    [
        (np.array([1.5, np.nan, -np.inf, 0.0, 1e-300]), "float64"),
        (np.array([-3, 2**62, 0]), "int64"),
        (np.array([2, 1, 0, -1], np.int8), "int8"),
        (np.arange(12, dtype=np.uint64).reshape(4, 3) + np.uint64(2**63), "uint64"),
        (np.array(["", "silicone", "5 µm, π", "a\nb"], object), "string"),
        (np.zeros(0), "float64"),
    ],
)
@pytest.mark.parametrize("rows", [1, 3, 100])
def test_values_are_those_that_zarr_reads(values: np.ndarray, kind: str, rows: int, tmp_path: Path) -> None:
    folder = made(tmp_path / "store.zarr", values, kind, rows)
    array, expected = opened(folder), np.asarray(zarr.open_array(folder, mode="r")[:])
    assert array is not None
    for first, stop in ((0, len(values)), (1, 3), (2, 2), (0, 1000)):
        found = array.part(first, stop)
        assert np.array_equal(found, expected[first:stop], equal_nan=kind == "float64")
        assert found.dtype == (object if kind == "string" else expected.dtype)


def test_what_was_not_written_is_the_fill_value(tmp_path: Path) -> None:
    for kind, values, fill in (("float64", np.ones(4), np.nan), ("string", np.array(["x"] * 4, object), "-")):
        folder = made(tmp_path / kind, values, kind, 2, fill)
        (folder / "c" / "1").unlink()
        array = opened(folder)
        assert array is not None
        np.testing.assert_array_equal(array.part(0, 4), [*values[:2], fill, fill])


@pytest.mark.parametrize("change", ["flipped", "cut", "empty"])
def test_a_damaged_chunk_is_told(change: str, tmp_path: Path) -> None:
    folder = made(tmp_path / "store.zarr", np.arange(50.0), "float64", 50)
    content = bytearray((folder / "c" / "0").read_bytes())
    content[len(content) // 2] ^= 4
    place = folder / "c" / "0"
    place.write_bytes({"flipped": content, "cut": content[:20], "empty": b""}[change])
    array = opened(folder)
    assert array is not None
    with pytest.raises(Damage, match="its CRC-32C is not that of its bytes"):
        array.part(0, 50)


def test_arrays_that_others_wrote_are_left_to_zarr(tmp_path: Path) -> None:
    group = zarr.open_group(tmp_path / "store.zarr", mode="w", zarr_format=3)
    group.create_array("plain", shape=(4,), dtype="float64", compressors=None)[:] = 1.0
    group.create_array("single", shape=(4,), dtype="float32")[:] = 1.0
    assert [opened(tmp_path / "store.zarr" / name) for name in ("plain", "single")] == [None, None]
