"""Cells solved side by side, each in a process of its own."""

from __future__ import annotations

import os
import queue
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from pathlib import Path

from acoustic_fem.cell.one_cell import CellError, CellFault, CellRecord, CellTask, solve_task
from acoustic_fem.numerics import disk_cache

#: Exit status of a process whose cell could not be solved, and of one that ended with a traceback.
_NOT_SOLVED, _TRACEBACK = 3, 1


def solve_side_by_side(
    tasks: Sequence[CellTask],
    workers: int,
    report: Callable[[CellTask, float], None],
    keep: Callable[[CellTask, CellRecord], None],
) -> None:
    """Solve cells in processes of their own, which hand their results over through a cache of their own.

    Plain child programs rather than a process pool: a pool would import the caller's main program again.
    """
    waiting = list(tasks)
    handover = tempfile.TemporaryDirectory(prefix="acoustic-fem-cells-")
    messages: queue.Queue[tuple[int, str | None]] = queue.Queue()
    running: dict[int, tuple[CellTask, subprocess.Popen[str]]] = {}

    def complaints(number: int) -> Path:
        return Path(handover.name) / f"{number}.log"

    def start() -> None:
        number = len(tasks) - len(waiting)
        task = waiting.pop(0)
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
        environment["ACOUSTIC_FEM_CACHE"] = handover.name
        for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
            environment[name] = "1"
        with complaints(number).open("wb") as log:  # the child has its own copy of the handle
            child = subprocess.Popen(
                [sys.executable, "-m", __name__],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                env=environment,
            )
        running[number] = (task, child)
        threading.Thread(target=listen, args=(number, task, child), daemon=True).start()

    def listen(number: int, task: CellTask, child: subprocess.Popen[str]) -> None:
        try:
            if child.stdin is not None and child.stdout is not None:
                # Left open: its end tells the child that its parent is gone.
                child.stdin.write(task.as_json() + "\n")
                child.stdin.flush()
                for line in child.stdout:
                    messages.put((number, line))
        except OSError:
            pass  # the child died early; its exit status says so
        finally:
            messages.put((number, None))

    try:
        for _ in range(workers):
            start()
        while running:
            number, line = messages.get()
            task, child = running[number]
            if line is not None:
                report(task, float(line))
                continue
            status = child.wait()
            said = complaints(number).read_text(encoding="utf-8").strip()
            if status == _TRACEBACK and said:
                print(said, file=sys.stderr)
                raise CellFault(f"{task.cell.label}: {said.splitlines()[-1]}")
            if status != 0:
                raise CellError(said.splitlines()[-1] if said else f"{task.cell.label}: the solver ended with {status}")
            if said:
                print(said, file=sys.stderr)
            del running[number]
            record = disk_cache.fetch(task.key, Path(handover.name))
            if record is None:
                raise CellError(f"{task.cell.label}: the solver ended without a result")
            keep(task, record)
            if waiting:
                start()
    finally:
        for _, child in running.values():
            child.kill()
            child.wait()
        handover.cleanup()


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
    return 0


if __name__ == "__main__":
    sys.exit(solve_as_child())
