"""Two touches at once: every pair of points, weighed against every single point.

Two independent touches i and j give the microphones' samples the covariance g (C_i + r C_j) + N: C_i as in
:mod:`localize.decoders.frame_covariance`, r the ratio of their powers, g the power of the first. All pairs are scored
over a grid of ratios with g profiled out, as one point is in :mod:`localize.decoders.bayes`. The search is full,
because a greedy one fails: the single point that explains two touches best is often neither of them.

Whether there are two is decided by the gain in log-likelihood of the best pair over the best point. Of a sensor that
nobody calibrated each point has the covariance that it has on average over what its design may come out as: with that
of the design, what a made sensor does otherwise is taken for a second touch nearly always.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Refusal
from localize.decoders.frame_covariance import check_noise, low_pass, touch_covariances, whitening
from localize.decoders.hypotheses import made_covariances
from localize.decoders.likelihood import CHUNK, POWERS, vertex
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor

    from acoustic_fem import Library
    from acoustic_fem.scatter.tolerances import Tolerance

LEVELS = (-20.0, -10.0, 0.0, 10.0, 20.0)
"""Powers of the second touch over that of the first that are tried, dB."""
WEAKEST = 1e-4
"""Share of the noise at g = 1 below which eigenvectors are left out."""
THRESHOLD = 5.0
"""Gain of the best pair over the best point, nats, from which there are two touches."""
UNCALIBRATED_THRESHOLD = 35.0
"""The same with tolerances."""


@dataclass(frozen=True, eq=False)
class TwoTouches:
    """Decisions on n signals."""

    pair: NDArray[np.int64]
    """Best two points, from 0, the lower one first; (n, 2) int64."""
    level: NDArray[np.float64]
    """Power of the second point over that of the first, the best of the grid; (n,) float64, dB."""
    point: NDArray[np.int64]
    """Best single point, from 0; (n,) int64."""
    gain: NDArray[np.float64]
    """Log-likelihood of the best pair over that of the best point; (n,) float64, nats."""
    is_two: NDArray[np.bool_]
    """Whether the gain is above the threshold; (n,) bool."""


class TwoTouchDecoder:
    """Maximum likelihood over all pairs of points.

    Tables grow with the square of the number of points: 0.3 GB for 36 points and three microphones.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of 2 to 64 points and at least two microphones.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        threshold: nats; by default :data:`THRESHOLD`, with tolerances :data:`UNCALIBRATED_THRESHOLD`.
        tolerances: of manufacturing, of a sensor that nobody calibrated, such as
            :data:`acoustic_fem.scatter.UNCALIBRATED`; None where the library knows its sensor.

    Raises:
        Refusal: too many points, a threshold below 0, tolerances of bare transfer functions or of a design whose
            scatter is not known, or as :class:`localize.BayesDecoder`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = 1e-3,
        threshold: float | None = None,
        tolerances: Sequence[Tolerance] | None = None,
    ) -> None:
        check_noise(microphone_noise)
        if threshold is None:
            threshold = THRESHOLD if tolerances is None else UNCALIBRATED_THRESHOLD
        if not threshold >= 0:
            raise Refusal(f"threshold = {threshold} must be 0 or above")
        response = response_of(library)
        if response.point_count > 64:
            raise Refusal(f"{response.point_count} points: pairs are searched among at most 64")
        self.microphones = response.microphones
        self.line = response.line
        self.place = response.place
        self.threshold = threshold
        self.pairs = np.array(list(combinations(range(response.point_count), 2)))
        """(n_pair, 2) points of each pair, from 0."""
        whiten = whitening(response.noise(microphone_noise))
        self._reduce = (whiten @ low_pass()).T.copy()
        if tolerances is None:
            single = touch_covariances(response, whiten)
        else:
            single = made_covariances(library, tolerances, whiten)
        self._single = _Tables(single)
        # The sum of the powers is 1, so that both touches keep within the powers tried at every ratio.
        second = 1 / (1 + 10 ** (-np.array(LEVELS) / 10))
        self._double = [
            _Tables((1 - share) * single[self.pairs[:, 0]] + share * single[self.pairs[:, 1]]) for share in second
        ]

    @one_thread()
    def log_likelihood(self, frames: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Log-likelihoods of every point and of every pair, maximised over the powers.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) and (n, n_pair, n_level) float64, nats, up to the same constant per frame.
        """
        x = (frames @ self._reduce).reshape(len(frames), -1)
        return self._single(x), np.stack([tables(x) for tables in self._double], -1)

    def locate(self, signals: ArrayLike | Tensor) -> TwoTouches:
        """Which points were touched, and whether there were two.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples; longer ones are cut into frames
                that are taken as independent observations of the same touches.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, _ = checked_signals(signals, self.microphones)
        frames = cut_frames(batch)
        flat = frames.reshape(-1, *frames.shape[2:])
        parts = [self.log_likelihood(flat[k : k + CHUNK]) for k in range(0, len(flat), CHUNK)]
        one, two = (
            np.concatenate([part[k] for part in parts]).reshape(*frames.shape[:2], *parts[0][k].shape[1:]).sum(1)
            for k in (0, 1)
        )
        best = two.reshape(len(two), -1).argmax(1)
        pair, level = np.divmod(best, len(LEVELS))
        gain = two.reshape(len(two), -1).max(1) - one.max(1)
        return TwoTouches(
            pair=self.pairs[pair],
            level=np.array(LEVELS)[level],
            point=one.argmax(1),
            gain=gain,
            is_two=gain > self.threshold,
        )


class _Tables:
    """Likelihood of zero-mean Gaussians with covariances g C_k + 1, maximised over g."""

    def __init__(self, covariances: NDArray[np.float64]) -> None:
        values, vectors = np.linalg.eigh(covariances)
        rank = max(1, int((values > WEAKEST).sum(1).max()))
        self.vectors = np.ascontiguousarray(vectors[:, :, -rank:])
        self.values = np.clip(values[:, -rank:], 0, None)
        self.log_determinant = np.stack([np.log1p(self.values * power).sum(1) for power in POWERS], -1)

    def __call__(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, size) to (n, n_covariance)."""
        result = np.empty((len(x), len(self.vectors)))
        for first in range(0, len(self.vectors), CHUNK):
            part = slice(first, first + CHUNK)
            gain = self.values[part, :, None] * POWERS
            energy = (x @ self.vectors[part]) ** 2
            score = -0.5 * (energy @ (-gain / (1 + gain)) + self.log_determinant[part, None, :])
            result[:, part] = vertex(score).T
        return result
