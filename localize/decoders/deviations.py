"""Fit of an as-built sensor to a frame: a hypothesis, and deviations from it that are estimated from the frame itself.

A sensor lies between its hypotheses, :mod:`localize.decoders.hypotheses`, and fits none of them exactly: in directions
in which the hypothesis predicts no signal, the residual of a loud touch is far larger than the noise. A hypothesis
therefore has a few shapes in which the logarithms of its transfer functions may deviate, each with a standard normal
amplitude z.

Write a frame as x = B(z)^T s + noise, with s the source's random amplitudes. The least sum of squares over s is, to
first order in z, (x - G z)^T S^-1 (x - G z). Here S = g C + 1 is the covariance of the hypothesis. Column k of G is the
change of the frame by shape k, for the source that the hypothesis itself finds, g B_k^T B S^-1 x (variable projection;
Golub and Pereyra 1973). The source is first estimated as if the noise were higher. It is then estimated again, with its
power g, after the part that the deviations explain is subtracted. Over z this is a Gaussian integral: the
log-likelihood gains b^T (1 + F)^-1 b / 2 - log det(1 + F) / 2, with b = G^T S^-1 x and F = G^T S^-1 G.

Everything is computed in the basis of the hypothesis, its eigenvectors and the directions that it leaves empty, because
S^-1 is diagonal there and sums have no terms to subtract. A sensor keeps its deviations, so b and F of all frames of a
recording are added up.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.decoders.decoder_options import TolerantOptions
from localize.decoders.frame_covariance import DEVIATING, deviation_moments
from localize.decoders.hypotheses import Hypotheses
from localize.decoders.likelihood import DecoderTables


class DeviatingTables:
    """Tables of hypotheses with their deviations, for one level of the sound around.

    Args:
        tables: of the hypotheses, point by point.
        hypotheses: what they are of.
        whiten: what makes noise and sound white, (size, n) float64, 1/Pa.
        options: of the decoder.
        at_once: whether all tables are made now; if not, each is when it is first used.
    """

    def __init__(
        self,
        tables: DecoderTables,
        hypotheses: Hypotheses,
        whiten: Array,
        options: TolerantOptions,
        at_once: bool = True,
    ) -> None:
        self.tables, self._options = tables, options
        self._hypotheses, self._whiten = hypotheses, whiten
        count, self.size, self.rank = tables.vectors.shape
        each = hypotheses.deviations.shape[1]
        self.shapes = max(1, min(each, int(options.shape_numbers // (count * self.size * self.rank))))
        self.changes = np.empty((count, self.shapes * self.size, self.rank), np.float32)
        self.beside = np.empty((count, self.size, self.size - self.rank))
        self._made = np.zeros(count, bool)
        if at_once:
            self._make(np.arange(count))

    def _make(self, tables: NDArray[np.int64]) -> None:
        """Make those of the tables that are not made yet."""
        missing = np.unique(tables[~self._made[tables]])
        each = len(self._hypotheses.responses)
        for number in np.unique(missing % each):
            touched = self._hypotheses.responses[number].at(DEVIATING)
            for table in missing[missing % each == number]:
                vectors, point = self.tables.vectors[table], table // each
                shapes = self._hypotheses.deviations[number, : self.shapes, point]
                moments = deviation_moments(touched[point], shapes, self._whiten.T @ vectors)
                self.beside[table] = np.linalg.qr(vectors, mode="complete")[0][:, self.rank :]
                basis = np.concatenate([vectors, self.beside[table]], axis=1)
                change = (basis.T @ self._whiten) @ moments
                self.changes[table] = change.reshape(-1, self.rank)
        self._made[missing] = True

    def scores(self, x: Array, tables: NDArray[np.int64]) -> Array:
        """Log-likelihoods of recordings by hypotheses and their deviations, without those of noise alone.

        Args:
            x: (n, n_frame, size), white.
            tables: numbers of the hypotheses, (k,).

        Returns:
            (k, n) float64, nats.
        """
        self._make(tables)
        options, powers = self._options, self._options.tried_powers
        recordings, temperature = (len(tables), *x.shape[:2]), options.relative_temperature * options.temperature
        flat = x.reshape(-1, self.size)
        weight, loss = self.tables.weight[tables], self.tables.log_determinant[tables][:, None]
        # In the basis of each hypothesis, what it leaves empty last.
        whole = np.empty((len(tables), *flat.shape))
        for row, table in zip(whole, tables, strict=True):
            np.matmul(flat, self.tables.vectors[table], out=row[:, : self.rank])
            np.matmul(flat, self.beside[table], out=row[:, self.rank :])
        along = cleaned = whole[..., : self.rank]
        unexplained = 1 + options.unexplained_fraction * (flat * flat).mean(1, keepdims=True)
        kept = np.ones(whole.shape)
        which = np.arange(len(tables))[:, None]
        for step in range(options.source_steps):
            power = (cleaned * cleaned @ weight + loss).argmin(-1)
            heard = -options.temperature * weight[which, :, power]
            kept[..., : self.rank] = 1 - heard
            source = cleaned / (unexplained + heard / (1 - heard))
            change = self._change(source * powers[power][..., None], tables, step == options.source_steps - 1)
            missing = change * kept[:, :, None]
            slope = (missing @ whole[..., None])[..., 0]
            bend = missing @ change.swapaxes(2, 3)
            slope, bend = (part.reshape(*recordings, *part.shape[2:]).sum(2) / temperature for part in (slope, bend))
            information = bend + np.eye(self.shapes)
            amplitude = np.linalg.solve(information, slope[..., None])[..., 0]
            explained = np.repeat(amplitude, recordings[2], 1)[:, :, None] @ change[..., : self.rank]
            cleaned = along - explained[:, :, 0]
        misfit = (along * along @ weight + loss)[which, np.arange(len(flat)), power]
        fit = -0.5 * misfit.reshape(recordings).sum(2) / options.relative_temperature
        determinant = np.linalg.slogdet(information)[1]
        return np.asarray(fit + 0.5 * (slope * amplitude).sum(2) - 0.5 * determinant)

    def _change(self, source: Array, tables: NDArray[np.int64], is_last: bool) -> Array:
        """Change of frames by each shape, for sources (k, n, rank) in the bases of the tables; (k, n, n_shape, size).

        Single precision is enough to estimate the source again, because the final scores are computed in double
        precision.
        """
        change = np.empty((*source.shape[:2], self.shapes * self.size))
        if not is_last:
            for row, of_table, table in zip(change, source.astype(np.float32), tables, strict=True):
                row[...] = of_table @ self.changes[table].T
            return change.reshape(*source.shape[:2], self.shapes, self.size)
        changes = np.empty(self.changes.shape[1:])  # one for all: memory that is new takes longer than the product
        for row, of_table, table in zip(change, source, tables, strict=True):
            changes[...] = self.changes[table]
            np.matmul(of_table, changes.T, out=row)
        return change.reshape(*source.shape[:2], self.shapes, self.size)
