"""Files of arrays of numbers, NPZ and MAT: what they claim to hold is looked at before anything is allocated for it."""

from __future__ import annotations

import math
import os
import zipfile
import zlib
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import IO, Any, Literal, TypeAlias

import numpy as np
import scipy.io
from numpy.typing import NDArray

from geometry.ground.file_checks import LARGEST_DATA, MOST_NUMBERS, library_reads, not_as_written, ordinary_file
from geometry.ground.mat_hdf5 import is_hdf5_mat, read_hdf5_mat
from geometry.ground.refusal import Kind, Refusal

_NUMBER = 8  # bytes of a float64
_Order: TypeAlias = Literal["big", "little"]
# MAT files: the kind of a packed variable, classes of arrays of numbers and letters, kinds of their parts, and the
# mark of complex ones.
_PACKED = 15
_PLAIN = {4, *range(6, 16)}
_KINDS = {*range(1, 8), 9, 12, 13, 16, 17, 18}
_COMPLEX = 0x800


def read_npz(
    path: str | os.PathLike[str], what: str, refusal: type[Refusal], most_numbers: int = MOST_NUMBERS
) -> dict[str, NDArray[Any]]:
    """Arrays of an NPZ file by name, numbers and texts, in the shape of what was saved.

    Args:
        path: the file.
        what: such as ``an NPZ file``, for messages.
        refusal: class of the errors.
        most_numbers: that a file may hold.

    Raises:
        Refusal: of that class: no such file, not NPZ, cut short, encrypted, or of more numbers.
    """
    path = ordinary_file(path, what, refusal, LARGEST_DATA)
    with library_reads(path, what, refusal), zipfile.ZipFile(path) as archive:
        members = [info for info in archive.infolist() if info.filename.endswith(".npy")]
        total = 0
        for info in members:
            with archive.open(info) as member:
                total += _claimed(path, info, member, refusal)
            _check_size(path, total // _NUMBER, refusal, most_numbers)
        arrays = {}
        for info in members:
            with archive.open(info) as member:
                array: NDArray[Any] = np.lib.format.read_array(member, allow_pickle=False)
            arrays[info.filename.removesuffix(".npy")] = array
    return arrays


def _claimed(path: Path, info: zipfile.ZipInfo, member: IO[bytes], refusal: type[Refusal]) -> int:
    """Bytes that the header of an array claims, at least eight for each value."""
    version = np.lib.format.read_magic(member)
    header = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}.get(version)
    if header is None:
        problem = f"{info.filename} is of version {version} of arrays, which is not read"
        raise refusal(problem, kind=Kind.UNREADABLE, file=path)
    shape, _, dtype = header(member)
    count = math.prod(shape)
    if min(shape, default=0) < 0 or info.file_size < count * dtype.itemsize:
        problem = f"{info.filename} claims the shape {shape} of {dtype} and holds {info.file_size} bytes"
        raise refusal(problem, kind=Kind.UNREADABLE, file=path)
    return count * max(dtype.itemsize, _NUMBER)


def read_mat(
    path: str | os.PathLike[str], what: str, refusal: type[Refusal], most_numbers: int = MOST_NUMBERS
) -> dict[str, NDArray[Any]]:
    """Variables of a MAT file by name, in the shape of what was saved; version 7.3 is an HDF5 file.

    Anything but a plain array, such as a structure or a sparse matrix, is passed over. Arguments are those of
    :func:`read_npz`.

    Raises:
        Refusal: of that class: no such file, not MAT, cut short, or of more numbers than may be.
    """
    path = ordinary_file(path, what, refusal, LARGEST_DATA)
    if is_hdf5_mat(path):
        return read_hdf5_mat(path, what, refusal, most_numbers)
    names = _plain_variables(path, what, refusal, most_numbers)
    with library_reads(path, what, refusal):
        content = scipy.io.loadmat(path, variable_names=names)
    arrays = {name: values for name, values in content.items() if isinstance(values, np.ndarray)}
    _check_size(path, sum(values.size for values in arrays.values()), refusal, most_numbers)
    return arrays


def _plain_variables(path: Path, what: str, refusal: type[Refusal], most_numbers: int) -> list[str] | None:
    """Names of the arrays in a MAT file of version 5 to 7, all of whose parts are there; None of version 4.

    SciPy 1.17 unpacks whatever is packed, and ends the whole program at parts of a kind that it does not know
    (scipy/scipy#25349).
    """
    names = []
    with path.open("rb") as file:
        head = file.read(128)
        order: _Order | None = {b"IM": "little", b"MI": "big"}.get(head[126:128])  # type: ignore[assignment]
        if order is None or 0 in head[:4]:
            return None  # version 4, which packs nothing
        while len(tag := file.read(8)) == 8:
            kind, size = (int.from_bytes(tag[place : place + 4], order) for place in (0, 4))
            if file.tell() + size > path.stat().st_size:
                raise not_as_written(path, what, refusal, f"a variable claims {size} bytes")
            content = file.read(size)
            if kind == _PACKED:
                with library_reads(path, what, refusal):
                    content = zlib.decompressobj().decompress(content, _NUMBER * most_numbers + 1)
                _check_size(path, len(content) / _NUMBER, refusal, most_numbers)
                content = content[8:]
            parts = _parts(path, what, content, order, refusal)
            head_parts = [bytes(part) for _, part in islice(parts, 3)]
            if len(head_parts) < 3:
                raise not_as_written(path, what, refusal, "a variable has no name")
            flags, name = int.from_bytes(head_parts[0][:4], order), head_parts[2].decode("latin-1")
            if flags & 0xFF in _PLAIN:
                kinds = [kind for kind, _ in parts]
                if len(kinds) != (2 if flags & _COMPLEX else 1) or not _KINDS.issuperset(kinds):
                    raise not_as_written(path, what, refusal, f"{name} is damaged")
                names.append(name)
    return names


def _parts(
    path: Path, what: str, content: bytes, order: _Order, refusal: type[Refusal]
) -> Iterator[tuple[int, memoryview]]:
    """Kind and content of each part of a variable; small ones share eight bytes with their tag."""
    view, place = memoryview(content), 0
    while place + 8 <= len(view):
        kind, size = (int.from_bytes(view[place + k : place + k + 4], order) for k in (0, 4))
        begin = place + 8
        if kind >> 16:
            kind, size, begin = kind & 0xFFFF, kind >> 16, place + 4
        if begin + size > len(view):
            raise not_as_written(path, what, refusal, f"a part of a variable claims {size} bytes")
        yield kind, view[begin : begin + size]
        place = begin + size + -size % (4 if begin == place + 4 else 8)


def _check_size(path: Path, numbers: float, refusal: type[Refusal], most: int) -> None:
    if numbers > most:
        problem = f"claims to hold {numbers:.0f} numbers; a file must hold at most {most}"
        raise refusal(problem, kind=Kind.OUT_OF_RANGE, file=path)
