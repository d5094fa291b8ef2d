"""Figures of merit of a list of designs, where a search needs them now: the runner of sweeps without its store."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from geometry import ArrayDesign, DesignError
from studies.study.cases import PROGRAM_ERROR, Cases
from studies.study.metric_registry import Metric
from studies.study.study import Study
from studies.sweep.workers import Workers

if TYPE_CHECKING:
    from acoustic_fem.membrane.disc import KnownDiscs


def design_metrics(
    values: Sequence[Mapping[str, Any]],
    study: Study,
    metrics: Sequence[Metric],
    team: Workers,
    parts: int = 1,
    designs: Sequence[ArrayDesign] | None = None,
    discs: KnownDiscs | None = None,
) -> tuple[NDArray[np.float64], tuple[str, ...]]:
    """Metrics of designs, with the base, the fidelity and the frequencies of a study.

    Args:
        values: of each design by dotted name, the same names in each; they need not be those of the study.
        study: gives base, fidelity and frequencies.
        metrics: what to compute.
        team: who computes.
        parts: in how many parts the designs are handed out.
        designs: the valid ones among them, where they are built already.
        discs: membranes that need not be solved.

    Returns:
        (n_design, n_metric) float64, NaN where it failed, and for each design why it failed, or nothing.

    Raises:
        RuntimeError: one failed by a mistake of the program.
    """
    from studies.sweep.block import Job, solve_block

    names = [metric.name for metric in metrics]
    job = Job(study.fidelity, study.frequency, tuple(names), discs=discs)
    cases = _cases(values, study.base)
    ends = np.linspace(0, len(values), min(max(parts, 1), len(values)) + 1).round().astype(int).tolist()
    blocks = list(pairwise(ends))
    closed = study.fidelity in CLOSED_FORMS
    cells = {} if closed else _cells(_valid(values, study) if designs is None else designs, study, team)
    table = np.full((len(values), len(names)), np.nan)
    reasons = [""] * len(values)
    tasks = ((job, cases.part(*block), block[0], cells) for block in blocks)
    for number, (result, _) in team.run(solve_block, tasks):
        part = slice(*blocks[number])
        table[part] = np.column_stack([result.values[name] for name in names])
        reasons[part] = result.reason
    for reason in reasons:
        if reason.startswith(PROGRAM_ERROR):
            raise RuntimeError(reason)  # no property of a design: a search must not learn from it
    return table, tuple(reasons)


def _cases(values: Sequence[Mapping[str, Any]], base: ArrayDesign) -> Cases:
    """Columns of objects, so that whole numbers stay whole. No name: the base itself, under its own name."""
    rows = [dict(each) or {"name": base.name} for each in values]
    columns = [np.array([row[name] for row in rows], dtype=object) for name in rows[0]]
    return Cases(base, tuple(rows[0]), tuple(columns))


def _valid(values: Sequence[Mapping[str, Any]], study: Study) -> Iterator[ArrayDesign]:
    """Designs whose values go together; of the others their block says why."""
    for each in values:
        try:
            yield study.base.with_values(each)
        except DesignError:
            continue


def _cells(designs: Iterable[ArrayDesign], study: Study, team: Workers) -> dict[Any, Any]:
    """Every distinct 3-D cell of the designs, solved once."""
    from studies.sweep.block import cells_of
    from studies.sweep.retries import solved_cells

    keys = list(dict.fromkeys(key for design in designs for key in cells_of(design)))
    return dict(solved_cells(team, keys, study.frequency, study.fidelity))
