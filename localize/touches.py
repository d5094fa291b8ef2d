"""Touches from the decisions of a stream: when each began and ended, and where it was."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from localize.frames import FRAME
from localize.stimulus import SAMPLE_RATE
from localize.stream import HOP, Decision, Fault

PAUSE = 0.05
"""s: a touch that is interrupted for less goes on."""
_LEAST_PROBABILITY = 1e-12


@dataclass(frozen=True)
class Touch:
    """Frames that follow each other and are told from silence."""

    start: float
    """s: end of the first frame that heard it; the touch began at most a frame (250 ms) before."""
    end: float
    """s: end of the last frame that heard it."""
    point: int
    """From 1."""
    probability: float
    level: float
    """Pa rms of the loudest microphone in the loudest frame."""


def touches_of(events: Iterable[Decision | Fault]) -> list[Touch]:
    """Join the decisions of a stream into touches, one point each.

    Frames overlap: the log-probabilities of one touch are added up with the weight of a hop in a frame, so that two
    frames that share no sample count as two observations, and a touch of a few frames as one.

    Args:
        events: what :meth:`localize.TouchStream.push` returned, in order.
    """
    groups: list[list[Decision]] = []
    for event in events:
        if isinstance(event, Decision) and event.state == "touch":
            if not groups or event.time - groups[-1][-1].time > PAUSE + HOP / SAMPLE_RATE:
                groups.append([])
            groups[-1].append(event)
    return [_joined(group) for group in groups]


def _joined(group: list[Decision]) -> Touch:
    each = np.stack([decision.distribution for decision in group if decision.distribution is not None])
    observations = max(1.0, len(each) * HOP / FRAME)
    score = observations * np.log(each.clip(_LEAST_PROBABILITY)).mean(0)
    probability = np.exp(score - score.max())
    probability /= probability.sum()
    best = int(probability.argmax())
    return Touch(
        start=group[0].time,
        end=group[-1].time,
        point=best + 1,
        probability=float(probability[best]),
        level=max(decision.level for decision in group),
    )
