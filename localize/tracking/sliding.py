"""A straight slide over an array: how fast it was, and when it passed which point.

A contact that slides is detected over one membrane after the other, each the louder the nearer its middle is. Each
frame gives a point and a level. They are compared with those of a contact on a straight line at an even speed: the
fraction of its force on each membrane as of :func:`localize.contacts.contact.hertz_fraction`, with a gain of its own
for each point. The line with the smallest residual of the levels is the slide.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy.optimize
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.contacts.contact import hertz_fraction, surface_of
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.threads import one_thread
from localize.tracking.tracking_options import SlideOptions


@dataclass(frozen=True, eq=False)
class Slide:
    """Slide of a contact on a straight line at an even speed."""

    speed: float
    """Speed, mm/s."""
    point: NDArray[np.int64]
    """Points that are detected under it, in the order in which they are passed, from 1; (n,) int64."""
    time: Array
    """Times at which its middle is nearest to them, s; (n,) float64."""


@one_thread()
def straight_slide(
    response: ArrayResponse,
    locate: Callable[[Array], Array],
    signals: Array,
    options: SlideOptions = SlideOptions(),
) -> Slide | None:
    """Slide that signals hold; None where they hold no slide over at least three points.

    Args:
        response: the array, with the places of its points.
        locate: gives the probability of each point, (n, n_point), of frames, (n, n_microphone, 250) Pa.
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a frame, of one slide.
        options: numbers that tune the search.

    Raises:
        Refusal: an array without places.
    """
    place, radius = surface_of(response)
    first = np.arange(0, signals.shape[1] - FRAME + 1, options.hop)
    time = (first + FRAME / 2) / SAMPLE_RATE
    heard = HighPass(len(signals), HIGH_PASS).begin(signals)
    frames = np.lib.stride_tricks.sliding_window_view(heard, FRAME, axis=1)[:, first].transpose(1, 0, 2)
    named = locate(np.ascontiguousarray(frames)).argmax(1)
    level = frames.std(2).max(1)
    level = np.minimum(level, np.quantile(level, options.loudest_quantile))
    # Points that are chosen by chance are chosen in frames with hardly any signal.
    counts = np.bincount(named, level**2, len(place))
    points = np.flatnonzero(counts > 0.02 * counts.sum())
    if len(points) < options.fewest_points:
        return None
    measured = np.where(named[:, None] == points, level[:, None], 0.0)
    distance = np.linspace(0.0, options.radii[-1] + radius.max() + 1.0, 100)
    middle, way = _line(place, named, level, time)
    best, found = options.explained_fraction, None
    within = np.array(options.within)[:, None]
    for pad in options.radii:
        share = hertz_fraction(distance, pad, float(radius[points].max()))

        def explained(line: Array, share: Array = share) -> float:
            at = line[:2] + (time[:, None, None] - time.mean() + within) * line[2:]
            away = np.linalg.norm(at[:, :, None] - place[points], axis=-1)
            expected = np.interp(away, distance, share).mean(1)
            both, own = (measured * expected).sum(0), (expected**2).sum(0)
            return -float((both**2 / np.maximum(own, 1e-9 * own.max() + 1e-300)).sum() / (measured**2).sum())

        start = min((np.concatenate([middle, faster * way]) for faster in options.faster), key=explained)
        told = scipy.optimize.minimize(explained, start, method="Nelder-Mead", options={"maxfev": 400, "xatol": 1e-3})
        if -told.fun > best:
            best, found = -told.fun, told.x
    if found is None:
        return None
    middle, way = found[:2], found[2:]
    speed = float(np.linalg.norm(way))
    passed = (place[points] - middle) @ way / speed**2 + time.mean()
    there = np.abs(passed - time.mean()) < signals.shape[1] / 2 / SAMPLE_RATE + options.edge
    if there.sum() < options.fewest_points or not options.speeds[0] <= speed <= options.speeds[1]:
        return None
    order = np.argsort(passed[there])
    return Slide(speed, points[there][order] + 1, passed[there][order])


def _line(place: Array, named: NDArray[np.int64], level: Array, time: Array) -> tuple[Array, Array]:
    """Middle and velocity of the straight line through the points that are named, the louder the more they count."""
    weight = level**2 / (level**2).sum()
    since, mean = time - weight @ time, weight @ place[named]
    way = (weight * since) @ (place[named] - mean) / (weight @ since**2)
    return mean + (time.mean() - weight @ time) * way, way
