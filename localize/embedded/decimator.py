"""The low-pass of the firmware that brings samples of 16 kHz to 1 kHz, and its response."""

from __future__ import annotations

import numpy as np
import scipy.signal

from geometry.ground.typed import Array
from localize.signals.stimulus import SAMPLE_RATE

FACTOR = 16
"""Samples of the converter for one of 1 kHz."""
FIR_TAPS = 256
"""Number of taps."""
FIR_DELAY = (FIR_TAPS - 1) / 2 / (FACTOR * SAMPLE_RATE)
"""Delay, s."""
_CUTOFF, _BETA = 455.0, 8.0


def decimator_taps() -> Array:
    """Taps of the low-pass, (FIR_TAPS,) float64: symmetric, and of sum 1."""
    return np.asarray(scipy.signal.firwin(FIR_TAPS, _CUTOFF, window=("kaiser", _BETA), fs=FACTOR * SAMPLE_RATE))


def decimator_response(frequency: Array) -> Array:
    """Gain at frequencies in Hz, (n,), before the decimation; (n,) float64, dB."""
    _, response = scipy.signal.freqz(decimator_taps(), worN=np.asarray(frequency, float), fs=FACTOR * SAMPLE_RATE)
    return np.asarray(20 * np.log10(np.abs(response)))
