"""Arrays of a store read without Zarr, which takes longer to load than all else that a list of the best designs needs.

Read are those that :func:`studies.output.checked_store.create_checked` writes, by the specification of Zarr 3: chunks
cut along the first axis, each the bytes of its values, or texts by the registered codec ``vlen-utf8``, compressed by
Zstandard (RFC 8878), then a CRC-32C of that (RFC 3720).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from geometry.files.ordinary import read_bytes

_CHECKSUM = 4
_NUMBERS = ("int8", "int64", "uint64", "float64")
_KEYS = {"name": "default", "configuration": {"separator": "/"}}


class Damage(Exception):
    """What is wrong with a chunk."""


@dataclass(frozen=True)
class PlainArray:
    """Array whose chunks are as :func:`studies.output.checked_store.create_checked` has them."""

    folder: Path
    """Folder of the array."""
    shape: tuple[int, ...]
    """Shape of all values."""
    rows: int
    """Number of rows of a chunk."""
    kind: str
    """Type of the values, ``string`` for texts."""
    fill: Any
    """Value of what was not written."""

    @classmethod
    def of(cls, folder: Path, document: Mapping[str, Any]) -> PlainArray | None:
        """The array of a folder, None where it is written in another way.

        Args:
            folder: of the array.
            document: its ``zarr.json``.
        """
        shape, kind = tuple(document["shape"]), str(document.get("data_type"))
        grid = document.get("chunk_grid") or {}
        chunk = (grid.get("configuration") or {}).get("chunk_shape") or [0]
        codecs = [each.get("name") for each in document.get("codecs") or ()]
        first = "vlen-utf8" if kind == "string" else "bytes"
        ours = (
            kind in ("string", *_NUMBERS)
            and grid.get("name") == "regular"
            and [*chunk[1:]] == [*shape[1:]]
            and chunk[0] > 0
            and document.get("chunk_key_encoding") == _KEYS
            and codecs == [first, "zstd", "crc32c"]
            and (document["codecs"][0].get("configuration") or {}).get("endian", "little") == "little"
        )
        return cls(folder, shape, chunk[0], kind, document.get("fill_value")) if ours else None

    def part(self, first: int, stop: int) -> NDArray[Any]:
        """Consecutive rows, (n, ...) in the type of the array, texts as objects.

        Raises:
            Exception: a chunk is damaged.
        """
        first, stop = max(first, 0), min(stop, self.shape[0])
        numbers = range(first // self.rows, -(-stop // self.rows)) if stop > first else range(0)
        chunks = [self._chunk(number) for number in numbers]
        values = np.concatenate(chunks) if chunks else self._filled(0)
        start = numbers.start * self.rows
        return values[first - start : stop - start]

    def _filled(self, rows: int) -> NDArray[Any]:
        fill = float(self.fill) if self.kind == "float64" else self.fill
        return np.full((rows, *self.shape[1:]), fill, object if self.kind == "string" else self.kind)

    def _chunk(self, number: int) -> NDArray[Any]:
        place = self.folder.joinpath("c", str(number), *["0"] * (len(self.shape) - 1))
        if not place.exists():
            return self._filled(self.rows)
        content = _decompressed(read_bytes(place, "a chunk", Damage))
        shape = self.rows, *self.shape[1:]
        if self.kind == "string":
            return _texts(content).reshape(shape)
        return np.frombuffer(content, np.dtype(self.kind).newbyteorder("<")).astype(self.kind).reshape(shape)


def _decompressed(content: bytes) -> bytes:
    """A chunk without its checksum and its compression."""
    import google_crc32c
    from numcodecs.zstd import decompress

    body = content[:-_CHECKSUM]
    if not body or google_crc32c.value(body) != int.from_bytes(content[-_CHECKSUM:], "little"):
        raise Damage("its CRC-32C is not that of its bytes")
    return bytes(decompress(body))


def _texts(content: bytes) -> NDArray[Any]:
    """Texts of a chunk, (n,) object: their number, then each with its length before it, whole numbers of 4 bytes."""
    count, place = int.from_bytes(content[:4], "little"), 4
    texts = np.empty(min(count, len(content)), object)
    for number in range(len(texts)):
        size = int.from_bytes(content[place : place + 4], "little")
        texts[number] = content[place + 4 : place + 4 + size].decode()
        place += 4 + size
    if place != len(content) or len(texts) != count:
        raise Damage("its texts are not as long as it says")
    return texts
