"""Files of arrays of numbers, NPZ and MAT: what they claim to hold is looked at before anything is allocated for it."""

from __future__ import annotations

import math
import os
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from geometry.files.ordinary import LARGEST_DATA, MOST_NUMBERS, library_reads, ordinary_file

_NUMBER = 8  # bytes of a float64


def read_npz(path: str | os.PathLike[str], what: str, refusal: Callable[[str], Exception]) -> dict[str, NDArray[Any]]:
    """Arrays of an NPZ file by name, numbers and texts, in the shape of what was saved.

    Args:
        path: the file.
        what: such as ``an NPZ file``, for messages.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``: no such file, not NPZ, cut short, encrypted, or of more than 2^26 numbers.
    """
    path = ordinary_file(path, what, refusal, LARGEST_DATA)
    with library_reads(path, what, refusal), zipfile.ZipFile(path) as archive:
        members = [info for info in archive.infolist() if info.filename.endswith(".npy")]
        total = 0
        for info in members:
            with archive.open(info) as member:
                total += _claimed(path, info, member, refusal)
            _check_size(path, total // _NUMBER, refusal)
        arrays = {}
        for info in members:
            with archive.open(info) as member:
                array: NDArray[Any] = np.lib.format.read_array(member, allow_pickle=False)
            arrays[info.filename.removesuffix(".npy")] = array
    return arrays


def _claimed(path: Path, info: zipfile.ZipInfo, member: IO[bytes], refusal: Callable[[str], Exception]) -> int:
    """Bytes that the header of an array claims, at least eight for each value."""
    version = np.lib.format.read_magic(member)
    header = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}.get(version)
    if header is None:
        raise refusal(f"{path}: {info.filename} is of version {version} of arrays, which is not read")
    shape, _, dtype = header(member)
    count = math.prod(shape)
    if min(shape, default=0) < 0 or info.file_size < count * dtype.itemsize:
        raise refusal(f"{path}: {info.filename} claims the shape {shape} of {dtype} and holds {info.file_size} bytes")
    return count * max(dtype.itemsize, _NUMBER)


def read_mat(path: str | os.PathLike[str], what: str, refusal: Callable[[str], Exception]) -> dict[str, NDArray[Any]]:
    """Variables of a MAT file up to version 7 by name, in the shape of what was saved; arguments and errors as for :func:`read_npz`.

    Raises:
        Exception: by ``refusal``: as there, or a variable that is no plain array.
    """
    import scipy.io

    path = ordinary_file(path, what, refusal, LARGEST_DATA)
    with library_reads(path, what, refusal):
        _check_inflated(path, refusal)
        content = scipy.io.loadmat(path)
    arrays = {name: values for name, values in content.items() if not name.startswith("__")}
    for name, values in arrays.items():
        if not isinstance(values, np.ndarray):
            raise refusal(f"{path}: {name} is a sparse matrix, must be a plain one")
    _check_size(path, sum(values.size for values in arrays.values()), refusal)
    return arrays


def _check_inflated(path: Path, refusal: Callable[[str], Exception]) -> None:
    """Refuse variables that become too large where they are unpacked; what is in them is left to the library."""
    with path.open("rb") as file:
        head = file.read(128)
        order = {b"IM": "little", b"MI": "big"}.get(head[126:128])
        if order is None:
            return  # version 4, which packs nothing
        total = 0
        while len(tag := file.read(8)) == 8:
            kind, size = (int.from_bytes(tag[k : k + 4], order) for k in (0, 4))  # type: ignore[arg-type]
            packed = file.read(size)
            if kind != 15:  # of a packed variable
                continue
            unpack = zlib.decompressobj()
            while packed and not unpack.eof:
                total += len(unpack.decompress(packed, 1 << 20))
                packed = unpack.unconsumed_tail
                _check_size(path, total // _NUMBER, refusal)


def _check_size(path: Path, numbers: int, refusal: Callable[[str], Exception]) -> None:
    if numbers > MOST_NUMBERS:
        raise refusal(f"{path}: claims to hold {numbers} numbers; a file must hold at most {MOST_NUMBERS}")
