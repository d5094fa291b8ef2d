"""Distances between the points of many designs at once; definitions as in :mod:`studies.metrics`."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from geometry.refusal import Refusal
from studies.metrics.pairs import BAND, DECIBEL, trapezoidal_weights
from studies.metrics.responses import Responses

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PairDistances:
    """Distances of all pairs of points i < j, in the order of ``itertools.combinations``."""

    level: Array
    """Level distance: rms over band and microphone pairs of 20 log10 |r_i / r_j|; (n_design, n_pair) float64, dB."""
    phase: Array
    """Phase distance: rms over band and microphone pairs of arg(r_i / r_j), wrapped to +-180; (n_design, n_pair)
    float64, degrees."""

    @property
    def combined(self) -> Array:
        """Combined distance: rms of |log(r_i / r_j)|, nepers and radians; (n_design, n_pair) float64."""
        return np.hypot(self.level / DECIBEL, np.radians(self.phase))


def pair_distances(responses: Responses, band: tuple[float, float] = BAND) -> PairDistances:
    """Distances of all pairs of points of each design, equal to :func:`studies.metrics.pairs.separability`.

    Args:
        responses: of at least two points and two microphones.
        band: lowest and highest frequency, Hz; at least two frequencies of the grid must lie in it.

    Raises:
        Refusal: fewer than two points, microphones, or frequencies in the band.
    """
    inside = (responses.frequency >= band[0] - 1e-9) & (responses.frequency <= band[1] + 1e-9)
    _, points, microphones, _ = responses.transfer_function.shape
    for name, count in (
        ("points", points),
        ("microphones", microphones),
        (f"frequencies between {band[0]:g} and {band[1]:g} Hz", int(inside.sum())),
    ):
        if count < 2:
            raise Refusal(f"distances of points: {count} {name} must be at least 2")
    pairs = list(combinations(range(microphones), 2))
    weight = trapezoidal_weights(responses.frequency[inside]) / len(pairs)
    log = np.log(responses.transfer_function[..., inside])
    first = np.triu_indices(points, 1)[0]
    level, phase = np.zeros((2, len(log), len(first)))
    for a, b in pairs:
        ratio = log[:, :, a] - log[:, :, b]
        # one point against all after it: the differences of one design stay in the processor's cache
        for point in range(points - 1):
            own = first == point
            difference = ratio[:, point + 1 :] - ratio[:, point, None]
            turn = difference.imag
            turn = turn - 2 * np.pi * np.round(turn / (2 * np.pi))
            level[:, own] += difference.real**2 @ weight
            phase[:, own] += turn**2 @ weight
    return PairDistances(DECIBEL * np.sqrt(level), np.degrees(np.sqrt(phase)))
