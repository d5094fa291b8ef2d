"""Results on disk: a file is whole or not there, and nobody else's files are touched.

The place of a result is checked here for every call that takes an ``out``: a file that is read, was measured or is of
another kind is never written over, and a folder that holds anything is written into only by what made it.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import acoustic_fem
from geometry.ground.extras import NotInstalled, check_extras
from geometry.ground.figures import quiet_fonts
from geometry.ground.file_checks import check_local, ordinary_file, read_bytes
from geometry.ground.refusal import Field, Kind, Refusal, said_by
from geometry.ground.stated_times import stopped_time
from geometry.ground.text_files import LARGEST_TEXT, read_text
from geometry.ground.whole_files import leftovers, write_text
from studies.output.sole_writer import sole_writer_of, sole_writer_of_file

#: Marks a folder as the result of a run, which a later run may replace.
MARK = ".acoustic-fem-run"
#: Lists what was put into a folder that may hold files of others too.
FILES = "files.txt"
#: What a run writes: the design first, the report and the list of all files last.
DESIGN = "design.toml"
RESULTS = ("library.nc", "parts", "localizer", "figures")
REPORT = ("report.html", "results.json")
MANIFEST = "MANIFEST.json"


PICTURES = (".png", ".pdf", ".svg", ".jpg", ".jpeg", ".tif", ".tiff", ".webp", ".eps", ".ps")
"""Suffixes of the formats of pictures."""

Files = Iterable[str | os.PathLike[str] | None]
"""Files and folders that a call reads; None for one that is not given."""
_ANOTHER_FILE = "name another file, or remove this one"


def claim_folder(out: str | os.PathLike[str], design: str) -> Path:
    """Folder of a run, made or taken over from an earlier one.

    The report of the earlier run is removed; where it was of another design, so is everything else that it made, the
    design file last, so that no folder ever holds results of two designs.

    Args:
        out: the folder.
        design: the complete design file of the new run, which is written.

    Raises:
        Refusal: it is a file, it holds what no run made, its design was changed by hand or its library measured, or it
            cannot be written.
    """
    from acoustic_fem.library.exchange import fidelity_in

    folder = Path(out)
    check_folder(folder, "run", MARK)
    of_earlier, library, mark = folder / DESIGN, folder / RESULTS[0], folder / MARK
    found = read_bytes(of_earlier, "a design file", Refusal, LARGEST_TEXT) if of_earlier.is_file() else None
    made = mark.read_text(encoding="utf-8", errors="replace").split() if mark.is_file() else []
    digests = [word for word in made if len(word) == len(_digest(b""))]
    if found is not None and digests and _digest(found) not in digests and found != design.encode():
        problem = "was changed since a run wrote it, and would be replaced"
        raise Refusal(problem, kind=Kind.EXISTS, file=of_earlier, remedy="move it to another folder")
    if fidelity_in(library) == acoustic_fem.library.MEASURED:
        problem = "exists, and a measured library is never overwritten"
        raise Refusal(problem, kind=Kind.EXISTS, file=library, remedy="move it to another folder")
    # Both designs, for a run may be killed before the one takes the place of the other.
    known = dict.fromkeys(_digest(text) for text in (found, design.encode()) if text is not None)
    make_folder(folder, "run", MARK, known)
    same = found == design.encode()
    for name in (MANIFEST, *REPORT) if same else (MANIFEST, *REPORT, *RESULTS, DESIGN):
        _remove(folder / name)
    write_text(of_earlier, design)
    return folder


def check_new_file(
    path: Path | None, suffix: str = "", *, reads: Files = (), kept: str | None = None, option: str = "out"
) -> None:
    """Refuse a file that cannot be written, before any work is done for it.

    Args:
        path: of the file; none is nothing to write.
        suffix: such as ``.jsonl``: an earlier file with another end of its name is not ours and is kept.
        reads: files that are read, whatever names they have there and here.
        kept: what it is, where such a file is never overwritten: a design that somebody may have changed, a library
            that nobody can compute again. By default an earlier file is replaced.
        option: name of the argument by which it was given.

    Raises:
        Refusal: it is the address of a store, a folder, no ordinary file or one that is read, exists and is kept, or
            its own folder does not exist or cannot be written to; or a picture, and nothing is installed that draws.
    """
    if path is None:
        return
    check_local(path, field=option)
    if path.suffix.lower() in PICTURES:
        check_extras(f"what draws {path}", "plots")
    if path.is_dir():
        raise Refusal("must be a file, not a folder", kind=Kind.EXISTS, file=path, field=Field(option))
    if kept is not None and path.exists():
        problem = f"exists, and {kept} is never overwritten"
        raise Refusal(problem, kind=Kind.EXISTS, file=path, field=Field(option), remedy=_ANOTHER_FILE)
    _check_not_read(path, reads, option)
    if suffix and path.exists() and path.suffix.lower() != suffix:
        problem = f"exists, and only a {suffix} file is replaced"
        raise Refusal(problem, kind=Kind.EXISTS, file=path, field=Field(option), remedy=_ANOTHER_FILE)
    if path.exists() and not path.is_file():
        raise Refusal("must be an ordinary file, or a new one", kind=Kind.EXISTS, file=path, field=Field(option))
    if not path.parent.is_dir():
        problem = f"must lie in a folder that exists; there is no {path.parent}"
        raise Refusal(problem, kind=Kind.MISSING, file=path, field=Field(option))
    _check_writable(path, path.parent, option)


def as_picture(path: str | os.PathLike[str], option: str = "out") -> Path:
    """Path of the file of a picture: a name without a suffix gets ``.png``.

    Args:
        path: of the file.
        option: name of the argument by which it was given.

    Raises:
        Refusal: its suffix is not that of a format of pictures.
    """
    path = Path(path)
    if path.is_dir():
        return path
    if not path.suffix:
        path = path.with_name(f"{path.name}.png")
    if path.suffix.lower() not in PICTURES:
        allowed = f"a picture, which ends in {', '.join(PICTURES[:-1])} or {PICTURES[-1]}"
        raise Refusal(kind=Kind.OUT_OF_RANGE, file=path, field=Field(option), allowed=allowed)
    return path


def new_picture(
    path: str | os.PathLike[str] | None, *, reads: Files = (), option: str = "out", kept: str | None = None
) -> Path | None:
    """Path of a picture that can be drawn and written, as of :func:`as_picture`; None where none is asked for.

    Arguments are those of :func:`check_new_file`.

    Raises:
        Refusal: as :func:`as_picture` and :func:`check_new_file`, or :func:`check_drawing`.
    """
    if path is None:
        return None
    drawn = as_picture(path, option)
    check_new_file(drawn, drawn.suffix.lower(), reads=reads, option=option, kept=kept)
    check_drawing()
    return drawn


def check_drawing() -> None:
    """Refuse to draw where matplotlib does not start or write, because of what is around it.

    Raises:
        Refusal: ``MPLBACKEND`` or ``SOURCE_DATE_EPOCH`` has a wrong value, or a matplotlibrc cannot be read.
    """
    stopped_time()
    quiet_fonts()
    for path in ("matplotlibrc", os.environ.get("MATPLOTLIBRC", "")):  # matplotlib would wait for a pipe without end
        if os.path.exists(path) and not os.path.isdir(path) and path != os.devnull:
            ordinary_file(path, "a matplotlibrc", Refusal, LARGEST_TEXT)
    try:
        import matplotlib  # noqa: F401  # whether it starts is the question
    except NotInstalled:
        raise
    except ValueError as error:
        field = "MPLBACKEND" if "backend" in str(error) else "matplotlibrc"
        problem = f"keeps matplotlib from starting: {said_by(error)}"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field=field) from None


def is_own_table(path: Path, columns: Sequence[str]) -> bool:
    """True if a CSV file is not there, or has the header of a table of ours: recordings may be CSV as well.

    Args:
        path: of the file.
        columns: of the table.
    """
    if not path.is_file():
        return True
    header = ",".join(columns).encode() + b"\n"
    with suppress(OSError), path.open("rb") as file:
        return file.read(len(header)) == header
    return False


def check_new_library(path: Path, formats: Sequence[str], reads: Files = (), others: str = "") -> None:
    """Refuse the file of a library that cannot be written: what can be computed is replaced, all else is kept.

    Args:
        path: of the file.
        formats: suffixes that its name may have.
        reads: files that are read.
        others: what else the call can write, as words behind the formats.

    Raises:
        Refusal: another suffix, a measured library, a file that is read or no library, or one that cannot be written.
    """
    from acoustic_fem.library.exchange import check_replaceable

    check_local(path, field="out")
    if path.suffix.lower() not in formats and not path.is_dir():
        allowed = f"a library, {' or '.join(formats)}{others}"
        raise Refusal(kind=Kind.OUT_OF_RANGE, file=path, field=Field("out"), allowed=allowed)
    check_new_file(path, reads=reads)
    check_replaceable(path)


def check_folder(path: Path, maker: str | None = None, *marks: str, reads: Files = ()) -> None:
    """Refuse a folder that cannot be made or written into, before any work is done for it.

    Args:
        path: the folder.
        maker: verb that writes into it, and whose own earlier results may be there; None where the caller looks itself
            at what the folder holds.
        marks: files by one of which earlier results of the verb are known, which it writes before all others.
        reads: files and folders that are read.

    Raises:
        Refusal: it is the address of a store; it, or a folder on the way to it, is a file or cannot be written to; it
            holds a file that is read, or anything that no such call made.
    """
    check_local(path, field="out")
    place = next(folder for folder in (path, *path.absolute().parents) if folder.exists() or folder.is_symlink())
    if not place.is_dir():
        problem = f"must be a folder; {place} is a {'file' if place.exists() else 'link to nothing'}"
        raise Refusal(problem, kind=Kind.EXISTS, file=path, field=Field("out"))
    for read in reads:
        if read is not None and Path(read).exists() and Path(read).resolve().is_relative_to(path.resolve()):
            problem = f"holds {read}, which this command reads"
            raise Refusal(problem, kind=Kind.CONFLICT, file=path, field=Field("out"), remedy="name another folder")
    is_own = maker is None or not path.is_dir() or any((path / mark).is_file() for mark in marks)
    if not is_own and set(path.iterdir()) - set(_unfinished(path, marks)):
        raise Refusal(
            f"holds files that no {maker} of this program made",
            kind=Kind.EXISTS,
            file=path,
            field=Field("out"),
            remedy=f"name a new or empty folder, or one of an earlier {maker}",
        )
    _check_writable(path, place, "out")


def _unfinished(folder: Path, marks: Iterable[str]) -> Iterator[Path]:
    """Files and folders of a call that was killed before it had written one of the marks, or while it wrote one."""
    for mark in marks:
        yield from leftovers(folder / mark)
        if (fresh := _beside_list(folder, mark)).is_dir():
            yield fresh


@contextmanager
def claimed_folder(path: Path, maker: str, *marks: str, reads: Files = ()) -> Iterator[None]:
    """A folder to which nobody else writes while the block runs; arguments and errors as for :func:`check_folder`.

    Files that a killed call left half written are removed.

    Raises:
        Refusal: as there, or another process is writing to it.
    """
    check_folder(path, maker, *marks, reads=reads)
    with sole_writer_of(path, maker, Refusal):
        check_folder(path, maker, *marks, reads=reads)
        for left in list(_unfinished(path, marks)):
            _remove(left)
        yield


@contextmanager
def claimed_file(path: Path | None, check: Callable[[], None]) -> Iterator[None]:
    """A file that nobody else writes while the block runs.

    Args:
        path: of the file; none is nothing to write.
        check: refuses a file that must not be written, also one that another process has written in the meantime.

    Raises:
        Refusal: as ``check``, or another process is writing it.
    """
    check()
    if path is None:
        yield
        return
    with sole_writer_of_file(path, Refusal):
        check()
        for left in list(leftovers(path)):
            _remove(left)
        yield


def make_folder(path: Path, maker: str, mark: str, notes: Iterable[str] = ()) -> None:
    """Make a folder that :func:`check_folder` has passed, with a mark, for what has no file that is always there.

    Args:
        path: the folder.
        maker: what writes into it, and may do so again.
        mark: name of the file.
        notes: words that the mark shall hold too.
    """
    path.mkdir(parents=True, exist_ok=True)
    text = f"Made by acoustic-fem {maker}, which replaces what lies here when it runs again.\n"
    write_text(path / mark, text + "".join(f"{note}\n" for note in notes))


def _check_not_read(path: Path, reads: Files, option: str) -> None:
    """Refuse to write over what is read, whatever it is called: through links, and where case does not count."""
    for read in reads:
        if read is not None and path.exists() and Path(read).exists() and path.samefile(read):
            same = "an input of this command" if Path(read) == path else f"the same file as {read}, an input"
            problem = f"is {same}"
            raise Refusal(problem, kind=Kind.CONFLICT, file=path, field=Field(option), remedy="name another file")


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


@contextmanager
def replaced_folder(folder: Path) -> Iterator[Path]:
    """Empty folder beside, which takes the place of ``folder`` when all went well, and is removed when not.

    The old folder is kept until the new one is in its place.
    """
    fresh, old = (folder.with_name(f".{folder.name}.{word}") for word in ("new", "old"))
    _remove(fresh)
    fresh.mkdir(parents=True)
    try:
        with _called_as_in(folder, fresh):
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
def replaced_files(folder: Path, list_name: str = FILES) -> Iterator[Path]:
    """Empty folder whose files move into ``folder`` when all went well, and are removed when not.

    Folders in it are filled in the same way. Files of an earlier call are removed, so that no folder holds files of two
    designs; files of others stay. A list keeps them apart:
    whenever a call is stopped, it names all that calls have put there.

    Args:
        folder: the folder.
        list_name: name of the list, a text file in the folder; each command has its own.

    Raises:
        Refusal: the list contains a file that is not in the folder.
    """
    fresh, listed = _beside_list(folder, list_name), folder / list_name
    earlier = set(read_text(listed, "a list of files", Refusal).splitlines()) if listed.exists() else set()
    for name in sorted(earlier):
        inside = Path(name).as_posix() == name and ".." not in Path(name).parts and name not in ("", ".")
        if not (inside and (folder / name).parent.resolve().is_relative_to(folder.resolve())):
            problem = f"must be the name of a file in {folder}"
            raise Refusal(problem, kind=Kind.UNSUITABLE, file=listed, value=name, remedy="correct or remove the list")
    folder.mkdir(parents=True, exist_ok=True)
    _remove(fresh)
    fresh.mkdir()
    try:
        with _called_as_in(folder, fresh):
            yield fresh
        made = (path for path in fresh.rglob("*") if not path.is_dir())
        names = {path.relative_to(fresh).as_posix() for path in made} | {list_name}
        _check_inside(folder, names)
        _write_list(listed, earlier | names)
        for name in names - {list_name}:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            os.replace(fresh / name, folder / name)
        for name in earlier - names:
            (folder / name).unlink(missing_ok=True)
        _remove_empty(folder, earlier - names)
        _write_list(listed, names)
    finally:
        _remove(fresh)


def _check_inside(folder: Path, names: Iterable[str]) -> None:
    """Refuse to write through a link out of the folder, or into a file that has the name of a folder."""
    for place in sorted({(folder / name).parent for name in names}):
        if not place.resolve().is_relative_to(folder.resolve()) or (place.exists() and not place.is_dir()):
            problem = "must be a folder, because files are written into it"
            raise Refusal(problem, kind=Kind.EXISTS, file=place, remedy="move it to another folder")


def _remove_empty(folder: Path, names: Iterable[str]) -> None:
    """Remove folders in which files of an earlier call lay, if nothing is in them any more."""
    emptied = {above for name in names for above in (folder / name).parents if above != folder}
    for place in sorted(emptied & set(folder.rglob("*")), key=lambda path: -len(path.parts)):
        if not any(place.iterdir()):
            place.rmdir()


def _beside_list(folder: Path, list_name: str) -> Path:
    """Folder in which files are made before they are put on a list; it is left there if the process is killed."""
    return folder / f".{Path(list_name).stem}.new"


@contextmanager
def _called_as_in(folder: Path, fresh: Path) -> Iterator[None]:
    """Name what cannot be written as it would be called: nobody knows of the folder beside, which is gone then."""
    try:
        yield
    except OSError as error:
        named = error.filename
        if isinstance(named, (str, os.PathLike)) and Path(named).is_relative_to(fresh):
            error.filename = str(folder / Path(named).relative_to(fresh))
        raise


def _write_list(path: Path, names: set[str]) -> None:
    write_text(path, "".join(f"{name}\n" for name in sorted(names)))


def _check_writable(path: Path, place: Path, option: str) -> None:
    # A file without a name is tried: the permission bits say nothing of /proc or of a full or read-only disk.
    try:
        with tempfile.TemporaryFile(dir=place):
            pass
    except OSError as error:
        reason = error.strerror or str(error)
        problem = f"cannot be written: {reason}: {place}"
        raise Refusal(problem, kind=Kind.UNREADABLE, file=path, field=Field(option)) from None


def _remove(path: Path) -> None:
    """Remove a file or a folder, if it is there."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write plain values as JSON; numbers that are not finite are refused."""
    write_text(path, json.dumps(content, indent=1, allow_nan=False) + "\n")
