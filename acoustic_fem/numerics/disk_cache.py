"""Solved cells and discs on disk, under a hash of everything they depend on.

The folder is ``$ACOUSTIC_FEM_CACHE``, else the user's cache folder. A file that is cut short, altered,
foreign or that of another cell under this one's name is recognised by its checksum, which covers the key;
it is said so, and made again.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import platformdirs
from numpy.typing import NDArray

_MAGIC = b"acoustic-fem cell 2\n"


class CacheWarning(UserWarning):
    """A cached cell or its folder that cannot be used: it costs time, and changes no result."""


def cache_folder() -> Path:
    """Folder in which solved cells and discs are kept."""
    configured = os.environ.get("ACOUSTIC_FEM_CACHE")
    return Path(configured) if configured else Path(platformdirs.user_cache_dir("acoustic-fem")) / "cells"


def key_of(description: dict[str, Any]) -> str:
    """Hash of a description made of plain values; floats count with all their digits."""
    return hashlib.sha256(json.dumps(description, sort_keys=True).encode()).hexdigest()


def store(key: str, arrays: dict[str, NDArray], about: dict[str, Any]) -> None:
    """Write arrays of any shape and plain values under a key; the file appears whole or not at all.

    A folder that cannot be written loses no work: it is said in a warning, and the cell is not kept.
    """
    buffer = io.BytesIO()
    named: dict[str, Any] = {**arrays, "about": np.array(json.dumps(about))}
    np.savez(buffer, **named)
    content = buffer.getvalue()
    folder = cache_folder()
    beside = folder / f"{key}.{os.getpid()}.part"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        try:
            beside.write_bytes(_MAGIC + _checksum(key, content) + b"\n" + content)
            beside.replace(folder / f"{key}.cell")
        except OSError:
            with contextlib.suppress(OSError):
                beside.unlink()
            raise
    except OSError as error:
        warnings.warn(
            f"{folder}: cannot be written ({error.strerror or error}); what was solved is not kept. "
            "ACOUSTIC_FEM_CACHE names the folder",
            CacheWarning,
            stacklevel=2,
        )


def holds(key: str) -> bool:
    """Whether there is a file for this key; whether it is usable shows :func:`fetch`."""
    return (cache_folder() / f"{key}.cell").is_file()


def fetch(key: str, folder: Path | None = None) -> tuple[dict[str, NDArray], dict[str, Any]] | None:
    """Arrays, of the shape of what :func:`store` wrote, and plain values; None where there is nothing usable."""
    path = (folder or cache_folder()) / f"{key}.cell"
    try:
        raw = path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:
        reason = error.strerror or error
        warnings.warn(f"{path} cannot be read ({reason}); the cell is solved again", CacheWarning, stacklevel=2)
        return None
    head, _, content = raw[len(_MAGIC) :].partition(b"\n")
    if not raw.startswith(_MAGIC) or _checksum(key, content) != head:
        warnings.warn(f"{path} is damaged; the cell is solved again", CacheWarning, stacklevel=2)
        return None
    with np.load(io.BytesIO(content), allow_pickle=False) as archive:
        arrays = {name: archive[name] for name in archive.files}
    return arrays, json.loads(str(arrays.pop("about")))


def _checksum(key: str, content: bytes) -> bytes:
    return hashlib.sha256(key.encode() + b"\n" + content).hexdigest().encode()
