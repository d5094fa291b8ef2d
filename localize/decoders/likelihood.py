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

from geometry.ground.typed import Array
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import SAMPLES, low_pass
from localize.signals.noise_model import NoiseSpectrum

BOUND_ERROR = 8 * float(np.finfo(np.float32).eps)
"""Error that the length of a frame's part may have in single precision, per unit of the length of the whole."""


@dataclass(frozen=True, eq=False)
class GaussianTables:
    """Log-likelihood of white frames under covariances g C + 1, maximised over the power g."""

    vectors: Array
    """Eigenvectors of each C; (n_table, n, rank) float64, a table for each covariance."""
    weight: Array
    """Weight of the energy along each eigenvector, of one, per value of g; (n_table, rank, n_power) float64."""
    log_determinant: Array
    """Logarithm of the covariance's determinant over that of the noise, over the temperature; (n_table, n_power)
    float64, nats."""

    @classmethod
    def of(cls, covariances: Array, options: DecoderOptions, whiten: Array | None = None) -> GaussianTables:
        """Tables of covariances of touches.

        Args:
            covariances: of touches of 0 dB, (n_table, n, n) float64.
            options: of the decoder.
            whiten: matrix that makes the noise white, (n, n) float64; None where the covariances are so already.
        """
        values, vectors = np.empty(covariances.shape[:2]), np.empty_like(covariances)
        step = options.frames_at_once
        for k in range(0, len(covariances), step):  # of many tables a copy of all would take memory
            part = covariances[k : k + step]
            part = part if whiten is None else whiten @ part @ whiten.T
            values[k : k + step], vectors[k : k + step] = np.linalg.eigh(part)
        # The largest eigenvalues come last. The same number for every table keeps the arrays rectangular.
        rank = max(1, int((values > options.weakest_direction).sum(1).max()))
        gain = np.clip(values[:, -rank:, None], 0, None) * options.tried_powers
        return cls(
            np.ascontiguousarray(vectors[:, :, -rank:]),
            -gain / (1 + gain) / options.temperature,
            np.log1p(gain).sum(1) / options.temperature,
        )

    def scores(self, x: Array, part: slice = slice(None)) -> Array:
        """Log-likelihoods of white frames, without that of noise alone.

        Args:
            x: (n, size) float64.
            part: tables that are asked for; by default all.

        Returns:
            (n, n_table) float64, nats.
        """
        gain = (x @ self.vectors[part]) ** 2 @ self.weight[part]
        return vertex(-0.5 * (gain + self.log_determinant[part, None, :])).T


@dataclass(frozen=True, eq=False)
class DecoderTables(GaussianTables):
    """Tables of a decoder for one level of the sound around: a table for each point, or each hypothesis of a point."""

    reduce: Array
    """Matrix from the samples to fewer ones whose noise is white of variance 1; (n_microphone * 250, n_microphone *
    SAMPLES) float64, 1/Pa."""
    offset: float
    """Log-likelihood of the noise and sound alone, nats, which tells levels apart."""
    options: DecoderOptions
    """Options that the tables were made with."""


def tables_of(touched: Array, whiten: Array, level: float | None, options: DecoderOptions) -> DecoderTables:
    """Tables of covariances of touches.

    Args:
        touched: (n_table, n, n) float64, Pa^2.
        whiten: matrix that makes noise and sound white, (n, n) float64, 1/Pa.
        level: of the sound, dB SPL; None for quiet.
        options: of the decoder.
    """
    tables = GaussianTables.of(touched, options, whiten)
    bonus = options.quiet_bonus if level is None else 0.0
    return DecoderTables(
        tables.vectors,
        tables.weight,
        tables.log_determinant,
        reduce=(whiten @ np.kron(np.eye(len(whiten) // SAMPLES), low_pass())).T.copy(),
        offset=float(np.log(np.diag(whiten)).sum() / options.temperature) + bonus,
        options=options,
    )


def assumed_noise(noise: float | NoiseSpectrum, options: DecoderOptions) -> float | NoiseSpectrum:
    """Noise that likelihoods are computed with, from the given one."""
    if isinstance(noise, NoiseSpectrum):
        return NoiseSpectrum(noise.power * options.noise_fraction**2, noise.source)
    return noise * options.noise_fraction


def vertex(values: Array) -> Array:
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

    x: Array
    """Frames where noise and sound are white of variance 1; (n, n_microphone * SAMPLES) float64."""
    alone: Array
    """Scores of noise and sound without a touch; (n, 1) float64, nats."""
    score: Array
    """Scores of the tables; (n, n_table) float64, nats."""
    error: Array
    """Largest error of the scores, by which they may be too low; (n,) float64, nats."""
    best: Array
    """Lower bound of the best score; (n,) float64, nats."""


class Screen:
    """Likelihood of all points in single precision, and of those that may be the best in double.

    Reading the tables is what takes the time, and single precision halves it. Likelihoods are differences of large
    numbers, which it cannot tell apart: every point that may come within 20 nats of the best is scored again.
    """

    def __init__(self, tables: DecoderTables, is_one_of_several: bool) -> None:
        self.tables = tables
        self.is_one_of_several = is_one_of_several
        self.points, self.size, self.rank = tables.vectors.shape
        self.options = tables.options
        self.is_exact = tables.vectors.size <= self.options.exact_numbers
        """True if all scores are in double."""
        if self.is_exact:
            return
        # One matrix for all points: (n_microphone SAMPLES, n_point rank).
        self.vectors = np.ascontiguousarray(tables.vectors.astype(np.float32).transpose(1, 0, 2).reshape(self.size, -1))
        self.weight = tables.weight.astype(np.float32)
        self.log_determinant = tables.log_determinant.astype(np.float32)

    def __call__(self, flat: Array) -> ScreenedLevel:
        """Scores of (n, n_microphone 250) samples."""
        return self.screened(flat @ self.tables.reduce)

    def screened(self, x: Array) -> ScreenedLevel:
        """Scores of white frames, (n, size)."""
        power, alone = self.alone(x)
        if self.is_exact:
            score = self.tables.scores(x) + alone
            return ScreenedLevel(x, alone, score, np.zeros(len(x)), score.max(1))
        energy = ((x.astype(np.float32) @ self.vectors) ** 2).reshape(len(x), self.points, self.rank)
        # (point, frame, ...): one matrix product per point.
        gain = energy.transpose(1, 0, 2) @ self.weight
        values = -0.5 * (gain + self.log_determinant[:, None, :])
        # Of large numbers single precision knows no parabola; a true one rises by less than a nat above its samples.
        score = np.minimum(vertex(values), values.max(-1) + 1).T + alone
        error = self.options.screen_error * power
        return ScreenedLevel(x, alone, score, error, score.max(1) - error)

    def alone(self, x: Array) -> tuple[Array, Array]:
        """Sum of squares of white frames, (n,), and log-likelihood of noise and sound without a touch, (n, 1) nats."""
        power = (x**2).sum(1)
        # Large, and the same for all points: left out where there is no other level to compare with.
        return power, np.where(
            self.is_one_of_several, self.tables.offset - power / (2 * self.options.temperature), 0.0
        )[:, None]

    def score_again(self, level: ScreenedLevel, least: Array) -> None:
        """Put scores of double precision in the place of those that may reach ``least``, (n,) nats."""
        if self.is_exact:
            return
        again = level.score > (least - level.error)[:, None]
        level.score[again] = self.exact(level.x, again)[again] + np.broadcast_to(level.alone, again.shape)[again]

    def some(self, x: Array, chosen: NDArray[np.bool_]) -> Array:
        """Scores as of :meth:`exact`, (n, n_table) nats; of quiet frames with many in single precision."""
        options = self.options
        many = (chosen.mean(1) > options.many_tables) & (options.screen_error * (x**2).sum(1) < options.single_error)
        score = self.exact(x, chosen & ~many[:, None])
        if many.any():
            level = self.screened(x[many])
            score[many] = level.score - level.alone
        return score

    def exact(self, x: Array, chosen: NDArray[np.bool_]) -> Array:
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
        self._temperature = tables.options.temperature
        self.directions = min(tables.options.bound_directions, size - rank)
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

    def __call__(self, x: Array) -> Array:
        """Upper bounds of the scores of white frames (n, size), less those of noise alone; (n, n_table) nats."""
        power = (x**2).sum(1, keepdims=True)
        if not self.directions:
            return self._usual + 0.5 * power / self._temperature + 1.0
        energy = ((x.astype(np.float32) @ self._beside) ** 2).reshape(len(x), -1, self.directions).sum(2)
        rounding = BOUND_ERROR * np.sqrt(power)
        missing = np.maximum(np.sqrt(energy.astype(np.float64)) - rounding, 0.0) ** 2
        # The parabola of a score rises by less than a nat above what is true.
        return np.asarray(self._usual + 0.5 * (power - missing) / self._temperature + 1.0)


def _loud_directions(tables: DecoderTables) -> Array:
    """Directions in which touches of all tables are loudest, each as long as they are there; (size, n_direction)."""
    count, size, _ = tables.vectors.shape
    options = tables.options
    unit = int(np.abs(options.tried_powers - 1.0).argmin())
    together = np.zeros((size, size))
    for table in range(0, count, max(1, count // options.loud_directions)):
        heard = -options.temperature * tables.weight[table, :, unit]
        power = heard / np.maximum(1 - heard, np.finfo(np.float64).eps)
        together += (tables.vectors[table] * (power / power.sum())) @ tables.vectors[table].T
    values, vectors = np.linalg.eigh(together)
    return np.asarray(
        vectors[:, -options.loud_directions :] * np.sqrt(np.maximum(values[-options.loud_directions :], 0.0))
    )
