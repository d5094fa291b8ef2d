"""Columns of a data set of touches as files have them: names, axes, units."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from localize.datasets.touch_dataset import TouchBatch

if TYPE_CHECKING:
    from torch import Tensor

#: Format of the shards of a data set.
FileFormat = Literal["npz", "parquet", "webdataset", "zarr"]
Columns = Mapping[str, NDArray[Any]]
"""Samples by column, (n_sample, ...) each."""


class Column(NamedTuple):
    """A column of the files."""

    axes: tuple[str, ...]
    """Axes behind the samples."""
    unit: str
    """Unit; 1 for numbers without one."""
    text: str
    """What it holds."""


COLUMNS = {
    "signals": Column(("microphone", "time"), "Pa", "pressure at the microphones, 1000 samples at 1 kHz"),
    "point": Column((), "1", "touched point, from 1"),
    "position": Column(("axis",), "mm", "middle of its membrane in plan, x and y"),
    "parameters": Column(("parameter",), "as named", "parameters of the design"),
    "points": Column(("any_point",), "1", "mask of the points that the array has"),
    "microphones": Column(("microphone",), "1", "mask of the microphones that the array has"),
    "kind": Column((), "1", "kind of the touch, an index into kinds"),
    "case": Column((), "1", "number of the design"),
    "index": Column((), "1", "number of the sample among those of its design, from 0"),
}
"""Columns in the order of the files. Maps in place of signals: axes map, frequency, time; no unit."""


def columns_of(batch: TouchBatch) -> dict[str, NDArray[Any]]:
    """Samples as the files hold them, (n_sample, ...) each, without empty columns such as the parameters of a library.

    Integers have 4 bytes, but for the number of the sample, and masks are bytes.
    """
    kept = {"case": np.int32, "point": np.int32, "kind": np.int32, "points": np.uint8, "microphones": np.uint8}
    tensors = cast("dict[str, Tensor]", batch)
    return {
        name: np.ascontiguousarray(tensors[name].numpy(), dtype=kept.get(name))
        for name in COLUMNS
        if tensors[name][:1].numel()
    }
