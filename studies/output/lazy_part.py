"""Arrays of a store that are read where they are used, as xarray asks for them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from xarray.backends import BackendArray
from xarray.core.indexing import ExplicitIndexer, IndexingSupport, explicit_indexing_adapter

from studies.output.checked_store import CheckedStore
from studies.output.seals import Seals


class LazyPart(BackendArray):
    """An array that is read where it is used, and refused where it is damaged or of another place.

    Args:
        stored: the store.
        name: of the array.
        sealed: names of all arrays that are sealed with it, block by block.
        block: number of cases per block.
        waiting: whether each case waits, (n_case,) bool; it is NaN whatever lies there.
    """

    def __init__(
        self, stored: CheckedStore, name: str, sealed: Sequence[str], block: int, waiting: NDArray[np.bool_]
    ) -> None:
        self._stored, self._name, self._array = stored, name, stored.array(name)
        self._seals, self._size, self._waiting = Seals(stored, list(sealed)), block, waiting
        self.shape, self.dtype = self._array.shape, self._array.dtype

    def __getitem__(self, key: ExplicitIndexer) -> NDArray[Any]:
        return np.asarray(explicit_indexing_adapter(key, self.shape, IndexingSupport.BASIC, self._read))

    def _read(self, part: tuple[Any, ...]) -> NDArray[Any]:
        wanted = np.arange(len(self._waiting))[part[0]]
        computed = np.atleast_1d(wanted)[~np.atleast_1d(self._waiting[wanted])]
        for block in np.unique(computed // self._size).tolist():
            rows = slice(block * self._size, (block + 1) * self._size)
            self._seals.check(block, {self._name: self._stored.part(self._array, self._name, rows)})
        values = np.array(self._stored.part(self._array, self._name, part))
        values[self._waiting[wanted]] = np.nan
        return values
