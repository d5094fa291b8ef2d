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
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
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


@dataclass(eq=False)
class _Attempt:
    """Task in the hands of one worker."""

    task: _Task
    worker: _Worker
    future: Any
    passed_on: bool = False
    """True if another worker got the task as well."""


@dataclass(eq=False)
class _Worker:
    """Worker as this process sees it."""

    address: str
    threads: int
    seen: float
    """When the scheduler last heard of it, by the scheduler's clock."""
    heard: float
    """When that last changed, by the clock of this process."""
    same: bool | None = None
    """True if it has what this process has; None: not known yet."""

    @property
    def silent(self) -> bool:
        return monotonic() - self.heard > SILENCE


class Cluster:
    """Workers of a dask client.

    Args:
        client: the client, connected.
        name: of the scheduler, for messages.
        notes: notes on the workers that are known already.
    """

    def __init__(self, client: Any, name: str, notes: Iterable[str] = ()) -> None:
        self._client, self._name = client, name
        self._crew: dict[str, _Worker] = {}
        #: What the workers were given, the first first.
        self._given: list[_Attempt] = []
        #: Tasks that are to be given once more.
        self._again: deque[_Task] = deque()
        self._answers: queue.SimpleQueue[tuple[_Attempt, Any, BaseException | None]] = queue.SimpleQueue()
        self._news: tuple[float, dict[str, Any]] = monotonic(), {}
        self._read = -1.0
        self._looked = self._back = self._manned = monotonic()
        self._rejected = ""
        #: What is to be known of the workers, each once.
        self.notes: dict[str, None] = dict.fromkeys(notes)
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

    async def _ask_installed(self, worker: _Worker) -> None:
        """Take or reject a worker by what is installed there."""
        try:
            found = (await self._client.run(installed, workers=[worker.address]))[worker.address]
        except Exception as error:
            differs = f"cannot load this version of acoustic-fem ({type(error).__name__}: {said_by(error)})"
        else:
            here = installed()
            parts = [f"{name} {found.get(name)} (here {here[name]})" for name in here if found.get(name) != here[name]]
            differs = "has " + ", ".join(parts) if parts else ""
        if differs:
            self._rejected = f"worker {worker.address} is not used: it {differs}"
            self.notes = {**self.notes, self._rejected: None}  # the caller may be reading them
        worker.same = not differs

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
        live: set[_Task] = set()
        self._again.clear()
        self._manned, ended, more = monotonic(), 0, True

        def finish(task: _Task) -> None:
            live.remove(task)
            task.done = True
            for attempt in [each for each in self._given if each.task is task]:  # also where others still work on it
                self._drop(attempt)

        try:
            while live or more:
                self._look()
                for task in [task for task in live if task.deaths >= DEATHS]:
                    finish(task)
                    if lost is None:
                        ended += 1
                    else:
                        yield task.number, lost(*task.arguments)
                while (more or self._again) and (worker := self._free()) is not None:
                    given = self._again.popleft() if self._again else next(waiting, None)
                    if given is None:
                        more = False
                        break
                    if given.done:
                        continue
                    live.add(given)
                    attempt = _Attempt(given, worker, self._client.submit(
                        _by_a_worker, function, *given.arguments, pure=False, workers=[worker.address]
                    ))  # fmt: skip
                    self._given.append(attempt)
                    self._client.loop.add_callback(self._follow, attempt)
                if (live or more) and (answer := self._answer()) is not None:
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

    def _drop(self, attempt: _Attempt) -> None:
        self._given.remove(attempt)
        attempt.future.release()

    def _free(self) -> _Worker | None:
        """The worker with the most room, of those that are known to be like this process and are heard."""
        asked = any(worker.same is None and not worker.silent for worker in self._crew.values())
        ahead = 1 if asked else AHEAD  # who answers first must not take what others could begin at once
        load = Counter(attempt.worker.address for attempt in self._given)
        crew = [worker for worker in self._crew.values() if worker.same and not worker.silent]
        free = min(crew, key=lambda worker: load[worker.address] / worker.threads, default=None)
        return free if free is not None and load[free.address] < ahead * free.threads else None

    def _answer(self) -> tuple[_Task, Any] | None:
        """The next task that has a result, and that; None where none comes soon."""
        from distributed import KilledWorker
        from distributed.comm import CommClosedError

        try:
            attempt, result, error = self._answers.get(timeout=WATCH / 4)
        except queue.Empty:
            return None
        if attempt not in self._given:
            return None  # it was dropped before
        self._drop(attempt)
        gone = error is not None and self._client.status != "running"
        # A result is fetched through the scheduler; the client may not have noticed yet that it is gone.
        if gone or isinstance(error, (asyncio.CancelledError, concurrent.futures.CancelledError, CommClosedError)):
            raise WorkersLost(CONNECTION_LOST, kind=Kind.STOPPED)
        if isinstance(error, KilledWorker):
            attempt.task.deaths += 1
            self._again.append(attempt.task)
            return None
        if error is not None:
            raise error
        return attempt.task, result

    def _look(self) -> None:
        """Note who came, went or fell silent, and whose tasks others must take over.

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
            self._compare(known, now)
        for attempt in self._given:
            if attempt.worker.silent and not attempt.passed_on:
                attempt.passed_on = True
                note = f"worker {attempt.worker.address} was silent for {SILENCE:g} s: others took over its tasks"
                self.notes = {**self.notes, note: None}
                self._again.append(attempt.task)
        if any(worker.same and not worker.silent for worker in self._crew.values()):
            self._manned = now
        elif now - self._manned > PATIENCE:
            why = f": {self._rejected}" if self._rejected else ""
            raise WorkersLost(f"there have been no workers for {PATIENCE:.0f} s{why}", kind=Kind.STOPPED)

    def _return(self, now: float) -> None:
        """Take nobody to have been silent while this process was away: stopped by its user, or long at its store."""
        self._back = self._manned = now
        for worker in self._crew.values():
            worker.heard = now

    def _compare(self, known: dict[str, Any], now: float) -> None:
        """Bring the crew to what the scheduler says; others take over the tasks of those that are gone."""
        for address in [address for address in self._crew if address not in known]:
            worker = self._crew.pop(address)
            for place, attempt in enumerate([each for each in self._given if each.worker is worker]):
                self._drop(attempt)
                attempt.task.deaths += place < worker.threads  # what it was at; the others waited beside it
                if not attempt.passed_on:
                    self._again.append(attempt.task)
        for address, about in known.items():
            running = about["status"] == "running"
            if address not in self._crew:
                worker = _Worker(address, about["nthreads"], about["last_seen"], now)
                self._crew[address] = worker
                self._client.loop.add_callback(self._ask_installed, worker)
            worker = self._crew[address]
            if running and about["last_seen"] != worker.seen:
                worker.seen, worker.heard = about["last_seen"], now


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
