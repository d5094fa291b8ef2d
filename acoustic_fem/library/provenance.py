"""Origin of a result: code, libraries, seed and time, stored with every result."""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Sequence
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from geometry.ground.stated_times import stated_time
from geometry.ground.typed import Array


def versions(seed: int | None, libraries: Sequence[str]) -> dict[str, Any]:
    """Plain values that say what made a result.

    Args:
        seed: of the random numbers, None where there are none.
        libraries: distributions whose versions matter.
    """
    return {
        "code_version": _installed("acoustic-fem"),
        "created": stated_time().isoformat(timespec="seconds"),
        "seed": seed,
        "python": platform.python_version(),
        "libraries": {name: _installed(name) for name in libraries},
    }


def library_provenance(frequency: Array, libraries: Sequence[str]) -> dict[str, Any]:
    """Plain values that every library states of itself: what made it, and the hash of its grid.

    Args:
        frequency: (n_freq,) Hz.
        libraries: distributions whose versions matter.
    """
    return {**versions(None, libraries), "frequency_sha256": frequency_hash(frequency)}


def frequency_hash(frequency: Array) -> str:
    """SHA-256 of a grid of frequencies, (n_freq,) float64, Hz; hexadecimal."""
    return hashlib.sha256(frequency.tobytes()).hexdigest()


@cache  # read from the installation's files: a third of a lumped solve
def _installed(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"
