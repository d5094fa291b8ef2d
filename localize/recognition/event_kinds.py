"""Twelve kinds of events, as the pressure that each makes in the cavity of one point.

The paper classifies twelve events and does not say which. These are ours, and so are the ranges of their parameters,
which are drawn anew for each take. Taps, presses and the pulse are those of :mod:`localize.contacts`, because results
on events must hold for its fingers too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from geometry.ground.typed import Array
from localize.contacts.contact_shapes import FINGER
from localize.contacts.finger_gestures import DOUBLE_TAP_SECONDS, HOLD_SECONDS, PRESS_SECONDS, TAP_SECONDS
from localize.contacts.pulses import pulse_wave
from localize.recognition.power_maps import WINDOW
from localize.signals.stimulus import SAMPLE_RATE

Draw = np.random.Generator


def _log(random: Draw, low: float, high: float) -> float:
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def _time(count: int) -> Array:
    """From the beginning of the window on, which is the end of what is made; s."""
    return (np.arange(count) - (count - WINDOW)) / SAMPLE_RATE


def _bump(time: Array, begin: float, length: float) -> Array:
    """sin^2 from ``begin`` on, s."""
    phase = (time - begin) / length
    return np.where((phase > 0) & (phase < 1), np.sin(np.pi * phase) ** 2, 0.0)


def _step(time: Array, begin: float, length: float) -> Array:
    """From 0 to 1 within ``length``, s."""
    return np.asarray(np.sin(0.5 * np.pi * np.clip((time - begin) / length, 0, 1)) ** 2)


def _by_hand(count: int, random: Draw) -> Array:
    """The force of a hand that means to keep it."""
    return 1 + random.uniform(0, FINGER.unsteadiness) * band_noise(count, 0.5, 8.0, random)


def band_noise(count: int, low: float, high: float, random: Draw) -> Array:
    """Gaussian noise of a band.

    Args:
        count: samples at 1 kHz.
        low: lowest frequency, Hz.
        high: highest frequency, Hz.
        random: draws it.

    Returns:
        (count,) float64 of rms one.
    """
    spectrum = np.fft.rfft(random.standard_normal(count))
    frequency = np.fft.rfftfreq(count, 1 / SAMPLE_RATE)
    spectrum[(frequency < low) | (frequency > high)] = 0
    noise = np.fft.irfft(spectrum, count)
    return np.asarray(noise / max(float(noise.std()), 1e-12))


def _tap(count: int, random: Draw) -> Array:
    return _bump(_time(count), random.uniform(0.05, 0.5), _log(random, *TAP_SECONDS))


def _double_tap(count: int, random: Draw) -> Array:
    time, begin, length = _time(count), random.uniform(0.05, 0.4), _log(random, *TAP_SECONDS)
    second = begin + random.uniform(*DOUBLE_TAP_SECONDS)
    return _bump(time, begin, length) + random.uniform(0.6, 1.4) * _bump(
        time, second, length * random.uniform(0.8, 1.25)
    )


def _press(count: int, random: Draw) -> Array:
    """A finger that comes down and stays; where it leaves again within the window, that is part of the press."""
    time, begin, rise = _time(count), random.uniform(0.05, 0.5), _log(random, *PRESS_SECONDS)
    leaves = begin + rise + random.uniform(*HOLD_SECONDS)
    held = _step(time, begin, rise) - _step(time, leaves, _log(random, *PRESS_SECONDS))
    return held * _by_hand(count, random)


def _release(count: int, random: Draw) -> Array:
    held = 1.0 - _step(_time(count), random.uniform(0.05, 0.5), _log(random, *PRESS_SECONDS))
    return held * _by_hand(count, random)


def _rub(count: int, random: Draw) -> Array:
    """Friction whose level follows the speed of a finger that goes to and fro."""
    time = _time(count)
    strokes = random.uniform(1.5, 3.5)
    speed = np.abs(np.sin(np.pi * strokes * time + random.uniform(0, np.pi)))
    slow = 0.4 * np.sin(np.pi * strokes * time + random.uniform(0, 2 * np.pi))
    return band_noise(count, random.uniform(4, 10), random.uniform(35, 60), random) * speed + slow


def _scratch(count: int, random: Draw) -> Array:
    """Short bursts of a nail: high, with silence between."""
    time, rate = _time(count), random.uniform(4.0, 7.0)
    phase = (time * rate + random.uniform()) % 1.0
    burst = np.where(phase < random.uniform(0.4, 0.6), 1.0, 0.05)
    soft = np.convolve(burst, np.hanning(15)[1:-1] / np.hanning(15).sum(), "same")
    return band_noise(count, random.uniform(40, 55), random.uniform(95, 140), random) * soft


def _tremor(count: int, random: Draw) -> Array:
    time, frequency = _time(count), random.uniform(4.5, 11.0)
    wander = 0.4 * np.cumsum(band_noise(count, 0.3, 2.0, random)) / SAMPLE_RATE * 2 * np.pi
    phase = 2 * np.pi * frequency * time + wander + random.uniform(0, 2 * np.pi)
    swell = 1 + 0.25 * band_noise(count, 0.3, 2.0, random)
    return swell * (np.sin(phase) + random.uniform(0, 0.2) * np.sin(2 * phase + random.uniform(0, 2 * np.pi)))


def _pulse(count: int, random: Draw) -> Array:
    rate, seconds = random.uniform(50.0, 100.0), count / SAMPLE_RATE + 1
    return pulse_wave((0.0, 0.0), rate, seconds, seed=int(random.integers(2**62))).force[500 : 500 + count]


def _knock(count: int, random: Draw) -> Array:
    """A hard, short blow and the ring of what was hit."""
    time, begin = _time(count), random.uniform(0.05, 0.6)
    since = np.maximum(time - begin, 0)
    ring = np.exp(-since / random.uniform(0.03, 0.06)) * np.sin(2 * np.pi * random.uniform(45, 95) * since)
    return _bump(time, begin, _log(random, 0.004, 0.01)) + random.uniform(0.5, 0.9) * ring


def _drop(count: int, random: Draw) -> Array:
    """A grain that falls and bounces, each time lower and sooner."""
    time, made = _time(count), np.zeros(count)
    at, gap, height, bounce = random.uniform(0.05, 0.2), random.uniform(0.14, 0.26), 1.0, random.uniform(0.6, 0.78)
    length = _log(random, 0.006, 0.015)
    while gap > 0.02 and at < time[-1]:
        made += height * _bump(time, at, length)
        at, gap, height = at + gap, gap * bounce, height * bounce
    return made


def _motor_hum(count: int, random: Draw) -> Array:
    time, frequency = _time(count), random.uniform(22.0, 48.0)
    phase = (
        2 * np.pi * frequency * time + 0.3 * np.cumsum(band_noise(count, 0.5, 3.0, random)) / SAMPLE_RATE * 2 * np.pi
    )
    made = np.sin(phase)
    for harmonic in (2, 3):
        made += random.uniform(0.2, 0.6) * np.sin(harmonic * phase + random.uniform(0, 2 * np.pi))
    return made


def _footstep(count: int, random: Draw) -> Array:
    """Heel, roll, toe: two broad bumps with the heel's strike on top."""
    time, begin, length = _time(count), random.uniform(0.05, 0.2), random.uniform(0.55, 0.7)
    heel, toe = 0.55 * length, 0.5 * length
    made = _bump(time, begin, heel) + random.uniform(0.8, 1.1) * _bump(time, begin + length - toe, toe)
    return made + random.uniform(0.5, 0.9) * _bump(time, begin + 0.01, random.uniform(0.02, 0.035))


EVENTS: Mapping[str, Callable[[int, Draw], Array]] = {
    "tap": _tap,
    "double tap": _double_tap,
    "press": _press,
    "release": _release,
    "rub": _rub,
    "scratch": _scratch,
    "tremor": _tremor,
    "pulse": _pulse,
    "knock": _knock,
    "drop": _drop,
    "motor hum": _motor_hum,
    "footstep": _footstep,
}
"""Pressure of each kind of event, of any scale: number of samples at 1 kHz and random numbers to it."""
PEAK = (0.1, 5.0)
"""Lowest and highest peak of an event in the cavity, Pa; drawn evenly on a logarithmic scale."""


def event_pressure(name: str, count: int, random: Draw) -> Array:
    """Pressure in the cavity under one event.

    Args:
        name: one of :data:`EVENTS`.
        count: samples at 1 kHz, at least a window; the event begins in the first 0.6 s of the last window.
        random: draws the event.

    Returns:
        (count,) float64, Pa.
    """
    made = EVENTS[name](count, random)
    peak = _log(random, *PEAK)
    return np.asarray(peak * made / np.abs(made).max() + 0.01 * peak * band_noise(count, 0.5, 8.0, random))
