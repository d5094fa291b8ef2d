"""One kind of job of a session: the latest asked for wins, and every result says which design it is of."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from typing import Any

from geometry.design.array_design import ArrayDesign


@dataclass(frozen=True, eq=False)
class Job:
    """Job of a stage."""

    stage: str
    """Name of the stage."""
    revision: int
    """Number of the design in its session, by which the page tells what is stale."""
    design: ArrayDesign
    """Design that the result is of."""
    options: tuple[Any, ...] = ()
    """Options of the stage."""


class Stage:
    """Queue of one place: while a job runs, of those asked for only the last is kept.

    Args:
        do: does a job and hands out its result; it must not raise what was foreseen.
        superseded: called with a job that runs while another one is asked for.
        pause: waited before a job begins, s: a slow one is not worth beginning while a slider is dragged.
    """

    def __init__(
        self,
        do: Callable[[Job], Awaitable[None]],
        superseded: Callable[[Job], None] = lambda job: None,
        pause: float = 0.0,
    ) -> None:
        self._do, self._superseded, self._pause = do, superseded, pause
        self._next: Job | None = None
        self._running: Job | None = None
        self._task: asyncio.Task[None] | None = None

    def ask(self, job: Job) -> None:
        """Do a job, after the one that runs and in place of those that wait."""
        self._next = job
        if self._running is not None:
            self._superseded(self._running)
        if self._task is None or self._task.done():
            self._task = asyncio.create_task(self._work())

    def cancel(self) -> None:
        """Do nothing more; what runs is told to end."""
        self._next = None
        if self._running is not None:
            self._superseded(self._running)

    async def _work(self) -> None:
        while True:
            if self._pause:
                await asyncio.sleep(self._pause)
            job, self._next = self._next, None
            if job is None:
                return
            self._running = job
            try:
                await self._do(job)
            finally:
                self._running = None
