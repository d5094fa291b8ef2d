"""The cells of a design in 3-D: solved once each, side by side in processes, and kept on disk."""

from __future__ import annotations

import json
import os
import queue
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import cell_cache
from acoustic_fem.cell import Progress, checked_physics, converge
from acoustic_fem.checks import frequency_grid
from acoustic_fem.medium import Medium
from geometry.cavity_shapes import Box, Dome
from geometry.cells import Cell, CellPort
from geometry.refusal import Refusal

#: Cells of a design are solved over at least this band (Hz), so that another grid finds them in the cache.
DESIGN_BAND = (1.0, 500.0)

#: Largest relative error of the bare cell's admittances that is accepted, up to this frequency (Hz) and beyond
#: it where frequencies above the band are asked for. An opening is a quarter of a cell's resistance and a
#: hundredth of a tube's: seen through its tubes a cell's error is about ten times smaller.
DESIGN_ACCURACY = 3e-3
CHECKED_UP_TO = 200.0

#: Scale of the first mesh; most cells of the prototypes are then within 3e-3.
_FIRST_SCALE = 1.2

#: Part of the cache key: raise it when the mesh or the equations of a cell change.
CELL_MODEL_VERSION = 8

_MODELS = ("heat", "viscous", "flow")

#: Exit status of a process whose cell could not be solved, and of one that ended with a traceback.
_NOT_SOLVED, _TRACEBACK = 3, 1

#: Arrays and plain values of a solved cell, as the cache keeps them.
_Record: TypeAlias = tuple[dict[str, NDArray[Any]], dict[str, Any]]


class CellError(Refusal):
    """A cell could not be solved; the message says which and why."""


class CellFault(RuntimeError):
    """A mistake of the program in the process that solved a cell; the message is the last line of its traceback."""


@dataclass(frozen=True, eq=False)
class CellSolution:
    """Responses of one cell and how they were obtained."""

    admittance: NDArray[np.complex128]
    """(n_freq, k+1, k+1), m^3/(Pa s): the k tube ports in order, then the opening."""
    physics: str
    unknowns: int
    sampled: tuple[float, ...]
    """Frequencies solved in 3-D, Hz; the others come from the rational model."""
    sweep_error: float
    """Estimated relative error of the rational model."""
    mesh_error: float
    """Estimated relative error from the mesh."""
    seconds: float
    """Time the 3-D solves took, when they were made."""
    cached: bool

    def summary(self) -> dict[str, Any]:
        """Everything but the responses, as plain values."""
        return {
            "method": f"3-D {self.physics}",
            "unknowns": self.unknowns,
            "sampled_frequencies": list(self.sampled),
            "sweep_error": self.sweep_error,
            "mesh_error": self.mesh_error,
            "seconds": self.seconds,
            "cached": self.cached,
        }


@dataclass(frozen=True)
class _Task:
    """All that the solution of a cell depends on."""

    cell: Cell
    medium: Medium
    band: tuple[float, float]
    fidelity: str

    @property
    def key(self) -> str:
        about = {"model": CELL_MODEL_VERSION, "accuracy": DESIGN_ACCURACY, "gmsh": version("gmsh")}
        return cell_cache.key_of({**_stated(asdict(self)), **about})

    def as_json(self) -> str:
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> _Task:
        plain = json.loads(text)
        ports = tuple(CellPort(**port) for port in plain["cell"].pop("ports"))
        sizes = plain["cell"].pop("shape")
        shape = None if sizes is None else Dome(**sizes) if "depth" in sizes else Box(**sizes)
        return cls(
            cell=Cell(**plain["cell"], ports=ports, shape=shape),
            medium=Medium(**plain["medium"]),
            band=tuple(plain["band"]),
            fidelity=plain["fidelity"],
        )


def solve_cells(
    cells: Sequence[Cell],
    frequency: ArrayLike,
    medium: Medium,
    fidelity: str = "navier-stokes",
    progress: Progress | None = None,
    *,
    apart: bool = False,
) -> dict[Cell, CellSolution]:
    """Nodal admittances of the cells of a design, in 3-D.

    The membrane (or the microphone's diaphragm) is a moving wall with a fixed shape, (1 - (r/a)^2)^2 for a
    membrane and 1 - (r/a)^2 at the end of a sound hole; the pressure of its node is the mean weighted by
    that shape. Its mechanics belong to the network, so another membrane needs no new solve.

    Cells that are not in the cache are solved in one process per core. A run that is killed keeps the
    cells it had finished.

    Args:
        cells: distinct cells.
        frequency: (n_freq,) Hz, ascending, 1e-3 to 2000.
        medium: the gas.
        fidelity: ``"navier-stokes"`` or ``"helmholtz"``.
        progress: called with the label of a cell and the fraction done of all.
        apart: solve a single cell in a process of its own, too: what stops that one does not stop the caller,
            and the caller's other threads go on.

    Returns:
        Per cell its solution.

    Raises:
        Refusal: bad frequencies or fidelity.
        CellError: a cell could not be meshed or solved.
        CellFault: the program failed in a process of its own; the traceback is on stderr.
    """
    grid = frequency_grid(frequency)
    checked_physics(fidelity)
    tasks = [_Task(cell, medium, _band(grid), fidelity) for cell in cells]
    records = {task: record for task in tasks if (record := cell_cache.fetch(task.key)) is not None}
    missing = [task for task in tasks if task not in records]
    done = {task: float(task in records) for task in tasks}

    def report(task: _Task, fraction: float) -> None:
        done[task] = fraction
        if progress is not None:
            origin = "" if task in missing else " (from the cache)"
            progress(task.cell.label + origin, sum(done.values()) / len(tasks))

    def keep(task: _Task, record: _Record) -> None:
        records[task] = record
        cell_cache.store(task.key, *record)

    for task in tasks:
        if task not in missing:
            report(task, 1.0)
    workers = min(len(missing), os.cpu_count() or 1)
    if workers > 1 or (apart and missing):
        _solve_side_by_side(missing, workers, report, keep)
    else:
        for task in missing:
            keep(task, _solve(task, partial(report, task)))
    return {task.cell: _solution(task, records[task], grid, cached=task not in missing) for task in tasks}


def _stated(description: dict[str, Any]) -> dict[str, Any]:
    """Without what is not stated: a cell keeps its place in the cache when cells can state more."""
    plain: dict[str, Any] = {}
    for name, value in description.items():
        if isinstance(value, dict):
            plain[name] = _stated(value)
        elif isinstance(value, tuple):
            plain[name] = [_stated(item) if isinstance(item, dict) else item for item in value]
        elif value is not None:
            plain[name] = value
    return plain


def is_cached(cell: Cell, frequency: ArrayLike, medium: Medium, fidelity: str = "navier-stokes") -> bool:
    """Whether :func:`solve_cells` would find a cell in the cache; arguments as there."""
    return cell_cache.holds(_Task(cell, medium, _band(frequency_grid(frequency)), fidelity).key)


def _band(grid: NDArray[np.float64]) -> tuple[float, float]:
    return min(DESIGN_BAND[0], float(grid[0])), max(DESIGN_BAND[1], float(grid[-1]))


def _solve(task: _Task, report: Callable[[float], None]) -> _Record:
    """Solve one cell."""
    from acoustic_fem.navier_stokes import WallMotion
    from geometry.air import MIRROR, OPENING, air_volume

    cell = task.cell
    try:
        air = air_volume(cell)
        radius = np.linspace(0, cell.opening_diameter / 2, 200)
        bowl = 1 - (radius / radius[-1]) ** 2
        profile = np.column_stack([radius, bowl**2 if cell.opening_length == 0 else bowl])
        faces = {**air.ports, OPENING: air.opening, **({} if air.mirror is None else {MIRROR: air.mirror})}
        solved = converge(
            air.solid,
            faces,
            tuple(air.ports),
            [WallMotion(OPENING, profile, air.centre)],
            None if air.mirror is None else MIRROR,
            task.medium,
            task.band,
            checked_physics(task.fidelity),
            DESIGN_ACCURACY,
            cell.smallest_extent,
            report,
            checked_band=(task.band[0], task.band[1] if task.band[1] > DESIGN_BAND[1] else CHECKED_UP_TO),
            scale=_FIRST_SCALE,
        )
    except (ValueError, RuntimeError, ArithmeticError, MemoryError) as error:
        raise CellError(f"{cell.label}: {error or type(error).__name__}") from error
    body = solved.body
    arrays = {"energies": body.energies}
    models = {}
    for name in _MODELS:
        model = getattr(body, name)
        if model is not None:
            arrays[f"{name}_matrices"], arrays[f"{name}_excitations"] = model.matrices, model.excitations
            models[name] = {key: getattr(model, key) for key in ("sampled", "error", "lowest", "highest")}
    about = {
        "physics": body.physics,
        "n_port": body.n_port,
        "copies": body.copies,
        "unknowns": body.unknowns,
        "mesh_error": solved.mesh_error,
        "seconds": solved.seconds,
        "models": models,
    }
    return arrays, about


def _solution(task: _Task, record: _Record, grid: NDArray[np.float64], cached: bool) -> CellSolution:
    from acoustic_fem.condensed import CondensedBody
    from acoustic_fem.frequency import ReducedModel

    arrays, about = record

    def model(name: str) -> ReducedModel:
        kept = about["models"][name]
        return ReducedModel(
            matrices=arrays[f"{name}_matrices"],
            excitations=arrays[f"{name}_excitations"],
            basis=None,
            sampled=tuple(kept["sampled"]),
            error=kept["error"],
            lowest=kept["lowest"],
            highest=kept["highest"],
        )

    body = CondensedBody(
        physics=about["physics"],
        medium=task.medium,
        n_port=about["n_port"],
        copies=about["copies"],
        heat=model("heat"),
        viscous=model("viscous") if "viscous" in about["models"] else None,
        flow=model("flow"),
        energies=arrays["energies"],
        unknowns=about["unknowns"],
    )
    return CellSolution(
        admittance=body.nodal_admittance(grid),
        physics=body.physics,
        unknowns=body.unknowns,
        sampled=body.flow.sampled,
        sweep_error=body.flow.error,
        mesh_error=about["mesh_error"],
        seconds=about["seconds"],
        cached=cached,
    )


def _solve_side_by_side(
    tasks: Sequence[_Task],
    workers: int,
    report: Callable[[_Task, float], None],
    keep: Callable[[_Task, _Record], None],
) -> None:
    """Solve cells in processes of their own, which hand their results over through a cache of their own.

    Plain child programs rather than a process pool: a pool would import the caller's main program again.
    """
    waiting = list(tasks)
    handover = tempfile.TemporaryDirectory(prefix="acoustic-fem-cells-")
    messages: queue.Queue[tuple[int, str | None]] = queue.Queue()
    running: dict[int, tuple[_Task, subprocess.Popen[str]]] = {}

    def complaints(number: int) -> Path:
        return Path(handover.name) / f"{number}.log"

    def start() -> None:
        number = len(tasks) - len(waiting)
        task = waiting.pop(0)
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
        environment["ACOUSTIC_FEM_CACHE"] = handover.name
        for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
            environment[name] = "1"
        with complaints(number).open("wb") as log:  # the child has its own copy of the handle
            child = subprocess.Popen(
                [sys.executable, "-m", "acoustic_fem.design_cells"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                env=environment,
            )
        running[number] = (task, child)
        threading.Thread(target=listen, args=(number, task, child), daemon=True).start()

    def listen(number: int, task: _Task, child: subprocess.Popen[str]) -> None:
        try:
            if child.stdin is not None and child.stdout is not None:
                # Left open: its end tells the child that its parent is gone.
                child.stdin.write(task.as_json() + "\n")
                child.stdin.flush()
                for line in child.stdout:
                    messages.put((number, line))
        except OSError:
            pass  # the child died early; its exit status says so
        finally:
            messages.put((number, None))

    try:
        for _ in range(workers):
            start()
        while running:
            number, line = messages.get()
            task, child = running[number]
            if line is not None:
                report(task, float(line))
                continue
            status = child.wait()
            said = complaints(number).read_text(encoding="utf-8").strip()
            if status == _TRACEBACK and said:
                print(said, file=sys.stderr)
                raise CellFault(f"{task.cell.label}: {said.splitlines()[-1]}")
            if status != 0:
                raise CellError(said.splitlines()[-1] if said else f"{task.cell.label}: the solver ended with {status}")
            if said:
                print(said, file=sys.stderr)
            del running[number]
            record = cell_cache.fetch(task.key, Path(handover.name))
            if record is None:
                raise CellError(f"{task.cell.label}: the solver ended without a result")
            keep(task, record)
            if waiting:
                start()
    finally:
        for _, child in running.values():
            child.kill()
            child.wait()
        handover.cleanup()


def _child() -> int:
    """Solve the cell described on standard input; write the fraction done to standard output."""
    task = _Task.from_json(sys.stdin.readline())

    def end_with_parent() -> None:
        sys.stdin.read()
        os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()
    try:
        cell_cache.store(task.key, *_solve(task, lambda fraction: print(fraction, flush=True)))
    except CellError as error:
        print(error, file=sys.stderr)
        return _NOT_SOLVED
    return 0


if __name__ == "__main__":
    sys.exit(_child())
