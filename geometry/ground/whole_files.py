"""Files that appear whole or not at all: written beside, then renamed; or line by line."""

from __future__ import annotations

import errno
import os
import re
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from geometry.ground.file_checks import check_local
from geometry.ground.refusal import Kind, Refusal

FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""Error numbers of the system where nothing more can be written: to the disk, by this user, or to a file so long."""
#: Bytes that are tried where a library failed: more than any of them leaves of a full disk.
_TRIED = 1 << 20


@contextmanager
def whole_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Path to write to; the file there replaces ``path`` when the block ends without an error.

    The name keeps the suffix, from which libraries infer the format. Whatever stops the block, an earlier file
    stays as it was and nothing is left beside it.

    Args:
        path: the file; its folder must exist.

    Raises:
        Refusal: the path is the address of a store.
        OSError: the disk is full, whatever the library says that met it; names the file.
    """
    check_local(path)
    path = Path(path)
    with suppress(FileNotFoundError):
        path.lstat()  # a name that is too long is reported for the file itself, before anything is written
    # Only a part of the name: nothing could be added to a name that is as long as can be.
    beside = path.with_name(f".{path.stem[:40]}.{os.getpid()}{path.suffix}")
    beside.unlink(missing_ok=True)  # whatever is there, such as a link, which would be followed
    try:
        yield beside
        # Without this a power cut may leave the new name before its content.
        with open(beside, "rb") as written:
            os.fsync(written.fileno())
        os.replace(beside, path)
    except Exception as error:
        full = _full(beside, error)
        if full is not None:
            raise OSError(full, os.strerror(full), str(path)) from error
        raise
    finally:
        beside.unlink(missing_ok=True)


def leftovers(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Files beside a path that :func:`whole_file` left there because the process was killed while it wrote.

    Another process may be writing one of them just now: they belong to whoever holds a lock of the place.
    """
    path = Path(path)
    name = re.compile(rf"\.{re.escape(path.stem[:40])}\.\d+{re.escape(path.suffix)}")
    with suppress(OSError):
        yield from (found for found in path.parent.iterdir() if name.fullmatch(found.name))


def made_folder(path: str | os.PathLike[str]) -> Path:
    """The folder, made with all above it where it is missing.

    Raises:
        Refusal: the path is the address of a store.
    """
    check_local(path)
    path = Path(path)
    path.mkdir(parents=True, exist_ok=True)
    return path


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """New folder for temporary files, which is removed with its content when the block ends.

    Raises:
        OSError: its disk is full, whatever the library says that met it; names the folder and says what to set.
    """
    remedy = "temporary files need room there: set TMPDIR to a folder with more"
    try:
        place = tempfile.TemporaryDirectory()
    except FileNotFoundError:  # every folder that may be one was tried
        where = os.environ.get("TMPDIR", "/tmp")
        raise OSError(errno.ENOSPC, f"no file can be made; {remedy}", where) from None
    with place as name:
        try:
            yield Path(name)
        except Refusal:
            raise
        except Exception as error:
            full = _full(Path(name, "room"), error)
            if full is None:
                raise
            raise OSError(full, f"{os.strerror(full)}; {remedy}", os.path.dirname(name)) from error


@contextmanager
def writing(path: str | os.PathLike[str]) -> Iterator[None]:
    """Name a file or folder in what the system says of a disk that is full; a name that it says itself stays."""
    try:
        yield
    except OSError as error:
        if error.filename is None and error.errno in FULL:
            error.filename = os.fspath(path)
        raise


@contextmanager
def whole_lines(path: str | os.PathLike[str]) -> Iterator[Callable[[str], None]]:
    """Function that writes the next line of a new file: each line is there whole or not at all, also on a full disk.

    Args:
        path: the file; an earlier one is replaced, also where the name is a link, whose file stays.

    Raises:
        OSError: the disk is full; names the file.
    """
    check_local(path)
    Path(path).unlink(missing_ok=True)
    with writing(path), open(path, "wb", buffering=0) as file:

        def write(line: str) -> None:
            end, rest = file.tell(), f"{line}\n".encode()
            try:
                while rest:  # of a line for which a disk has no more room its beginning is written
                    rest = rest[file.write(rest) :]
            except BaseException:
                file.truncate(end)
                raise

        yield write


def _full(beside: Path, error: Exception) -> int | None:
    """Error number of a full disk, where that is why something failed; else None.

    Libraries that write files themselves seldom hand it on: HDF5 says "HDF error", others write half a file in
    silence, which is then not what should be in it. So a little more is written, where they failed.
    """
    if isinstance(error, OSError) and error.errno in FULL:
        return error.errno
    try:
        with open(beside, "ab") as file:
            file.write(bytes(_TRIED))
            file.flush()
            os.fsync(file.fileno())
    except OSError as found:
        return found.errno if found.errno in FULL else None
    return None


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write a text in UTF-8, whole or not at all; lines end with a line feed on every system."""
    with whole_file(path) as beside:
        beside.write_text(text, encoding="utf-8", newline="\n")


def replace_section(path: str | os.PathLike[str], begin: str, end: str, lines: Sequence[str]) -> None:
    """Put lines between two marks of a text, in place of what stands there; the marks stay.

    Raises:
        Refusal: the marks do not stand in the text once each, in this order.
    """
    text = Path(path).read_text(encoding="utf-8")
    before, found, rest = text.partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed or begin in rest:
        problem = f"must have {begin!r} once and after it {end!r} once"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path)
    write_text(path, "\n".join([before + begin, *lines, end + after]))


def check_own_kind(path: str | os.PathLike[str], suffix: str, refusal: type[Refusal]) -> None:
    """Refuse to write over a file whose name ends as that of another kind: a recording, a picture.

    Args:
        path: the file to write.
        suffix: end of the names of its kind, such as ``.nc``.
        refusal: class of the errors.

    Raises:
        Refusal: of that class: a file is there, and its name ends otherwise.
    """
    path = Path(path)
    if path.exists() and not path.is_dir() and path.suffix.lower() != suffix:
        raise refusal(
            f"exists, and only a {suffix} file is replaced",
            kind=Kind.EXISTS,
            file=path,
            remedy="name another file, or remove this one",
        )
