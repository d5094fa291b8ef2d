"""One kind of job of a session: the latest asked for wins, and every result says which design it is of."""

from __future__ import annotations

import asyncio
import traceback
from collections.abc import Awaitable, Callable, Coroutine
from dataclasses import dataclass
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from studies.studio.workshop import Stopped

#: Tells the page a message.
Say = Callable[[dict[str, Any]], Coroutine[Any, Any, None]]
#: What a page is told where nothing was foreseen.
MISTAKE = "this is a mistake of the program; the studio's terminal says where"


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
            except Exception:  # a mistake of ours, which the page was told: the next job is done all the same
                traceback.print_exc()
            finally:
                self._running = None


async def outcome(job: Job, work: Awaitable[Any], say: Say, stopped: str = "") -> Any:
    """What some work for a job gives; None after the page was told why there is nothing.

    Args:
        job: that the work is for.
        work: awaited.
        say: tells the page.
        stopped: what the page is told of work that was stopped; nothing where empty.

    Raises:
        Exception: nothing was foreseen; the page was told, and the traceback is for the terminal.
    """
    try:
        return await work
    except Stopped:
        message = stopped
    except Refusal as error:
        message = str(error)
    except OSError as error:  # such as a full disk
        message = f"{error.filename or job.stage}: {error.strerror or error}; the design is kept"
    except Exception:
        await say({"type": "failed", "stage": job.stage, "revision": job.revision, "message": MISTAKE})
        raise
    if message:
        await say({"type": "failed", "stage": job.stage, "revision": job.revision, "message": message})
    return None


async def progress(job: Job, line: str, say: Say) -> None:
    """Tell the page how far a job is."""
    await say({"type": "progress", "stage": job.stage, "revision": job.revision, "line": line})


def teller(job: Job, say: Say) -> Callable[[str], None]:
    """Function that tells the page lines on a job from another thread."""
    loop = asyncio.get_running_loop()

    def tell(line: str) -> None:
        asyncio.run_coroutine_threadsafe(progress(job, line, say), loop)

    return tell
