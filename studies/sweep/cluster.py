"""The workers of a dask scheduler: each task is given to one of them, and to another when that one is silent or gone.

Only workers with the same code and libraries as this process are given any, so that who computes a task changes
nothing in its result: of a task that was given twice the first result counts. Nothing waits for ever: a worker that
has not been heard for :data:`SILENCE` gets nothing until it is heard again, and others take over what it was given;
without its scheduler nothing goes on.
"""

from __future__ import annotations

import asyncio
import concurrent.futures
import hashlib
import platform
import queue
import sys
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache, lru_cache
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path
from time import monotonic
from typing import Any

from threadpoolctl import ThreadpoolController

from geometry.ground.refusal import Kind, Refusal, counted, said_by

#: Seconds for which a worker, or the scheduler, may be silent; heartbeats come once a second or two.
SILENCE = 60.0
SCHEDULER_SILENCE = 60.0
#: Seconds to wait while there is no worker, and between questions to the scheduler who is there.
PATIENCE = 60.0
WATCH = 2.0
#: Tasks given to a worker per thread: one is computed while the next waits beside it.
AHEAD = 2
#: Workers that a task may end before it is given up.
DEATHS = 2
#: Distributions that change results, or how they are handed on.
LIBRARIES = ("acoustic-fem", "numpy", "scipy", "scikit-fem", "gmsh", "mkl", "torch", "pydantic", "dask", "distributed")
_CODE = ("geometry", "acoustic_fem", "localize", "studies")
CONNECTION_LOST = "the connection to the scheduler was lost"


class WorkersLost(Refusal):
    """Refusal to go on: workers or their scheduler are gone."""


@dataclass(eq=False)
class _Task:
    """Task of a run."""

    number: int
    arguments: tuple[Any, ...]
    deaths: int = 0
    done: bool = False
    attempts: list[_Attempt] = field(default_factory=list)


@dataclass(eq=False)
class _Attempt:
    """Task in the hands of one worker."""

    task: _Task | None
    """Task; None: the worker is asked what is installed."""
    worker: _Worker
    future: Any
    passed_on: bool = False
    """Whether another worker got the task as well."""


@dataclass(eq=False)
class _Worker:
    """Worker as this process sees it."""

    address: str
    threads: int
    seen: float
    """When the scheduler last heard of it, by the scheduler's clock."""
    heard: float
    """When that last changed, by the clock of this process."""
    given: list[_Attempt] = field(default_factory=list)
    """What it was given, the first first."""
    same: bool | None = None
    """Whether it has what this process has; None: not known yet."""

    @property
    def silent(self) -> bool:
        return monotonic() - self.heard > SILENCE


class Cluster:
    """Workers of a dask client.

    Args:
        client: the client, connected.
        name: of the scheduler, for messages.
        own: whether the workers are processes of this one and need not be asked what is installed.
        patience: seconds to wait while no worker is there.
    """

    def __init__(self, client: Any, name: str, own: bool, patience: float | None = None) -> None:
        self._client, self._name, self._own = client, name, own
        self._patience = PATIENCE if patience is None else patience
        self._crew: dict[str, _Worker] = {}
        self._answers: queue.SimpleQueue[tuple[_Attempt, Any, BaseException | None]] = queue.SimpleQueue()
        self._news: tuple[float, dict[str, Any]] = monotonic(), {}
        self._read = -1.0
        self._looked = self._back = self._manned = monotonic()
        self._refused = ""
        #: What is to be known of the workers, each once.
        self.notes: dict[str, None] = {}
        client.loop.add_callback(self._ask_again_and_again)

    # -- in the client's own thread ---------------------------------------------------------------------
    async def _ask_again_and_again(self) -> None:
        """Ask the scheduler who is there; its answer may never come."""
        while self._client.status in ("running", "connecting"):
            if self._client.status == "running":
                try:
                    identity = await self._client.scheduler.identity(n_workers=-1)
                    self._news = monotonic(), dict(identity["workers"])
                except OSError:
                    pass  # the client says what is the matter
            await asyncio.sleep(WATCH)

    async def _follow(self, attempt: _Attempt) -> None:
        """Wait for a result, each for itself: one that does not come keeps no other back."""
        try:
            result = await attempt.future
        except BaseException as error:
            self._answers.put((attempt, None, error))
        else:
            self._answers.put((attempt, result, None))

    # -- in the thread of the caller --------------------------------------------------------------------
    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        """Results as they come; see :meth:`studies.sweep.workers.Workers.run`."""
        waiting = (_Task(number, arguments) for number, arguments in enumerate(tasks))
        again: deque[_Task] = deque()
        live: set[_Task] = set()
        self._manned, ended, more = monotonic(), 0, True

        def finish(task: _Task) -> None:
            live.remove(task)
            task.done = True
            for attempt in task.attempts:  # also where others still work on it
                self._drop(attempt)

        try:
            while live or more:
                again += self._look()
                for task in [task for task in live if task.deaths >= DEATHS]:
                    finish(task)
                    if lost is None:
                        ended += 1
                    else:
                        yield task.number, lost(*task.arguments)
                again = deque(task for task in again if not task.done)
                while (more or again) and (worker := self._free()) is not None:
                    given = again.popleft() if again else next(waiting, None)
                    if given is None:
                        more = False
                        break
                    live.add(given)
                    self._give(worker, given, _by_a_worker, function, *given.arguments)
                if live and (answer := self._answer()) is not None:
                    task, result = answer
                    if isinstance(result, Refusal):
                        raise result
                    finish(task)
                    yield task.number, result
        finally:
            for task in [*live]:
                finish(task)
        if ended:
            problem = f"{counted(ended, 'task')} ended several workers each, which may lack memory"
            raise WorkersLost(problem, kind=Kind.STOPPED)

    def _give(self, worker: _Worker, task: _Task | None, function: Callable[..., Any], *arguments: Any) -> None:
        future = self._client.submit(function, *arguments, pure=False, workers=[worker.address])
        attempt = _Attempt(task, worker, future)
        worker.given.append(attempt)
        if task is not None:
            task.attempts.append(attempt)
        self._client.loop.add_callback(self._follow, attempt)

    def _drop(self, attempt: _Attempt) -> None:
        if attempt in attempt.worker.given:
            attempt.worker.given.remove(attempt)
        attempt.future.release()

    def _free(self) -> _Worker | None:
        """The worker with the most room, of those that are known to be like this process and are heard."""
        asked = any(worker.same is None and not worker.silent for worker in self._crew.values())
        ahead = 1 if asked else AHEAD  # who answers first must not take what others could begin at once
        free = [
            worker
            for worker in self._crew.values()
            if worker.same and not worker.silent and len(worker.given) < ahead * worker.threads
        ]
        return min(free, key=lambda worker: len(worker.given) / worker.threads, default=None)

    def _answer(self) -> tuple[_Task, Any] | None:
        """The next task that has a result, and that; None where none comes soon."""
        from distributed import KilledWorker

        try:
            attempt, result, error = self._answers.get(timeout=WATCH / 4)
        except queue.Empty:
            return None
        if attempt not in attempt.worker.given or isinstance(error, KilledWorker):
            return None  # it was dropped before, or will be when the scheduler says that its worker is gone
        self._drop(attempt)
        if attempt.task is None:
            self._compare_installed(attempt.worker, result, error)
            return None
        gone = error is not None and self._client.status != "running"
        if gone or isinstance(error, (asyncio.CancelledError, concurrent.futures.CancelledError)):
            raise WorkersLost(CONNECTION_LOST, kind=Kind.STOPPED)
        if error is not None:
            raise error
        return attempt.task, result

    def _look(self) -> Iterator[_Task]:
        """Note who came, went or fell silent; the tasks that others must take over.

        Raises:
            WorkersLost: the scheduler is gone or silent, or there have been no workers for a while.
        """
        when, known = self._news
        now = monotonic()
        if now - self._looked > SILENCE / 2:
            self._return(now)
        self._looked = now
        if self._client.status != "running":
            raise WorkersLost(CONNECTION_LOST, kind=Kind.STOPPED)
        if now - max(when, self._back) > SCHEDULER_SILENCE:
            raise WorkersLost(f"{self._name} has not answered for {SCHEDULER_SILENCE:g} s", kind=Kind.STOPPED)
        if when != self._read:
            self._read = when
            yield from self._compare(known, now)
        for worker in self._crew.values():
            if not worker.silent:
                continue
            for attempt in worker.given:
                if attempt.task is not None and not attempt.passed_on:
                    attempt.passed_on = True
                    self.notes[f"worker {worker.address} was silent for {SILENCE:g} s: others took over its tasks"] = (
                        None
                    )
                    yield attempt.task
        if any(worker.same and not worker.silent for worker in self._crew.values()):
            self._manned = now
        elif now - self._manned > self._patience:
            why = f": {self._refused}" if self._refused else ""
            raise WorkersLost(f"there have been no workers for {self._patience:.0f} s{why}", kind=Kind.STOPPED)

    def _return(self, now: float) -> None:
        """Take nobody to have been silent while this process was away: stopped by its user, or long at its store."""
        self._back = self._manned = now
        for worker in self._crew.values():
            worker.heard = now

    def _compare(self, known: dict[str, Any], now: float) -> Iterator[_Task]:
        """Bring the crew to what the scheduler says; the tasks of those that are gone."""
        for address in [address for address in self._crew if address not in known]:
            worker = self._crew.pop(address)
            for place, attempt in enumerate(list(worker.given)):
                self._drop(attempt)
                if (task := attempt.task) is None:
                    continue
                task.deaths += place < worker.threads  # what it was at; the others waited beside it
                if not attempt.passed_on:
                    yield task
        for address, about in known.items():
            running = about["status"] == "running"
            if address not in self._crew:
                worker = _Worker(address, about["nthreads"], about["last_seen"], now, same=True if self._own else None)
                self._crew[address] = worker
                if not self._own:
                    self._give(worker, None, installed)
            worker = self._crew[address]
            if running and about["last_seen"] != worker.seen:
                worker.seen, worker.heard = about["last_seen"], now

    def _compare_installed(self, worker: _Worker, found: dict[str, str], error: BaseException | None) -> None:
        """Take or refuse a worker by what is installed there."""
        if error is not None:
            differs = f"cannot load this version of acoustic-fem ({type(error).__name__}: {said_by(error)})"
        else:
            here = installed()
            parts = [f"{name} {found.get(name)} (here {here[name]})" for name in here if found.get(name) != here[name]]
            differs = "has " + ", ".join(parts) if parts else ""
        worker.same = not differs
        if differs:
            self._refused = f"worker {worker.address} is not used: it {differs}"
            self.notes[self._refused] = None


# -- what a worker runs -----------------------------------------------------------------------------
def in_one_thread(function: Callable[..., Any], *task: Any) -> Any:
    """Run a task with one thread in BLAS: the workers share the processors among themselves."""
    with _thread_pools(len(sys.modules)).limit(limits=1):
        return function(*task)


@lru_cache(maxsize=1)
def _thread_pools(modules: int) -> ThreadpoolController:
    """The BLAS and OpenMP libraries of so many modules: looking for them takes ten milliseconds."""
    return ThreadpoolController()


def _by_a_worker(function: Callable[..., Any], *task: Any) -> Any:
    """Result of a task; what it refuses is handed back, for a worker that raises it shows a traceback as well."""
    try:
        return in_one_thread(function, *task)
    except Refusal as refusal:
        return refusal


@cache
def installed() -> dict[str, str]:
    """Versions of everything here that changes a result, and a digest of the project's own code."""
    found = {"Python": ".".join(platform.python_version_tuple()[:2])}
    for name in LIBRARIES:
        try:
            found[name] = version(name).partition("+")[0]  # a build for other cards is the same on a processor
        except PackageNotFoundError:
            found[name] = "none"
    digest = hashlib.sha256()
    for package in _CODE:
        spec = find_spec(package)
        for folder in sorted((spec and spec.submodule_search_locations) or ()):
            files = [path for kind in ("*.py", "*.toml", "cell_atlas.json") for path in Path(folder).rglob(kind)]
            for path in sorted(files):
                digest.update(path.relative_to(folder).as_posix().encode() + b"\n" + path.read_bytes())
    return {**found, "code of acoustic-fem": digest.hexdigest()[:12]}
