"""Likelihood of a moving contact: the footprint pressed in each hop, beside the decay of those pressed before.

A finger that writes leaves a membrane in less than the time of a frame, and the signal from there lasts longer. A
frame's decimated samples are therefore taken as the sum of sources that last a hop of 16 ms each, the response of each
footprint to a source being known over time: the hops before, by what has been decided of them; noise; and one footprint
pressed from the middle of the frame to its end, of unknown power,

    x ~ N(0, N + sum_past v A A^T + g B B^T),

with A the responses to the samples of a past hop of power v, and B those of the footprint in question. Its likelihood,
maximised over g as in :mod:`localize.decoders.bayes`, counts by the share of the newest hop, for the same samples are
judged in several frames.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem.numerics.frequency_splines import interpolated
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import (
    DECIMATION,
    SAMPLES,
    check_level,
    check_noise,
    floor_covariance,
    frame_noise_covariance,
    joint_covariance,
    low_pass,
    sampled_waves,
)
from localize.decoders.likelihood import vertex
from localize.live.events import HOP
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse
from localize.signals.noise_model import NoiseChoice
from localize.signals.stimulus import BAND, SAMPLE_RATE
from localize.tracking.footprints import Footprints, footprint_response
from localize.tracking.tracking_options import TrackingOptions

EARLY = 3
"""Number of decimated samples by which the limited band makes responses begin before their source."""
STEP = HOP // DECIMATION
"""Number of decimated samples of a hop."""
_PERIOD = 4000


@dataclass(frozen=True, eq=False)
class ScoredHop:
    """Scores of all footprints in one hop."""

    gain: Array
    """Log-likelihood of each footprint over that of nothing new, zero or above; (n_footprint,) float64, nats."""
    power: Array
    """Mean square of the source of each footprint over the hop, if it is the one; (n_footprint,) float64, Pa^2."""
    source: Array
    """Mean of that source; (n_footprint,) float64, Pa in a cavity of the mean point."""


class MovingScorer:
    """Scorer of footprints, hop by hop.

    Args:
        response: of a library with a design.
        footprints: that may be pressed.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: level of room sound, dB SPL; None for a quiet room.
        high_pass: corner of the high-pass that frames come through, Hz; None for none.
        options: of the tracker.

    Raises:
        Refusal: as of :class:`localize.BayesDecoder`.
    """

    def __init__(
        self,
        response: ArrayResponse,
        footprints: Footprints,
        microphone_noise: NoiseChoice = "design",
        ambient: float | None = None,
        high_pass: float | None = HIGH_PASS,
        options: TrackingOptions = TrackingOptions(),
    ) -> None:
        self.options = options
        check_noise(microphone_noise)
        check_level(response, ambient)
        noise = response.noise(microphone_noise)
        self._noise = joint_covariance(response, noise, ambient)
        # Hum fills a few lines and hides no source: what counts is compared with the rest.
        self._hiss = float(self._noise[0, 0] - floor_covariance(noise)[0, 0] + frame_noise_covariance(noise)[0])
        self._channels = len(response.microphones)
        self._reduce = low_pass()
        response = footprint_response(response, _of_two(footprints.fraction), options.footprints.top_frequency)
        taps = impulse_responses(response, high_pass, options.heard_samples)[: len(footprints.fraction)]
        self._count = len(taps)
        self._now = (
            _spread(taps, np.arange(options.ahead), options.before).transpose(2, 3, 0, 1).reshape(self._size, -1)
        )
        past = _spread(taps, np.arange(-options.heard_samples, 0), options.before)
        self._past = past.reshape(self._count, options.heard_samples, self._size)
        self.reset()

    @property
    def _size(self) -> int:
        return self._channels * SAMPLES

    def reset(self) -> None:
        """Forget all earlier frames."""
        self._heard = np.zeros((self.options.heard_samples, self._count))  # power of past sources

    def score(self, frame: Array) -> ScoredHop:
        """Scores of a frame, (n_microphone, 250) float64, Pa."""
        x = (frame @ self._reduce.T).reshape(-1)
        floor = self.options.misfit**2 * float(np.mean(x**2))
        known = self._noise + floor * np.eye(self._size)
        sample, number = np.nonzero(self._heard > self.options.forgotten * (floor + self._hiss))
        if len(sample):
            columns = self._past[number, sample] * np.sqrt(self._heard[sample, number])[:, None]
            known = known + columns.T @ columns
        root = np.linalg.cholesky(known)
        both = scipy.linalg.solve_triangular(root, np.column_stack([x, self._now]), lower=True, check_finite=False)
        white, responses = both[:, 0], both[:, 1:].reshape(self._size, self._count, -1).transpose(1, 2, 0)
        value, vector = np.linalg.eigh(responses @ responses.transpose(0, 2, 1))
        value = np.clip(value, 0.0, None)
        part = np.einsum("pij,pi->pj", vector, responses @ white)
        powers = self.options.tried_powers
        gained = powers[:, None, None] * value
        each = 0.5 * (powers[:, None, None] * part**2 / (1 + gained)).sum(2) - 0.5 * np.log1p(gained).sum(2)
        power = powers[each.argmax(0)][:, None]
        share = power / (1 + power * value)
        newest = vector[:, :STEP]
        source = np.einsum("pij,pj->pi", newest, share * part)
        unsure = np.einsum("pij,pj->pi", newest**2, share)
        gain = np.maximum(vertex(each.T), 0.0)
        return ScoredHop(gain, np.where(gain > 0, (source**2 + unsure).mean(1), 0.0), source.mean(1))

    def decide(self, power: Array) -> None:
        """Take the powers of all footprints in the hop that was scored, (n_footprint,) Pa^2, for known."""
        self._heard = np.concatenate([self._heard[STEP:], np.tile(power, (STEP, 1))])


def impulse_responses(response: ArrayResponse, high_pass: float | None, heard_samples: int) -> Array:
    """Responses of the decimated samples to one sample of a source at 250 Hz, behind the high-pass of a stream.

    Args:
        response: of the footprints.
        high_pass: corner, Hz; None for none.
        heard_samples: number of decimated samples behind the source.

    Returns:
        (n_footprint, n_microphone, n_sample) float64, from EARLY samples before the source on.
    """
    frequency = np.fft.rfftfreq(_PERIOD, 1 / SAMPLE_RATE).astype(np.float64)
    top = SAMPLE_RATE / DECIMATION / 2
    inside = frequency <= min(top, float(response.frequency[-1]))
    gain = np.sin(np.pi / 2 * np.clip((top - frequency[inside]) / (top - BAND[1]), 0, 1)) ** 2
    _, passed = sampled_waves(frequency[inside])
    gain = gain * passed
    if high_pass is not None:
        _, high = scipy.signal.sosfreqz(high_pass_sections(high_pass), frequency[inside], fs=SAMPLE_RATE)
        gain = gain * high
    spectrum = np.zeros((*response.transfer_function.shape[:2], len(frequency)), np.complex128)
    spectrum[..., inside] = gain * interpolated(response.transfer_function, response.frequency, frequency[inside])
    taps = np.fft.irfft(spectrum, _PERIOD)[..., ::DECIMATION] * DECIMATION
    return np.asarray(np.concatenate([taps[..., -EARLY:], taps[..., :heard_samples]], -1))


def _spread(taps: Array, source: NDArray[np.int64], before: int) -> Array:
    """Responses of a frame's samples to sources at given samples after its ``before`` first ones.

    Returns:
        (n_footprint, n_source, n_microphone, SAMPLES) float64.
    """
    lag = np.arange(SAMPLES) - before - source[:, None] + EARLY
    heard = (lag >= 0) & (lag < taps.shape[2])
    return np.asarray(np.where(heard, taps[:, :, np.where(heard, lag, 0)], 0.0).transpose(0, 2, 1, 3))


def _of_two(share: Array) -> Array:
    """At least two footprints, as an array has points."""
    return share if len(share) > 1 else np.concatenate([share, share])
