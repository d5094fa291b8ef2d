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

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import softmax

from geometry.ground.typed import Array
from localize.live.events import HOP, Decision, Fault, TouchEvent
from localize.live.joined_contacts import Step, TouchJoiner, log_probability_of
from localize.live.stream_options import TouchOptions
from localize.live.touch_filter import TouchFilter
from localize.signals.array_facts import ArrayFacts
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE


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
    beats: tuple[float, ...] = ()
    """Times at which the beats of a pulse began, s; empty if there are not at least two."""


def touches_of(
    events: Iterable[Decision | Fault], array: ArrayFacts | Locator, options: TouchOptions = TouchOptions()
) -> list[Touch]:
    """Touches into which the decisions of a stream join.

    Args:
        events: what :meth:`localize.TouchStream.push` returned, in order.
        array: lines and places of the points that were decided on.
        options: how decisions join.
    """
    joiner, found = TouchJoiner(options), list[_Frames]()
    steps = [step for event in events if isinstance(event, Decision) for step in joiner.take(event)]
    for step in (*steps, *joiner.finish()):
        if step.kind == "begins":
            found.append(_Frames())
        if step.is_new_contact:
            found[-1].begins.append(len(found[-1].frames))
        if step.kind == "beat":
            found[-1].beats.append(step.frames[0].time)
        if step.kind == "ends":
            found[-1].end = step.last
        found[-1].frames += step.frames
    tracked = TouchFilter(array.line, array.place, options.stay, options.jump)
    return [touch for frames in found for touch in _touches(frames, tracked, options)]


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

    @property
    def total(self) -> Array:
        """Log-probability of each point up to a constant, (n_point,) nats."""
        new = HOP / FRAME / self._loudest
        return np.asarray(new * self._sum + max(0.0, 1.0 - new * self._levels) * self._of_loudest)

    def probability(self, point: int) -> float:
        """Probability that the contact was at a point, from 0."""
        return float(softmax(self.total)[point])


def _evidence_of(log_probability: Iterable[Array], levels: Iterable[float]) -> _Evidence:
    """Evidence of frames: log-probabilities of each, (n_point,) nats, and its level."""
    evidence = _Evidence()
    for each, level in zip(log_probability, levels, strict=True):
        evidence.take(each, level)
    return evidence


class TouchTracker:
    """Tracker that reports the beginnings, moves, beats and ends of touches while they happen.

    Args:
        array: lines and places of the points that are decided on.
        delay: delay of the stream, s: :attr:`localize.TouchStream.delay`.
        options: how decisions join.
    """

    def __init__(self, array: ArrayFacts | Locator, delay: float = 0.0, options: TouchOptions = TouchOptions()) -> None:
        self._joiner, self._delay, self._options = TouchJoiner(options), delay, options
        self._filter = TouchFilter(array.line, array.place, options.stay, options.jump)
        self._touch = 0  # number of the last touch that came down
        self._now = 0.0
        self._reset()

    def _reset(self) -> None:
        self._point: int | None = None  # that is reported, from 0
        self._frames: list[Decision] = []
        self._count = 0  # of frames of the contact
        self._loudest = 0.0
        self._evidence = _Evidence()
        self._belief: Array = np.empty(0)
        self._other = 0  # frames in a row that name another point
        self._filter.reset()

    def take(self, event: object) -> list[TouchEvent]:
        """Touch events that follow from the next event of a stream; none from events that are not decisions."""
        if not isinstance(event, Decision):
            return []
        self._now = event.time
        return [told for step in self._joiner.take(event) for told in self._told(step)]

    def finish(self) -> list[TouchEvent]:
        """End the touch that the stream ends in, if there is one."""
        self._now = self._frames[-1].time if self._frames else 0.0
        return [told for step in self._joiner.finish() for told in self._told(step)]

    def _told(self, step: Step) -> list[TouchEvent]:
        if step.kind == "begins":
            self._reset()
        if step.is_new_contact:
            self._count = self._other = 0
        told = [event for frame in step.frames for event in self._goes_on(frame)]
        if step.kind == "beat" and self._point is not None:
            told.append(self._event("beat", self._now, step.frames[0].time))
        if step.kind in ("rests", "ends"):
            # A contact that was too short for its frames to agree.
            if self._point is None and self._belief.max() >= self._options.likely:
                told += self._down(int(self._belief.argmax()))
            if step.kind == "ends" and self._point is not None:
                told.append(self._event("up", max(self._now, step.last), step.last))
        return told

    def _goes_on(self, event: Decision) -> list[TouchEvent]:
        options = self._options
        self._frames.append(event)
        self._count += 1
        self._loudest = max(self._loudest, event.level)
        log_probability = log_probability_of(event)
        self._evidence.take(log_probability, event.level)
        # Where the touch is, and when that is sure: not how sure, for of the first frames next to nothing counts.
        weight = HOP / FRAME * event.level / self._loudest * min(self._count * HOP / FRAME, 1.0) ** 2
        self._belief = self._filter.update(weight * log_probability)
        best = int(self._belief.argmax())
        agreed = self._count >= options.agree and {each.point for each in self._frames[-options.agree :]} == {best + 1}
        if self._point is None:
            # The first frames hold next to nothing of the touch.
            likely = self._count >= options.held and self._belief[best] >= options.likely
            return self._down(best) if agreed or likely else []
        self._other = self._other + 1 if best != self._point else 0
        if self._other < options.held or not agreed:
            return []
        newest = self._frames[-self._other :]
        there = _evidence_of(map(log_probability_of, newest), [each.level for each in newest]).total
        if there[best] - there[self._point] < math.log(options.moved):
            return []
        self._point, first = best, self._frames[-self._other]
        self._other = 0
        return [self._event("moved", self._now, first.time)]

    def _down(self, point: int) -> list[TouchEvent]:
        self._touch += 1
        self._point = point
        return [self._event("down", self._now, self._frames[0].time)]

    def _event(self, kind: Literal["down", "moved", "beat", "up"], time: float, first: float) -> TouchEvent:
        """Event that is reported at a time, of what the frame that ends at ``first`` was the first to show."""
        assert self._point is not None
        return TouchEvent(
            time=time,
            kind=kind,
            touch=self._touch,
            point=self._point + 1,
            probability=self._evidence.probability(self._point),
            level=self._frames[-1].level,
            latency=time - first + HOP / SAMPLE_RATE + self._delay,
        )


@dataclass
class _Frames:
    """Frames of a touch."""

    frames: list[Decision] = field(default_factory=list)
    begins: list[int] = field(default_factory=list)
    """Frame with which each contact begins."""
    beats: list[float] = field(default_factory=list)
    """Times at which beats but the first began, s."""
    end: float = 0.0
    """Time at which the touch was last there, s."""


def _touches(touch: _Frames, tracked: TouchFilter, options: TouchOptions) -> list[Touch]:
    frames = touch.frames
    heard = np.array([decision.level if decision.weight is None else decision.weight for decision in frames])
    covered = [_covered(end - begin) for begin, end in pairwise([*touch.begins, len(frames)])]
    weight = HOP / FRAME * heard / heard.max() * np.concatenate(covered) ** 2
    log_probability = np.stack([log_probability_of(each) for each in frames])
    probability = tracked.forward_backward(weight[:, None] * log_probability)
    runs = _runs(probability.argmax(1), log_probability, heard, options)
    if not runs:  # too short for anything else: the point of most weight, where there is one
        of_points = weight @ probability / weight.sum()
        best = int(of_points.argmax())
        runs = [(0, len(frames), best)] if of_points[best] >= options.likely else []
    beats = (frames[0].time, *touch.beats) if touch.beats else ()
    found = []
    for k, (a, b, point) in enumerate(runs):
        end = touch.end if k == len(runs) - 1 else frames[b - 1].time
        found.append(_touch(frames[a:b], log_probability[a:b], heard[a:b], point, end, beats))
    return found


def _runs(
    named: NDArray[np.int64], log_probability: Array, heard: Array, options: TouchOptions
) -> list[tuple[int, int, int]]:
    """Runs of frames of one point each, first and last + 1, and the point; those that are not surely apart are one."""
    edges = [0, *(np.flatnonzero(np.diff(named)) + 1).tolist(), len(named)]
    found: list[tuple[int, int, int]] = []
    for a, b in pairwise(edges):
        if b - a < options.held:
            continue
        here, point = _evidence_of(log_probability[a:b], heard[a:b]).total, int(named[a])
        if found:
            first, last, before = found[-1]
            there = _evidence_of(log_probability[first:last], heard[first:last]).total
            least = math.log(options.moved)
            if point == before or min(here[point] - here[before], there[before] - there[point]) < least:
                both = _evidence_of(log_probability[first:b], heard[first:b]).total
                found[-1] = first, b, point if both[point] > both[before] else before
                continue
        found.append((a, b, point))
    return found


def _covered(count: int) -> Array:
    """(count,) share of each frame of a contact that the contact fills: less at its beginning and end."""
    frame = np.arange(count)
    return np.clip(np.minimum(frame + 1, count - frame) * HOP / FRAME, 0.0, 1.0)


def _touch(
    decisions: list[Decision], log_probability: Array, heard: Array, point: int, end: float, beats: tuple[float, ...]
) -> Touch:
    evidence = _evidence_of(log_probability, heard)
    start = decisions[0].time
    return Touch(
        start=start,
        end=end,
        point=point + 1,
        probability=evidence.probability(point),
        level=max(decision.level for decision in decisions),
        beats=tuple(beat for beat in beats if start <= beat <= end),
    )
