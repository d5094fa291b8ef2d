"""One kind of job of a session: the latest asked for wins, and every result says which design it is of."""

from __future__ import annotations

import asyncio
import traceback
from collections.abc import Awaitable, Callable, Coroutine
from dataclasses import dataclass
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.ground.process_messages import Stopped
from geometry.ground.refusal import Refusal

#: Sends a message to the page.
Post = Callable[[dict[str, Any] | bytes], Coroutine[Any, Any, None]]
#: Message to a page about an error that nobody foresaw.
MISTAKE = "this is a mistake of the program; the studio's terminal says where"


@dataclass(frozen=True, eq=False)
class Job:
    """Job of a stage."""

    stage: str
    """Name of the stage."""
    revision: int
    """Number of the design in its session, by which the page knows what is stale."""
    design: ArrayDesign
    """Design that the result is of."""
    options: tuple[Any, ...] = ()
    """Options of the stage."""


class Stage:
    """Queue of one place: while a job runs, of those asked for only the last is kept.

    Args:
        do: does a job and hands out its result; it must not raise what was foreseen.
        superseded: called with a job that runs while another one is asked for.
        pause: waited before a job begins, s, anew if another one is asked for meanwhile: a slow one is not worth
            beginning while a slider is dragged.
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
        """Do nothing more; what runs is asked to end."""
        self._next = None
        if self._running is not None:
            self._superseded(self._running)

    async def _settled(self) -> None:
        """Wait until nothing else was asked for during a pause: while a slider is dragged, nothing slow begins."""
        while True:
            asked = self._next
            await asyncio.sleep(self._pause)
            if self._next is asked:
                return

    async def _work(self) -> None:
        while True:
            if self._pause:
                await self._settled()
            job, self._next = self._next, None
            if job is None:
                return
            self._running = job
            try:
                await self._do(job)
            except Exception:  # a mistake of ours, which the page knows of: the next job is done all the same
                traceback.print_exc()
            finally:
                self._running = None


async def outcome(job: Job, work: Awaitable[Any], post: Post, stopped: str = "") -> Any:
    """Result of some work for a job; None after a message to the page about why there is none.

    Args:
        job: that the work is for.
        work: awaited.
        post: sends a message to the page.
        stopped: message about work that was stopped; empty for none.

    Raises:
        Exception: nobody foresaw it; the page got a message, and the traceback is for the terminal.
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
        await post({"type": "failed", "stage": job.stage, "revision": job.revision, "message": MISTAKE})
        raise
    if message:
        await post({"type": "failed", "stage": job.stage, "revision": job.revision, "message": message})
    return None


async def progress(job: Job, line: str, post: Post) -> None:
    """Send the page how far a job is."""
    await post({"type": "progress", "stage": job.stage, "revision": job.revision, "line": line})


def notifier(job: Job, post: Post) -> Callable[[str], None]:
    """Function that sends the page lines on a job from another thread."""
    loop = asyncio.get_running_loop()

    def notify(line: str) -> None:
        asyncio.run_coroutine_threadsafe(progress(job, line, post), loop)

    return notify
