"""Libraries in formats of other programs, written and read back to the last digit: netCDF, SOFA, NPZ, MAT and CSV."""

from __future__ import annotations

import os
from mmap import ACCESS_READ, mmap
from pathlib import Path

from acoustic_fem.library.array_file import read_mat, read_npz, write_mat, write_npz
from acoustic_fem.library.netcdf_file import LibraryError, library_in, load_netcdf, refused_in, write_netcdf
from acoustic_fem.library.other_files import refuse_other_content
from acoustic_fem.library.sofa_file import read_sofa, write_sofa
from acoustic_fem.library.table_file import read_table, write_table
from acoustic_fem.library.transfer_functions import MEASURED, Library
from geometry.ground.file_checks import ordinary_file
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import check_own_kind

#: Formats of libraries, by the ending of their names: netCDF-4, SOFA, NPZ, MAT, CSV.
FORMATS = (".nc", ".sofa", ".npz", ".mat", ".csv")
#: What writes and reads each but netCDF.
_WRITERS = {".nc": write_netcdf, ".sofa": write_sofa, ".npz": write_npz, ".mat": write_mat, ".csv": write_table}
_READERS = {".sofa": read_sofa, ".npz": read_npz, ".mat": read_mat, ".csv": read_table}


def save(library: Library, path: str | os.PathLike[str]) -> None:
    """Write a library in netCDF. The file is never incomplete. An existing file is replaced as by :func:`export`.

    Raises:
        LibraryError: the file cannot be written, or exists and is not netCDF, not a library, or a measured one.
    """
    path = Path(path)
    check_own_kind(path, ".nc", LibraryError)
    check_replaceable(path)
    write_netcdf(library, path)


def export(library: Library, path: str | os.PathLike[str], *, folders: bool = False) -> None:
    """Write a library in the format of the name's suffix; the file is whole or not there.

    Args:
        library: the library.
        path: the file.
        folders: make the folders of the file that are missing.

    Raises:
        LibraryError: another suffix than those of :data:`FORMATS`, a file that cannot be written, or
            one that is there and is not a library, or a measured one.
    """
    path = Path(path)
    _suffix(path)
    check_replaceable(path)
    if folders:
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            problem = f"cannot be made: {error.strerror or error}"
            raise LibraryError(problem, kind=Kind.UNREADABLE, file=path.parent) from None
    write_library(library, path)


def check_replaceable(path: Path) -> None:
    """Refuse to write over a file that cannot be computed again; recordings have some of the suffixes too.

    Raises:
        LibraryError: a file is there, and is not a library, or a measured one.
    """
    if not path.is_file():
        return
    fidelity = fidelity_in(path)
    if fidelity is None or fidelity == MEASURED:
        what = "is not a readable library" if fidelity is None else "a measured library is never overwritten"
        remedy = "name another file, or remove this one"
        raise LibraryError(f"exists, and {what}", kind=Kind.EXISTS, file=path, remedy=remedy)


def fidelity_in(path: Path) -> str | None:
    """Fidelity of the library in a file; None where none can be read."""
    try:
        return load(path).fidelity
    except LibraryError:
        return None


def write_library(library: Library, path: Path) -> None:
    """Write a library as :func:`export` does, over whatever is there: for who has looked at it already.

    Raises:
        LibraryError: another suffix than those of :data:`FORMATS`, or a file that cannot be written.
    """
    write = _WRITERS[_suffix(path)]
    try:
        write(library, path)
    except OSError as error:
        raise LibraryError(f"cannot be written: {error.strerror or error}", kind=Kind.UNREADABLE, file=path) from None


def load(path: str | os.PathLike[str]) -> Library:
    """Read a library file that :func:`export` or :func:`acoustic_fem.save` wrote, with all digits.

    The format is recognized by the content of the file, whatever its name is.

    Raises:
        LibraryError: no such file, or a file that is cut short, was changed, or is not a library; the message says
            which.
    """
    path = ordinary_file(path, "a library", LibraryError)
    found = _format_of(path)
    if found == ".nc":
        return load_netcdf(path)
    try:
        dataset = _READERS[found](path)
    except LibraryError:
        raise
    except Refusal as error:
        raise refused_in(path, error) from None
    return library_in(path, dataset)


def _format_of(path: Path) -> str:
    """Format of the content of a file, as the suffix that it should have."""
    with path.open("rb") as file:
        head = file.read(1024)
        if head.startswith(b"\x89HDF\r\n\x1a\n"):
            # By its bytes: HDF5 follows what a damaged file says.
            with mmap(file.fileno(), 0, access=ACCESS_READ) as content:
                return ".nc" if content.find(b"SOFAConventions") < 0 else ".sofa"
    refuse_other_content(path, head)
    if head.startswith(b"PK"):
        return ".npz"
    if head.startswith(b"MATLAB"):
        return ".mat"
    if head and b"\0" not in head:
        return ".csv"
    what = "is empty" if not head else "holds neither netCDF, SOFA, NPZ, MAT nor CSV"
    raise LibraryError(f"{what}: it is not a library", kind=Kind.UNREADABLE, file=path)


def _suffix(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise LibraryError(
            f"its name must end with {', '.join(FORMATS[:-1])} or {FORMATS[-1]}", kind=Kind.OUT_OF_RANGE, file=path
        )
    return suffix
