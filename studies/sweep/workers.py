"""Who computes: this process, processes of this machine, or the workers of a dask scheduler."""

from __future__ import annotations

import queue
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol

from acoustic_fem.numerics.processors import cores
from geometry.refusal import Refusal, counted, said_by

#: Tasks handed out per worker thread: one is computed while the next waits beside it.
_AHEAD = 2
#: Seconds to wait for a scheduler, which runs already, for its first worker, and between looks at whether any is left.
_ANSWER = 15.0
_PATIENCE = 60.0
_WATCH = 5.0


class WorkersLost(Refusal):
    """Refusal to go on: workers or their scheduler are gone."""


class Workers(Protocol):
    """Workers: whatever runs tasks."""

    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        """Results of a function with the arguments of each task: number of the task and result, as they come.

        Args:
            function: what is called.
            tasks: its arguments.
            lost: called here with those of a task that ended several workers, for its result; without it that is an
                error once all other tasks are done.

        Raises:
            WorkersLost: no workers are left, or a task ended several.
        """


#: Of a worker of this machine. With dask's own setting of malloc every array is fetched from the system anew, which
#: took two fifths of a worker's time.
ENVIRONMENT = {f"{name}_NUM_THREADS": 1 for name in ("OMP", "MKL", "OPENBLAS")} | {
    f"MALLOC_{name}_THRESHOLD_": 1 << 30 for name in ("TRIM", "MMAP")
}


@contextmanager
def open_workers(count: int | None, scheduler: str | None) -> Iterator[Workers]:
    """Workers, for as long as the block lasts.

    Args:
        count: processes on this machine; 1 works in this process; None: one per core.
        scheduler: address of a dask scheduler in place of processes of this machine.

    Raises:
        Refusal: a bad count, or both given.
        WorkersLost: no scheduler or no worker answers.
    """
    if count is not None and not 1 <= count <= 1024:
        raise Refusal(f"workers = {count} must be between 1 and 1024")
    if scheduler is not None:
        if count is not None:
            raise Refusal("workers must not be given beside a scheduler, which has its own")
        with _connected(scheduler) as team:
            yield team
        return
    number = count if count is not None else cores()
    if number == 1:
        yield _Here()
        return
    with _local(number) as team:
        yield team


class _Here:
    """This process, which no task can end without ending the sweep."""

    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        for number, task in enumerate(tasks):
            yield number, _in_one_thread(function, *task)


class _Dask:
    """The workers of a dask client. A task whose worker dies is given to another one."""

    def __init__(self, client: Any) -> None:
        self._client = client

    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        from distributed import KilledWorker

        waiting = enumerate(tasks)
        running: dict[Any, tuple[int, tuple[Any, ...]]] = {}
        finished: queue.SimpleQueue[Any] = queue.SimpleQueue()
        ended = 0

        def hand_out() -> None:
            for number, task in waiting:
                future = self._client.submit(_by_a_worker, function, *task, pure=False)
                running[future] = number, task
                future.add_done_callback(finished.put)
                return

        for _ in range(_AHEAD * max(1, self._threads())):
            hand_out()
        while running:
            future = self._next(finished)
            number, task = running.pop(future)
            if future.status == "cancelled":
                raise WorkersLost("the connection to the scheduler was lost")
            if future.status == "error":
                error = future.exception()
                if not isinstance(error, KilledWorker):
                    raise error
                if lost is None:
                    ended += 1
                else:
                    yield number, lost(*task)
            else:
                result = future.result()
                if isinstance(result, Refusal):
                    raise result
                yield number, result
            future.release()
            hand_out()
        if ended:
            raise WorkersLost(f"{counted(ended, 'task')} ended several workers each, which may lack memory")

    def _next(self, finished: queue.SimpleQueue[Any]) -> Any:
        """The next future that is done, while there is anybody to work on it."""
        alone = 0.0
        while True:
            try:
                return finished.get(timeout=_WATCH)
            except queue.Empty:
                if self._client.status != "running":
                    raise WorkersLost("the connection to the scheduler was lost") from None
                alone = 0.0 if self._threads() else alone + _WATCH
                if alone >= _PATIENCE:
                    raise WorkersLost(f"there have been no workers for {alone:.0f} s") from None

    def _threads(self) -> int:
        return sum(self._client.nthreads().values())


#: What BLAS and OpenMP libraries are loaded, and how many modules there were when they were looked for.
_libraries: tuple[int, Any] = (0, None)


def _in_one_thread(function: Callable[..., Any], *task: Any) -> Any:
    """Run a task with one thread in BLAS: the workers share the processors among themselves."""
    global _libraries
    from threadpoolctl import ThreadpoolController

    if _libraries[0] != len(sys.modules):  # looking for them takes ten milliseconds
        controller = ThreadpoolController()
        _libraries = len(sys.modules), controller
    with _libraries[1].limit(limits=1):
        return function(*task)


def _by_a_worker(function: Callable[..., Any], *task: Any) -> Any:
    """Result of a task; what it refuses is handed back, for a worker that raises it shows a traceback as well."""
    try:
        return _in_one_thread(function, *task)
    except Refusal as refusal:
        return refusal


@contextmanager
def _local(count: int) -> Iterator[_Dask]:
    """A cluster of processes on this machine, which end with this one."""
    import dask
    from distributed import Client, LocalCluster

    # a worker whose thread keeps the interpreter to itself for a while, or a machine that is busy, is not dead
    patient = {
        "distributed.comm.timeouts.connect": "60s",
        "distributed.comm.timeouts.tcp": "600s",
        "distributed.scheduler.worker-ttl": None,
        "distributed.scheduler.allowed-failures": 1,  # a task that ends two workers is given up
    }
    one = {f"distributed.nanny.pre-spawn-environ.{name}": value for name, value in ENVIRONMENT.items()}
    with (
        dask.config.set({**one, **patient}),
        LocalCluster(n_workers=count, threads_per_worker=1, processes=True, dashboard_address=None,
                     silence_logs=40) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):  # fmt: skip
        yield _Dask(client)


@contextmanager
def _connected(address: str) -> Iterator[_Dask]:
    """The workers of a scheduler that runs already."""
    from distributed import Client

    try:
        client = Client(address, timeout=_ANSWER, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        raise WorkersLost(f"no scheduler answers at {address}: {said_by(error)}") from None
    with client:
        try:
            client.wait_for_workers(1, timeout=_PATIENCE)
        except TimeoutError:
            raise WorkersLost(f"the scheduler at {address} has no workers") from None
        yield _Dask(client)
