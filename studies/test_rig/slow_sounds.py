"""Pressures of the air around a sensor below 20 Hz: doors that are closed, and gusts of wind.

All figures are assumed.
"""

from __future__ import annotations

import numpy as np

from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array

#: Range of largest and rms pressures, Pa.
PRESSURES = (0.0, 1000.0)
#: Largest pressure in a room whose door is closed, and level of gusts at a sheltered place, Pa.
DOOR, GUST = 10.0, 1.0
#: Shortest and longest time in which a door that closes compresses the room, and in which the room leaks, s.
_CLOSING, _LEAKING = (0.08, 0.3), (0.1, 0.4)
#: Band of gusts, in which their power falls as 1/f, Hz.
_GUSTS = (0.1, 20.0)


def closing_doors(seconds: float, random: np.random.Generator, largest: float = DOOR, rate: float = 1000.0) -> Array:
    """Pressure in a room whose door is closed about every three seconds.

    The door compresses the room along sin^2, and the room leaks exponentially.

    Args:
        seconds: length, s.
        random: draws times, strengths and lengths.
        largest: pressure of the strongest closing, 0 to 1000 Pa.
        rate: sample rate, Hz.

    Returns:
        (n_sample,) float64, Pa above the rest.

    Raises:
        Refusal: a pressure out of range.
    """
    check_range("largest", largest, *PRESSURES, "Pa")
    time = np.arange(round(seconds * rate)) / rate
    pressure = np.zeros(len(time))
    at = random.uniform(0.5, 1.0)
    while at < seconds:
        closing, leaking = random.uniform(*_CLOSING), random.uniform(*_LEAKING)
        peak = largest * random.uniform(0.3, 1.0) * random.choice([-1.0, 1.0])
        since = time - at
        rise = np.sin(np.pi / 2 * np.clip(since / closing, 0.0, 1.0)) ** 2
        pressure += peak * rise * np.exp(-np.maximum(since - closing, 0.0) / leaking)
        at += random.uniform(2.0, 4.0)
    return pressure


def gusts(seconds: float, random: np.random.Generator, rms: float = GUST, rate: float = 1000.0) -> Array:
    """Pressure of wind around a sensor, pink from 0.1 to 20 Hz.

    Args:
        seconds: length, s, long enough for several periods of 0.1 Hz.
        random: draws the gusts.
        rms: level, 0 to 1000 Pa.
        rate: sample rate, Hz.

    Returns:
        (n_sample,) float64, Pa about the mean.

    Raises:
        Refusal: a level or a length out of range.
    """
    check_range("rms", rms, *PRESSURES, "Pa")
    check_range("seconds", seconds, 1 / _GUSTS[0], unit="s")
    count = round(seconds * rate)
    grid = np.fft.rfftfreq(count, 1 / rate)
    inside = (grid >= _GUSTS[0]) & (grid <= _GUSTS[1])
    spectrum = np.fft.rfft(random.standard_normal(count))
    spectrum[~inside] = 0
    spectrum[inside] /= np.sqrt(grid[inside])
    pressure = np.fft.irfft(spectrum, count)
    return np.asarray(rms * pressure / pressure.std())
