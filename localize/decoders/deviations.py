"""How well a made sensor fits a frame: a hypothesis, and deviations about it that are found from the frame itself.

Between its hypotheses, :mod:`localize.decoders.hypotheses`, a sensor fits none exactly: what is left of a loud touch in
the directions in which the hypothesis says that nothing is heard weighs far more than the noise. A hypothesis therefore
has a few shapes in which the logarithms of its transfer functions may deviate, each with a standard normal amplitude z.

With x = B(z)^T s + noise, s the source's random amplitudes, the least sum of squares over s is, to first order in z,
(x - G z)^T S^-1 (x - G z): S = g C + 1 the covariance of the hypothesis, column k of G what shape k does to the source
that the hypothesis itself finds, g B_k^T B S^-1 x (variable projection; Golub and Pereyra 1973). Over z this is a
Gaussian integral: the log-likelihood gains b^T (1 + F)^-1 b / 2 - log det(1 + F) / 2, b = G^T S^-1 x and
F = G^T S^-1 G. A sensor keeps its deviations: b and F of all frames of a recording are added up.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from localize.decoders.bayes import POWERS, TEMPERATURE, DecoderTables, vertex
from localize.decoders.frame_covariance import DEVIATING, deviation_moments
from localize.decoders.hypotheses import Hypotheses

STEPS = 2
"""Times that the source is found again without what deviations explain."""
MOST_NUMBERS = 3e7
"""Numbers of all shapes of all tables together: large arrays have fewer shapes."""


class DeviatingTables:
    """Tables of hypotheses with their deviations, for one level of the sound around.

    Args:
        tables: of the hypotheses, point by point.
        hypotheses: what they are of.
        whiten: what makes noise and sound white, (n, n) float64, 1/Pa.
        warmth: temperature over that of the tables.
    """

    def __init__(
        self, tables: DecoderTables, hypotheses: Hypotheses, whiten: NDArray[np.float64], warmth: float
    ) -> None:
        self.tables, self.warmth = tables, warmth
        count, self.size, self.rank = tables.vectors.shape
        each = hypotheses.deviations.shape[1]
        self.shapes = max(1, min(each, int(MOST_NUMBERS // (count * self.size * self.rank))))
        self.changes = np.empty((count, self.shapes * self.size, self.rank), np.float32)
        for number, response in enumerate(hypotheses.responses):
            for point, touched in enumerate(response.at(DEVIATING)):
                table = point * len(hypotheses.responses) + number
                moments = deviation_moments(touched, hypotheses.deviations[number, : self.shapes, point])
                change = whiten @ moments @ (whiten.T @ tables.vectors[table])
                self.changes[table] = change.reshape(-1, self.rank)

    def scores(self, x: NDArray[np.float64], table: int) -> NDArray[np.float64]:
        """Log-likelihoods of recordings by one hypothesis and its deviations, without those of noise alone.

        Args:
            x: (n, n_frame, size), white.
            table: number of the hypothesis.

        Returns:
            (n,) float64, nats.
        """
        count, frames, _ = x.shape
        flat = x.reshape(-1, self.size)
        vectors = self.tables.vectors[table]
        along = flat @ vectors
        values = -0.5 * (along**2 @ self.tables.weight[table] + self.tables.log_determinant[table])
        power = values.argmax(1)
        fit = vertex(values).reshape(count, frames).sum(1) / self.warmth
        heard = -TEMPERATURE * self.tables.weight[table].T[power]
        gain = self._gain(flat, along, vectors, heard, POWERS[power], table, (count, frames))
        return np.asarray(fit + gain)

    def _gain(
        self,
        x: NDArray[np.float64],
        along: NDArray[np.float64],
        vectors: NDArray[np.float64],
        heard: NDArray[np.float64],
        power: NDArray[np.float64],
        table: int,
        recordings: tuple[int, int],
    ) -> NDArray[np.float64]:
        """What deviations add to the log-likelihood, (n,) nats; ``heard`` is the share of touch in each direction."""
        temperature = self.warmth * TEMPERATURE
        misfit = x - (along * heard) @ vectors.T
        source = along * (1 - heard)
        for _ in range(STEPS):
            change = (source.astype(np.float32) @ self.changes[table].T).reshape(len(x), self.shapes, -1)
            change = change * power[:, None, None]
            seen = change @ vectors
            slope = (change @ misfit[:, :, None])[..., 0]
            bend = change @ change.transpose(0, 2, 1) - (seen * heard[:, None]) @ seen.transpose(0, 2, 1)
            slope, bend = (each.reshape(*recordings, *each.shape[1:]).sum(1) / temperature for each in (slope, bend))
            information = bend + np.eye(self.shapes)
            amplitude = np.linalg.solve(information, slope[..., None])[..., 0]
            explained = np.repeat(amplitude, recordings[1], 0)[:, None]
            source = (along - (explained @ seen)[:, 0]) * (1 - heard)
        determinant = np.linalg.slogdet(information)[1]
        return np.asarray(0.5 * (slope * amplitude).sum(1) - 0.5 * determinant)
