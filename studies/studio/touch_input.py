"""Touches of a page: simulated ones, and live input from the microphones of a sound card."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Mapping
from shutil import rmtree
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind
from studies.studio.messages import MessageError, is_number, packed_signals, place_of, text_of
from studies.studio.stage import Job, Post, notifier, outcome
from studies.studio.workplace import Workplace

#: Touches that wait to be computed at once.
_MOST_TOUCHES = 8
#: No machine has as many devices.
_MOST_DEVICES = 10_000


class TouchInput:
    """Touches of a session, and its live input.

    Args:
        workplace: where they are computed.
        post: sends a message to the page: a table, or bytes.
    """

    def __init__(self, workplace: Workplace, post: Post) -> None:
        self._workplace = workplace
        self._post = post
        self._count = 0
        self._tasks: set[asyncio.Task[None]] = set()
        self._live: Job | None = None
        self._listening: asyncio.Task[None] | None = None
        #: Folder of the uploaded recognizer of kinds and letters; None for none.
        self.recognizer: str | None = None

    async def touch(self, design: ArrayDesign, revision: int, message: Mapping[str, Any]) -> None:
        """Touch a point, slide or write a letter; the page gets the signals and what is decoded of them.

        Raises:
            MessageError: none of these.
        """
        kind = text_of(message, "kind")
        if kind == "slide":
            what: tuple[Any, ...] = (place_of(message, "start"), place_of(message, "end"))
        elif kind == "letter":
            what = (text_of(message, "letter"),)
        else:
            point = message.get("point")
            if not isinstance(point, int) or isinstance(point, bool):
                raise MessageError(kind=Kind.WRONG_TYPE, field="point", allowed="a whole number")
            what = (point, kind)
        if len(self._tasks) >= _MOST_TOUCHES:
            await self._post({"type": "error", "message": f"{_MOST_TOUCHES} touches are being computed: wait for one"})
            return
        self._count += 1
        self._begin(self._touched(Job("touch", revision, design, (*what, self._count)), kind))

    async def replay(self, design: ArrayDesign, revision: int, recording: tuple[bytes, str, float]) -> dict[str, Any]:
        """A recording that was handed in, decoded; the page gets its progress.

        Args:
            design: the array.
            revision: number of the design in its session.
            recording: content, name and full scale (Pa) of the file.

        Raises:
            Refusal: as :func:`studies.panels.touching.replay_recording`.
        """
        notify = notifier(Job("touch", revision, design), self._post)
        return await self._workplace.replay(design, recording, self.recognizer, notify)

    async def listen(self, design: ArrayDesign, revision: int, message: Mapping[str, Any]) -> None:
        """Listen to a sound card until the page asks to stop.

        Raises:
            MessageError: no such message.
        """
        device, full_scale = message.get("device"), message.get("full_scale")
        if not is_number(full_scale) or not (
            device is None or (isinstance(device, int) and device in range(_MOST_DEVICES))
        ):
            raise MessageError("device must be a whole number or null, full_scale a number", kind=Kind.WRONG_TYPE)
        self.stop()
        self._live = Job("live", revision, design, (device, float(full_scale)))
        self._listening = self._begin(self._listened(self._live, self._listening))

    async def cards(self, design: ArrayDesign, revision: int) -> None:
        """Send the page the sound cards of the machine that the studio runs on."""
        found = await outcome(Job("live", revision, design), self._workplace.sound_cards(), self._post)
        if found is not None:
            await self._post({"type": "cards", "cards": found})

    def stop(self) -> None:
        """End the live input."""
        if self._live is not None:
            self._workplace.stop_apart("live", self._live)
            self._live = None

    async def end(self, why: str) -> None:
        """End the live input, if there is any, with a message about why."""
        if self._live is not None:
            revision = self._live.revision
            self.stop()
            await self._post({"type": "failed", "stage": "live", "revision": revision, "message": why})

    def take_recognizer(self, folder: str) -> None:
        """Use the recognizer in a folder, which is removed when another one comes."""
        self.forget()
        self.recognizer = folder

    def forget(self) -> None:
        """Remove the recognizer that was handed in."""
        if self.recognizer is not None:
            rmtree(self.recognizer, ignore_errors=True)
            self.recognizer = None

    def _begin(self, work: Any) -> asyncio.Task[None]:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    async def _touched(self, job: Job, kind: str) -> None:
        found = await outcome(job, self._workplace.touch(job.design, kind, job.options, self.recognizer), self._post)
        if found is not None:
            point = None if kind in ("slide", "letter") else job.options[0]
            header = {"stage": "touch", "revision": job.revision, "touched": point, "kind": kind}
            await self._post(packed_signals(header, found))

    async def _listened(self, job: Job, before: asyncio.Task[None] | None) -> None:
        if before is not None:  # a sound card is given back before it is taken again
            await asyncio.wait([before])
        if self._live is not job:
            return
        loop = asyncio.get_running_loop()

        async def post(message: dict[str, Any] | bytes) -> None:
            if self._live is job:  # the page knows of what was stopped
                await self._post(message)

        def notify(line: str) -> None:
            event = {"type": "heard", "revision": job.revision, "event": json.loads(line)}
            asyncio.run_coroutine_threadsafe(post(event), loop)

        if await outcome(job, self._workplace.live(job, notify), post) is not None:
            await post({"type": "failed", "stage": "live", "revision": job.revision, "message": "ended"})
        if self._live is job:
            self._live = None
