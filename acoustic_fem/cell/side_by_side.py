"""Cells solved side by side, in processes that solve one after another."""

from __future__ import annotations

import atexit
import os
import queue
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from acoustic_fem.cell.one_cell import CellError, CellFault, CellRecord, CellTask, solve_task
from acoustic_fem.numerics import disk_cache
from geometry.ground.extras import NotInstalled

#: Exit status of a process whose cell could not be solved, that lacks a library, and that ended with a traceback.
_NOT_SOLVED, _LACKING, _TRACEBACK = 3, 4, 1
#: What a process writes to standard output when a cell is solved.
_SOLVED = "solved"
#: After so long without a cell a process ends, s.
_IDLE = 10.0


def solve_side_by_side(
    tasks: Sequence[CellTask],
    workers: int,
    report: Callable[[CellTask, float], None],
    keep: Callable[[CellTask, CellRecord], None],
    lasting: bool = False,
) -> None:
    """Solve cells in a few processes, which hand their results over through a cache of their own.

    Plain child programs rather than a process pool: a pool would import the caller's main program again. They live
    until no cell is left: what they import takes as long as a cell.

    Args:
        tasks: the cells, in the order in which they are begun.
        workers: processes at a time, not more than there are tasks.
        report: called with a task and the fraction of it that is done.
        keep: called with a task and its result.
        lasting: leave the processes, for a few seconds, to the next call.

    Raises:
        CellError: a cell cannot be solved.
        NotInstalled: nothing can be meshed on this system.
        CellFault: a process ended with a traceback.
    """
    waiting = list(tasks)
    with _Children.left(_environment()) as children:
        for _ in range(workers):
            children.start(waiting.pop(0))
        while children.running:
            child, line = children.messages.get()
            if child not in children.running:
                continue
            if line is None:
                if (failure := children.failure(child)) is not None:
                    raise failure
                children.start(child.task)
                continue
            if line.strip() != _SOLVED:
                report(child.task, float(line))
                continue
            keep(child.task, children.result(child))
            children.pass_on(child)
            if waiting:
                child.solve(waiting.pop(0))
            elif lasting:
                children.rest(child)
            else:
                children.dismiss(child)


def _environment() -> dict[str, str]:
    """Environment of a process that solves cells, one thread each; where it begins is in it."""
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    with suppress(FileNotFoundError):
        threads["PWD"] = str(Path.cwd())
    return {**os.environ, **threads, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}


@dataclass(eq=False)
class _Child:
    """A process that solves cells."""

    task: CellTask
    """Cell that it solves."""
    process: subprocess.Popen[str]
    complaints: Path
    """What it writes to standard error."""
    told: int = 0
    """How much of that has been passed on, characters."""
    rested: bool = False
    """Whether it waited for a cell once it had solved others."""

    def solve(self, task: CellTask) -> None:
        """Hand it a cell."""
        self.task = task
        with suppress(OSError):  # it has died; the end of its output says so
            if self.process.stdin is not None:
                # Left open: its end tells the child that its parent is gone, or wants no more of it.
                self.process.stdin.write(task.as_json() + "\n")
                self.process.stdin.flush()


class _Children:
    """Processes that solve cells; none outlives the block but those that rest, which end by themselves."""

    _left: ClassVar[list[_Children]] = []
    """Those of which a process rests."""

    def __init__(self, environment: dict[str, str]) -> None:
        self.running: list[_Child] = []
        self.resting: list[_Child] = []
        #: What they say, and None at their end.
        self.messages: queue.Queue[tuple[_Child, str | None]] = queue.Queue()
        self._environment, self._owner = environment, os.getpid()
        self._handover = Path(tempfile.mkdtemp(prefix="acoustic-fem-cells-"))
        self._started = 0

    @classmethod
    def left(cls, environment: dict[str, str]) -> _Children:
        """Those that rest in the same environment, or new ones."""
        while True:
            try:
                found = cls._left.pop()
            except IndexError:
                return cls(environment)
            if found._environment == environment and found._owner == os.getpid():
                return found
            found._end()

    @classmethod
    def end_left(cls) -> None:
        """End those that rest, as this program ends."""
        while cls._left:
            cls._left.pop()._end()

    def __enter__(self) -> _Children:
        return self

    def __exit__(self, failed: type[BaseException] | None, *_: object) -> None:
        if failed is None and self.resting:
            self._left.append(self)
        else:
            self._end()

    def _end(self) -> None:
        if self._owner != os.getpid():
            return  # this process is a fork of theirs
        for child in (*self.running, *self.resting):
            child.process.kill()
            child.process.wait()
        shutil.rmtree(self._handover, ignore_errors=True)

    def start(self, task: CellTask) -> None:
        """Begin with a cell, in a process that rests or in a new one."""
        while self.resting:
            child = self.resting.pop()
            if child.process.poll() is None:
                self.running.append(child)
                child.solve(task)
                return
        complaints = self._handover / f"{self._started}.log"
        self._started += 1
        with complaints.open("wb") as log:  # the child has its own copy of the handle
            process = subprocess.Popen(
                [sys.executable, "-m", __name__],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                env={**self._environment, "ACOUSTIC_FEM_CACHE": str(self._handover)},
            )
        child = _Child(task, process, complaints)
        self.running.append(child)
        threading.Thread(target=self._listen, args=(child,), daemon=True).start()
        child.solve(task)

    def _listen(self, child: _Child) -> None:
        for line in child.process.stdout or ():
            self.messages.put((child, line))
        child.process.wait()
        self.messages.put((child, None))

    def result(self, child: _Child) -> CellRecord:
        """What a process has found.

        Raises:
            CellError: it has found nothing.
        """
        record = disk_cache.fetch(child.task.key, self._handover)
        if record is None:
            raise CellError(f"{child.task.cell.label}: the solver ended without a result")
        disk_cache.forget(child.task.key, self._handover)
        return record

    def pass_on(self, child: _Child) -> None:
        """Pass on what a process has warned of."""
        said = child.complaints.read_text(encoding="utf-8")
        if new := said[child.told :].strip():
            print(new, file=sys.stderr)
        child.told = len(said)

    def rest(self, child: _Child) -> None:
        """Leave a process that has solved its cells to the next."""
        self.running.remove(child)
        child.rested = True
        self.resting.append(child)

    def dismiss(self, child: _Child) -> None:
        """End a process that has solved its cells."""
        self.running.remove(child)
        if child.process.stdin is not None:
            child.process.stdin.close()
        child.process.wait()

    def failure(self, child: _Child) -> Exception | None:
        """Why a process has ended: its cell cannot be solved, nothing can be meshed on this system, or a traceback.

        None where it had rested and was ended before it began: another can solve its cell.
        """
        self.running.remove(child)
        label, status = child.task.cell.label, child.process.wait()
        said = child.complaints.read_text(encoding="utf-8")[child.told :].strip()
        if status == _TRACEBACK and said:
            print(said, file=sys.stderr)
            return CellFault(f"{label}: {said.splitlines()[-1]}")
        if status == _LACKING and said:
            return NotInstalled(said.splitlines()[-1])
        if child.rested and status != _NOT_SOLVED:
            return None
        return CellError(said.splitlines()[-1] if said else f"{label}: the solver ended with {status}")


atexit.register(_Children.end_left)


def solve_as_child() -> int:
    """Solve the cells described on standard input, one a line; write the fraction done to standard output."""
    lines: queue.Queue[str] = queue.Queue()

    def listen() -> None:
        for line in sys.stdin:
            lines.put(line)
        os._exit(0)  # the parent is gone, or wants no more

    def following() -> str | None:
        with suppress(queue.Empty):
            return lines.get(timeout=_IDLE)
        return None

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # of the parent's terminal; it ends its children itself
    threading.Thread(target=listen, daemon=True).start()
    try:
        while (line := following()) is not None:
            task = CellTask.from_json(line)
            with warnings.catch_warnings():  # what one cell has warned of the next may warn of again
                disk_cache.store(task.key, *solve_task(task, lambda fraction: print(fraction, flush=True)))
            print(_SOLVED, flush=True)
    except CellError as error:
        print(error, file=sys.stderr)
        return _NOT_SOLVED
    except NotInstalled as error:
        print(error, file=sys.stderr)
        return _LACKING
    return 0


if __name__ == "__main__":
    sys.exit(solve_as_child())
