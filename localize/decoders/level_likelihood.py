"""Likelihood of frames under covariances of touches, the likeliest level of the sound around each."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterable
from functools import reduce
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import joint_whitening
from localize.decoders.likelihood import Bounds, Screen, assumed_noise, tables_of
from localize.decoders.partly_known import FEWEST, known_directions, partly_known_tables
from localize.decoders.surroundings import Surroundings
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import cut_frames
from localize.signals.noise_model import NoiseSpectrum

Whitening: TypeAlias = Callable[[ArrayResponse, float | NoiseSpectrum, float | None], Array]
"""Makes the matrix, (n, n) float64, 1/Pa, by which noise and sound of a level at all microphones become white."""


class LevelLikelihood:
    """Likelihood of frames under some covariances of touches at each level of the sound around.

    Args:
        touched: covariances of touches of 0 dB, (n_table, n, n) float64, Pa^2.
        response: the array.
        around: noise and sound.
        options: of the decoder.
        whiten: makes noise and sound white.
    """

    def __init__(
        self,
        touched: Array,
        response: ArrayResponse,
        around: Surroundings,
        options: DecoderOptions,
        whiten: Whitening = joint_whitening,
    ) -> None:
        self.options = options
        noise = assumed_noise(around.noise, options)
        self.whitening = tuple(whiten(response, noise, level) for level in around.ambient)
        """Matrix that makes noise and sound of each level white; (n, n) float64, 1/Pa, each. If frames
        are known in part, it has the known rows alone."""
        self.tables = tuple(
            tables_of(touched, matrix, level, options)
            for matrix, level in zip(self.whitening, around.ambient, strict=True)
        )
        """Tables of each level."""
        self.screens = tuple(Screen(tables, len(self.tables) > 1) for tables in self.tables)
        """Scores by the tables of each level."""
        # Directions that a point does not reach, where all that is left of a frame is noise.
        self._empty = self.tables[0].reduce.shape[1] * (1 - 1 / len(response.microphones))

    def scores(self, frames: Array) -> Array:
        """Log-likelihoods of frames under each covariance, maximised over the power of the touch, over the temperature.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_table) float64, nats, up to a constant per frame.
        """
        flat = frames.reshape(len(frames), -1)
        levels = [screen(flat) for screen in self.screens]
        # Scores stay in single precision only where none of any level may come near the best of all.
        least = np.max([level.best for level in levels], axis=0) - self.options.sure_lead
        for screen, level in zip(self.screens, levels, strict=True):
            screen.score_again(level, least)
        return np.max([level.score for level in levels], axis=0) if len(levels) > 1 else levels[0].score

    def misfit(self, frames: Array) -> Array:
        """Residual that the best covariance leaves of each frame, over that of the noise, as :class:`Locator` has it.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n,) float64.
        """
        flat = frames.reshape(len(frames), -1)
        power, fit, whole = [], [], []
        for screen in self.screens:
            white = flat @ screen.tables.reduce
            power.append((white**2).sum(1))
            fit.append(screen.tables.scores(white).max(1))
            whole.append(fit[-1] + screen.alone(white)[1][:, 0])
        level = np.argmax(whole, axis=0)[None]
        left = np.array(power) / self.options.temperature - 2 * np.array(fit)
        return np.asarray(np.take_along_axis(left, level, 0)[0] / self._empty)

    def partly_known(self, unknown: Array) -> LevelLikelihood | None:
        """Likelihood of frames to which signals are added whose amplitudes nobody knows.

        Args:
            unknown: signals, (n, n_microphone, 250) float64, Pa, with amplitudes of order 1.

        Returns:
            None if the signals leave too little of a frame.
        """
        found = copy.copy(self)
        flat = unknown.reshape(len(unknown), -1)
        parts = [known_directions((flat @ tables.reduce).T) for tables in self.tables]
        if min(len(kept) for kept, _ in parts) < FEWEST:
            return None
        found.whitening = tuple(kept @ white for (kept, _), white in zip(parts, self.whitening, strict=True))
        found.tables = tuple(
            partly_known_tables(tables, kept, left_out)
            for tables, (kept, left_out) in zip(self.tables, parts, strict=True)
        )
        found.screens = tuple(Screen(tables, len(self.tables) > 1) for tables in found.tables)
        found._empty = self._empty * found.tables[0].reduce.shape[1] / self.tables[0].reduce.shape[1]
        return found

    def likeliest_level(self, frames: Array) -> int:
        """Index of the level of the sound around frames (n, n_microphone, 250), Pa, that explains them best."""
        return int(np.argmax([screen(frames.reshape(len(frames), -1)).score.max(1).sum() for screen in self.screens]))


class BoundedSearch:
    """Search for the likeliest covariances: those that cannot be near the best get a bound in place of a score.

    Args:
        likelihood: of the covariances.
    """

    def __init__(self, likelihood: LevelLikelihood) -> None:
        self._likelihood = likelihood
        few = all(screen.is_exact for screen in likelihood.screens)
        self._bounds = () if few else tuple(Bounds(tables) for tables in likelihood.tables)

    @property
    def saves(self) -> bool:
        """True if there are so many covariances that bounds save time."""
        return bool(self._bounds)

    def __call__(self, batch: Array) -> Array:
        """Log-likelihoods of all frames of each signal together, exact for those near the best.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa.

        Returns:
            (n, n_table) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch)
        several = max(1, self._likelihood.options.frames_at_once // frames.shape[1])
        parts = [frames[k : k + several] for k in range(0, len(frames), several)]
        return np.concatenate([self._of_few(part) for part in parts])

    def _of_few(self, frames: Array) -> Array:
        """The same of few signals, (n, n_frame, n_microphone, 250)."""
        options, screens = self._likelihood.options, self._likelihood.screens
        count, each = frames.shape[:2]
        white = [frames.reshape(count * each, -1) @ screen.tables.reduce for screen in screens]
        alone = [screen.alone(x)[1] for screen, x in zip(screens, white, strict=True)]

        def joint(by_level: Iterable[Array]) -> Array:
            best = reduce(np.maximum, (score + own for score, own in zip(by_level, alone, strict=True)))
            return np.asarray(best.reshape(count, each, -1).sum(1))

        def exact(chosen: NDArray[np.bool_]) -> Array:
            of_frames = np.repeat(chosen, each, 0)
            return joint(screen.exact(x, of_frames) for screen, x in zip(screens, white, strict=True))

        def all_exact() -> Array:
            return joint(screen.tables.scores(x) for screen, x in zip(screens, white, strict=True))

        score = joint(bound(x) for bound, x in zip(self._bounds, white, strict=True))
        # In a frame that says little all points may be near the best: then a bound each is no help.
        many = (score > score.max(1, keepdims=True) - options.far_lead).mean(1) > options.many_tables
        if many.all():
            return all_exact()
        leading = min(options.leading_points, score.shape[1])
        known = np.zeros(score.shape, bool)
        np.put_along_axis(known, np.argpartition(-score, leading - 1, axis=1)[:, :leading], True, axis=1)
        score[known] = exact(known)[known]
        found = np.sort(np.where(known, score, -np.inf), axis=1)
        least = np.minimum(found[:, -1] - options.far_lead, found[:, -leading])
        wanted = ~known & (score > least[:, None])
        many |= wanted.mean(1) > options.many_tables
        wanted[many] = False
        if wanted.any():
            score[wanted] = exact(wanted)[wanted]
        if many.any():
            score[many] = all_exact()[many]
        return score
