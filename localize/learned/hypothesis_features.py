"""Features of a frame under each hypothesis about its sensor: what the network of hypotheses looks at.

A sensor that nobody calibrated may be one of several, :mod:`localize.decoders.hypotheses`. Each hypothesis of each
point says in which directions a touch moves a frame, and in which shapes these directions may deviate. Write the frame
as x, where noise is white, over its own size; u is its part along those directions and r = x - V u the residual. A
Gaussian whose noise is a small share f of the frame gives

    q = r^T S^-1 r,   S = s^2 + G G^T,   s^2 = f + noise / frame,   and   log det(S / s^2).

Column k of G is the change of the residual by shape k, for the source that the hypothesis itself finds: as in
:mod:`localize.decoders.deviations`, but without the search for its power. All of it is linear in the frame, but for a
system of as many equations as there are shapes. Further features are the residual without shapes, and how likely the
source is, whose spectrum a touch of a flat spectrum gives.

A share f says how far a sensor may be off its hypothesis. The right one depends on the touch, so there are several,
from a tenth of the amplitude to a ten-thousandth; the network weighs them.
"""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor, nn

from geometry.ground.typed import Array
from localize.decoders.deviations import DeviatingTables
from localize.decoders.likelihood import DecoderTables

SHARES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
"""Shares f of the power of a frame that a hypothesis need not explain."""
UNEXPLAINED = 1e-4
"""The same share where the source is estimated. With 0.02, five more presses of a hundred on as-built sensors of
array-2x6 were wrong, by the strokes that it is trained on; 1e-3 does as well."""
LEAST_PRIOR = -20.0
"""Least logarithm of a prior."""
SOURCES = 40
"""Largest number of combinations of a source's parts whose changes are followed: the others make less than a thousandth
of all changes on any prototype."""
MOVED = 80
"""Largest number of directions in which shapes are taken to move a frame. With two microphones there are fewer; with
four, where a touch leaves 137 directions empty, the others hold 1 % of all changes."""
TOGETHER = 2**23
"""Size of the largest intermediate result, numbers: frames are taken in parts."""


class HypothesisFeatures(nn.Module):
    """Features (n, n_point, n_hypothesis, n_feature) of a batch of frames (n, n_microphone, 250).

    Matrix products and functions of one value alone: it runs on any device and can be exported.

    Args:
        points: number of points.
        hypotheses: number of each point.
        samples: of a frame, all microphones together.
        size: of a white frame.
        rank: number of directions in which a touch moves a frame.
        shapes: number of shapes in which these deviate, or 0.
    """

    reduce: Tensor
    """From the samples of a frame to where noise is white; (samples, size) float64, 1/Pa."""
    explained: Tensor
    """Directions in which a touch moves a frame; (n_table, size, rank) float32, a table for each hypothesis of each
    point."""
    beside: Tensor
    """Those of the other directions in which shapes move a frame most; (n_table, size, n_moved) float32."""
    source: Tensor
    """From the parts of a frame in the first to those combinations that move a frame most; (n_table, rank, n_source)
    float32."""
    change: Tensor
    """Change in the other directions by each of these combinations; (n_table, n_source, n_shape n_moved) float32."""
    likely: Tensor
    """Inverse of the power that a touch has in each direction, and a share of the frame; (n_table, rank, n_share)
    float32."""
    volume: Tensor
    """Logarithm of the determinant of the same; (n_table, n_share) float32."""
    prior: Tensor
    """Logarithm of the prior of each hypothesis; (n_point, n_hypothesis) float32."""

    def __init__(self, points: int, hypotheses: int, samples: int, size: int, rank: int, shapes: int) -> None:
        super().__init__()
        tables = points * hypotheses
        sources, moved = (min(rank, SOURCES), min(size - rank, MOVED)) if shapes else (0, 0)
        self.points, self.hypotheses, self.shapes = points, hypotheses, shapes
        self._frames_together = max(1, TOGETHER // (tables * max(size, moved * shapes)))
        self.register_buffer("reduce", torch.zeros(samples, size, dtype=torch.float64))
        self.register_buffer("explained", torch.zeros(tables, size, rank))
        self.register_buffer("beside", torch.zeros(tables, size, moved))
        self.register_buffer("source", torch.zeros(tables, rank, sources))
        self.register_buffer("change", torch.zeros(tables, sources, shapes * moved))
        self.register_buffer("likely", torch.zeros(tables, rank, len(SHARES)))
        self.register_buffer("volume", torch.zeros(tables, len(SHARES)))
        self.register_buffer("prior", torch.zeros(points, hypotheses))

    @property
    def count(self) -> int:
        """Number of features of a hypothesis."""
        return feature_count(self.shapes)

    def take(self, tables: DecoderTables, deviating: DeviatingTables | None, log_prior: Array) -> None:
        """Take the tables of a decoder.

        Args:
            tables: of one level of the sound around.
            deviating: shapes of the same; None where nothing deviates.
            log_prior: of the hypotheses, (n_point, n_hypothesis) float64.
        """
        self.reduce.copy_(torch.from_numpy(tables.reduce))
        self.explained.copy_(torch.from_numpy(tables.vectors))
        self.prior.copy_(torch.from_numpy(np.maximum(log_prior, LEAST_PRIOR)))
        power = _powers(tables)
        expected = power / power.mean(1, keepdims=True) * (tables.vectors.shape[1] / tables.vectors.shape[2])
        together = expected[..., None] + np.asarray(SHARES)
        self.likely.copy_(torch.from_numpy(1 / together))
        self.volume.copy_(torch.from_numpy(np.log(together).sum(1)))
        if deviating is None or not self.shapes:
            return
        size, rank = tables.vectors.shape[1:]
        for table, of_table in enumerate(power):
            usual = np.sqrt(UNEXPLAINED / size * of_table.sum() + of_table)
            # Changes by the parts of a touch of a flat spectrum, each as large as it is expected.
            shapes = deviating.changes[table].reshape(-1, size, rank)[: self.shapes, rank:] / usual
            into, of = _leading(shapes.swapaxes(0, 1), MOVED), _leading(shapes.transpose(2, 0, 1), SOURCES)
            self.beside[table] = torch.from_numpy(deviating.beside[table] @ into)
            self.source[table] = torch.from_numpy(of / usual[:, None])
            self.change[table] = torch.from_numpy((into.T @ shapes @ of).transpose(2, 0, 1).reshape(of.shape[1], -1))

    def forward(self, frames: Tensor) -> Tensor:
        """Features of a batch of frames.

        Args:
            frames: (n, n_microphone, 250) float32, Pa, at 1 kHz.

        Returns:
            (n, n_point, n_hypothesis, n_feature) float32.
        """
        if torch.compiler.is_compiling():  # and while a graph is exported, whose batch is open
            return self._features(frames)
        return torch.cat([self._features(part) for part in frames.split(self._frames_together)])

    def _features(self, frames: Tensor) -> Tensor:
        white = frames.double().flatten(1) @ self.reduce
        # A frame of zeros, of a microphone that is switched off, says nothing of any point.
        power = white.square().mean(1).clamp_min(1e-12)
        # Of size one, so that single precision does for all that follows.
        unit = (white / power.sqrt()[:, None]).float()
        along = unit @ self.explained
        rest = unit - along @ self.explained.mT
        left = rest.square().sum(-1, keepdim=True)
        shares = (1 / power).float()[:, None] + unit.new_tensor(SHARES)
        surprise = torch.log1p(along.square() @ self.likely)
        columns = [torch.log1p(left / shares), surprise, self.volume[:, None].expand_as(surprise)]
        if self.shapes:
            inside = rest @ self.beside
            change = (along @ self.source @ self.change).unflatten(-1, (self.shapes, -1))
            explained, determinant = _ridge(change @ change.mT, (change @ inside[..., None])[..., 0], shares)
            columns = [torch.log1p((left - explained).clamp_min(0.0) / shares), determinant, *columns]
        features = torch.cat(columns, -1).unflatten(0, (self.points, self.hypotheses)).movedim(2, 0)
        # A column counts beside that of the best hypothesis.
        features = features + (-features).amax((1, 2), keepdim=True)
        loud = power.log().float()[:, None, None, None].expand(-1, self.points, self.hypotheses, 1)
        prior = self.prior[None, :, :, None].expand_as(loud)
        return torch.cat([features, loud, prior], -1)


def feature_count(shapes: int) -> int:
    """Number of features of a hypothesis with so many shapes; the first of each share, then the others."""
    return (5 if shapes else 3) * len(SHARES) + 2


def _leading(values: Array, most: int) -> Array:
    """Directions along the first axis that hold most of (n, ...) values, at most so many; (n, k) float64."""
    flat = values.reshape(len(values), -1)
    return np.asarray(np.linalg.eigh(flat @ flat.T)[1][:, ::-1][:, :most])


def _powers(tables: DecoderTables) -> Array:
    """Power of a touch along each direction of each table; (n_table, rank) float64, over the noise."""
    unit = int(np.abs(tables.options.tried_powers - 1.0).argmin())
    heard = -tables.options.temperature * tables.weight[:, :, unit]
    return np.asarray(heard / np.maximum(1 - heard, np.finfo(np.float64).eps))


def _ridge(bend: Tensor, slope: Tensor, shares: Tensor) -> tuple[Tensor, Tensor]:
    """Part of the residual that shapes explain, b^T (s^2 + F)^-1 b, and log det(1 + F / s^2), for each share.

    The Cholesky decomposition is written out, because exported graphs do not have it and the matrices are small.

    Args:
        bend: F, (n_table, n, k, k).
        slope: b, (n_table, n, k).
        shares: s^2, (n, n_share).

    Returns:
        Two of (n_table, n, n_share).
    """
    lower: dict[tuple[int, int], Tensor] = {}
    solved: list[Tensor] = []
    for i in range(slope.shape[-1]):
        for j in range(i + 1):
            value = bend[..., i, j, None] + (shares if i == j else torch.zeros_like(shares))
            for m in range(j):
                value = value - lower[i, m] * lower[j, m]
            # Rounding must not make a pivot smaller than what was added.
            lower[i, j] = torch.maximum(value, shares).sqrt() if i == j else value / lower[j, j]
        right = slope[..., i, None]
        for m in range(i):
            right = right - lower[i, m] * solved[m]
        solved.append(right / lower[i, i])
    explained = torch.stack([each.square() for each in solved]).sum(0)
    determinant = 2 * torch.stack([lower[i, i].log() for i in range(len(solved))]).sum(0)
    return explained, determinant - len(solved) * shares.log()
