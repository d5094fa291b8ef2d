"""The results of a study on disk: written block by block, and the same however often that was interrupted.

Metrics are kept in the records of :mod:`studies.sweep.records`. From these a plain Zarr store is written into the same
folder, for xarray and other programs. The responses, where the study keeps them, stand in its group ``responses``
alone. Variables are named as in the study: a parameter by its dotted name, a metric by its name; the attribute ``kind``
says which is which. Nothing in a store depends on the time, the number of workers or the order of the blocks. The next
run of the study computes again what is damaged; until then readers are refused the damaged part by its name.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.file_checks import open_to_append
from geometry.ground.refusal import Field, Kind
from geometry.ground.whole_files import writing
from studies.output.folders import check_folder
from studies.output.sole_writer import hold
from studies.output.zarr_files import Layout, ZarrFiles
from studies.study.cases import Cases, by_kind
from studies.study.differences import first_difference, other_table
from studies.study.metric_registry import Metric
from studies.study.parameter import StudyError
from studies.study.study import Study
from studies.sweep.records import FAILED, FOLDER, WAITING, BlockResult, Records, layout_of
from studies.sweep.results import check_sweep

#: Damaged blocks that are reported one by one.
_TOLD = 3


class SweepStore:
    """Store that is being filled. Only one process may write to it.

    Args:
        records: what is kept.
        notes: what was wrong with the store.
    """

    def __init__(self, records: Records, notes: Sequence[str] = ()) -> None:
        self.attributes = records.layout.attributes
        self.notes = list(notes)
        #: State of each case; (n_case,) int8.
        self.state: NDArray[np.int8] = np.full(records.layout.variables["state"].shape, WAITING, np.int8)
        self._reason = np.full(self.state.shape, "", object)
        self._records = records
        self._files = ZarrFiles(records.path, records.layout)

    @classmethod
    def claim(cls, path: Path, study: Study, cases: Cases, metrics: Sequence[Metric]) -> SweepStore:
        """Store with nothing done, or the one of an earlier run of the same study.

        Blocks of the latter that are damaged wait to be computed again, and :attr:`notes` says so. The caller holds
        :func:`sole_writer`: whoever else writes to the store would lose what this removes.

        Raises:
            StudyError: the path holds something else, the store of another study, or one that is damaged beyond that.
        """
        check_store(path)
        with writing(path):
            records, notes = _taken_up(path, layout_of(study, cases, metrics))
        if differs := first_difference(records.content, study.content()):
            raise _not_continued(path, f"holds the results of another study: {differs}")
        if other := other_table(records.layout.attributes["atlas"], study.atlas):
            raise _not_continued(path, f"is not continued: {other}")
        for left in (*path.rglob("*.partial"), *(path / FOLDER).glob(".*")):  # of a run that was killed while it wrote
            left.unlink()
        with writing(path):
            store = cls(records, notes)
            store._take_up_blocks()
        return store

    def _take_up_blocks(self) -> None:
        """Take the blocks that are done, and let those of which anything is damaged wait."""
        notes = []
        for first, stop in self._records.blocks():
            if self._records.is_done(first):
                try:
                    self._records.check_responses(first)
                    self._show(first)
                    continue
                except StudyError as error:
                    which = f"case {first} is" if stop == first + 1 else f"cases {first} to {stop - 1} are"
                    notes.append(f"{error}; {which} computed again")
            self._records.forget(first)
            self._files.drop(first)
        more = f"{self._records.path}: {len(notes) - _TOLD} more blocks are damaged and computed again"
        self.notes += [*notes[:_TOLD], *([more] if len(notes) > _TOLD else [])]

    def waiting(self) -> list[tuple[int, int]]:
        """Blocks that are not done: first case, and the one after the last, of each."""
        return [(first, stop) for first, stop in self._records.blocks() if self.state[first] == WAITING]

    def write(self, result: BlockResult) -> None:
        """Keep the results of one block."""
        with writing(self._records.path):
            self._records.write(result, self._files.put(result.first, self._records.padded(result)))
            self._show(result.first)

    def _show(self, first: int) -> None:
        """Write the metrics of a block that is kept into the Zarr store too."""
        result = self._records.block(first)
        values: dict[str, NDArray[Any]] = dict(result.values)
        values |= {"state": result.state, "reason": np.array(result.reason, dtype=object)}
        self._files.put(first, values)
        part = slice(first, first + len(result.state))
        self.state[part], self._reason[part] = result.state, result.reason

    def failures(self) -> dict[str, list[int]]:
        """Numbers of the failed cases by kind of reason, as :func:`studies.study.cases.by_kind`."""
        return by_kind((int(number), self._reason[number]) for number in np.flatnonzero(self.state == FAILED))


def _taken_up(path: Path, layout: Layout) -> tuple[Records, list[str]]:
    """Records of a store, begun where there are none; and a note where the record of the study is restored."""
    if not (path / FOLDER).is_dir():
        beside = path.with_name(f".{path.name}.new")
        shutil.rmtree(beside, ignore_errors=True)
        Records(beside, layout).begin()
        if path.exists():
            path.rmdir()  # empty
        os.replace(beside, path)
    try:
        return Records.of_store(path), []
    except StudyError as error:
        own = Records(path, layout)
        if error.kind is Kind.MISMATCH or not _holds_a_block(own):
            raise
        own.begin()
        return own, [f"{error}; restored from the study"]


def _holds_a_block(records: Records) -> bool:
    """True if any block is one of this study, and whole."""
    for first, _ in records.blocks():
        with suppress(StudyError):
            records.block(first)
            return True
    return False


def check_store(path: Path) -> None:
    """Refuse a path that no sweep may write to; nothing is touched.

    Raises:
        StudyError: it holds something else than the results of a sweep, those of another version, or a pipe, a device
            or a link.
        Refusal: it cannot be written.
    """
    check_folder(path)
    if path.is_dir() and any(path.iterdir()):
        try:
            check_sweep(path)
        except StudyError as error:
            if error.kind is not Kind.MISMATCH:
                raise
            raise StudyError.of(
                error, remedy=(Field("out"), " must be new, or the results of the same study")
            ) from None


def _not_continued(path: Path, why: str) -> StudyError:
    return StudyError(why, kind=Kind.MISMATCH, file=path, remedy=("give another ", Field("out"), ", or remove it"))


@contextmanager
def sole_writer(path: Path) -> Iterator[IO[str]]:
    """Log beside a store, for as long as nobody else may write to either.

    Raises:
        StudyError: another sweep is writing, or the file system has no locks.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f"{path.name}.log")
    with writing(beside), open_to_append(beside, "the log of a sweep", StudyError) as log:
        try:
            hold(log.fileno(), path, "sweep", StudyError)
        except OSError as error:
            problem, remedy = f"cannot be locked ({error.strerror})", (Field("out"), " must be where files can")
            raise StudyError(problem, kind=Kind.UNREADABLE, file=beside, remedy=remedy) from None
        yield log
