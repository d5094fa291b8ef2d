"""netCDF-4 files, also those of SOFA, of which damage is noticed before HDF5 reads them.

HDF5 follows what a damaged file says: it may answer with other numbers, end the process, or loop for ever. So a file
that this program wrote is sealed (:func:`geometry.ground.record.seal_file`). Other programs read past the seal, and
take it away when they change the file. A file without a seal is first read in a process of its own, for a limited time
and with limited memory.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import h5netcdf

from geometry.ground.file_checks import library_reads, ordinary_file
from geometry.ground.foreign_files import PATIENCE, read_apart
from geometry.ground.record import file_is_sealed
from geometry.ground.refusal import Kind, Refusal

#: Most bytes of a file, and of its arrays: those of 1000 points, 10 microphones and 2000 frequencies.
_LARGEST = 2_000_000_000
T = TypeVar("T")


def read_netcdf(path: Path, what: str, refusal: type[Refusal], take: Callable[[Any], T]) -> T:
    """The result of reading a netCDF-4 file whose bytes are those that were written, or that was tried.

    Args:
        path: the file.
        what: such as ``a SOFA file``, for messages.
        refusal: class of the error.
        take: reads from the open ``h5netcdf.File``; nothing of it is used once the file is closed.

    Raises:
        Refusal: of that class: no ordinary file, not netCDF, damaged, cut short, or one that takes too long or too
            much memory to read.
    """
    ordinary_file(path, what, refusal, _LARGEST)
    intact = file_is_sealed(path)
    if intact is None:
        _try_apart(path, what, refusal)
    elif not intact:
        raise refusal("is damaged: its bytes are not those that were written (SHA-256)", kind=Kind.DAMAGED, file=path)
    with library_reads(path, what, refusal), h5netcdf.File(path, "r") as file:
        return take(file)


def _try_apart(path: Path, what: str, refusal: type[Refusal]) -> None:
    """Read all of a file in a process that may take too long, or be ended by it."""
    read_apart(_trial, path, what, refusal, 2 * _LARGEST, PATIENCE)


def _trial(path: str) -> bytes:
    """Read every value and attribute, those of the arrays after their sizes were summed; nothing is returned."""
    with h5netcdf.File(path, "r") as file:
        size = sum(math.prod(one.shape) * getattr(one.dtype, "itemsize", 64) for one in file.variables.values())
        if size > _LARGEST:
            problem = f"its arrays would take {size} bytes, and must take at most {_LARGEST}"
            raise Refusal(problem, kind=Kind.OUT_OF_RANGE)
        for one in (file, *file.variables.values()):
            dict(one.attrs)
        for one in file.variables.values():
            one[...]
    return b""
