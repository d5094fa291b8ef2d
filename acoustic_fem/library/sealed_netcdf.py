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

from geometry.ground.child import Child
from geometry.ground.file_checks import library_reads, ordinary_file
from geometry.ground.process_messages import ChildError, Limits
from geometry.ground.record import file_is_sealed
from geometry.ground.refusal import Kind, Refusal, said_by

#: Most bytes of a file, and of its arrays: those of 1000 points, 10 microphones and 2000 frequencies.
_LARGEST = 2_000_000_000
#: Time that the process may take in which a file without a seal is tried, s.
_PATIENCE = 20.0
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
    try:
        with Child("the reader", limits=Limits(memory=2 * _LARGEST), quiet=True, trusted=False) as child:
            said = child.call(_trial, str(path), seconds=_PATIENCE).decode()
    except ChildError as error:
        if error.status is None:
            problem = f"cannot be read in {_PATIENCE:g} s; it is damaged, or not {what}"
            raise refusal(problem, kind=Kind.UNREADABLE, file=path) from None
        said = "it ends what reads it"
    if said:
        raise refusal(f"cut short, damaged or not {what}: {said}", kind=Kind.UNREADABLE, file=path)


def _trial(path: str) -> bytes:
    """Read every value and attribute, those of the arrays after their sizes were summed; what is wrong, if anything."""
    try:
        with h5netcdf.File(path, "r") as file:
            size = sum(math.prod(one.shape) * getattr(one.dtype, "itemsize", 64) for one in file.variables.values())
            if size > _LARGEST:
                return f"its arrays would take {size} bytes, and must take at most {_LARGEST}".encode()
            for one in (file, *file.variables.values()):
                dict(one.attrs)
            for one in file.variables.values():
                one[...]
    except Exception as error:
        return " ".join((getattr(error, "strerror", None) or said_by(error)).split()).encode(errors="replace")
    return b""
