"""Channels of a file or a device for the microphones of an array: by their order, or as they are given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from geometry.ground.refusal import Field, Kind, Refusal, counted


def chosen_channels(
    microphones: Sequence[str],
    channels: Mapping[str, int] | None,
    available: int,
    what: str,
    refusal: type[Refusal] = Refusal,
) -> NDArray[np.int64]:
    """Channels of a device or a file, from 0, in the order of the microphones.

    Args:
        microphones: of the array.
        channels: microphone -> channel from 1; by default the first ones in order.
        available: how many there are.
        what: name of what has them, for the error.
        refusal: class of the error.

    Returns:
        (n_microphone,) int64.

    Raises:
        Refusal: by ``refusal``; a microphone is missing, unknown, or has a channel that is not there or another's.
    """
    given = channels or {name: number for number, name in enumerate(microphones, 1)}
    if set(given) != set(microphones) or len(set(given.values())) < len(given):
        stated = ",".join(f"{name}={number}" for name, number in given.items())
        allowed = f"a number each for {', '.join(microphones)}, all different"
        raise refusal(kind=Kind.OUT_OF_RANGE, field="channels", value=stated, allowed=allowed)
    for name, number in given.items():
        if not 1 <= number <= available:
            problem = f"is not there for microphone {name}: {what} has {counted(available, 'channel')}"
            raise refusal(problem, kind=Kind.MISSING, field="channels", value=number)
    return np.array([given[name] - 1 for name in microphones])


def check_count(available: int, microphones: Sequence[str], path: Path, refusal: type[Refusal]) -> None:
    """Refuse a file whose channels have no names and are more or fewer than the microphones: which are they?

    Args:
        available: number of channels of the file.
        microphones: names of the array's microphones.
        path: of the file.
        refusal: class of the error.

    Raises:
        Refusal: by ``refusal``, with the argument that chooses channels where there are enough of them.
    """
    if available == len(microphones):
        return
    more = available > len(microphones)
    raise refusal(
        f"has {counted(available, 'channel')}, must have {len(microphones)}: {', '.join(microphones)}",
        kind=Kind.MISMATCH,
        file=path,
        remedy=("give the channel of each microphone by ", Field("channels")) if more else "",
    )
