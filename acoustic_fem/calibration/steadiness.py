"""Whether a recording is of one piece: level and delay of each microphone against the reference, part by part."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.sound.estimate import amplitudes

Array = NDArray[np.float64]

#: Seconds of a segment: short, so that a part of 5 s has many; rough, since only changes are looked for.
_SEGMENT = 1.0
#: Segments of a part, and the largest number of parts.
_PER_PART, _MOST_PARTS = 18, 8
#: Coherence, and share of its power in the whole recording, from which a frequency of a part says something.
_COHERENCE, _DRIVEN = 0.9, 0.1
#: Share of the frequencies that two parts must have in common to be compared.
_SHARED = 0.25
#: Delays that are tried, s.
_DELAYS = np.linspace(-0.25, 0.25, 2001)


def largest_changes(signals: Array, rate: float, frequency: Array) -> tuple[Array, Array]:
    """Largest changes between two parts of a recording.

    Args:
        signals: (1 + n_microphone, n_sample) float64, Pa, the reference first, of at least 19 s.
        rate: Hz.
        frequency: (n_freq,) Hz, at which they are compared.

    Returns:
        (n_microphone,) float64 of the level in dB, and of the delay in s, both >= 0; 0 of microphones whose parts
        cannot be
        compared: too much noise, or a slow sweep, of which each part holds other frequencies.
    """
    found = amplitudes(signals, rate, frequency, _SEGMENT)
    count = found.shape[1]
    parts = min(max(count // _PER_PART, 1), _MOST_PARTS)
    found = found[:, : count // parts * parts].reshape(len(found), parts, -1, len(frequency))
    x, y = found[0], found[1:]
    power, of_output = (np.abs(x) ** 2).sum(1), (np.abs(y) ** 2).sum(2)
    cross = (x.conj() * y).sum(2)  # (microphone, part, frequency)
    tiny = np.finfo(np.float64).tiny
    known = np.abs(cross) ** 2 > _COHERENCE * power * of_output
    known &= (power > _DRIVEN * power.mean(0)) & (np.abs(cross) > tiny)
    level = 20 * np.log10(np.maximum(np.abs(cross), tiny) / np.maximum(power, tiny))
    unit = cross / np.maximum(np.abs(cross), tiny)
    turns = np.exp(2j * np.pi * _DELAYS * frequency[:, None])
    levels, delays = np.zeros(len(y)), np.zeros(len(y))
    for a, b in combinations(range(parts), 2):
        shared = known[:, a] & known[:, b]
        enough = shared.mean(1) >= _SHARED
        if enough.any():
            difference = np.where(shared, level[:, b] - level[:, a], np.nan)[enough]
            levels[enough] = np.maximum(levels[enough], np.abs(np.nanmedian(difference, axis=1)))
            fit = ((unit[:, b] * unit[:, a].conj() * shared)[enough] @ turns).real
            delays[enough] = np.maximum(delays[enough], np.abs(_DELAYS[fit.argmax(1)]))
    return levels, delays
