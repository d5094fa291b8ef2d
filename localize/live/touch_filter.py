"""Successive frames of one moving touch: a hidden Markov model on the array's graph.

The touch is at one point per frame and moves from frame to frame: it stays with one probability, goes on to the
neighbours on its line with another, and otherwise lifts off and lands anywhere. With the frames' likelihoods as
observations the forward recursion gives what is known so far, the forward-backward recursion what is known once the
recording has ended (Rabiner 1989, equations 19 to 27), both exactly. Frames are taken as independent given the point:
they must not overlap, or the likelihoods count the same samples twice.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Kind, Refusal


class TouchFilter:
    """Filter that tracks a touch: exact filtering and smoothing of point likelihoods over time.

    Args:
        line: (n_point,) int64, line of each point.
        place: (n_point,) int64, place of each point along its line.
        stay: probability of staying at a point from one frame to the next, above 0.
        jump: probability of landing anywhere on the array, all points alike, above 0; the rest, 1 - stay - jump, goes
            to the neighbours on the line, or stays at a point without neighbours.

    Raises:
        Refusal: probabilities out of range, or line and place of different lengths.
    """

    def __init__(
        self, line: Sequence[int] | NDArray[np.int64], place: Sequence[int] | NDArray[np.int64],
        stay: float = 0.7, jump: float = 0.01,
    ) -> None:  # fmt: skip
        if not (stay > 0 and jump > 0 and stay + jump <= 1):
            allowed = f"above 0, and with jump = {jump} at most 1"
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="stay", value=stay, allowed=allowed)
        lines, places = np.asarray(line), np.asarray(place)
        if lines.ndim != 1 or lines.shape != places.shape or not len(lines):
            problem = f"has shape {places.shape}, must be that of line, (n_point,) = {lines.shape}"
            raise Refusal(problem, kind=Kind.WRONG_TYPE, field="place")
        neighbour = (lines[:, None] == lines) & (np.abs(places[:, None] - places) == 1)
        count = neighbour.sum(1)
        step = np.divide(neighbour, count[:, None], out=np.zeros(neighbour.shape), where=count[:, None] > 0)
        staying = stay + (1 - stay - jump) * (count == 0)
        self.transition = np.diag(staying) + (1 - stay - jump) * step + jump / len(lines)
        """(n_point, n_point): probability of going from the point of the row to that of the column."""
        self._belief = np.full(len(lines), 1 / len(lines))
        self._started = False

    def reset(self) -> None:
        """Forget the frames seen by :meth:`update`."""
        self._belief = np.full(len(self.transition), 1 / len(self.transition))
        self._started = False

    def update(self, log_likelihood: ArrayLike) -> NDArray[np.float64]:
        """Probability of each point after the next frame of a stream, which is taken in.

        Args:
            log_likelihood: (n_point,), nats, up to a constant.

        Returns:
            (n_point,) float64: probability of each point given this frame and those before it.

        Raises:
            Refusal: a wrong shape, or a value that is not finite.
        """
        frame = self._checked(log_likelihood, 1)
        prior = self._belief @ self.transition if self._started else self._belief
        self._belief = _normalised(prior * np.exp(frame - frame.max()))
        self._started = True
        return self._belief.copy()

    def forward(self, log_likelihood: ArrayLike) -> NDArray[np.float64]:
        """Probability of each point given the frames up to each one.

        Args:
            log_likelihood: (n_frame, n_point), nats, up to a constant per frame.

        Returns:
            (n_frame, n_point) float64.

        Raises:
            Refusal: as :meth:`update`.
        """
        frames = self._checked(log_likelihood, 2)
        likelihood = np.exp(frames - frames.max(1, keepdims=True))
        result = np.empty_like(likelihood)
        prior = np.full(likelihood.shape[1], 1 / likelihood.shape[1])
        for k, here in enumerate(likelihood):
            result[k] = _normalised(prior * here)
            prior = result[k] @ self.transition
        return result

    def forward_backward(self, log_likelihood: ArrayLike) -> NDArray[np.float64]:
        """Probability of each point at each frame given all frames.

        Args:
            log_likelihood: (n_frame, n_point), nats, up to a constant per frame.

        Returns:
            (n_frame, n_point) float64.

        Raises:
            Refusal: as :meth:`update`.
        """
        frames = self._checked(log_likelihood, 2)
        likelihood = np.exp(frames - frames.max(1, keepdims=True))
        result = self.forward(frames)
        after = np.ones(likelihood.shape[1])
        for k in range(len(frames) - 2, -1, -1):
            after = _normalised(self.transition @ (likelihood[k + 1] * after))
            result[k] = _normalised(result[k] * after)
        return result

    def _checked(self, log_likelihood: ArrayLike, dimensions: int) -> NDArray[np.float64]:
        values = np.asarray(log_likelihood, np.float64)
        points = len(self.transition)
        if values.ndim != dimensions or values.shape[-1] != points or not values.size:
            expected = f"({points},)" if dimensions == 1 else f"(n_frame, {points})"
            problem = f"has shape {values.shape}, must be {expected}"
            raise Refusal(problem, kind=Kind.WRONG_TYPE, field="log_likelihood")
        if not np.isfinite(values).all():
            raise Refusal("holds values that are not finite", kind=Kind.UNSUITABLE, field="log_likelihood")
        return values


def _normalised(weights: NDArray[np.float64]) -> NDArray[np.float64]:
    # Every jump is possible and the largest likelihood is 1: the sum is never 0.
    return np.asarray(weights / weights.sum())
