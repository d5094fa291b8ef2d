"""The decoder that needs no training: maximum likelihood over points, from the library alone.

If point i is touched, the microphones' samples of a frame, stacked into one vector x, are a zero-mean Gaussian with
covariance g C_i + N: C_i from :mod:`localize.decoders.frame_covariance`, g the unknown power of the touch, N the
covariance of the noise. The likelihood of each point, maximised over g, ranks the points (Gaussian-process
classification; Rasmussen and Williams 2006, chapter 2, for the likelihood). In coordinates where N is the identity, the
eigenvectors of C_i make the likelihood a sum over a few dozen terms.

Sound from outside presses on all membranes alike: at each frequency it adds a covariance of rank one to N, whose
shape the library knows and whose level is assumed, or found among several as the likeliest.

A touch with few spectral lines fills far fewer of those terms than a flat spectrum, so that the likelihood weighs the
noise of the empty ones too high against the shape of the signal: the decoder assumes a share of the noise that it is
told, and divides its log-likelihoods by a temperature, so that its probabilities are as sure as they are right.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from geometry.refusal import Refusal
from localize.decoders.frame_covariance import (
    SAMPLES,
    check_level,
    check_noise,
    joint_whitening,
    low_pass,
    touch_covariances,
)
from localize.signals.array_response import ArrayResponse, response_of, warn_of_uncovered
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise import NoiseChoice, NoiseSpectrum
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from acoustic_fem import Library

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
CHUNK = 64
"""Number of frames that are decoded at once."""


def sound_levels(loudest: float | None) -> tuple[float | None, ...]:
    """Levels that cover sound up to one in dB SPL, quiet (None) among them; of None quiet alone.

    15 dB apart from 40 on: 10 apart was tried on line-2, better at some levels and worse at others by up to 1.7 %.
    """
    if loudest is None:
        return (None,)
    return (None, *(float(level) for level in np.arange(40.0, loudest + 7.5, 15.0)))


ROOM = sound_levels(90.0)
"""Levels among which the sound of a room is looked for, dB SPL; None is quiet."""

#: Sound around: none, a level in dB SPL, or several, of which each frame takes the likeliest.
Ambient = float | None | Sequence[float | None]


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
    """Weight of the energy along each eigenvector, per value of g; (n_table, rank, n_power) float64."""
    log_determinant: NDArray[np.float64]
    """Logarithm of the covariance's determinant over that of the noise, over the temperature; (n_table, n_power)
    float64, nats."""
    offset: float
    """Log-likelihood of the noise and sound alone, nats, which tells levels apart."""


class BayesDecoder:
    """Gaussian-process maximum likelihood over the points of one array.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones; touches are
            taken to be silent above their last frequency, with a warning where that is below 500 Hz.
        microphone_noise: the noise floor to assume: white, Pa rms over 0 to 500 Hz, 1e-9 to 10; or "design" for
            that of the library's design, see :mod:`localize.signals.noise`. It also stands for what the library does
            not know; a higher one is kinder to a sensor that differs from its design.
        ambient: pink sound around, the same pressure on all membranes: its level in dB SPL, 0 to 140; None for
            quiet; or several levels, such as :data:`ROOM`, of which each frame takes the likeliest. Tables, and where
            there is sound also time, grow with their number. Needs a library with a design.

    Raises:
        Refusal: the library does not cover 1 to 100 Hz, the noise or the sound is outside its range, or sound is
            assumed without a design.
    """

    assumes = "that the sensor is as its library has it"
    """What is taken for granted of the sensor, in words."""

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = 1e-3,
        ambient: Ambient = None,
    ) -> None:
        check_noise(microphone_noise)
        response = self._heard(library)
        warn_of_uncovered(response)
        self.ambient = checked_levels(response, ambient)
        self.design = response.name
        self.microphones = response.microphones
        self.line = response.line
        self.place = response.place
        self.microphone_noise = microphone_noise
        self.provenance = response.provenance
        noise = response.noise(microphone_noise)
        self.noise_rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        touched = self._touched(library, response)
        whitening = [self._white(response, share_of(noise), level) for level in self.ambient]
        self.tables = tuple(tables_of(touched, *each) for each in zip(whitening, self.ambient, strict=True))
        self._prepare(whitening)

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.line)

    def _heard(self, library: Library | ArrayResponse) -> ArrayResponse:
        """The array that is decoded."""
        return response_of(library)

    def _touched(self, library: Library | ArrayResponse, response: ArrayResponse) -> NDArray[np.float64]:
        """Covariances of what may have been touched, (n_table, n, n) float64, Pa^2: of the points."""
        return touch_covariances(response, np.eye(SAMPLES))

    def _white(self, response: ArrayResponse, noise: float | NoiseSpectrum, level: float | None) -> NDArray[np.float64]:
        """Matrix that makes all that is heard beside touches white, (n, n) float64, 1/Pa."""
        return joint_whitening(response, noise, level)

    def _prepare(self, whitening: Sequence[NDArray[np.float64]]) -> None:
        """What scores the tables of each level of sound, whose noise and sound the matrices make white."""
        self._screens = tuple(Screen(tables, len(self.tables) > 1) for tables in self.tables)

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Where the array was touched, all points equally likely beforehand.

        A recording longer than 250 samples is cut into frames, the last one ending with it, which are taken as
        independent observations of one touch.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64: probability per point.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, batched = checked_signals(signals, self.microphones)
        probability = np.exp(self._log_probability(batch))
        return probability if batched else probability[0]

    @one_thread()
    def log_probability(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Logarithm of what :meth:`locate` gives, which does not end at the smallest number there is.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n, n_point) float64, nats.

        Raises:
            Refusal: as :meth:`locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        return self._log_probability(batch)

    def _log_probability(self, batch: Tensor) -> NDArray[np.float64]:
        total = self.joint_log_likelihood(batch)
        total -= total.max(1, keepdims=True)
        return np.asarray(total - np.log(np.exp(total).sum(1, keepdims=True)))

    def joint_log_likelihood(self, batch: Tensor) -> NDArray[np.float64]:
        """Log-likelihood of every point, all frames of each signal together.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch)
        flat = frames.flatten(0, 1).numpy()
        score = np.concatenate([self.log_likelihood(flat[k : k + CHUNK]) for k in range(0, len(flat), CHUNK)])
        return np.asarray(score.reshape(*frames.shape[:2], -1).sum(1))

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, maximised over the power of the touch and divided by the temperature.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        flat = frames.reshape(len(frames), -1)
        levels = [screen(flat) for screen in self._screens]
        # Points are left to single precision only where none of any level may come near the best of all.
        least = np.max([level.best for level in levels], axis=0) - SURE
        for screen, level in zip(self._screens, levels, strict=True):
            screen.score_again(level, least)
        return np.max([level.score for level in levels], axis=0) if len(levels) > 1 else levels[0].score


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
        # One matrix for all points: (n_microphone SAMPLES, n_point rank).
        self.vectors = np.ascontiguousarray(tables.vectors.astype(np.float32).transpose(1, 0, 2).reshape(self.size, -1))
        self.weight = tables.weight.astype(np.float32)
        self.log_determinant = tables.log_determinant.astype(np.float32)

    def __call__(self, flat: NDArray[np.float64]) -> ScreenedLevel:
        """Scores of (n, n_microphone 250) samples."""
        x = flat @ self.tables.reduce
        energy = ((x.astype(np.float32) @ self.vectors) ** 2).reshape(len(x), self.points, self.rank)
        # (point, frame, ...): one matrix product per point.
        gain = energy.transpose(1, 0, 2) @ self.weight
        values = -0.5 * (gain + self.log_determinant[:, None, :])
        power, alone = self.alone(x)
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
        again = level.score > (least - level.error)[:, None]
        for table in np.flatnonzero(again.any(0)):
            frames = np.flatnonzero(again[:, table])
            level.score[frames, table] = self.exact(level.x[frames], int(table)) + level.alone[frames, 0]

    def exact(self, x: NDArray[np.float64], table: int) -> NDArray[np.float64]:
        """Scores of white frames by one table in double precision, without those of noise alone; (n,) nats."""
        tables = self.tables
        energy = (x @ tables.vectors[table]) ** 2 @ tables.weight[table]
        return vertex(-0.5 * (energy + tables.log_determinant[table]))


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


def share_of(noise: float | NoiseSpectrum) -> float | NoiseSpectrum:
    """Noise that likelihoods are computed with, from the one that is told."""
    if isinstance(noise, NoiseSpectrum):
        return NoiseSpectrum(noise.power * NOISE_SHARE**2, noise.source)
    return noise * NOISE_SHARE


def checked_levels(response: ArrayResponse, ambient: Ambient) -> tuple[float | None, ...]:
    """Levels of an ``ambient``, from quiet to loud.

    Raises:
        Refusal: no level, or as :func:`localize.decoders.frame_covariance.check_level`.
    """
    levels = tuple(ambient) if isinstance(ambient, Sequence) else (ambient,)
    if not levels:
        raise Refusal("ambient is empty: it must hold at least one level, or None for quiet")
    for level in levels:
        check_level(response, level)
    return tuple(sorted(set(levels), key=lambda level: -1.0 if level is None else level))


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
