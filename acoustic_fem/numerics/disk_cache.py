"""Solved cells and discs on disk, under a hash of everything they depend on.

The folder is ``$ACOUSTIC_FEM_CACHE``, else the user's cache folder. Each is a record under its key: a file that is
cut short, altered, foreign or that of another cell under this one's name is recognised; a warning says so, and the
cell is solved again.
"""

from __future__ import annotations

import json
import os
import warnings
from pathlib import Path
from typing import Any

import platformdirs
from numpy.typing import NDArray

from geometry.ground.record import packed, read_record, sha256, unpacked, write_record
from geometry.ground.refusal import Refusal

_KIND = "cell 2"


class CacheWarning(UserWarning):
    """A cached cell or its folder that cannot be used: it costs time, and changes no result."""


def cache_folder() -> Path:
    """Folder in which solved cells and discs are kept."""
    configured = os.environ.get("ACOUSTIC_FEM_CACHE")
    return Path(configured) if configured else Path(platformdirs.user_cache_dir("acoustic-fem")) / "cells"


def key_of(description: dict[str, Any]) -> str:
    """Hash of a description made of plain values; floats count with all their digits."""
    return sha256(json.dumps(description, sort_keys=True))


def store(key: str, arrays: dict[str, NDArray], about: dict[str, Any]) -> None:
    """Keep arrays of any shape and plain values under a key.

    A folder that cannot be written loses no work: a warning says so, and the cell is not kept.
    """
    folder = cache_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        write_record(folder / f"{key}.cell", _KIND, key, packed(arrays, about))
    except OSError as error:
        warnings.warn(
            f"{folder}: cannot be written ({error.strerror or error}); what was solved is not kept. "
            "ACOUSTIC_FEM_CACHE names the folder",
            CacheWarning,
            stacklevel=2,
        )


def holds(key: str) -> bool:
    """True if there is a file for this key; whether it is usable shows :func:`fetch`."""
    return (cache_folder() / f"{key}.cell").is_file()


def fetch(key: str, folder: Path | None = None) -> tuple[dict[str, NDArray], dict[str, Any]] | None:
    """Arrays, of the shape of what :func:`store` wrote, and plain values; None where there is nothing usable."""
    path = (folder or cache_folder()) / f"{key}.cell"
    try:
        if not os.path.lexists(path):
            return None
        return unpacked(read_record(path, _KIND, key, Refusal))
    except Refusal as error:
        warnings.warn(f"{error}; the cell is solved again", CacheWarning, stacklevel=2)
        return None
