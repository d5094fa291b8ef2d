"""Messages between this process and one that works for it: results and errors, limits, and an end without a result."""

from __future__ import annotations

import os
import pickle  # noqa: TID251  between two processes of one program, never into a file
import struct
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from geometry.ground.refusal import Kind, Refusal

#: Seconds between two looks at a process that works, and those that a process gets to end when it is asked to.
BEAT, PATIENCE = 0.2, 2.0
#: Kinds of messages about work: something reported on the way, a result, one that is bytes, an error, a stop, the end.
REPORT, RESULT, BYTES, ERROR, STOPPED, ENDED = b"t", b"r", b"b", b"e", b"s", b""
_KILLED = 9  # the signal by which Linux ends a process when memory runs out
#: Kind and length of a message; its content follows.
_HEAD = struct.Struct("<cQ")


class ChildError(Refusal):
    """A process ended, or was ended by this one, before it had a result."""

    status: int | None = None
    """Exit status of the process, negative for the signal that ended it; None if this process gave up waiting."""

    @classmethod
    def ended(cls, name: str, status: int) -> ChildError:
        """The error of a process that ended without a result, by its name and exit status."""
        how = f"exit status {status}" if status >= 0 else f"signal {-status}"
        remedy = "the system may have ended it for lack of memory" if status == -_KILLED else ""
        error = cls(f"{name} ended without a result ({how})", kind=Kind.STOPPED, remedy=remedy)
        error.status = status
        return error


class Stopped(Refusal):
    """Work that was stopped because nobody waits for it any more."""


class StopWork(BaseException):
    """In the process that works: nobody waits for the work any more."""


@dataclass(frozen=True)
class Limits:
    """Limits of a process; systems that know none, such as Windows, go without."""

    processor_seconds: int | None = None
    """Processor time of the whole process, s; None: no limit."""
    memory: int | None = None
    """Memory beyond what the process has when it begins to work, bytes; None: no limit."""

    def apply(self) -> None:
        """Set them for this process; a lower limit that is set already stays."""
        try:
            import resource
        except ImportError:
            return
        memory = None if self.memory is None else _memory() + self.memory
        for which, most in ((resource.RLIMIT_CPU, self.processor_seconds), (resource.RLIMIT_DATA, memory)):
            if most is not None:
                soft, hard = resource.getrlimit(which)
                known = [each for each in (soft, hard) if each != resource.RLIM_INFINITY]
                resource.setrlimit(which, (min([*known, most]), hard))


def _memory() -> int:
    """Memory that this process may write, bytes; 0 where the system does not say."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[5]) * os.sysconf("SC_PAGESIZE")
    except OSError:
        return 0


class _Elsewhere(Exception):
    """Traceback of another process, shown as the cause of its error."""


def packed(work: Callable[[], object]) -> tuple[bytes, bytes]:
    """Kind and content of the message that carries what some work returns or raises."""
    try:
        result = work()
        return (BYTES, result) if isinstance(result, bytes) else (RESULT, pickle.dumps(result))
    except StopWork:
        return STOPPED, b""
    except Exception as error:
        text = f"\n{traceback.format_exc()}"
        try:
            content = pickle.dumps((error, text))
            pickle.loads(content)
        except Exception:  # it cannot be sent as it is; a mistake of ours must not look like the end of the process
            content = pickle.dumps((RuntimeError(repr(error)), text))
        return ERROR, content


def unpacked(kind: bytes, content: bytes) -> Any:
    """The value that a message carries.

    Raises:
        Exception: the error that it carries, with its traceback as the cause.
    """
    if kind == BYTES:
        return content
    if kind != ERROR:
        return pickle.loads(content)
    error, text = pickle.loads(content)
    raise error from _Elsewhere(text)


def write_message(file: int, kind: bytes, content: bytes) -> None:
    """Write a message to a file descriptor."""
    rest = memoryview(_HEAD.pack(kind, len(content)) + content)
    while rest:
        rest = rest[os.write(file, rest) :]


def read_message(file: int) -> tuple[bytes, bytes]:
    """Kind and content of the next message of a file descriptor.

    Raises:
        EOFError: there is no further message, or the writer ended in the middle of one.
    """
    kind, length = _HEAD.unpack(_exactly(file, _HEAD.size))
    return kind, _exactly(file, length)


def _exactly(file: int, count: int) -> bytes:
    found = bytearray()
    while len(found) < count:
        piece = os.read(file, min(count - len(found), 1 << 20))
        if not piece:
            raise EOFError
        found += piece
    return bytes(found)
