"""What a study will cost, before it is run: cases, distinct cells, time and memory."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from time import process_time

from acoustic_fem.design_cells import is_cached
from acoustic_fem.disc_table import disc_count
from geometry import DesignError
from studies.cases import Cases, cases_of, sobol_note
from studies.study import Study, StudyError
from studies.sweep_cases import CellKey, Job, cells_of, check_metrics, discs_of, solve_block
from studies.sweep_store import block_size, point_count
from studies.sweep_workers import cores

#: Processor time of one cell that is not in the cache, s: array-2x6, the start of its process included.
SECONDS_PER_CELL = {"helmholtz": 6.0, "navier-stokes": 15.0}
#: Of one membrane.
_SECONDS_PER_DISC = 0.22
#: Memory of a worker that has loaded everything, and of one that solves a 3-D cell, bytes.
_WORKER_MEMORY = 0.25e9
_CELL_MEMORY = 1.5e9
#: Arrays of a block that exist at the same time, in transfer functions.
_ARRAYS = 12
#: Cases that are computed to measure the time of one, and designs that are looked at to count cells.
_TRIED = 32


@dataclass(frozen=True)
class Plan:
    """What a study will cost.

    Attributes:
        cases: of the study.
        left_out: combinations or samples that broke a constraint.
        refused: per reason the number of cases whose design is not valid.
        cells: distinct 3-D cells; 0 at the lumped fidelity.
        cells_cached: of those, in the cache of this machine.
        seconds: expected, with the given number of workers of this machine.
        workers: that number.
        memory: expected of all workers together, bytes.
        storage: of the store before compression, bytes.
        note: what to know of the sample; empty where there is nothing.
    """

    cases: int
    left_out: int
    refused: dict[str, int]
    cells: int
    cells_cached: int
    seconds: float
    workers: int
    memory: float
    storage: float
    note: str


def plan_sweep(study: Study, workers: int | None = None) -> Plan:
    """Count the cases and cells of a study, and measure a few of its cases in closed form.

    Raises:
        StudyError: a metric does not suit the study.
    """
    cases = cases_of(study)
    job = Job(study.fidelity, study.frequency, study.metrics, study.transfer_functions)
    refused: Counter[str] = Counter()
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
            refused[str(error)] += 1
        except ValueError as error:
            if not valid:
                raise StudyError(f"{study.name}: {error}") from None
            refused[str(error)] += 1
    cached = sum(is_cached(cell, study.frequency, air, study.fidelity) for cell, air in cells)
    team = workers or cores()
    seconds = _seconds_per_case(study, cases, valid) * len(valid)
    seconds += SECONDS_PER_CELL.get(study.fidelity, 0.0) * (len(cells) - cached)
    seconds += _SECONDS_PER_DISC * disc_count(discs_of(cases))
    seconds /= team
    values = point_count(cases) * len(study.base.microphones) * len(study.frequency) * 16
    memory = team * (_WORKER_MEMORY + block_size(study, cases) * values * _ARRAYS)
    if len(cells) > cached:
        memory += team * _CELL_MEMORY
    stored = 8 * (len(study.metrics) + len(cases.names) + 1) + (values if study.transfer_functions else 0)
    return Plan(
        len(cases), cases.left_out, dict(refused.most_common()), len(cells), cached, seconds, team, memory,
        stored * len(cases), sobol_note(study),
    )  # fmt: skip


def _seconds_per_case(study: Study, cases: Cases, valid: list[int]) -> float:
    """Processor time of one case without its 3-D cells; a 3-D network costs as much as a lumped one."""
    if not valid:
        return 0.0
    import numpy as np

    chosen = np.array(valid)[np.unique(np.linspace(0, len(valid) - 1, _TRIED).astype(int))]
    few = Cases(cases.base, cases.names, tuple(column[chosen] for column in cases.columns))
    job = Job("lumped", study.frequency, study.metrics, False)
    for _ in range(2):  # the second time all modules are loaded and the membranes are known
        start = process_time()
        if study.fidelity == "lumped":
            solve_block(job, few, 0, {})
        else:
            for number in range(len(few)):
                solve_block(job, few.part(number, number + 1), 0, {})
        seconds = (process_time() - start) / len(few)
    return seconds
