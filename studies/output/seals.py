"""Seals of the blocks of a store: of which store, array and block the values are, beside the values themselves.

A CRC-32C in a chunk says that its bytes are those that were written, not where. A seal is a hash of the store's
identity, the name of the array, the number of the block and the values: a chunk of another store, of another array or
of another block does not match. Seals lie in an array of the store, a chunk for each block.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from studies.output.checked_store import CheckedStore, create_checked, values_digest

SEALS = "seals"
"""Array of the seals, (n_block, n_array) uint64."""


def create_seals(group: Any, blocks: int, names: Sequence[str]) -> None:
    """New array for the seals of a store; no block has one yet.

    Args:
        group: the Zarr group.
        blocks: how many there are.
        names: of the arrays that are filled block by block.
    """
    title = f"seals of {', '.join(names)}: which store, array and block the values are of"
    shape = (blocks, len(names))
    create_checked(group, SEALS, shape, "uint64", (1, len(names)), ("block", "sealed"), {"long_name": title}, 0)


class Seals:
    """Seals of a store; those of older versions have none, and whatever is in them passes.

    Args:
        stored: the store.
        names: of the arrays that are filled block by block, as they were created.
        writing: whether blocks will be written.
    """

    def __init__(self, stored: CheckedStore, names: Sequence[str], writing: bool = False) -> None:
        self._stored, self._names = stored, tuple(names)
        self._array = stored.array(SEALS, writing) if stored.identity else None

    def rows(self, blocks: slice) -> NDArray[np.uint64]:
        """Seals of blocks, (n_block, n_array) uint64; none for older stores.

        Raises:
            Exception: by the store's ``refusal``: seals are damaged or have another shape.
        """
        if self._array is None:
            return np.zeros((0, len(self._names)), np.uint64)
        return np.asarray(self._stored.part(self._array, SEALS, blocks), np.uint64)

    def write(self, block: int, values: Mapping[str, NDArray[Any]]) -> None:
        """Seal a block.

        Args:
            block: its number.
            values: of every array, all that the block holds.
        """
        if self._array is not None:
            self._array[block] = np.array([self._seal(name, block, values[name]) for name in self._names], np.uint64)

    def check(self, block: int, values: Mapping[str, NDArray[Any]], row: NDArray[np.uint64] | None = None) -> None:
        """Refuse a block of which anything is of another place.

        Args:
            block: its number.
            values: of some arrays, all that the block holds.
            row: its seals, where they are read already; (n_array,) uint64.

        Raises:
            Exception: by the store's ``refusal``; names the array.
        """
        if self._array is None:
            return
        found = self.rows(slice(block, block + 1))[0] if row is None else row
        for name, each in values.items():
            if found[self._names.index(name)] != self._seal(name, block, each):
                where = f"{self._stored.path}: {name}: chunk {block}"
                raise self._stored.refusal(f"{where} is not what was written there: of another store, array or place")

    def _seal(self, name: str, block: int, values: NDArray[Any]) -> int:
        place = json.dumps([self._stored.identity, name, block, values_digest(values)])
        return int.from_bytes(hashlib.sha256(place.encode()).digest()[:8], "big")
