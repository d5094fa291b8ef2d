"""The pulse of an artery under a finger: forces of hearts of several ages and rhythms, with the times of their waves.

The order and rough times of the waves are those of the radial pulse (Nichols and O'Rourke, McDonald's Blood Flow in
Arteries). The kinds of shape follow the classes of Dawber, Thomas and McNamara (1973, Angiology 24, 244), from a
distinct notch to none. All ranges are ours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, Unpack, get_args

import numpy as np

from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.typed import Array
from localize.contacts.contact import Contact
from localize.contacts.contact_shapes import FINGER, Place, still, times
from localize.contacts.draws import Draws, Stream

#: Kinds of shape of a beat.
PulseShape = Literal["three waves", "stiff arteries", "dilated arteries", "one wave"]
#: Kinds of rhythm.
Rhythm = Literal["even", "early beats", "irregular"]

HEART_RATES = (30.0, 220.0)
"""Lowest and highest heart rate, beats a minute."""
WAVES: dict[PulseShape, dict[str, tuple[tuple[float, float], tuple[float, float], tuple[float, float]]]] = {
    "three waves": {
        "percussion": ((0.11, 0.14), (1.0, 1.0), (0.040, 0.050)),
        "tidal": ((0.24, 0.29), (0.45, 0.75), (0.050, 0.065)),
        "dicrotic": ((0.42, 0.50), (0.25, 0.45), (0.055, 0.075)),
    },
    "stiff arteries": {
        "percussion": ((0.11, 0.14), (1.0, 1.0), (0.040, 0.050)),
        "tidal": ((0.21, 0.25), (0.80, 1.10), (0.050, 0.065)),
        "dicrotic": ((0.42, 0.50), (0.08, 0.20), (0.055, 0.075)),
    },
    "dilated arteries": {
        "percussion": ((0.11, 0.14), (1.0, 1.0), (0.050, 0.060)),
        "dicrotic": ((0.40, 0.48), (0.30, 0.55), (0.060, 0.080)),
    },
    "one wave": {"percussion": ((0.13, 0.18), (1.0, 1.0), (0.060, 0.090))},
}
"""Ranges of each wave by shape: its time after the foot at 75 beats a minute, s; its height against the first; its
standard deviation, s. In stiff arteries the reflected wave comes early and high; where arteries are dilated, it is
lost."""
PULSE_FADE = 0.2
"""Time in which a pulse is faded in, and out, s."""
EARLY, EARLY_EVERY, EARLY_HEIGHT = 0.65, (4, 8), (0.6, 1.15)
"""An early beat: length of the interval before it, of the usual one, where the next is longer by as much; number of
beats from one to the next; height of its wave and of the wave behind the pause."""
IRREGULAR = 0.2
"""Variation of the intervals of an irregular heart, rms; as in atrial fibrillation, without order."""
_SHORTEST_INTERVAL = 0.5


def pulse_wave(
    place: Place,
    rate: float = 75.0,
    seconds: float = 4.0,
    *,
    shape: PulseShape = "three waves",
    rhythm: Rhythm = "even",
    **stream: Unpack[Stream],
) -> Contact:
    """A finger that rests on the array, through whose skin the pulse comes: percussion, tidal and dicrotic wave.

    The percussion wave adds 20 to 200 uN to the force of the finger, which sways slowly by 2 to 50 uN, rms. The force
    with which it rests changes nothing and is left out; what is left is faded in and out within 0.2 s. Beats of an even
    heart differ in length by 2 %, rms, and their waves keep to times that go with the root of their length.

    Args:
        place: where, mm.
        rate: beats a minute, 30 to 220.
        seconds: length, 0.5 to 1000 s.
        shape: waves of each beat, of :data:`WAVES`.
        rhythm: "even", "early beats" (extrasystoles with their pauses) or "irregular".
        stream: ``seed``, ``purpose`` and ``sample`` of its random numbers, as of :class:`localize.contacts.Stream`.

    Raises:
        Refusal: a rate or a length out of range, or an unknown shape or rhythm.
    """
    heart = _heart(rate, seconds, shape, rhythm, **stream)
    time, pulse = times(seconds), np.zeros(len(times(seconds)))
    for foot, stretch, height in heart.beats:
        for later, weight, width in heart.waves.values():
            pulse += height * weight * np.exp(-0.5 * ((time - foot - later * stretch) / (width * stretch)) ** 2)
    sway = heart.draws.noise(time, (0.1, 0.5))
    fade = np.sin(np.pi / 2 * np.clip(np.minimum(time, time[-1] - time) / PULSE_FADE, 0, 1)) ** 2
    force = fade * (heart.height * pulse + heart.swaying * (sway - sway.min()))
    return Contact(time, still(place, len(time)), force, heart.radius, 0.0, "pulse wave")


def pulse_times(
    rate: float = 75.0,
    seconds: float = 4.0,
    *,
    shape: PulseShape = "three waves",
    rhythm: Rhythm = "even",
    **stream: Unpack[Stream],
) -> dict[str, Array]:
    """Times of the waves of :func:`pulse_wave` with the same arguments; errors as there.

    Args:
        rate: beats a minute.
        seconds: length, s.
        shape: waves of each beat.
        rhythm: of the heart.
        stream: of its random numbers.

    Returns:
        (n_beat,) float64, s, by the name of the wave, NaN for a wave that the shape lacks; the first beats lie before
        the contact.
    """
    heart = _heart(rate, seconds, shape, rhythm, **stream)
    later = {name: heart.waves[name][0] if name in heart.waves else np.nan for name in WAVES["three waves"]}
    return {name: np.array([foot + own * stretch for foot, stretch, _ in heart.beats]) for name, own in later.items()}


@dataclass(frozen=True)
class _Heart:
    """Random numbers of one pulse."""

    draws: Draws
    swaying: float
    height: float
    radius: float
    waves: dict[str, tuple[float, float, float]]
    """Time after the foot and width at 75 beats a minute, s, and height of each wave."""
    beats: tuple[tuple[float, float, float], ...]
    """Time of the foot of each beat, s, by how much its waves are stretched, and their height."""


def _heart(rate: float, seconds: float, shape: PulseShape, rhythm: Rhythm, **stream: Unpack[Stream]) -> _Heart:
    check_range("rate", rate, *HEART_RATES, "beats a minute")
    check_range("seconds", seconds, 0.5, 1000.0, "s")
    check_choice("shape", shape, tuple(WAVES))
    check_choice("rhythm", rhythm, get_args(Rhythm))
    draws = Draws("pulse", **stream)
    swaying, height = draws.log_between((2e-6, 50e-6)), draws.log_between((20e-6, 200e-6))
    radius = draws.between(FINGER.contact_radius_mm)
    waves = {}
    for name, limits in WAVES[shape].items():
        later, weight, width = (draws.between(each) for each in limits)
        waves[name] = (later, weight, width)
    beat = 60 / rate
    at = -beat * (1 + draws.between((0.0, 1.0)))
    number = np.arange(math.ceil(seconds / beat / _SHORTEST_INTERVAL) + 4, dtype=np.float64)
    moved = draws.noise(number * beat, (0.08, 0.3), 6)
    lengths, heights = beat * (1 + 0.02 * moved), np.ones(len(number))
    if rhythm == "irregular":
        lengths *= np.clip(1 + IRREGULAR * draws.noise(number, (0.1, 0.5), 12), _SHORTEST_INTERVAL, None)
    elif rhythm == "early beats":
        every = round(draws.between(EARLY_EVERY))
        lengths[every - 2 :: every] *= EARLY
        heights[every - 1 :: every] *= EARLY_HEIGHT[0]
        lengths[every - 1 :: every] *= 2 - EARLY
        heights[every::every] *= EARLY_HEIGHT[1]
    beats = []
    for length, high in zip(lengths.tolist(), heights.tolist(), strict=True):
        if at > seconds + beat:
            break
        beats.append((at, math.sqrt(length / 0.8), high))
        at += length
    return _Heart(draws, swaying, height, radius, waves, tuple(beats))
