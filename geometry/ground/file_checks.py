"""The one check of a file before it is read: an ordinary one, of at most so many bytes; and what libraries raise then.

Whoever reads a file that a user names calls :func:`ordinary_file` or :func:`read_bytes` first: a pipe would be waited
for without end, a device read without end, and a folder gives each library another error. Errors of a library while
it reads become refusals in :func:`library_reads`.
"""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from geometry.ground.argument_checks import check_type
from geometry.ground.refusal import Field, Kind, Refusal, said_by

LARGEST_DATA = 2**29
"""Most bytes of a file of numbers or sound: eight channels of 16 bits at 48 kHz for eleven minutes."""
MOST_NUMBERS = 2**26
"""Most numbers that are taken from a file at once: half a gigabyte of them."""

#: The address of a store or a site as it begins, also after ``pathlib`` has made one slash of two: ``s3://bucket/a``.
_ADDRESS = re.compile(r"[A-Za-z][A-Za-z0-9+.:-]+:/")
_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFLNK: "a link",
}


def check_local(path: str | os.PathLike[str], refusal: type[Refusal] = Refusal, field: str = "") -> None:
    """Reject the address of a store or a site in place of a path, which would become a folder called ``s3:``.

    Args:
        path: what was given as a path.
        refusal: class of the error.
        field: name of the argument.

    Raises:
        Refusal: of that class: it begins like ``s3://`` or ``file://``.
    """
    found = _ADDRESS.match(os.fspath(path))
    if found:
        slashes = "///" if found[0].lower() == "file:/" else "//"
        raise refusal(
            kind=Kind.OUT_OF_RANGE,
            file=found[0][:-1] + slashes + os.fspath(path)[found.end() :].lstrip("/"),  # as it was before pathlib
            field=Field(field),
            allowed="a path on this machine, not an address",
            remedy="copy the files with the store's own tool, or mount the store as a folder",
        )


def ordinary_file(path: str | os.PathLike[str], what: str, refusal: type[Refusal], largest: int | None = None) -> Path:
    """The path of a file that is there, is ordinary, may be read, and is not too large.

    Args:
        path: the file.
        what: such as ``a design file``, for messages.
        refusal: class of the errors.
        largest: most bytes that it may have; by default any number.

    Raises:
        Refusal: of that class: not the path of a file, the address of a store, no such file, a folder, pipe, socket or
            device, not readable, or too large.
    """
    check_type("path", path, (str, os.PathLike), f"the path of {what}", refusal)
    check_local(path, refusal)
    path = Path(path)
    try:
        status = path.stat()
        kind = _KINDS.get(stat.S_IFMT(status.st_mode))
        if kind is not None:
            raise refusal(f"is {kind}, not {what}", kind=Kind.UNREADABLE, file=path)
        if largest is not None and status.st_size > largest:
            raise _too_large(path, status.st_size, what, refusal, largest)
        path.open("rb").close()
    except OSError as error:
        raise _unreadable(path, error, refusal) from None
    except Refusal:
        raise
    except ValueError:  # what Python says of a name with a NUL byte
        problem = "no such file: its name holds a NUL byte"
        raise refusal(problem, kind=Kind.MISSING, file=path) from None
    return path


def read_bytes(path: str | os.PathLike[str], what: str, refusal: type[Refusal], largest: int | None = None) -> bytes:
    """The content of a file; arguments as for :func:`ordinary_file`.

    Raises:
        Refusal: of that class, as there.
    """
    path = ordinary_file(path, what, refusal, largest)
    try:
        with path.open("rb") as file:
            # Some files of the system state no length: what is read is bounded too.
            content = file.read() if largest is None else file.read(largest + 1)
    except OSError as error:
        raise _unreadable(path, error, refusal) from None
    if largest is not None and len(content) > largest:
        raise _too_large(path, len(content), what, refusal, largest)
    return content


def check_own_file(path: Path, what: str, refusal: type[Refusal]) -> None:
    """Refuse to write on in anything but an ordinary or new file, also in a link, which may lead to another's.

    Args:
        path: the file.
        what: what it should be, such as ``the log of a sweep``, for messages.
        refusal: class of the errors.

    Raises:
        Refusal: of that class.
    """
    try:
        found = stat.S_IFMT(path.lstat().st_mode)
    except FileNotFoundError:
        return
    if found != stat.S_IFREG:
        problem = f"is {_KINDS.get(found, 'no file')}, not {what}"
        raise refusal(problem, kind=Kind.EXISTS, file=path, remedy="remove it, or name another place")


def check_entries(folder: Path, refusal: type[Refusal], remedy: str = "") -> None:
    """Reject a folder that holds a pipe, a device or a link, at any depth; none of its files is opened.

    Args:
        folder: the folder, which may be a link itself.
        refusal: class of the errors.
        remedy: what to do.

    Raises:
        Refusal: of that class, with the entry, or with a folder that cannot be listed.
    """
    waiting = [folder]
    while waiting:
        place = waiting.pop()
        try:
            entries = list(os.scandir(place))
        except FileNotFoundError:  # removed since it was listed
            continue
        except OSError as error:
            raise _unreadable(place, error, refusal) from None
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                waiting.append(Path(entry.path))
            elif not entry.is_file(follow_symlinks=False):
                with suppress(FileNotFoundError):
                    found = _KINDS.get(stat.S_IFMT(entry.stat(follow_symlinks=False).st_mode), "no file")
                    problem = f"is {found}, not a file or folder"
                    raise refusal(problem, kind=Kind.UNREADABLE, file=Path(entry.path), remedy=remedy)


def open_to_append(path: Path, what: str, refusal: type[Refusal]) -> IO[str]:
    """A text file opened to write on in it, made where there is none; arguments and errors as for
    :func:`check_own_file`. A link or a pipe that was put there since is not opened.
    """
    check_own_file(path, what, refusal)
    flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    return open(os.open(path, flags, 0o666), "a", encoding="utf-8")


@contextmanager
def library_reads(path: str | os.PathLike[str], what: str, refusal: type[Refusal]) -> Iterator[None]:
    """Refuse a file by its name, whatever a library raises while it reads it; around its call and nothing of ours.

    Args:
        path: the file.
        what: what it should be, such as ``a MAT file up to version 7``, for messages.
        refusal: class of the errors.

    Raises:
        Refusal: of that class; what is a refusal already passes.
    """
    try:
        yield
    except Refusal:
        raise
    except MemoryError:
        problem = f"takes more memory to read than there is; it is damaged, or not {what}"
        raise refusal(problem, kind=Kind.UNREADABLE, file=path) from None
    except Exception as error:
        raise not_as_written(path, what, refusal, said_by(error)) from None


def not_as_written(path: str | os.PathLike[str], what: str, refusal: type[Refusal], why: str) -> Refusal:
    """The refusal of a file that is cut short or of another format, with what was found in it."""
    return refusal(f"cut short or not {what}: {why}", kind=Kind.UNREADABLE, file=path)


def _unreadable(path: Path, error: OSError, refusal: type[Refusal]) -> Refusal:
    if isinstance(error, FileNotFoundError):
        return refusal(kind=Kind.MISSING, file=path)
    return refusal(f"cannot be read: {error.strerror or error}", kind=Kind.UNREADABLE, file=path)


def _too_large(path: Path, size: int, what: str, refusal: type[Refusal], largest: int) -> Refusal:
    return refusal(
        kind=Kind.OUT_OF_RANGE, file=path, value=size, unit="bytes", allowed=f"at most {largest} bytes for {what}"
    )
