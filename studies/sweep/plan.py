"""Cost of a study before it is run: cases, distinct cells, time and memory."""

from __future__ import annotations

import math
from dataclasses import dataclass

from acoustic_fem.cell.design_cells import cached_count
from geometry.ground.typed import PathLike
from studies.study.cases import by_kind, sobol_note
from studies.study.study import Study, resolve_study
from studies.sweep.cost import elapsed, seconds_of, team_size
from studies.sweep.records import block_size, point_count, response_shapes
from studies.sweep.survey import surveyed

#: Memory of a worker that has loaded everything, and of one that solves a 3-D cell, bytes.
_WORKER_MEMORY = 0.25e9
_CELL_MEMORY = 1.0e9
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
    """Number of distinct 3-D cells; 0 where cells are closed forms."""
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


def plan_sweep(study: Study | PathLike, workers: int | None = None) -> Plan:
    """Cost of a study: its cases and cells counted, a few of its cases measured in closed form.

    Raises:
        Refusal: as :func:`studies.sweep.survey.surveyed`.
    """
    study = resolve_study(study)
    found = surveyed(study, every=True)
    cases = found.cases
    valid = [number for number in range(len(cases)) if number not in found.refused]
    cells = found.cells_of(valid)
    cached = cached_count(cells, study.frequency, study.solid_fidelity)
    alone = seconds_of(study, cases, valid, cells, found.discs)
    team = workers or team_size(alone)
    microphones, size = len(study.base.microphones), {"double": 16, "single": 8}[study.precision]
    values = point_count(cases) * microphones * len(study.frequency) * 16
    kept = sum(math.prod(sizes) for sizes in response_shapes(study, point_count(cases)).values()) * size
    memory = team * (_WORKER_MEMORY + block_size(study, cases) * values * _ARRAYS)
    if len(cells) > cached:
        memory += team * _CELL_MEMORY
    stored = 8 * (len(study.metrics) + len(cases.names) + 1) + kept
    refused = {why: len(numbers) for why, numbers in by_kind(found.refused.items()).items()}
    return Plan(
        len(cases), cases.left_out, refused, len(cells), cached, elapsed(alone, team),
        team, memory, stored * len(cases), sobol_note(study),
    )  # fmt: skip
