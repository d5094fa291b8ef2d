"""Cells solved side by side, in processes that solve one after another."""

from __future__ import annotations

import os
import queue
import threading
import traceback
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from acoustic_fem.cell.one_cell import CellError, CellFault, CellRecord, CellTask, solve_task
from geometry.ground.child import Child, Message
from geometry.ground.process_messages import ChildError
from geometry.ground.refusal import Kind, Refusal

#: A process that waits for a cell is ended after so long, s.
_IDLE = 10.0


@dataclass(eq=False)
class _Resting:
    """A process that waits for a cell."""

    child: Child
    environment: dict[str, str]
    """The environment that it was started in."""
    timer: threading.Timer
    """Ends it when nobody has a cell for it."""


_resting: list[_Resting] = []


def solve_side_by_side(
    tasks: Sequence[CellTask],
    workers: int,
    report: Callable[[CellTask, float], None],
    keep: Callable[[CellTask, CellRecord], None],
    lasting: bool = False,
) -> None:
    """Solve cells in a few processes, which live until no cell is left: what they import takes as long as a cell.

    The pools of libraries are no help: a sweep solves cells inside dask's workers, where neither loky nor the standard
    library may start processes, because these workers are daemons.

    Args:
        tasks: the cells, in the order in which they are begun.
        workers: processes at a time, not more than there are tasks.
        report: called with a task and the fraction of it that is done.
        keep: called with a task and its result.
        lasting: leave the processes, for a few seconds, to the next call.

    Raises:
        CellError: a cell cannot be solved.
        NotInstalled: nothing can be meshed on this system.
        CellFault: the program failed in a process; the traceback is on standard error.
    """
    waiting, environment = list(tasks), _environment()
    inbox: queue.SimpleQueue[Message] = queue.SimpleQueue()
    running: dict[Child, CellTask] = {}

    def begin(child: Child) -> None:
        running[child] = waiting.pop(0)
        child.begin(inbox, _solve, running[child], reports=True)

    try:
        for _ in range(workers):
            begin(_rested(environment) or Child("the solver", environment=environment))
        while running:
            message = inbox.get()
            child, task = message.child, running.get(message.child)
            if task is None:  # the end of one that is not needed any more
                continue
            if message.is_report:
                report(task, message.value())
                continue
            keep(task, _record(task, message))
            if waiting:
                begin(child)
                continue
            del running[child]
            if lasting:
                _rest(child, environment)
            else:
                child.kill()
    finally:
        for child in running:
            child.kill()


def _environment() -> dict[str, str]:
    """Environment of a process that solves cells, one thread each; where it begins is in it."""
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    with suppress(FileNotFoundError):
        threads["PWD"] = str(Path.cwd())
    return {**os.environ, **threads}


def _rest(child: Child, environment: dict[str, str]) -> None:
    """Leave a process to the next call, or end it after a while."""

    def end() -> None:
        with suppress(ValueError):  # somebody has taken it
            _resting.remove(resting)
            child.kill()

    resting = _Resting(child, environment, threading.Timer(_IDLE, end))
    resting.timer.daemon = True
    _resting.append(resting)
    resting.timer.start()


def _rested(environment: dict[str, str]) -> Child | None:
    """A process that waits for a cell in the same environment; those in another one are ended."""
    while True:
        try:
            found = _resting.pop()
        except IndexError:
            return None
        found.timer.cancel()
        if found.environment == environment and found.child.is_alive:
            return found.child
        found.child.kill()


def _solve(task: CellTask, tell: Callable[[float], None]) -> tuple[CellRecord, list[tuple[Any, ...]]]:
    """In the process: a solved cell, and the warnings that came up."""
    with warnings.catch_warnings(record=True) as caught:
        record = solve_task(task, tell)
    return record, [(each.message, each.category, each.filename, each.lineno) for each in caught]


def _record(task: CellTask, message: Message) -> CellRecord:
    """The record that a process sent; its warnings are passed on.

    Raises:
        CellError: it sent none.
    """
    label = task.cell.label
    try:
        record, caught = message.value()
    except ChildError as error:
        raise CellError(f"{label}: {error}", kind=Kind.STOPPED) from None
    except (Refusal, OSError, MemoryError):
        raise
    except Exception as error:
        traceback.print_exception(error)
        raise CellFault(f"{label}: {type(error).__name__}: {error}") from error
    for warning in caught:
        warnings.warn_explicit(*warning)
    return record
