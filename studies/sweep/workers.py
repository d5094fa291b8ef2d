"""Workers of a sweep: this process, processes of this machine, or the workers of a dask scheduler."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol

from acoustic_fem.numerics.processors import cores
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal, said_by
from studies.sweep.cluster import Cluster, WorkersLost, in_one_thread
from studies.sweep.processes import Processes

#: Seconds to wait for a scheduler, which runs already.
_ANSWER = 15.0
#: Addresses that dask encrypts and whose certificates it checks, and what is said of others.
_ENCRYPTED = ("tls", "wss")
_OPEN = "is not encrypted: whoever reaches this port can run programs as you; docs/cluster.md says how to protect it"
_LOGGERS = ("distributed", "tornado")


class Workers(Protocol):
    """Workers: whatever runs tasks."""

    @property
    def notes(self) -> Iterable[str]:
        """Notes on the workers that their user should know, each once."""

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
    if count is not None:
        check_range("workers", count, 1, 1024, whole=True)
    if scheduler is not None:
        if count is not None:
            problem = ("must not be given beside ", Field("scheduler"), ", which has its own")
            raise Refusal(problem, kind=Kind.CONFLICT, field="workers")
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

    notes: Iterable[str] = ()

    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        for number, task in enumerate(tasks):
            yield number, in_one_thread(function, *task)


@contextmanager
def _local(count: int) -> Iterator[Processes]:
    """Processes of this machine, which end with this one."""
    processes = Processes(count)
    try:
        yield processes
    finally:
        processes.close()


@contextmanager
def _connected(address: str) -> Iterator[Cluster]:
    """The workers of a scheduler that runs already."""
    from distributed import Client

    with _without_tracebacks():
        try:
            client = Client(address, timeout=_ANSWER, set_as_default=False)
        except (OSError, TimeoutError, ValueError) as error:
            problem = f"no scheduler answers at {address}: {said_by(error)}"
            raise WorkersLost(problem, kind=Kind.STOPPED) from None
        with client:
            is_open = address.partition("://")[0] not in _ENCRYPTED
            yield Cluster(client, f"the scheduler at {address}", [f"{address} {_OPEN}"] if is_open else [])


@contextmanager
def _without_tracebacks() -> Iterator[None]:
    """Dask's own loggers kept from telling of a lost connection: the refusal does."""
    loggers = [logging.getLogger(name) for name in list(logging.root.manager.loggerDict) if name.startswith(_LOGGERS)]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)
