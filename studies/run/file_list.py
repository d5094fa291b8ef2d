"""List of a run's files with their SHA-256, by which later changes to the folder are found."""

from __future__ import annotations

import hashlib
import os
import re
import stat
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from geometry.ground.file_checks import check_local, read_bytes
from geometry.ground.record import is_sealed, sealed
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import LARGEST_TEXT, parse_json
from geometry.ground.typed import PathLike
from studies.output.folders import MANIFEST, write_json

#: Version of the format.
_FORMAT = 1
_DIGEST = re.compile(r"[0-9a-f]{64}")


@dataclass(frozen=True)
class FolderCheck:
    """Comparison of the folder of a run with what the run wrote."""

    folder: Path
    """The folder."""
    unchanged: tuple[str, ...]
    """Files that are as the run wrote them, in the order of their names, as are all."""
    changed: tuple[str, ...]
    """Files with another content, and names under which there is a link, a pipe or a device now."""
    missing: tuple[str, ...]
    """Files that are not there."""
    extra: tuple[str, ...]
    """Files that the run did not write."""

    @property
    def complete(self) -> bool:
        """True if the folder holds exactly the files that the run wrote."""
        return not (self.changed or self.missing or self.extra)


class _Listed(NamedTuple):
    size: int
    digest: str


def write_file_list(folder: Path, names: Sequence[str]) -> None:
    """Write ``MANIFEST.json``: size and SHA-256 of files of a run.

    Args:
        folder: of the run.
        names: files in it, and folders of which every file is listed.

    Raises:
        OSError: a file cannot be read, or the list cannot be written.
    """
    found = {name: path for name, path in sorted(_entries(folder)) if name.split("/")[0] in names}
    files = {name: {"bytes": path.stat().st_size, "sha256": _digest(path)} for name, path in found.items()}
    write_json(folder / MANIFEST, sealed({"program": "acoustic-fem run", "format": _FORMAT, "files": files}))


def verify_run(folder: PathLike) -> FolderCheck:
    """Comparison of the folder of a run with its ``MANIFEST.json``: changed, missing and extra files.

    It finds damage and later changes. It does not replace a signature, because a person who can write to the folder can
    also write another list.

    Args:
        folder: of :func:`studies.run_design`.

    Raises:
        Refusal: there is no such folder, its list is missing, damaged, or of another version, or a file cannot be read.
    """
    check_local(folder, field="folder")
    folder = Path(folder)
    if not folder.is_dir():
        problem = "is a file, must be the folder of a run" if folder.exists() else "there is no such folder"
        kind = Kind.WRONG_TYPE if folder.exists() else Kind.MISSING
        raise Refusal(problem, kind=kind, file=folder)
    listed = _read_manifest(folder)
    found = {name: path for name, path in _entries(folder) if name != MANIFEST}
    common = sorted(listed.keys() & found.keys())
    unchanged = [name for name in common if _is_as_listed(found[name], listed[name])]
    return FolderCheck(
        folder=folder,
        unchanged=tuple(unchanged),
        changed=tuple(name for name in common if name not in unchanged),
        missing=tuple(sorted(listed.keys() - found.keys())),
        extra=tuple(sorted(found.keys() - listed.keys())),
    )


def _read_manifest(folder: Path) -> dict[str, _Listed]:
    """Size and hash of each listed file by its name; each is checked, and so are the names."""
    path = folder / MANIFEST
    if not path.is_symlink() and not path.exists():
        raise Refusal(kind=Kind.MISSING, file=path, remedy="give the folder of a run that ended")
    content: Any = parse_json(read_bytes(path, "a list of files", Refusal, LARGEST_TEXT), str(path), Refusal)
    if not isinstance(content, dict) or not is_sealed(content):
        raise Refusal("is damaged: its SHA-256 differs from the recorded one", kind=Kind.DAMAGED, file=path)
    if content.get("format") != _FORMAT:
        problem = f"this version of the program reads format {_FORMAT}"
        raise Refusal(problem, kind=Kind.MISMATCH, file=path, field="format", value=content.get("format"))
    files = content.get("files")
    if not isinstance(files, dict):
        raise Refusal(kind=Kind.WRONG_TYPE, file=path, field="files", value=files, allowed="a table of files")
    return {name: _listed(path, name, entry) for name, entry in files.items()}


def _listed(path: Path, name: str, entry: Any) -> _Listed:
    size, digest = (entry.get(key) if isinstance(entry, dict) else None for key in ("bytes", "sha256"))
    if type(size) is int and size >= 0 and isinstance(digest, str) and _DIGEST.fullmatch(digest):
        return _Listed(size, digest)
    allowed = "its number of bytes and its SHA-256"
    raise Refusal(kind=Kind.WRONG_TYPE, file=path, field=f"files.{name}", value=entry, allowed=allowed)


def _entries(folder: Path) -> Iterator[tuple[str, Path]]:
    """Whatever lies in a folder and below, folders left out, by its name with slashes; links are not followed."""
    for above, folders, files in os.walk(folder, onerror=_raise):
        links = [name for name in folders if Path(above, name).is_symlink()]
        for name in (*files, *links):
            path = Path(above, name)
            yield path.relative_to(folder).as_posix(), path


def _raise(error: OSError) -> None:
    raise error


def _is_as_listed(path: Path, listed: _Listed) -> bool:
    status = path.lstat()
    return stat.S_ISREG(status.st_mode) and status.st_size == listed.size and _digest(path) == listed.digest


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
