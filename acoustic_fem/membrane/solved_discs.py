"""Discs that were solved once: one takes about a twentieth of a second, and nearly every command asks for some.

They are kept in this process and, as cells are, on disk.
"""

from __future__ import annotations

from dataclasses import asdict, fields
from functools import lru_cache
from typing import Any

import numpy as np

from acoustic_fem.membrane.elasticity import MODES, REFINEMENT, ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.numerics import disk_cache

DISC_MODEL_VERSION = 3
"""To be raised with every change of :mod:`acoustic_fem.membrane.elasticity` that changes a number."""


@lru_cache(maxsize=256)
def solved_disc(shape: DiscShape, refinement: int = REFINEMENT) -> ElasticDisc:
    """Disc of a shape, solved where nobody did before; arguments as of
    :func:`acoustic_fem.membrane.elasticity.solve_dimensionless`.
    """
    key = _key(shape, refinement)
    kept = disk_cache.fetch(key)
    if kept is not None:
        record: dict[str, Any] = {**kept[0], **kept[1]}
        return ElasticDisc(**record)
    disc = solve_dimensionless(shape, refinement)
    values: dict[str, Any] = {each.name: getattr(disc, each.name) for each in fields(disc)}
    arrays = {name: value for name, value in values.items() if isinstance(value, np.ndarray)}
    disk_cache.store(key, arrays, {name: value for name, value in values.items() if name not in arrays})
    return disc


def is_kept(shape: DiscShape) -> bool:
    """True if a disc of this shape is on disk."""
    return disk_cache.holds(_key(shape, REFINEMENT))


def _key(shape: DiscShape, refinement: int) -> str:
    return disk_cache.key_of({"disc": DISC_MODEL_VERSION, "refinement": refinement, "modes": MODES, **asdict(shape)})
