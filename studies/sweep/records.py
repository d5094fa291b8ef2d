"""Records of a sweep: one of its study, and one of each block of cases that was computed.

They lie in the folder ``records`` of the store. The record of the study says what is computed, with the values of all
parameters. The record of a block holds the metrics of its cases. Responses are large, so they stand in the Zarr store
alone. They are written before the record, which holds the SHA-256 of their files: a block with a record is done. Keys
name the study and the block, so that a record of another study or place is damage. Metrics in the Zarr store are
written from the records alone.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.library.provenance import versions
from geometry import ArrayDesign
from geometry.design.design_file import write_design
from geometry.ground.file_checks import read_bytes
from geometry.ground.record import packed, read_record, sha256, unpacked, write_record
from geometry.ground.refusal import Kind
from geometry.schema.declared_fields import field_named
from localize.datasets.splits import DEFAULT_SHARES, split_of
from studies.output.zarr_files import Layout, Variable, chunk_name, read_dense
from studies.study.cases import Cases
from studies.study.fields import Keep
from studies.study.metric_registry import Metric
from studies.study.parameter import StudyError
from studies.study.study import Study

FOLDER = "records"
"""Folder of the records in a store."""
MARK = "acoustic_fem_sweep"
"""Attribute that marks a store and states the format of it and of its records."""
FORMAT = 6
_KIND = f"sweep {FORMAT}"
RESPONSES = "responses"
"""Group of the store with the responses, where the study keeps them."""
KEPT: dict[Keep, tuple[str, ...]] = {
    "metrics": (),
    "responses": ("transfer_function",),
    "libraries": ("transfer_function", "point_impedance", "microphone_impedance"),
}
"""Responses that a store holds, by the word of the study. The source response of a library is the product of its
transfer function and its point impedance."""
#: Versions that may change a result.
_LIBRARIES = ("gmsh", "numcodecs", "numpy", "scikit-fem", "scipy", "xarray", "zarr")
#: Complex values of transfer functions worked on in one block, and most cases of one.
_BLOCK_VALUES = 400_000
_LARGEST_BLOCK = 1024
SPLIT = "split"
"""Variable with the split of each case."""
PARTS = ("real", "imag")
"""Parts of a complex response, each of which is a variable."""
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
        "keep": study.keep,
        "study": study.text,
        "study_content": json.dumps(study.content()),
        "base_design": write_design(study.base.completed()),
        "parameter_names": json.dumps(cases.names),
        "metric_names": json.dumps([metric.name for metric in metrics]),
        "coordinates": " ".join([SPLIT, *cases.names]),
        "block": block,
        "left_out": cases.left_out,
        **made,
    }
    numbers = Variable(("case",), {"long_name": "number of the case"}, np.arange(count))
    variables = {"case": numbers, SPLIT: _splits(cases)}
    for name, column in zip(cases.names, cases.columns, strict=True):
        known = field_named(ArrayDesign, name)
        about = {"long_name": known.description, "units": known.unit or "1"} if known else {"units": "mm"}
        variables[name] = Variable(("case",), {"kind": "parameter", **about}, column)
    for metric in metrics:
        about = {"kind": "metric", "units": metric.unit, "long_name": metric.long_name}
        variables[metric.name] = Variable(("case",), about, shape=(count,))
    state, reason = {"long_name": "0 waiting, 1 done, 2 failed"}, {"long_name": "why the case failed"}
    variables["state"] = Variable(("case",), state, shape=(count,), dtype="int8", fill=WAITING)
    variables["reason"] = Variable(("case",), reason, shape=(count,), dtype="string", fill="")
    if KEPT[study.keep]:
        variables |= _responses(study, numbers, variables[SPLIT], points)
    return Layout(attributes, variables, block)


def case_key(values: Mapping[str, Any]) -> str:
    """Key of a case, on which its split depends: the values of its parameters by name, as JSON."""
    return json.dumps(values)


def _splits(cases: Cases) -> Variable:
    """Split of each case, that which data sets deal it to where nobody asks for other shares or another seed."""
    splits = split_of([case_key(cases.case(number)) for number in range(len(cases))])
    shares = ", ".join(f"{share:g} {name}" for name, share in DEFAULT_SHARES.items())
    return Variable(("case",), {"long_name": "split by design, seed 0", "shares": shares}, splits.astype(object))


def _responses(study: Study, numbers: Variable, splits: Variable, points: int) -> dict[str, Variable]:
    """Variables of the group of responses: coordinates, and real and imaginary part of each response."""
    microphones = np.array(study.base.microphones, dtype=object)
    coordinates = {
        "case": numbers,
        SPLIT: splits,
        "point": Variable(("point",), {"long_name": "sensing point, from 1"}, np.arange(1, points + 1)),
        "microphone": Variable(("microphone",), {"long_name": "microphone"}, microphones),
        "frequency": Variable(("frequency",), {"units": "Hz", "long_name": "frequency"}, study.frequency),
    }
    if study.keep == "libraries":
        second = {"long_name": "second microphone"}
        coordinates["microphone_2"] = Variable(("microphone_2",), second, microphones)
    dtype, found = {"double": "float64", "single": "float32"}[study.precision], {}
    for name, sizes in response_shapes(study, points).items():
        dimensions, unit, title = acoustic_fem.library.VARIABLES[name]
        shape = (len(numbers.start()), *sizes)
        for part in PARTS:
            about = {"units": unit, "long_name": f"{title}, {part} part"}
            found[f"{name}_{part}"] = Variable(("case", *dimensions), about, shape=shape, dtype=dtype)
    return {f"{RESPONSES}/{name}": variable for name, variable in {**coordinates, **found}.items()}


def response_shapes(study: Study, points: int) -> dict[str, tuple[int, ...]]:
    """Shape of each response that a study keeps of a case, by name; the largest case has so many points."""
    sizes = {"point": points, "frequency": len(study.frequency)}
    sizes |= dict.fromkeys(("microphone", "microphone_2"), len(study.base.microphones))
    return {name: tuple(sizes[each] for each in acoustic_fem.library.VARIABLES[name][0]) for name in KEPT[study.keep]}


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
    responses: Mapping[int, Mapping[str, NDArray[np.complex128]]] = field(default_factory=dict)
    """Responses of cases by number and name, where the study keeps them; (n_point, n_microphone, n_freq) complex128
    and others, of the axes and units of :data:`acoustic_fem.library.transfer_functions.VARIABLES`."""
    solid: tuple[int, ...] = ()
    """Numbers of the cases outside the atlas that were solved in 3-D."""
    about: Mapping[int, Mapping[str, Any]] = field(default_factory=dict)
    """Provenance of cases by number, as JSON can hold it, where libraries are kept."""
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
    def kept(self) -> tuple[str, ...]:
        """Names of the responses that are kept."""
        return KEPT[self.content["keep"]]

    @property
    def precision(self) -> str:
        """Precision of the responses that are kept."""
        return str(self.content["precision"])

    def blocks(self) -> Iterator[tuple[int, int]]:
        """First case of each block, and the one after its last."""
        (count,) = self.layout.variables["state"].shape
        for first in range(0, count, self.layout.block):
            yield first, min(first + self.layout.block, count)

    def padded(self, result: BlockResult) -> dict[str, NDArray[Any]]:
        """Responses of a block by variable, as the store holds them, (n_case, ...) float64 or float32.

        NaN stands where a case failed or has fewer points.
        """
        found: dict[str, NDArray[Any]] = {}
        for name in self.kept:
            for part in PARTS:
                variable = self.layout.variables[f"{RESPONSES}/{name}_{part}"]
                values = np.full((len(result.state), *variable.shape[1:]), np.nan, variable.dtype)
                for number, own in result.responses.items():
                    values[number - result.first, : len(own[name])] = getattr(own[name], part)
                found[f"{RESPONSES}/{name}_{part}"] = values
        return found

    def write(self, result: BlockResult, sums: Mapping[str, str]) -> None:
        """Keep a block: from then on it counts.

        Args:
            result: of the block.
            sums: SHA-256 of the files of its responses by variable, which are written already.
        """
        values = np.array([result.values[name] for name in self.metrics], np.float64)
        arrays: dict[str, NDArray[Any]] = {"values": values, "state": np.asarray(result.state, np.int8)}
        cases = {str(number): dict(own) for number, own in result.about.items()}
        about = {"reason": list(result.reason), "sums": dict(sums), "solid": list(result.solid), "cases": cases}
        content = packed(arrays, about)
        write_record(self._file(result.first), _KIND, self._key(result.first), content)

    def is_done(self, first: int) -> bool:
        """True if the block that begins with a case was computed; whether it is damaged or lost shows :meth:`block`."""
        shown = self.path / chunk_name("state", 1, first // self.layout.block)  # written after the record
        return self._file(first).exists() or shown.exists()

    def block(self, first: int) -> BlockResult:
        """Results of the block that begins with a case, without its responses.

        Raises:
            StudyError: the record is missing or damaged, or a file of responses is missing.
        """
        arrays, about = self._read(first)
        for name in about["sums"]:
            if not self._chunk_path(name, first).exists():
                raise StudyError(kind=Kind.MISSING, file=self._chunk_path(name, first))
        values = dict(zip(self.metrics, arrays["values"], strict=True))
        cases = {int(number): own for number, own in about["cases"].items()}
        reason, solid = tuple(about["reason"]), tuple(about["solid"])
        return BlockResult(first, values, arrays["state"], reason, solid=solid, about=cases)

    def check_responses(self, first: int) -> None:
        """Refuse a block of which a file of responses is not the one that was written.

        Raises:
            StudyError: it is missing or damaged.
        """
        for name, digest in self._read(first)[1]["sums"].items():
            self._chunk(name, first, digest)

    def responses(self, first: int, names: Sequence[str]) -> dict[str, NDArray[np.complex128]]:
        """Responses of the block that begins with a case, by name.

        Args:
            first: number of the case.
            names: of responses that are kept.

        Returns:
            (n, ...) complex128 each, of the axes and units of
            :data:`acoustic_fem.library.transfer_functions.VARIABLES`; NaN where a case failed or has fewer points.

        Raises:
            StudyError: a file of theirs, or the record, is missing or damaged.
        """
        arrays, about = self._read(first)
        count, found = len(arrays["state"]), {}
        for name in names:
            parts = []
            for part in PARTS:
                stored = f"{RESPONSES}/{name}_{part}"
                content = self._chunk(stored, first, about["sums"][stored])
                parts.append(read_dense(content, self.layout.variables[stored], self.layout.block)[:count])
            values = np.empty(parts[0].shape, np.complex128)
            values.real, values.imag = parts
            found[name] = values
        return found

    def forget(self, first: int) -> None:
        """Remove the record of a block, so that it no longer counts."""
        self._file(first).unlink(missing_ok=True)

    def _chunk(self, name: str, first: int, digest: str) -> bytes:
        """Content of the file with a block of a response, which is the one that was written."""
        path = self._chunk_path(name, first)
        content = read_bytes(path, "a part of the results of a sweep", StudyError)
        if sha256(content) != digest:
            raise StudyError("is damaged: its SHA-256 differs from the recorded one", kind=Kind.DAMAGED, file=path)
        return content

    def _chunk_path(self, name: str, first: int) -> Path:
        dimensions = len(self.layout.variables[name].shape)
        return self.path / chunk_name(name, dimensions, first // self.layout.block)

    def _file(self, first: int) -> Path:
        return self.path / FOLDER / f"{first // self.layout.block:06d}.metrics"

    def _key(self, first: int) -> str:
        return json.dumps([self.content, self.layout.attributes["atlas"], first], sort_keys=True)

    def _read(self, first: int) -> tuple[dict[str, NDArray[Any]], dict[str, Any]]:
        return unpacked(read_record(self._file(first), _KIND, self._key(first), StudyError))
