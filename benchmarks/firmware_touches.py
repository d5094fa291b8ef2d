"""Recordings that the whole firmware is compared on, as its converter has them, and the events that Python finds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.signal
from numpy.typing import NDArray

import localize
from geometry.ground.typed import Array
from localize.embedded.decimator import FACTOR, FIR_DELAY, FIR_TAPS, decimator_taps
from localize.live.events import TouchEvent
from localize.live.serial_port import NEARLY
from localize.live.stream_options import HIGH_PASS
from localize.live.touches import TouchTracker
from localize.signals.array_response import ArrayResponse
from localize.signals.stimulus import SAMPLE_RATE

SECONDS = 8
"""Length of a recording, s; the second after its touches is quiet."""
LARGEST_NUMBER = 32767
"""Largest number of the converter."""


def recordings(response: ArrayResponse, seed: int, full_scale: float, seconds: int = SECONDS) -> dict[str, Array]:
    """Simulated recordings of an array at 1 kHz, each with the noise of its microphones.

    Args:
        response: of the array; sound is simulated if it has a design.
        seed: of everything that is drawn.
        full_scale: pressure at which microphones are clipped, Pa.
        seconds: length.

    Returns:
        (n_microphone, n) float64, Pa, by name: taps, some of them clipped; presses that are held; fingers that slide
        from point to point; a pulse; and quiet taps in bursts of room sound.
    """
    random = np.random.default_rng([seed, response.point_count])
    made = {
        "taps": _taps(response, random, seconds, (1.0, 3 * full_scale)),
        "presses": _presses(response, random, seconds),
        "slides": _slides(response, random, seconds),
        "pulse": _pulse(response, random, seconds),
        "quiet taps in sound": _taps(response, random, seconds, (0.02, 1.0)),
    }
    noise = localize.BayesDecoder(response, "design").noise_rms
    found = {}
    for name, pressure in made.items():
        signals = _at_microphones(response, pressure)
        if name == "quiet taps in sound" and response.ambient_response is not None:
            signals += _sound(response, random, seconds)
        signals += noise * random.standard_normal(signals.shape)
        found[name] = np.clip(signals, -full_scale, full_scale)
    return found


def of_converter(signals: Array, full_scale: float) -> NDArray[np.int16]:
    """Samples of the converter, (n, n_microphone) int16 at 16 kHz, of (n_microphone, n) Pa at 1 kHz."""
    fine = scipy.signal.resample_poly(signals, FACTOR, 1, axis=1)
    numbers = np.clip(np.round(fine / full_scale * LARGEST_NUMBER), -LARGEST_NUMBER, LARGEST_NUMBER)
    return np.ascontiguousarray(numbers.T.astype("<i2"))


def decimated(samples: NDArray[np.int16], full_scale: float) -> Array:
    """Pressures of the firmware, (n_microphone, n) Pa: number n of 1 kHz from the converter's samples up to 16 n + 15;
    NaN before there are enough.
    """
    taps, first = decimator_taps(), FIR_TAPS // FACTOR - 1
    rows = [np.convolve(row.astype(float), taps, "valid")[::FACTOR] for row in samples.T]
    return np.concatenate([np.full((len(rows), first), np.nan), rows], axis=1) * full_scale / LARGEST_NUMBER


@dataclass(frozen=True, eq=False)
class Reference:
    """Events of a recording in Python."""

    events: list[TouchEvent]
    """Touches, with the latency of the firmware."""
    states: dict[str, int]
    """Number of decisions of each state."""


def events_in_python(response: ArrayResponse, pressures: Array, limit: float) -> Reference:
    """Events of the stream and the tracker in Python, with the options that the C code has.

    Args:
        response: of the array.
        pressures: (n_microphone, n) Pa at 1 kHz; NaN where samples are lost.
        limit: full scale, Pa.
    """
    decoder = localize.BayesDecoder(response, "design")
    stream = localize.TouchStream(
        decoder,
        limit=NEARLY * limit,
        options=localize.StreamOptions(HIGH_PASS, follow=False, fade=True),
        sound_test=None if response.ambient_response is None else localize.SoundTest(response, "design"),
    )
    tracker = TouchTracker(decoder, stream.delay + FIR_DELAY)
    good = np.isfinite(pressures).all(0)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], good, [False]]).astype(int)))
    found, states = list[TouchEvent](), dict[str, int]()
    for begin, end in edges.reshape(-1, 2).tolist():
        for event in stream.push(pressures[:, begin:end], begin):
            found += tracker.take(event)
            if isinstance(event, localize.live.Decision):
                states[event.state] = states.get(event.state, 0) + 1
    return Reference(found, states)


def _at_microphones(response: ArrayResponse, pressure: Array) -> Array:
    """(n_microphone, n) Pa of (n_point, n) Pa in the cavities."""
    count = pressure.shape[1]
    frequency = np.fft.rfftfreq(count, 1 / SAMPLE_RATE)
    inside = frequency <= response.frequency[-1]
    transfer = np.zeros((response.point_count, len(response.microphones), len(frequency)), complex)
    transfer[..., inside] = response.between(frequency[inside])[0]
    return np.asarray(np.fft.irfft(np.einsum("pmf,pf->mf", transfer, np.fft.rfft(pressure)), count))


def _sound(response: ArrayResponse, random: np.random.Generator, seconds: int) -> Array:
    """(n_microphone, n) Pa of two bursts of noise in the room, 80 to 300 Hz, half a second each."""
    assert response.ambient_response is not None
    count = _count(seconds)
    sections = scipy.signal.butter(4, [80, 300], "bandpass", fs=SAMPLE_RATE, output="sos")
    noise = scipy.signal.sosfilt(sections, random.standard_normal(count))
    noise *= 0.3 * (np.arange(count) * 2 // SAMPLE_RATE % (seconds - 1) == 3)
    frequency = np.fft.rfftfreq(count, 1 / SAMPLE_RATE)
    gain = np.stack(
        [
            np.interp(frequency, response.frequency, each.real)
            + 1j * np.interp(frequency, response.frequency, each.imag)
            for each in response.ambient_response
        ]
    )
    return np.asarray(np.fft.irfft(gain * np.fft.rfft(noise), count))


def _count(seconds: int) -> int:
    return round(seconds * SAMPLE_RATE)


def _pressed(seconds: int, begin: float, rise: float, hold: float, fall: float) -> Array:
    """Course of height 1 that rises, is held and falls; (n,), from four times in s."""
    since = np.arange(_count(seconds)) / SAMPLE_RATE - begin
    left = rise + hold + fall - since
    return np.asarray(np.sin(np.pi / 2 * np.clip(np.minimum(since / rise, left / fall), 0, 1)) ** 2)


def _taps(response: ArrayResponse, random: np.random.Generator, seconds: int, height: tuple[float, float]) -> Array:
    pressure = np.zeros((response.point_count, _count(seconds)))
    begin = 0.4
    while begin < seconds - 1.2:
        half = random.uniform(0.015, 0.05)
        peak = np.exp(random.uniform(*np.log(height)))
        pressure[random.integers(response.point_count)] += peak * _pressed(seconds, begin, half, 0, half)
        begin += random.uniform(0.25, 0.8)
    return pressure


def _presses(response: ArrayResponse, random: np.random.Generator, seconds: int) -> Array:
    pressure = np.zeros((response.point_count, _count(seconds)))
    begin = 0.4
    while begin < seconds - 2.2:
        rise, hold, fall = random.uniform(0.05, 0.15), random.uniform(0.3, 1.5), random.uniform(0.05, 0.15)
        course = random.uniform(1, 8) * _pressed(seconds, begin, rise, hold, fall)
        tremor = 1 + 0.05 * np.sin(2 * np.pi * random.uniform(6, 12) * np.arange(len(course)) / SAMPLE_RATE)
        pressure[random.integers(response.point_count)] += course * tremor
        begin += rise + hold + fall + random.uniform(0.1, 0.5)
    return pressure


def _slides(response: ArrayResponse, random: np.random.Generator, seconds: int) -> Array:
    count = _count(seconds)
    pressure = np.zeros((response.point_count, count))
    sections = scipy.signal.butter(2, [10, 80], "bandpass", fs=SAMPLE_RATE, output="sos")
    rough = scipy.signal.sosfilt(sections, random.standard_normal((response.point_count, count)), axis=1)
    begin = 0.4
    while begin < seconds - 3.2:
        at, steps = int(random.integers(response.point_count)), int(random.integers(2, 4))
        for k in range(steps):
            if at + k < response.point_count:
                pressure[at + k] += 4 * rough[at + k] * _pressed(seconds, begin + 0.5 * k, 0.15, 0.35, 0.15)
        begin += 0.5 * steps + random.uniform(0.5, 0.8)
    return pressure


def _pulse(response: ArrayResponse, random: np.random.Generator, seconds: int) -> Array:
    pressure = np.zeros((response.point_count, _count(seconds)))
    point, period, begin = int(random.integers(response.point_count)), random.uniform(0.6, 0.8), 0.5
    while begin < seconds - 2:
        pressure[point] += 2 * _pressed(seconds, begin, 0.13, 0, 0.3)
        begin += period
    return pressure
