"""Distances between the points of many designs at once; definitions as in :mod:`studies.metrics.pairs`."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations, product
from typing import TYPE_CHECKING

import numpy as np

from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import Responses
from studies.metrics.pairs import DECIBEL, trapezoidal_weights

if TYPE_CHECKING:
    import xarray as xr

#: Differences of points, of one and all after it, worked on at once.
_CHUNK = 20_000


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
    """Distances of all pairs of points of each design.

    Args:
        responses: of at least two points and two microphones.
        band: lowest and highest frequency, Hz; at least two frequencies of the grid must lie in it.

    Raises:
        Refusal: fewer than two points, microphones, or frequencies in the band.
    """
    inside = (responses.frequency >= band[0] - 1e-9) & (responses.frequency <= band[1] + 1e-9)
    _, points, microphones, _ = responses.transfer_function.shape
    for name, count in (
        ("point", points),
        ("microphone", microphones),
        ("frequency", int(inside.sum())),
    ):
        if count < 2:
            within = f" from {band[0]:g} to {band[1]:g} Hz" if name == "frequency" else ""
            problem = f"has {counted(count, name)}{within}; at least 2 are needed to compare points"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="transfer_function")
    pairs = list(combinations(range(microphones), 2))
    weight = trapezoidal_weights(responses.frequency[inside]) / len(pairs)
    h = responses.transfer_function[..., inside]
    log, angle = np.log(np.abs(h)), np.arctan2(h.imag, h.real) / (2 * np.pi)
    level, phase = np.zeros((2, len(h), points * (points - 1) // 2))
    # A few designs at a time, one point against all after it: their differences stay in the processor's cache.
    step = max(1, _CHUNK // (points * len(weight)))
    room = np.empty((2, min(step, len(h)), points, len(weight)))
    for few, (a, b) in product((slice(first, first + step) for first in range(0, len(h), step)), pairs):
        louder, turned = log[few, :, a] - log[few, :, b], angle[few, :, a] - angle[few, :, b]
        start = 0
        for point in range(points - 1):
            own = few, slice(start, start + points - 1 - point)
            difference, whole = (each[: len(louder), point + 1 :] for each in room)
            np.subtract(louder[:, point + 1 :], louder[:, point, None], out=difference)
            level[own] += np.square(difference, out=difference) @ weight
            np.subtract(turned[:, point + 1 :], turned[:, point, None], out=difference)
            difference -= np.rint(difference, out=whole)  # turns, the short way round
            phase[own] += np.square(difference, out=difference) @ weight
            start = own[1].stop
    return PairDistances(DECIBEL * np.sqrt(level), 360 * np.sqrt(phase))


@dataclass(frozen=True, eq=False)
class Separability:
    """Distances of all pairs of points; each matrix is symmetric with zeros on its diagonal."""

    points: tuple[int, ...]
    """Numbers of the points, in the order of rows and columns."""
    level: Array
    """Level distance: rms over band and microphone pairs of 20 log10 |r_i / r_j|; (n_point, n_point) float64, dB."""
    phase: Array
    """Phase distance: rms over band and microphone pairs of arg(r_i / r_j), wrapped to (-180, 180]; (n_point, n_point)
    float64, degrees."""

    @property
    def combined(self) -> Array:
        """Combined distance: rms of |log(r_i / r_j)|, level in nepers and phase in radians; (n_point, n_point) float64.

        The square root of (level / 8.686 dB)^2 + (phase / 57.3 degrees)^2: 0.1 is as much as 0.87 dB or 5.7 degrees
        over the whole band.
        """
        return np.hypot(self.level / DECIBEL, np.radians(self.phase))

    @property
    def hardest_pairs(self) -> tuple[tuple[int, int], ...]:
        """Numbers of all pairs of points, the smallest combined distance first, each as (lower, higher)."""
        distance = self.combined
        # Mirror images are equally hard up to rounding: the lower numbers come first, every time.
        pairs = sorted(
            combinations(range(len(self.points)), 2), key=lambda pair: (float(f"{distance[pair]:.6g}"), pair)
        )
        return tuple((self.points[i], self.points[j]) for i, j in pairs)

    @property
    def equally_hard(self) -> tuple[tuple[int, int], ...]:
        """Numbers of the hardest pair and of those within 1 % of its combined distance, such as its mirror image."""
        least = self.between(*self.hardest_pairs[0])[2]
        return tuple(sorted(pair for pair in self.hardest_pairs if self.between(*pair)[2] <= 1.01 * least))

    def nearest(self, point: int) -> int:
        """Number of the point that is hardest to tell from ``point``."""
        index = self.points.index(point)
        row = self.combined[index].copy()
        row[index] = np.inf
        return self.points[int(np.argmin(row))]

    def between(self, first: int, second: int) -> tuple[float, float, float]:
        """Level (dB), phase (degrees) and combined distance of two points, by number."""
        i, j = self.points.index(first), self.points.index(second)
        return float(self.level[i, j]), float(self.phase[i, j]), float(self.combined[i, j])


def separability(transfer_function: xr.DataArray, band: tuple[float, float] = BAND) -> Separability:
    """Distances of all pairs of points.

    Means over frequency are integrals by the trapezoidal rule over a linear axis, so that they hardly depend on
    the grid.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        band: lowest and highest frequency, Hz; the grid must have at least two frequencies in it.

    Raises:
        Refusal: fewer than two points, microphones, or frequencies in the band.
    """
    responses = Responses(
        np.asarray(transfer_function["frequency"].values, np.float64),
        np.asarray(transfer_function.transpose("point", "microphone", "frequency").values, np.complex128)[None],
    )
    found = pair_distances(responses, band)
    points = tuple(int(number) for number in transfer_function["point"].values)
    above = np.triu_indices(len(points), 1)
    level, phase = np.zeros((2, len(points), len(points)))
    for matrix, of_pairs in ((level, found.level), (phase, found.phase)):
        matrix[above] = of_pairs[0]
        matrix += matrix.T
    return Separability(points, level, phase)
