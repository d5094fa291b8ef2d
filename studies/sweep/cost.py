"""Cost of the cases of a study, and how many processes of this machine that is worth: a run and its plan agree."""

from __future__ import annotations

from collections.abc import Sequence
from time import process_time
from typing import NamedTuple

import numpy as np

from acoustic_fem.cell.design_cells import SECONDS_PER_CELL
from acoustic_fem.membrane.design_discs import design_disc
from acoustic_fem.membrane.disc_table import disc_count
from acoustic_fem.membrane.elasticity import REFINEMENT
from acoustic_fem.membrane.half_section import DiscShape, half_section
from acoustic_fem.membrane.solved_discs import is_kept
from acoustic_fem.numerics.processors import cores
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from studies.study.cases import Cases
from studies.study.study import Study
from studies.sweep.block import FAILURES, Job, solve_block

#: Processor time of a membrane per unknown of its mesh, s; and so many membranes stand for all.
_SECONDS_PER_UNKNOWN, _SOME = 9e-6, 16
#: Time until workers of this machine compute: processes are started and modules loaded, and ended afterwards.
START_UP = 4.0
#: Workers must save so many times their start-up; what is expected is not known better.
_WORTH = 2.0
#: Cases that are timed, how often cheap ones are repeated up to a batch of the usual size, and what is long enough, s.
_TIMED, _REPEATED, _LONG = 4, (4, 16), 0.1


class Expected(NamedTuple):
    """Processor time that cases take."""

    seconds: float
    """Time of all of them, s."""
    loading: float
    """Time in which this process loaded what they need, once, s; 0 where it was there."""


def team_size(seconds: float) -> int:
    """Number of processes for what takes so many seconds of one: as many as there are cores where that pays, or one."""
    count = cores()
    return count if seconds * (1 - 1 / count) > _WORTH * START_UP else 1


def elapsed(seconds: float, workers: int) -> float:
    """Time in which processes of this machine do what takes one of them so many seconds, s."""
    return seconds if workers == 1 else START_UP + seconds / workers


def seconds_of(
    study: Study,
    cases: Cases,
    numbers: Sequence[int],
    missing: float,
    discs: Sequence[DiscShape],
    fraction: float = 1.0,
) -> Expected:
    """Processor time that some cases will take.

    Args:
        study: the study.
        cases: all of its cases, or a sample of them.
        numbers: of those that are computed.
        missing: number of 3-D cells to solve.
        discs: the membranes of these cases, each once.
        fraction: size of the sample, of one; the others take as long.
    """
    membranes = seconds_of_discs(study, len(cases), discs, fraction)  # before some of them are solved
    each, loading = _seconds_per_case(study, cases, numbers)
    return Expected(each * len(numbers) / fraction + SECONDS_PER_CELL * missing + membranes, loading)


def seconds_of_discs(study: Study, cases: int, discs: Sequence[DiscShape], fraction: float = 1.0) -> float:
    """Processor time of the membranes that are not on disk, s.

    Args:
        study: the study, which says whether they are interpolated.
        cases: number of cases that have them.
        discs: the membranes, each once.
        fraction: size of the sample of cases, of one.
    """
    if not discs:
        return 0.0
    chosen = discs[:: -(-len(discs) // _SOME)]
    each = _SECONDS_PER_UNKNOWN * float(np.mean([half_section(disc, REFINEMENT).unknowns for disc in chosen]))
    if study.membranes == "interpolated":
        return each * disc_count(discs)
    missing = sum(not is_kept(disc) for disc in discs)
    # if most cases of a sample have a membrane of their own, so have those outside it
    return each * (missing / fraction if 2 * len(discs) > cases else missing)


def _seconds_per_case(study: Study, cases: Cases, numbers: Sequence[int]) -> tuple[float, float]:
    """Processor time of one case without its 3-D cells and membranes, and that of the first one beyond it, s.

    A 3-D network costs as much as a lumped one.
    """
    chosen: list[int] = []
    if not len(numbers):
        return 0.0, 0.0
    for number in np.array(numbers, int)[np.unique(np.linspace(0, len(numbers) - 1, _TIMED + 1).astype(int))]:
        try:
            design = cases.design(int(number))
            for kind in design.kinds:
                design_disc(design.of_kind(kind))  # the membranes: from now on known
        except FAILURES:
            continue  # the case fails by name when it is computed
        chosen.append(int(number))
    if not chosen:
        return 0.0, 0.0
    first = _timed(study, cases, chosen[:1])  # all modules are loaded
    for batch in (chosen[-1:], chosen, *(chosen * often for often in _REPEATED)):
        seconds = _timed(study, cases, batch)
        if seconds * len(batch) > _LONG:
            break
    return seconds, max(0.0, first - seconds)


def _timed(study: Study, cases: Cases, chosen: Sequence[int]) -> float:
    alone = study.fidelity not in CLOSED_FORMS
    job = Job("lumped" if alone else study.fidelity, study.frequency, study.metrics, study.keep)
    few = Cases(cases.base, cases.names, tuple(column[chosen] for column in cases.columns))
    start = process_time()
    for part in [few.part(k, k + 1) for k in range(len(few))] if alone else [few]:
        solve_block(job, part, 0, {})
    return (process_time() - start) / len(few)
