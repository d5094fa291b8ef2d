"""One writer at a time: whoever else would write to the same place is refused at once, before any work is done.

The lock is one that the system takes away with the process that holds it, however that ends.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from geometry.ground.refusal import Kind, Refusal

#: Longest name of a file whose lock is called by it, characters; of others it is called by a digest.
_LONGEST_NAME = 40


def hold(descriptor: int, path: Path, verb: str, refusal: type[Refusal]) -> None:
    """Hold what is written to, until its descriptor is closed.

    Args:
        descriptor: of an open file or folder.
        path: what the lock is for, for messages.
        verb: that writes, such as ``sweep``.
        refusal: class of the error.

    Raises:
        Refusal: of that class: another process holds it.
        OSError: the file system has no locks.
    """
    try:
        import fcntl
    except ImportError:  # not on this system: nobody watches
        return
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise refusal(f"another {verb} is writing to it", kind=Kind.EXISTS, file=path) from None


@contextmanager
def sole_writer_of(folder: Path, verb: str, refusal: type[Refusal]) -> Iterator[None]:
    """Nobody else's folder while the block runs; it is made where it is missing. Arguments as for :func:`hold`.

    Nothing is put into the folder, and one that was made and stays empty is removed. If folders cannot be locked, as
    on some network drives, nothing is checked.

    Raises:
        Refusal: of that class: another process holds it.
    """
    missing = not folder.is_dir()
    folder.mkdir(parents=True, exist_ok=True)
    try:
        descriptor = os.open(folder, os.O_RDONLY)
    except PermissionError:  # Windows opens no folder
        yield
        return
    try:
        with suppress(OSError):
            hold(descriptor, folder, verb, refusal)
        yield
    finally:
        if missing:
            with suppress(OSError):  # it is not empty
                folder.rmdir()
        os.close(descriptor)


@contextmanager
def sole_writer_of_file(path: Path, refusal: type[Refusal]) -> Iterator[None]:
    """Nobody else's file while the block runs: a hidden file beside it is locked, and removed at the end.

    A process that is killed leaves the hidden file; the next one takes it. If files cannot be locked there, nothing is
    checked.

    Args:
        path: of the file, which need not exist; its folder must.
        refusal: class of the error.

    Raises:
        Refusal: of that class: another process holds it.
    """
    name = path.name if len(path.name) <= _LONGEST_NAME else hashlib.sha256(os.fsencode(path.name)).hexdigest()
    beside = path.with_name(f".{name}.lock")
    descriptor = _locked(beside, path, refusal)
    try:
        yield
    finally:
        if descriptor is not None:
            with suppress(OSError):
                beside.unlink()
            os.close(descriptor)


def _locked(beside: Path, path: Path, refusal: type[Refusal]) -> int | None:
    """Descriptor of the lock of a file; None where there are no locks."""
    while True:
        try:
            descriptor = os.open(beside, os.O_RDONLY | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o644)
        except OSError:  # somebody else's, or no place for it: the file itself says what is wrong
            return None
        try:
            hold(descriptor, path, "command", refusal)
            with suppress(OSError):
                if os.path.samestat(os.fstat(descriptor), os.stat(beside)):
                    return descriptor
        except OSError:
            os.close(descriptor)
            return None
        except BaseException:
            os.close(descriptor)
            raise
        os.close(descriptor)  # whoever held it has removed it in the meantime
