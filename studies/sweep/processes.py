"""Processes of this machine that run tasks. They are reached through pipes, so no port opens to other users."""

from __future__ import annotations

import contextlib
import queue
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic
from typing import Any

import cloudpickle

from geometry.ground.child import Child, Message
from geometry.ground.process_messages import BEAT, ENDED
from geometry.ground.refusal import Kind, counted
from studies.sweep.cluster import AHEAD, DEATHS, SILENCE, WorkersLost, in_one_thread

#: Environment of a worker. With the usual settings of malloc every array is fetched from the system anew, which took
#: two fifths of a worker's time.
_ENVIRONMENT = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "MKL", "OPENBLAS")} | {
    f"MALLOC_{name}_THRESHOLD_": str(1 << 30) for name in ("TRIM", "MMAP")
}
#: Starts that may fail one after the other.
_FAILED_STARTS = 3
#: Where the memory of the machine is used up, the system ends processes with a high value first; the highest is 1000.
_FIRST_TO_END = Path("/proc/self/oom_score_adj"), "500"


@dataclass(eq=False)
class _Task:
    """Task of a run."""

    number: int
    arguments: tuple[Any, ...]
    deaths: int = 0


@dataclass(eq=False)
class _Worker:
    """A process, and what it was given."""

    child: Child
    given: deque[_Task | None] = field(default_factory=deque)
    """Tasks that have no answer yet, in the order in which it computes them; None stands for its start."""
    stopped: float | None = None
    """Time at which it was first seen stopped by a signal; None while it runs."""


class Processes:
    """Workers that are processes of this one.

    Args:
        count: number of processes.
    """

    def __init__(self, count: int) -> None:
        self._inbox: queue.SimpleQueue[Message] = queue.SimpleQueue()
        self._failed_starts = 0
        self._looked = monotonic()
        #: Notes on the workers, each once.
        self.notes: dict[str, None] = {}
        self._crew: list[_Worker] = []
        for _ in range(count):
            self._crew.append(self._started())

    def close(self) -> None:
        """End the processes."""
        for worker in self._crew:
            worker.child.kill()

    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        """Results as they come; see :meth:`studies.sweep.workers.Workers.run`."""
        waiting = (_Task(number, arguments) for number, arguments in enumerate(tasks))
        again: deque[_Task] = deque()
        ended, more = 0, True
        try:
            while True:
                while (more or again) and (worker := self._free()) is not None:
                    task = again.popleft() if again else next(waiting, None)
                    if task is None:
                        more = False
                        break
                    worker.given.append(task)
                    worker.child.begin(self._inbox, _work, cloudpickle.dumps((function, task.arguments)))
                if not more and not again and not any(any(worker.given) for worker in self._crew):
                    break
                self._replace_stopped(again)
                try:
                    message = self._inbox.get(timeout=BEAT)
                except queue.Empty:
                    continue
                known = next((each for each in self._crew if each.child is message.child), None)
                if known is None:
                    continue  # a process that was replaced
                if message.kind != ENDED:
                    done = known.given.popleft()
                    content = message.value()
                    if done is None:
                        self._failed_starts = 0
                    else:
                        yield done.number, cloudpickle.loads(content)
                    continue
                if (task := self._replace_ended(known, message, again)) is None:
                    continue
                if task.deaths < DEATHS:
                    again.append(task)
                elif lost is None:
                    ended += 1
                else:
                    yield task.number, lost(*task.arguments)
        finally:
            for number, worker in enumerate(self._crew):
                if any(worker.given):  # nobody waits for the results any more
                    worker.child.kill()
                    self._crew[number] = self._started()
        if ended:
            problem = f"{counted(ended, 'task')} ended several workers each, which may lack memory"
            raise WorkersLost(problem, kind=Kind.STOPPED)

    def _started(self) -> _Worker:
        worker = _Worker(Child("a worker", start=_give_way, environment=_ENVIRONMENT), deque([None]))
        worker.child.begin(self._inbox, _ready)
        return worker

    def _free(self) -> _Worker | None:
        """The worker with the least to do, if it has room for a task."""
        found = min(self._crew, key=lambda worker: len(worker.given))
        return found if len(found.given) < AHEAD else None

    def _replace(self, worker: _Worker) -> None:
        worker.child.kill()
        self._crew[self._crew.index(worker)] = self._started()

    def _replace_ended(self, worker: _Worker, message: Message, again: deque[_Task]) -> _Task | None:
        """Start a process in place of one that has ended; the task that it was at, if any.

        Raises:
            WorkersLost: several processes in a row ended while they started.
        """
        at, *beside = worker.given or [None]
        if at is None and worker.given:
            self._failed_starts += 1
            if self._failed_starts >= _FAILED_STARTS:
                status = message.child.kill()
                how = f"exit status {status}" if status >= 0 else f"signal {-status}"
                problem = f"{counted(self._failed_starts, 'worker')} in a row ended while they started ({how})"
                raise WorkersLost(problem, kind=Kind.STOPPED)
        again.extend(task for task in beside if task is not None)
        self._replace(worker)
        if at is not None:
            at.deaths += 1
        return at

    def _replace_stopped(self, again: deque[_Task]) -> None:
        """Give the tasks of processes that have been stopped for long to others."""
        now = monotonic()
        away = now - self._looked > SILENCE / 2  # this process itself was stopped, and the workers with it
        self._looked = now
        for worker in [each for each in self._crew if any(each.given)]:
            if away or not worker.child.is_stopped:
                worker.stopped = None
            elif worker.stopped is None:
                worker.stopped = now
            elif now - worker.stopped > SILENCE:
                note = f"worker process {worker.child.number} was stopped for {SILENCE:g} s: another took over its work"
                self.notes = {**self.notes, note: None}  # the caller may be reading them
                again.extend(task for task in worker.given if task is not None)
                self._replace(worker)


# -- in a process -----------------------------------------------------------------------------------
def _give_way() -> None:
    """Let the system end this process before the one that keeps the results, if memory runs out."""
    file, value = _FIRST_TO_END
    with contextlib.suppress(OSError):  # only Linux has it
        file.write_text(value, encoding="ascii")


def _ready() -> bytes:
    """Answer of a process that has started."""
    return b""


def _work(packed: bytes) -> bytes:
    """Result of a task. Its function may stand in the program itself, which this process has not read."""
    function, arguments = cloudpickle.loads(packed)
    return bytes(cloudpickle.dumps(in_one_thread(function, *arguments)))
