"""Touches from the decisions of a stream: when each began and ended, and where it was.

Frames that are told from silence and follow each other are one contact, until their level rises again after it had
fallen: beats of a pulse follow each other faster than the array comes to rest. A finger may slide meanwhile: the exact
hidden Markov filter of :mod:`localize.live.touch_filter`, run forward and backward over the contact, tells which point
was touched when, and each point that was held long enough is a touch. While it lasts the forward filter
alone tells where it came down and moved. Frames 16 ms apart share most of their samples; their log-likelihoods count in
proportion to what is new in them, and to their level (in sound, to what stands out of it) and the square of the share
of them that the contact fills: a frame that a touch begins or ends in, or what is left
of a touch once its beginning has passed out of the frame, names wrong points with certainty.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.special import softmax

from localize.live.events import HOP, Decision, Fault, TouchEvent
from localize.live.touch_filter import TouchFilter
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

PAUSE = 0.05
"""Longest interruption after which a contact goes on, s."""
HELD = 6
"""Number of frames, 96 ms, that a point must be named for: for fewer within a longer contact it is passed over."""
LIKELY = 0.5
"""Probability that a point must reach, by what its frames hold of it, to be touched in a contact shorter than that:
sound that rises and falls within one touch makes such pieces."""
STAY, JUMP = 0.97, 1e-3
"""Probability of staying at a point from one frame to the next, 16 ms later, and of landing anywhere."""
FALLEN, RISEN = 0.4, 2.0
"""Share of a contact's loudest frame to which its level must fall, and factor by which it must rise from there, where a
new touch begins."""
AGREE = 3
"""Number of frames in a row that must name the same point before it is told."""
MOST = 3750
"""Number of frames, a minute, after which a contact is taken for a new one."""
_LEAST_PROBABILITY = 1e-12


class Array(Protocol):
    """Points of an array."""

    @property
    def line(self) -> NDArray[np.int64]:
        """Line of each point; (n_point,) int64."""

    @property
    def place(self) -> NDArray[np.int64]:
        """Place of each point along its line; (n_point,) int64."""


@dataclass(frozen=True)
class Touch:
    """Touch of one point for a while."""

    start: float
    """Time of the end of the first frame that heard it, s; the touch began at most a frame (250 ms) before."""
    end: float
    """Time of the end of the last frame that heard it, s."""
    point: int
    """Point that was touched, from 1."""
    probability: float
    """Probability of the point by what all its frames say together."""
    level: float
    """Level of the loudest microphone in the loudest frame, Pa rms."""


class ContactCutter:
    """Cutter of a stream's decisions into contacts."""

    def __init__(self) -> None:
        self._last: Decision | None = None
        self._loudest = self._least = 0.0
        self._count = 0

    def take(self, event: Decision) -> Literal["begins", "goes on", "over"]:
        """Say what a decision means for contacts: one that begins ends that before it."""
        last = self._last
        # Time steps back where a device counts anew.
        apart = last is None or not 0 < event.time - last.time <= PAUSE + HOP / SAMPLE_RATE
        if event.state != "touch":
            self._last = None if apart else last
            return "over" if apart else "goes on"
        rises = self._least < FALLEN * self._loudest and event.level > RISEN * self._least
        self._last = event
        self._count += 1
        if apart or rises or self._count > MOST:
            self._loudest = self._least = event.level
            self._count = 1
            return "begins"
        if event.level > self._loudest:
            self._loudest = self._least = event.level
        self._least = min(self._least, event.level)
        return "goes on"


def touches_of(events: Iterable[Decision | Fault], array: Array) -> list[Touch]:
    """Touches into which the decisions of a stream join.

    Args:
        events: what :meth:`localize.TouchStream.push` returned, in order.
        array: whatever decided: its points' lines and places.
    """
    contacts: list[list[Decision]] = []
    cutter = ContactCutter()
    for event in events:
        if isinstance(event, Decision):
            if cutter.take(event) == "begins":
                contacts.append([])
            if event.state == "touch":
                contacts[-1].append(event)
    listener = TouchFilter(array.line, array.place, STAY, JUMP)
    return [touch for contact in contacts for touch in _touches(contact, listener)]


class _Evidence:
    """What the frames of a contact say together of its point.

    What is new in each frame counts in proportion to its level, and what the first frame holds from before it counts as
    the loudest one says: that holds most of the touch.
    """

    def __init__(self) -> None:
        self._sum: NDArray[np.float64] | float = 0.0
        self._levels = self._loudest = 0.0
        self._of_loudest: NDArray[np.float64] = np.empty(0)

    def take(self, log_probability: NDArray[np.float64], level: float) -> None:
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
    """Tracker that tells beginnings, moves and ends of touches while they happen.

    Args:
        array: whatever decides: its points' lines and places.
        delay: s, by which the stream hears later than its samples are: :attr:`localize.TouchStream.delay`.
    """

    def __init__(self, array: Array, delay: float = 0.0) -> None:
        self._cutter, self._delay = ContactCutter(), delay
        self._filter = TouchFilter(array.line, array.place, STAY, JUMP)
        self._touch = 0  # number of the last one that came down
        self._point: int | None = None  # that is told, from 0
        self._contact: list[Decision] = []
        self._evidence = _Evidence()
        self._belief: NDArray[np.float64] = np.empty(0)
        self._other = 0  # frames in a row that name another point

    def take(self, event: object) -> list[TouchEvent]:
        """Take the next event of a stream and say what it means; nothing of what is no decision."""
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
            agreed = count >= AGREE and {each.point for each in self._contact[-AGREE:]} == {best + 1}
            likely = count >= HELD and self._belief[best] >= LIKELY
            return self._down(event.time, best) if agreed or likely else []
        self._other = self._other + 1 if best != self._point else 0
        if self._other < HELD:
            return []
        self._point, self._other = best, 0
        return [self._told("moved", event.time, self._contact[-HELD].time)]

    def _down(self, time: float, point: int) -> list[TouchEvent]:
        self._touch += 1
        self._point = point
        return [self._told("down", time, self._contact[0].time)]

    def _end(self, time: float) -> list[TouchEvent]:
        """The contact so far is over."""
        told: list[TouchEvent] = []
        if self._contact:
            last = self._contact[-1].time
            if self._point is None and self._belief.max() >= LIKELY:
                told += self._down(max(time, last), int(self._belief.argmax()))
            if self._point is not None:
                told.append(self._told("up", max(time, last), last))
        self._contact, self._point, self._other = [], None, 0
        self._evidence = _Evidence()
        self._filter.reset()
        return told

    def _told(self, kind: Literal["down", "moved", "up"], time: float, first: float) -> TouchEvent:
        """Event that is told at a time, of what the frame that ends at ``first`` was the first to show."""
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


def _touches(contact: list[Decision], listener: TouchFilter) -> list[Touch]:
    each = np.stack([decision.distribution for decision in contact if decision.distribution is not None])
    heard = np.array([decision.level if decision.weight is None else decision.weight for decision in contact])
    weight = HOP / FRAME * heard / heard.max() * _covered(len(contact)) ** 2
    log_probability = np.log(each.clip(_LEAST_PROBABILITY))
    probability = listener.forward_backward(weight[:, None] * log_probability)
    named = probability.argmax(1)
    edges = [0, *(np.flatnonzero(np.diff(named)) + 1).tolist(), len(named)]
    runs = [(a, b) for a, b in pairwise(edges) if b - a >= HELD]
    if not runs:  # too short for anything else: the point of most weight, where there is one
        of_points = weight @ probability / weight.sum()
        best = int(of_points.argmax())
        return [_touch(contact, log_probability, heard, best)] if of_points[best] >= LIKELY else []
    return [_touch(contact[a:b], log_probability[a:b], heard[a:b], int(named[a])) for a, b in runs]


def _covered(count: int) -> NDArray[np.float64]:
    """(count,) share of each frame of a contact that the contact fills: less at its beginning and end."""
    frame = np.arange(count)
    return np.clip(np.minimum(frame + 1, count - frame) * HOP / FRAME, 0.0, 1.0)


def _touch(
    decisions: list[Decision], log_probability: NDArray[np.float64], heard: NDArray[np.float64], point: int
) -> Touch:
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
