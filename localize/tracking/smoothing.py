"""Path of a contact from its footprints, hop by hop: a hidden Markov model over the surface decides which footprint is
pressed, and a Kalman smoother gives the places between them.

From hop to hop a contact goes to any footprint, the nearer the likelier, on its line or not. Places are then those of
the detected footprints, with a larger deviation if a footprint is faint. A contact keeps its velocity but for
accelerations that are white noise (Rauch, Tung and Striebel 1965): between membranes, where no contact is detected, it
continues from one to the next.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.ground.typed import Array
from localize.live.events import HOP
from localize.signals.stimulus import SAMPLE_RATE
from localize.tracking.footprints import Footprints
from localize.tracking.tracking_options import TrackingOptions

HOP_TIME = HOP / SAMPLE_RATE
"""Time from hop to hop, s."""


@dataclass(frozen=True, eq=False)
class Cells:
    """Footprints as cells of the surface."""

    middle: Array
    """Mean place of each footprint; (n_footprint, 2) float64, mm."""
    extent: Array
    """Standard deviation of its places in each direction; (n_footprint,) float64, mm."""
    transition: Array
    """Probability of a step from the footprint of the row to that of the column; (n_footprint, n_footprint)."""

    @classmethod
    def of(cls, footprints: Footprints, pitch: float, options: TrackingOptions = TrackingOptions()) -> Cells:
        """Cells of footprints on an array of a pitch, mm."""
        count = np.bincount(footprints.footprint)
        middle, square = np.zeros((len(count), 2)), np.zeros(len(count))
        np.add.at(middle, footprints.footprint, footprints.place)
        middle /= count[:, None]
        away = ((footprints.place - middle[footprints.footprint]) ** 2).sum(1)
        np.add.at(square, footprints.footprint, away)
        extent = np.sqrt(square / count / 2 + footprints.step**2 / 12)
        apart = np.linalg.norm(middle[:, None] - middle, axis=-1)
        step = np.exp(-0.5 * (apart / (options.fastest * HOP_TIME + options.near * pitch)) ** 2) + options.jump_weight
        return cls(middle, extent, step / step.sum(1, keepdims=True))

    def forward(self, belief: Array, log_likelihood: Array) -> Array:
        """Probabilities of footprints after one more hop, (n_footprint,)."""
        likely = (belief @ self.transition) * np.exp(log_likelihood - log_likelihood.max())
        return np.asarray(likely / likely.sum())

    def forward_backward(self, log_likelihood: Array) -> Array:
        """Probabilities of footprints in every hop by all of them, (n_hop, n_footprint)."""
        belief = np.empty_like(log_likelihood)
        before = np.full(len(self.middle), 1 / len(self.middle))
        for k, row in enumerate(log_likelihood):
            before = belief[k] = self.forward(before, row)
        after = np.ones(len(self.middle))
        for k in range(len(belief) - 2, -1, -1):
            row = log_likelihood[k + 1]
            after = self.transition @ (np.exp(row - row.max()) * after)
            after /= after.sum()
            belief[k] *= after
            belief[k] /= belief[k].sum()
        return belief


def smoothed(
    place: Array, deviation: Array, options: TrackingOptions = TrackingOptions()
) -> tuple[Array, Array, Array]:
    """A smooth path through places, its uncertainty and its speed.

    Args:
        place: of every hop, (n, 2) float64, mm.
        deviation: their standard deviations in each direction, (n,) float64, mm; infinite where nothing is known.
        options: of the tracker.

    Returns:
        Places (n, 2) mm, their standard deviations in each direction (n,) mm, and speeds (n,) mm/s.
    """
    speed = options.speeds[0]
    for _ in range(2):
        state, covariance = _rauch(place, deviation, options.agility * speed, options.speeds[1])
        moved = np.linalg.norm(np.diff(state[:, 0], axis=0), axis=1).sum()
        speed = float(np.clip(moved / max(len(place) * HOP_TIME, HOP_TIME), *options.speeds))
    return state[:, 0], np.sqrt(covariance[:, 0, 0]), np.linalg.norm(state[:, 1], axis=1)


def _rauch(place: Array, deviation: Array, acceleration: float, fastest: float) -> tuple[Array, Array]:
    """States (n, 2, 2), place and velocity in both directions, and their covariance (n, 2, 2), alike in both."""
    step = np.array([[1.0, HOP_TIME], [0.0, 1.0]])
    # White acceleration that within a second changes the velocity by as much.
    noise = acceleration**2 * np.array([[HOP_TIME**3 / 3, HOP_TIME**2 / 2], [HOP_TIME**2 / 2, HOP_TIME]])
    known = np.isfinite(deviation)
    state = np.stack([place[known][0], np.zeros(2)])
    covariance = np.diag([float(np.ptp(place[known], axis=0).max()) ** 2 + 100.0, fastest**2])
    states, covariances = np.empty((len(place), 2, 2)), np.empty((len(place), 2, 2))
    predicted, spread = np.empty((len(place), 2, 2)), np.empty((len(place), 2, 2))
    for k in range(len(place)):
        if k:
            state, covariance = step @ state, step @ covariance @ step.T + noise
        predicted[k], spread[k] = state, covariance
        if known[k]:
            gain = covariance[:, 0] / (covariance[0, 0] + deviation[k] ** 2)
            state = state + gain[:, None] * (place[k] - state[0])
            covariance = covariance - np.outer(gain, covariance[0])
        states[k], covariances[k] = state, covariance
    for k in range(len(place) - 2, -1, -1):
        back = covariances[k] @ step.T @ np.linalg.inv(spread[k + 1])
        states[k] += back @ (states[k + 1] - predicted[k + 1])
        covariances[k] += back @ (covariances[k + 1] - spread[k + 1]) @ back.T
    return states, covariances
