"""MAT files of version 7.3, which are HDF5 files: read by h5py, after a process of its own has tried it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from geometry.ground.file_checks import library_reads
from geometry.ground.foreign_files import read_apart
from geometry.ground.refusal import Kind, Refusal

_SIGN = b"MATLAB 7.3 MAT-file"
#: Memory that the process may take in which a file is tried, bytes.
_MEMORY = 4_000_000_000


def is_hdf5_mat(path: Path) -> bool:
    """True for a file that begins as MATLAB's version 7.3 or as HDF5 does."""
    with path.open("rb") as file:
        head = file.read(520)
    return head.startswith((_SIGN, b"\x89HDF\r\n")) or head[512:516] == b"\x89HDF"


def read_hdf5_mat(path: Path, what: str, refusal: type[Refusal], most_numbers: int) -> dict[str, NDArray[Any]]:
    """Arrays of numbers by name, in the shape of what was saved; texts, structures and cells are passed over.

    Args:
        path: the file.
        what: such as ``a MAT file``, for messages.
        refusal: class of the errors.
        most_numbers: that a file may hold.

    Raises:
        Refusal: by ``refusal``: not HDF5, damaged, of more numbers, or one that takes too long to read.
    """
    if read_apart(_trial, path, what, refusal, _MEMORY, arguments=(most_numbers,)):
        raise refusal(
            f"holds more than {most_numbers} numbers, the most that are read", kind=Kind.OUT_OF_RANGE, file=path
        )
    with library_reads(path, what, refusal), h5py.File(path, "r") as file:
        return {name: np.asarray(one[()]).T for name, one in _arrays(file)}


def _arrays(file: h5py.File) -> list[tuple[str, h5py.Dataset]]:
    """Data sets of numbers at the top of a file."""
    found = [(name, file.get(name)) for name in file if not name.startswith("#")]
    return [
        (name, one)
        for name, one in found
        if isinstance(one, h5py.Dataset)
        and one.attrs.get("MATLAB_class", b"double") not in (b"char", b"cell", b"struct")
        and not one.attrs.get("MATLAB_empty", 0)
        and one.dtype.kind in "biufcV"
    ]


def _trial(path: str, most_numbers: int) -> bytes:
    """In the process: read every array; something where they hold more numbers than may be, nothing else."""
    with h5py.File(path, "r") as file:
        arrays = _arrays(file)
        if sum(math.prod(one.shape) for _, one in arrays) > most_numbers:
            return b"more"
        for _, one in arrays:
            one[()]
    return b""
