"""Shards of a data set in four formats that programs of others read: NPZ, Parquet, WebDataset, Zarr.

The same samples make the same bytes, so that a writing that was stopped ends as one that was not.
"""

from __future__ import annotations

import io
import json
import tarfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Protocol, get_args

import numpy as np
from numpy.typing import NDArray

from geometry.ground.record import sha256
from geometry.ground.whole_files import whole_file
from studies.datasets.columns import COLUMNS, Columns, FileFormat
from studies.output.zarr_files import Layout, Variable, ZarrFiles

#: Formats of shards.
FORMATS: tuple[FileFormat, ...] = get_args(FileFormat)


class ShardWriter(Protocol):
    """Writer of the shards of one split."""

    def files(self, number: int) -> list[str]:
        """Names of the files of a shard, below the folder of the data set."""

    def write(self, number: int, columns: Columns) -> dict[str, str]:
        """Write a shard, each file whole or not at all; hands out the SHA-256 of each of its files, by name."""


class OneFileShards:
    """Shards that are a file each, such as ``train-00003.npz``."""

    def __init__(self, file_format: FileFormat, folder: Path, split: str) -> None:
        self.suffix, self._content = ONE_FILE[file_format]
        self.folder, self.split = folder, split

    def files(self, number: int) -> list[str]:
        """Name of the file of a shard."""
        return [f"{self.split}-{number:05d}{self.suffix}"]

    def write(self, number: int, columns: Columns) -> dict[str, str]:
        """Write the file of a shard."""
        (name,) = self.files(number)
        content = self._content(columns)
        with whole_file(self.folder / name) as beside:
            beside.write_bytes(content)
        return {name: sha256(content)}


def npz_bytes(columns: Columns) -> bytes:
    """NumPy archive, an array for each column; not compressed, because signals with noise cannot be."""
    buffer = io.BytesIO()
    arrays: dict[str, Any] = dict(columns)
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def parquet_bytes(columns: Columns) -> bytes:
    """Parquet file; a column of several numbers a sample is a flat list of fixed length, in C order."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    made = {}
    for name, values in columns.items():
        flat = pa.array(np.ascontiguousarray(values).reshape(-1))
        made[name] = flat if values.ndim == 1 else pa.FixedSizeListArray.from_arrays(flat, _width(values))
    shapes = {name: json.dumps(values.shape[1:]) for name, values in columns.items()}
    table = pa.table(made).replace_schema_metadata({f"shape of {name}": shape for name, shape in shapes.items()})
    buffer = io.BytesIO()
    pq.write_table(table, buffer, compression="zstd")
    return buffer.getvalue()


def tar_bytes(columns: Columns) -> bytes:
    """Tar file as WebDataset reads it: of each sample ``CASE-INDEX.signals.npy`` and ``CASE-INDEX.json``."""
    buffer = io.BytesIO()
    facts = [name for name in columns if name != "signals"]
    with tarfile.open(fileobj=buffer, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for row, signals in enumerate(columns["signals"]):
            key = f"{int(columns['case'][row]):07d}-{int(columns['index'][row]):010d}"
            array = io.BytesIO()
            np.save(array, signals)
            _add(tar, f"{key}.signals.npy", array.getvalue())
            about = {name: _plain(columns[name][row]) for name in facts}
            _add(tar, f"{key}.json", json.dumps(about).encode())
    return buffer.getvalue()


#: Formats with a file for each shard: suffix, and function that makes its content.
ONE_FILE: Mapping[str, tuple[str, Callable[[Columns], bytes]]] = {
    "npz": (".npz", npz_bytes),
    "parquet": (".parquet", parquet_bytes),
    "webdataset": (".tar", tar_bytes),
}


class ZarrShards:
    """One Zarr store for a split, such as ``train.zarr``, a chunk of each column for a shard."""

    def __init__(self, folder: Path, split: str, rows: int, count: int, columns: Columns) -> None:
        self.name, self.rows = f"{split}.zarr", rows
        variables = {
            name: Variable(
                ("sample", *COLUMNS[name].axes[: values.ndim - 1]),
                {"long_name": COLUMNS[name].text, "units": COLUMNS[name].unit},
                shape=(count, *values.shape[1:]),
                dtype=str(values.dtype),
                fill=0,
            )
            for name, values in columns.items()
        }
        self._files = ZarrFiles(folder / self.name, Layout({"title": f"touches, {split}"}, variables, rows))
        self._axes = {name: values.ndim for name, values in columns.items()}
        #: SHA-256 of what says what the arrays are.
        self.described = {f"{self.name}/{name}": digest for name, digest in self._files.sums.items()}

    def files(self, number: int) -> list[str]:
        """Names of the chunks of a shard."""
        return [f"{self.name}/{name}/c/{number}" + "/0" * (axes - 1) for name, axes in self._axes.items()]

    def write(self, number: int, columns: Columns) -> dict[str, str]:
        """Write the chunks of a shard."""
        self._files.put(number * self.rows, columns)
        return {name: self._files.sums[name.removeprefix(f"{self.name}/")] for name in self.files(number)}


def writer_of(
    file_format: FileFormat, folder: Path, split: str, rows: int, count: int, columns: Columns
) -> ShardWriter:
    """Writer of a split.

    Args:
        file_format: one of :data:`FORMATS`.
        folder: of the data set.
        split: name of the split.
        rows: samples of a shard.
        count: samples of the split.
        columns: a few samples, of which names, types and shapes count.
    """
    if file_format == "zarr":
        return ZarrShards(folder, split, rows, count, columns)
    return OneFileShards(file_format, folder, split)


def _width(values: NDArray[Any]) -> int:
    return int(np.prod(values.shape[1:]))


def _plain(value: Any) -> Any:
    """Numbers as JSON has them: null in place of one that is not finite."""
    if np.ndim(value):
        return [_plain(each) for each in value]
    number = value.item()
    return number if np.isfinite(number) else None


def _add(tar: tarfile.TarFile, name: str, content: bytes) -> None:
    entry = tarfile.TarInfo(name)
    entry.size = len(content)
    tar.addfile(entry, io.BytesIO(content))
