"""Work of a sweep's worker: the metrics of consecutive cases, and single 3-D cells.

Cases of one topology whose cells are closed forms are computed in one vectorised call; what a batch cannot hold, and
every 3-D fidelity, case by case with the admittances of the cells given. A case that fails keeps its reason and stops
no other; a mistake of the program says so in its reason, and keeps its traceback. A full disk, memory that does not
suffice and a package that is missing are no fault of a case: they end the sweep, and the case waits.
"""

from __future__ import annotations

import gc
import traceback
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from itertools import compress
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Medium
from acoustic_fem.atlas.cell_table import OutsideAtlas, cell_atlas
from acoustic_fem.batch.network import batch_response, each_alone
from acoustic_fem.batch.openings import OpeningSizes, designs_outside
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters, fits_batch
from acoustic_fem.batch.topology import Topology
from acoustic_fem.cell.design_cells import kept_cell, solve_cells
from acoustic_fem.cell.one_cell import CellError, CellRecord, CellSolution
from acoustic_fem.library.network_responses import closed_form, joined_cells, named_responses
from acoustic_fem.library.transfer_functions import VARIABLES
from acoustic_fem.membrane.design_discs import design_shape
from acoustic_fem.membrane.disc import KnownDiscs
from acoustic_fem.membrane.disc_table import ACCURACY
from acoustic_fem.quantities.fidelity import CLOSED_FORMS, Fidelity
from acoustic_fem.quantities.local_air import design_air
from geometry import ArrayDesign, DesignError
from geometry.air.cells import Cell, cell_catalogue
from geometry.ground.extras import NotInstalled
from geometry.ground.refusal import Kind, Refusal
from geometry.layout.arrangement import place_housings
from studies.metrics.batch_responses import Responses
from studies.metrics.shared import SharedFigures
from studies.study.cases import PROGRAM_ERROR, Cases
from studies.study.fields import Keep, Outside
from studies.study.metric_registry import Metric, metrics_named
from studies.sweep.records import DONE, FAILED, KEPT, BlockResult

#: A cell in its air.
CellKey: TypeAlias = tuple[Cell, Medium]
Complex: TypeAlias = NDArray[np.complex128]

_LONGEST_REASON = 500
#: What stops a case as a property of its design: it is refused, or cannot be computed (libraries raise more than
#: refusals). All else is a mistake of the program, but for what the machine lacks.
FAILURES = (Refusal, np.linalg.LinAlgError, ArithmeticError)
LACKS = (OSError, MemoryError, NotInstalled)
"""Errors that stop a sweep because its machine lacks something; the case at hand keeps waiting."""


@dataclass(frozen=True, eq=False)
class Job:
    """Job that all blocks of a sweep have in common."""

    fidelity: Fidelity
    """Fidelity that the cells are computed with."""
    frequency: NDArray[np.float64]
    """Frequencies of the study; (n_freq,) float64, Hz."""
    metrics: tuple[str, ...]
    """Names of the metrics."""
    keep: Keep = "metrics"
    """Results of a case that are handed back: "metrics", also "responses", or everything that "libraries" need."""
    outside: Outside = "fail"
    """Fate of a case outside the atlas: "fail", or "navier-stokes" with the cells that are given."""
    discs: KnownDiscs | None = None
    """Membranes that are interpolated between solved ones; None: all are solved."""


@dataclass(frozen=True, eq=False)
class SolvedCell:
    """Admittance of a 3-D cell on the study's frequencies, or why there is none."""

    admittance: Complex | None
    """Admittance of the cell; (n_freq, k + 1, k + 1) complex128, m^3/(Pa s); None where it could not be solved."""
    reason: str = ""
    """Reason why it could not be solved; empty where it could."""
    seconds: float = 0.0
    """Processor time that its solution took when it was made, s."""
    cached: bool = False
    """True if it came from the cache."""
    summary: Mapping[str, Any] = field(default_factory=dict)
    """How it was solved, as JSON can hold it; nothing that differs from run to run."""
    record: CellRecord | None = None
    """Record of the cell, for the cache of another machine."""
    mistake: str = ""
    """Traceback, where a mistake of the program is the reason."""


def solve_cell(key: CellKey, frequency: NDArray[np.float64], fidelity: str) -> SolvedCell:
    """Admittance of one cell, solved or taken from the cache of this machine.

    Args:
        key: the cell and its air.
        frequency: (n_freq,) float64, Hz.
        fidelity: "helmholtz" or "navier-stokes".

    Raises:
        Exception: one of :data:`LACKS`.
    """
    cell, medium = key
    try:
        solution = solve_cells([cell], frequency, medium, fidelity, apart=True)[cell]
    except Exception as error:
        why, mistake = _reason(error)
        return SolvedCell(None, why, mistake=mistake)
    kept = kept_cell(cell, frequency, medium, fidelity)
    record = None if kept is None else kept[1]
    return SolvedCell(solution.admittance, "", solution.seconds, solution.cached, lasting(solution), record)


def lasting(solution: CellSolution) -> dict[str, Any]:
    """How a cell was solved, without what differs from run to run."""
    return {name: value for name, value in solution.summary().items() if name not in ("seconds", "cached")}


def cells_of(design: ArrayDesign) -> tuple[CellKey, ...]:
    """Distinct cells of a design, in its air."""
    air = design_air(design)
    return tuple((cell, air) for cell in cell_catalogue(design, place_housings(design)).distinct)


@dataclass
class _Block:
    """Results of a block while it is being computed."""

    count: int
    values: dict[str, NDArray[np.float64]]
    reason: list[str]
    responses: dict[int, dict[str, Complex]] = field(default_factory=dict)
    solid: list[int] = field(default_factory=list)
    about: dict[int, dict[str, Any]] = field(default_factory=dict)
    mistakes: dict[str, None] = field(default_factory=dict)

    def fail(self, numbers: Iterable[int], error: Exception, where: str = "") -> None:
        """Keep the first reason for which cases fail.

        Raises:
            Exception: one of :data:`LACKS`.
        """
        why, mistake = _reason(error, where)
        if mistake:
            self.mistakes[mistake] = None
        for number in numbers:
            self.reason[number] = self.reason[number] or why[:_LONGEST_REASON]


def solve_block(
    job: Job, cases: Cases, first: int, cells: Mapping[CellKey, SolvedCell]
) -> tuple[BlockResult, tuple[str, ...]]:
    """Metrics of some cases.

    Args:
        job: what to compute.
        cases: the cases of the block.
        first: number of the first of them in the study.
        cells: the 3-D cells of their designs; empty where cells are closed forms.

    Returns:
        The results, and the warnings that came up, each once.

    Raises:
        Exception: one of :data:`LACKS`.
    """
    metrics = metrics_named(job.metrics)
    block = _Block(len(cases), {metric.name: np.full(len(cases), np.nan) for metric in metrics}, [""] * len(cases))
    with _uncollected(), warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        if job.fidelity == "atlas":
            cell_atlas().warn_above(job.frequency)
        designs: dict[int, ArrayDesign] = {}
        for number in range(len(cases)):
            try:
                designs[number] = cases.buildable(number)
            except DesignError as error:
                block.fail([number], error)
        for numbers, responses in _responses(job, designs, cells, block):
            _measure(numbers, responses, metrics, block)
            for place, number in enumerate(numbers if KEPT[job.keep] else ()):
                if not block.reason[number]:
                    block.responses[number] = {name: getattr(responses, name)[place] for name in KEPT[job.keep]}
    state = np.array([FAILED if why else DONE for why in block.reason], dtype=np.int8)
    kept, about = ({first + k: own for k, own in each.items()} for each in (block.responses, block.about))
    solid = tuple(first + number for number in sorted(block.solid))
    result = BlockResult(first, block.values, state, tuple(block.reason), kept, solid, about, tuple(block.mistakes))
    ours = (UserWarning, RuntimeWarning)
    return result, tuple(dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, ours)))


@contextmanager
def _uncollected() -> Iterator[None]:
    """No search for circles of objects: a block leaves next to none, and all modules would be looked through for them
    again and again, which takes a twelfth of its time.
    """
    was = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()


# -- responses --------------------------------------------------------------------------------------
def _responses(
    job: Job, designs: Mapping[int, ArrayDesign], cells: Mapping[CellKey, SolvedCell], block: _Block
) -> list[tuple[list[int], Responses]]:
    """Responses of the designs in groups of equal topology, with the places of each group in the block."""
    groups: dict[Topology, list[int]] = {}
    alone: list[int] = []
    for number, design in designs.items():
        if job.fidelity in CLOSED_FORMS and fits_batch(design):
            groups.setdefault(Topology.of(design), []).append(number)
        else:
            alone.append(number)
    found: list[tuple[list[int], Responses]] = []
    for topology, numbers in groups.items():
        try:
            inside, responses = _batch(job, topology, [designs[number] for number in numbers])
        except (*FAILURES, MemoryError):
            alone += numbers  # one of them is at fault, or they are too many at once: that shows case by case
        except Exception as error:
            block.fail(numbers, error)
        else:
            alone += compress(numbers, ~inside)
            if responses is not None:
                within = list(compress(numbers, inside))
                found.append((within, responses))
                for number in within if job.keep == "libraries" else ():
                    block.about[number] = _provenance(job, designs[number], cells, job.fidelity)
    single: dict[tuple[int, ...], list[tuple[int, Responses]]] = {}
    for number in sorted(alone):
        try:
            one = _alone(job, designs[number], cells, number, block)
        except Exception as error:
            block.fail([number], error)
        else:
            single.setdefault(one.transfer_function.shape, []).append((number, one))
    found += [([number for number, _ in each], _joined([one for _, one in each])) for each in single.values()]
    return found


def _batch(job: Job, topology: Topology, designs: Sequence[ArrayDesign]) -> tuple[NDArray[np.bool_], Responses | None]:
    """Mask of the designs that a batch can hold, with the responses of these; cells of the rest: outside the atlas."""
    states: dict[Any, Medium] = {}
    for design in designs:
        if design.air not in states:
            states[design.air] = design_air(design)
    media = [states[design.air] for design in designs]
    medium = media[0] if len(states) == 1 else MediumParameters.from_media(media)
    # of the same designs whatever the others of the block are: their own air, diaphragm and vent
    parameters = [
        ArrayParameters.from_designs([d for d in designs if d.air == air], state, job.discs)
        for air, state in states.items()
    ]
    joined = parameters[0] if len(parameters) == 1 else _in_order(parameters, designs, list(states))
    inside = np.ones(len(designs), dtype=bool)
    if job.fidelity == "atlas":
        inside = ~designs_outside(OpeningSizes.of(joined), topology, job.frequency, medium)
    if not inside.any():
        return inside, None
    if not inside.all():
        designs, media = list(compress(designs, inside)), list(compress(media, inside))
        joined = joined.map(lambda values: values[inside])
        medium = media[0] if len(set(media)) == 1 else MediumParameters.from_media(media)
    return inside, Responses(
        frequency=job.frequency,
        designs=tuple(designs),
        medium=tuple(media),
        discs=job.discs,
        parameters=joined,
        **_batch_responses(job, joined, topology, medium),
    )


def _batch_responses(
    job: Job, parameters: ArrayParameters, topology: Topology, medium: Medium | MediumParameters
) -> dict[str, Complex]:
    """Responses of the designs of a batch by their names; those of a library as :func:`acoustic_fem.solve` has them."""
    if job.keep == "libraries":
        alone = each_alone(parameters, topology, job.frequency, medium, job.fidelity)
        named = [named_responses(one) for one in alone]
        return {name: np.stack([one[name] for one in named]) for name in named[0]}
    response = batch_response(parameters, topology, job.frequency, medium, job.fidelity)
    return {name: getattr(response, name) for name in VARIABLES}


def _in_order(parts: list[ArrayParameters], designs: Sequence[ArrayDesign], states: list[Any]) -> ArrayParameters:
    """Parameters of the designs of each air, put back in the order of the designs."""
    group = np.array([states.index(design.air) for design in designs])
    order = np.argsort(np.argsort(group, kind="stable"), kind="stable")
    return ArrayParameters(
        **{name: np.concatenate([getattr(part, name) for part in parts])[order] for name in vars(parts[0])}
    )


def _alone(job: Job, design: ArrayDesign, cells: Mapping[CellKey, SolvedCell], number: int, block: _Block) -> Responses:
    """One design, in 3-D if it is outside the atlas and the study asks for that."""
    fidelity: Fidelity = job.fidelity
    try:
        found = _network(job, design, cells, fidelity)
    except OutsideAtlas:
        if job.outside == "fail":
            raise
        fidelity = job.outside
        found = _network(job, design, cells, fidelity)
        block.solid.append(number)
    if job.keep == "libraries":
        block.about[number] = _provenance(job, design, cells, fidelity)
    return found


def _provenance(
    job: Job, design: ArrayDesign, cells: Mapping[CellKey, SolvedCell], fidelity: Fidelity
) -> dict[str, Any]:
    """Provenance of a library of the design, beyond what all cases have in common."""
    about: dict[str, Any] = {}
    if fidelity not in CLOSED_FORMS:
        about["cells"] = [{"cell": key[0].label, **cells[key].summary} for key in cells_of(design)]
    discs = job.discs
    if discs is not None and any(discs.find(design_shape(design.of_kind(kind))) for kind in design.kinds):
        about["membranes"] = f"interpolated between solutions, to {ACCURACY:g}"
    return about


def _network(job: Job, design: ArrayDesign, cells: Mapping[CellKey, SolvedCell], fidelity: Fidelity) -> Responses:
    """One design, its cells given or in closed form."""
    air = design_air(design)

    def admittance(cell: Cell) -> Complex:
        if fidelity in CLOSED_FORMS:
            return closed_form(fidelity, cell, job.frequency, air)
        solved = cells[cell, air]
        if solved.admittance is None:
            raise CellError(solved.reason, kind=Kind.NO_RESULT)
        return solved.admittance

    def admittances(distinct: tuple[Cell, ...]) -> dict[Cell, Complex]:
        return {cell: admittance(cell) for cell in distinct}

    found = joined_cells(design, job.frequency, air, admittances, job.discs)
    responses: dict[str, Any] = {name: values[None] for name, values in found.items()}
    return Responses(frequency=job.frequency, designs=(design,), medium=(air,), discs=job.discs, **responses)


def _joined(parts: Sequence[Responses]) -> Responses:
    """Several designs with equally many points in one batch."""

    def all_of(name: str) -> Any:
        return np.concatenate([getattr(part, name) for part in parts])

    return Responses(
        frequency=parts[0].frequency,
        designs=tuple(design for part in parts for design in part.designs or ()),
        medium=tuple(air for part in parts for air in part.medium or ()),
        discs=parts[0].discs,
        **{
            name: all_of(name)
            for name in ("transfer_function", "source_response", "point_impedance", "microphone_impedance")
        },
    )


def _one(responses: Responses, number: int) -> Responses:
    """One design of a batch."""
    part = slice(number, number + 1)

    def cut(values: Any) -> Any:
        return None if values is None else values[part]

    return replace(
        responses,
        parameters=None,
        **{
            name: cut(getattr(responses, name))
            for name in (
                "transfer_function",
                "designs",
                "medium",
                "source_response",
                "point_impedance",
                "microphone_impedance",
            )
        },
    )


# -- metrics ----------------------------------------------------------------------------------------
def _measure(numbers: Sequence[int], responses: Responses, metrics: Sequence[Metric], block: _Block) -> None:
    figures = SharedFigures(responses, (level for metric in metrics for level in metric.noise_levels))
    for metric in metrics:
        values, where = block.values[metric.name], f"metric {metric.name}: "
        try:
            values[list(numbers)] = metric.of_batch(responses, figures)
        except (*FAILURES, MemoryError):  # one design is at fault, or all are: each has its own reason
            for place_in_batch, number in enumerate(numbers):
                try:
                    values[number] = metric.of_batch(_one(responses, place_in_batch))[0]
                except Exception as error:
                    block.fail([number], error, where)
        except Exception as error:
            block.fail(numbers, error, where)
        block.fail(
            (number for number in numbers if np.isnan(values[number])),
            Refusal("is not a number", kind=Kind.NO_RESULT),
            where,
        )


def _reason(error: Exception, where: str = "") -> tuple[str, str]:
    """Why a case failed, in one line, and the traceback where that is a mistake of the program.

    Raises:
        Exception: the error, where no case is to blame for it.
    """
    if isinstance(error, LACKS):
        raise error
    message = " ".join(str(error).split())
    if isinstance(error, FAILURES):
        named = isinstance(error, Refusal) and message
        return where + (message if named else f"{type(error).__name__}: {message}"), ""
    last = traceback.extract_tb(error.__traceback__)[-1]
    why = f"{PROGRAM_ERROR}{where}{type(error).__name__} in {Path(last.filename).name}:{last.lineno}: {message}"
    return why, "".join(traceback.format_exception(error))
