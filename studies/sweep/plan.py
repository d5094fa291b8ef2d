"""What a study will cost, before it is run: cases, distinct cells, time and memory."""

from __future__ import annotations

from dataclasses import dataclass

from acoustic_fem.cell.design_cells import is_cached
from geometry import DesignError
from studies.study.cases import cases_of, sobol_note
from studies.study.failure_reasons import by_kind
from studies.study.study import Study, StudyError
from studies.sweep.block import CellKey, Job, cells_of, check_metrics, discs_of
from studies.sweep.cost import elapsed, seconds_of, team_size
from studies.sweep.store import block_size, point_count

#: Memory of a worker that has loaded everything, and of one that solves a 3-D cell, bytes.
_WORKER_MEMORY = 0.25e9
_CELL_MEMORY = 1.5e9
#: Arrays of a block that exist at the same time, in transfer functions.
_ARRAYS = 12


@dataclass(frozen=True)
class Plan:
    """Cost of a study, before it is run."""

    cases: int
    """Number of cases of the study."""
    left_out: int
    """Number of combinations or samples that broke a constraint."""
    refused: dict[str, int]
    """Number of cases whose design is not valid, per kind of reason, each by its first."""
    cells: int
    """Number of distinct 3-D cells; 0 at the lumped fidelity."""
    cells_cached: int
    """Number of those in the cache of this machine."""
    seconds: float
    """Time to expect with this number of workers of this machine, their start included, s."""
    workers: int
    """Number of workers: as given, or as many as pay."""
    memory: float
    """Memory to expect of all workers together, bytes."""
    storage: float
    """Size of the store before compression, bytes."""
    note: str
    """Note on the sample; empty where there is nothing to know."""


def plan_sweep(study: Study, workers: int | None = None) -> Plan:
    """Cost of a study: its cases and cells counted, a few of its cases measured in closed form.

    Raises:
        StudyError: a metric does not suit the study.
    """
    cases = cases_of(study)
    job = Job(study.fidelity, study.frequency, study.metrics, study.transfer_functions)
    refused: list[tuple[int, str]] = []
    cells: dict[CellKey, None] = {}
    valid: list[int] = []
    for number in range(len(cases)):
        try:
            design = cases.design(number)
            if not valid:
                check_metrics(job, design)
            valid.append(number)
            if study.fidelity != "lumped":
                cells |= dict.fromkeys(cells_of(design))
        except DesignError as error:
            refused.append((number, str(error)))
        except ValueError as error:
            if not valid:
                raise StudyError(f"{study.name}: {error}") from None
            refused.append((number, str(error)))
    cached = sum(is_cached(cell, study.frequency, air, study.fidelity) for cell, air in cells)
    alone = seconds_of(study, cases, valid, cells, discs_of(cases))
    team = workers or team_size(alone)
    values = point_count(cases) * len(study.base.microphones) * len(study.frequency) * 16
    memory = team * (_WORKER_MEMORY + block_size(study, cases) * values * _ARRAYS)
    if len(cells) > cached:
        memory += team * _CELL_MEMORY
    stored = 8 * (len(study.metrics) + len(cases.names) + 1) + (values if study.transfer_functions else 0)
    return Plan(
        len(cases), cases.left_out, {why: len(numbers) for why, numbers in by_kind(refused).items()}, len(cells),
        cached, elapsed(alone, team), team, memory, stored * len(cases), sobol_note(study),
    )  # fmt: skip
