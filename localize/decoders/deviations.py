"""How well a made sensor fits a frame: a hypothesis, and deviations about it that are found from the frame itself.

Between its hypotheses, :mod:`localize.decoders.hypotheses`, a sensor fits none exactly: what is left of a loud touch in
the directions in which the hypothesis says that nothing is heard weighs far more than the noise. A hypothesis therefore
has a few shapes in which the logarithms of its transfer functions may deviate, each with a standard normal amplitude z.

With x = B(z)^T s + noise, s the source's random amplitudes, the least sum of squares over s is, to first order in z,
(x - G z)^T S^-1 (x - G z): S = g C + 1 the covariance of the hypothesis, column k of G what shape k does to the source
that the hypothesis itself finds, g B_k^T B S^-1 x (variable projection; Golub and Pereyra 1973). That source is found
as if there were more noise, and found again, with its power g, without what the deviations explain. Over z this is a
Gaussian integral: the log-likelihood gains b^T (1 + F)^-1 b / 2 - log det(1 + F) / 2, b = G^T S^-1 x and
F = G^T S^-1 G. A sensor keeps its deviations: b and F of all frames of a recording are added up.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from localize.decoders.bayes import POWERS, TEMPERATURE, DecoderTables
from localize.decoders.frame_covariance import DEVIATING, deviation_moments
from localize.decoders.hypotheses import Hypotheses

STEPS = 2
"""Times that the source, and its power, are found again without what deviations explain."""
UNEXPLAINED = 0.02
"""Share of a frame's power that the source is not asked to explain, against 1 for the noise: in directions in which a
touch is hardly heard, what deviates is far more than the touch. From 0.005 to 0.05 the integral is met alike."""
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

    def scores(self, x: NDArray[np.float64], tables: NDArray[np.int64]) -> NDArray[np.float64]:
        """Log-likelihoods of recordings by hypotheses and their deviations, without those of noise alone.

        Args:
            x: (n, n_frame, size), white.
            tables: numbers of the hypotheses, (k,).

        Returns:
            (k, n) float64, nats.
        """
        recordings, temperature = (len(tables), *x.shape[:2]), self.warmth * TEMPERATURE
        flat = x.reshape(-1, self.size)
        vectors, weight = self.tables.vectors[tables], self.tables.weight[tables]
        loss, changes = self.tables.log_determinant[tables][:, None], self.changes[tables].transpose(0, 2, 1)
        along = cleaned = flat @ vectors
        unexplained = 1 + UNEXPLAINED * (flat**2).mean(1, keepdims=True)
        each = (*along.shape[:2], self.shapes)
        for _ in range(STEPS):
            power = (-0.5 * (cleaned**2 @ weight + loss)).argmax(-1)
            heard = -TEMPERATURE * np.take_along_axis(weight, power[:, None], 2).transpose(0, 2, 1)
            source = cleaned / (unexplained + heard / (1 - heard))
            change = (source.astype(np.float32) @ changes).reshape(*each, -1)
            change = change * POWERS[power][..., None, None]
            seen = (change.reshape(len(tables), -1, self.size) @ vectors).reshape(*each, -1)
            left = flat - (along * heard) @ vectors.transpose(0, 2, 1)
            slope = (change @ left[..., None])[..., 0]
            bend = change @ change.swapaxes(2, 3) - (seen * heard[:, :, None]) @ seen.swapaxes(2, 3)
            slope, bend = (part.reshape(*recordings, *part.shape[2:]).sum(2) / temperature for part in (slope, bend))
            information = bend + np.eye(self.shapes)
            amplitude = np.linalg.solve(information, slope[..., None])[..., 0]
            cleaned = along - (np.repeat(amplitude, recordings[2], 1)[:, :, None] @ seen)[:, :, 0]
        values = -0.5 * (along**2 @ weight + loss)
        fit = np.take_along_axis(values, power[..., None], 2).reshape(recordings).sum(2) / self.warmth
        determinant = np.linalg.slogdet(information)[1]
        return np.asarray(fit + 0.5 * (slope * amplitude).sum(2) - 0.5 * determinant)
