"""Run a study: blocks of cases over processes or machines, into a store that survives being killed.

Blocks depend on the study alone, each is computed by one worker in one thread, and one process writes them as
they come. A sweep that was killed and started again ends in the same store as what was not.
"""

from __future__ import annotations

import json
import traceback
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from time import perf_counter
from typing import IO, Any

from acoustic_fem.cell.design_cells import cached_count
from acoustic_fem.library.provenance import versions
from acoustic_fem.membrane.disc_table import DiscTables, disc_tables
from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from geometry.ground.extras import check_extras
from geometry.ground.refusal import Kind, Refusal, said_by
from geometry.ground.typed import PathLike
from studies.output.display import Display
from studies.study.cases import Cases, repeated_note
from studies.study.metric_registry import metrics_named
from studies.study.study import Study, resolve_study
from studies.sweep.block import CellKey, Job, SolvedCell
from studies.sweep.cluster import WorkersLost
from studies.sweep.cost import seconds_of, team_size
from studies.sweep.progress import Progress, progress_of, shown_on
from studies.sweep.records import DONE, FAILED, WAITING
from studies.sweep.results import Sweep, open_sweep
from studies.sweep.retries import solved_blocks, solved_cells
from studies.sweep.store import SweepStore, check_store, sole_writer
from studies.sweep.summary import Summary
from studies.sweep.survey import surveyed
from studies.sweep.workers import Workers, open_workers


class SweepError(Refusal):
    """Refusal of a sweep that did not compute all of its cases; what is done is kept."""


def run_sweep(
    study: Study | PathLike,
    out: PathLike,
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Callable[[Progress], None] | None = None,
    display: Display | None = None,
) -> Sweep:
    """Results of a study, which is computed or continued. Their ``summary`` is that of this run.

    Args:
        study: the study, or its file.
        out: the store, a folder ``*.zarr``. If it holds an earlier run of this study, that run is continued.
        workers: number of processes on this machine, with one thread each; 1 computes in this process. By default one
            per core if that saves more time than their start takes, otherwise 1.
        scheduler: address of a dask scheduler whose workers are used instead, such as ``tcp://10.0.0.1:8786``.
        progress: function that is called when results arrive.
        display: shows progress.

    Raises:
        StudyError: ``out`` holds something else or another study, or a metric does not suit the study.
        OverlapError: the base of the study cannot be built.
        SweepError: workers were lost; running again continues.
    """
    study = resolve_study(study)
    if display is None:
        return _run_sweep(study, Path(out), workers, scheduler, progress)
    with display.stage("Sweep") as report:
        told = shown_on(report, often=display.terminal)

        def both(now: Progress) -> None:
            told(now)
            if progress is not None:
                progress(now)

        return _run_sweep(study, Path(out), workers, scheduler, both)


def _run_sweep(
    study: Study,
    out: Path,
    workers: int | None,
    scheduler: str | None,
    progress: Callable[[Progress], None] | None,
) -> Sweep:
    started = perf_counter()
    check_store(out)
    found = surveyed(study, progress=progress)
    cases, metrics = found.cases, metrics_named(study.metrics)
    for metric in metrics:
        check_extras(f"what computes {metric.name}", *metric.extras)
    job = Job(study.fidelity, study.frequency, study.metrics, study.keep, study.outside)
    with sole_writer(out) as log:  # from before the store is made: of two that begin at once, one does
        store = SweepStore.claim(out, study, cases, metrics)
        waiting = store.waiting()
        notes = dict.fromkeys(store.notes)
        if store.attributes["code_version"] != versions(None, ())["code_version"]:
            notes[f"begun by version {store.attributes['code_version']} of acoustic-fem"] = None
        if repeated := repeated_note(cases):
            notes[repeated] = None
        before = int((store.state != WAITING).sum())
        write_line(log, "start", **versions(study.seed, ()), waiting_blocks=len(waiting))
        cells: dict[CellKey, SolvedCell] = {}
        if waiting:
            needed = {block: found.cells_of(range(*block)) for block in waiting}
            keys = list(dict.fromkeys(key for block in needed.values() for key in block))
            pool = open_workers(_team(study, cases, waiting, keys, found.discs, workers, scheduler), scheduler)
            try:
                with pool as team:
                    if study.membranes == "interpolated":
                        job = replace(job, discs=_interpolate_discs(team, found.discs))
                    cells = _solve_cells(team, study, keys, progress, log)
                    _solve_blocks(team, job, cases, store, waiting, needed, cells, progress, notes, log)
            except WorkersLost as error:
                raise _stopped(out, str(error)) from None
            except (OSError, MemoryError) as error:  # the cases at hand wait
                write_line(log, "stopped", traceback="".join(traceback.format_exception(error)))
                raise _stopped(out, _lack(error)) from None
        state = store.state
        summary = Summary(
            cases=len(cases),
            computed=int((state != WAITING).sum()) - before,
            failures=store.failures(),
            cells=len(cells),
            cells_solved=sum(not cell.cached and cell.admittance is not None for cell in cells.values()),
            cell_seconds=sum(cell.seconds for cell in cells.values() if not cell.cached),
            seconds=perf_counter() - started,
            notes=tuple(notes),
        )
        done, failed = int((state == DONE).sum()), int((state == FAILED).sum())
        write_line(log, "end", done=done, failed=failed, seconds=round(summary.seconds, 3))
    return replace(open_sweep(out), run=summary)


def _stopped(out: Path, why: str) -> SweepError:
    return SweepError(why, kind=Kind.STOPPED, file=out, remedy="finished cases are kept, run again to continue")


def _lack(error: OSError | MemoryError) -> str:
    """The resource that the machine lacks, in words."""
    if isinstance(error, MemoryError):
        return f"there is not enough memory ({said_by(error)})"
    where = "" if error.filename is None else f" ({error.filename})"
    return f"{error.strerror or said_by(error)}{where}"


def _team(
    study: Study,
    cases: Cases,
    waiting: list[tuple[int, int]],
    cells: Collection[CellKey],
    discs: Sequence[DiscShape],
    workers: int | None,
    scheduler: str | None,
) -> int | None:
    """Workers of this machine: as configured, or as many as pay for the remaining cases."""
    if workers is not None or scheduler is not None:
        return workers
    numbers = [number for block in waiting for number in range(*block)]
    missing = len(cells) - cached_count(cells, study.frequency, study.solid_fidelity)
    return team_size(seconds_of(study, cases, numbers, missing, discs).seconds)


def _interpolate_discs(team: Workers, discs: Sequence[DiscShape]) -> DiscTables:
    """Tables of the membranes of all cases, waiting or not, so that every run has the same."""

    def solve(shapes: Sequence[DiscShape]) -> list[ElasticDisc]:
        solved = dict(team.run(solve_dimensionless, ((shape,) for shape in shapes)))
        return [solved[number] for number in range(len(shapes))]

    return DiscTables(disc_tables(discs, solve))


def _solve_cells(
    team: Workers,
    study: Study,
    keys: Sequence[CellKey],
    progress: Callable[[Progress], None] | None,
    log: IO[str],
) -> dict[CellKey, SolvedCell]:
    """Every distinct cell once."""
    solved: dict[CellKey, SolvedCell] = {}
    started, failed = perf_counter(), 0
    for key, cell in solved_cells(team, keys, study.frequency, study.solid_fidelity):
        solved[key] = cell
        failed += cell.admittance is None
        if cell.mistake:
            write_line(log, "mistake", traceback=cell.mistake)
        if progress is not None:
            progress(progress_of("cells", len(solved), len(keys), failed, len(solved), perf_counter() - started))
    return solved


def _solve_blocks(
    team: Workers,
    job: Job,
    cases: Cases,
    store: SweepStore,
    waiting: list[tuple[int, int]],
    needed: Mapping[tuple[int, int], tuple[CellKey, ...]],
    cells: Mapping[CellKey, SolvedCell],
    progress: Callable[[Progress], None] | None,
    notes: dict[str, None],
    log: IO[str],
) -> None:
    done, failed, computed = int((store.state != WAITING).sum()), int((store.state == FAILED).sum()), 0
    started = perf_counter()
    for result, warned in solved_blocks(team, job, cases, waiting, needed, cells):
        store.write(result)
        for note in team.notes:
            if note not in notes:
                write_line(log, "note", note=note)
        for mistake in result.mistakes:
            write_line(log, "mistake", first=result.first, traceback=mistake)
        notes |= dict.fromkeys((*warned, *team.notes))
        count = len(result.state)
        done, computed = done + count, computed + count
        failed += int((result.state == FAILED).sum())
        write_line(log, "block", first=result.first, cases=count)
        if progress is not None:
            progress(progress_of("cases", done, len(cases), failed, computed, perf_counter() - started))


# -- log --------------------------------------------------------------------------------------------
def write_line(log: IO[str], event: str, **content: Any) -> None:
    """Write one line of JSON with the time."""
    now = datetime.now(UTC).isoformat(timespec="milliseconds")
    log.write(json.dumps({"time": now, "event": event, **content}) + "\n")
    log.flush()
