"""To 1 kHz, whole recordings and streams alike: one polyphase filter, the same values however a stream is cut up.

The filter is linear in phase and 20 samples of 1 kHz long: a stream is resampled 10 ms after it came in.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

import numpy as np
import scipy.signal

from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array
from localize.signals.stimulus import SAMPLE_RATE

HALF_LENGTH = 10
"""Length of the filter from its middle to its end, samples of the lower rate."""
FULL_SCALES = (1e-12, 1e12)
"""Least and most pressure, Pa, that the largest value of a recording can stand for."""
LARGEST_DENOMINATOR = 10_000
"""Largest denominator of the ratio of the rates, which is rounded to it."""
_CHUNK = 1_000_000  # samples that are resampled at once


def ratio_to_one_kilohertz(rate: float) -> tuple[int, int]:
    """Ratio of 1 kHz to a rate in Hz as a fraction in lowest terms: up and down."""
    ratio = Fraction(SAMPLE_RATE / rate).limit_denominator(LARGEST_DENOMINATOR)
    return ratio.numerator, ratio.denominator


@lru_cache(maxsize=8)
def _filter(up: int, down: int) -> Array:
    """Low-pass at half the lower rate, on the grid of ``up`` times the rate; (2 HALF_LENGTH max(up, down) + 1,)."""
    slower = max(up, down)
    return np.asarray(scipy.signal.firwin(2 * HALF_LENGTH * slower + 1, 1 / slower, window=("kaiser", 5.0)))


def at_one_kilohertz(samples: Array, rate: float) -> Array:
    """Samples at 1 kHz by a polyphase filter (as scipy.signal.resample_poly).

    The ends are continued by the end values: a step to zero there would ring into the first and last frame.

    Args:
        samples: (n_channel, n_sample) float64, in any unit.
        rate: of the samples, Hz.

    Returns:
        (n_channel, k) float64, in the unit of the samples.
    """
    resampler = StreamResampler(rate, len(samples))
    # In chunks, since the filter copies what it is given several times.
    chunks = (samples[:, first : first + _CHUNK] for first in range(0, samples.shape[1], _CHUNK))
    return np.concatenate([*map(resampler.push, chunks), resampler.finish()], axis=1)


class StreamResampler:
    """Resampler of a stream to 1 kHz: all pushed chunks and the end joined are what :func:`at_one_kilohertz` gives of
    the whole, to the last bit.

    Args:
        rate: of what is pushed, Hz.
        channels: how many.
        limit: samples that reach it before the filter are put at it behind the filter, which would hide them. By
            default none are.
    """

    def __init__(self, rate: float, channels: int, limit: float | None = None) -> None:
        self.up, self.down = ratio_to_one_kilohertz(rate)
        self.limit = limit
        half = HALF_LENGTH * max(self.up, self.down)
        self._before = self.down - half % self.down
        taps = np.ones(1) if self.up == self.down else self.up * _filter(self.up, self.down)
        self._half = 0 if self.up == self.down else half
        self._taps = np.concatenate([np.zeros(self._before), taps])
        self._channels = channels
        self.next = 0
        """Number of the output sample that comes next; sample n lies at n down / up of the input."""
        self.skip(0)

    def skip(self, first: int, at_least: int = 0) -> None:
        """Begin anew: the next chunk starts with this input sample, and the sample before it is unknown.

        Args:
            first: number of the input sample.
            at_least: number of the output sample that comes next; a later one where the input begins later.
        """
        self._input = first
        self._begun = False
        self.next = max(at_least, -(-first * self.up // self.down))
        self._kept = np.empty((self._channels, 0))
        self._start = 0  # number of the first kept input sample, a multiple of down
        self._clipped = np.empty((3, 0))  # output number, channel and value of samples that reached the limit

    def push(self, chunk: Array) -> Array:
        """Samples at 1 kHz that a chunk completes.

        Args:
            chunk: (n_channel, n) float64, input samples that follow those before.

        Returns:
            (n_channel, k) float64, k >= 0, in the unit of the chunks.
        """
        if not chunk.shape[1]:
            return np.empty((self._channels, 0))
        if self.limit is not None:
            channel, index = np.nonzero(np.abs(chunk) >= self.limit)
            value = np.copysign(self.limit, chunk[channel, index])
            number = np.rint((self._input + index) * self.up / self.down)
            self._clipped = np.concatenate([self._clipped, [number, channel, value]], axis=1)
        self._input += chunk.shape[1]
        if self.up == self.down:
            return self._marked(chunk.copy())
        if not self._begun:
            self._begun = True
            self._start = self._oldest() // self.down * self.down
            chunk = np.concatenate([np.repeat(chunk[:, :1], self._input - chunk.shape[1] - self._start, 1), chunk], 1)
        self._kept = np.concatenate([self._kept, chunk], axis=1)
        return self._filtered((self._input * self.up - 1 - self._half) // self.down + 1)

    def finish(self) -> Array:
        """Last samples at 1 kHz: the last value goes on, as behind the end of a whole recording; (n_channel, k)
        float64.
        """
        stop = -(-self._input * self.up // self.down)
        if self.up == self.down or not self._begun or stop <= self.next:
            return np.empty((self._channels, 0))
        longer = self._half // self.up + 2
        self._kept = np.concatenate([self._kept, np.repeat(self._kept[:, -1:], longer, axis=1)], axis=1)
        return self._filtered(stop)

    def _oldest(self) -> int:
        """Number of the first input sample that the next output sample needs."""
        return -(-(self.next * self.down - self._half) // self.up)

    def _filtered(self, stop: int) -> Array:
        """Output samples up to a number, from the kept input samples."""
        if stop <= self.next:
            return np.empty((self._channels, 0))
        # Output m of the filter lies at m down - before - half on the fine grid; the first kept sample is a multiple
        # of down, so that the phases are those of the whole recording.
        shift = (self._half + self._before) // self.down - self._start * self.up // self.down
        made = scipy.signal.upfirdn(self._taps, self._kept, self.up, self.down, axis=1)
        made = np.asarray(made[:, self.next + shift : stop + shift])
        made = self._marked(made)
        drop = max(0, self._oldest() // self.down * self.down - self._start)
        self._kept = self._kept[:, drop:].copy()
        self._start += drop
        return made

    def _marked(self, made: Array) -> Array:
        """Count the output samples, those that were clipped put at the limit."""
        first, self.next = self.next, self.next + made.shape[1]
        if self._clipped.shape[1]:
            now = self._clipped[0] < self.next
            number, channel, value = self._clipped[:, now & (self._clipped[0] >= first)]
            made[channel.astype(np.int64), (number - first).astype(np.int64)] = value
            self._clipped = self._clipped[:, ~now]
        return made


def check_full_scale(full_scale: float | None) -> None:
    """Refuse a full scale that no recording has.

    Raises:
        Refusal: it is not a number within :data:`FULL_SCALES`.
    """
    least, most = FULL_SCALES
    if full_scale is not None:
        check_range("full_scale", full_scale, least, most, "Pa")
