"""Cells and blocks of a sweep on its workers, also those that end the processes that compute them.

A cell is solved once for all workers: what one has solved goes into the cache of the process that asks, which looks
there first, so that neither another worker nor the next run solves it again.

A block that ends several workers is halved until the cases that do it are alone: they fail, with that for a reason,
and the others are computed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.cell.design_cells import keep_cell, kept_cell
from studies.study.cases import Cases
from studies.study.metric_registry import metrics_named
from studies.sweep.block import CellKey, Job, SolvedCell, lasting, solve_block, solve_cell
from studies.sweep.records import FAILED, BlockResult
from studies.sweep.workers import Workers

#: Why a case or a cell failed that no worker survived.
ENDED_WORKERS = "ended the processes that computed it, which may lack memory"
Block = tuple[int, int]
Solved = tuple[BlockResult, tuple[str, ...]]


def solved_cells(
    team: Workers, keys: Sequence[CellKey], frequency: NDArray[np.float64], fidelity: str
) -> Iterator[tuple[CellKey, SolvedCell]]:
    """Distinct 3-D cells, each solved once or taken from the cache, as they come.

    Args:
        team: who computes.
        keys: the cells, each once.
        frequency: (n_freq,) float64, Hz.
        fidelity: "helmholtz" or "navier-stokes".
    """
    missing = []
    for key in keys:
        kept = kept_cell(key[0], frequency, key[1], fidelity)
        if kept is None:
            missing.append(key)
        else:
            solution = kept[0]
            summary = lasting(solution)
            yield key, SolvedCell(solution.admittance, seconds=solution.seconds, cached=True, summary=summary)
    tasks = ((key, frequency, fidelity) for key in missing)
    for number, solved in team.run(solve_cell, tasks, lost=lambda *_: SolvedCell(None, ENDED_WORKERS)):
        key = missing[number]
        if solved.record is not None:
            keep_cell(key[0], frequency, key[1], fidelity, solved.record)
        yield key, replace(solved, record=None)


def solved_blocks(
    team: Workers,
    job: Job,
    cases: Cases,
    blocks: list[Block],
    needed: Mapping[Block, tuple[CellKey, ...]],
    cells: Mapping[CellKey, SolvedCell],
) -> Iterator[Solved]:
    """Results of blocks of cases, and the warnings that came up in each, as they come.

    Args:
        team: who computes.
        job: what to compute.
        cases: all cases of the study.
        blocks: first case and the one after the last of each.
        needed: the 3-D cells of each block.
        cells: those cells, solved.
    """

    def attempt(parts: list[Block], own: Mapping[CellKey, SolvedCell] | None = None) -> Iterator[tuple[Block, Any]]:
        tasks = (
            (job, cases.part(*part), part[0], own or {key: cells[key] for key in needed.get(part, ())})
            for part in parts
        )
        for number, solved in team.run(solve_block, tasks, lost=_nothing):
            yield parts[number], solved

    def halved(block: Block, own: Mapping[CellKey, SolvedCell]) -> Solved:
        first, stop = block
        if stop - first == 1:
            return _failed(job, first), ()
        middle = (first + stop) // 2
        parts = dict(attempt([(first, middle), (middle, stop)], own))
        return _joined([parts[part] or halved(part, own) for part in sorted(parts)])

    ending = []
    for block, solved in attempt(blocks):
        if solved is None:
            ending.append(block)
        else:
            yield solved
    for block in ending:  # last, for workers are lost over them
        yield halved(block, {key: cells[key] for key in needed.get(block, ())})


def _nothing(*_: Any) -> None:
    """In place of the result of a task that ended its workers."""


def _failed(job: Job, number: int) -> BlockResult:
    values = {metric.name: np.full(1, np.nan) for metric in metrics_named(job.metrics)}
    return BlockResult(number, values, np.array([FAILED], np.int8), (ENDED_WORKERS,))


def _joined(halves: list[Solved]) -> Solved:
    """Consecutive results as one."""
    results = [result for result, _ in halves]
    joined = BlockResult(
        first=results[0].first,
        values={name: np.concatenate([result.values[name] for result in results]) for name in results[0].values},
        state=np.concatenate([result.state for result in results]),
        reason=tuple(reason for result in results for reason in result.reason),
        responses={k: own for result in results for k, own in result.responses.items()},
        solid=tuple(number for result in results for number in result.solid),
        about={k: own for result in results for k, own in result.about.items()},
        mistakes=tuple(dict.fromkeys(mistake for result in results for mistake in result.mistakes)),
    )
    return joined, tuple(dict.fromkeys(note for _, notes in halves for note in notes))
