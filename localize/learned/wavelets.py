"""Morlet wavelets of a localizer's maps: frequencies, width and grid, for whoever predicts them without torch."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from localize.signals.stimulus import BAND

CONTINUATION = 250
"""Number of times that the last sample is repeated behind the frame."""
FREQUENCIES = 64
"""Number of frequencies, the rows of a map."""
TAIL = 47
"""Number of samples at the end of the frame whose ratios are used."""
GRID = 2048
"""Length of the circular wavelet grid, samples: on 512 the wavelets below 20 Hz would wrap around onto the frame."""
BANDWIDTH = 1.0
"""Standard deviation of the wavelet's Gaussian envelope, in periods of its centre frequency."""


def wavelet_frequencies() -> NDArray[np.float64]:
    """Centre frequencies of the rows of a map; (64,) float64, Hz."""
    return np.linspace(*BAND, FREQUENCIES)
