"""Cells solved side by side, each in a process of its own."""

from __future__ import annotations

import os
import queue
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from acoustic_fem.cell.one_cell import CellError, CellFault, CellRecord, CellTask, solve_task
from acoustic_fem.numerics import disk_cache
from geometry.system.extras import NotInstalled

#: Exit status of a process whose cell could not be solved, that lacks a library, and that ended with a traceback.
_NOT_SOLVED, _LACKING, _TRACEBACK = 3, 4, 1


def solve_side_by_side(
    tasks: Sequence[CellTask],
    workers: int,
    report: Callable[[CellTask, float], None],
    keep: Callable[[CellTask, CellRecord], None],
) -> None:
    """Solve cells in processes of their own, which hand their results over through a cache of their own.

    Plain child programs rather than a process pool: a pool would import the caller's main program again.

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
            if line is not None:
                report(child.task, float(line))
                continue
            keep(child.task, children.result(child))
            if waiting:
                children.start(waiting.pop(0))


@dataclass(frozen=True, eq=False)
class _Child:
    """A process that solves one cell."""

    task: CellTask
    process: subprocess.Popen[str]
    complaints: Path
    """What it writes to standard error."""


class _Children:
    """Processes that solve cells; none outlives the block."""

    def __init__(self) -> None:
        self.running: list[_Child] = []
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
        """Begin with a cell: lines of its process become messages, the last of which is None."""
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
        task, process = child.task, child.process
        try:
            if process.stdin is not None and process.stdout is not None:
                # Left open: its end tells the child that its parent is gone.
                process.stdin.write(task.as_json() + "\n")
                process.stdin.flush()
                for line in process.stdout:
                    self.messages.put((child, line))
        except OSError:
            pass  # the child died early; its exit status says so
        finally:
            self.messages.put((child, None))

    def result(self, child: _Child) -> CellRecord:
        """What a process that has said its last has found.

        Raises:
            CellError: the cell cannot be solved.
            NotInstalled: nothing can be meshed on this system.
            CellFault: the process ended with a traceback.
        """
        label, status = child.task.cell.label, child.process.wait()
        said = child.complaints.read_text(encoding="utf-8").strip()
        if said and status in (0, _TRACEBACK):
            print(said, file=sys.stderr)
        if status == _TRACEBACK and said:
            raise CellFault(f"{label}: {said.splitlines()[-1]}")
        if status == _LACKING and said:
            raise NotInstalled(said.splitlines()[-1])
        if status != 0:
            raise CellError(said.splitlines()[-1] if said else f"{label}: the solver ended with {status}")
        self.running.remove(child)
        record = disk_cache.fetch(child.task.key, Path(self._handover.name))
        if record is None:
            raise CellError(f"{label}: the solver ended without a result")
        return record


def solve_as_child() -> int:
    """Solve the cell described on standard input; write the fraction done to standard output."""
    task = CellTask.from_json(sys.stdin.readline())

    def end_with_parent() -> None:
        sys.stdin.read()
        os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()
    try:
        disk_cache.store(task.key, *solve_task(task, lambda fraction: print(fraction, flush=True)))
    except CellError as error:
        print(error, file=sys.stderr)
        return _NOT_SOLVED
    except NotInstalled as error:
        print(error, file=sys.stderr)
        return _LACKING
    return 0


if __name__ == "__main__":
    sys.exit(solve_as_child())
