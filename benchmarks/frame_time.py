"""Time that a localizer takes for one frame of a stream, on one core."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter, process_time
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from localize import ArrayResponse
    from localize.signals.locator import Locator

#: Frames that are decoded before the first one is timed.
WARM_UP = 50


@dataclass(frozen=True)
class FrameTime:
    """Percentiles of the time that single frames take, ms."""

    median: float
    """Median of the wall-clock time, ms; here and in the next field other work on the machine adds waiting."""
    worst: float
    """99th percentile of the wall-clock time, ms."""
    processor_median: float
    """Median of the processor time of the process, ms; here and in the next field other work adds only colder
    caches."""
    processor_worst: float
    """99th percentile of the processor time, ms."""


def frame_time(locator: Locator, response: ArrayResponse, frames: int = 2000) -> FrameTime:
    """Time of each frame of touches in :class:`localize.TouchStream`, which gets 16 samples at a time and decides at
    once.

    Args:
        locator: anything that can listen to a stream.
        response: the array that is touched.
        frames: number of frames that are timed.
    """
    from localize import Decision, TouchStream
    from localize.live import AS_IT_COMES
    from localize.live.events import HOP
    from localize.signals.frames import FRAME

    signals = _continuous(response, FRAME + (WARM_UP + frames) * HOP)
    stream = TouchStream(locator, options=AS_IT_COMES)
    begin = FRAME + WARM_UP * HOP
    stream.push(signals[:, :begin])
    wall, processor = [], []
    for first in range(begin, begin + frames * HOP, HOP):
        started, spent = perf_counter(), process_time()
        (event,) = stream.push(signals[:, first : first + HOP])
        processor.append(process_time() - spent)
        wall.append(perf_counter() - started)
        if not (isinstance(event, Decision) and event.state == "touch"):
            raise RuntimeError("a frame was not decoded: its time says nothing")
    return FrameTime(*(1e3 * float(np.percentile(times, share)) for times in (wall, processor) for share in (50, 99)))


def _continuous(response: ArrayResponse, samples: int) -> NDArray[np.float64]:
    """Touches of one point after the other, loud enough for every frame to be decoded: (n_microphone, samples)."""
    from localize import TouchGenerator

    touches = TouchGenerator(response, 0, "evaluation", 1e-3).samples(0, -(-samples // 1000))
    signals = touches.signals.double().numpy()
    signals /= signals.std((1, 2), keepdims=True)
    return np.concatenate(list(signals), axis=1)[:, :samples]
