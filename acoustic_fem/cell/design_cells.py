"""The cells of a design in 3-D: solved once each, side by side in processes, and kept on disk."""

from __future__ import annotations

import threading
from collections.abc import Iterable, Sequence
from functools import partial

from acoustic_fem.cell.one_cell import (
    DESIGN_BAND,
    CellRecord,
    CellSolution,
    CellTask,
    rebuilt,
    solve_task,
    too_large,
)
from acoustic_fem.cell.side_by_side import solve_side_by_side
from acoustic_fem.cell.solid import Progress, checked_physics
from acoustic_fem.numerics import disk_cache
from acoustic_fem.numerics.processors import cores
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell
from geometry.ground.typed import Array

#: Processor time of a cell that is not in the cache, s: a middling one of the prototypes', 1 to 5 s, and its part of
#: the start of the processes, 2 s each.
SECONDS_PER_CELL = 3.0


def solve_cells(
    cells: Sequence[Cell],
    frequency: FrequencyLike,
    air: AirLike,
    fidelity: str = "navier-stokes",
    progress: Progress | None = None,
    *,
    apart: bool = False,
) -> dict[Cell, CellSolution]:
    """Nodal admittances of the cells of a design, in 3-D.

    The membrane (or the microphone's diaphragm) is a moving wall with a fixed shape, (1 - (r/a)^2)^2 for a
    membrane and 1 - (r/a)^2 at the end of a sound hole; the pressure of its node is the mean weighted by
    that shape. Its mechanics belong to the network, so another membrane needs no new solve.

    Cells that are not in the cache are solved in as many processes as there are cores. A run that is killed keeps the
    cells it had finished.

    Args:
        cells: distinct cells.
        frequency: (n_freq,) Hz, ascending, 1e-3 to 2000.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        fidelity: ``"navier-stokes"`` or ``"helmholtz"``.
        progress: called with the label of a cell, its number among them, and the fraction done of all.
        apart: solve a single cell in a process of its own, too, which is left to the next call for a few seconds: what
            stops that one does not stop the caller, and the caller's other threads go on.

    Returns:
        Per cell its solution.

    Raises:
        Refusal: bad frequencies or fidelity.
        CellError: a cell could not be meshed or solved.
        CellFault: the program failed in a process of its own; the traceback is on stderr.
    """
    medium = medium_of(air)
    grid = frequency_grid(frequency)
    checked_physics(fidelity)
    tasks = [CellTask(cell, medium, _band(grid), fidelity) for cell in cells]
    records = {task: record for task in tasks if (record := disk_cache.fetch(task.key)) is not None}
    missing = [task for task in tasks if task not in records]
    done = {task: float(task in records) for task in tasks}

    def report(task: CellTask, fraction: float) -> None:
        done[task] = fraction
        if progress is not None:
            origin = "" if task in missing else " (from the cache)"
            count = f"{tasks.index(task) + 1} of {len(tasks)}: "
            progress(count + task.cell.label + origin, sum(done.values()) / len(tasks))

    def keep(task: CellTask, record: CellRecord) -> None:
        records[task] = record
        disk_cache.store(task.key, *record)

    for task in tasks:
        if task not in missing:
            report(task, 1.0)
    workers = min(len(missing), cores())
    # Meshing stops the other threads of a process, such as those of a server.
    apart = apart or threading.current_thread() is not threading.main_thread()
    if workers > 1 or (apart and missing):
        # Chambers and what has many tubes take longest: begun last, they would leave the other processes idle.
        missing.sort(key=lambda task: (task.cell.kind == "microphone", len(task.cell.ports)), reverse=True)
        solve_side_by_side(missing, workers, report, keep, apart)
    else:
        for task in missing:
            keep(task, solve_task(task, partial(report, task)))
    return {task.cell: rebuilt(task, records[task], grid, cached=task not in missing) for task in tasks}


def is_cached(cell: Cell, frequency: FrequencyLike, air: AirLike, fidelity: str = "navier-stokes") -> bool:
    """True if :func:`solve_cells` would find a cell in the cache; arguments as there, frequency (n_freq,) in Hz."""
    medium = medium_of(air)
    return cached_count([(cell, medium)], frequency_grid(frequency), fidelity) == 1


def too_large_cell(cells: Iterable[Cell], frequency: FrequencyLike, air: AirLike) -> str:
    """Why a cell needs a mesh that is too large for a solution in 3-D; empty where each is small enough.

    Takes a fraction of a second for each cell that is not in the cache, because its air is drawn.

    Args:
        cells: the cells.
        frequency: (n_freq,) Hz, as of :func:`solve_cells`.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Raises:
        Refusal: the air of a cell cannot be made.
    """
    medium, band = medium_of(air), _band(frequency_grid(frequency))
    tasks = (CellTask(cell, medium, band, "navier-stokes") for cell in cells)
    return next(filter(None, (too_large(task) for task in tasks if not disk_cache.holds(task.key))), "")


def cached_count(cells: Iterable[tuple[Cell, Medium]], grid: Array, fidelity: str) -> int:
    """Number of cells, each with its gas, that are in the cache at a grid of :func:`frequency_grid`."""
    return sum(disk_cache.holds(CellTask(cell, medium, _band(grid), fidelity).key) for cell, medium in cells)


def kept_cell(
    cell: Cell, frequency: FrequencyLike, air: AirLike, fidelity: str = "navier-stokes"
) -> tuple[CellSolution, CellRecord] | None:
    """Solution of a cell that the cache of this machine holds, and its record; None where there is none.

    Args:
        cell: the cell.
        frequency: (n_freq,) Hz, as of :func:`solve_cells`.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        fidelity: ``"navier-stokes"`` or ``"helmholtz"``.
    """
    medium = medium_of(air)
    grid = frequency_grid(frequency)
    task = CellTask(cell, medium, _band(grid), fidelity)
    record = disk_cache.fetch(task.key)
    return None if record is None else (rebuilt(task, record, grid, cached=True), record)


def keep_cell(cell: Cell, frequency: FrequencyLike, air: AirLike, fidelity: str, record: CellRecord) -> None:
    """Keep a cell that was solved on another machine; arguments as of :func:`kept_cell`, and its record."""
    medium = medium_of(air)
    if not is_cached(cell, frequency, medium, fidelity):
        disk_cache.store(CellTask(cell, medium, _band(frequency_grid(frequency)), fidelity).key, *record)


def _band(grid: Array) -> tuple[float, float]:
    return min(DESIGN_BAND[0], float(grid[0])), max(DESIGN_BAND[1], float(grid[-1]))
