"""Decoders by their formulas alone: every table is scored in double precision, a frame at a time.

Shortcuts of the package's decoders must not show: tests compare their probabilities with
these, and ``decoder_time.py`` their time.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import softmax

from localize.decoders.bayes import BayesDecoder
from localize.decoders.frame_covariance import DEVIATING, deviation_moments, joint_whitening
from localize.decoders.likelihood import DecoderTables, assumed_noise, vertex
from localize.decoders.tolerant import TolerantDecoder
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import checked_signals
from localize.signals.threads import one_thread

Array = NDArray[np.float64]


class PlainBayes:
    """The decoder of a known sensor.

    Args:
        decoder: whose tables are taken, of one level of sound.
    """

    def __init__(self, decoder: BayesDecoder) -> None:
        (self._tables,) = decoder.tables
        self.microphones, self.noise_rms = decoder.microphones, decoder.noise_rms

    @one_thread()
    def locate(self, signals: ArrayLike) -> Array:
        """Probability of each point, (n_point,), from (n_microphone, 250) Pa."""
        x = _checked(signals, self.microphones) @ self._tables.reduce
        return np.asarray(softmax(_scores(x, self._tables)[0]))


class PlainTolerant:
    """The decoder of a sensor that nobody calibrated.

    Args:
        decoder: whose hypotheses and tables are taken, of one level of sound and of all microphones.
        response: of its library.
    """

    def __init__(self, decoder: TolerantDecoder, response: ArrayResponse) -> None:
        (self._tables,) = decoder.tables
        self.microphones, self.noise_rms = decoder.microphones, decoder.noise_rms
        self._log_prior, made, self._options = decoder.log_prior, decoder.hypotheses, decoder.options
        self.shapes = decoder.shapes
        whiten = joint_whitening(response, assumed_noise(decoder.around.noise, decoder.options), None)
        count, size, rank = self._tables.vectors.shape
        self._changes = np.empty((count, self.shapes * size, rank))
        for number, each in enumerate(made.responses):
            for point, touched in enumerate(each.at(DEVIATING)):
                table = point * len(made.responses) + number
                seen = whiten.T @ self._tables.vectors[table]
                change = whiten @ deviation_moments(touched, made.deviations[number, : self.shapes, point], seen)
                self._changes[table] = change.reshape(-1, rank)

    @one_thread()
    def locate(self, signals: ArrayLike) -> Array:
        """Probability of each point, (n_point,), from (n_microphone, 250) Pa."""
        options = self._options
        x = _checked(signals, self.microphones) @ self._tables.reduce
        loudest = 10 ** (options.believed_level / 10)
        x = x * np.sqrt(min(1.0, loudest * options.temperature / max((x**2).mean(), 1e-30)))
        screened = _scores(x, self._tables)[0] / options.relative_temperature
        score = np.full(screened.shape, np.nan)
        for table in np.argsort(-screened)[: options.candidates]:
            score[table] = self._fitted(x[0], int(table))
        empty = x.size * (1 - 1 / len(self.microphones))
        fit = options.relative_temperature * np.nanmax(score)
        misfit = ((x**2).sum() / options.temperature - 2 * fit) / empty
        score = np.where(np.isnan(score), np.minimum(screened, np.nanmin(score)), score)
        of_point = np.logaddexp.reduce(score.reshape(self._log_prior.shape) + self._log_prior, axis=1)
        return np.asarray(softmax(of_point / max(1.0, misfit / options.explained_misfit) ** 2))

    def _fitted(self, x: Array, table: int) -> float:
        """Log-likelihood of a white frame (size,) by a hypothesis and its deviations, in differences of large sums."""
        vectors, weight = self._tables.vectors[table], self._tables.weight[table]
        loss, options = self._tables.log_determinant[table], self._options
        temperature = options.relative_temperature * options.temperature
        along = cleaned = x @ vectors
        unexplained = 1 + options.unexplained_fraction * (x**2).mean()
        for _ in range(options.source_steps):
            power = int((-0.5 * (cleaned**2 @ weight + loss)).argmax())
            heard = -options.temperature * weight[:, power]
            source = cleaned / (unexplained + heard / (1 - heard))
            change = options.tried_powers[power] * (self._changes[table] @ source).reshape(self.shapes, -1)
            seen = change @ vectors
            slope = change @ (x - vectors @ (along * heard)) / temperature
            information = (change @ change.T - (seen * heard) @ seen.T) / temperature + np.eye(self.shapes)
            amplitude = np.linalg.solve(information, slope)
            cleaned = along - amplitude @ seen
        fit = -0.5 * (along**2 @ weight[:, power] + loss[power]) / options.relative_temperature
        return float(fit + 0.5 * slope @ amplitude - 0.5 * np.linalg.slogdet(information)[1])


def _checked(signals: ArrayLike, microphones: tuple[str, ...]) -> Array:
    """A frame (n_microphone, 250) as one row, looked at as the decoders look at it."""
    frames = checked_signals(signals, microphones)[0]
    return frames.reshape(len(frames), -1)


def _scores(x: Array, tables: DecoderTables) -> Array:
    """Scores of white frames (n, size) by all tables, (n, n_table) nats."""
    gain = (x @ tables.vectors) ** 2 @ tables.weight
    return vertex(-0.5 * (gain + tables.log_determinant[:, None, :])).T
