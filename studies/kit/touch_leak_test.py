"""Leak test of a finished sensor by touches: order of the touches, and what a leak of each point would change.

A leak lets the pressure out that passes its cavity. So a touch on one side of it reaches the microphone on the other
side with less level, and the difference of the levels of two microphones changes. The difference does not depend on
how hard the finger touches. Its change is computed with the closed forms of the network, and compared with the spread
of sensors that have the tolerances of a workshop: a smaller change cannot be distinguished from the spread by hand.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from acoustic_fem.batch import ArrayParameters, Topology, batch_response
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.units import metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from localize.diagnosis.bench_advice import AUDIBLE
from localize.diagnosis.faults import HOLE_LENGTH
from studies.kit.expected_signals import FREQUENCY

TOUCHED_HOLE = 0.2
"""Diameter of the hole whose signal is stated, mm: a joint that the glue has missed on one side."""
FEWEST_TOUCHES = 24
"""Number of touches that a diagnosis should have."""
READABLE = 1.0
"""Smallest change of a difference of levels that can be read from touches, dB; assumed."""
_HOLES = (0.03, 3.0)
_STEPS = 24


@dataclass(frozen=True)
class LeakSign:
    """Change by which touches show a leak at one point, at its membrane or at a joint of its tubes."""

    point: int
    """Point that leaks, from 1."""
    touched: int
    """Point whose touch shows it best, from 1."""
    one: str
    """Microphone whose level is compared."""
    other: str
    """Microphone with which it is compared."""
    tight: float
    """Level of the one above the other, if nothing leaks, dB."""
    leaking: float
    """The same with a hole of :data:`TOUCHED_HOLE` at the point, dB."""
    spread: float
    """Two standard deviations of that difference over as-built sensors, dB."""
    smallest_hole: float | None
    """Diameter of the smallest hole whose change is larger than the spread and :data:`READABLE`, mm; None if not even
    3 mm are."""


def touch_order(design: ArrayDesign) -> tuple[int, ...]:
    """Points to touch, from 1: every point in the order of its number, again until there are enough touches."""
    rounds = -(-FEWEST_TOUCHES // design.point_count)
    return tuple(range(1, design.point_count + 1)) * rounds


def leak_signs(design: ArrayDesign, built: Array | None) -> tuple[LeakSign, ...]:
    """Change by which touches show a leak at each point; none for a design whose closed forms or scatter are not known.

    Args:
        design: the array, with two microphones or more.
        built: levels of as-built sensors, see :func:`studies.kit.expected_signals.as_built_levels`.
    """
    if built is None:
        return ()
    pairs = np.array(list(combinations(range(built.shape[2]), 2)))
    try:
        tight = _levels(design, 0.0)[0]
    except Refusal:
        return ()
    leaking = _levels(design, TOUCHED_HOLE)
    spread = 2 * np.std(built[..., pairs[:, 0]] - built[..., pairs[:, 1]], axis=0)  # (n_point, n_pair)
    unclear = np.maximum(spread, READABLE)
    before = tight[:, pairs[:, 0]] - tight[:, pairs[:, 1]]
    after = leaking[..., pairs[:, 0]] - leaking[..., pairs[:, 1]]  # (n_point leaking, n_point touched, n_pair)
    heard = np.minimum(tight[:, pairs[:, 0]], tight[:, pairs[:, 1]]) > AUDIBLE
    clarity = np.where(heard, np.abs(after - before) / unclear, 0.0)
    number = np.arange(len(tight))
    clarity[number, number] = 0.0  # a finger on a leak may close it
    best = clarity.reshape(len(tight), -1).argmax(1)
    touched, pair = np.unravel_index(best, clarity.shape[1:])
    smallest = _smallest_holes(design, before, unclear, touched, pairs[pair], pair)
    names = design.microphones
    return tuple(
        LeakSign(
            int(k) + 1,
            int(touched[k]) + 1,
            names[pairs[pair[k], 0]],
            names[pairs[pair[k], 1]],
            float(before[touched[k], pair[k]]),
            float(after[k, touched[k], pair[k]]),
            float(spread[touched[k], pair[k]]),
            smallest[k],
        )
        for k in number
    )


def _smallest_holes(
    design: ArrayDesign, before: Array, unclear: Array, touched: Array, chosen: Array, pair: Array
) -> list[float | None]:
    """Smallest hole at each point that changes the chosen difference by more than what is unclear (dB), mm."""
    holes = np.geomspace(*_HOLES, _STEPS)
    number = np.arange(len(before))
    found = np.full(len(before), np.nan)
    for hole in holes[::-1]:
        levels = _levels(design, float(hole))[number, touched]
        difference = levels[number, chosen[:, 0]] - levels[number, chosen[:, 1]]
        shows = np.abs(difference - before[touched, pair]) > unclear[touched, pair]
        # From the largest hole down, as long as every larger one shows.
        found = np.where(shows & ((hole == holes[-1]) | np.isfinite(found)), hole, found)
        if not shows.any():
            break
    return [None if np.isnan(each) else float(each) for each in found]


def _levels(design: ArrayDesign, hole: float) -> Array:
    """Level of touches relative to the touched cavity with a hole (mm) at each point in turn, dB.

    Returns:
        (n_point leaking, n_point touched, n_microphone) float64; one row if the hole is 0.
    """
    air, shared = design_air(design), Topology.of(design)
    parameters = ArrayParameters.from_design(design, air).individual(shared)
    if hole:
        conductance = leak_conductance(metres(hole) / 2, metres(HOLE_LENGTH), air)
        added = np.asarray(parameters.leak_conductance) + np.eye(design.point_count) * conductance
        parameters = replace(parameters, leak_conductance=added)
    response = batch_response(parameters, shared.individual(), np.array([FREQUENCY]), air)
    return np.asarray(20 * np.log10(np.abs(response.transfer_function[..., 0])))
