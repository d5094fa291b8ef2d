"""Likelihood of frames by tables: Gaussians of covariance g C + 1 in coordinates where noise and sound are white.

The tables hold the eigenvectors of each C, in which the log-likelihood is a sum over a few dozen terms, maximised over
the power g.

Most tables need no score: what a touch leaves empty only lowers a likelihood, so that the energy of a frame in a few of
the directions that a table leaves empty bounds its score from above (:class:`Bounds`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from localize.decoders.frame_covariance import SAMPLES, low_pass
from localize.signals.noise_model import NoiseSpectrum

POWERS = 10 ** (np.arange(-80.0, 40.1, 4.0) / 10)
"""Values of g that are tried; a parabola through the best one and its neighbours gives the maximum."""
WEAKEST = 1e-2
"""Eigenvectors that hold less than this share of the assumed noise at g = 1 are left out: 1e-4 names the same points,
40 dB louder ones as well."""
NOISE_SHARE = 0.25
"""Share of the noise that is told, in amplitude, that likelihoods assume; tried on 216 points were 1, 1/2, 0.3, 1/5 and
1/10. See docs/decoder.md."""
TEMPERATURE = NOISE_SHARE**-2
"""Divisor of log-likelihoods: it counts misfits by the noise that is told again, so that probabilities are calibrated,
see docs/decoder.md."""
QUIET_BONUS = 30.0
"""Advantage of quiet over sound, nats, after the temperature: the likelihood assumes less noise than there is, and
would take the rest for sound. In quiet, sound was preferred by at most 35 nats on line-2 (1 of 100 by 27 or more), at
60 dB SPL by at least 90."""
SURE = 20.0
"""Lead of the best point, nats: those this far behind it, and what single precision may err, are not scored again in
double."""
SCREEN_ERROR = 8 * float(np.finfo(np.float32).eps) / (2 * TEMPERATURE)
"""Error that a score in single precision may have, nats, per unit of the sum of squares of a frame's white samples."""
BOUND_ERROR = 8 * float(np.finfo(np.float32).eps)
"""Error that the length of a frame's part may have in single precision, per unit of the length of the whole."""
CHUNK = 64
"""Number of frames that are decoded at once."""
FAR = 30.0
"""Lead of the best point, nats, from which on another needs no score of its own: its probability is below 1e-13."""
QUIET_ERROR = 1e-3
"""Error of a score in single precision, nats at most, up to which it stands for that in double where many are wanted:
it is a tenth of that in most frames."""
DIRECTIONS = 16
"""Number of directions that bound the score of a table. Of 36 points in line 3 to 4 of a loud frame are left."""
LOUD_DIRECTIONS = 64
"""Number of directions in which touches are loudest, among which those that a table leaves empty are looked for."""
FEW_NUMBERS = 4e5
"""Numbers of the vectors of all tables up to which all of them are scored in double at once: of 36 points in line and
less, choosing takes longer than it saves."""
TOO_MANY = 1 / 5
"""Share of the tables from which on all of them are scored at once, in single precision, sooner than one by one."""


@dataclass(frozen=True, eq=False)
class DecoderTables:
    """Tables that the likelihood of a frame is computed from, for one level of the sound around."""

    reduce: NDArray[np.float64]
    """Matrix from the samples to fewer ones whose noise is white of variance 1; (n_microphone * 250, n_microphone *
    SAMPLES) float64, 1/Pa."""
    vectors: NDArray[np.float64]
    """Eigenvectors of each C_i where the noise is white; (n_table, n_microphone * SAMPLES, rank) float64, a table for
    each point, or for each hypothesis of each point."""
    weight: NDArray[np.float64]
    """Weight of the energy along each eigenvector, of one, per value of g; (n_table, rank, n_power) float64."""
    log_determinant: NDArray[np.float64]
    """Logarithm of the covariance's determinant over that of the noise, over the temperature; (n_table, n_power)
    float64, nats."""
    offset: float
    """Log-likelihood of the noise and sound alone, nats, which tells levels apart."""


def tables_of(touched: NDArray[np.float64], whiten: NDArray[np.float64], level: float | None) -> DecoderTables:
    """Tables of covariances of touches.

    Args:
        touched: (n_table, n, n) float64, Pa^2.
        whiten: what makes noise and sound white, (n, n) float64, 1/Pa.
        level: of the sound, dB SPL; None for quiet.
    """
    values, vectors = np.empty(touched.shape[:2]), np.empty_like(touched)
    for k in range(0, len(touched), CHUNK):  # of many tables a copy of all would take memory
        values[k : k + CHUNK], vectors[k : k + CHUNK] = np.linalg.eigh(whiten @ touched[k : k + CHUNK] @ whiten.T)
    # The largest eigenvalues come last. The same number for every point keeps the tables rectangular.
    rank = max(1, int((values > WEAKEST).sum(1).max()))
    gain = np.clip(values[:, -rank:, None], 0, None) * POWERS
    return DecoderTables(
        reduce=(whiten @ np.kron(np.eye(len(whiten) // SAMPLES), low_pass())).T.copy(),
        vectors=np.ascontiguousarray(vectors[:, :, -rank:]),
        weight=-gain / (1 + gain) / TEMPERATURE,
        log_determinant=np.log1p(gain).sum(1) / TEMPERATURE,
        offset=float(np.log(np.diag(whiten)).sum() / TEMPERATURE) + (QUIET_BONUS if level is None else 0.0),
    )


def share_of(noise: float | NoiseSpectrum) -> float | NoiseSpectrum:
    """Noise that likelihoods are computed with, from the one that is told."""
    if isinstance(noise, NoiseSpectrum):
        return NoiseSpectrum(noise.power * NOISE_SHARE**2, noise.source)
    return noise * NOISE_SHARE


def vertex(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Maximum over the last axis of samples of a smooth curve: that of the parabola around the largest one.

    Args:
        values: (..., n) float64, n >= 3, in any unit, equally spaced.

    Returns:
        (...,) float64, in the unit of the values.
    """
    # A flat view and whole indices: for a single frame the calls take the time, not the numbers.
    flat = values.reshape(-1, values.shape[-1])
    row = np.arange(len(flat))
    best = flat.argmax(1)
    inner = np.minimum(np.maximum(best, 1), flat.shape[1] - 2)
    left, middle, right = flat[row, inner - 1], flat[row, inner], flat[row, inner + 1]
    bend = left - 2 * middle + right
    # At an end of the range the curve may still be rising: then the sample itself is taken.
    is_top = (best == inner) & (bend < 0)
    rise = -((right - left) ** 2) / (8 * np.where(is_top, bend, -1.0))
    top = np.where(is_top, middle + rise, flat[row, best])
    return np.asarray(top.reshape(values.shape[:-1]))


@dataclass(eq=False)
class ScreenedLevel:
    """Frames and their scores at one level of the sound around."""

    x: NDArray[np.float64]
    """Frames where noise and sound are white of variance 1; (n, n_microphone * SAMPLES) float64."""
    alone: NDArray[np.float64]
    """Scores of noise and sound without a touch; (n, 1) float64, nats."""
    score: NDArray[np.float64]
    """Scores of the tables; (n, n_table) float64, nats."""
    error: NDArray[np.float64]
    """What scores may be too low by; (n,) float64, nats."""
    best: NDArray[np.float64]
    """What the best score is at least; (n,) float64, nats."""


class Screen:
    """Likelihood of all points in single precision, and of those that may be the best in double.

    Reading the tables is what takes the time, and single precision halves it. Likelihoods are differences of large
    numbers, which it cannot tell apart: every point that may come within 20 nats of the best is scored again.
    """

    def __init__(self, tables: DecoderTables, is_one_of_several: bool) -> None:
        self.tables = tables
        self.is_one_of_several = is_one_of_several
        self.points, self.size, self.rank = tables.vectors.shape
        self.is_exact = tables.vectors.size <= FEW_NUMBERS
        """Whether all scores are in double."""
        if self.is_exact:
            return
        # One matrix for all points: (n_microphone SAMPLES, n_point rank).
        self.vectors = np.ascontiguousarray(tables.vectors.astype(np.float32).transpose(1, 0, 2).reshape(self.size, -1))
        self.weight = tables.weight.astype(np.float32)
        self.log_determinant = tables.log_determinant.astype(np.float32)

    def __call__(self, flat: NDArray[np.float64]) -> ScreenedLevel:
        """Scores of (n, n_microphone 250) samples."""
        return self.screened(flat @ self.tables.reduce)

    def screened(self, x: NDArray[np.float64]) -> ScreenedLevel:
        """Scores of white frames, (n, size)."""
        power, alone = self.alone(x)
        if self.is_exact:
            score = self.all_exact(x) + alone
            return ScreenedLevel(x, alone, score, np.zeros(len(x)), score.max(1))
        energy = ((x.astype(np.float32) @ self.vectors) ** 2).reshape(len(x), self.points, self.rank)
        # (point, frame, ...): one matrix product per point.
        gain = energy.transpose(1, 0, 2) @ self.weight
        values = -0.5 * (gain + self.log_determinant[:, None, :])
        # Of large numbers single precision knows no parabola; a true one rises by less than a nat above its samples.
        score = np.minimum(vertex(values), values.max(-1) + 1).T + alone
        error = SCREEN_ERROR * power
        return ScreenedLevel(x, alone, score, error, score.max(1) - error)

    def alone(self, x: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Sum of squares of white frames, (n,), and log-likelihood of noise and sound without a touch, (n, 1) nats."""
        power = (x**2).sum(1)
        # Large, and the same for all points: left out where there is no other level to compare with.
        return power, np.where(self.is_one_of_several, self.tables.offset - power / (2 * TEMPERATURE), 0.0)[:, None]

    def score_again(self, level: ScreenedLevel, least: NDArray[np.float64]) -> None:
        """Put scores of double precision in the place of those that may reach ``least``, (n,) nats."""
        if self.is_exact:
            return
        again = level.score > (least - level.error)[:, None]
        level.score[again] = self.exact(level.x, again)[again] + np.broadcast_to(level.alone, again.shape)[again]

    def all_exact(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """Scores of white frames (n, size) in double precision by all tables, without those of noise alone; (n,
        n_table) nats.
        """
        gain = (x @ self.tables.vectors) ** 2 @ self.tables.weight
        return vertex(-0.5 * (gain + self.tables.log_determinant[:, None, :])).T

    def some(self, x: NDArray[np.float64], chosen: NDArray[np.bool_]) -> NDArray[np.float64]:
        """Scores as of :meth:`exact`, (n, n_table) nats; of quiet frames with many in single precision."""
        many = (chosen.mean(1) > TOO_MANY) & (SCREEN_ERROR * (x**2).sum(1) < QUIET_ERROR)
        score = self.exact(x, chosen & ~many[:, None])
        if many.any():
            level = self.screened(x[many])
            score[many] = level.score - level.alone
        return score

    def exact(self, x: NDArray[np.float64], chosen: NDArray[np.bool_]) -> NDArray[np.float64]:
        """Scores of white frames (n, size) in double precision by the tables that are chosen for each, (n, n_table)
        bool, without those of noise alone; (n, n_table) nats, zero elsewhere.
        """
        score, tables = np.zeros(chosen.shape), self.tables
        numbers = np.flatnonzero(chosen.any(0))
        if len(x) == 1:  # in one go: the calls take the time, not the numbers
            energy = np.empty((len(numbers), 1, self.rank))
            for row, table in zip(energy, numbers, strict=True):
                np.matmul(x, tables.vectors[table], out=row)
            gain = (energy * energy @ tables.weight[numbers])[:, 0]
            score[0, numbers] = vertex(-0.5 * (gain + tables.log_determinant[numbers]))
            return score
        for table in numbers:
            frames = chosen[:, table]
            gain = (x[frames] @ tables.vectors[table]) ** 2 @ tables.weight[table]
            score[frames, table] = vertex(-0.5 * (gain + tables.log_determinant[table]))
        return score


class Bounds:
    """Bounds of the scores of tables, from the energy in a few of the directions that each leaves empty.

    Args:
        tables: whose scores are bounded.
    """

    def __init__(self, tables: DecoderTables) -> None:
        count, size, rank = tables.vectors.shape
        self.directions = min(DIRECTIONS, size - rank)
        loud = _loud_directions(tables)
        beside = np.zeros((size, count, self.directions), np.float32)
        for table, vectors in enumerate(tables.vectors if self.directions else ()):
            left = loud - vectors @ (vectors.T @ loud)
            power, turn = np.linalg.eigh(left.T @ left)
            # The largest come last; of what is nearly nothing rounding would leave no direction beside the vectors.
            kept = np.arange(len(power)) >= len(power) - self.directions
            kept &= power > 1e-8 * power[-1]
            found = left @ (turn[:, kept] / np.sqrt(power[kept]))
            beside[:, table, : found.shape[1]] = found
        self._beside = beside.reshape(size, -1)
        self._usual = -0.5 * tables.log_determinant.min(1)

    def __call__(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """What the scores of white frames (n, size) are at most, without those of noise alone; (n, n_table) nats."""
        power = (x**2).sum(1, keepdims=True)
        if not self.directions:
            return self._usual + 0.5 * power / TEMPERATURE + 1.0
        energy = ((x.astype(np.float32) @ self._beside) ** 2).reshape(len(x), -1, self.directions).sum(2)
        rounding = BOUND_ERROR * np.sqrt(power)
        missing = np.maximum(np.sqrt(energy.astype(np.float64)) - rounding, 0.0) ** 2
        # The parabola of a score rises by less than a nat above what is true.
        return np.asarray(self._usual + 0.5 * (power - missing) / TEMPERATURE + 1.0)


def _loud_directions(tables: DecoderTables) -> NDArray[np.float64]:
    """Directions in which touches of all tables are loudest, each as long as they are there; (size, n_direction)."""
    count, size, _ = tables.vectors.shape
    unit = int(np.abs(POWERS - 1.0).argmin())
    together = np.zeros((size, size))
    for table in range(0, count, max(1, count // LOUD_DIRECTIONS)):
        heard = -TEMPERATURE * tables.weight[table, :, unit]
        power = heard / np.maximum(1 - heard, np.finfo(np.float64).eps)
        together += (tables.vectors[table] * (power / power.sum())) @ tables.vectors[table].T
    values, vectors = np.linalg.eigh(together)
    return np.asarray(vectors[:, -LOUD_DIRECTIONS:] * np.sqrt(np.maximum(values[-LOUD_DIRECTIONS:], 0.0)))
