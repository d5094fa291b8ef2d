"""A plain Zarr store, for xarray and other programs, written file by file from values that are kept elsewhere.

The same values make the same files to the last byte. A file is written beside and renamed, so that whoever reads while
the store grows never sees half of one; files that are there already with the same content stay untouched.
"""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numcodecs import blosc
from numpy.typing import NDArray

from geometry.ground.record import packed, sha256, unpacked

#: Bytes of the checksum behind each chunk.
_CHECKSUM = 4
METADATA = "zarr.json"
"""File that says what a group or an array is."""


@dataclass(frozen=True, eq=False)
class Variable:
    """Variable of a store: all its values, or its shape where the values come block by block along the first axis."""

    dimensions: tuple[str, ...]
    """Names of the axes."""
    attributes: dict[str, str]
    """Attributes, such as ``units`` and ``long_name``."""
    values: NDArray[Any] | None = None
    """Values, numbers or texts, (n, ...) as ``dimensions`` names the axes; None where they come block by block."""
    shape: tuple[int, ...] = ()
    """Shape, where the values come block by block."""
    dtype: str = "float64"
    """Zarr's name of the type, where the values come block by block."""
    fill: float | str = np.nan
    """Value of what has not come yet, where the values come block by block."""

    def start(self) -> NDArray[Any]:
        """Values before any block has come, in the shape of the variable."""
        if self.values is not None:
            return self.values
        return np.full(self.shape, self.fill, object if self.dtype == "string" else self.dtype)


@dataclass(frozen=True, eq=False)
class Layout:
    """A store before its blocks come: what it says of itself, and the values that are known from the beginning."""

    attributes: dict[str, Any]
    """Attributes of the store, as JSON can hold them."""
    variables: dict[str, Variable]
    """Variables by name."""
    block: int
    """Rows of a block."""

    def packed(self) -> bytes:
        """The layout as the content of a record; :meth:`unpacked` is the way back."""
        rows = {name: replace(variable, values=None) for name, variable in self.variables.items()}
        about = {"attributes": self.attributes, "block": self.block, "variables": {k: vars(v) for k, v in rows.items()}}
        known = {name: variable.values for name, variable in self.variables.items() if variable.values is not None}
        return packed({name: each.astype(str) if each.dtype == object else each for name, each in known.items()}, about)

    @classmethod
    def unpacked(cls, content: bytes) -> Layout:
        """The layout that was packed."""
        arrays, about = unpacked(content)
        known = {name: each.astype(object) if each.dtype.kind == "U" else each for name, each in arrays.items()}
        variables = {
            name: Variable(**{**row, "dimensions": tuple(row["dimensions"]), "values": known.get(name)})
            for name, row in about["variables"].items()
        }
        return cls(about["attributes"], variables, about["block"])


def plain_attributes(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """Attributes as texts and numbers, which netCDF can hold too; tables, lists and truth values as JSON."""
    return {
        name: value if isinstance(value, (str, int, float)) and not isinstance(value, bool) else json.dumps(value)
        for name, value in attributes.items()
    }


class ZarrFiles:
    """Files of a Zarr store; each chunk is compressed and carries a CRC-32C, at which Zarr notices damage.

    Args:
        path: folder of the store.
        layout: what it holds.
    """

    def __init__(self, path: Path, layout: Layout) -> None:
        import zarr
        from zarr.codecs import BloscCodec, Crc32cCodec, ZstdCodec
        from zarr.storage import MemoryStore

        self.path, self.block = path, layout.block
        #: SHA-256 of each file that was written or found as it must be, by its name in the store.
        self.sums: dict[str, str] = {}
        self._memory: dict[str, Any] = {}
        self._growing: dict[str, Any] = {}
        store = MemoryStore(self._memory)
        group = zarr.open_group(store, mode="w", zarr_format=3, attributes=plain_attributes(layout.attributes))
        below = dict.fromkeys(name.rpartition("/")[0] for name in layout.variables if "/" in name)
        for name in below:
            group.create_group(name)
        for name, variable in layout.variables.items():
            values = variable.values
            shape = variable.shape if values is None else values.shape
            more: Any = {"dtype": variable.dtype, "fill_value": variable.fill}
            if values is not None:
                more = {"dtype": "string" if values.dtype == object else str(values.dtype)}
            compressor: Any = ZstdCodec(level=0)
            if len(shape) > 1:  # responses change little along the frequency: the bytes of equal weight lie together
                size = np.dtype(variable.dtype).itemsize
                compressor = BloscCodec(typesize=size, cname="lz4", clevel=1, shuffle="shuffle")
            array: Any = group.create_array(
                name, shape=shape, chunks=shape if values is not None else (min(self.block, shape[0]), *shape[1:]),
                dimension_names=variable.dimensions, attributes=plain_attributes(variable.attributes),
                compressors=(compressor, Crc32cCodec()), config={"write_empty_chunks": True}, **more,
            )  # fmt: skip
            if values is None:
                self._growing[name] = array
            else:
                array[...] = values
        with warnings.catch_warnings():  # it says that the third version of the format has not settled how
            warnings.filterwarnings("ignore", "Consolidated metadata is currently not part", UserWarning)
            for name in (*below, ""):
                zarr.consolidate_metadata(store, path=name, zarr_format=3)  # where other programs look first
        self._write()

    def put(self, first: int, values: Mapping[str, NDArray[Any]]) -> dict[str, str]:
        """Write one block of some variables.

        Args:
            first: number of its first row.
            values: of variables that come block by block; rows first.

        Returns:
            SHA-256 of the file of each variable, by its name.
        """
        for name, each in values.items():
            self._growing[name][first : first + len(each)] = each
        self._write()
        return {name: self.sums[self.chunk(name, first)] for name in values}

    def chunk(self, name: str, first: int) -> str:
        """Name in the store of the file with the block of a variable that begins with a row."""
        return chunk_name(name, self._growing[name].ndim, first // self.block)

    def drop(self, first: int) -> None:
        """Remove what is there of the block that begins with a row; it reads as fill values from now on."""
        for name in self._growing:
            self.path.joinpath(self.chunk(name, first)).unlink(missing_ok=True)

    def _write(self) -> None:
        for name in sorted(self._memory):
            content: bytes = self._memory.pop(name).to_bytes()
            self.sums[name] = sha256(content)
            path = self.path / name
            if path.is_file() and path.stat().st_size == len(content) and path.read_bytes() == content:
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            beside = path.with_name(f"{path.name}.partial")
            beside.unlink(missing_ok=True)  # whatever is there, such as a link, which would be followed
            beside.write_bytes(content)
            os.replace(beside, path)


def chunk_name(name: str, dimensions: int, block: int) -> str:
    """Name in a store of the file of one block of a variable.

    Args:
        name: of the variable.
        dimensions: number of its axes.
        block: number of the block, from 0.
    """
    return "/".join([name, "c", str(block), *["0"] * (dimensions - 1)])


def read_dense(content: bytes, variable: Variable, block: int) -> NDArray[Any]:
    """Values of a chunk with more than one axis, from the content of its file, which is the one that was written.

    Args:
        content: of the file.
        variable: the variable.
        block: rows of a chunk.

    Returns:
        (n, n_freq) float64 or float32, or any shape of more axes; rows beyond the last hold the fill value.
    """
    values = np.frombuffer(blosc.decompress(content[:-_CHECKSUM]), np.dtype(variable.dtype).newbyteorder("<"))
    return values.reshape(min(block, variable.shape[0]), *variable.shape[1:])
