"""Decoder of one array by its library: what all of them share, whatever covariances they take touches to have."""

from __future__ import annotations

import copy
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.library.transfer_functions import MEASURED
from geometry.ground.typed import Array
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import joint_whitening
from localize.decoders.level_likelihood import BoundedSearch, LevelLikelihood, Whitening
from localize.decoders.likelihood import DecoderTables
from localize.decoders.surroundings import Surroundings
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class LibraryDecoder(Locator):
    """Decoder that needs no training: points are ranked by the likelihood of the samples.

    Args:
        response: the array that is decoded.
        around: noise and sound that are assumed.
        touched: covariances that touches of 0 dB are taken to have, (n_table, n, n) float64, Pa^2; in the order of the
            points where each has one.
        options: numbers that tune it.
        whiten: makes noise and sound white.
    """

    response: ArrayResponse
    options: DecoderOptions

    def __init__(
        self,
        response: ArrayResponse,
        around: Surroundings,
        touched: Array,
        options: DecoderOptions,
        whiten: Whitening = joint_whitening,
    ) -> None:
        self.array = replace(response.array, noise_rms=around.noise_rms)
        self.response, self.around, self.options = response, around, options
        self.likelihood = LevelLikelihood(touched, response, around, options, whiten)

    @property
    def ambient(self) -> tuple[float | None, ...]:
        """Levels of the sound around that are assumed, from quiet (None) to loud, dB SPL."""
        return self.around.ambient

    @property
    def microphone_noise(self) -> NoiseChoice:
        """Noise that is assumed, as it was given."""
        return self.around.microphone_noise

    @property
    def tables(self) -> tuple[DecoderTables, ...]:
        """Tables of the likelihood at each level of the sound around."""
        return self.likelihood.tables

    @property
    def kind(self) -> str:
        """Kind of localizer, as graphs state theirs."""
        return "model-based decoder"

    @property
    def needs_all_microphones(self) -> bool:
        """True if nothing can be located without one of the microphones: two are enough."""
        return False

    @property
    def needs_whole_frames(self) -> bool:
        """True if no part of a frame can be left out: what is known is enough."""
        return False

    @property
    def assumptions(self) -> str:
        """Assumptions about the sensor, in words."""
        return self.array.assumptions

    @property
    def largest_misfit(self) -> float | None:
        """Largest median misfit of a calibrated sensor; None for a library that was computed."""
        if self.provenance.get("fidelity") != MEASURED:
            return None
        known = self.provenance.get("library", {})
        measured = known.get("calibration", {}).get("measured_points")
        fitted = known.get("fit") or "self_calibration" in known or "brought_from_air" in known
        partly = measured is not None and len(measured) < self.point_count
        return self.options.fitted_misfit if fitted or partly else self.options.calibrated_misfit

    @one_thread()
    def without(self, unknown: Array) -> Self | None:
        """The decoder of frames in which signals of unknown amplitudes lie; as of :class:`localize.Locator`."""
        likelihood = self.likelihood.partly_known(unknown)
        return None if likelihood is None else self._decided_by(likelihood)

    def _decided_by(self, likelihood: LevelLikelihood) -> Self:
        """The decoder with another likelihood, of the same hypotheses in the same order."""
        found = copy.copy(self)
        found.likelihood = likelihood
        return found

    def misfit(self, frames: Array) -> Array:
        """Residual that the best point leaves of each frame, over that of the assumed noise.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n,) float64.
        """
        return self.likelihood.misfit(frames)

    @one_thread()
    def log_probability(self, signals: ArrayLike | Tensor) -> Array:
        """Logarithm of what :meth:`locate` gives, which does not end at the smallest number there is.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n, n_point) float64, nats.

        Raises:
            Refusal: as :meth:`locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        return _normalised(self.joint_log_likelihood(batch))

    def joint_log_likelihood(self, batch: Array) -> Array:
        """Log-likelihood of every point, all frames of each signal together.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch)
        score = in_parts(self.log_likelihood, frames, self.options.frames_at_once)
        return np.asarray(score.reshape(*frames.shape[:2], -1).sum(1))

    def log_likelihood(self, frames: Array) -> Array:
        """Log-likelihood of every point, maximised over the power of the touch and divided by the temperature.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        return self.likelihood.scores(frames)

    def _probability(self, batch: Array) -> Array:
        return np.exp(_normalised(self.joint_log_likelihood(batch)))


class PointDecoder(LibraryDecoder):
    """Decoder whose points have one covariance each."""

    @cached_property
    def _search(self) -> BoundedSearch:
        return BoundedSearch(self.likelihood)

    def _decided_by(self, likelihood: LevelLikelihood) -> Self:
        found = super()._decided_by(likelihood)
        found.__dict__.pop("_search", None)  # which is of the other likelihood
        return found

    @property
    def no_graph(self) -> str:
        """Empty: an ONNX graph can hold this localizer."""
        return ""

    def _probability(self, batch: Array) -> Array:
        if self._search.saves:
            return np.exp(_normalised(self._search(batch)))
        return super()._probability(batch)


def in_parts(score: Any, frames: Array, at_once: int) -> Array:
    """Results of a function of frames, which takes so many at once.

    Args:
        score: takes (k, n_microphone, 250) and gives (k, ...) float64.
        frames: (n, n_frame, n_microphone, 250) float64.
        at_once: how many.

    Returns:
        (n * n_frame, ...) float64.
    """
    flat = frames.reshape(-1, *frames.shape[2:])
    return np.concatenate([score(flat[k : k + at_once]) for k in range(0, len(flat), at_once)])


def _normalised(total: Array) -> Array:
    """Logarithms of probabilities from log-likelihoods, both (n, n_point) nats."""
    total = total - total.max(1, keepdims=True)
    return np.asarray(total - np.log(np.exp(total).sum(1, keepdims=True)))
