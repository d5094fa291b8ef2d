"""Bodies of air in 3-D: CAD solid, mesh and physics -> port admittances.

The mesh is chosen by the accuracy asked for. The cells of a design are in :mod:`acoustic_fem.cell.design_cells`.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from os import PathLike
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

import geometry
from acoustic_fem.cell.condensed import AirModel, BodyFaces, CondensedBody, Pumped, ThermalField, condense
from acoustic_fem.fields.cylinder_heat import CylinderAir, CylinderField, cylinder_field
from acoustic_fem.fields.diffusion import DiffusionField, diffusion_field
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.numerics.refinement import BEST_ORDER, FLOW_ORDER, HEAT_ORDER, Refinement, refined
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid, port_points
from acoustic_fem.quantities.fidelity import PHYSICS, Physics
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from geometry.air.mesh import MOST_ELEMENTS, MeshSizes, Point, SolidMesh, face_at, mesh_solid, refuse_large_mesh
from geometry.air.solid_checks import sound_solid
from geometry.air.straight_bores import shortened
from geometry.air.volume import MIRROR
from geometry.formats.step_file import read_step
from geometry.ground.argument_checks import check_range, out_of_range, real_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

if TYPE_CHECKING:
    import cadquery

#: Called with what is being done and the fraction of it that is done.
Progress: TypeAlias = Callable[[str, float], None]

#: Most elements, as estimated, of the mesh of the flow that should do: its solution takes gigabytes.
MOST_FLOW_ELEMENTS = 1e5
_ACCURACY_RANGE = (2e-4, 3e-3)
_USUAL_FLOW_SCALE, _USUAL_HEAT_SCALE = 0.95, 0.7
"""Scales (see :func:`mesh_sizes`) that give an accuracy of 1e-3 in most bodies."""
_BELIEVED = 0.85e-3
"""Least error of the flow that is believed at its usual scale: where two meshes are nearer than that it is chance.
Chosen by 27 random cells of designs up to 200 Hz, of which two meshes seldom say more.
"""


_PUMPED_ERROR = 0.05
"""Error of what is pumped through a midplane on the coarsest mesh, relative; 0.005 to 0.03 was found."""


@dataclass(frozen=True, eq=False)
class MarkedSolid:
    """A body of air to be meshed, with what its faces are."""

    shape: cadquery.Shape
    """One solid, mm."""
    points: Mapping[str, Point]
    """Name -> a point on the face, mm: of ports, moving walls and the mirror."""
    faces: BodyFaces
    """Names of the tube ports, the moving walls and the mirror."""
    cylinder: CylinderAir | None = None
    """The same air, or twice it at a mirror, as a cylinder with bores, the ports first; None for other shapes."""

    def mesh(self, sizes: MeshSizes, beat: Callable[[], None]) -> SolidMesh:
        """The body meshed; ``beat`` is called while gmsh is at work."""
        return mesh_solid(self.shape, self.points, tuple(self.faces.tubes), sizes, beat)

    def shortened(self) -> MarkedSolid:
        """The same body, of whose straight bores only the pieces at the mouths are meshed."""
        short = shortened(self.shape, self.points, self.faces.tubes)
        lengths = [bore.length for bore in short.bores]
        cylinder = None if self.cylinder is None else self.cylinder.shortened(lengths)
        return MarkedSolid(short.solid, short.points, replace(self.faces, bores=short.bores), cylinder)


@dataclass(frozen=True)
class MeshGoal:
    """How far the meshes of a body are refined, and from where."""

    accuracy: float
    """Relative error aimed at."""
    width: float
    """Smallest extent of the cavity, mm."""
    checked_band: tuple[float, float] | None = None
    """Lowest and highest frequency at which the accuracy must hold, Hz; None: the whole band."""

    def frequencies(self, band: tuple[float, float]) -> Array:
        """Frequencies of the accuracy check of a body: (5,) float64, Hz, or (1,) in a band of one frequency."""
        low, high = self.checked_band or band
        return np.geomspace(low, high, 5) if high > low else np.array([low])

    def first_scale(self, usual: float) -> float:
        """The scale to begin with, from that which usually gives 1e-3."""
        return usual * (self.accuracy / 1e-3) ** (1 / BEST_ORDER)


@dataclass(frozen=True, eq=False)
class SolvedBody:
    """A condensed body of air and how far it has converged."""

    body: CondensedBody
    """The body, which answers at any frequency of its band."""
    mesh_error: float
    """Estimated relative error from the meshes, the larger of two: of every admittance, and of their sum, which is the
    compliance of the air. Each follows from how the answer changed from a mesh at least 1.5 times coarser.
    """
    convergence: tuple[Refinement, ...]
    """All meshes, in the order solved."""
    seconds: float
    """Time taken, s."""


def port_admittance(
    solid: cadquery.Shape | cadquery.Workplane | str | PathLike[str],
    ports: Mapping[str, Point],
    frequency: FrequencyLike,
    air: AirLike,
    fidelity: str = "navier-stokes",
    accuracy: float = 1e-3,
    progress: Progress | None = None,
) -> ComplexArray:
    """Port admittance of a body of air of any shape.

    Every face that is not a port is a rigid, no-slip, isothermal wall. Ports must lie a few bore radii down a
    tube, where the flow is a plane wave.

    Args:
        solid: one closed CadQuery solid of air in mm, or the path of a STEP file.
        ports: name -> a point on its flat face, mm.
        frequency: (n_freq,) Hz, ascending, 1e-3 to 2000, or one number.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        fidelity: ``"navier-stokes"`` (linearised, the one to trust) or ``"helmholtz"`` (scalar; wrong by
            about 5 % where a tube opens into a cavity, see :mod:`acoustic_fem.fields.helmholtz`).
        accuracy: relative error aimed at in the admittances, 2e-4 to 3e-3. The mesh is refined until
            comparison with a coarser one says that it is met.
        progress: called with a label and the fraction done.

    Returns:
        (n_freq, n_port, n_port) complex128, m^3/(Pa s): volume velocities into the cell per unit port
        pressure, ports in the order given; (n_port, n_port) at one frequency. Symmetric.

    Raises:
        Refusal: bad frequencies, ports, fidelity or accuracy, with the value and what is allowed.
        MeshError: the solid cannot be meshed, or a port lies on no flat face.
        LinearSolverError: a solve misses its residual limit.
        ConvergenceError: four refinements do not reach the accuracy.
    """
    medium = medium_of(air)
    grid = frequency_grid(
        frequency if isinstance(frequency, str) else np.atleast_1d(real_numbers("frequency", frequency))
    )
    solved = solve_solid(solid, ports, (float(grid[0]), float(grid[-1])), medium, fidelity, accuracy, progress)
    admittance = solved.body.nodal_admittance(grid)
    return admittance if isinstance(frequency, str) or np.ndim(frequency) else admittance[0]


def solve_solid(
    solid: cadquery.Shape | cadquery.Workplane | str | PathLike[str],
    ports: Mapping[str, Point],
    band: tuple[float, float],
    air: AirLike,
    fidelity: str = "navier-stokes",
    accuracy: float = 1e-3,
    progress: Progress | None = None,
) -> SolvedBody:
    """Condense a body of air of any shape over a band, with its convergence.

    Where a plane mirrors the body and each port onto themselves, half of it is solved.

    Args:
        solid: as for :func:`port_admittance`.
        ports: name -> a point on its flat face, mm.
        band: lowest and highest frequency, Hz.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        fidelity: ``"navier-stokes"`` or ``"helmholtz"``.
        accuracy: as for :func:`port_admittance`.
        progress: called with a label and the fraction done.

    Raises:
        As :func:`port_admittance`.
    """
    medium = medium_of(air)
    accuracy = check_range("accuracy", accuracy, *_ACCURACY_RANGE)
    physics = checked_physics(fidelity)
    ports = port_points(ports)
    if not isinstance(medium, Medium):
        raise Refusal(f"must be a Medium, not a {type(medium).__name__}", kind=Kind.WRONG_TYPE, field="medium")
    shape, ports = _at_origin(sound_solid(as_shape(solid)), ports)
    box = shape.BoundingBox()
    half = geometry.air.mirror_half(shape, ports) if MIRROR not in ports else None
    faces = dict(ports) if half is None else {**half.ports, MIRROR: half.mirror}
    return converge(
        MarkedSolid(
            shape if half is None else half.solid,
            faces,
            BodyFaces(tuple(ports), mirror=None if half is None else MIRROR),
        ),
        AirModel(medium, band, physics),
        MeshGoal(accuracy, min(box.xlen, box.ylen, box.zlen)),
        lambda done: None if progress is None else progress("cell", done),
    )


def _at_origin(solid: cadquery.Solid, ports: Mapping[str, Point]) -> tuple[cadquery.Solid, dict[str, Point]]:
    """A solid and its ports, moved so that the solid lies around the origin: wherever it was drawn, the answer is one.

    Raises:
        MeshError: a port lies on no flat face, or on several; it is named where the caller has it.
    """
    for name, point in ports.items():
        face_at(solid, name, point)
    centre = solid.BoundingBox().center
    moved = {name: (x - centre.x, y - centre.y, z - centre.z) for name, (x, y, z) in ports.items()}
    return solid.translate(-centre), moved


def converge(
    solid: MarkedSolid, air: AirModel, goal: MeshGoal, report: Callable[[float], None] = lambda done: None
) -> SolvedBody:
    """Refine the mesh of a body until its admittances have converged.

    Args:
        solid: the body and what its faces are.
        air: gas, frequencies and equations.
        goal: how far to refine, and from where.
        report: called with the fraction done.

    Raises:
        ConvergenceError: four refinements do not reach the accuracy.
    """
    started = time.perf_counter()
    solid = solid.shortened()
    closed = _closed_heat(solid, air, goal)
    _refuse_large(solid, air, goal, heat_too=closed is None)
    heat, heat_error, heat_meshes = closed or _converged_heat(solid, air, goal, lambda done: report(0.2 * done))
    flow, flow_error, flow_meshes = _converged_flow(solid, heat, air, goal, lambda done: report(0.2 + 0.8 * done))
    return SolvedBody(flow, max(heat_error, flow_error), (*heat_meshes, *flow_meshes), time.perf_counter() - started)


def refuse_large_body(solid: MarkedSolid, air: AirModel, goal: MeshGoal) -> None:
    """Refuse a body whose flow needs too large a mesh; arguments as :func:`converge`. Nothing is meshed.

    Raises:
        MeshError: the mesh of the flow would be too large.
    """
    _refuse_large(solid.shortened(), air, goal, heat_too=False)


def _refuse_large(short: MarkedSolid, air: AirModel, goal: MeshGoal, *, heat_too: bool) -> None:
    highest = float(goal.frequencies(air.band)[-1])
    meshed = [(_USUAL_FLOW_SCALE, 0, MOST_FLOW_ELEMENTS), (_USUAL_HEAT_SCALE, 1, MOST_ELEMENTS)]
    for usual, number, most in meshed if heat_too else meshed[:1]:
        # Coarser meshes come first: what the one that may do costs is known before any of them.
        sizes = mesh_sizes(goal.first_scale(usual), goal.width, air.medium, highest)[number]
        for each in short.shape.Solids():
            refuse_large_mesh(each, sizes, most)


def _closed_heat(
    solid: MarkedSolid, air: AirModel, goal: MeshGoal
) -> tuple[CylinderField, float, list[Refinement]] | None:
    """The thermal field of a cylinder with bores, its error in the compliance, no mesh; None where it will not do."""
    if solid.cylinder is None or (air.medium.gamma - 1) * solid.cylinder.mean_error > goal.accuracy / 2:
        return None
    field = cylinder_field(solid.cylinder, air.medium.thermal_diffusivity, air.band)
    # The compliance is V (gamma - (gamma - 1) <Psi>) / (gamma p), isothermal at least.
    return field, (air.medium.gamma - 1) * solid.cylinder.mean_error, []


def _converged_heat(
    solid: MarkedSolid, air: AirModel, goal: MeshGoal, report: Callable[[float], None]
) -> tuple[DiffusionField, float, list[Refinement]]:
    """The thermal field, its error in the compliance and its meshes."""
    medium, checked = air.medium, goal.frequencies(air.band)

    def heat_on(scale: float, advance: Callable[[float], None]) -> tuple[DiffusionField, int]:
        sizes = mesh_sizes(scale, goal.width, medium, float(checked[-1]))[1]
        mesh = solid.mesh(sizes, lambda: advance(0.0))
        return diffusion_field(mesh, solid.faces.open, medium.thermal_diffusivity, air.band), len(mesh.tetrahedra)

    def compliance_change(fine: DiffusionField, coarse: DiffusionField) -> float:
        fine_factor, coarse_factor = (
            medium.gamma - (medium.gamma - 1) * field.mean(checked, medium.thermal_diffusivity)
            for field in (fine, coarse)
        )
        return float(np.max(np.abs(fine_factor / coarse_factor - 1)))

    first = goal.first_scale(_USUAL_HEAT_SCALE)
    return refined("heat", heat_on, compliance_change, first, goal.accuracy, HEAT_ORDER, report)


def _converged_flow(
    solid: MarkedSolid, heat: ThermalField, air: AirModel, goal: MeshGoal, report: Callable[[float], None]
) -> tuple[CondensedBody, float, list[Refinement]]:
    """The condensed body, its error in the admittances and its meshes."""
    checked = goal.frequencies(air.band)

    pumped: Pumped | None = None
    least = 0.0

    def flow_on(scale: float, advance: Callable[[float], None]) -> tuple[CondensedBody, int]:
        nonlocal pumped, least
        sizes = mesh_sizes(scale, goal.width, air.medium, float(checked[-1]))[0]
        mesh = solid.mesh(sizes, lambda: advance(0.0))
        body = condense(mesh, heat, solid.faces, air, 1e-2 * goal.accuracy, advance, pumped)
        if pumped is None and body.pumped is not None:
            left = _PUMPED_ERROR * _difference(body, replace(body, pumped=None), checked)
            if left < goal.accuracy / 2:  # where tubes are not wide: finer meshes need not solve it again
                pumped, least = body.pumped, left
        return body, len(mesh.tetrahedra)

    first = goal.first_scale(_USUAL_FLOW_SCALE)

    def change(fine: CondensedBody, coarse: CondensedBody) -> float:
        return _difference(fine, coarse, checked)

    flow, error, meshes = refined("flow", flow_on, change, first, goal.accuracy, FLOW_ORDER, report)
    least = max(least, _BELIEVED * (meshes[-1].scale / _USUAL_FLOW_SCALE) ** BEST_ORDER)
    return flow, max(error, least), meshes


def _difference(first: CondensedBody, second: CondensedBody, frequency: Array) -> float:
    """Largest relative difference of two admittances, each entry against its row and column."""
    a, b = first.nodal_admittance(frequency), second.nodal_admittance(frequency)
    scale = np.sqrt(np.abs(np.einsum("fii->fi", a)))
    return float(np.max(np.abs(a - b) / (scale[:, :, None] * scale[:, None, :])))


def checked_physics(fidelity: str) -> Physics:
    """The fidelity as a 3-D model.

    Raises:
        Refusal: another name.
    """
    for name in PHYSICS:
        if fidelity == name:
            return name
    raise out_of_range("fidelity", fidelity, f"one of {', '.join(PHYSICS)} for a 3-D cell")


def as_shape(solid: cadquery.Shape | cadquery.Workplane | str | PathLike[str]) -> cadquery.Shape:
    """The one shape that was given, read from a STEP file where a path was.

    Raises:
        Refusal: no such file, no STEP file that can be read in 20 s and 1.5 GB, or not one shape.
    """
    import cadquery as cq

    if isinstance(solid, str | PathLike):
        shapes: list[Any] = [*read_step(solid)]
    else:
        shapes = solid.vals() if isinstance(solid, cq.Workplane) else [solid]
    if len(shapes) != 1 or not isinstance(shapes[0], cq.Shape):
        held = ", ".join(type(shape).__name__ for shape in shapes) or "nothing"
        raise Refusal(f"must be one CadQuery shape, it holds {held}", kind=Kind.WRONG_TYPE, field="solid")
    return shapes[0]
