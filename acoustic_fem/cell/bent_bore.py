"""A bent round bore in 3-D: what a bend of uniform curvature does to the plane wave in it.

The flow along a bore of uniform curvature is the same in every section, so that a bent bore is a uniform line:
it has a series impedance and a shunt admittance per length of its centre line, which a short piece gives. For
a circular arc the ends of the piece take nothing from that: a flow purely along the arc, the same at every
azimuth, has a pressure that is uniform over each section, as a port demands. On a helix this holds but for
terms of the square of radius times torsion.

The change to look for is (a/R)^2 / 48 at low frequency (0.004 % for a = 0.25 mm, R = 5.8 mm; Topakoglu, J. Math.
Mech. 16 (1967) 1321, for vanishing flow), less than the error of any affordable mesh. Hence the straight bore is
solved on the same mesh unbent, and the difference of the two is added to the exact straight duct: the error of
the mesh counts only as a fraction of the difference.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.cell.condensed import AirModel, BodyFaces, condense
from acoustic_fem.cell.solid import checked_physics
from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.meshed_section import MeshedSection
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import Physics
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.wound_tube import FIRST, LAST, Winding, swept_mesh
from geometry.ground.argument_checks import check_range, out_of_range, positive_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Length of the piece that is solved, in bore radii.
PIECE = 4.0
#: Sections of the mesh have 6 rings^2 triangles; a piece has this many layers per ring.
LAYERS_PER_RING = 2.5
#: Largest a sqrt(w / nu): beyond, the layer at the wall is thinner than the elements.
LARGEST_SHEAR_NUMBER = 7.0


@dataclass(frozen=True, eq=False)
class BentBore:
    """A bent bore as a uniform line, per length of its centre line."""

    series: ComplexArray
    """Series impedance Z' per length, (n_freq,) complex128, Pa s/m^4."""
    shunt: ComplexArray
    """Shunt admittance Y' per length, (n_freq,) complex128, m^2/(Pa s)."""
    straight_error: float
    """Largest relative error of the straight bore's admittance on the same mesh, against the exact duct; it is taken
    out.
    """
    unknowns: int
    """Number of unknowns of the largest system solved."""

    def port_admittance(self, length: ArrayLike) -> ComplexArray:
        """Two-port of a piece of a length, scalar, m: (n_freq, 2, 2) complex128, m^3/(Pa s)."""
        return plane_wave.two_port(self.series, self.shunt, length)


def solve_bent_bores(
    radius: float,
    windings: Sequence[Winding],
    frequency: FrequencyLike,
    air: AirLike,
    fidelity: str = "navier-stokes",
    rings: int = 4,
    progress: Callable[[float], None] = lambda done: None,
) -> list[BentBore]:
    """Solve a piece of a bore bent in several ways, and the same piece straight.

    Rigid, no-slip, isothermal walls. The relative error of the change falls with about the fourth power of
    ``rings``: at most 17 % for 2 and 0.9 % for 4 up to a sqrt(w/nu) = 7, against the flow in a torus
    (tests/acoustic_fem/cell/test_bent_bore.py).

    Args:
        radius: a of the bore, m.
        windings: centre lines, mm; curvature and pitch count, the angle does not.
        frequency: (n_freq,) Hz, ascending.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        fidelity: ``"navier-stokes"`` (the one to trust) or ``"helmholtz"``, whose change of the resistance is 13
            times too large: the scalar viscous field does not know that the flow turns.
        rings: of elements in the section, 1 to 8.
        progress: called with the fraction done.

    Returns:
        One line per winding.

    Raises:
        Refusal: a bore as wide as the bend, frequencies at which the mesh does not resolve the layer at the
            wall, or another bad value, by name.
        LinearSolverError: a solve misses its residual limit.
        RationalFitError: the sweep does not reach its tolerance.
    """
    medium = medium_of(air)
    grid = check_bent_bore(radius, windings, frequency, medium)
    physics = checked_physics(fidelity)
    rings = int(check_range("rings", rings, 1, 8))
    length = PIECE * radius
    pieces: list[Winding | None] = [None, *windings]
    exact = plane_wave.port_admittance(radius, length, grid, medium)
    solved: list[tuple[ComplexArray, int]] = []

    def advance(done: float) -> None:
        progress((len(solved) + done) / len(pieces))

    for winding in pieces:
        solved.append(_piece(radius, winding, rings, grid, medium, physics, advance))
    straight, unknowns = solved[0]
    error = float(np.max(np.abs(straight / exact - 1)))
    lines = [_line(exact + (bent - straight), length) for bent, _ in solved[1:]]
    return [BentBore(series, shunt, error, unknowns) for series, shunt in lines]


def check_bent_bore(radius: float, windings: Sequence[Winding], frequency: FrequencyLike, air: AirLike) -> Array:
    """Check the arguments of :func:`solve_bent_bores` without solving: radius in m, frequency (n_freq,) in Hz.

    Returns:
        (n_freq,) float64, Hz.

    Raises:
        Refusal: as there.
    """
    medium = medium_of(air)
    bore = float(positive_numbers("radius", radius, "m"))
    for winding in windings:
        if not bore * winding.curvature < metres(1.0):
            raise out_of_range("radius", bore, f"below the bend's radius {metres(1 / winding.curvature):g} m", "m")
    grid = frequency_grid(frequency)
    highest = LARGEST_SHEAR_NUMBER**2 * medium.kinematic_viscosity / (2 * np.pi * bore**2)
    if grid[-1] > highest:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="frequency",
            value=float(grid[-1]),
            unit="Hz",
            allowed=f"at most {highest:.4g} Hz for a bore of radius {bore:g} m: above, the viscous layer is thinner "
            "than the elements",
        )
    return grid


def _piece(
    radius: float,
    winding: Winding | None,
    rings: int,
    frequency: Array,
    medium: Medium,
    physics: Physics,
    progress: Callable[[float], None],
) -> tuple[ComplexArray, int]:
    """Admittance of a piece between its two ends, the same from both, and the number of unknowns."""
    bore = radius / metres(1.0)
    section = MeshedSection.circle(bore, rings)
    layers = round(LAYERS_PER_RING * rings)
    mesh = swept_mesh(section.points, section.triangles, winding, np.linspace(0, PIECE * bore, layers + 1))
    band = (float(frequency[0]), float(frequency[-1]))
    body = condense(
        mesh, mesh, BodyFaces((FIRST, LAST)), AirModel(medium, band, physics), tolerance=1e-9, report=progress
    )
    admittance = body.nodal_admittance(frequency)
    # A piece of uniform curvature is the same from both ends; its mesh is not.
    return (admittance + admittance[:, ::-1, ::-1]) / 2, body.unknowns


def _line(admittance: ComplexArray, length: float) -> tuple[ComplexArray, ComplexArray]:
    """Z' and Y' of the uniform line whose piece has this two-port, that of a duct inverted.

    cosh x - 1 = -(Y11 + Y12) / Y12, Z' L = -x / (Y12 sinh x), Z' Y' L^2 = x^2; pieces with |x| below about 1.
    """
    own, transfer = admittance[:, 0, 0], admittance[:, 0, 1]
    x = 2 * np.arcsinh(np.sqrt(-(own + transfer) / (2 * transfer)))
    total = -x / (transfer * np.sinh(x))
    return total / length, x**2 / (total * length)
