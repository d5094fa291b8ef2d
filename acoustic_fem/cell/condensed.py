"""A body of air condensed to its ports and moving walls: small matrices that answer at any frequency.

Both 3-D models end in one form: a symmetric response of the excitations, ports first, then wall motions,
from which the nodal admittance follows. A condensed body is small, so that it can be stored.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TypeAlias

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from acoustic_fem.duct.plane_wave import port_admittance
from acoustic_fem.fields.cylinder_heat import CylinderField
from acoustic_fem.fields.diffusion import DiffusionField, diffusion_field, field_coefficients
from acoustic_fem.fields.helmholtz import pressure_system
from acoustic_fem.fields.navier_stokes import FlowMatrices, WallMotion, cell_system, compliance_mass, flow_matrices
from acoustic_fem.numerics.rational_sweep import ReducedModel, reduce_system, require_passive
from acoustic_fem.quantities.fidelity import Physics
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.mesh import SolidMesh
from geometry.air.straight_bores import StraightBore
from geometry.ground.argument_checks import out_of_range
from geometry.ground.typed import Array, ComplexArray

#: A solved thermal field: on a mesh of its own, or of the sections of a cylinder and its bores.
ThermalField: TypeAlias = DiffusionField | CylinderField

_LENGTH = metres(1.0)  # meshes are in mm


@dataclass(frozen=True, eq=False)
class BodyFaces:
    """Roles of the faces of a body of air; every other face is a rigid wall."""

    tubes: Sequence[str]
    """Names of the tube ports, in order."""
    motions: Sequence[WallMotion] = ()
    """Moving walls, in order."""
    mirror: str | None = None
    """Name of the plane that halves the body, if any."""
    midplane: str | None = None
    """Name of the plane that halves the body, but of each moving wall makes one there and a resting one beyond, if any.
    All tubes lie in it.
    """
    bores: Sequence[StraightBore] = ()
    """Straight bores beyond the tube ports, one each where any is given; their far ends are then the ports."""

    @property
    def open(self) -> list[str]:
        """Names of the faces that are no wall: tube ports, then the planes."""
        return [*self.tubes, *self.planes]

    @property
    def planes(self) -> list[str]:
        """Names of the planes that halve the body."""
        return [name for name in (self.mirror, self.midplane) if name is not None]


@dataclass(frozen=True)
class AirModel:
    """The gas, the frequencies and the equations that a body of air is solved for."""

    medium: Medium
    """The gas."""
    band: tuple[float, float]
    """Lowest and highest frequency, Hz."""
    physics: Physics = "navier-stokes"
    """The model of the flow."""


@dataclass(frozen=True, eq=False)
class Pumped:
    """Half a body whose walls pump air through its midplane, as walls do that move alike on either side of it.

    No tube takes part. A wall that moves while the one beyond rests is the mean of that and of both moving inwards.
    """

    flow: ReducedModel
    """Reduced model of the flow, driven by the wall motions."""
    energies: Array
    """Terms that the wall motions add to the response themselves, (n_term, m, m) float64."""


@dataclass(frozen=True, eq=False)
class CondensedBody:
    """Responses of a body of air over a band of frequencies."""

    physics: Physics
    """The model it was solved with."""
    medium: Medium
    """The gas it was solved for."""
    n_port: int
    """Number of tube ports; wall motions follow them."""
    copies: int
    """How often the body repeats: twice for each plane that halves it."""
    heat: ReducedModel
    """Reduced model of the thermal field."""
    viscous: ReducedModel | None
    """Reduced model of the viscous field; None but for Helmholtz."""
    flow: ReducedModel
    """Reduced model of the flow."""
    pumped: Pumped | None
    """The part that a midplane leaves out: None without one, or without a wall that moves."""
    bores: tuple[StraightBore, ...]
    """Straight bores beyond the tube ports, exact ones: one per port, or none."""
    energies: Array
    """Terms that the excitations add to the response themselves, (n_term, m, m) float64."""
    unknowns: int
    """Number of unknowns of the largest system solved."""

    def nodal_admittance(self, frequency: Array) -> ComplexArray:
        """Symmetric admittance between the ports and the pressures on the moving walls.

        The pressure of a wall's node is the mean over the wall weighted by the shape of its motion.

        Args:
            frequency: (n_freq,) Hz within the band.

        Returns:
            (n_freq, m, m) complex128, m^3/(Pa s): ports first, then wall motions.

        Raises:
            Refusal: a frequency outside the band the body was solved for.
        """
        low, high = self.flow.lowest, self.flow.highest
        outside = frequency[(frequency < low * (1 - 1e-9)) | (frequency > high * (1 + 1e-9))]
        if outside.size:
            raise out_of_range(
                "frequency", float(outside[0]), f"between {low:g} and {high:g} Hz, the band solved", "Hz"
            )
        response = _navier_stokes_response if self.physics == "navier-stokes" else _helmholtz_response
        nodal = self.copies * response(self, frequency)
        for port, bore in enumerate(self.bores):
            if bore.length > 0:
                nodal = _through_bore(nodal, port, bore, frequency, self.medium)
        return nodal


def condense(
    flow_mesh: SolidMesh,
    heat: SolidMesh | ThermalField,
    faces: BodyFaces,
    air: AirModel,
    tolerance: float = 1e-6,
    report: Callable[[float], None] = lambda done: None,
    pumped: Pumped | None = None,
) -> CondensedBody:
    """Solve a body of air over a band of frequencies.

    Args:
        flow_mesh: mesh for the flow, mm.
        heat: mesh of the same solid for the thermal field, or the field solved over the band.
        faces: which of its faces are ports, moving walls and the mirror.
        air: gas, frequencies and equations.
        tolerance: of the frequency sweep, relative.
        report: called with the fraction done.
        pumped: what the midplane leaves out, from another mesh; None: it is solved on this one, where there is any.

    Raises:
        LinearSolverError: a solve misses its residual limit.
        RationalFitError: the sweep does not reach its tolerance, or its model gives energy.
    """
    medium = air.medium
    if isinstance(heat, SolidMesh):
        heat = diffusion_field(heat, faces.open, medium.thermal_diffusivity, air.band)
    viscous: DiffusionField | None = None
    if air.physics == "navier-stokes":
        whole = flow_matrices(flow_mesh)
        means = heat.means_over(whole.pressure)
        storage = [whole.compliance, *(compliance_mass(whole.pressure, mean) for mean in means)]
        solve = partial(_condense_navier_stokes, whole, storage, heat, air=air, tolerance=tolerance)
        if faces.midplane is not None and faces.motions and pumped is None:
            # Its pressure is zero in the midplane, as in one more port.
            through = replace(faces, tubes=[*faces.tubes, faces.midplane], midplane=None)
            pumped = Pumped(*solve(through, report=lambda done: None, driven=False)[:2])
        flow, energies, unknowns = solve(faces, report=report)
    else:
        if faces.midplane is not None:
            raise RuntimeError("a lossy Helmholtz body has no midplane: its viscous field is another below a membrane")
        moving = {motion.face for motion in faces.motions}
        viscous = diffusion_field(flow_mesh, [*faces.open, *moving], medium.kinematic_viscosity, air.band)
        flow, energies, unknowns = _condense_helmholtz(flow_mesh, heat, viscous, faces, air, tolerance, report)
    body = CondensedBody(
        air.physics,
        medium,
        len(faces.tubes),
        2 ** len(faces.planes),
        heat.model,
        None if viscous is None else viscous.model,
        flow,
        pumped,
        tuple(faces.bores),
        energies,
        unknowns,
    )
    grid = np.geomspace(*air.band, 200)
    require_passive(body.nodal_admittance(grid), grid)
    return body


# -- linearised Navier-Stokes -----------------------------------------------------------------------------


def _condense_navier_stokes(
    whole: FlowMatrices,
    storage: Sequence[sp.csr_array],
    heat: ThermalField,
    faces: BodyFaces,
    air: AirModel,
    tolerance: float,
    report: Callable[[float], None],
    driven: bool = True,
) -> tuple[ReducedModel, Array, int]:
    """Model of the flow, energies of the motions and unknowns; where not driven, ports hold no pressure."""
    system = cell_system(whole, faces.tubes, faces.motions, faces.planes)
    blank = sp.csr_array((system.n_velocity, system.n_velocity))
    matrices = [system.viscous, system.inertia, system.coupling]
    matrices += [sp.csr_array(sp.block_diag([blank, part], format="csr")) for part in storage]
    n_port = len(faces.tubes) if driven else 0
    excitations = [np.zeros((system.size, n_port + len(faces.motions))) for _ in range(4)]
    excitations[0][:, :n_port] = system.port_flux[:, :n_port]
    for excitation, term in zip(excitations[1:], system.motion_terms, strict=True):
        excitation[:, n_port:] = term
    model = reduce_system(
        matrices,
        lambda f: _navier_stokes_coefficients(f, heat.model, air.medium)[0],
        excitations,
        lambda f: _navier_stokes_coefficients(f, heat.model, air.medium)[1],
        air.band,
        tolerance=tolerance,
        progress=report,
    )
    return model, system.motion_energy, system.size


def _navier_stokes_coefficients(
    frequency: Array, heat: ReducedModel, medium: Medium
) -> tuple[ComplexArray, ComplexArray]:
    """Coefficients of the matrices viscous, inertia, coupling, storage and of the excitations."""
    rate = _inertia_coefficient(frequency, medium)
    one = np.ones_like(rate)
    storage = 2j * np.pi * frequency * medium.viscosity / (medium.gamma * medium.pressure)
    theta = np.column_stack([one, rate, -one, -storage[:, None] * _storage_factors(frequency, heat, medium)])
    return theta, np.column_stack([one, one, rate, -one])


def _navier_stokes_response(body: CondensedBody, frequency: Array) -> ComplexArray:
    medium, n = body.medium, body.n_port
    response = body.flow.response(*_navier_stokes_coefficients(frequency, body.heat, medium))
    rate = _inertia_coefficient(frequency, medium)[:, None, None]
    y, b = response[:, :n, :n], response[:, :n, n:]
    z = body.energies[0] + rate * body.energies[1] - response[:, n:, n:]
    if body.pumped is not None:
        energies = body.pumped.energies
        alike = body.pumped.flow.response(*_navier_stokes_coefficients(frequency, body.heat, medium))
        z = z + energies[0] + rate * energies[1] - alike
    return _nodal(y, b, z) * (_LENGTH**3 / medium.viscosity)


# -- lossy Helmholtz --------------------------------------------------------------------------------------


def _condense_helmholtz(
    mesh: SolidMesh,
    heat: ThermalField,
    viscous: DiffusionField,
    faces: BodyFaces,
    air: AirModel,
    tolerance: float,
    report: Callable[[float], None],
) -> tuple[ReducedModel, Array, int]:
    system = pressure_system(mesh, faces.tubes, faces.motions)
    whole = [system.conduction(weight) for weight in viscous.at_quadrature()]
    uniform = np.ones_like(system.basis.dx)
    per_element = [mean[:, None] * uniform for mean in heat.means_over(system.basis)]
    whole += [system.storage(weight) for weight in (uniform, *per_element)]
    free, n_port = system.free, len(faces.tubes)
    zeros = np.zeros((len(free), len(faces.motions)))
    excitations = [np.hstack([(matrix @ system.on_ports)[free], zeros]) for matrix in whole]
    excitations.append(np.hstack([np.zeros((len(free), n_port)), system.sources[free]]))
    energies = np.stack([system.on_ports.T @ (matrix @ system.on_ports) for matrix in whole])
    model = reduce_system(
        [sp.csr_array(matrix[free][:, free]) for matrix in whole],
        lambda f: _helmholtz_coefficients(f, heat.model, viscous.model, air.medium)[0],
        excitations,
        lambda f: _helmholtz_coefficients(f, heat.model, viscous.model, air.medium)[1],
        air.band,
        tolerance=tolerance,
        progress=report,
    )
    return model, energies, len(free)


def _helmholtz_coefficients(
    frequency: Array, heat: ReducedModel, viscous: ReducedModel, medium: Medium
) -> tuple[ComplexArray, ComplexArray]:
    """Coefficients of conduction and storage, in Pa -> m^3/s per mm, and of the excitations.

    A p = source with A = Psi_v grad . grad / (j w rho) + j w storage / (gamma p0).
    """
    conduct = field_coefficients(viscous, frequency, medium.kinematic_viscosity)
    conduct = conduct * (_LENGTH / (2j * np.pi * frequency * medium.density))[:, None]
    storage = 2j * np.pi * frequency * _LENGTH**3 / (medium.gamma * medium.pressure)
    theta = np.column_stack([conduct, storage[:, None] * _storage_factors(frequency, heat, medium)])
    return theta, np.column_stack([theta, np.ones(len(frequency), dtype=np.complex128)])


def _helmholtz_response(body: CondensedBody, frequency: Array) -> ComplexArray:
    if body.viscous is None:
        raise RuntimeError("a lossy Helmholtz body must have a viscous field")
    n = body.n_port
    theta, phi = _helmholtz_coefficients(frequency, body.heat, body.viscous, body.medium)
    # With the free pressures p_f eliminated from K_ff p_f + K_fP p = S U, Q = K_PP p + K_Pf p_f, F = S^T p_f.
    response = body.flow.response(theta, phi)
    y = np.einsum("fk,kij->fij", theta, body.energies) - response[:, :n, :n]
    return _nodal(y, response[:, :n, n:], response[:, n:, n:])


# -- shared -----------------------------------------------------------------------------------------------


def _nodal(y: NDArray, b: NDArray, z: NDArray) -> ComplexArray:
    """Ports and walls, Q = Y p + B U and F = -B^T p + Z U, solved for Q and U at given pressures."""
    n, m = y.shape[1], y.shape[1] + z.shape[1]
    nodal = np.zeros((len(y), m, m), dtype=np.complex128)
    inverse = np.linalg.inv(z)
    nodal[:, :n, :n] = y + b @ inverse @ b.transpose(0, 2, 1)
    nodal[:, :n, n:] = b @ inverse
    nodal[:, n:, :n] = nodal[:, :n, n:].transpose(0, 2, 1)
    nodal[:, n:, n:] = (inverse + inverse.transpose(0, 2, 1)) / 2
    return nodal


def _through_bore(nodal: ComplexArray, port: int, bore: StraightBore, frequency: Array, medium: Medium) -> ComplexArray:
    """The admittance with the port at the far end of a bore."""
    duct = port_admittance(metres(bore.radius), metres(bore.length), frequency, medium)
    met = nodal[:, port, port] + duct[:, 1, 1]
    column = nodal[:, :, port].copy()
    beyond = nodal - column[:, :, None] * column[:, None, :] / met[:, None, None]
    beyond[:, port, :] = beyond[:, :, port] = -column * (duct[:, 0, 1] / met)[:, None]
    beyond[:, port, port] = duct[:, 0, 0] - duct[:, 0, 1] ** 2 / met
    return np.asarray(beyond, dtype=np.complex128)


def _storage_factors(frequency: Array, heat: ReducedModel, medium: Medium) -> ComplexArray:
    """Factors of the storage matrices in gamma - (gamma - 1) sum_k c_k v_k, (n_freq, 1 + r)."""
    coefficients = field_coefficients(heat, frequency, medium.thermal_diffusivity)
    constant = np.full((len(frequency), 1), medium.gamma, dtype=np.complex128)
    return np.hstack([constant, -(medium.gamma - 1) * coefficients])


def _inertia_coefficient(frequency: Array, medium: Medium) -> ComplexArray:
    return np.asarray(2j * np.pi * frequency * _LENGTH**2 / medium.kinematic_viscosity, dtype=np.complex128)
