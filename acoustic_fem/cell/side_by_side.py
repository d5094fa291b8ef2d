"""Cells solved side by side, in processes that solve one after another."""

from __future__ import annotations

import os
import queue
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from acoustic_fem.cell.one_cell import CellError, CellFault, CellRecord, CellTask, solve_task
from acoustic_fem.numerics import disk_cache
from geometry.system.extras import NotInstalled

#: Exit status of a process whose cell could not be solved, that lacks a library, and that ended with a traceback.
_NOT_SOLVED, _LACKING, _TRACEBACK = 3, 4, 1
#: What a process writes to standard output when a cell is solved.
_SOLVED = "solved"


def solve_side_by_side(
    tasks: Sequence[CellTask],
    workers: int,
    report: Callable[[CellTask, float], None],
    keep: Callable[[CellTask, CellRecord], None],
) -> None:
    """Solve cells in a few processes, which hand their results over through a cache of their own.

    Plain child programs rather than a process pool: a pool would import the caller's main program again. They live
    until no cell is left: what they import takes as long as a cell.

    Args:
        tasks: the cells, in the order in which they are begun.
        workers: processes at a time, not more than there are tasks.
        report: called with a task and the fraction of it that is done.
        keep: called with a task and its result.

    Raises:
        CellError: a cell cannot be solved.
        NotInstalled: nothing can be meshed on this system.
        CellFault: a process ended with a traceback.
    """
    waiting = list(tasks)
    with _Children() as children:
        for _ in range(workers):
            children.start(waiting.pop(0))
        while children.running:
            child, line = children.messages.get()
            if child not in children.running:
                continue
            if line is None:
                raise children.failure(child)
            if line.strip() != _SOLVED:
                report(child.task, float(line))
                continue
            keep(child.task, children.result(child))
            if waiting:
                child.solve(waiting.pop(0))
            else:
                children.dismiss(child)


@dataclass(eq=False)
class _Child:
    """A process that solves cells."""

    task: CellTask
    """Cell that it solves."""
    process: subprocess.Popen[str]
    complaints: Path
    """What it writes to standard error."""

    def solve(self, task: CellTask) -> None:
        """Hand it a cell."""
        self.task = task
        with suppress(OSError):  # it has died; the end of its output says so
            if self.process.stdin is not None:
                # Left open: its end tells the child that its parent is gone, or wants no more of it.
                self.process.stdin.write(task.as_json() + "\n")
                self.process.stdin.flush()


class _Children:
    """Processes that solve cells; none outlives the block."""

    def __init__(self) -> None:
        self.running: list[_Child] = []
        #: What they say, and None at their end.
        self.messages: queue.Queue[tuple[_Child, str | None]] = queue.Queue()
        self._handover = tempfile.TemporaryDirectory(prefix="acoustic-fem-cells-")
        self._started = 0

    def __enter__(self) -> _Children:
        return self

    def __exit__(self, *_: object) -> None:
        for child in self.running:
            child.process.kill()
            child.process.wait()
        self._handover.cleanup()

    def start(self, task: CellTask) -> None:
        """Begin with a cell in a new process."""
        complaints = Path(self._handover.name) / f"{self._started}.log"
        self._started += 1
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
        environment["ACOUSTIC_FEM_CACHE"] = self._handover.name
        for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
            environment[name] = "1"
        with complaints.open("wb") as log:  # the child has its own copy of the handle
            process = subprocess.Popen(
                [sys.executable, "-m", __name__],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                env=environment,
            )
        child = _Child(task, process, complaints)
        self.running.append(child)
        threading.Thread(target=self._listen, args=(child,), daemon=True).start()

    def _listen(self, child: _Child) -> None:
        child.solve(child.task)
        for line in child.process.stdout or ():
            self.messages.put((child, line))
        self.messages.put((child, None))

    def result(self, child: _Child) -> CellRecord:
        """What a process has found.

        Raises:
            CellError: it has found nothing.
        """
        record = disk_cache.fetch(child.task.key, Path(self._handover.name))
        if record is None:
            raise CellError(f"{child.task.cell.label}: the solver ended without a result")
        return record

    def dismiss(self, child: _Child) -> None:
        """End a process that has solved its cells, and pass its warnings on."""
        self.running.remove(child)
        if child.process.stdin is not None:
            child.process.stdin.close()
        child.process.wait()
        if said := self._said(child):
            print(said, file=sys.stderr)

    def failure(self, child: _Child) -> Exception:
        """Why a process has ended: its cell cannot be solved, nothing can be meshed on this system, or a traceback."""
        label, status, said = child.task.cell.label, child.process.wait(), self._said(child)
        if status == _TRACEBACK and said:
            print(said, file=sys.stderr)
            return CellFault(f"{label}: {said.splitlines()[-1]}")
        if status == _LACKING and said:
            return NotInstalled(said.splitlines()[-1])
        return CellError(said.splitlines()[-1] if said else f"{label}: the solver ended with {status}")

    @staticmethod
    def _said(child: _Child) -> str:
        return child.complaints.read_text(encoding="utf-8").strip()


def solve_as_child() -> int:
    """Solve the cells described on standard input, one a line; write the fraction done to standard output."""
    lines: queue.Queue[str] = queue.Queue()

    def listen() -> None:
        for line in sys.stdin:
            lines.put(line)
        os._exit(0)  # the parent is gone, or wants no more

    threading.Thread(target=listen, daemon=True).start()
    try:
        while True:
            task = CellTask.from_json(lines.get())
            disk_cache.store(task.key, *solve_task(task, lambda fraction: print(fraction, flush=True)))
            print(_SOLVED, flush=True)
    except CellError as error:
        print(error, file=sys.stderr)
        return _NOT_SOLVED
    except NotInstalled as error:
        print(error, file=sys.stderr)
        return _LACKING


if __name__ == "__main__":
    sys.exit(solve_as_child())
