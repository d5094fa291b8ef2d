"""Two touches at once: every pair of points, weighed against every single point.

Two independent touches i and j give the microphones' samples the covariance g (C_i + r C_j) + N: C_i as in
:mod:`localize.decoders.frame_covariance`, r the ratio of their powers, g the power of the first. All pairs are scored
over a grid of ratios with g profiled out, as one point is in :mod:`localize.decoders.bayes`. The search is full,
because a greedy one fails: the single point that explains two touches best is often neither of them.

The decision for two touches rests on the gain in log-likelihood of the best pair over the best point. If nobody
calibrated the sensor, each point has its mean covariance over the sensors that its design may come out as. With the
covariance of the design itself, differences between the as-built sensor and its design are nearly always taken for a
second touch.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from acoustic_fem.scatter.tolerances import Tolerance
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.decoder_options import TwoTouchOptions
from localize.decoders.frame_covariance import check_noise, low_pass, touch_covariances, whitening
from localize.decoders.hypotheses import as_built_covariances
from localize.decoders.likelihood import GaussianTables
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor

MOST_POINTS = 64
"""Largest number of points whose pairs are searched."""


@dataclass(frozen=True, eq=False)
class TwoTouches:
    """Decisions on n signals."""

    pair: NDArray[np.int64]
    """Best two points, from 1, the lower one first; (n, 2) int64."""
    level: Array
    """Power of the second point over that of the first, the best of the grid; (n,) float64, dB."""
    point: NDArray[np.int64]
    """Best single point, from 1; (n,) int64."""
    gain: Array
    """Log-likelihood of the best pair over that of the best point; (n,) float64, nats."""
    is_two: NDArray[np.bool_]
    """True if the gain is above the threshold; (n,) bool."""


class TwoTouchDecoder:
    """Maximum likelihood over all pairs of points.

    Its tables grow with the square of the number of points. They take 0.3 GB for 36 points and three microphones.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of 2 to 64 points and at least two microphones.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        threshold: gain from which there are two touches, nats; by default that of the options.
        tolerances: of manufacturing, of a sensor that nobody calibrated, such as
            :data:`acoustic_fem.scatter.UNCALIBRATED`; None where the library knows its sensor.
        options: numbers that tune it.

    Raises:
        Refusal: too many points, a threshold below 0, tolerances of bare transfer functions or of a design whose
            scatter is not known, or as :class:`localize.BayesDecoder`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        threshold: float | None = None,
        tolerances: Sequence[Tolerance] | None = None,
        options: TwoTouchOptions = TwoTouchOptions(),
    ) -> None:
        check_noise(microphone_noise)
        if threshold is None:
            threshold = options.threshold if tolerances is None else options.tolerant_threshold
        check_range("threshold", threshold, 0, unit="nats")
        response = response_of(library)
        if response.point_count > MOST_POINTS:
            problem = f"has {response.point_count} points; pairs are searched among at most {MOST_POINTS}"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
        self.array = response.array
        self.threshold, self.options = threshold, options
        self.pairs = np.array(list(combinations(range(1, response.point_count + 1), 2)))
        """Points of each pair, from 1; (n_pair, 2) int64."""
        whiten = whitening(response.noise(microphone_noise))
        self._reduce = (whiten @ low_pass()).T.copy()
        if tolerances is None:
            single = touch_covariances(response, whiten)
        else:
            single = as_built_covariances(library, tolerances, whiten)
        self._single = GaussianTables.of(single, options)
        # The sum of the powers is 1, so that both touches keep within the powers tried at every ratio.
        second = 1 / (1 + 10 ** (-np.array(options.level_differences) / 10))
        one, other = (single[self.pairs[:, k] - 1] for k in (0, 1))
        self._double = [GaussianTables.of((1 - share) * one + share * other, options) for share in second]

    @one_thread()
    def log_likelihood(self, frames: Array) -> tuple[Array, Array]:
        """Log-likelihoods of every point and of every pair, maximised over the powers.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) and (n, n_pair, n_level) float64, nats, up to the same constant per frame.
        """
        x = (frames @ self._reduce).reshape(len(frames), -1)
        return self._scores(self._single, x), np.stack([self._scores(tables, x) for tables in self._double], -1)

    def _scores(self, tables: GaussianTables, x: Array) -> Array:
        """Scores of white frames (n, size) by all tables, (n, n_table), a part of the tables at once."""
        step = self.options.frames_at_once
        parts = (tables.scores(x, slice(k, k + step)) for k in range(0, len(tables.vectors), step))
        return np.concatenate(list(parts), axis=1)

    def locate(self, signals: ArrayLike | Tensor) -> TwoTouches:
        """The touched points, and whether there are two.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples; longer ones are cut into frames
                that are taken as independent observations of the same touches.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, _ = checked_signals(signals, self.array.microphones)
        frames = cut_frames(batch)
        flat = frames.reshape(-1, *frames.shape[2:])
        step = self.options.frames_at_once
        parts = [self.log_likelihood(flat[k : k + step]) for k in range(0, len(flat), step)]
        one, two = (
            np.concatenate([part[k] for part in parts]).reshape(*frames.shape[:2], *parts[0][k].shape[1:]).sum(1)
            for k in (0, 1)
        )
        best = two.reshape(len(two), -1).argmax(1)
        pair, level = np.divmod(best, len(self.options.level_differences))
        gain = two.reshape(len(two), -1).max(1) - one.max(1)
        return TwoTouches(
            pair=self.pairs[pair],
            level=np.array(self.options.level_differences)[level],
            point=one.argmax(1) + 1,
            gain=gain,
            is_two=gain > self.threshold,
        )
