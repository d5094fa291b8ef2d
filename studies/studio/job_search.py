"""The job that a page asks designs for: one search at a time, in a process of its own."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from studies.studio.messages import MessageError, text_of
from studies.studio.stage import Job, Post, notifier, outcome, progress
from studies.studio.workplace import Workplace


class JobSearch:
    """Search of designs for the job of a session.

    Args:
        workplace: where it is done.
        post: sends a message to the page.
    """

    def __init__(self, workplace: Workplace, post: Post) -> None:
        self._workplace, self._post = workplace, post
        self._task: asyncio.Task[None] | None = None
        self._job: Job | None = None

    async def words(self, design: ArrayDesign, revision: int) -> None:
        """Send the page what its dialogue offers."""
        found = await outcome(Job("proposals", revision, design), self._workplace.job_words(), self._post)
        if found is not None:
            await self._post({"type": "job", **found})

    def search(self, design: ArrayDesign, revision: int, message: Mapping[str, Any]) -> None:
        """Search designs, while the page may do other things.

        Raises:
            MessageError: no such message.
            Refusal: another search is under way.
        """
        name, asked = text_of(message, "name"), message.get("asked")
        if not isinstance(asked, dict):
            raise MessageError(kind=Kind.WRONG_TYPE, field="asked", allowed="a table")
        if self._task is not None and not self._task.done():
            raise Refusal("one search runs already", kind=Kind.CONFLICT, remedy="stop it first")
        self._job = Job("proposals", revision, design, (name, asked))
        self._task = asyncio.create_task(self._work(self._job))

    def stop(self) -> None:
        """End the search that is running."""
        if self._job is not None:
            self._workplace.stop_apart("proposals", self._job)

    async def _work(self, job: Job) -> None:
        await progress(job, "begins", self._post)
        name, asked = job.options
        found = await outcome(
            job, self._workplace.proposals(name, asked, notifier(job, self._post), job), self._post, "stopped"
        )
        if found is not None:
            await self._post({"type": "proposals", **found})
