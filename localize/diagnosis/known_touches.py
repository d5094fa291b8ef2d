"""Known points of touches, matched to the touches that were found in a recording.

Points in the order of the touches fit one by one if there are as many. A finger that bounces makes two touches of one,
and a light touch is not found, so one or two more or fewer are tolerated. All ways to match the points in their order
are then compared by the likelihoods of the touches, on the sound sensor and on that with each fault. A touch whose
point is not certain stays unknown.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TypeAlias

import numpy as np
import scipy.special
from numpy.typing import NDArray

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from localize.diagnosis.diagnosis_options import DiagnosisOptions
from localize.diagnosis.fault_libraries import FaultLibraries
from localize.diagnosis.fault_likelihood import TouchLikelihood
from localize.diagnosis.touch_spectra import TouchSpectra

KnownPoints: TypeAlias = Sequence[int] | Mapping[float, int]
"""Points of all touches in their order, or of some of them by a time within the touch, s; points count from 1."""

NEAR = 0.3
"""Time from the beginning of a touch within which a stated time means it, s, unless it lies within the touch."""


@dataclass(frozen=True, eq=False)
class KnownTouches:
    """Known points of the touches of a recording."""

    point: NDArray[np.int64]
    """Index of the point of each touch, (n_touch,) int64; -1 where it is not known."""
    note: str = ""
    """Sentence about touches that were missed or doubled; empty if there is one touch for each point."""


def known_touches(
    points: KnownPoints | None, spectra: TouchSpectra, libraries: FaultLibraries, options: DiagnosisOptions
) -> KnownTouches:
    """Known points of touches.

    Args:
        points: as they are given.
        spectra: of the touches.
        libraries: of the faults.
        options: of the diagnosis.

    Raises:
        Refusal: a point that the array does not have, numbers of points and touches that differ by more than
            :attr:`DiagnosisOptions.unmatched`, or a time at which there is no touch.
    """
    known = np.full(len(spectra.start), -1, np.int64)
    if not points:
        return KnownTouches(known)
    values = points.values() if isinstance(points, Mapping) else points
    for value in values:
        check_range("points", value, 1, libraries.design.point_count, whole=True, why="the points of the array")
    if isinstance(points, Mapping):
        return KnownTouches(_at_times(points, spectra))
    stated = np.array(points, np.int64) - 1
    if len(stated) == len(known):
        return KnownTouches(stated)
    if abs(len(stated) - len(known)) > options.unmatched:
        raise Refusal(
            f"states {counted(len(stated), 'point')}, but {counted(len(known), 'touch')} were found, at "
            f"{_listed(spectra.start)} s",
            kind=Kind.MISMATCH,
            field="points",
            remedy=f"touch once for each point, at most {options.unmatched} more or fewer, or give points by their "
            "times, such as 2.5=9",
        )
    return _matched(stated, spectra, libraries, options)


def _at_times(points: Mapping[float, int], spectra: TouchSpectra) -> NDArray[np.int64]:
    """Index of the point of each touch by times within touches, (n_touch,) int64; -1 where none is given."""
    known = np.full(len(spectra.start), -1, np.int64)
    for time, value in points.items():
        inside = np.flatnonzero((spectra.start - NEAR <= time) & (time <= spectra.end + NEAR))
        if not len(inside):
            raise Refusal(
                f"states a touch at {time:g} s; touches begin at {_listed(spectra.start)} s",
                kind=Kind.MISMATCH,
                field="points",
            )
        known[inside] = value - 1
    return known


def _matched(
    stated: NDArray[np.int64], spectra: TouchSpectra, libraries: FaultLibraries, options: DiagnosisOptions
) -> KnownTouches:
    """Points in their order, of which one or two are missed or doubled."""
    orders = _orders(len(stated), len(spectra.start))
    likelihood = TouchLikelihood(spectra, np.full(len(spectra.start), -1, np.int64), options.mismatch)
    every, points = np.arange(len(spectra.start)), stated[orders]
    scores = np.array(
        [
            likelihood.by_point(tables.transfer_function, tables.spread, options.first_mismatches[0])[every, points]
            for tables in libraries.screening
        ]
    ).sum(2)
    probability = scipy.special.softmax(scores / options.evidence_temperature).sum(0)  # (n_order,)
    by_point = np.zeros((len(every), libraries.design.point_count))
    for order, own in zip(points, probability, strict=True):
        by_point[every, order] += own
    known = np.where(by_point.max(1) > options.matched, by_point.argmax(1), -1)
    is_certain = bool(probability.max() > options.matched)
    note = _note(orders[probability.argmax()], is_certain, stated, spectra.start, int((known < 0).sum()))
    return KnownTouches(known, note)


def _orders(stated: int, found: int) -> NDArray[np.int64]:
    """Numbers of stated points that the found touches may be of, each order a row, (n_order, found) int64."""
    if stated > found:
        missed = combinations(range(stated), stated - found)
        return np.array([np.delete(np.arange(stated), list(each)) for each in missed])
    doubled = combinations(range(1, found), found - stated)
    return np.array([np.arange(found) - np.isin(np.arange(found), each).cumsum() for each in doubled])


def _note(order: NDArray[np.int64], is_certain: bool, stated: NDArray[np.int64], start: Array, unknown: int) -> str:
    """Sentence about the likeliest order."""
    counts = np.bincount(order, minlength=len(stated))
    found = [f"touch {k + 1} (point {stated[k] + 1}) was missed" for k in np.flatnonzero(counts == 0).tolist()]
    for k in np.flatnonzero(counts > 1).tolist():
        times = _listed(start[order == k])
        found.append(f"touch {k + 1} (point {stated[k] + 1}) was found as {counts[k]} touches, at {times} s")
    doubt = f" The points of {counted(unknown, 'touch')} are uncertain and count as unknown." if unknown else ""
    return (
        f"{counted(len(stated), 'point')} are stated and {counted(len(start), 'touch')} were found: "
        f"{'most probably' if is_certain else 'perhaps'} {'; '.join(found)}.{doubt}"
    )


def _listed(start: Array) -> str:
    """Times as a list, s."""
    return ", ".join(f"{each:.1f}" for each in start)
