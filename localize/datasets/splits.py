"""Splits by design: a case is of the training, the validation or the test set, never of two of them.

The split of a case depends on a seed and on the key of its design alone: it stays the same when cases are added, and
equal designs are always of one split.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from geometry.ground.argument_checks import check_choice
from geometry.ground.record import sha256
from geometry.ground.refusal import Kind, Refusal
from localize.signals.random_streams import Purpose

#: Name of a split.
Split = Literal["train", "validation", "test"]
SPLITS: tuple[Split, ...] = get_args(Split)
"""Names of the splits, in the order of their shares."""
DEFAULT_SHARES: Mapping[Split, float] = {"train": 0.8, "validation": 0.1, "test": 0.1}
"""Share of the cases that each split has where a caller gives none."""
#: Touches of two splits never share a random number, not even those on the same array.
PURPOSE_OF: Mapping[Split, Purpose] = {"train": "training", "validation": "held-out", "test": "evaluation"}


def split_of(keys: Sequence[str], seed: int = 0, shares: Mapping[Split, float] = DEFAULT_SHARES) -> NDArray[np.str_]:
    """Split of each case, by the key of its design and the seed alone.

    Args:
        keys: text of each case; equal designs have equal ones.
        seed: any non-negative integer.
        shares: fraction of the cases in each split, one in all.

    Returns:
        (n,) text, each one of :data:`SPLITS`.

    Raises:
        Refusal: shares that are below zero, do not make one, or name no split.
    """
    check_shares(shares)
    part = np.array([shares.get(name, 0.0) for name in SPLITS], np.float64)
    drawn = [int(sha256(f"{seed}\n{key}")[:8], 16) / 2.0**32 for key in keys]
    place = np.searchsorted(np.cumsum(part[:-1]), drawn, "right")
    return np.array(SPLITS)[place]


def check_shares(shares: Mapping[Split, float]) -> None:
    """Refuse shares of splits that are below zero, do not make one, or name no split.

    Raises:
        Refusal: they do.
    """
    for name in shares:
        check_choice("shares", name, SPLITS)
    part = np.array(list(shares.values()), np.float64)
    if not (np.isfinite(part).all() and (part >= 0).all() and abs(part.sum() - 1) < 1e-9):
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="shares",
            value=dict(shares),
            allowed=f"fractions of {', '.join(SPLITS)}, zero or above, one in all",
        )
