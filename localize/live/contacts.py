"""Contacts: runs of frames of a stream in which something is touched, cut where the level falls and rises again."""

from __future__ import annotations

from typing import Literal

from localize.live.events import HOP, Decision
from localize.live.stream_options import TouchOptions
from localize.signals.stimulus import SAMPLE_RATE


class ContactCutter:
    """Cutter of a stream's decisions into contacts.

    Args:
        options: when a contact begins.
    """

    def __init__(self, options: TouchOptions = TouchOptions()) -> None:
        self._options = options
        self._last: Decision | None = None
        self._loudest = self._least = 0.0
        self._count = 0

    def take(self, event: Decision) -> Literal["begins", "goes on", "over"]:
        """Say what a decision means for contacts: one that begins ends that before it."""
        last = self._last
        # Time steps back where a device counts anew.
        apart = last is None or not 0 < event.time - last.time <= self._options.pause + HOP / SAMPLE_RATE
        if event.state != "touch":
            self._last = None if apart else last
            return "over" if apart else "goes on"
        fallen = self._least < self._options.fallen * self._loudest
        rises = fallen and event.level > self._options.risen * self._least
        self._last = event
        self._count += 1
        if apart or rises or self._count > self._options.longest:
            self._loudest = self._least = event.level
            self._count = 1
            return "begins"
        if event.level > self._loudest:
            self._loudest = self._least = event.level
        self._least = min(self._least, event.level)
        return "goes on"
