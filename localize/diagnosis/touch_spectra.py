"""Spectra of the touches of a recording: each touch a few windows of one second, above the noise of the recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.ndimage
import scipy.signal
from numpy.typing import NDArray

from geometry.ground.typed import Array, ComplexArray
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.signals.stimulus import SAMPLE_RATE

WINDOW = round(SAMPLE_RATE)
"""Length of a window, samples: 1 s."""
_HOP = 16
#: Seconds of a window before a touch begins and behind its end, and of quiet between two touches at least.
_BEFORE, _BEHIND, _GAP = 0.06, 0.1, 0.25
#: Largest number of windows of a touch that goes on for longer than one.
_MOST = 6
#: Level over the quiet, and over the loudest touches, from which on there is a touch.
_ABOVE, _LOUD = 12.0, 0.008


@dataclass(frozen=True, eq=False)
class TouchSpectra:
    """Spectra of touches, at whole frequencies."""

    start: Array
    """Time at which each touch begins, (n_touch,) float64, s."""
    end: Array
    """Time at which each touch ends, (n_touch,) float64, s."""
    touch: NDArray[np.int64]
    """Index of the touch of each window, (n_window,) int64."""
    spectrum: ComplexArray
    """Spectra over the standard deviation of the noise, (n_window, n_microphone, n_freq) complex128."""
    noise: Array
    """Standard deviation of the spectrum of the noise in a window, (n_microphone, n_freq) float64, Pa."""


def touch_spectra(signals: Array, frequency: NDArray[np.int64], noise_rms: float) -> TouchSpectra:
    """Touches of a recording, found by their level above the quiet between them.

    Args:
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.
        frequency: whole Hz, (n_freq,).
        noise_rms: noise that a microphone has at least, Pa rms over 0 to 500 Hz.

    Returns:
        Touches in the order of time; none where nothing is louder than the noise.
    """
    heard = HighPass(len(signals), HIGH_PASS).begin(signals)
    count = heard.shape[1] // _HOP
    power = (heard[:, : count * _HOP].reshape(len(heard), count, _HOP) ** 2).mean(2)
    power = scipy.ndimage.uniform_filter1d(power, 3, axis=1)
    quiet = np.maximum(np.quantile(power, 0.1, axis=1), (0.3 * noise_rms) ** 2)
    level = np.sqrt((power / quiet[:, None]).max(0))
    least = max(_ABOVE, _LOUD * float(np.quantile(level, 0.98)))
    starts, ends = _runs(level > least)
    return _windows(heard, starts * _HOP, ends * _HOP, frequency, noise_rms, level < least / 2)


def _runs(loud: NDArray[np.bool_]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First and last hop of each stretch of loud hops; short gaps are closed."""
    edge = np.diff(np.concatenate([[0], loud.astype(int), [0]]))
    starts, ends = np.flatnonzero(edge == 1), np.flatnonzero(edge == -1)
    if not len(starts):
        return starts, ends
    apart = (starts[1:] - ends[:-1]) * _HOP / SAMPLE_RATE > _GAP
    return starts[np.concatenate([[True], apart])], ends[np.concatenate([apart, [True]])]


def _windows(
    heard: Array, starts: NDArray[np.int64], ends: NDArray[np.int64], frequency: NDArray[np.int64], noise_rms: float,
    quiet: NDArray[np.bool_],
) -> TouchSpectra:  # fmt: skip
    before, behind = round(_BEFORE * SAMPLE_RATE), round(_BEHIND * SAMPLE_RATE)
    spectra, touch, energy = [], [], []
    for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
        limit = starts[number + 1] - before if number + 1 < len(starts) else heard.shape[1]
        first, last = max(0, start - before), min(limit, max(end + behind, start - before + WINDOW))
        places = [first]
        if last - first > 1.3 * WINDOW:
            places = list(range(first, last - WINDOW + 1, WINDOW // 2))[:_MOST]
        for place in places:
            part = heard[:, place : min(place + WINDOW, last)]
            taper = scipy.signal.windows.tukey(part.shape[1], 1.0 if len(places) > 1 else 2 * 0.05)
            windowed = np.zeros((len(heard), WINDOW))
            windowed[:, : part.shape[1]] = part * taper
            spectra.append(np.fft.rfft(windowed)[:, frequency])
            touch.append(number)
            energy.append((taper**2).sum())
    # The noise of quiet stretches, at least the microphones' own.
    own = noise_rms**2 / (SAMPLE_RATE / 2) * SAMPLE_RATE * WINDOW / 2
    noise = np.full((len(heard), len(frequency)), np.sqrt(own))
    calm = np.repeat(quiet, _HOP)[: heard.shape[1]]
    blocks = [heard[:, k : k + WINDOW // 4] for k in range(0, len(calm) - WINDOW // 4, WINDOW // 4)
              if calm[k : k + WINDOW // 4].all()]  # fmt: skip
    if len(blocks) >= 4:
        taper = np.hanning(WINDOW // 4)
        each = np.abs(np.fft.rfft(np.array(blocks) * taper)) ** 2 / (taper**2).sum() * WINDOW
        measured = np.median(each, 0) / np.log(2)
        at = np.arange(measured.shape[1]) * 4.0
        found = np.array([np.interp(frequency, at[1:], row[1:]) for row in measured])
        noise = np.sqrt(np.maximum(noise**2, found))
    spectrum = np.array(spectra).reshape(-1, len(heard), len(frequency)) / noise
    return TouchSpectra(starts / SAMPLE_RATE, ends / SAMPLE_RATE, np.array(touch, np.int64), spectrum, noise)
