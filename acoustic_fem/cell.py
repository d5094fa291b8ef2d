"""Cells in 3-D: mesh and physics -> port admittances.

Two ways in: :func:`port_admittance` takes any CAD solid of air; :func:`solve_cells` takes the cells of a
design, whose thermal field has a closed form, and keeps what it solved on disk.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib.metadata import version
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import cavity, cell_cache, duct
from acoustic_fem.checks import frequency_grid, in_range
from acoustic_fem.medium import Medium
from acoustic_fem.units import metres
from geometry.cells import Cell

if TYPE_CHECKING:
    import cadquery

    from acoustic_fem.frequency import ReducedModel
    from acoustic_fem.navier_stokes import CellSystem
    from geometry.mesh import MeshSizes

#: Called with what is being done and the fraction of it that is done.
Progress: TypeAlias = Callable[[str, float], None]

#: Cells of a design are solved over at least this band (Hz), so that another grid finds them in the cache.
DESIGN_BAND = (1.0, 500.0)

#: Part of the cache key: raise it when the mesh or the equations of a cell change.
CELL_MODEL_VERSION = 2

_LENGTH = metres(1.0)  # meshes are in mm
_ACCURACY_RANGE = (2e-4, 3e-3)


@dataclass(frozen=True)
class CellSolution:
    """Responses of one cell and how they were obtained."""

    admittance: NDArray[np.complex128]
    """(n_freq, k+1, k+1), m^3/(Pa s): the k tube ports in order, then the opening."""
    unknowns: int
    sampled: tuple[float, ...]
    """Frequencies solved in 3-D, Hz; the others come from the rational model."""
    error: float
    """Estimated relative error of the rational model."""
    seconds: float
    """Time the 3-D solves took, when they were made."""
    cached: bool

    def summary(self) -> dict[str, Any]:
        """Everything but the responses, as plain values."""
        return {
            "method": "3-D linearised Navier-Stokes",
            "unknowns": self.unknowns,
            "sampled_frequencies": list(self.sampled),
            "sweep_error": self.error,
            "seconds": self.seconds,
            "cached": self.cached,
        }


@dataclass(frozen=True)
class _CondensedCell:
    """What the cache keeps of a cell: enough for its responses at any frequency of the band."""

    model: ReducedModel
    lift_energy: tuple[float, float]
    unknowns: int
    seconds: float

    def store(self, key: str) -> None:
        about = {
            "lift_energy": self.lift_energy,
            "unknowns": self.unknowns,
            "seconds": self.seconds,
            "sampled": self.model.sampled,
            "error": self.model.error,
            "band": (self.model.lowest, self.model.highest),
        }
        cell_cache.store(key, {"matrices": self.model.matrices, "excitations": self.model.excitations}, about)

    @classmethod
    def fetch(cls, key: str) -> _CondensedCell | None:
        stored = cell_cache.fetch(key)
        if stored is None:
            return None
        from acoustic_fem.frequency import ReducedModel

        arrays, about = stored
        model = ReducedModel(
            matrices=arrays["matrices"],
            excitations=arrays["excitations"],
            basis=None,
            sampled=tuple(about["sampled"]),
            error=about["error"],
            lowest=about["band"][0],
            highest=about["band"][1],
        )
        return cls(model, tuple(about["lift_energy"]), about["unknowns"], about["seconds"])


def port_admittance(
    solid: cadquery.Shape | cadquery.Workplane | str | PathLike[str],
    ports: Mapping[str, tuple[float, float, float]],
    frequency: ArrayLike,
    medium: Medium,
    fidelity: str = "navier-stokes",
    accuracy: float = 1e-3,
    progress: Progress | None = None,
) -> NDArray[np.complex128]:
    """Port admittance of a body of air of any shape, by 3-D linearised Navier-Stokes.

    Every face that is no port is a rigid, no-slip, isothermal wall. Ports must lie a few bore radii down a
    tube, where the flow is a plane wave.

    Args:
        solid: one closed CadQuery solid of air in mm, or the path of a STEP file.
        ports: name -> a point on its flat face, mm.
        frequency: (n_freq,) Hz, ascending, 1e-3 to 2000.
        medium: the gas.
        fidelity: ``"navier-stokes"``.
        accuracy: relative error aimed at in the admittances, 2e-4 to 3e-3; it sets the mesh, which
            also gets finer with rising frequency, as the viscous and thermal layers get thinner. Measured in
            a bore of 0.5 mm: kept up to 100 Hz, missed by a factor of 2 at 200 Hz and 6 at 1 kHz.
        progress: called with a label and the fraction done.

    Returns:
        (n_freq, n_port, n_port) complex128, m^3/(Pa s): volume velocities into the cell per unit port
        pressure, ports in the order given. Symmetric.

    Raises:
        ValueError: bad frequencies, ports, fidelity or accuracy, with the value and what is allowed.
        MeshError: the solid cannot be meshed, or a port lies on no flat face.
        LinearSolverError: a solve misses its residual limit.
    """
    grid = frequency_grid(frequency)
    accuracy = in_range("accuracy", accuracy, *_ACCURACY_RANGE)
    if fidelity != "navier-stokes":
        raise ValueError(f"fidelity = {fidelity!r} must be 'navier-stokes' for a CAD solid")
    if not ports:
        raise ValueError("ports must name at least one port")

    from acoustic_fem.navier_stokes import cell_system, compliance_mass
    from acoustic_fem.thermal_field import thermal_field
    from geometry.mesh import mesh_solid

    shape = _as_shape(solid)
    names = tuple(ports)
    band = (float(grid[0]), float(grid[-1]))
    report = _Reporter(progress, "cell")
    report(0.0)
    flow_sizes, heat_sizes = _solid_mesh_sizes(shape, accuracy, medium, band[1])
    system = cell_system(mesh_solid(shape, ports, names, flow_sizes), names)
    field = thermal_field(mesh_solid(shape, ports, names, heat_sizes), names, medium, band)
    means = field.means_over(system.pressure)
    parts = [system.compliance, *(compliance_mass(system.pressure, mean) for mean in means)]
    gamma = medium.gamma

    def compliance(f: NDArray[np.float64]) -> NDArray[np.complex128]:
        # gamma - (gamma - 1) Psi with Psi = sum c_k v_k
        return np.column_stack([np.full(len(f), gamma + 0j), -(gamma - 1) * field.coefficients(f)])

    model = _reduce(system, parts, compliance, medium, band, accuracy * 1e-2, report)
    return model.response(*_coefficients(grid, compliance(grid), medium)) * (_LENGTH**3 / medium.viscosity)


def solve_cells(
    cells: Sequence[Cell], frequency: ArrayLike, medium: Medium, progress: Progress | None = None
) -> dict[Cell, CellSolution]:
    """Nodal admittances of the cells of a design, by 3-D linearised Navier-Stokes.

    The membrane (or the microphone's diaphragm) is a moving wall with a fixed shape, (1 - (r/a)^2)^2 for a
    membrane and 1 - (r/a)^2 at the end of a sound hole; the pressure of its node is the mean weighted by
    that shape. Its mechanics belong to the network, so another membrane needs no new solve.

    Args:
        cells: distinct cells.
        frequency: (n_freq,) Hz, ascending, 1e-3 to 2000.
        medium: the gas.
        progress: called with a label and the fraction done.

    Returns:
        Per cell its solution.

    Raises:
        ValueError: bad frequencies.
        MeshError, LinearSolverError: a cell cannot be meshed or solved.
    """
    grid = frequency_grid(frequency)
    return {cell: _solve_cell(cell, grid, medium, progress) for cell in cells}


def _solve_cell(cell: Cell, grid: NDArray[np.float64], medium: Medium, progress: Progress | None) -> CellSolution:
    band = (min(DESIGN_BAND[0], float(grid[0])), max(DESIGN_BAND[1], float(grid[-1])))
    key = cell_cache.key_of(
        {
            "cell": asdict(cell),
            "medium": asdict(medium),
            "band": band,
            "model": CELL_MODEL_VERSION,
            "sizes": asdict(_cell_mesh_sizes(cell, medium, band[1])),
            "gmsh": version("gmsh"),
        }
    )
    condensed = _CondensedCell.fetch(key)
    cached = condensed is not None
    report = _Reporter(progress, cell.label + (" (from the cache)" if cached else ""))
    if condensed is None:
        condensed = _condense(cell, medium, band, report)
        condensed.store(key)
    report(1.0)
    model, energy = condensed.model, condensed.lift_energy
    response = model.response(*_coefficients(grid, _closed_form_compliance(cell, grid, medium), medium))
    lift = energy[0] + _inertia_coefficient(grid, medium) * energy[1]
    return CellSolution(
        admittance=_nodal_admittance(response, lift) * (_LENGTH**3 / medium.viscosity),
        unknowns=condensed.unknowns,
        sampled=model.sampled,
        error=model.error,
        seconds=condensed.seconds,
        cached=cached,
    )


def _condense(cell: Cell, medium: Medium, band: tuple[float, float], report: _Reporter) -> _CondensedCell:
    """Mesh and solve a cell."""
    from acoustic_fem.navier_stokes import cell_system, compliance_mass
    from geometry.air import OPENING, air_volume
    from geometry.mesh import mesh_solid

    report(0.0)
    started = time.perf_counter()
    air = air_volume(cell)
    tubes = tuple(air.ports)
    fine = tubes if cell.opening_length == 0 else (*tubes, OPENING)
    mesh = mesh_solid(air.solid, {**air.ports, OPENING: air.opening}, fine, _cell_mesh_sizes(cell, medium, band[1]))
    radius = np.linspace(0, cell.opening_diameter / 2, 200)
    bowl = 1 - (radius / radius[-1]) ** 2
    profile = np.column_stack([radius, bowl**2 if cell.opening_length == 0 else bowl])
    system = cell_system(mesh, tubes, OPENING, profile)
    region = _regions(cell, mesh.nodes[mesh.tetrahedra[:, :4]].mean(axis=1))
    parts = [compliance_mass(system.pressure, (region == k).astype(float)) for k in range(region.max() + 1)]
    model = _reduce(system, parts, lambda f: _closed_form_compliance(cell, f, medium), medium, band, 1e-6, report)
    return _CondensedCell(model, system.lift_energy, system.size, time.perf_counter() - started)


def _regions(cell: Cell, centres: NDArray[np.float64]) -> NDArray[np.int64]:
    """Which closed form holds at a point: 0 the cavity, 1 + k the stub of port k, then the sound hole."""
    region = np.zeros(len(centres), dtype=np.int64)
    outside = np.hypot(centres[:, 0], centres[:, 1]) > cell.diameter / 2
    for k, port in enumerate(cell.ports):
        angle = np.radians(port.angle)
        along = centres[:, :2] @ np.array([np.cos(angle), np.sin(angle)])
        across = centres[:, :2] @ np.array([-np.sin(angle), np.cos(angle)])
        region[outside & (along > 0) & (np.abs(across) < 0.6 * port.bore_diameter)] = k + 1
    region[centres[:, 2] > cell.height] = len(cell.ports) + 1
    return region


def _closed_form_compliance(cell: Cell, frequency: NDArray[np.float64], medium: Medium) -> NDArray[np.complex128]:
    """Thermal factor gamma - (gamma - 1) <Psi_h> of each region of a cell, (n_freq, n_region)."""
    stiffness = medium.gamma * medium.pressure
    radius, height = metres(cell.diameter / 2), metres(cell.height)
    volume = np.pi * radius**2 * height
    columns = [cavity.closed_cylinder_compliance(radius, height, frequency, medium) * stiffness / volume]
    bores = [port.bore_diameter for port in cell.ports]
    if cell.opening_length > 0:
        bores.append(cell.opening_diameter)
    for bore in bores:
        per_length = duct.shunt_admittance(metres(bore / 2), frequency, medium)
        columns.append(per_length * stiffness / (2j * np.pi * frequency * np.pi * metres(bore / 2) ** 2))
    return np.column_stack(columns)


def _inertia_coefficient(frequency: NDArray[np.float64], medium: Medium) -> NDArray[np.complex128]:
    return np.asarray(2j * np.pi * frequency * _LENGTH**2 / medium.kinematic_viscosity, dtype=np.complex128)


def _coefficients(
    frequency: NDArray[np.float64], compliance: NDArray[np.complex128], medium: Medium
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Coefficients of the system's matrices and of its excitations at each frequency."""
    rate = _inertia_coefficient(frequency, medium)
    one = np.ones_like(rate)
    storage = 2j * np.pi * frequency * medium.viscosity / (medium.gamma * medium.pressure)
    theta = np.column_stack([one, rate, -one, -storage[:, None] * compliance])
    return theta, np.column_stack([one, one, rate, -one])


def _reduce(
    system: CellSystem,
    compliance_parts: Sequence[sp.csr_array],
    compliance: Callable[[NDArray[np.float64]], NDArray[np.complex128]],
    medium: Medium,
    band: tuple[float, float],
    tolerance: float,
    report: _Reporter,
) -> ReducedModel:
    from acoustic_fem.frequency import reduce_system

    blank = sp.csr_array((system.n_velocity, system.n_velocity))
    matrices = [system.viscous, system.inertia, system.coupling]
    matrices += [sp.csr_array(sp.block_diag([blank, part], format="csr")) for part in compliance_parts]
    moving = bool(system.lift.any())
    n_port = system.port_flux.shape[1]
    excitations = [np.zeros((system.size, n_port + moving)) for _ in range(4)]
    excitations[0][:, :n_port] = system.port_flux
    if moving:
        for excitation, term in zip(excitations[1:], system.lift_terms, strict=True):
            excitation[:, n_port] = term
    return reduce_system(
        matrices,
        lambda f: _coefficients(f, compliance(f), medium)[0],
        excitations,
        lambda f: _coefficients(f, compliance(f), medium)[1],
        band,
        tolerance=tolerance,
        progress=lambda done: report(0.1 + 0.9 * done),
    )


def _nodal_admittance(response: NDArray[np.complex128], lift: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Hybrid response of ports and, last, the moving wall -> nodal admittance of the same nodes.

    With port pressures p and the wall's volume velocity U, Q = Y p + B U and F = -B^T p + Z U; solved for
    U at given pressures.
    """
    y, b = response[:, :-1, :-1], response[:, :-1, -1]
    z = lift - response[:, -1, -1]
    nodal = np.empty_like(response)
    nodal[:, :-1, :-1] = y + b[:, :, None] * b[:, None, :] / z[:, None, None]
    nodal[:, :-1, -1] = nodal[:, -1, :-1] = b / z[:, None]
    nodal[:, -1, -1] = 1 / z
    return nodal


def _layer_thickness(diffusivity: float, frequency: float) -> float:
    """Viscous or thermal layer sqrt(2 nu / w), mm."""
    return float(np.sqrt(diffusivity / (np.pi * frequency))) / _LENGTH


def _cell_mesh_sizes(cell: Cell, medium: Medium, highest: float) -> MeshSizes:
    """Measured on the reference cell: 6e-4 in the port admittances up to 100 Hz."""
    from geometry.mesh import MeshSizes

    return MeshSizes(
        mouth_edge=0.2,
        tube=0.6,
        growth=0.5,
        largest=0.35 * min(cell.height, cell.diameter),
        tube_layer=2 * _layer_thickness(medium.kinematic_viscosity, highest),
    )


def _solid_mesh_sizes(
    shape: cadquery.Shape, accuracy: float, medium: Medium, highest: float
) -> tuple[MeshSizes, MeshSizes]:
    """Sizes for the flow and for heat; errors fall about with the third power of the size."""
    from geometry.mesh import MeshSizes

    factor = (accuracy / 1e-3) ** (1 / 3)
    box = shape.BoundingBox()
    largest = 0.35 * factor * min(box.xlen, box.ylen, box.zlen)
    viscous = _layer_thickness(medium.kinematic_viscosity, highest)
    thermal = _layer_thickness(medium.thermal_diffusivity, highest)
    return (
        MeshSizes(
            mouth_edge=0.2 * factor, tube=0.5 * factor, growth=0.5, largest=largest, tube_layer=1.3 * factor * viscous
        ),
        MeshSizes(mouth_edge=0.7, tube=0.7, growth=0.5, largest=largest, wall=1.1 * factor * thermal),
    )


def _as_shape(solid: cadquery.Shape | cadquery.Workplane | str | PathLike[str]) -> cadquery.Shape:
    import cadquery as cq

    if isinstance(solid, str | PathLike):
        path = Path(solid)
        if not path.is_file():
            raise ValueError(f"solid = {str(path)!r} must be the path of a STEP file; there is no such file")
        try:
            solid = cq.importers.importStep(str(path))
        except Exception as error:
            raise ValueError(f"{path}: no STEP file that can be read ({error})") from error
    shapes = solid.vals() if isinstance(solid, cq.Workplane) else [solid]
    if len(shapes) != 1 or not isinstance(shapes[0], cq.Shape):
        raise ValueError(f"solid must hold one shape, it holds {len(shapes)}")
    return shapes[0]


class _Reporter:
    """Progress of one cell under its label."""

    def __init__(self, progress: Progress | None, label: str) -> None:
        self._progress, self._label = progress, label

    def __call__(self, done: float) -> None:
        if self._progress is not None:
            self._progress(self._label, done)
