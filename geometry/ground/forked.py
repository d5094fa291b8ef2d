"""Work in a copy of this process, for input that cannot be sent, such as CAD solids; a crash ends the copy alone."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from multiprocessing.connection import wait
from typing import NoReturn, TypeVar

from geometry.ground.process_messages import BEAT, ChildError, Limits, packed, read_message, unpacked, write_message
from geometry.ground.refusal import Kind

Result = TypeVar("Result")


def in_a_copy(
    work: Callable[[], Result],
    name: str,
    limits: Limits | None = None,
    beat: Callable[[], None] = lambda: None,
    asleep: float = 30.0,
) -> Result:
    """The result of some work that is done in a copy of this process.

    Args:
        work: what it returns, or the error that it raises, is sent back.
        name: what works, such as "gmsh".
        limits: limits of the copy.
        beat: called again and again while the work goes on; an error that it raises ends the copy.
        asleep: time without any work after which the copy is stuck, s.

    Raises:
        Exception: what the work raised.
        ChildError: the copy ended without a result, or waits for threads that only this process has.
    """
    if not hasattr(os, "fork"):  # Windows: Ctrl-C then waits for the end of the work
        return work()
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(ours)  # held open here too, the pipe would never break, and the copy would outlive its parent
        _work_in_copy(work, theirs, limits or Limits())
    status = None
    try:
        os.close(theirs)
        quiet, used = 0, -1
        while not wait([ours], BEAT):
            beat()
            now = _processor_time(child)
            quiet, used = (quiet + 1 if now == used else 0), now
            if quiet * BEAT > asleep:
                raise ChildError(
                    f"{name} does not wake up in a copy of this process, because other code has used it here before",
                    kind=Kind.STOPPED,
                    remedy=f"use {name} in a process of its own",
                )
        try:
            kind, content = read_message(ours)
        except EOFError:
            _, status = os.waitpid(child, 0)
            raise ChildError.ended(name, os.waitstatus_to_exitcode(status)) from None
    finally:
        os.close(ours)
        if status is None:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
    return unpacked(kind, content)


def _work_in_copy(work: Callable[[], object], outward: int, limits: Limits) -> NoReturn:
    """Work, send what came of it, and end at once: what the program does when it ends is not the task of its copy."""
    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # the program decides
        limits.apply()
        write_message(outward, *packed(work))
    finally:
        os._exit(0)


def _processor_time(process: int) -> int:
    """Processor time of a process, clock ticks; a number that grows where it is ready to run or nobody can say."""
    try:
        with open(f"/proc/{process}/stat", encoding="ascii") as file:
            state, *fields = file.read().rpartition(")")[2].split()
    except OSError:
        return time.monotonic_ns()
    return time.monotonic_ns() if state == "R" else int(fields[10]) + int(fields[11])
