"""Records of a sweep: one of its study and, for each block of cases, records of what was computed.

They lie in the folder ``records`` of the store. The record of the study says what is computed, with the values of all
parameters. A block has a record of its metrics and, where the study keeps them, one of its transfer functions, written
before: a block whose metrics are there is done. Keys name the study, the block and the content, so that a record of
another study or place is damage. The Zarr store around them is written from the records alone.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.library.provenance import versions
from geometry import ArrayDesign
from geometry.design.design_file import write_design
from geometry.ground.record import packed, read_record, unpacked, write_record
from geometry.ground.refusal import Kind
from geometry.schema.declared_fields import field_named
from studies.output.zarr_files import Layout, Variable
from studies.study.cases import Cases
from studies.study.metric_registry import Metric
from studies.study.study import Study, StudyError

FOLDER = "records"
"""Folder of the records in a store."""
MARK = "acoustic_fem_sweep"
"""Attribute that marks a store and states the format of it and of its records."""
FORMAT = 4
_KIND = f"sweep {FORMAT}"
TRANSFER_FUNCTIONS = ("transfer_function_real", "transfer_function_imag")
"""Variables of the transfer functions, where the study keeps them."""
#: Versions that may change a result.
_LIBRARIES = ("gmsh", "numpy", "scikit-fem", "scipy", "xarray", "zarr")
#: Complex values of transfer functions worked on in one block, and most cases of one.
_BLOCK_VALUES = 400_000
_LARGEST_BLOCK = 1024
WAITING, DONE, FAILED = 0, 1, 2
"""States of a case."""


def block_size(study: Study, cases: Cases, count: int | None = None) -> int:
    """Number of cases per block, by the study alone: enough to be fast, few enough for memory and for sharing.

    The number of blocks is a multiple of four where it can be: two or four workers then end together.

    Args:
        study: the study.
        cases: its cases, or a sample of them.
        count: number of all cases; by default there are no others.
    """
    count = len(cases) if count is None else count
    values = point_count(cases) * len(study.base.microphones) * len(study.frequency)
    largest = max(1, min(_BLOCK_VALUES // values, -(-count // 16), _LARGEST_BLOCK))
    blocks = 4 * -(-count // (4 * largest))
    return -(-count // blocks)


def point_count(cases: Cases) -> int:
    """Largest number of points of any case."""
    columns = dict(zip(cases.names, cases.columns, strict=True))
    total = np.zeros(len(cases), dtype=np.int64)
    for number, line in enumerate(cases.base.lines):
        total += columns.get(f"lines.{number}.points", np.int64(line.points))
    return int(total.max())


def layout_of(study: Study, cases: Cases, metrics: Sequence[Metric]) -> Layout:
    """Results of a study before anything is computed; the same whenever and wherever one version makes them."""
    made = versions(study.seed, _LIBRARIES)
    del made["created"]  # in the log
    count, points, block = len(cases), point_count(cases), block_size(study, cases)
    attributes = {
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
    microphones = np.array(study.base.microphones, dtype=object)
    variables = {
        "case": Variable(("case",), {"long_name": "number of the case"}, np.arange(count)),
        "frequency": Variable(("frequency",), {"units": "Hz", "long_name": "frequency"}, study.frequency),
        "microphone": Variable(("microphone",), {"long_name": "microphone"}, microphones),
        "point": Variable(("point",), {"long_name": "sensing point, from 1"}, np.arange(1, points + 1)),
    }
    for name, column in zip(cases.names, cases.columns, strict=True):
        known = field_named(ArrayDesign, name)
        about = {"long_name": known.description, "units": known.unit or "1"} if known else {"units": "mm"}
        variables[name] = Variable(("case",), {"kind": "parameter", **about}, column)
    for metric in metrics:
        about = {"kind": "metric", "units": metric.unit, "long_name": metric.long_name}
        variables[metric.name] = Variable(("case",), about, shape=(count,))
    for name in TRANSFER_FUNCTIONS if study.transfer_functions else ():
        about = {"units": "Pa/Pa", "long_name": "pressure at the microphone per pressure in the touched cavity"}
        shape = (count, points, len(microphones), len(study.frequency))
        variables[name] = Variable(("case", "point", "microphone", "frequency"), about, shape=shape)
    state, reason = {"long_name": "0 waiting, 1 done, 2 failed"}, {"long_name": "why the case failed"}
    variables["state"] = Variable(("case",), state, shape=(count,), dtype="int8", fill=WAITING)
    variables["reason"] = Variable(("case",), reason, shape=(count,), dtype="string", fill="")
    return Layout(attributes, variables, block)


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
    transfer_functions: Mapping[int, NDArray[np.complex128]] = field(default_factory=dict)
    """Transfer functions of cases by number, where the study keeps them; (n_point, n_microphone, n_freq) complex128,
    Pa/Pa."""
    mistakes: tuple[str, ...] = ()
    """Tracebacks of mistakes of the program, each once; they go into the log, not into the store."""


class Records:
    """Records of one store.

    Args:
        path: of the store.
        layout: what is computed.
    """

    def __init__(self, path: Path, layout: Layout) -> None:
        self.path, self.layout = path, layout
        #: Study as :meth:`studies.study.study.Study.content` gives it.
        self.content: dict[str, Any] = json.loads(layout.attributes["study_content"])
        kinds = {name: variable.attributes.get("kind") for name, variable in layout.variables.items()}
        #: Names of the variables that were varied, and of those that were computed.
        self.parameters = tuple(name for name, kind in kinds.items() if kind == "parameter")
        self.metrics = tuple(name for name, kind in kinds.items() if kind == "metric")

    @classmethod
    def of_store(cls, path: Path) -> Records:
        """Records of a store that has one of its study.

        Raises:
            StudyError: the record of the study is missing, damaged or of another version.
        """
        return cls(path, Layout.unpacked(read_record(path / FOLDER / "study", _KIND, "study", StudyError)))

    def begin(self) -> None:
        """Keep the record of the study."""
        (self.path / FOLDER).mkdir(parents=True, exist_ok=True)
        write_record(self.path / FOLDER / "study", _KIND, "study", self.layout.packed())

    @property
    def keeps_responses(self) -> bool:
        """True if transfer functions are kept."""
        return TRANSFER_FUNCTIONS[0] in self.layout.variables

    def blocks(self) -> Iterator[tuple[int, int]]:
        """First case of each block, and the one after its last."""
        (count,) = self.layout.variables["state"].shape
        for first in range(0, count, self.layout.block):
            yield first, min(first + self.layout.block, count)

    def write(self, result: BlockResult) -> None:
        """Keep a block, its metrics last: from then on it counts."""
        if self.keeps_responses:
            _, *rest = self.layout.variables[TRANSFER_FUNCTIONS[0]].shape
            padded = np.full((len(result.state), *rest), complex(np.nan, np.nan))
            for number, values in result.transfer_functions.items():
                padded[number - result.first, : len(values)] = values
            self._write(result.first, "responses", packed({"transfer_function": padded}, {}))
        values = np.array([result.values[name] for name in self.metrics], np.float64)
        arrays: dict[str, NDArray[Any]] = {"values": values, "state": np.asarray(result.state, np.int8)}
        self._write(result.first, "metrics", packed(arrays, {"reason": list(result.reason)}))

    def is_done(self, first: int) -> bool:
        """True if the block that begins with a case was computed; whether it is damaged or lost shows :meth:`block`."""
        shown = self.path / "state" / "c" / str(first // self.layout.block)  # in the Zarr store, written afterwards
        return self._file(first, "metrics").exists() or shown.exists()

    def block(self, first: int) -> BlockResult:
        """Results of the block that begins with a case, without its transfer functions, which must be there.

        Raises:
            StudyError: a record is missing or damaged.
        """
        arrays, about = unpacked(self._read(first, "metrics"))
        if self.keeps_responses and not self._file(first, "responses").exists():
            raise StudyError(kind=Kind.MISSING, file=self._file(first, "responses"))
        values = dict(zip(self.metrics, arrays["values"], strict=True))
        return BlockResult(first, values, arrays["state"], tuple(about["reason"]))

    def responses(self, first: int) -> NDArray[np.complex128]:
        """Transfer functions of the block that begins with a case.

        Returns:
            (n, n_point, n_microphone, n_freq) complex128, Pa/Pa; NaN where a case failed or has fewer points.

        Raises:
            StudyError: the record is missing or damaged.
        """
        return unpacked(self._read(first, "responses"))[0]["transfer_function"]

    def forget(self, first: int) -> None:
        """Remove a block; its metrics first, so that it no longer counts."""
        for what in ("metrics", "responses"):
            self._file(first, what).unlink(missing_ok=True)

    def _file(self, first: int, what: str) -> Path:
        return self.path / FOLDER / f"{first // self.layout.block:06d}.{what}"

    def _key(self, first: int, what: str) -> str:
        return json.dumps([self.content, self.layout.attributes["atlas"], first, what], sort_keys=True)

    def _write(self, first: int, what: str, content: bytes) -> None:
        write_record(self._file(first, what), _KIND, self._key(first, what), content)

    def _read(self, first: int, what: str) -> bytes:
        return read_record(self._file(first, what), _KIND, self._key(first, what), StudyError)
