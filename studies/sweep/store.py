"""The results of a study on disk: one Zarr store, written block by block, the same however often it was interrupted.

Variables are named as in the study: a parameter by its dotted name, a metric by its name; the attribute ``kind``
says which is which. The state of a block is written last, each file beside and then renamed: what is marked as
done is whole. Nothing in the store depends on the time, the number of workers or the order of the blocks.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.library.provenance import versions
from geometry import ArrayDesign
from geometry.design.design_file import read_design, write_design
from geometry.stated.fields import field_named
from studies.output.folders import check_folder
from studies.study.cases import Cases
from studies.study.failure_reasons import by_kind
from studies.study.study import Study, StudyError

if TYPE_CHECKING:
    import xarray as xr

#: Layout of the store.
FORMAT = 1
#: Values of ``state``.
WAITING, DONE, FAILED = 0, 1, 2
#: Versions that may change a result.
_LIBRARIES = ("gmsh", "numpy", "scikit-fem", "scipy", "xarray", "zarr")
#: Complex values of transfer functions worked on in one block, and most cases of one.
_BLOCK_VALUES = 400_000
_LARGEST_BLOCK = 1024


class Labelled(Protocol):
    """Metric, as far as the store needs to know it."""

    @property
    def name(self) -> str:
        """Name of its variable."""

    @property
    def unit(self) -> str:
        """Unit of its values, "1" for ratios."""

    @property
    def long_name(self) -> str:
        """Title, a few words."""


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


class SweepStore:
    """Store that is being filled. Only one process may write to it."""

    def __init__(self, path: Path) -> None:
        """Open a store that exists; see :meth:`claim`."""
        import zarr

        self.path = path
        self._group = zarr.open_group(path, mode="r+", zarr_format=3, use_consolidated=False)
        self._variables: dict[str, Any] = dict(self._group.arrays())
        self.attributes: dict[str, Any] = dict(self._group.attrs)

    @classmethod
    def claim(cls, path: Path, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> SweepStore:
        """Store with all parameters and nothing done, or the one of an earlier run of the same study.

        The caller holds :func:`sole_writer`: whoever else writes to the store would lose what this removes.

        Raises:
            StudyError: the path holds something else, or the store of another study.
        """
        check_store(path)
        if not is_sweep(path):
            _create(path, study, cases, metrics)
        store = cls(path)
        differs = _first_difference(json.loads(store.attributes["study_content"]), study.content())
        if differs:
            raise StudyError(f"{path}: holds the results of another study: {differs}; give another `out`, or remove it")
        for left in path.rglob("*.partial"):  # of a run that was killed while it wrote
            left.unlink()
        return store

    @property
    def block(self) -> int:
        """Number of cases per block."""
        return int(self.attributes["block"])

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
        for name, values in result.values.items():
            self._variables[name][part] = values
        if result.transfer_function is not None:
            points = slice(0, result.transfer_function.shape[1])
            self._variables["transfer_function_real"][part, points] = result.transfer_function.real
            self._variables["transfer_function_imag"][part, points] = result.transfer_function.imag
        self._variables["reason"][part] = np.array(result.reason, dtype=object)
        self._variables["state"][part] = result.state  # last: from now on the block counts

    def failures(self) -> dict[str, list[int]]:
        """Numbers of the failed cases by kind of reason, as :func:`studies.study.failure_reasons.by_kind`."""
        reasons = self._variables["reason"][:]
        return by_kind((int(number), str(reasons[number])) for number in np.flatnonzero(self.state == FAILED))


def check_store(path: Path) -> None:
    """Refuse a path that no sweep may write to; nothing is touched.

    Raises:
        StudyError: it holds what no sweep made.
        Refusal: it cannot be written.
    """
    check_folder(path)
    if not is_sweep(path) and path.is_dir() and any(path.iterdir()) and not is_sweep(path):  # or it came meanwhile
        raise StudyError(f"{path}: holds what no sweep made; `out` must be new, or the results of the same study")


@contextmanager
def sole_writer(path: Path) -> Iterator[IO[str]]:
    """Log beside a store, for as long as nobody else may write to either.

    Raises:
        StudyError: another sweep is writing, or the file system has no locks.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.with_name(f"{path.name}.log").open("a", encoding="utf-8") as log:
        try:
            import fcntl
        except ImportError:  # not on this system: nobody watches
            yield log
            return
        try:
            fcntl.flock(log, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise StudyError(f"{path}: another sweep is writing to it") from None
        except OSError as error:
            raise StudyError(
                f"{log.name}: cannot be locked ({error.strerror}); `out` must be where files can"
            ) from None
        yield log


def is_sweep(path: Path) -> bool:
    """Whether a folder is the store of a sweep."""
    try:
        content = json.loads((path / "zarr.json").read_text(encoding="utf-8"))
        return "acoustic_fem_sweep" in content["attributes"]
    except (OSError, ValueError, KeyError, TypeError):
        return False


def block_size(study: Study, cases: Cases) -> int:
    """Number of cases per block, by the study alone: enough to be fast, few enough for memory and for sharing."""
    values = point_count(cases) * len(study.base.microphones) * len(study.frequency)
    return max(1, min(_BLOCK_VALUES // values, -(-len(cases) // 16), _LARGEST_BLOCK))


def point_count(cases: Cases) -> int:
    """Largest number of points of any case."""
    columns = dict(zip(cases.names, cases.columns, strict=True))
    total = np.zeros(len(cases), dtype=np.int64)
    for number, line in enumerate(cases.base.lines):
        total += columns.get(f"lines.{number}.points", np.int64(line.points))
    return int(total.max())


# -- reading ----------------------------------------------------------------------------------------
@dataclass(frozen=True, eq=False)
class Sweep:
    """Results of a study, finished or not."""

    dataset: xr.Dataset
    """Variables along ``case``; what is waiting or failed is NaN."""
    base: ArrayDesign
    """Design that was varied."""
    parameters: tuple[str, ...]
    """Names of the variables that were varied."""
    metrics: tuple[str, ...]
    """Names of the variables that were computed."""

    @property
    def done(self) -> NDArray[np.bool_]:
        """Whether a case was computed without failure; (n_case,) bool."""
        return np.asarray(self.dataset["state"].values == DONE)

    @property
    def failed(self) -> NDArray[np.bool_]:
        """Whether a case failed, why is in ``dataset["reason"]``; (n_case,) bool."""
        return np.asarray(self.dataset["state"].values == FAILED)

    def case(self, number: int) -> dict[str, Any]:
        """Values of the parameters of one case."""
        values = {name: self.dataset[name].values[number] for name in self.parameters}
        return {name: value.item() if hasattr(value, "item") else str(value) for name, value in values.items()}

    def design(self, number: int) -> ArrayDesign:
        """Design of one case.

        Raises:
            DesignError: its values do not go together: the reason it failed for.
        """
        return self.base.with_values(self.case(number))


def open_sweep(path: str | os.PathLike[str]) -> Sweep:
    """Results of a study, opened, also while it runs; variables are read when they are used.

    Raises:
        StudyError: the folder is not the store of a sweep.
    """
    import xarray as xr

    path = Path(path)
    if not is_sweep(path):
        raise StudyError(f"{path}: is not the results of a sweep (a .zarr folder)")
    dataset = xr.open_zarr(path, consolidated=False)

    def of_kind(kind: str) -> tuple[str, ...]:
        names = json.loads(dataset.attrs[f"{kind}_names"])
        return tuple(str(name) for name in names)

    return Sweep(
        dataset,
        read_design(dataset.attrs["base_design"], f"{path}: base design"),
        of_kind("parameter"),
        of_kind("metric"),
    )


# -- creating ---------------------------------------------------------------------------------------
def _create(path: Path, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> None:
    """A store with all parameters and nothing done, built beside and then put in place."""
    import zarr

    beside = path.with_name(f".{path.name}.new")
    shutil.rmtree(beside, ignore_errors=True)
    made = versions(study.seed, _LIBRARIES)
    del made["created"]  # in the log: the store of a study is the same whenever it is made
    group = zarr.open_group(beside, mode="w", zarr_format=3)
    block = block_size(study, cases)
    group.attrs.update(
        {
            "acoustic_fem_sweep": FORMAT,
            "title": study.name,
            "description": study.description,
            "fidelity": study.fidelity,
            "study": study.text,
            "study_content": json.dumps(study.content()),
            "base_design": write_design(study.base.completed()),
            "parameter_names": json.dumps(cases.names),
            "metric_names": json.dumps([metric.name for metric in metrics]),
            "block": block,
            "left_out": cases.left_out,
            **made,
        }
    )

    def variable(name: str, dims: Sequence[str], values: NDArray[Any], **attributes: Any) -> None:
        array = group.create_array(
            name, shape=values.shape, dtype=_kind(values), chunks=values.shape, dimension_names=dims,
            attributes=attributes,
        )  # fmt: skip
        array[:] = values

    def along_cases(name: str, dtype: str, fill: float | str, dims: Iterable[str] = (), **attributes: Any) -> None:
        more = {
            "point": point_count(cases),
            "microphone": len(study.base.microphones),
            "frequency": len(study.frequency),
        }
        rest = [more[each] for each in dims]
        group.create_array(
            name, shape=(len(cases), *rest), chunks=(block, *rest), dtype=dtype, fill_value=fill,
            dimension_names=("case", *dims), attributes=attributes,
        )  # fmt: skip

    variable("case", ("case",), np.arange(len(cases)), long_name="number of the case")
    variable("frequency", ("frequency",), study.frequency, units="Hz", long_name="frequency")
    variable("microphone", ("microphone",), np.array(study.base.microphones, dtype=object), long_name="microphone")
    variable("point", ("point",), np.arange(1, point_count(cases) + 1), long_name="sensing point, from 1")
    for name, column in zip(cases.names, cases.columns, strict=True):
        field = field_named(ArrayDesign, name)
        about = {"long_name": field.description, "units": field.unit or "1"} if field else {"units": "mm"}
        variable(name, ("case",), column, kind="parameter", **about)
    for metric in metrics:
        along_cases(metric.name, "float64", np.nan, kind="metric", units=metric.unit, long_name=metric.long_name)
    if study.transfer_functions:
        for part in ("real", "imag"):
            along_cases(
                f"transfer_function_{part}", "float64", np.nan, ("point", "microphone", "frequency"),
                units="Pa/Pa", long_name="pressure at the microphone per pressure in the touched cavity",
            )  # fmt: skip
    along_cases("state", "int8", WAITING, long_name="0 waiting, 1 done, 2 failed")
    along_cases("reason", "string", "", long_name="why the case failed")
    if path.exists():
        path.rmdir()  # empty
    os.replace(beside, path)


def _kind(values: NDArray[Any]) -> str:
    return "string" if values.dtype == object else str(values.dtype)


def _first_difference(stored: Mapping[str, Any], wanted: Mapping[str, Any]) -> str:
    """In words, the first field in which two studies differ; empty where they do not."""
    wanted = json.loads(json.dumps(wanted))
    stored = json.loads(json.dumps(stored))
    for name in wanted:
        if stored.get(name) != wanted[name]:
            if name == "base":
                return "its base design is not the same"
            if name == "frequencies":
                ends = [f"{grid[0]:g}:{grid[-1]:g}:{len(grid)}" for grid in (stored[name], wanted[name])]
                return f"its frequencies are {ends[0]}, not {ends[1]}"
            if name == "parameters":
                return _parameter_difference(stored[name], wanted[name])
            return f"its {name} is {stored.get(name)!r}, not {wanted[name]!r}"
    return ""


def _parameter_difference(stored: list[Any], wanted: list[Any]) -> str:
    old, new = ({each["name"]: each for axis in axes for each in axis} for axes in (stored, wanted))
    for name in [*new, *old]:
        if name not in old:
            return f"it does not vary {name}"
        if name not in new:
            return f"it varies {name}"
        if json.dumps(old[name]) != json.dumps(new[name]):
            return f"its values of {name} are not the same"
    return "its parameters are grouped or ordered otherwise"
