"""Results on disk: a file is whole or not there, and nobody else's files are touched."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

#: Marks a folder as the result of a run, which a later run may replace.
MARK = ".acoustic-fem-run"


def claim_folder(out: str | os.PathLike[str]) -> Path:
    """Make the folder of a run, or take over that of an earlier one, whose report is removed.

    Raises:
        ValueError: it is a file, or it holds what no run made.
    """
    folder = Path(out)
    check_folder(folder)
    if folder.is_dir() and any(folder.iterdir()) and not (folder / MARK).is_file():
        raise ValueError(
            f"{folder}: holds files that no run of this program made; --out must be a new or empty folder, or one of "
            "an earlier run"
        )
    folder.mkdir(parents=True, exist_ok=True)
    (folder / MARK).write_text("Made by acoustic-fem run, which replaces what lies here when it runs again.\n")
    for stale in ("report.html", "results.json"):
        (folder / stale).unlink(missing_ok=True)
    return folder


def check_new_file(path: Path | None) -> None:
    """Refuse a file that cannot be written, before any work is done for it.

    Raises:
        ValueError: it is a folder, or its own folder does not exist or cannot be written to.
    """
    if path is None:
        return
    if path.is_dir():
        raise ValueError(f"{path}: is a folder; --out must be a file")
    if not path.parent.is_dir():
        raise ValueError(f"{path}: --out must lie in a folder that exists; there is no {path.parent}")
    if not os.access(path.parent, os.W_OK):
        raise ValueError(f"{path}: --out cannot be written: no permission to write to {path.parent}")


def check_folder(path: Path) -> None:
    """Refuse a folder that cannot be made, before any work is done for it.

    Raises:
        ValueError: it, or a folder on the way to it, is a file or cannot be written to.
    """
    place = next(folder for folder in (path, *path.absolute().parents) if folder.exists())
    if not place.is_dir():
        raise ValueError(f"{path}: --out must be a folder; {place} is a file")
    if not os.access(place, os.W_OK):
        raise ValueError(f"{path}: --out cannot be written: no permission to write to {place}")


@contextmanager
def replaced_folder(folder: Path) -> Iterator[Path]:
    """An empty folder beside, which takes the place of ``folder`` when all went well."""
    fresh = folder.with_name(f".{folder.name}.new")
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    yield fresh
    if folder.exists():
        shutil.rmtree(folder)
    os.replace(fresh, folder)


def write_text(path: Path, text: str) -> None:
    """Write a file beside, then rename it."""
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        beside.write_text(text, encoding="utf-8")
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write plain values; numbers that are not finite are refused."""
    write_text(path, json.dumps(content, indent=1, allow_nan=False) + "\n")
