"""Touches at once in a stream: a frame of each contact is looked at again for a second touch."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor

from localize.live.contacts import ContactCutter
from localize.live.events import HOP, Decision, DownTouch, SeveralTouches
from localize.live.stream_options import TouchOptions
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE
from localize.two_touches.two_touch_decoder import TouchesAtOnce, TwoTouchDecoder

WAIT = 11
"""Number of decisions after the first one of a contact, whose frame holds the beginning and most of the contact."""
LARGEST_MISFIT = 5.0
"""Largest misfit at which several touches are reported: slides leave more."""


class TwoTouchWatch:
    """Watch of a stream that reports contacts of several touches.

    A report comes :data:`WAIT` decisions after the beginning of a contact, or when the contact ends before.

    Args:
        decoder: of the array.
        beside: True: frames are decoded in a thread, so that the decisions of a stream do not wait for them, and a
            report may come a few decisions later.
        options: when a contact begins.
    """

    def __init__(self, decoder: TwoTouchDecoder, beside: bool = False, options: TouchOptions = TouchOptions()) -> None:
        self._decoder, self._cutter = decoder, ContactCutter(options)
        self._pool = ThreadPoolExecutor(1) if beside else None
        self._pending: list[tuple[float, Decision, Future[TouchesAtOnce]]] = []
        self._begin = 0.0
        self._hops: int | None = None
        """Decisions since the contact began; None if it was decoded already, and without a contact."""
        self._last: Decision | None = None

    def take(self, event: object) -> list[SeveralTouches]:
        """Take the next event of a stream, whose decisions carry their frames."""
        if not isinstance(event, Decision):
            return []
        found = self._cutter.take(event)
        told = self._decoded() if found != "goes on" else []
        if found == "begins":
            self._begin, self._hops = event.time, 0
        if self._hops is not None:
            self._last = event if event.frame is not None else self._last
            self._hops += 1
            if self._hops > WAIT:
                told += self._decoded()
        return told + self._ready(event.time)

    def finish(self) -> list[SeveralTouches]:
        """End of the stream: report what is left."""
        told = self._decoded()
        for _, _, future in self._pending:
            future.result()
        told += self._ready(self._pending[-1][1].time if self._pending else 0.0)
        if self._pool is not None:
            self._pool.shutdown()
        return told

    def _decoded(self) -> list[SeveralTouches]:
        """Decode the frame of the contact."""
        frame, begin = self._last, self._begin
        self._hops = self._last = None
        if frame is None or frame.frame is None:
            return []
        if self._pool is not None:
            self._pending.append((begin, frame, self._pool.submit(self._decoder.locate, frame.frame)))
            return []
        return _told(begin, frame, self._decoder.locate(frame.frame), frame.time)

    def _ready(self, now: float) -> list[SeveralTouches]:
        """Reports of frames that were decoded meanwhile, at a time, s."""
        told = list[SeveralTouches]()
        while self._pending and self._pending[0][2].done():
            begin, frame, future = self._pending.pop(0)
            told += _told(begin, frame, future.result(), now)
        return told


def _told(begin: float, frame: Decision, found: TouchesAtOnce, now: float) -> list[SeveralTouches]:
    if len(found.touches) < 2 or found.misfit > LARGEST_MISFIT:
        return []
    first = frame.time - FRAME / SAMPLE_RATE
    touches = tuple(DownTouch(first + each.time, each.point, each.probability) for each in found.touches)
    return [SeveralTouches(now, begin, touches, now - begin + HOP / SAMPLE_RATE)]
