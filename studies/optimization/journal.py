"""The trials of a search on disk: a journal of Optuna's, and a seal that tells whether it is still what was written."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from geometry.ground.file_checks import check_own_file, read_bytes
from geometry.ground.record import read_record, sha256, write_record
from geometry.ground.refusal import Kind, said_by
from geometry.ground.whole_files import temporary_folder
from studies.study.differences import other_table
from studies.study.parameter import StudyError

if TYPE_CHECKING:
    import optuna

JOURNAL = "trials.journal"
"""Name of the file of the trials in the folder of an optimisation."""
_SEAL = "trials.seal"
_LOCK = f"{JOURNAL}.lock"  # Optuna's own; it waits without end for one that is a link to nothing
_KIND = "search 2"
_LARGEST = 2_000_000_000
"""Most bytes of a journal; a trial has about a thousand."""


Directions = Sequence[Literal["minimize", "maximize"]]


@dataclass(frozen=True)
class Seal:
    """Contents of a journal when a batch was complete, and which of its designs turned out not to be printable."""

    bytes: int = 0
    """Length of the journal then."""
    sha256: str = ""
    """Hash of so many bytes of the journal."""
    unprintable: dict[int, str] = field(default_factory=dict)
    """Reasons of designs that left the front when their parts were drawn, by their numbers."""


def journal_exists(out: Path) -> bool:
    """True if a folder holds trials."""
    return os.path.lexists(out / JOURNAL)


def opened(out: Path, directions: Directions, identity: dict[str, Any], atlas: str) -> optuna.Study:
    """The trials of a folder, to be continued; a line that a kill left half written is cut off.

    The caller holds the folder: :func:`studies.output.sole_writer.sole_writer_of`.

    Args:
        out: the folder; it must exist.
        directions: ``maximize`` or ``minimize`` of each objective.
        identity: what must agree for trials to belong to one search, as JSON keeps it.
        atlas: digest of the installed table of the atlas; empty at other fidelities.

    Raises:
        StudyError: the journal is damaged, or holds the trials of another problem or of another table.
    """
    path = out / JOURNAL
    (out / _LOCK).unlink(missing_ok=True)  # of a search that was killed: nobody else writes here, as the caller sees to
    if os.path.lexists(path):
        check_own_file(path, "the journal of a search", StudyError)
        read_seal(out)
        whole = path.read_bytes().rfind(b"\n") + 1
        if whole < path.stat().st_size:
            with path.open("r+b") as file:
                file.truncate(whole)
    search = _study(path, directions, path)
    of_whom = search.user_attrs.get("problem")
    if of_whom is None:
        search.set_user_attr("atlas", atlas)
        search.set_user_attr("problem", identity)
        seal(out)
    else:
        _check_owner(path, of_whom, identity)
        if other := other_table(str(search.user_attrs.get("atlas", "")), atlas):
            raise StudyError(f"is not continued: {other}", kind=Kind.MISMATCH, file=path, remedy="give a new folder")
    return search


@contextmanager
def read_only(out: Path, directions: Directions, identity: dict[str, Any]) -> Iterator[optuna.Study]:
    """The trials of a folder, which stays as it is; arguments and errors as for :func:`opened`."""
    read_seal(out)
    held = read_bytes(out / JOURNAL, "the journal of a search", StudyError, _LARGEST)
    with temporary_folder() as folder:
        copy = folder / JOURNAL
        copy.write_bytes(held[: held.rfind(b"\n") + 1])
        search = _study(copy, directions, out / JOURNAL)
        _check_owner(out / JOURNAL, search.user_attrs.get("problem"), identity)
        yield search


def seal(out: Path, unprintable: dict[int, str] | None = None) -> None:
    """Note what the journal holds now; what was known to be unprintable stays so unless said anew."""
    held = (out / JOURNAL).read_bytes()
    known = _stated(out).unprintable if unprintable is None else unprintable
    content = json.dumps([len(held), sha256(held), [*known.items()]])
    write_record(out / _SEAL, _KIND, JOURNAL, content.encode())


def read_seal(out: Path) -> Seal:
    """The seal of a folder's journal, which agrees with it; an empty one where there is none.

    Raises:
        StudyError: the seal cannot be read, or the journal is not what was sealed.
    """
    found = _stated(out)
    held = read_bytes(out / JOURNAL, "the journal of a search", StudyError, _LARGEST)
    if found.bytes and sha256(held[: found.bytes]) != found.sha256:
        raise StudyError(
            "is damaged: its SHA-256 differs from the recorded one", kind=Kind.DAMAGED, file=out / JOURNAL,
            remedy="search anew in a new folder",
        )  # fmt: skip
    return found


def _stated(out: Path) -> Seal:
    """The seal as it stands on disk."""
    if not os.path.lexists(out / _SEAL):
        return Seal()
    length, digest, unprintable = json.loads(read_record(out / _SEAL, _KIND, JOURNAL, StudyError))
    return Seal(length, digest, dict(unprintable))


def _study(path: Path, directions: Directions, original: Path) -> optuna.Study:
    """Optuna's study of a journal, or of a copy of it; errors name the original.

    Raises:
        StudyError: a line does not belong to a journal.
    """
    import optuna
    from optuna.storages.journal import JournalFileBackend

    try:
        return optuna.create_study(
            storage=optuna.storages.JournalStorage(JournalFileBackend(str(path))),
            study_name="acoustic-fem",
            directions=directions,
            load_if_exists=True,
        )
    except (OSError, MemoryError):
        raise
    except Exception as error:  # of Optuna alone, which raises anything at lines that are not its own
        problem = f"is not the journal of a search: {type(error).__name__}: {said_by(error)}"
        raise StudyError(problem, kind=Kind.UNREADABLE, file=original) from None


def _check_owner(path: Path, of_whom: object, identity: dict[str, Any]) -> None:
    if of_whom != identity:
        raise StudyError(
            "holds the trials of another problem", kind=Kind.MISMATCH, file=path,
            remedy="give a new folder, or the file it was begun with (only optimize.trials may change)",
        )  # fmt: skip
