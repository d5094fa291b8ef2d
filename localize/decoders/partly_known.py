"""Tables for frames in which a part of the signal is not known, such as samples at which a microphone was clipped.

A frame is then x + A d, where the columns of A are known signals and nobody knows their amplitudes d. With a flat prior
of d, the likelihood is that of the part of the frame on which no column of A acts: its projection onto the directions
beside them. In coordinates where the noise is white it stays white there, so that the same Gaussians apply, with
covariances that are projected too.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from geometry.ground.typed import Array
from localize.decoders.likelihood import DecoderTables, GaussianTables

FEWEST = 16
"""Least number of directions of a frame that must be known, for anything to be located by them."""
NOTHING = 0.1
"""Size below which an unknown signal is neglected, by the noise of a direction."""


def known_directions(unknown: Array) -> tuple[Array, float]:
    """Directions of white frames on which no unknown signal acts.

    Args:
        unknown: signals with amplitudes of order 1 that are not known, (n, m) float64, where noise is white.

    Returns:
        Orthonormal rows, (k, n) float64, and the logarithm of the product of the sizes in the directions that are left
        out, by which the density of a frame is divided.
    """
    directions, sizes, _ = np.linalg.svd(unknown, full_matrices=True)
    acting = int((sizes > NOTHING).sum())
    return directions[:, acting:].T.copy(), float(np.log(sizes[:acting]).sum())


def partly_known_tables(tables: DecoderTables, kept: Array, left_out: float) -> DecoderTables:
    """Tables of the same covariances for frames of which only some directions are known.

    Args:
        tables: of whole frames.
        kept: orthonormal directions that are known, (k, n) float64.
        left_out: as of :func:`known_directions`.
    """
    options = tables.options
    # The power of each eigenvector at the weakest power that is tried, where no digit is lost.
    heard = -options.temperature * tables.weight[:, :, 0]
    value = heard / (1 - heard) / options.tried_powers[0]
    factor = kept @ (tables.vectors * np.sqrt(value)[:, None])
    few = GaussianTables.of(factor @ factor.swapaxes(1, 2), options)
    return DecoderTables(
        few.vectors,
        few.weight,
        few.log_determinant,
        reduce=tables.reduce @ kept.T,
        offset=tables.offset - left_out / options.temperature,
        # scores of one frame take less time than bounds of them
        options=replace(options, bound_directions=0),
    )
