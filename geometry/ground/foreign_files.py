"""Files of formats that can explode: read in a process of their own, with a deadline and limited memory.

A damaged or hostile file may make a library loop for ever, take all memory, or end the process that reads it. Whatever
it does, it does it to a process that does nothing else, and the user gets one line that names the file.
"""

from __future__ import annotations

import math
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

from geometry.ground.child import Child
from geometry.ground.process_messages import ChildError, Limits
from geometry.ground.refusal import Kind, Refusal, said_by

PATIENCE = 20.0
"""Processor time that a file may take to be read, s, with the start of the process that reads it."""
#: The same by the clock, in that time: other programs may keep the processors busy, or the disk may be slow.
_BUSY = 3


def read_apart(
    read: Callable[..., bytes],
    path: Path,
    what: str,
    refusal: type[Refusal],
    memory: int,
    seconds: float = PATIENCE,
    arguments: tuple[Any, ...] = (),
) -> bytes:
    """Bytes that a function makes of a file, in a process that is ended when it takes too long or too much memory.

    Args:
        read: a function of a module, which gets the path and the arguments. Its result is neither run nor unpickled.
        path: the file, which :func:`geometry.ground.file_checks.ordinary_file` has passed.
        what: such as ``a STEP file``, for messages.
        refusal: class of the error.
        memory: memory that the process may take, bytes.
        seconds: processor time that it may take, s; by the clock three times that.
        arguments: further ones of the function.

    Raises:
        Refusal: of that class: the function raised an error, the process ended, or a limit was reached.
    """
    limits = Limits(processor_seconds=math.ceil(seconds), memory=memory)
    try:
        with Child("the reader", limits=limits, quiet=True, trusted=False) as child:
            answer = child.call(_answer, read, str(path), arguments, seconds=_BUSY * seconds)
    except ChildError as error:
        if error.status is None or error.status == -getattr(signal, "SIGXCPU", 0):
            problem = f"cannot be read in {seconds:g} s; it is damaged, or not {what}"
            raise refusal(problem, kind=Kind.UNREADABLE, file=path) from None
        answer = b"-the process that reads it crashed"
    if answer[:1] != b"+":
        said = answer[1:].decode(errors="replace")
        raise refusal(f"cut short, damaged or not {what}: {said}", kind=Kind.UNREADABLE, file=path)
    return answer[1:]


def _answer(read: Callable[..., bytes], path: str, arguments: tuple[Any, ...]) -> bytes:
    """In the process: what the function returns, behind ``+``; why it returns nothing, behind ``-``."""
    try:
        return b"+" + read(path, *arguments)
    except MemoryError:
        return b"-it takes more memory than it may"
    except Exception as error:  # of any library: the process does nothing else, and its caller says what it was
        said = " ".join((getattr(error, "strerror", None) or said_by(error)).split())
        return b"-" + said.encode(errors="replace")
