"""Numbers of the touch tracker in C: the options of touches in samples and decisions, and the neighbours of points."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.embedded.decoder_tables import EmbeddedTables
from localize.live.events import HOP
from localize.live.front_end import HighPass
from localize.live.joined_contacts import LEAST_PROBABILITY
from localize.live.pressure_course import HOP_SECONDS, RESTS
from localize.live.stream_options import HIGH_PASS, TouchOptions
from localize.live.touch_filter import TouchFilter
from localize.signals.stimulus import SAMPLE_RATE


def tracker_options(options: TouchOptions = TouchOptions()) -> dict[str, int | float]:
    """Options by their names in C: whole numbers are samples or decisions, floats have no unit or are decisions."""
    return {
        "AGREE": options.agree,
        "BEFORE": options.before,
        "HELD": options.held,
        "LONGEST": options.longest,
        "WAIT": options.longest_wait,
        "REMEMBERED": round(options.remembered / HOP_SECONDS),
        "PAUSE": HOP + _samples(options.pause),
        "LONGEST_HOLD": _samples(options.longest_hold),
        "SHORTEST_BEAT": _samples(options.shortest_beat),
        "LONGEST_BEAT": _samples(options.longest_beat),
        "LIKELY": options.likely,
        "JUMP": options.jump,
        "FALLEN": options.fallen,
        "RISEN": options.risen,
        "MOVED": math.log(options.moved),
        "OTHER_POINT": math.log(options.other_point),
        "HELD_FRACTION": options.held_fraction,
        "TREMOR": options.tremor,
        "SURELY": options.surely,
        "TAIL": options.tail,
        "SLOW": options.slow / HOP_SECONDS,
        "ROUNDNESS": options.roundness,
        "REST": options.rest,
        "BEAT_LEVEL": options.beat_level,
        "RESTS": RESTS,
        "LEAST": LEAST_PROBABILITY,
    }


def stream_delay() -> float:
    """Delay of the high-pass of the decoder, s."""
    return HighPass(1, HIGH_PASS).delay


def point_steps(
    tables: EmbeddedTables, options: TouchOptions = TouchOptions()
) -> tuple[NDArray[np.int16], Array, Array]:
    """Steps of a touch from point to point, without those that land anywhere.

    Args:
        tables: of the array.
        options: how probable the steps are.

    Returns:
        Neighbours of each point, (n_point, n) int16, from 0, and -1 where there are fewer than n; the probability of
        staying at each point, and that of going on to one of its neighbours, (n_point,) float64 each.
    """
    transition = TouchFilter(tables.line, tables.place, options.stay, options.jump).transition
    steps = transition - options.jump / len(transition)
    staying = np.diagonal(steps).copy()
    np.fill_diagonal(steps, 0.0)
    is_step = steps > 1e-12
    most = max(1, int(is_step.sum(1).max()))
    neighbours = np.full((len(steps), most), -1, np.int16)
    for row, found in zip(neighbours, is_step, strict=True):
        row[: found.sum()] = np.flatnonzero(found)
    return neighbours, staying, steps.max(1)


def _samples(seconds: float) -> int:
    return round(seconds * SAMPLE_RATE)
