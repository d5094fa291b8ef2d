r"""The ribbed bore of a close-wound coil spring: linearised Navier-Stokes in one pitch of the winding.

The bore is taken as axisymmetric and periodic: a stack of touching rings of round wire (diameter d), whose
wall has the radius r(z) = a + d/2 - sqrt((d/2)^2 - z^2) with a = outer diameter/2 - d at the crests. For a
pressure gradient G along the axis the flow in one pitch is periodic and, by its mirror planes, fixed by half
of it: no radial velocity on the planes of crest and groove. Find u and p with

.. math::
    \int (\nabla u : \nabla w + s\, u \cdot w - p\, \nabla\!\cdot w)\, dV = \int w_z\, dV, \qquad
    \int q\, \nabla\!\cdot u\, dV = 0,

s = j w / nu; Z' = G / q, the mean volume velocity. The gas in the grooves adds to the compliance: Y' has the
true volume per length and the thermal field of the ribbed bore. Taylor-Hood elements (Q2-Q1) on curved
quadrilaterals; lengths in units of a. This is the homogenised line of a periodic waveguide, valid for
wavelengths and |1/Gamma| far above the pitch d; the pitch angle of the helix (d over the circumference,
0.05 to 0.1 rad) is left out.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import scipy.sparse as sp
import skfem

from acoustic_fem.duct.plane_wave import Line, diffusion_rate
from acoustic_fem.numerics.rational_sweep import reduce_system
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from geometry.ground.argument_checks import check_range, out_of_range, positive_numbers
from geometry.ground.typed import Array, ComplexArray

#: Columns of elements over a quarter of the wire; see tests/acoustic_fem/duct/test_coil_bore.py for the error.
REFINEMENT = 12

#: The cusp between touching wires is cut where the wall is this far (rad) from pointing to the next wire.
CUSP = 0.15


@dataclass(frozen=True)
class CoilBore(Line):
    """The bore of a close-wound spring as a line."""

    outer_diameter: float
    """Outside diameter of the spring, m."""
    wire_diameter: float
    """Diameter of the wire, m, below a quarter of the outer diameter."""
    refinement: int = REFINEMENT
    """Columns of elements over a quarter of the wire."""
    cusp: float = CUSP
    """Angle at which the cusp between the wires is cut, rad, 0.02 to 0.5; the gas behind it, a share below cusp^3/3 of
    the groove, is at rest and isothermal.
    """

    def __post_init__(self) -> None:
        outer = float(positive_numbers("outer_diameter", self.outer_diameter, "m"))
        wire = float(positive_numbers("wire_diameter", self.wire_diameter, "m"))
        if wire >= outer / 4:
            raise out_of_range("wire_diameter", wire, f"below a quarter of outer_diameter = {outer:g} m", "m")
        check_range("refinement", self.refinement, 2, whole=True)
        check_range("cusp", self.cusp, 0.02, 0.5, "rad")

    @property
    def crest_radius(self) -> float:
        """Radius at the crests of the wire, outer diameter / 2 - wire, m."""
        return self.outer_diameter / 2 - self.wire_diameter

    @property
    def volume_per_length(self) -> float:
        """Mean area of the bore with its grooves, exact, m^2."""
        a, b = self.crest_radius, self.wire_diameter / 2
        # mean over z of (a + b - sqrt(b^2 - z^2))^2
        return float(np.pi * ((a + b) ** 2 - np.pi / 2 * b * (a + b) + 2 / 3 * b**2))

    @property
    def effective_radius(self) -> float:
        """Radius of the smooth bore with the same resistance at low frequency, (8 mu / (pi R'))^(1/4), m."""
        conductance = float(self._flow_response(np.zeros(1))[0].real) / self._depth
        return self.crest_radius * (8 * conductance / np.pi) ** 0.25

    def series_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Series impedance Z' per length, Pa s/m^4: shape of frequency (Hz), complex128."""
        medium = medium_of(air)
        rate = np.abs(diffusion_rate(frequency, medium.kinematic_viscosity))
        response = self._flow_response(rate.ravel() * self.crest_radius**2).reshape(rate.shape)
        return np.asarray(medium.viscosity / self.crest_radius**4 * self._depth / response)

    def shunt_admittance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """Shunt admittance Y' per length, m^2/(Pa s): shape of frequency (Hz), complex128."""
        medium = medium_of(air)
        rate = np.abs(diffusion_rate(frequency, medium.thermal_diffusivity))
        scaled = rate.ravel() * self.crest_radius**2
        heat, load = self._heat
        adiabatic = 1j * scaled * _response(heat, load, scaled) / self._depth * self.crest_radius**2
        gamma = medium.gamma
        stored = gamma * self.volume_per_length - (gamma - 1) * adiabatic.reshape(rate.shape)
        return np.asarray(2j * np.pi * frequencies(frequency) / (gamma * medium.pressure) * stored)

    @property
    def _depth(self) -> float:
        """Radius of the wire in units of the crest radius: the length of half a pitch."""
        return self.wire_diameter / 2 / self.crest_radius

    def _flow_response(self, scaled_rate: Array) -> ComplexArray:
        flow, load = self._flow
        return _response(flow, load, scaled_rate)

    @cached_property
    def _mesh(self) -> skfem.MeshQuad2:
        return half_pitch_mesh(self._depth, self._depth, self.refinement, self.cusp)

    @cached_property
    def _flow(self) -> tuple[list[sp.csr_array], Array]:
        return flow_system(self._mesh)

    @cached_property
    def _heat(self) -> tuple[list[sp.csr_array], Array]:
        return heat_system(self._mesh)


def half_pitch_mesh(half_pitch: float, wire_radius: float, refinement: int, cusp: float = CUSP) -> skfem.MeshQuad2:
    """Half a pitch in (r, z), crest radius 1: curved quadrilaterals with named boundaries.

    Args:
        half_pitch: length of the half pitch.
        wire_radius: of the arcs that form the wall, equal to half_pitch; 0: a smooth bore.
        refinement: columns over the arc.
        cusp: angle (rad) before the next wire at which the groove gets a flat bottom.
    """
    core = max(1 - 3 * half_pitch, 0.3)
    rows = [np.linspace(0, core, max(4, refinement // 2) + 1), np.linspace(core, 1, 2 * refinement + 1)[1:]]
    columns = np.linspace(0, 1, refinement + 2)  # the last one is the flat bottom
    straight = skfem.MeshQuad.init_tensor(np.concatenate(rows), columns)
    curved = skfem.MeshQuad2.from_mesh(straight)
    row, column = curved.doflocs
    last = columns[-2]
    angle = np.minimum(column / last, 1) * (np.pi / 2 - cusp)
    at_cut = half_pitch * np.cos(cusp)
    z = np.where(
        column <= last, half_pitch * np.sin(angle), at_cut + (half_pitch - at_cut) * (column - last) / (1 - last)
    )
    wall = 1 + wire_radius * (1 - np.cos(angle))
    r = np.where(row <= core, row, core + (row - core) / (1 - core) * (wall - core))
    mesh = skfem.MeshQuad2(np.stack([r, z]), curved.t)
    facets = straight.boundary_facets()
    middle = straight.p[:, straight.facets[:, facets]].mean(axis=1)
    tiny = 1e-9
    return mesh.with_boundaries(
        {
            "wall": facets[middle[0] > 1 - tiny],
            "axis": facets[middle[0] < tiny],
            "mirror": facets[(middle[1] < tiny) | (middle[1] > 1 - tiny)],
        }
    )


def flow_system(mesh: skfem.MeshQuad2) -> tuple[list[sp.csr_array], Array]:
    """Matrices (constant, times s), (n, n), and load, (n,) float64, of flow; load K^-1 load is flux x pitch / 2."""
    velocity = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=6)
    pressure = velocity.with_element(skfem.ElementQuad1())
    held = np.concatenate(
        [velocity.get_dofs("wall").flatten(), *(velocity.get_dofs(name).all("u^1") for name in ("axis", "mirror"))]
    )
    free = np.setdiff1d(np.arange(velocity.N), held)
    viscous = _viscous.assemble(velocity).tocsr()[free][:, free]
    inertia = _inertia.assemble(velocity).tocsr()[free][:, free]
    divergence = _divergence.assemble(velocity, pressure).tocsr()[:, free]
    blank = sp.csr_array((pressure.N, pressure.N))
    constant = sp.block_array([[viscous, -divergence.T], [-divergence, blank]], format="csr")
    load = np.concatenate([2 * np.pi * _axial.assemble(velocity)[free], np.zeros(pressure.N)])
    # with every term times 2 pi the response is in full turns
    return [2 * np.pi * constant, 2 * np.pi * sp.block_diag([inertia, blank], format="csr")], load


def heat_system(mesh: skfem.MeshQuad2) -> tuple[list[sp.csr_array], Array]:
    """Matrices (constant, times s), (n, n), and load, (n,) float64, of the heat; s load K^-1 load is its integral."""
    basis = skfem.Basis(mesh, skfem.ElementQuad2(), intorder=6)
    free = np.setdiff1d(np.arange(basis.N), basis.get_dofs("wall").flatten())
    conduction = 2 * np.pi * _conduction.assemble(basis).tocsr()
    storage = 2 * np.pi * _storage.assemble(basis).tocsr()
    load = np.asarray(storage @ np.ones(basis.N))[free]
    return [sp.csr_array(conduction[free][:, free]), sp.csr_array(storage[free][:, free])], load


def _response(matrices: list[sp.csr_array], load: Array, rates: Array) -> ComplexArray:
    """Load^T (K0 + j rate K1)^-1 load at all rates from a few solves."""

    def theta(rates: Array) -> ComplexArray:
        return np.column_stack([np.ones_like(rates), 1j * rates])

    def phi(rates: Array) -> ComplexArray:
        return np.ones((len(rates), 1), dtype=np.complex128)

    band = (float(rates.min()), float(rates.max()))
    model = reduce_system(matrices, theta, [load[:, None]], phi, band, tolerance=1e-9)
    return model.response(theta(rates), phi(rates))[:, 0, 0]


@skfem.BilinearForm
def _viscous(u: Any, w: Any, form: Any) -> Any:
    r = form.x[0]
    du, dw = u.grad, w.grad
    planar = du[0, 0] * dw[0, 0] + du[0, 1] * dw[0, 1] + du[1, 0] * dw[1, 0] + du[1, 1] * dw[1, 1]
    return planar * r + u[0] * w[0] / r


@skfem.BilinearForm
def _inertia(u: Any, w: Any, form: Any) -> Any:
    return (u[0] * w[0] + u[1] * w[1]) * form.x[0]


@skfem.BilinearForm
def _divergence(u: Any, q: Any, form: Any) -> Any:
    return ((u.grad[0, 0] + u.grad[1, 1]) * form.x[0] + u[0]) * q


@skfem.LinearForm
def _axial(w: Any, form: Any) -> Any:
    return w[1] * form.x[0]


@skfem.BilinearForm
def _conduction(u: Any, v: Any, form: Any) -> Any:
    return (u.grad[0] * v.grad[0] + u.grad[1] * v.grad[1]) * form.x[0]


@skfem.BilinearForm
def _storage(u: Any, v: Any, form: Any) -> Any:
    return u * v * form.x[0]
