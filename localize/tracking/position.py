"""Place of a contact between the points: the likelihood of its footprints, refined to any place around the best.

Each footprint (:mod:`localize.tracking.footprints`) is scored as the decoder of points scores a point. From the best
of them the place is looked for by :mod:`localize.tracking.place_search`: of a finger as wide as the pitch all points of
the grid are far from fitting, and the best of them may lie elsewhere.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.library_decoder import LibraryDecoder
from localize.decoders.surroundings import Ambient, Surroundings
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread
from localize.tracking.footprints import footprint_response, footprints_over, pitch_of
from localize.tracking.place_likelihood import PlaceLikelihood
from localize.tracking.place_search import found_place
from localize.tracking.tracking_options import PositionOptions

if TYPE_CHECKING:
    from torch import Tensor

RADIUS = 4.0
"""Radius of a contact where none is given, mm: that of a finger that touches lightly."""


@dataclass(frozen=True, eq=False)
class Positions:
    """Positions of contacts, one of each signal."""

    place: Array
    """Most likely middle of each contact in the plan of :attr:`localize.ArrayResponse.position`; (n, 2) float64, mm."""
    covariance: Array
    """Covariance of the place by the posterior, about the most likely one; (n, 2, 2) float64, mm^2."""
    point: NDArray[np.int64]
    """Point whose middle is nearest, from 1; (n,) int64."""

    @property
    def deviation(self) -> Array:
        """Standard deviation of the place, the root of the mean over both directions; (n,) float64, mm."""
        return np.sqrt(np.trace(self.covariance, axis1=1, axis2=2) / 2)


class PositionDecoder(LibraryDecoder):
    """Decoder of places between the points, for a contact that covers several membranes.

    ``locate`` gives the probability that each point is the nearest. Making one takes some seconds.

    Args:
        library: with a design, as of :class:`localize.BayesDecoder`.
        contact_radius_mm: radius of the contact, mm.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: as of :class:`localize.BayesDecoder`.
        options: as of :class:`localize.BayesDecoder`.
        position_options: numbers that tune the search for a place.

    Raises:
        Refusal: bare transfer functions; a radius out of range; as :class:`localize.BayesDecoder`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        contact_radius_mm: float = RADIUS,
        microphone_noise: NoiseChoice = "design",
        ambient: Ambient = None,
        options: DecoderOptions = DecoderOptions(),
        position_options: PositionOptions = PositionOptions(),
    ) -> None:
        self.position_options = position_options
        response = response_of(library)
        around = Surroundings.of(response, microphone_noise, ambient)
        size = len(response.microphones) * SAMPLES
        self.contact_radius_mm = contact_radius_mm
        self.footprints = footprints_over(response, contact_radius_mm, int(position_options.most_numbers / size**2))
        assert response.position is not None
        apart = np.linalg.norm(self.footprints.place[:, None] - response.position, axis=-1)
        self._nearest = apart.argmin(1)
        self._finer: dict[float | None, PlaceLikelihood] = {}
        pressed = footprint_response(response, self.footprints.fraction)
        touched = touch_covariances(pressed, np.eye(SAMPLES), lowest=position_options.lowest_frequency)
        super().__init__(response, around, touched, options)

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
            self.likelihood.scores(self._quieted(frames, self.footprints.step))[:, self.footprints.footprint]
        )

    def _quieted(self, frames: Array, step: float) -> Array:
        """Frames (n, n_microphone, 250) so quiet that noise covers what places a step apart, mm, cannot fit."""
        loudest = frames.std(2).max(1)[:, None, None]
        misfit = self.position_options.unfit * step / pitch_of(self.response)
        return np.asarray(frames * np.minimum(1.0, self.noise_rms / misfit / np.maximum(loudest, 1e-300)))

    @one_thread()
    def position(self, signals: ArrayLike | Tensor) -> Positions:
        """Places of contacts that stand still; frames of one signal are taken as independent observations of it.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, as of
                :meth:`localize.BayesDecoder.locate`.

        Returns:
            One position of each signal.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        each = [self._position(frames) for frames in cut_frames(batch)]
        place = np.stack([one for one, _ in each])
        assert self.response.position is not None
        nearest = np.linalg.norm(place[:, None] - self.response.position, axis=-1).argmin(1)
        return Positions(place, np.stack([spread for _, spread in each]), nearest + 1)

    @one_thread()
    def log_likelihood_of(self, signals: ArrayLike | Tensor, place: ArrayLike) -> Array:
        """Log-likelihood of given places, if a contact is known to be at one of them, such as places along a line.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, as of
                :meth:`localize.BayesDecoder.locate`; frames of one signal count together.
            place: (n_place, 2) mm, at least two.

        Returns:
            (n, n_place) float64, nats, up to a constant per signal.

        Raises:
            Refusal: as :meth:`localize.BayesDecoder.locate`; places of another shape.
        """
        asked = np.asarray(place, dtype=np.float64)
        if asked.ndim != 2 or asked.shape[0] < 2 or asked.shape[1] != 2 or not np.isfinite(asked).all():
            raise Refusal(
                f"has shape {asked.shape}; it must be (n, 2), finite, with n at least 2",
                kind=Kind.WRONG_TYPE,
                field="place",
            )
        batch, _ = checked_signals(signals, self.microphones)
        return np.stack([self._along(asked, frames) for frames in cut_frames(batch)])

    def _along(self, place: Array, frames: Array) -> Array:
        """Log-likelihoods of places (n, 2) mm by the frames of one signal together, (n,) nats."""
        likelihood = self._likelihood_at(self._level(frames))
        return likelihood.along(place, likelihood.white(frames))

    def _position(self, frames: Array) -> tuple[Array, Array]:
        """Most likely place and its covariance from the frames of one signal, (n_frame, n_microphone, 250)."""
        place, wide = self._starts(self._of_places(frames).sum(0))
        likelihood = self._likelihood_at(self._level(frames))
        return found_place(likelihood, likelihood.white(frames), place, wide)

    def _likelihood_at(self, level: float | None) -> PlaceLikelihood:
        """Likelihood of any place in sound of a level."""
        if level not in self._finer:
            self._finer[level] = PlaceLikelihood(
                self.response, self.contact_radius_mm, self.microphone_noise, level, self.position_options
            )
        return self._finer[level]

    def _level(self, frames: Array) -> float | None:
        """The likeliest level of the sound around frames of one signal."""
        if len(self.ambient) == 1:
            return self.ambient[0]
        return self.ambient[self.likelihood.likeliest_level(frames)]

    def _starts(self, score: Array) -> tuple[Array, Array]:
        """The best places of the grid by their log-likelihoods (n_place,), none near another.

        Returns:
            Places with a footprint of their own, and the middles of those that share one; (n, 2) mm. The covariances
            of the latter, (n, 2, 2) mm^2, not a number for the former.
        """
        prints = self.footprints
        count = np.bincount(prints.footprint)
        alone = count[prints.footprint] == 1
        places, covariances = [prints.place[alone]], [np.full((int(alone.sum()), 2, 2), np.nan)]
        scores = [score[alone]]
        for number in np.flatnonzero(count > 1):
            alike = prints.footprint == number
            places.append(prints.place[alike].mean(0)[None])
            covariances.append((np.cov(prints.place[alike].T, bias=True) + prints.step**2 / 12 * np.eye(2))[None])
            scores.append(score[alike][:1])
        place, wide = np.concatenate(places), np.concatenate(covariances)
        left = np.concatenate(scores)
        chosen: list[int] = []
        apart = self.position_options.starts_apart * pitch_of(self.response)
        while len(chosen) < self.position_options.starts and np.isfinite(left.max()):
            chosen.append(int(left.argmax()))
            left[np.linalg.norm(place - place[chosen[-1]], axis=1) <= apart] = -np.inf
        return place[chosen], wide[chosen]
