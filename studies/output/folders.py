"""Results on disk: a file is whole or not there, and nobody else's files are touched.

A refusal names an argument other than its first word in backticks: the command line makes an option of it.
"""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from geometry.files.writing import write_text
from geometry.refusal import Refusal

#: Marks a folder as the result of a run, which a later run may replace.
MARK = ".acoustic-fem-run"
#: Lists what was put into a folder that may hold files of others too.
FILES = "files.txt"
#: What a run writes: the design first, the report last.
DESIGN = "design.toml"
RESULTS = ("library.nc", "parts", "localizer", "figures")
REPORT = ("report.html", "results.json")


def claim_folder(out: str | os.PathLike[str], design: str) -> Path:
    """Folder of a run, made or taken over from an earlier one.

    The report of the earlier run is removed; where it was of another design, so is everything else that it made, the
    design file last, so that no folder ever holds results of two designs.

    Args:
        out: the folder.
        design: the complete design file of the new run, which is written.

    Raises:
        Refusal: it is a file, it holds what no run made, or it cannot be written.
    """
    folder = Path(out)
    check_folder(folder)
    if folder.is_dir() and any(folder.iterdir()) and not (folder / MARK).is_file():
        raise Refusal(
            f"{folder}: holds files that no run of this program made; `out` must be a new or empty folder, or one of "
            "an earlier run"
        )
    folder.mkdir(parents=True, exist_ok=True)
    (folder / MARK).write_text("Made by acoustic-fem run, which replaces what lies here when it runs again.\n")
    of_earlier = folder / DESIGN
    same = of_earlier.is_file() and of_earlier.read_text(encoding="utf-8", errors="replace") == design
    for name in REPORT if same else (*REPORT, *RESULTS, DESIGN):
        _remove(folder / name)
    write_text(of_earlier, design)
    return folder


def check_new_file(path: Path | None, kept: str | None = None, option: str = "out") -> None:
    """Refuse a file that cannot be written, before any work is done for it.

    Args:
        path: of the file; none is nothing to write.
        kept: what it is, where such a file is never overwritten: a design that somebody may have changed, a library
            that nobody can compute again. By default an earlier file is replaced.
        option: name of the argument by which it was given.

    Raises:
        Refusal: it is a folder, exists and is kept, or its own folder does not exist or cannot be written to.
    """
    if path is None:
        return
    if path.is_dir():
        raise Refusal(f"{path}: is a folder; `{option}` must be a file")
    if kept is not None and path.exists():
        raise Refusal(f"{path}: exists, and {kept} is never overwritten; name another file, or remove this one")
    if not path.parent.is_dir():
        raise Refusal(f"{path}: `{option}` must lie in a folder that exists; there is no {path.parent}")
    _check_writable(path, path.parent, option)


def check_new_library(path: Path, formats: Sequence[str]) -> None:
    """Refuse the file of a library that cannot be written: what can be computed is replaced, what was measured is kept.

    Args:
        path: of the file.
        formats: suffixes that its name may have.

    Raises:
        Refusal: another suffix, a measured library, or a file that cannot be written.
    """
    if path.suffix.lower() not in formats and not path.is_dir():
        raise Refusal(f"{path}: `out` must be a library, {' or '.join(formats)}")
    check_new_file(path, kept="a measured library" if _is_measured(path) else None)


def _is_measured(path: Path) -> bool:
    from acoustic_fem.library.exchange import load_exchanged
    from acoustic_fem.library.netcdf_file import LibraryError
    from acoustic_fem.library.result import MEASURED

    try:
        return load_exchanged(path).fidelity == MEASURED
    except LibraryError:  # no file, or no library
        return False


def check_folder(path: Path) -> None:
    """Refuse a folder that cannot be made, before any work is done for it.

    Raises:
        Refusal: it, or a folder on the way to it, is a file or cannot be written to.
    """
    place = next(folder for folder in (path, *path.absolute().parents) if folder.exists())
    if not place.is_dir():
        raise Refusal(f"{path}: `out` must be a folder; {place} is a file")
    _check_writable(path, place, "out")


@contextmanager
def replaced_folder(folder: Path) -> Iterator[Path]:
    """Empty folder beside, which takes the place of ``folder`` when all went well, and is removed when not.

    The old folder is kept until the new one is in its place.
    """
    fresh, old = (folder.with_name(f".{folder.name}.{word}") for word in ("new", "old"))
    _remove(fresh)
    fresh.mkdir(parents=True)
    try:
        yield fresh
        _remove(old)
        if folder.exists():
            os.replace(folder, old)
        try:
            os.replace(fresh, folder)
        except BaseException:
            if old.exists():
                os.replace(old, folder)
            raise
        _remove(old)
    finally:
        _remove(fresh)


@contextmanager
def replaced_files(folder: Path) -> Iterator[Path]:
    """Empty folder whose files move into ``folder`` when all went well, and are removed when not.

    What an earlier call put there goes, so that no folder holds files of two designs; files of others stay. Both are
    told apart by the list ``files.txt``: whenever a call is stopped, it names all that calls have put there.

    Raises:
        Refusal: the list names what is no file of the folder.
    """
    fresh, listed = folder / ".files.new", folder / FILES
    earlier = set(listed.read_text(encoding="utf-8").splitlines()) if listed.is_file() else set()
    for name in sorted(earlier):
        if name in ("", ".", "..") or Path(name).name != name:
            raise Refusal(f"{listed}: {name!r} must be the name of a file in {folder}; remove the list or mend it")
    folder.mkdir(parents=True, exist_ok=True)
    _remove(fresh)
    fresh.mkdir()
    try:
        yield fresh
        names = {path.name for path in fresh.iterdir()} | {FILES}
        _write_list(listed, earlier | names)
        for name in names - {FILES}:
            os.replace(fresh / name, folder / name)
        for name in earlier - names:
            (folder / name).unlink(missing_ok=True)
        _write_list(listed, names)
    finally:
        _remove(fresh)


def _write_list(path: Path, names: set[str]) -> None:
    write_text(path, "".join(f"{name}\n" for name in sorted(names)))


def _check_writable(path: Path, place: Path, option: str) -> None:
    # A file without a name is tried: the permission bits say nothing of /proc or of a full or read-only disk.
    try:
        with tempfile.TemporaryFile(dir=place):
            pass
    except OSError as error:
        reason = error.strerror or str(error)
        raise Refusal(f"{path}: `{option}` cannot be written: {reason}: {place}") from None


def _remove(path: Path) -> None:
    """Remove a file or a folder, if it is there."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write plain values as JSON; numbers that are not finite are refused."""
    write_text(path, json.dumps(content, indent=1, allow_nan=False) + "\n")
