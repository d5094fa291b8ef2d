"""The study of a page: its file, its run, and the designs that it found."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from studies.panels.exploring import FoundDesigns, study_figures, study_file
from studies.studio.messages import is_number
from studies.studio.stage import Job, Post, notifier, outcome, progress
from studies.studio.workplace import Workplace

#: Seconds between two looks at what a running study has computed.
LOOK_EVERY = 2.0


class Exploration:
    """The study of a session, one at a time.

    Args:
        workplace: where it is run.
        post: sends a message to the page.
    """

    def __init__(self, workplace: Workplace, post: Post) -> None:
        self._workplace, self._post = workplace, post
        self._task: asyncio.Task[None] | None = None
        self._job: Job | None = None
        self._found: FoundDesigns | None = None
        self._last: dict[str, Any] | None = None

    async def run(self, design: ArrayDesign, revision: int, asked: Mapping[str, Any]) -> None:
        """Run a study, or go on with it where it was stopped; it goes on while its page is away.

        Raises:
            Refusal: not a study, or another one is running.
        """
        if self._task is not None and not self._task.done():
            raise Refusal("one study runs already", kind=Kind.CONFLICT, remedy="stop it first")
        job = Job("study", revision, design, (file_of(design, asked), limits_asked(asked)))
        self._job, self._task = job, asyncio.create_task(self._work(job))

    def stop(self) -> None:
        """End the study that is running; what it has computed stays."""
        if self._job is not None:
            self._workplace.stop_apart("study", self._job)

    async def post_again(self) -> None:
        """Send a page that comes back what was found."""
        if self._last is not None:
            await self._post(self._last)

    def design_of(self, number: Any) -> ArrayDesign:
        """One of the designs that were found.

        Args:
            number: of it in its study.

        Raises:
            Refusal: there is none of that number.
        """
        if self._found is None:
            raise Refusal("cannot be opened: no study has run yet", kind=Kind.MISSING, field="design", value=number)
        return self._found.design(number)

    async def _work(self, job: Job) -> None:
        await progress(job, "begins", self._post)
        watching = asyncio.create_task(self._watch(job))
        try:
            found = self._workplace.study(job.design, job.options[0], notifier(job, self._post), job)
            done = await outcome(job, found, self._post, "stopped; nothing was computed yet")
        finally:
            watching.cancel()
        if done is not None:
            await self._show(job, done)

    async def _watch(self, job: Job) -> None:
        """Show the designs that a running study has computed, as long as it runs."""
        known = 0
        while True:
            await asyncio.sleep(LOOK_EVERY)
            try:
                found = await self._workplace.study_so_far(job.design, job.options[0])
            except Refusal:  # nothing is there yet
                continue
            if len(found.table.number) > known:
                known = len(found.table.number)
                await self._show(job, found, running=True)

    async def _show(self, job: Job, found: FoundDesigns, running: bool = False) -> None:
        shown: dict[str, Any] = await self._workplace.in_thread("found", lambda: study_figures(found, job.options[1]))
        self._found = found
        self._last = {"type": "figures", "stage": "study", "revision": job.revision, "found": shown}
        self._last |= {"running": running}
        await self._post(self._last)


def file_of(design: ArrayDesign, asked: Mapping[str, Any]) -> str:
    """The study file that a page asks for.

    Args:
        design: the base.
        asked: ``ranges``, ``metrics``, ``search``, ``designs``, ``fidelity`` and ``limits``, as
            :func:`study_file` takes them.

    Raises:
        Refusal: not a study.
    """
    ranges, metrics, designs = asked.get("ranges"), asked.get("metrics"), asked.get("designs")
    if not isinstance(ranges, dict) or not all(
        isinstance(values, list) and all(isinstance(value, str) or is_number(value) for value in values)
        for values in ranges.values()
    ):
        raise _wrong("ranges", "a table of lists of numbers or texts")
    if not isinstance(metrics, list) or not all(isinstance(name, str) for name in metrics):
        raise _wrong("metrics", "a list of names")
    if not isinstance(designs, int) or isinstance(designs, bool):
        raise _wrong("designs", "a whole number")
    search, fidelity = asked.get("search") is True, str(asked.get("fidelity"))[:40]
    limits = limits_asked(asked)
    return study_file(design, ranges, metrics, search=search, designs=designs, fidelity=fidelity, limits=limits)


def limits_asked(asked: Mapping[str, Any]) -> dict[str, float]:
    """Limits that a page asks for, by the name of the metric; none if it states none.

    Raises:
        Refusal: not a table of numbers.
    """
    limits = asked.get("limits", {})
    if not isinstance(limits, dict) or not all(is_number(bound) for bound in limits.values()):
        raise _wrong("limits", "a table of numbers")
    return {name: float(bound) for name, bound in limits.items()}


def _wrong(field: str, allowed: str) -> Refusal:
    return Refusal(kind=Kind.WRONG_TYPE, field=field, allowed=allowed)
