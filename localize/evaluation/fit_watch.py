"""Check of a live stream: whether its sensor fits the decoder, while touches come in."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Thread

from geometry.ground.typed import Array
from localize.evaluation.goodness_of_fit import FitOptions, LoudFrames, SensorFit, sensor_fit
from localize.live.events import Decision
from localize.live.listener import Notice
from localize.live.stream import TouchStream

GROWTH = 2
"""Factor by which the number of loud frames grows from one check to the next, while the sensor fits."""
MORE = 4
"""Number of further loud frames after which a misfit is checked again."""
TURN = 1e-3
"""Time after which one thread lets another go on while a stream is watched, s: the usual 5 ms would delay decisions."""


class FitWatch:
    """Check of a stream that reports once that its sensor does not fit the decoder.

    Checks run in a thread of their own, because the search for a fault takes seconds. They come after 8, 16 and 32 loud
    frames, and 4 frames after each check that found a misfit. The misfit is reported if two checks in succession agree
    on it.

    Args:
        stream: whose decisions carry their samples.
        options: numbers that tune the test.
    """

    def __init__(self, stream: TouchStream, options: FitOptions = FitOptions()) -> None:
        self._stream, self._options = stream, options
        self._loud = LoudFrames(options)
        self._due = math.inf if stream.locator.largest_misfit is None else options.fewest
        self._check: _Check | None = None
        self._suspected: tuple[object, ...] | None = None

    def take(self, event: object) -> list[Notice]:
        """Take the next event of the stream; a notice if the sensor has just been found not to fit."""
        if self._due == math.inf or not isinstance(event, Decision):
            return []
        self._loud.take([event])
        if self._check is None:
            if self._loud.count >= self._due:
                self._check = _Check(self._stream, self._loud.frames(ended=False), self._options)
                self._check.start()
            return []
        if self._check.is_alive():
            return []
        fit, self._check = self._check.result(), None
        suspected = None if fit is None or fit.fits else _kind_of(fit)
        agreed, self._suspected = suspected == self._suspected, suspected
        if suspected is not None:
            self._due = self._loud.count + MORE
        else:
            self._due = GROWTH * self._due if self._due < self._options.most else math.inf
        if fit is None or fit.warning is None or not agreed:
            return []
        self._due = math.inf
        return [Notice(event.time, "sensor does not fit", fit.warning)]

    def finish(self) -> list[Notice]:
        """End of the stream: a check that is still running is given up."""
        self._due = math.inf
        return []


class _Check(Thread):
    """One check in a thread, which does not keep the program from ending."""

    def __init__(self, stream: TouchStream, frames: list[Array], options: FitOptions) -> None:
        super().__init__(daemon=True)
        self._given = (stream.locator, frames, stream.noise, options)
        self._found: SensorFit | None = None
        self._error: Exception | None = None

    def run(self) -> None:
        try:
            self._found = sensor_fit(*self._given)
        except Exception as error:  # raised where the result is asked for
            self._error = error

    def result(self) -> SensorFit | None:
        """Fit that was found; what stopped the check is raised."""
        if self._error is not None:
            raise self._error
        return self._found


@contextmanager
def short_turns() -> Iterator[None]:
    """Threads that take turns of 1 ms, so that a check beside a stream does not delay its decisions."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(TURN)
    try:
        yield
    finally:
        sys.setswitchinterval(before)


def _kind_of(fit: SensorFit) -> tuple[object, ...]:
    """Reason why a sensor does not fit, without its amount, which changes a little with every frame."""
    return ("misfit",) if fit.fault is None else (fit.fault.kind, fit.fault.microphones)
