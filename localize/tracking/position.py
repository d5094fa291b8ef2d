"""Where a contact is, between the points: the likelihood of its footprints, refined to any place around the best.

Each footprint (:mod:`localize.tracking.footprints`) is scored as the decoder of points scores a point. Around the best
maxima of the grid footprints are made anew, ever closer together: of a finger as wide as the pitch all points of the
grid are far from fitting, and the best of them may lie elsewhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.refusal import Refusal
from localize.decoders.bayes import Ambient, BayesDecoder
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.likelihood import Screen, tables_of
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise import NoiseChoice
from localize.signals.threads import one_thread
from localize.tracking.footprints import footprint_response, footprints_over, pitch_of, shares_at

if TYPE_CHECKING:
    from torch import Tensor

    from acoustic_fem import Library

Array = NDArray[np.float64]

RADIUS = 4.0
"""Radius of a contact where none is given, mm: that of a finger that touches lightly."""
LOWEST = 0.25
"""Lowest frequency of a contact, Hz: fingers come down and stay."""
NUMBERS = 3e7
"""Numbers that the covariances of all footprints may hold."""
MISFIT = 1e-3
"""Share of a frame's level that is noise at least: no library is exact."""
UNFIT = 0.03
"""Share of a frame's level that places a pitch apart leave unexplained."""
REACH = 2.0
"""Distance to which a maximum is looked for beyond places that were scored, in their distances."""
MAXIMA = 12
"""Number of maxima of the grid that are refined."""
CANDIDATES = (10, 8, 6, 4, 3, 2, 2)
"""Number of them that go on after each round."""
_AROUND = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)], np.float64)
_QUADRATIC = np.linalg.pinv(np.column_stack([np.ones(9), _AROUND, _AROUND**2 / 2, _AROUND[:, 0] * _AROUND[:, 1]]))


@dataclass(frozen=True, eq=False)
class Positions:
    """Positions of contacts, one of each signal."""

    place: Array
    """Most likely middle of each contact in the plan of :attr:`localize.ArrayResponse.position`; (n, 2) float64, mm."""
    covariance: Array
    """Covariance of the place by the posterior, about the most likely one; (n, 2, 2) float64, mm^2."""
    point: NDArray[np.int64]
    """Index of the point whose middle is nearest, from 0; (n,) int64."""

    @property
    def deviation(self) -> Array:
        """Standard deviation of the place, the root of the mean over both directions; (n,) float64, mm."""
        return np.sqrt(np.trace(self.covariance, axis1=1, axis2=2) / 2)


class PositionDecoder(BayesDecoder):
    """Decoder of places between the points, for a contact that covers several membranes.

    ``locate`` gives the probability that each point is the nearest. Making one takes some seconds.

    Args:
        library: with a design, as of :class:`localize.BayesDecoder`.
        radius: of the contact, mm.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.

    Raises:
        Refusal: bare transfer functions; a radius out of range; as :class:`localize.BayesDecoder`.
    """

    bounds_scores = False

    def __init__(
        self,
        library: Library | ArrayResponse,
        radius: float = RADIUS,
        microphone_noise: NoiseChoice = 1e-3,
        ambient: Ambient = None,
    ) -> None:
        self.radius = radius
        self._response = response_of(library)
        super().__init__(self._response, microphone_noise, ambient)

    def _touched(self, library: Library | ArrayResponse, response: ArrayResponse) -> Array:
        """Covariances of the footprints."""
        size = len(response.microphones) * SAMPLES
        self.footprints = footprints_over(response, self.radius, int(NUMBERS / size**2))
        assert response.position is not None
        apart = np.linalg.norm(self.footprints.place[:, None] - response.position, axis=-1)
        self._nearest = apart.argmin(1)
        return self._covariances(self.footprints.share)

    def _prepare(self, whitening: Sequence[Array]) -> None:
        """The screens of the footprints, and what makes noise and sound white for others."""
        super()._prepare(whitening)
        self._whitening = tuple(whitening)

    def _covariances(self, share: Array) -> Array:
        return touch_covariances(footprint_response(self._response, share), np.eye(SAMPLES), lowest=LOWEST)

    def log_likelihood(self, frames: Array) -> Array:
        """Log-likelihood that each point is the nearest, all places of the grid equally likely beforehand.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        score = self._of_places(frames)
        found = np.full((len(score), self.point_count), -np.inf)
        for point in np.unique(self._nearest):
            found[:, point] = np.logaddexp.reduce(score[:, self._nearest == point], axis=1)
        # A point that is nowhere the nearest is as far behind as any.
        return np.where(np.isfinite(found), found, score.min(1, keepdims=True))

    def _of_places(self, frames: Array) -> Array:
        """Log-likelihood of the places of the grid, (n, n_place) nats."""
        return np.asarray(
            super().log_likelihood(self._quieted(frames, self.footprints.step))[:, self.footprints.footprint]
        )

    def _quieted(self, frames: Array, step: float) -> Array:
        """Frames (n, n_microphone, 250) so quiet that noise covers what places a step apart, mm, cannot fit."""
        loudest = frames.std(2).max(1)[:, None, None]
        misfit = max(MISFIT, UNFIT * step / pitch_of(self._response))
        return np.asarray(frames * np.minimum(1.0, self.noise_rms / misfit / np.maximum(loudest, 1e-300)))

    @one_thread()
    def position(self, signals: ArrayLike | Tensor) -> Positions:
        """Where contacts that stand still are; frames of one signal are taken as independent observations of it.

        Args:
            signals: as of :meth:`localize.BayesDecoder.locate`.

        Returns:
            One position of each signal.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        each = [self._position(frames) for frames in cut_frames(batch)]
        place = np.stack([one for one, _ in each])
        assert self._response.position is not None
        nearest = np.linalg.norm(place[:, None] - self._response.position, axis=-1).argmin(1)
        return Positions(place, np.stack([spread for _, spread in each]), nearest)

    @one_thread()
    def log_likelihood_of(self, signals: ArrayLike | Tensor, place: ArrayLike) -> Array:
        """Log-likelihood of places that one knows a contact to be at one of, such as those along a line.

        Args:
            signals: as of :meth:`localize.BayesDecoder.locate`; frames of one signal count together.
            place: (n_place, 2) mm, at least two.

        Returns:
            (n, n_place) float64, nats, up to a constant per signal.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`; places of another shape.
        """
        asked = np.asarray(place, dtype=np.float64)
        if asked.ndim != 2 or asked.shape[0] < 2 or asked.shape[1] != 2 or not np.isfinite(asked).all():
            raise Refusal(f"place has shape {asked.shape}: it must be (n, 2), finite, with n at least 2")
        batch, _ = checked_signals(signals, self.microphones)
        quiet = (self._quieted(frames, 0.0).reshape(len(frames), -1) for frames in cut_frames(batch))
        return np.stack([self._scores_at(asked, flat) for flat in quiet])

    def _position(self, frames: Array) -> tuple[Array, Array]:
        """Most likely place and its covariance from the frames of one signal, (n_frame, n_microphone, 250)."""
        middle, wide = self._maxima(self._of_places(frames).sum(0))
        step = np.full(len(middle), self.footprints.step / 2)
        found: list[_Maximum] = []
        for count in (*CANDIDATES, 0):
            flat = self._quieted(frames, float(step.max())).reshape(len(frames), -1)
            around = middle[:, None] + step[:, None, None] * _AROUND
            values = self._scores_at(around.reshape(-1, 2), flat).reshape(-1, 9)
            top, spread = self._vertex(values, step)
            flat_top = ~np.isnan(wide).any((1, 2))
            top[flat_top], spread[flat_top] = 0.0, wide[flat_top]
            # The louder a frame counts, the more nats apart places are: those of one round are compared.
            score = values[:, 4] - values[:, 4].max()
            order = np.argsort(-score)
            found += [_Maximum(score[k], middle[k] + top[k], spread[k]) for k in order[count:]]
            kept = order[:count]
            # A vertex at the edge of what was scored may lie beyond.
            step = np.where(np.linalg.norm(top, axis=1) < step, step / 2, step)[kept]
            middle, wide = (middle + top)[kept], wide[kept]
        return _mixed(found)

    def _maxima(self, score: Array) -> tuple[Array, Array]:
        """The best places of the grid by their log-likelihoods (n_place,).

        Returns:
            Places with a footprint of their own that no neighbour exceeds, and the middles of those that share one;
            (n, 2) mm. The covariances of the latter, (n, 2, 2) mm^2, not a number for the former.
        """
        prints = self.footprints
        board = np.full(prints.node.max(0) + 3, -np.inf)
        row, column = prints.node.T + 1
        board[row, column] = score
        around = np.stack([board[row + i, column + j] for i, j in _AROUND.astype(int)])
        count = np.bincount(prints.footprint)
        own = np.flatnonzero((score >= around.max(0)) & (count[prints.footprint] == 1))
        middle, wide, best = [*prints.place[own]], [np.full((2, 2), np.nan)] * len(own), [*score[own]]
        for number in np.flatnonzero(count > 1):
            alike = prints.footprint == number
            middle.append(prints.place[alike].mean(0))
            wide.append(np.cov(prints.place[alike].T, bias=True) + prints.step**2 / 12 * np.eye(2))
            best.append(score[alike][0])
        kept = np.argsort(-np.array(best))[:MAXIMA]
        return np.stack(middle)[kept], np.stack(wide)[kept]

    def _scores_at(self, place: Array, flat: Array) -> Array:
        """Log-likelihoods of any places (n, 2) mm, of frames (n_frame, n_microphone 250) together; (n,) nats."""
        if not len(place):
            return np.empty(0)
        share = shares_at(self._response, self.radius, place)
        share /= np.maximum(np.linalg.norm(share, axis=1, keepdims=True), 1e-12)
        covariances = self._covariances(share)
        levels = []
        for level, whiten in zip(self.ambient, self._whitening, strict=True):
            screen = Screen(tables_of(covariances, whiten, level), len(self.ambient) > 1)
            scored = screen(flat)
            screen.score_again(scored, np.full(len(flat), -np.inf))
            levels.append(scored.score)
        return np.asarray(np.max(levels, axis=0).sum(0))

    def _vertex(self, values: Array, step: Array) -> tuple[Array, Array]:
        """Ways to maxima, (n, 2) mm, and their covariances, (n, 2, 2) mm^2, by (n, 9) values a step of (n,) mm apart.

        Where values do not bend down, the way is that to the best of them.
        """
        _, slope_x, slope_y, along, across, mixed = _QUADRATIC @ (values - values[:, 4:5]).T
        bend = -np.stack([np.stack([along, mixed], -1), np.stack([mixed, across], -1)], -1)
        size, axes = np.linalg.eigh(bend)
        # Flatter than over the next points nothing is known to be.
        flattest = (step / pitch_of(self._response))[:, None] ** 2
        turned = np.einsum("nij,ni->nj", axes, np.column_stack([slope_x, slope_y])) / np.maximum(size, flattest)
        way = np.clip(np.einsum("nij,nj->ni", axes, turned), -REACH, REACH)
        way[size[:, 0] <= 0] = _AROUND[values.argmax(1)][size[:, 0] <= 0]
        covariance = np.einsum("nij,nj,nkj->nik", axes, 1 / np.maximum(size, flattest), axes)
        return way * step[:, None], covariance * step[:, None, None] ** 2


@dataclass(frozen=True)
class _Maximum:
    """A place that the likelihood prefers to those around it."""

    score: float
    place: Array
    covariance: Array


def _mixed(found: list[_Maximum]) -> tuple[Array, Array]:
    """The most likely place, and the covariance about it of a mixture of normal distributions."""
    best = max(found, key=lambda each: each.score)
    covariance, total = np.zeros((2, 2)), 0.0
    for each in found:
        away = each.place - best.place
        weight = float(np.exp(each.score - best.score) * np.sqrt(np.linalg.det(each.covariance)))
        covariance += weight * (each.covariance + np.outer(away, away))
        total += weight
    return best.place, covariance / total
