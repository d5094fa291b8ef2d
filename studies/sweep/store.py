"""The results of a study on disk: written block by block, and the same however often that was interrupted.

The results are kept in the records of :mod:`studies.sweep.records`. From these a plain Zarr store is written into the
same folder, for xarray and other programs; nothing here reads it. Variables are named as in the study: a parameter by
its dotted name, a metric by its name; the attribute ``kind`` says which is which. Nothing in a store depends on the
time, the number of workers or the order of the blocks. The next run of the study computes again what is damaged in the
records; until then readers of the results get a warning that says what that is.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry import ArrayDesign
from geometry.design.design_file import read_completed
from geometry.ground.file_checks import check_local, open_to_append, read_bytes
from geometry.ground.refusal import Field, Kind
from geometry.ground.whole_files import writing
from studies.output.folders import check_folder
from studies.output.sole_writer import hold
from studies.output.zarr_files import METADATA, Layout, ZarrFiles, plain_attributes
from studies.study.cases import Cases, by_kind
from studies.study.differences import first_difference, other_table
from studies.study.metric_registry import METRICS, Metric
from studies.study.study import Study, StudyError
from studies.sweep.records import (
    DONE,
    FAILED,
    FOLDER,
    FORMAT,
    MARK,
    TRANSFER_FUNCTIONS,
    WAITING,
    BlockResult,
    Records,
    layout_of,
)

if TYPE_CHECKING:
    import xarray as xr

#: Most bytes of what a store of an older version says of itself.
_MOST_METADATA = 2**26
#: Damaged blocks that are reported one by one.
_TOLD = 3


# -- writing ------------------------------------------------------------------------------------------------
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
                    self._show(first)
                    continue
                except StudyError as error:
                    notes.append(f"{error}; cases {first} to {stop - 1} are computed again")
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
            self._records.write(result)
            self._show(result.first)

    def _show(self, first: int) -> None:
        """Write a block that is kept into the Zarr store too."""
        result = self._records.block(first)
        values: dict[str, NDArray[Any]] = dict(result.values)
        if self._records.keeps_responses:
            transfer = self._records.responses(first)
            values |= dict(zip(TRANSFER_FUNCTIONS, (transfer.real, transfer.imag), strict=True))
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
        StudyError: it holds something else than the results of a sweep, or those of another version.
        Refusal: it cannot be written.
    """
    check_folder(path)
    if path.is_dir() and any(path.iterdir()):
        try:
            _check_sweep(path)
        except StudyError as error:
            raise StudyError.of(
                error, remedy=(Field("out"), " must be new, or the results of the same study")
            ) from None


def is_sweep(path: Path) -> bool:
    """True if a folder holds the results of a sweep, of this version or an older one."""
    return (path / FOLDER).is_dir() or (path / METADATA).exists()


def _check_sweep(path: Path) -> None:
    """Refuse a path that is not the results of a sweep of this version."""
    if (path / FOLDER).is_dir():
        return
    older = None
    with suppress(ValueError, KeyError, TypeError, RecursionError):
        older = json.loads(read_bytes(path / METADATA, "a store", StudyError, _MOST_METADATA))["attributes"][MARK]
    if older in (None, FORMAT):
        raise StudyError(f"is not the results of a sweep: it has no {FOLDER}", kind=Kind.MISMATCH, file=path)
    raise StudyError(
        f"is of format {older}; this version of the program reads format {FORMAT}",
        kind=Kind.MISMATCH, file=path, remedy="compute the study again",
    )  # fmt: skip


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


# -- reading ------------------------------------------------------------------------------------------------
@dataclass(frozen=True, eq=False)
class Sweep:
    """Results of a study, finished or not."""

    records: Records
    """Records from which they are read."""
    values: Mapping[str, NDArray[Any]]
    """Values of all variables but the transfer functions, those of ``frequency``, ``microphone`` and ``point`` along
    themselves, others (n_case,); metrics of what is waiting or failed are NaN."""

    @property
    def attributes(self) -> dict[str, Any]:
        """Attributes of the results: ``title``, ``description``, ``fidelity``, ``study`` and others."""
        return self.records.layout.attributes

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the variables that were varied."""
        return self.records.parameters

    @property
    def metrics(self) -> tuple[str, ...]:
        """Names of the variables that were computed."""
        return self.records.metrics

    def units(self, name: str) -> str:
        """Unit of a variable, "1" for ratios; empty if it is dimensionless."""
        return self.records.layout.variables[name].attributes.get("units", "")

    @cached_property
    def dataset(self) -> xr.Dataset:
        """Variables along ``case``, transfer functions too, which are read when they are used."""
        import xarray as xr  # takes longer than a sweep is listed in without it

        values: dict[str, Any] = dict(self.values)
        if self.records.keeps_responses:
            values |= dict(zip(TRANSFER_FUNCTIONS, self._transfer_functions(), strict=True))
        variables = self.records.layout.variables.items()
        rows = {name: (each.dimensions, values[name], each.attributes) for name, each in variables}
        return xr.Dataset(rows, attrs=plain_attributes(self.attributes))

    def _transfer_functions(self) -> tuple[Any, Any]:
        """Real and imaginary parts, as arrays of dask whose blocks are read when they are used."""
        import dask
        import dask.array as da

        _, *rest = self.records.layout.variables[TRANSFER_FUNCTIONS[0]].shape
        read, blocks = dask.delayed(self._responses, pure=False), []
        for first, stop in self.records.blocks():
            shape = (stop - first, *rest)
            blocks.append(da.from_delayed(read(first, shape), shape, np.complex128))
        whole = da.concatenate(blocks)
        return whole.real, whole.imag

    def _responses(self, first: int, shape: tuple[int, ...]) -> NDArray[np.complex128]:
        if self.values["state"][first] == WAITING:
            return np.full(shape, complex(np.nan, np.nan))
        return self.records.responses(first)

    @cached_property
    def base(self) -> ArrayDesign:
        """Design that was varied.

        Raises:
            DesignError: it is not valid in this version.
        """
        return base_of(self.records.path, self.attributes["base_design"])

    @property
    def done(self) -> NDArray[np.bool_]:
        """True if a case was computed without failure; (n_case,) bool."""
        return np.asarray(self.values["state"] == DONE)

    @property
    def failed(self) -> NDArray[np.bool_]:
        """True if a case failed, why is in ``values["reason"]``; (n_case,) bool."""
        return np.asarray(self.values["state"] == FAILED)

    def case(self, number: int) -> dict[str, Any]:
        """Values of the parameters of one case."""
        values = {name: self.values[name][number] for name in self.parameters}
        return {name: value.item() if hasattr(value, "item") else str(value) for name, value in values.items()}

    def design(self, number: int) -> ArrayDesign:
        """Design of one case.

        Raises:
            DesignError: its values do not go together: the reason it failed for.
        """
        return self.base.with_values(self.case(number))


def base_of(path: Path, text: str) -> ArrayDesign:
    """Design of which the results in a store are changes, from its text there."""
    return read_completed(text, f"{path}: base design").completed()


def open_sweep(path: str | os.PathLike[str]) -> Sweep:
    """Results of a study, opened, also while it runs; transfer functions are read when they are used.

    Raises:
        StudyError: the folder is not the results of a sweep, or they are damaged; names the record, and what to do.
    """
    check_local(path, StudyError, "results")
    path = Path(path)
    _check_sweep(path)
    try:
        records = Records.of_store(path)
        variables = records.layout.variables
        values = {name: variables[name].start() for name in variables if name not in TRANSFER_FUNCTIONS}
        for first, stop in records.blocks():
            if records.is_done(first):
                found = records.block(first)
                columns: dict[str, Any] = {**found.values, "state": found.state, "reason": found.reason}
                for name, column in columns.items():
                    values[name][first:stop] = column
    except StudyError as error:
        if error.kind is Kind.MISMATCH:
            raise
        remedy = "run the same sweep again, which computes again what is damaged"
        raise StudyError.of(error, remedy=remedy) from None
    for name in records.metrics:
        if name not in METRICS:
            raise StudyError(
                "is not a metric of this version", kind=Kind.UNKNOWN, file=path, field="metrics", value=name
            )
    return Sweep(records, values)
