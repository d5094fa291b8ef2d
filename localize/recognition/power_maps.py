"""Maps of a waveform: wavelet power over time and frequency, 64 x 32, and with it the sign of what is slow.

The paper recognises kinds of touch from the wavelet power of reconstructed waveforms. The first map is that power in
dB below its maximum, so that loudness says nothing. A press and a release have the same power: the second map, ours, is
the real part of the wavelet's value over the largest magnitude of its window.
"""

from __future__ import annotations

import functools
import math

import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from localize.learned.features import COLUMNS
from localize.learned.wavelets import wavelet_frequencies
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.threads import one_thread

WINDOW = 1024
"""Number of samples of a window, at 1 kHz."""
WIDTH = 1.0
"""Standard deviation of the wavelet's Gaussian envelope, in periods of its centre frequency."""
RANGE = 40.0
"""Range of the power, dB: what is weaker is the recorder's."""
MAPS = 2
"""Number of maps: power, and signed value."""
_GRID = 2 * WINDOW
"""Length of the circular grid, samples: what lies behind a window is silence."""
_KEPT = _GRID // 4
"""Lines of the grid that are kept, up to 250 Hz: wavelets are analytic, and hear nothing above 200 Hz."""


@one_thread()
def maps_of(waveforms: ArrayLike) -> Tensor:
    """Maps of windows of a waveform; a common gain changes nothing.

    Args:
        waveforms: (n, 1024) float, Pa or any other unit, at 1 kHz.

    Returns:
        (n, 2, 64, 32) float32: power in dB below the maximum of the window, at least -40; and the real part of the
        wavelet's value, a share of the largest magnitude of the window.
    """
    given = torch.as_tensor(np.asarray(waveforms, np.float32))
    if not len(given):  # of which FFTs make an error
        return torch.zeros(0, MAPS, len(_wavelets()), COLUMNS)
    centred = given - given.mean(1, keepdim=True)
    spectrum = torch.fft.rfft(centred, _GRID)[:, None, :_KEPT] * _wavelets()
    # A quarter of the lines gives every fourth sample, of which the window has the first half.
    value = torch.fft.ifft(spectrum, dim=2)[..., : _KEPT // 2].unflatten(2, (COLUMNS, -1))
    power = value.real.square() + value.imag.square()
    mean = power.mean(3)
    most = mean.amax((1, 2), keepdim=True).clamp_min(1e-30)
    level = 10 * (mean / most).clamp_min(10 ** (-RANGE / 10)).log10()
    return torch.stack([level, value.real.mean(3) / most.sqrt()], 1)


def windows(waveform: NDArray[np.float64], hop: int = WINDOW // 4) -> NDArray[np.float64]:
    """Windows of a waveform, the last one ending with it; a shorter one is continued by its last value.

    Args:
        waveform: (n_sample,) float64, of any length.
        hop: samples between the beginnings of two windows.

    Returns:
        (n, 1024) float64.
    """
    if len(waveform) < WINDOW:
        waveform = np.pad(waveform, (0, WINDOW - len(waveform)), mode="edge")
    first = np.arange((len(waveform) - WINDOW) % hop, len(waveform) - WINDOW + 1, hop)
    return waveform[first[:, None] + np.arange(WINDOW)]


@functools.lru_cache(maxsize=1)
def _wavelets() -> Tensor:
    """(64, n_line) spectra of the analytic wavelets (Torrence and Compo 1998, table 1)."""
    frequency = torch.arange(_KEPT) * (SAMPLE_RATE / _GRID)
    centre = torch.from_numpy(wavelet_frequencies().astype(np.float32))[:, None]
    return torch.exp(-0.5 * (2 * math.pi * WIDTH * (frequency / centre - 1)) ** 2) * (frequency > 0)
