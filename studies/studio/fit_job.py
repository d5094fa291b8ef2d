"""The body of a page and the fit of its array to it: one fit at a time, in a process of its own."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Mapping
from pathlib import Path
from typing import Any

from geometry.body.reading import UNITS
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from studies.studio.messages import MessageError, text_of
from studies.studio.stage import Job, Post, Stage, notifier, outcome, progress
from studies.studio.workplace import Workplace


class FitJob:
    """Body of a session, and the fit to it.

    Args:
        workplace: where bodies are read and arrays are fitted.
        post: sends a message to the page.
        take: puts a fitted design in place, if the number of the design is still the one that was fitted.
    """

    def __init__(self, workplace: Workplace, post: Post, take: Callable[[ArrayDesign, int], Awaitable[bool]]) -> None:
        self._workplace, self._post, self._take = workplace, post, take
        self._handed_in: Path | None = None
        self._reading = Stage(self._read)
        self._task: asyncio.Task[None] | None = None
        self._job: Job | None = None

    def take_body(self, path: Path) -> None:
        """From now on arrays are fitted to a body that was handed in."""
        self._handed_in = path

    def body_of(self, design: ArrayDesign) -> Path | None:
        """File of the body that was handed in, else of the one that the design names; None where neither is there."""
        return self._handed_in or self._workplace.bodies.of(design)

    async def show(self, design: ArrayDesign, revision: int, message: Mapping[str, Any]) -> None:
        """Begin to read the body, and send the page what it shows of it; of several that are asked for, the last.

        Raises:
            MessageError: no such message.
        """
        unit, skin = _reading(message)
        body = self.body_of(design)
        if body is None:
            named = "" if design.surface is None else design.surface.body
            await self._post({"type": "body", "name": named, "file": None})
        else:
            self._reading.ask(Job("body", revision, design, (body, unit, skin)))

    async def _read(self, job: Job) -> None:
        body, unit, skin = job.options
        await progress(job, f"reading {body.name}", self._post)
        found = await outcome(job, self._workplace.body(body, unit, skin), self._post)
        if found is not None:
            await self._post({"type": "body", **{key: value for key, value in found.items() if key != "shape"}})

    def fit(self, design: ArrayDesign, revision: int, message: Mapping[str, Any]) -> None:
        """Fit the array of a design to the body, while the page may do other things.

        Raises:
            MessageError: no such message.
            Refusal: there is no body, or another fit is under way.
        """
        surface, points = message.get("surface"), message.get("points")
        if not isinstance(surface, dict):
            raise MessageError(kind=Kind.WRONG_TYPE, field="surface", allowed="a table")
        if points is not None and not (isinstance(points, list) and all(type(each) is int for each in points)):
            raise MessageError(kind=Kind.WRONG_TYPE, field="points", allowed="a list of whole numbers")
        if self._task is not None and not self._task.done():
            raise Refusal("one fit runs already", kind=Kind.CONFLICT, remedy="stop it first")
        body = self.body_of(design)
        if body is None:
            raise Refusal("choose the file of a body first", kind=Kind.MISSING)
        self._job = Job("fit", revision, design, (surface, points, body))
        self._task = asyncio.create_task(self._work(self._job))

    async def post_again(self) -> None:
        """Say to a page that comes back that the fit is still running."""
        if self._job is not None and self._task is not None and not self._task.done():
            await progress(self._job, "goes on", self._post)

    def stop(self) -> None:
        """End the fit that is running."""
        if self._job is not None:
            self._workplace.stop_apart("fit", self._job)

    async def _work(self, job: Job) -> None:
        await progress(job, "begins", self._post)
        work = self._workplace.fit(job.design, job.options, notifier(job, self._post), job)
        found = await outcome(job, work, self._post, "stopped")
        if found is None:
            return
        if await self._take(found, job.revision):
            await self._post({"type": "fitted", "revision": job.revision})
            return
        line = "The design was changed while it was fitted, and is kept as it is now. Press Fit again."
        await self._post({"type": "failed", "stage": "fit", "revision": job.revision, "message": line})


def _reading(message: Mapping[str, Any]) -> tuple[str, int | None]:
    """Unit and skin with which a page wants a body to be read.

    Raises:
        MessageError: none of the units, or no number.
    """
    unit, skin = text_of(message, "unit"), message.get("skin")
    check_choice("unit", unit, tuple(UNITS), error=MessageError)
    if skin is not None and (type(skin) is not int or not 1 <= skin <= 1000):
        raise MessageError(kind=Kind.OUT_OF_RANGE, field="skin", value=skin, allowed="a whole number from 1 to 1000")
    return unit, skin
