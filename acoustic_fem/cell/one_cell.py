"""One cell of a design: solved in 3-D over the band of designs, recorded, and rebuilt from its record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.cell.condensed import AirModel, BodyFaces, CondensedBody, Pumped
from acoustic_fem.cell.solid import MarkedSolid, MeshGoal, checked_physics, converge, refuse_large_body
from acoustic_fem.fields.cylinder_heat import CylinderAir, SideBore
from acoustic_fem.fields.navier_stokes import WallMotion
from acoustic_fem.numerics import disk_cache
from acoustic_fem.numerics.rational_sweep import ReducedModel
from acoustic_fem.quantities.fidelity import Physics
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell
from geometry.air.mesh import MeshError
from geometry.air.straight_bores import StraightBore
from geometry.air.volume import MIDPLANE, MIRROR, OPENING, air_volume
from geometry.ground.extras import NotInstalled, installed_version
from geometry.ground.refusal import Kind, Refusal, said_by
from geometry.ground.stated_times import stated_seconds, stopped_time
from geometry.ground.typed import Array, ComplexArray

#: Cells of a design are solved over at least this band (Hz), so that another grid finds them in the cache.
DESIGN_BAND = (1.0, 500.0)


#: Largest relative error of the bare cell's admittances that is accepted, up to this frequency (Hz) and beyond
#: it where frequencies above the band are asked for. An opening is a quarter of a cell's resistance and a
#: hundredth of a tube's: seen through its tubes a cell's error is about ten times smaller.
DESIGN_ACCURACY = 3e-3


CHECKED_UP_TO = 200.0


#: Part of the cache key: raise it when the mesh or the equations of a cell change.
CELL_MODEL_VERSION = 15


_MODELS, _PUMPED = ("heat", "viscous", "flow"), "pumped"


#: Arrays and plain values of a solved cell, as the cache keeps them.
CellRecord: TypeAlias = tuple[dict[str, NDArray[Any]], dict[str, Any]]


class CellError(Refusal):
    """A cell could not be solved; the message says which and why."""


class CellFault(RuntimeError):
    """A mistake of the program in the process that solved a cell; the message is the last line of its traceback."""


@dataclass(frozen=True, eq=False)
class CellSolution:
    """Responses of one cell and how they were obtained."""

    admittance: ComplexArray
    """Nodal admittance, (n_freq, k + 1, k + 1) complex128, m^3/(Pa s): the k tube ports in order, then the opening."""
    physics: str
    """The model it was solved with."""
    unknowns: int
    """Number of unknowns of the largest system solved."""
    sampled: tuple[float, ...]
    """Frequencies solved in 3-D, Hz; the others come from the rational model."""
    sweep_error: float
    """Estimated relative error of the rational model."""
    mesh_error: float
    """Estimated relative error from the mesh."""
    seconds: float
    """Time that the 3-D solves took, when they were made, s."""
    cached: bool
    """True if it came from the cache."""

    def summary(self) -> dict[str, Any]:
        """All but the responses, as plain values; whether it was cached only while the clock of files runs."""
        return {
            "method": f"3-D {self.physics}",
            "unknowns": self.unknowns,
            "sampled_frequencies": list(self.sampled),
            "sweep_error": self.sweep_error,
            "mesh_error": self.mesh_error,
            "seconds": stated_seconds(self.seconds),
            **({"cached": self.cached} if stopped_time() is None else {}),
        }


@dataclass(frozen=True)
class CellTask:
    """All that the solution of a cell depends on."""

    cell: Cell
    """The cell."""
    medium: Medium
    """The gas."""
    band: tuple[float, float]
    """Lowest and highest frequency, Hz."""
    fidelity: str
    """The model, a 3-D one."""

    @property
    def key(self) -> str:
        """Name under which the cell is kept in the cache."""
        about = {"model": CELL_MODEL_VERSION, "accuracy": DESIGN_ACCURACY, "gmsh": installed_version("gmsh")}
        return disk_cache.key_of({**_stated(asdict(self)), **about})


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


def marked_solid(cell: Cell, physics: Physics = "navier-stokes") -> MarkedSolid:
    """The air of a cell with its faces, and the shape in which its membrane, or a microphone's diaphragm, moves.

    Args:
        cell: lengths in mm.
        physics: the model it is to be solved with.

    Raises:
        Refusal: its air cannot be made.
    """
    air = air_volume(cell, level=physics == "navier-stokes")
    radius = np.linspace(0, cell.opening_diameter / 2, 200)
    bowl = 1 - (radius / radius[-1]) ** 2
    profile = np.column_stack([radius, bowl**2 if cell.opening_length == 0 else bowl])
    motions = (WallMotion(OPENING, profile, air.centre),)
    mirror, midplane = (name if name in air.mirrors else None for name in (MIRROR, MIDPLANE))
    return MarkedSolid(air.solid, air.faces, BodyFaces(tuple(air.ports), motions, mirror, midplane), _cylinder(cell))


def _cylinder(cell: Cell) -> CylinderAir | None:
    """The air of a cell whose cavity is a cylinder."""
    if cell.shape is not None:
        return None
    bores = []
    for port in cell.ports:
        radius = port.bore_diameter / 2
        # The wall falls back beside the axis, on an average by a^2 / (8 R).
        bores.append(SideBore(radius, cell.bore_of(port) + radius**2 / (4 * cell.diameter), cell.height_of(port)))
    if cell.opening_length > 0:
        bores.append(SideBore(cell.opening_diameter / 2, cell.opening_length, None))
    return CylinderAir(cell.diameter / 2, cell.height, tuple(bores))


def too_large(task: CellTask) -> str:
    """Why the flow in a cell needs too large a mesh; empty where it does not. The air is drawn, but nothing is meshed.

    Raises:
        Refusal: the air of the cell cannot be made.
    """
    physics = checked_physics(task.fidelity)
    try:
        refuse_large_body(marked_solid(task.cell, physics), AirModel(task.medium, task.band, physics), _goal_of(task))
    except MeshError as error:
        return str(CellError(str(error.problem), kind=Kind.UNSUITABLE, field=task.cell.label))
    return ""


def _goal_of(task: CellTask) -> MeshGoal:
    """How far the meshes of a cell are refined."""
    checked_band = (task.band[0], task.band[1] if task.band[1] > DESIGN_BAND[1] else CHECKED_UP_TO)
    return MeshGoal(DESIGN_ACCURACY, task.cell.smallest_extent, checked_band)


def solve_task(task: CellTask, report: Callable[[float], None]) -> CellRecord:
    """Solve one cell.

    Raises:
        CellError: its air cannot be made or meshed, its solution misses the accuracy, or takes too much memory.
        NotInstalled: nothing can be meshed on this system.
    """
    from OCP.Standard import Standard_Failure

    cell = task.cell
    try:
        physics = checked_physics(task.fidelity)
        solid = marked_solid(cell, physics)
        solved = converge(
            solid,
            AirModel(task.medium, task.band, physics),
            _goal_of(task),
            report,
        )
    except NotInstalled:
        raise  # no fault of this cell
    except (Refusal, Standard_Failure, MemoryError) as error:
        kind = error.kind if isinstance(error, Refusal) else Kind.NO_RESULT
        raise CellError(f"cannot be solved: {said_by(error)}", kind=kind, field=cell.label) from error
    body = solved.body
    arrays = {"energies": body.energies}
    models = {}
    parts = {name: getattr(body, name) for name in _MODELS}
    if body.pumped is not None:
        arrays["pumped_energies"] = body.pumped.energies
        parts[_PUMPED] = body.pumped.flow
    for name, model in parts.items():
        if model is not None:
            arrays[f"{name}_matrices"], arrays[f"{name}_excitations"] = model.matrices, model.excitations
            models[name] = {key: getattr(model, key) for key in ("sampled", "error", "lowest", "highest")}
    about = {
        "physics": body.physics,
        "n_port": body.n_port,
        "copies": body.copies,
        "bores": [asdict(bore) for bore in body.bores],
        "unknowns": body.unknowns,
        "mesh_error": solved.mesh_error,
        "seconds": solved.seconds,
        "models": models,
    }
    return arrays, about


def rebuilt(task: CellTask, record: CellRecord, grid: Array, cached: bool) -> CellSolution:
    """Solution of a cell on a grid of frequencies, (n_freq,) float64 in Hz, from its record."""
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
        pumped=Pumped(model(_PUMPED), arrays["pumped_energies"]) if _PUMPED in about["models"] else None,
        bores=tuple(StraightBore(**bore) for bore in about["bores"]),
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
