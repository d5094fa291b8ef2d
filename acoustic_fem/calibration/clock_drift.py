"""Clocks of two recorders: how much faster one samples than the other, and its signals at the other's times.

A recorder of 20 ppm gains a sample at 1 kHz in 50 s. The transfer function between channels of two recorders then turns
its phase in the course of the recording. The turn that makes all parts of the recording agree gives the difference.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import make_interp_spline

from acoustic_fem.sound.estimate import amplitudes
from geometry.ground.typed import Array

LEAST, LARGEST = 6.0, 500.0
"""Differences of clocks that are corrected, ppm. On virtual rigs without a difference 1 ppm or less is found with
noise, and up to 3.5 ppm with swept sines; crystals differ by up to 100 or 200 ppm."""
COHERENT = 0.5
"""Power of the sum of all segments over the largest that it can have, below which they say nothing of clocks."""
#: Steps in which the difference is looked for, and how far to either side, ppm.
_STEPS = ((5.0, LARGEST), (1.0, 6.0), (0.25, 1.0))
#: Length of a segment, short, so that a drift within one is none; and of the step from one to the next, s.
_SEGMENT, _HOP = 1.0, 0.25
#: Degree of the spline that gives signals between their samples.
_DEGREE = 5


def clock_difference(signals: Array, rate: float, frequency: Array) -> float:
    """Rate of the microphones' recorder above that of the reference, ppm; 0 where it is too small to matter.

    Args:
        signals: (1 + n_microphone, n_sample) float64, Pa, the reference first, the others of one recorder.
        rate: stated, Hz.
        frequency: (n_freq,) Hz, at which the parts of the recording are compared.
    """
    found = amplitudes(signals, rate, frequency, _SEGMENT)
    cross = found[0].conj() * found[1:]  # (microphone, segment, frequency)
    weight = np.abs(cross).mean((1, 2), keepdims=True)
    cross = cross / np.maximum(weight, np.finfo(np.float64).tiny)
    times = _HOP * (np.arange(cross.shape[1]) - (cross.shape[1] - 1) / 2)

    def agreement(drifts: Array) -> Array:
        """Power of the sum of all segments, after the turn by a drift, 1e-6, was undone; (n,) of (n,) drifts."""
        total = np.zeros(len(drifts))
        for k, each in enumerate(frequency):
            turn = np.exp(2j * np.pi * each * np.outer(1e-6 * drifts, times))
            total += (np.abs(turn @ cross[:, :, k].T) ** 2).sum(1)
        return total

    drift = 0.0
    for step, reach in _STEPS:
        tried = drift + np.arange(-reach, reach + step / 2, step)
        drift = float(tried[agreement(tried).argmax()])
    if not LEAST <= abs(drift) <= LARGEST:
        return 0.0
    largest = (np.abs(cross).sum(1) ** 2).sum()
    return drift if agreement(np.array([drift]))[0] >= COHERENT * largest else 0.0


def at_nominal_times(values: Array, ppm: float) -> Array:
    """Signal of a recorder whose clock is too fast, at the times of one whose clock is right.

    Args:
        values: (n_sample,) float64, of any unit.
        ppm: rate of the recorder above the stated one, 1e-6.

    Returns:
        (n,) float64 in the unit of the values, n at most n_sample.
    """
    if ppm == 0:
        return values
    factor = 1 + 1e-6 * ppm
    places = factor * np.arange(int((len(values) - 1) / factor) + 1)
    return np.asarray(make_interp_spline(np.arange(len(values)), values, _DEGREE)(places[: len(values)]))
