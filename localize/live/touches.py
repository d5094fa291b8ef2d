"""Touches from the decisions of a stream: when each began and ended, and where it was.

Successive frames above silence are one contact, until their level falls and rises again: beats of a pulse follow each
other faster than the array comes to rest. A finger may slide meanwhile. The exact hidden Markov filter of
:mod:`localize.live.touch_filter`, run forward and backward over the contact, gives the point that was touched at each
time, and each point that was held long enough is a touch. During the contact the forward filter alone gives the points
where it came down and moved. Frames 16 ms apart share most of their samples. Their log-likelihoods therefore count in
proportion to their fraction of new samples, to their level (in sound, to the level above the sound) and to the square
of the fraction of the frame that the contact fills. Without these weights, frames in which a touch begins or ends, and
frames that hold only its decay, give wrong points with certainty.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from scipy.special import softmax

from geometry.ground.typed import Array
from localize.live.events import HOP, Decision, Fault, TouchEvent
from localize.live.stream_options import TouchOptions
from localize.live.touch_filter import TouchFilter
from localize.signals.array_facts import ArrayFacts
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE

_LEAST_PROBABILITY = 1e-12


@dataclass(frozen=True)
class Touch:
    """Touch of one point for a while."""

    start: float
    """Time of the end of the first frame that detected it, s; the touch began at most a frame (250 ms) before."""
    end: float
    """Time of the end of the last frame that detected it, s."""
    point: int
    """Point that was touched, from 1."""
    probability: float
    """Probability of the point by what all its frames say together."""
    level: float
    """Level of the loudest microphone in the loudest frame, Pa rms."""


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


def touches_of(
    events: Iterable[Decision | Fault], array: ArrayFacts | Locator, options: TouchOptions = TouchOptions()
) -> list[Touch]:
    """Touches into which the decisions of a stream join.

    Args:
        events: what :meth:`localize.TouchStream.push` returned, in order.
        array: lines and places of the points that were decided on.
        options: how decisions join.
    """
    contacts: list[list[Decision]] = []
    cutter = ContactCutter(options)
    for event in events:
        if isinstance(event, Decision):
            if cutter.take(event) == "begins":
                contacts.append([])
            if event.state == "touch":
                contacts[-1].append(event)
    tracked = TouchFilter(array.line, array.place, options.stay, options.jump)
    return [touch for contact in contacts for touch in _touches(contact, tracked, options)]


class _Evidence:
    """Evidence of all frames of a contact for its point.

    The new samples of each frame count in proportion to its level. The samples that the first frame holds from before
    count with the log-probability of the loudest frame, because that holds most of the touch.
    """

    def __init__(self) -> None:
        self._sum: Array | float = 0.0
        self._levels = self._loudest = 0.0
        self._of_loudest: Array = np.empty(0)

    def take(self, log_probability: Array, level: float) -> None:
        """Take the next frame: (n_point,) nats, and its level."""
        self._sum = self._sum + level * log_probability
        self._levels += level
        if level >= self._loudest:
            self._loudest, self._of_loudest = level, log_probability

    def probability(self, point: int) -> float:
        """Probability that the contact was at a point, from 0."""
        new = HOP / FRAME / self._loudest
        total = new * self._sum + max(0.0, 1.0 - new * self._levels) * self._of_loudest
        return float(softmax(total)[point])


class TouchTracker:
    """Tracker that reports the beginnings, moves and ends of touches while they happen.

    Args:
        array: lines and places of the points that are decided on.
        delay: delay of the stream, s: :attr:`localize.TouchStream.delay`.
        options: how decisions join.
    """

    def __init__(self, array: ArrayFacts | Locator, delay: float = 0.0, options: TouchOptions = TouchOptions()) -> None:
        self._cutter, self._delay, self._options = ContactCutter(options), delay, options
        self._filter = TouchFilter(array.line, array.place, options.stay, options.jump)
        self._touch = 0  # number of the last touch that came down
        self._point: int | None = None  # that is reported, from 0
        self._contact: list[Decision] = []
        self._evidence = _Evidence()
        self._belief: Array = np.empty(0)
        self._other = 0  # frames in a row that name another point

    def take(self, event: object) -> list[TouchEvent]:
        """Touch events that follow from the next event of a stream; none from events that are not decisions."""
        if not isinstance(event, Decision):
            return []
        found = self._cutter.take(event)
        told = [] if found == "goes on" else self._end(event.time)
        return [*told, *self._goes_on(event)] if event.state == "touch" else told

    def finish(self) -> list[TouchEvent]:
        """End the touch that the stream ends in, if there is one."""
        return self._end(self._contact[-1].time if self._contact else 0.0)

    def _goes_on(self, event: Decision) -> list[TouchEvent]:
        assert event.distribution is not None
        options = self._options
        self._contact.append(event)
        loudest = max(each.level for each in self._contact)
        count = len(self._contact)
        log_probability = np.log(event.distribution.clip(_LEAST_PROBABILITY))
        self._evidence.take(log_probability, event.level)
        # Where the touch is, and when that is sure: not how sure, for of the first frames next to nothing counts.
        weight = HOP / FRAME * event.level / loudest * min(count * HOP / FRAME, 1.0) ** 2
        self._belief = self._filter.update(weight * log_probability)
        best = int(self._belief.argmax())
        if self._point is None:
            # The first frames hold next to nothing of the touch.
            agreed = count >= options.agree and {each.point for each in self._contact[-options.agree :]} == {best + 1}
            likely = count >= options.held and self._belief[best] >= options.likely
            return self._down(event.time, best) if agreed or likely else []
        self._other = self._other + 1 if best != self._point else 0
        if self._other < options.held:
            return []
        self._point, self._other = best, 0
        return [self._event("moved", event.time, self._contact[-options.held].time)]

    def _down(self, time: float, point: int) -> list[TouchEvent]:
        self._touch += 1
        self._point = point
        return [self._event("down", time, self._contact[0].time)]

    def _end(self, time: float) -> list[TouchEvent]:
        """The contact so far is over."""
        told: list[TouchEvent] = []
        if self._contact:
            last = self._contact[-1].time
            if self._point is None and self._belief.max() >= self._options.likely:
                told += self._down(max(time, last), int(self._belief.argmax()))
            if self._point is not None:
                told.append(self._event("up", max(time, last), last))
        self._contact, self._point, self._other = [], None, 0
        self._evidence = _Evidence()
        self._filter.reset()
        return told

    def _event(self, kind: Literal["down", "moved", "up"], time: float, first: float) -> TouchEvent:
        """Event that is reported at a time, of what the frame that ends at ``first`` was the first to show."""
        assert self._point is not None
        return TouchEvent(
            time=time,
            kind=kind,
            touch=self._touch,
            point=self._point + 1,
            probability=self._evidence.probability(self._point),
            level=self._contact[-1].level,
            latency=time - first + HOP / SAMPLE_RATE + self._delay,
        )


def _touches(contact: list[Decision], tracked: TouchFilter, options: TouchOptions) -> list[Touch]:
    each = np.stack([decision.distribution for decision in contact if decision.distribution is not None])
    heard = np.array([decision.level if decision.weight is None else decision.weight for decision in contact])
    weight = HOP / FRAME * heard / heard.max() * _covered(len(contact)) ** 2
    log_probability = np.log(each.clip(_LEAST_PROBABILITY))
    probability = tracked.forward_backward(weight[:, None] * log_probability)
    named = probability.argmax(1)
    edges = [0, *(np.flatnonzero(np.diff(named)) + 1).tolist(), len(named)]
    runs = [(a, b) for a, b in pairwise(edges) if b - a >= options.held]
    if not runs:  # too short for anything else: the point of most weight, where there is one
        of_points = weight @ probability / weight.sum()
        best = int(of_points.argmax())
        return [_touch(contact, log_probability, heard, best)] if of_points[best] >= options.likely else []
    return [_touch(contact[a:b], log_probability[a:b], heard[a:b], int(named[a])) for a, b in runs]


def _covered(count: int) -> Array:
    """(count,) share of each frame of a contact that the contact fills: less at its beginning and end."""
    frame = np.arange(count)
    return np.clip(np.minimum(frame + 1, count - frame) * HOP / FRAME, 0.0, 1.0)


def _touch(decisions: list[Decision], log_probability: Array, heard: Array, point: int) -> Touch:
    evidence = _Evidence()
    for of_frame, level in zip(log_probability, heard.tolist(), strict=True):
        evidence.take(of_frame, level)
    return Touch(
        start=decisions[0].time,
        end=decisions[-1].time,
        point=point + 1,
        probability=evidence.probability(point),
        level=max(decision.level for decision in decisions),
    )
