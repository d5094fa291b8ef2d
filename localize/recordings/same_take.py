"""Search for recordings that hold one take: the same signals shifted, cut, at another gain, sample rate or resolution.

Two stretches of each recording, from its first touch on and up to its last, are looked for in all others: at 250 Hz in
the mean of the microphones, everywhere at once (cross-correlation by FFT, normalised by the energy of each window), and
where that is alike at 1 kHz in every microphone. Different takes share slow drift, which dominates signals, or hum,
which dominates their differences; the same take agrees in both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.fft
import scipy.signal
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

Single = NDArray[np.float32]

STRETCH = 4000
"""Length of a stretch, samples at 1 kHz; all, of a shorter recording."""
LEAST_TOUCHED = 2000
"""Number of a stretch's samples that frames with a touch must cover: one tap is like many others."""
ALIKE = 0.99
"""Correlation from which two stretches are one; docs/evidence/localizer.md has what takes reach."""
_COARSE = 4
"""Samples at 1 kHz for one of the first search."""
_COARSE_ALIKE = 0.75
"""Correlation from which a place is looked at closely; a take that lies between two samples loses a part."""
_BLOCK = 3072
"""Samples at 250 Hz that are transformed at once: 12 s and a little."""
_NEAR = 2 * _COARSE
"""Samples at 1 kHz around a place that are tried."""
_TINY = np.finfo(np.float64).tiny


@dataclass(frozen=True)
class SameTake:
    """Pair of recordings that hold one take."""

    first: int
    """Number of the earlier recording, from 0."""
    second: int
    """Number of the later recording, from 0."""
    correlation: float
    """Correlation by which they were found: the lower of those of the signals and of their differences, 0 to 1."""


def find_same_take(signals: Sequence[Single], touched: Sequence[NDArray[np.int64]]) -> SameTake | None:
    """First two recordings found that hold one take, or None.

    Recordings without a stretch that is touched for :data:`LEAST_TOUCHED` are not compared.

    Args:
        signals: of each recording, (n_microphone, n_sample) float32 at 1 kHz, of any level.
        touched: of each recording, (n,) int64, first samples of the frames with a touch, n >= 1, ascending.
    """
    stretches = [
        (number, start)
        for number, (own, frames) in enumerate(zip(signals, touched, strict=True))
        for start in _starts(own.shape[1], frames)
    ]
    if not stretches:
        return None
    coarse = [_coarse(each) for each in signals]
    lengths = np.array([min(STRETCH, signals[number].shape[1]) // _COARSE - 1 for number, _ in stretches])
    padded = np.zeros((len(stretches), _BLOCK), np.float32)
    for row, (number, start) in enumerate(stretches):
        own = coarse[number][start // _COARSE :][: lengths[row]]
        padded[row, : len(own)] = own / max(float(np.linalg.norm(own)), _TINY)
    wanted = scipy.fft.rfft(padded, axis=1).conj()
    for second, own in enumerate(coarse):
        for row, place in _alike(own, wanted, lengths):
            first, start = stretches[row]
            if first == second:
                continue
            correlation = _closely(signals[first][:, start : start + STRETCH], signals[second], place)
            if correlation >= ALIKE:
                return SameTake(min(first, second), max(first, second), correlation)
    return None


def _starts(count: int, frames: NDArray[np.int64]) -> list[int]:
    """First samples of the stretches of a recording that hold enough of touches."""
    begin, end = int(frames[0]), int(frames[-1]) + FRAME
    starts = {max(0, min(begin, count - STRETCH)), max(0, min(end, count) - STRETCH)}
    covered = np.zeros(count + 1, np.int64)
    covered[frames] += 1
    covered[frames + FRAME] -= 1
    inside = np.cumsum(covered)[:count] > 0
    return [start for start in sorted(starts) if inside[start : start + STRETCH].sum() >= LEAST_TOUCHED]


def _coarse(signals: Single) -> Single:
    """(n,) differences of the mean of the microphones at 250 Hz, what lies above 50 Hz weakened; their rms is 1."""
    taps = scipy.signal.firwin(8 * _COARSE + 1, 50.0, fs=SAMPLE_RATE)
    change = np.diff(signals.mean(axis=0, dtype=np.float64))  # before the filter, for which it begins and ends at zero
    made = np.convolve(change, taps, "same")[::_COARSE]
    return np.asarray(made / max(float(np.sqrt(np.mean(made**2))), _TINY), np.float32)


def _alike(own: Single, wanted: NDArray[np.complex64], lengths: NDArray[np.int64]) -> Iterator[tuple[int, int]]:
    """Stretches that are alike a window of a recording: their row, and the window's first sample at 1 kHz.

    Blocks overlap so that every window lies in one.
    """
    for begin in range(0, max(1, len(own) - int(lengths.min()) + 1), _BLOCK - int(lengths.max()) + 1):
        block = own[begin : begin + _BLOCK]
        found = scipy.fft.irfft(wanted * scipy.fft.rfft(block, _BLOCK), _BLOCK, axis=1, overwrite_x=True)
        energy = np.concatenate([[0.0], np.cumsum(block.astype(np.float64) ** 2)])
        for length in np.unique(lengths[lengths <= len(block)]):
            # A silent window has no energy: single precision leaves more of the loud ones there.
            window = np.maximum(energy[length:] - energy[:-length], 1e-8 * energy[-1] + _TINY)
            rows = np.flatnonzero(lengths == length)
            correlation = np.abs(found[rows, : len(window)]) / np.sqrt(window).astype(np.float32)
            best = correlation.argmax(axis=1)
            for k in np.flatnonzero(correlation[np.arange(len(rows)), best] >= _COARSE_ALIKE):
                yield int(rows[k]), _COARSE * (begin + int(best[k]))


def _closely(stretch: Single, signals: Single, place: int) -> float:
    """Correlation of a stretch, but for its ends, with what lies near a place of a recording."""
    near = signals[:, place : place + stretch.shape[1]].astype(np.float64)
    inner = stretch[:, _NEAR:-_NEAR].astype(np.float64)
    whole = _highest(inner, near)
    return whole if whole < ALIKE else min(whole, _highest(np.diff(inner), np.diff(near)))


def _highest(stretch: Array, near: Array) -> float:
    """Highest correlation, in magnitude, with a window of equal length: all microphones together, between samples too.

    Args:
        stretch: (n_microphone, n).
        near: (n_microphone, n + k), k >= 0.
    """
    length = stretch.shape[1]
    stretch = stretch - stretch.mean(axis=1, keepdims=True)
    near = near - near.mean(axis=1, keepdims=True)
    product = sum(np.correlate(row, own, "valid") for row, own in zip(near, stretch, strict=True))
    windows = np.lib.stride_tricks.sliding_window_view(near, length, axis=1)
    energy = length * windows.var(axis=2).sum(axis=0) * (stretch**2).sum()
    found = np.abs(product) / np.sqrt(np.maximum(energy, _TINY))
    best = int(found.argmax())
    if not 0 < best < len(found) - 1:
        return min(float(found[best]), 1.0)
    before, top, behind = found[best - 1 : best + 2]
    # the vertex of the parabola through the highest and its neighbours
    return min(float(top + (behind - before) ** 2 / (8 * max(2 * top - before - behind, _TINY))), 1.0)
