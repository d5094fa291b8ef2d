"""Touches from the decisions of a stream: when each began and ended, and where it was.

Frames that are told from silence and follow each other are one contact. A finger may slide meanwhile: the exact
hidden Markov filter of :mod:`localize.live.touch_filter`, run forward and backward over the contact, tells which point
was touched when, and each point that was held long enough is a touch. Frames 16 ms apart share most of their samples;
their log-likelihoods count in proportion to what is new in them, and to their level (in sound, to what stands out of
it) and the square of the share of them that the contact fills: a frame that a touch begins or ends in, or what is left
of a touch once its beginning has passed out of the frame, names wrong points with certainty.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from localize.live.stream import HOP, Decision, Fault
from localize.live.touch_filter import TouchFilter
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

PAUSE = 0.05
"""Longest interruption after which a contact goes on, s."""
HELD = 6
"""Number of frames, 96 ms, that a point must be named for: for fewer within a longer contact it is passed over."""
LIKELY = 0.5
"""Probability that a point must reach to be touched in a contact shorter than that."""
STAY, JUMP = 0.97, 1e-3
"""Probability of staying at a point from one frame to the next, 16 ms later, and of landing anywhere."""
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
    """Mean probability of the point over its frames, each by how much of the touch is in it."""
    level: float
    """Level of the loudest microphone in the loudest frame, Pa rms."""


def touches_of(events: Iterable[Decision | Fault], array: Array) -> list[Touch]:
    """Touches into which the decisions of a stream join.

    Args:
        events: what :meth:`localize.TouchStream.push` returned, in order.
        array: whatever decided: its points' lines and places.
    """
    contacts: list[list[Decision]] = []
    for event in events:
        if isinstance(event, Decision) and event.state == "touch":
            # Time steps back where a device counts anew.
            if not contacts or not 0 < event.time - contacts[-1][-1].time <= PAUSE + HOP / SAMPLE_RATE:
                contacts.append([])
            contacts[-1].append(event)
    listener = TouchFilter(array.line, array.place, STAY, JUMP)
    return [touch for contact in contacts for touch in _touches(contact, listener)]


def _touches(contact: list[Decision], listener: TouchFilter) -> list[Touch]:
    each = np.stack([decision.distribution for decision in contact if decision.distribution is not None])
    heard = np.array([decision.level if decision.weight is None else decision.weight for decision in contact])
    weight = HOP / FRAME * heard / heard.max() * _covered(len(contact)) ** 2
    probability = listener.forward_backward(weight[:, None] * np.log(each.clip(_LEAST_PROBABILITY)))
    named = probability.argmax(1)
    edges = [0, *(np.flatnonzero(np.diff(named)) + 1).tolist(), len(named)]
    runs = [(a, b) for a, b in pairwise(edges) if b - a >= HELD]
    if not runs:  # too short for anything else: the point of most weight, where there is one
        best = int((weight @ probability).argmax())
        touch = _touch(contact, probability[:, best], weight, best)
        return [touch] if touch.probability >= LIKELY else []
    return [_touch(contact[a:b], probability[a:b, named[a]], weight[a:b], int(named[a])) for a, b in runs]


def _covered(count: int) -> NDArray[np.float64]:
    """(count,) share of each frame of a contact that the contact fills: less at its beginning and end."""
    frame = np.arange(count)
    return np.clip(np.minimum(frame + 1, count - frame) * HOP / FRAME, 0.0, 1.0)


def _touch(
    decisions: list[Decision], probability: NDArray[np.float64], weight: NDArray[np.float64], point: int
) -> Touch:
    return Touch(
        start=decisions[0].time,
        end=decisions[-1].time,
        point=point + 1,
        probability=float(np.average(probability, weights=weight)),
        level=max(decision.level for decision in decisions),
    )
