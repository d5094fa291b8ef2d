"""Files that a page asks for: one is made at a time, and the last few can be fetched."""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable
from pathlib import Path
from typing import Any

from geometry.design.array_design import ArrayDesign
from studies.panels.pinned_panel import COMPARISON
from studies.studio.page_words import SHARED
from studies.studio.shared_page import shared_page
from studies.studio.stage import Job, Post, notifier, outcome, progress
from studies.studio.workplace import Workplace

#: Files that a page can still fetch: a browser may ask for one after the next one was made.
MOST_FILES = 4


class Exports:
    """Files of a session.

    Args:
        session: identifier of the session, which addresses of its files begin with.
        workplace: where files are made.
        post: sends a message to the page.
        is_open: True while a page listens.
    """

    def __init__(self, session: str, workplace: Workplace, post: Post, is_open: Callable[[], bool]) -> None:
        self.files: dict[str, tuple[Path, str]] = {}
        self.task: asyncio.Task[None] | None = None
        self._session, self._workplace, self._post, self._is_open = session, workplace, post, is_open
        self._job: Job | None = None
        self._undelivered: dict[str, Any] | None = None

    async def make(self, job: Job, pinned: ArrayDesign | None) -> None:
        """Begin to make a file, or send the page why not.

        Args:
            job: with the name of the file and the fidelity as its options.
            pinned: design that the page has pinned.
        """
        name, _ = job.options
        waits = self.task is not None and not self.task.done()
        unpinned = name == COMPARISON and pinned is None
        if waits or unpinned:
            line = "one file at a time: stop the one that is made first" if waits else "pin a design first"
            await self._post({"type": "refused-export", "message": line})
            return
        self._job = job
        self.task = asyncio.create_task(self._make(job, pinned))

    async def stop(self) -> None:
        """End the file that is made."""
        if self._job is None:
            return
        self._workplace.stop_apart("export", self._job)
        if self.task is not None and self._job.options[0] == SHARED and self.task.cancel():
            failure = {"stage": "export", "revision": self._job.revision, "message": "stopped"}
            await self._post({"type": "failed", **failure})

    def end(self) -> None:
        """Nobody comes back: what is still made is stopped, and all files are removed."""
        if self._job is not None:
            self._workplace.stop_apart("export", self._job)
        for path, _ in self.files.values():
            self._workplace.remove(path)
        self.files.clear()

    async def post_again(self) -> None:
        """Send a page that comes back the file that was made while it was away."""
        if self._undelivered is not None:
            message, self._undelivered = self._undelivered, None
            await self._post(message)

    async def hand_out(self, path: Path, name: str, stage: str = "") -> None:
        """Send the page the address of a file.

        Args:
            path: of the file.
            name: under which the browser saves it.
            stage: that it was made for; empty where the page shows none.
        """
        key = secrets.token_urlsafe(16)
        self.files[key] = (path, name)
        for old in [*self.files][:-MOST_FILES]:
            self._workplace.remove(self.files.pop(old)[0])
        message = {"type": "file", "stage": stage, "name": name, "file": f"/files/{self._session}/{key}"}
        if not self._is_open():  # its page comes back: a report takes minutes
            self._undelivered = message
        await self._post(message)

    async def _make(self, job: Job, pinned: ArrayDesign | None) -> None:
        name, fidelity = job.options
        await progress(job, "begins", self._post)
        notify = notifier(job, self._post)
        if name == COMPARISON and pinned is not None:
            work = self._workplace.comparison(job.design, pinned, notify, job)
        elif name == SHARED:
            work = shared_page(self._workplace, job, notify)
        else:
            work = self._workplace.export(job.design, name, fidelity, notify, job)
        path = await outcome(job, work, self._post, "stopped")
        if path is not None:
            await self.hand_out(path, f"{job.design.name}-{name}", "export")
