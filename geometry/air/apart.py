"""Work of a foreign library in a process of its own: Ctrl-C, a crash or too much memory ends that, not the program."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from typing import NoReturn, TypeVar

from geometry.ground.refusal import Refusal

Result = TypeVar("Result")

#: Processor time (s) and memory beyond that of the program (bytes) that the work may take.
MOST_SECONDS, MOST_MEMORY = 60, 3 * 2**30
#: How often is said that the work goes on, and after how long without any it is stuck, s.
_BEAT, _ASLEEP = 0.2, 30.0


def apart(work: Callable[[], Result], what: str, beat: Callable[[], None] = lambda: None) -> Result:
    """What some work returns or raises, done in a copy of this process.

    Args:
        work: what it returns, or the error that it raises, is sent back.
        what: to name it by, such as "gmsh".
        beat: called again and again while the work goes on.

    Raises:
        Refusal: the copy ended without an answer, or waits for threads that only this process has.
    """
    if not hasattr(os, "fork"):  # Windows: Ctrl-C then waits for the end of the work
        return work()
    receiver, sender = Pipe(duplex=False)
    child = os.fork()
    if child == 0:
        _answer(work, sender)
    sender.close()
    try:
        asleep, used = 0, -1
        while not receiver.poll(_BEAT):
            beat()
            now = _processor_time(child)
            # Counted, not timed: both processes may be stopped for hours and go on.
            asleep, used = (asleep + 1 if now == used else 0), now
            if asleep * _BEAT > _ASLEEP:
                raise Refusal(
                    f"{what} does not wake up in a copy of this process: it was used here before, by other code; use "
                    "it in a process of its own"
                )
        done, answer = receiver.recv()
    except EOFError:
        raise Refusal(
            f"{what} gave up on this solid: it may take {MOST_SECONDS} s of processor time and "
            f"{MOST_MEMORY / 2**30:g} GiB; leave out small holes and roundings, or ask for less accuracy"
        ) from None
    finally:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        receiver.close()
    if done:
        return answer
    raise answer


def _answer(work: Callable[[], object], sender: Connection) -> NoReturn:
    """Work, send what came of it, and end at once: what the program does when it ends is not this process's task."""
    import resource

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the program decides
    try:
        _limit(resource.RLIMIT_CPU, MOST_SECONDS)
        _limit(resource.RLIMIT_DATA, _memory() + MOST_MEMORY)
        try:
            answer: tuple[bool, object] = (True, work())
        except BaseException as error:
            answer = (False, error)
        try:
            sender.send(answer)
        except Exception:  # it cannot be sent as it is; a mistake of ours must not look like a solid too hard to mesh
            sender.send((False, RuntimeError(repr(answer[1]))))
    finally:
        os._exit(0)


def _processor_time(child: int) -> int:
    """Processor time of a process, clock ticks; a number that grows where it is ready to run or nobody can say."""
    try:
        with open(f"/proc/{child}/stat", encoding="ascii") as file:
            state, *fields = file.read().rpartition(")")[2].split()
    except OSError:
        return time.monotonic_ns()
    return time.monotonic_ns() if state == "R" else int(fields[10]) + int(fields[11])


def _limit(kind: int, most: int) -> None:
    """Lower a limit of this process; what is lower already stays."""
    import resource

    soft, hard = resource.getrlimit(kind)
    known = [each for each in (soft, hard, most) if each != resource.RLIM_INFINITY]
    resource.setrlimit(kind, (min(known), hard))


def _memory() -> int:
    """Memory that this process may write, bytes; none where the system does not say."""
    import resource

    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[5]) * resource.getpagesize()
    except OSError:
        return 0
