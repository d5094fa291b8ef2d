"""netCDF-4 files, also those of SOFA, of which damage is noticed before HDF5 reads them.

HDF5 follows what a damaged file says: it may answer with other numbers, end the process, or loop for ever. So a file
that this program wrote ends with a seal, a SHA-256 of all bytes before it, which other programs pass over and take away
when they change the file. What has none is first read in a process of its own, for a limited time and with limited
memory.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import h5netcdf

from geometry.ground.file_checks import library_reads, ordinary_file
from geometry.ground.refusal import Refusal

_MARK = b"\nacoustic-fem sha256 "
_LENGTH = len(_MARK) + 64 + 1
#: Most bytes of a file, and of its arrays: those of 1000 points, 10 microphones and 2000 frequencies.
_LARGEST = 2_000_000_000
#: Time that the process may take in which a file without a seal is tried, s.
_PATIENCE = 20.0
#: What that process runs: every value and attribute is read, those of the arrays after their sizes were summed.
_TRIAL = f"""
import math
import sys
import h5netcdf
try:
    import resource
    resource.setrlimit(resource.RLIMIT_AS, (2 * {_LARGEST}, 2 * {_LARGEST}))
except (ImportError, ValueError, OSError):
    pass
try:
    with h5netcdf.File(sys.argv[1], "r") as file:
        bytes = sum(math.prod(one.shape) * getattr(one.dtype, "itemsize", 64) for one in file.variables.values())
        if bytes > {_LARGEST}:
            sys.exit(f"its arrays would take {{bytes}} bytes, and must take at most {_LARGEST}")
        for one in (file, *file.variables.values()):
            dict(one.attrs)
        for one in file.variables.values():
            one[...]
except Exception as error:
    said = getattr(error, "strerror", None) or str(error) or type(error).__name__
    sys.exit(" ".join(said.split()))
"""
T = TypeVar("T")


def seal(path: Path) -> None:
    """Put the seal at the end of a file that is complete."""
    with path.open("r+b") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
        file.seek(0, os.SEEK_END)
        file.write(_MARK + digest.encode() + b"\n")


def read_netcdf(path: Path, what: str, refusal: type[Refusal], take: Callable[[Any], T]) -> T:
    """What is taken from a netCDF-4 file whose bytes are those that were written, or that was tried.

    Args:
        path: the file.
        what: such as ``a SOFA file``, for messages.
        refusal: class of the errors.
        take: reads from the open ``h5netcdf.File``; nothing of it is used once the file is closed.

    Raises:
        Exception: by ``refusal``: no ordinary file, not netCDF, damaged, cut short, or one that takes too long or too
            much memory to read.
    """
    ordinary_file(path, what, refusal, _LARGEST)
    with path.open("rb") as file:
        file.seek(-min(_LENGTH, path.stat().st_size), os.SEEK_END)
        tail = file.read()
    if tail.startswith(_MARK):
        if tail[len(_MARK) :].strip() != _digest_before_seal(path):
            raise refusal(f"{path}: is damaged: its bytes are not those that were written (SHA-256)")
    else:
        _try_apart(path, what, refusal)
    with library_reads(path, what, refusal), h5netcdf.File(path, "r") as file:
        return take(file)


def _digest_before_seal(path: Path) -> bytes:
    digest, left = hashlib.sha256(), path.stat().st_size - _LENGTH
    with path.open("rb") as file:
        while left > 0 and (piece := file.read(min(left, 1 << 20))):
            digest.update(piece)
            left -= len(piece)
    return digest.hexdigest().encode()


def _try_apart(path: Path, what: str, refusal: type[Refusal]) -> None:
    """Read all of a file in a process that may take too long, or be ended by it."""
    try:
        tried = subprocess.run(
            [sys.executable, "-c", _TRIAL, str(path)], capture_output=True, text=True, timeout=_PATIENCE,
            stdin=subprocess.DEVNULL, check=False, errors="replace",
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise refusal(f"{path}: cannot be read in {_PATIENCE:g} s; it is damaged, or not {what}") from None
    if tried.returncode:
        said = tried.stderr.strip().splitlines()[-1:] if tried.returncode == 1 else ["it ends what reads it"]
        raise refusal(f"{path}: cut short, damaged or not {what}: {' '.join(said)}")
