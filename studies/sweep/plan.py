"""Cost of a study before it is run: cases, distinct cells, time and memory."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from acoustic_fem.cell.design_cells import cached_count
from geometry.ground.refusal import counted
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from studies.output.display import Display, duration
from studies.study.cases import Cases, by_kind, repeated_note, sobol_note
from studies.study.study import Study, resolve_study
from studies.sweep.cost import elapsed, seconds_of, team_size
from studies.sweep.progress import shown_on
from studies.sweep.records import block_size, point_count, response_shapes
from studies.sweep.survey import Survey, surveyed

#: Number of cases up to which all are looked at, in a minute or less; of more a sample of so many is.
MOST_SURVEYED = 5000
#: Memory of a worker that has loaded everything, and of one that solves a 3-D cell, bytes.
_WORKER_MEMORY = 0.25e9
_CELL_MEMORY = 1.0e9
#: Arrays of a block that exist at the same time, in transfer functions.
_ARRAYS = 12


@dataclass(frozen=True, repr=False)
class Plan(Shown):
    """Cost of a study, before it is run."""

    cases: int
    """Number of cases of the study."""
    left_out: int
    """Number of combinations or samples that broke a constraint."""
    refused: dict[str, int]
    """Number of cases whose design is not valid, per kind of reason, each by its first."""
    outside: dict[str, int]
    """Number of cases outside the atlas, per kind of reason, each by its first; with ``outside = "fail"`` they fail."""
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
    sampled: int = 0
    """Number of cases that were looked at where that is not all of them: numbers are then estimates. 0 if all were."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return "Plan of a sweep", {
            "cases": self.cases,
            "break a constraint": self.left_out or "",
            "not valid": sum(self.refused.values()) or "",
            "outside the atlas": sum(self.outside.values()) or "",
            "cells": f"{self.cells}, {self.cells_cached} in the cache" if self.cells else "closed forms",
            "time": f"{duration(self.seconds)} with {counted(self.workers, 'worker')}",
            "memory": f"{self.memory / 1e6:.3g} MB",
            "store": f"at most {self.storage / 1e6:.3g} MB",
            "note": self.note,
        }


def plan_sweep(study: Study | PathLike, workers: int | None = None, *, display: Display | None = None) -> Plan:
    """Cost of a study: number of cases and cells, and a time that is estimated from a few cases in closed form.

    If the study has more than 5000 cases, 5000 of them are drawn at random. The numbers of designs and cells are then
    estimates.

    Args:
        study: the study, or its file.
        workers: number of processes on this machine; by default chosen for the shortest time.
        display: shows how many designs were checked.

    Raises:
        Refusal: as :func:`studies.sweep.survey.surveyed`.
    """
    study, show = resolve_study(study), display or Display()
    with show.stage("Plan") as report:
        found = surveyed(study, every=True, most=MOST_SURVEYED, progress=shown_on(report, often=show.terminal))
        return _planned(study, found, workers)


def _planned(study: Study, found: Survey, workers: int | None) -> Plan:
    cases, fraction = found.cases, found.fraction
    count = round(len(cases) / fraction)
    valid = [number for number in range(len(cases)) if number not in found.refused]
    cells = found.cells_of(valid)
    cached = cached_count(cells, study.frequency, study.solid_fidelity)
    distinct = len(cells) if fraction == 1 else _distinct(found, valid)
    cached_in_all = round(cached * distinct / max(len(cells), 1))
    alone = seconds_of(study, cases, valid, distinct - cached_in_all, found.discs, fraction)
    team = workers or team_size(alone.seconds)
    # processes of their own load what they need while they start
    seconds = alone.loading + alone.seconds if team == 1 else elapsed(alone.seconds, team)
    values = point_count(cases) * len(study.base.microphones) * len(study.frequency) * 16
    size = {"double": 16, "single": 8}[study.precision]
    kept = sum(math.prod(sizes) for sizes in response_shapes(study, point_count(cases)).values()) * size
    memory = team * (_WORKER_MEMORY + block_size(study, cases, count) * values * _ARRAYS)
    if distinct > cached_in_all:
        memory += team * _CELL_MEMORY
    stored = 8 * (len(study.metrics) + len(cases.names) + 1) + kept
    refused, outside = (
        {why: round(len(numbers) / fraction) for why, numbers in by_kind(reasons.items()).items()}
        for reasons in (found.refused, found.outside)
    )
    return Plan(
        count, round(cases.left_out / fraction), refused, outside, distinct, cached_in_all, seconds,
        team, memory, stored * count, _note(study, cases, fraction), len(cases) + cases.left_out if fraction < 1 else 0,
    )  # fmt: skip


def _note(study: Study, cases: Cases, fraction: float) -> str:
    repeated = repeated_note(cases) if fraction == 1 else ""
    return "; ".join(note for note in (sobol_note(study), repeated) if note)


def _distinct(found: Survey, numbers: Sequence[int]) -> int:
    """Number of distinct cells of all cases, estimated from a sample.

    A. Chao, Scand. J. Statist. 11 (1984) 265, with the correction for few: cells that one case of the sample has, and
    those that two have, say how many it has not. At most as many as if no two cases outside the sample shared any.
    """
    if not found.cells:
        return 0
    times = Counter(Counter(key for number in numbers for key in set(found.cells[number])).values())
    seen = sum(times.values())
    unseen = times[1] * (times[1] - 1) / (2 * (times[2] + 1))
    return round(min(seen + unseen, seen / found.fraction))
