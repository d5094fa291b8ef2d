"""One writer at a time: whoever else would write to the same place is refused at once, before any work is done.

The lock is one that the system takes away with the process that holds it, however that ends.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from geometry.ground.refusal import Kind, Refusal


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

    Nothing is put into the folder. If folders cannot be locked, as on some network drives, nothing is checked.

    Raises:
        Refusal: of that class: another process holds it.
    """
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
        os.close(descriptor)
