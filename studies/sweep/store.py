"""The results of a study on disk: one Zarr store, written block by block, the same however often it was interrupted.

Variables are named as in the study: a parameter by its dotted name, a metric by its name; the attribute ``kind``
says which is which. A block is sealed when all of it is written, and its state is written last, each file beside and
then renamed: what is marked as done is whole, and of this store and block. Nothing in the store depends on the time,
the number of workers or the order of the blocks. What is damaged is computed again by the next run of the study, and
refused by whoever reads it before.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Json, PositiveInt

from geometry.ground.file_checks import library_reads
from geometry.ground.whole_files import write_text, writing
from studies.output.checked_store import METADATA, CheckedStore, read_store, take_checksums
from studies.output.folders import check_folder
from studies.output.seals import SEALS, Seals
from studies.output.sole_writer import hold
from studies.study.cases import by_kind
from studies.study.differences import first_difference, other_table
from studies.study.metric_registry import METRICS
from studies.study.study import Study, StudyError
from studies.sweep.new_store import (
    FORMAT,
    MARK,
    TRANSFER_FUNCTIONS,
    WAITING,
    Labelled,
    create_store,
    filled_arrays,
    fresh_store,
)

if TYPE_CHECKING:
    import xarray as xr

    from geometry import ArrayDesign
    from studies.study.cases import Cases

#: Values of ``state`` beside :data:`WAITING`.
DONE, FAILED = 1, 2
#: Damaged blocks that are told of one by one.
_TOLD = 3


@dataclass(frozen=True, eq=False)
class BlockResult:
    """Results of consecutive cases."""

    first: int
    """Number of the first case."""
    values: Mapping[str, NDArray[np.float64]]
    """Values of each metric, NaN where it failed; (n,) float64."""
    state: NDArray[np.int8]
    """State of each case, :data:`DONE` or :data:`FAILED`; (n,) int8."""
    reason: tuple[str, ...]
    """Reason why a case failed, empty where it did not."""
    transfer_function: NDArray[np.complex128] | None = None
    """Transfer functions, where the study keeps them; (n, n_point, n_microphone, n_freq) complex128, Pa/Pa."""


class _About(BaseModel):
    """Attributes of a store on which its results depend."""

    model_config = ConfigDict(strict=True)
    title: str = ""
    description: str = ""
    fidelity: str
    atlas: str = ""
    study_content: Json[dict[str, Any]]
    base_design: str
    parameter_names: Json[list[str]]
    metric_names: Json[list[str]]
    block: PositiveInt

    def filled(self) -> dict[str, int]:
        """Arrays that are filled block by block; see :func:`studies.sweep.new_store.filled_arrays`."""
        return filled_arrays(self.metric_names, bool(self.study_content.get("transfer_functions")))


#: Attributes of a store that change no result.
_DESCRIBED = ("title", "description", "study", "left_out", "code_version", "seed", "python", "libraries")


def _stored(path: Path) -> tuple[CheckedStore, _About]:
    """What a store says of itself.

    Raises:
        StudyError: it is not the store of a sweep, or is damaged; names the member.
    """
    return read_store(path, "the results of a sweep", MARK, FORMAT, _About, _DESCRIBED, StudyError)


class SweepStore:
    """Store that is being filled. Only one process may write to it."""

    def __init__(self, path: Path) -> None:
        """Open a store that exists; see :meth:`claim`."""
        self.path = path
        self._stored, self._about = _stored(path)
        self.attributes: dict[str, Any] = self._stored.attributes
        #: Arrays that are filled block by block, the state last, and how many axes they have.
        self._filled = self._about.filled()
        self._files = self._filled | ({SEALS: 2} if self._stored.identity else {})
        self._variables: dict[str, Any] = {}
        self._seals: Seals
        self.notes: tuple[str, ...] = ()

    @classmethod
    def claim(cls, path: Path, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> SweepStore:
        """Store with all parameters and nothing done, or the one of an earlier run of the same study.

        Of the latter, what is damaged is restored from the study where it follows from that, and waits to be computed
        again where it does not; :attr:`notes` says so. The caller holds :func:`sole_writer`: whoever else writes to the
        store would lose what this removes.

        Raises:
            StudyError: the path holds something else, the store of another study, or one that is damaged beyond that.
        """
        check_store(path)
        if not (path / METADATA).exists():
            with writing(path):
                create_store(path, study, cases, metrics)
        store = cls(path)
        differs = first_difference(store._about.study_content, study.content())
        if differs:
            raise StudyError(f"{path}: holds the results of another study: {differs}; give another `out`, or remove it")
        if other := other_table(store._about.atlas, study.atlas):
            raise StudyError(f"{path}: is not continued: {other}; give another `out`, or remove it")
        for left in path.rglob("*.partial"):  # of a run that was killed while it wrote
            left.unlink()
        with writing(path):
            store._restore(study, cases, metrics)
        store._variables = {name: store._stored.array(name, writing=True) for name in store._filled}
        store._seals = Seals(store._stored, list(store._filled), writing=True)
        with writing(path):
            store._forget_damaged()
        return store

    def _restore(self, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> None:
        """Make anew what follows from the study alone: arrays that say what is computed, and what arrays are."""
        wrong: dict[str, str] = {}
        for name in ("case", "frequency", "microphone", "point", *self._about.parameter_names):
            try:
                self._stored.fixed(name)
            except StudyError as error:
                wrong[name] = str(error)
        for name in self._files:
            try:
                self._stored.array(name)
            except StudyError as error:
                wrong[name] = str(error)
        if not wrong:
            return
        with fresh_store(self.path, study, cases, metrics) as fresh:
            made, about = _stored(fresh)
            if not self._stored.checked or about.block != self._about.block:
                raise StudyError(f"{next(iter(wrong.values()))}; an older version wrote it: give another `out`")
            for name in wrong:
                if name not in self._files:
                    shutil.rmtree(self.path / name, ignore_errors=True)
                    shutil.copytree(fresh / name, self.path / name)
                (self.path / name).mkdir(exist_ok=True)
                write_text(self.path / name / METADATA, (fresh / name / METADATA).read_text(encoding="utf-8"))
            take_checksums(self.path, made, wrong)
        self._stored, self._about = _stored(self.path)
        self.notes += tuple(f"{reason}; restored from the study" for reason in wrong.values())

    def _forget_damaged(self) -> None:
        """Let blocks of which anything is damaged or missing wait to be computed again."""
        count = self._variables["state"].shape[0]
        notes = []
        for block, first in enumerate(range(0, count, self.block)):
            wrong = self._damage(block, slice(first, min(first + self.block, count)))
            if wrong:
                last = min(first + self.block, count) - 1
                for name in ("state", *self._files):  # first the state: from now on the block does not count
                    self._stored.chunk_file(name, block, self._files[name]).unlink(missing_ok=True)
                    if name == "state":
                        self._variables[name][first : last + 1] = WAITING
                notes.append(f"{wrong}; cases {first} to {last} are computed again")
        more = (f"{self.path}: {len(notes) - _TOLD} more blocks are damaged and computed again",)
        self.notes += tuple(notes[:_TOLD]) + more * (len(notes) > _TOLD)

    def _damage(self, block: int, part: slice) -> str:
        """What is wrong with a block that was done; empty where nothing is."""
        try:
            state = self._stored.part(self._variables["state"], "state", part)
            if not self._stored.has_chunk("state", block):
                return f"{self.path}: state: chunk {block} is missing"
            if (state == WAITING).all():
                return ""
            for name, dimensions in self._files.items():
                if not self._stored.has_chunk(name, block, dimensions):
                    return f"{self.path}: {name}: chunk {block} is missing"
            self._seals.check(
                block, {name: self._stored.part(array, name, part) for name, array in self._variables.items()}
            )
        except StudyError as error:
            return str(error)
        return ""

    @property
    def block(self) -> int:
        """Number of cases per block."""
        return self._about.block

    @property
    def state(self) -> NDArray[np.int8]:
        """State of each case, :data:`WAITING`, :data:`DONE` or :data:`FAILED`; (n_case,) int8."""
        return np.asarray(self._variables["state"][:], np.int8)

    def waiting(self) -> list[tuple[int, int]]:
        """Blocks that are not done: first case, and the one after the last, of each."""
        state = self.state
        blocks = [(first, min(first + self.block, len(state))) for first in range(0, len(state), self.block)]
        return [(first, stop) for first, stop in blocks if (state[first:stop] == WAITING).any()]

    def write(self, result: BlockResult) -> None:
        """Keep the results of one block."""
        part = slice(result.first, result.first + len(result.state))
        values: dict[str, NDArray[Any]] = {name: np.asarray(each, np.float64) for name, each in result.values.items()}
        if TRANSFER_FUNCTIONS[0] in self._variables:
            found = result.transfer_function
            points = slice(0, None if found is None else found.shape[1])
            both: tuple[Any, Any] = (np.nan, np.nan) if found is None else (found.real, found.imag)
            for name, each in zip(TRANSFER_FUNCTIONS, both, strict=True):
                values[name] = np.full((len(result.state), *self._variables[name].shape[1:]), np.nan)
                values[name][:, points] = each
        values["reason"] = np.array(result.reason, dtype=object)
        with writing(self.path):
            for name, each in values.items():
                self._variables[name][part] = each
            values["state"] = np.asarray(result.state, np.int8)
            self._seals.write(result.first // self.block, values)
            self._variables["state"][part] = values["state"]  # last: from now on the block counts

    def failures(self) -> dict[str, list[int]]:
        """Numbers of the failed cases by kind of reason, as :func:`studies.study.cases.by_kind`."""
        reasons = self._variables["reason"][:]
        return by_kind((int(number), str(reasons[number])) for number in np.flatnonzero(self.state == FAILED))


def check_store(path: Path) -> None:
    """Refuse a path that no sweep may write to; nothing is touched.

    Raises:
        StudyError: it holds what no sweep made, or a store that is damaged.
        Refusal: it cannot be written.
    """
    check_folder(path)
    if path.is_dir() and any(path.iterdir()):
        if not (path / METADATA).exists():
            raise StudyError(
                f"{path}: holds what no sweep made (it has no {METADATA}); `out` must be new, or the results of the "
                "same study"
            )
        _stored(path)


@contextmanager
def sole_writer(path: Path) -> Iterator[IO[str]]:
    """Log beside a store, for as long as nobody else may write to either.

    Raises:
        StudyError: another sweep is writing, or the file system has no locks.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f"{path.name}.log")
    with writing(beside), beside.open("a", encoding="utf-8") as log:
        try:
            hold(log.fileno(), path, "sweep", StudyError)
        except OSError as error:
            raise StudyError(
                f"{log.name}: cannot be locked ({error.strerror}); `out` must be where files can"
            ) from None
        yield log


# -- reading ----------------------------------------------------------------------------------------
@dataclass(frozen=True, eq=False)
class Sweep:
    """Results of a study, finished or not."""

    values: Mapping[str, NDArray[Any]]
    """Values of all variables but the transfer functions, those of ``frequency``, ``microphone`` and ``point`` along
    themselves, others (n_case,); metrics of what is waiting or failed are NaN."""
    attributes: Mapping[str, Mapping[str, Any]]
    """Attributes of each variable, and under an empty name of all."""
    open_dataset: Callable[[], xr.Dataset]
    """Maker of :attr:`dataset`."""
    open_base: Callable[[], ArrayDesign]
    """Maker of :attr:`base`."""
    parameters: tuple[str, ...]
    """Names of the variables that were varied."""
    metrics: tuple[str, ...]
    """Names of the variables that were computed."""

    @cached_property  # without it a sweep is listed in a third of the time: xarray is not needed
    def dataset(self) -> xr.Dataset:
        """Variables along ``case``, transfer functions too, which are read when they are used."""
        return self.open_dataset()

    @cached_property  # nor are the classes of designs
    def base(self) -> ArrayDesign:
        """Design that was varied.

        Raises:
            DesignError: it is not valid in this version.
        """
        return self.open_base()

    @property
    def done(self) -> NDArray[np.bool_]:
        """Whether a case was computed without failure; (n_case,) bool."""
        return np.asarray(self.values["state"] == DONE)

    @property
    def failed(self) -> NDArray[np.bool_]:
        """Whether a case failed, why is in ``values["reason"]``; (n_case,) bool."""
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


def open_sweep(path: str | os.PathLike[str]) -> Sweep:
    """Results of a study, opened, also while it runs; transfer functions are read when they are used.

    Raises:
        StudyError: the folder is not the store of a sweep, or is damaged; names the member, and what to do.
    """
    path = Path(path)
    stored, about = _stored(path)
    unknown = [name for name in about.metric_names if name not in METRICS]
    if unknown:
        raise StudyError(f"{path}: {METADATA}: attribute metric_names: {unknown[0]!r} is no metric of this version")
    try:
        # the state first: what is done then stays as it is
        variables: dict[str, Any] = {"state": ("case", stored.small("state", "i"))}
        done = np.flatnonzero([block.any() for block in np.split(variables["state"][1], _cuts(variables, about))])
        for name, kind in (("case", "i"), ("frequency", "f"), ("microphone", "UO"), ("point", "i")):
            variables[name] = (name, stored.fixed(name, kind))
        variables |= {name: ("case", stored.fixed(name, "fiuUO")) for name in about.parameter_names}
        variables |= {name: ("case", stored.small(name, "f")) for name in about.metric_names}
        variables["reason"] = ("case", stored.small("reason", "UO"))
        _check_blocks(stored, about, variables, set(done.tolist()))
        waiting = ~np.isin(np.arange(len(variables["state"][1])) // about.block, done)
        for name in (*about.metric_names, "reason"):  # also where a block is being written
            variables[name][1][waiting] = "" if name == "reason" else np.nan
    except StudyError as error:
        raise StudyError(f"{error}; run the same sweep again, which computes again what is damaged") from None
    lazy = TRANSFER_FUNCTIONS if about.study_content.get("transfer_functions") else ()
    attributes = {name: stored.described.get(name, {}) for name in (*variables, *lazy)} | {"": stored.attributes}
    values = {name: each for name, (_, each) in variables.items()}
    make = partial(_dataset, stored, about, variables, lazy, waiting, attributes)
    base = partial(_base, path, about.base_design)
    return Sweep(values, attributes, make, base, tuple(about.parameter_names), tuple(about.metric_names))


def _base(path: Path, text: str) -> ArrayDesign:
    from geometry.design.design_file import read_stored_design

    return read_stored_design(text, f"{path}: base design").completed()


def _dataset(
    stored: CheckedStore,
    about: _About,
    variables: Mapping[str, Any],
    lazy: Sequence[str],
    waiting: NDArray[np.bool_],
    attributes: Mapping[str, Mapping[str, Any]],
) -> xr.Dataset:
    """Everything as xarray has it; ``lazy`` names the transfer functions, where they are kept."""
    import xarray as xr
    from xarray.core.indexing import LazilyIndexedArray

    from studies.output.lazy_part import LazyPart

    dimensions = ("case", "point", "microphone", "frequency")
    with library_reads(stored.path, "the results of a sweep", StudyError):
        parts = {name: LazyPart(stored, name, list(about.filled()), about.block, waiting) for name in lazy}
        rows = {**variables, **{name: (dimensions, LazilyIndexedArray(part)) for name, part in parts.items()}}
        return xr.Dataset({name: (*row, attributes[name]) for name, row in rows.items()}, attrs=dict(attributes[""]))


def _cuts(variables: Mapping[str, Any], about: _About) -> range:
    """Where the blocks after the first begin."""
    return range(about.block, len(variables["state"][1]), about.block)


def _check_blocks(stored: CheckedStore, about: _About, variables: Mapping[str, Any], done: set[int]) -> None:
    """Refuse what is missing of the blocks, and what belongs elsewhere; transfer functions wait until they are used."""
    filled = about.filled()
    for block in range(len(_cuts(variables, about)) + 1):
        for name, dimensions in filled.items() if block in done else (("state", 1),):
            if not stored.has_chunk(name, block, dimensions):
                raise StudyError(f"{stored.path}: {name}: chunk {block} is missing")
    seals = Seals(stored, list(filled))
    rows = seals.rows(slice(None))
    for block in sorted(done) if stored.identity else ():
        part = slice(block * about.block, (block + 1) * about.block)
        seals.check(block, {name: variables[name][1][part] for name in filled if name in variables}, rows[block])
