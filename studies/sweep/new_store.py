"""The store of a study before anything is computed: all parameters, and room for what will be."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.library.provenance import versions
from studies.output.checked_store import add_checksums, create_checked
from studies.output.seals import SEALS, create_seals
from studies.study.study import Study

if TYPE_CHECKING:
    from studies.study.cases import Cases

#: Attribute that marks a store, and the layout of the store that it states; from 2 on there are checksums, from 3
#: on seals.
MARK = "acoustic_fem_sweep"
FORMAT = 3
#: Versions that may change a result.
_LIBRARIES = ("gmsh", "numpy", "scikit-fem", "scipy", "xarray", "zarr")
#: Complex values of transfer functions worked on in one block, and most cases of one.
_BLOCK_VALUES = 400_000
_LARGEST_BLOCK = 1024
WAITING = 0
"""State of a case that is not computed yet."""
TRANSFER_FUNCTIONS = ("transfer_function_real", "transfer_function_imag")
"""Arrays of the transfer functions, where the study keeps them."""


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


def block_size(study: Study, cases: Cases) -> int:
    """Number of cases per block, by the study alone: enough to be fast, few enough for memory and for sharing.

    The number of blocks is a multiple of four where it can be: two or four workers then end together.
    """
    values = point_count(cases) * len(study.base.microphones) * len(study.frequency)
    largest = max(1, min(_BLOCK_VALUES // values, -(-len(cases) // 16), _LARGEST_BLOCK))
    blocks = 4 * -(-len(cases) // (4 * largest))
    return -(-len(cases) // blocks)


def point_count(cases: Cases) -> int:
    """Largest number of points of any case."""
    columns = dict(zip(cases.names, cases.columns, strict=True))
    total = np.zeros(len(cases), dtype=np.int64)
    for number, line in enumerate(cases.base.lines):
        total += columns.get(f"lines.{number}.points", np.int64(line.points))
    return int(total.max())


def create_store(path: Path, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> None:
    """Make a store with all parameters and nothing done, built beside and then put in place."""
    with fresh_store(path, study, cases, metrics) as beside:
        if path.exists():
            path.rmdir()  # empty
        os.replace(beside, path)


def filled_arrays(metrics: Iterable[str], transfer_functions: bool) -> dict[str, int]:
    """Names of the arrays that are filled block by block, the state last, and how many axes they have."""
    transfer = TRANSFER_FUNCTIONS if transfer_functions else ()
    return dict.fromkeys(metrics, 1) | dict.fromkeys(transfer, 4) | {"reason": 1, "state": 1}


@contextmanager
def fresh_store(path: Path, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> Iterator[Path]:
    """A store with all parameters and nothing done beside a path, for as long as it is needed."""
    beside = path.with_name(f".{path.name}.new")
    shutil.rmtree(beside, ignore_errors=True)
    try:
        _fill(beside, study, cases, metrics)
        add_checksums(beside, (*filled_arrays([metric.name for metric in metrics], study.transfer_functions), SEALS))
        yield beside
    finally:
        shutil.rmtree(beside, ignore_errors=True)


def _fill(path: Path, study: Study, cases: Cases, metrics: Sequence[Labelled]) -> None:
    import zarr

    from geometry import ArrayDesign
    from geometry.design.design_file import write_design
    from geometry.schema.declared_fields import field_named

    made = versions(study.seed, _LIBRARIES)
    del made["created"]  # in the log: the store of a study is the same whenever it is made
    group = zarr.open_group(path, mode="w", zarr_format=3)
    block = block_size(study, cases)
    group.attrs.update(
        {
            MARK: FORMAT,
            "title": study.name,
            "description": study.description,
            "fidelity": study.fidelity,
            "atlas": study.atlas,
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
        create_checked(group, name, values.shape, _kind(values), values.shape, dims, attributes)[:] = values

    def along_cases(name: str, dtype: str, fill: float | str, dims: Iterable[str] = (), **attributes: Any) -> Any:
        more = {
            "point": point_count(cases),
            "microphone": len(study.base.microphones),
            "frequency": len(study.frequency),
        }
        rest = [more[each] for each in dims]
        shape, chunks = (len(cases), *rest), (block, *rest)
        return create_checked(group, name, shape, dtype, chunks, ("case", *dims), attributes, fill)

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
        for name in TRANSFER_FUNCTIONS:
            along_cases(
                name, "float64", np.nan, ("point", "microphone", "frequency"),
                units="Pa/Pa", long_name="pressure at the microphone per pressure in the touched cavity",
            )  # fmt: skip
    # Written where nothing is done yet, too: a chunk that is missing is damage, not a case that waits.
    along_cases("state", "int8", WAITING, long_name="0 waiting, 1 done, 2 failed")[:] = WAITING
    along_cases("reason", "string", "", long_name="why the case failed")
    filled = filled_arrays([metric.name for metric in metrics], study.transfer_functions)
    create_seals(group, -(-len(cases) // block), list(filled))


def _kind(values: NDArray[Any]) -> str:
    return "string" if values.dtype == object else str(values.dtype)
