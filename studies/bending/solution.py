"""Does a tube transmit less when it is bent? The publication's rig, by 3-D finite elements of the bent bore.

A tube of given length is wound on a cylinder over several angles, the rest of it straight on both sides. The
bent bore is a uniform line (:mod:`acoustic_fem.cell.bent_bore`), the straight rest an exact round duct; at the far end
sits a microphone in its chamber, or a plug. The pressure there is compared as a fraction of that at the near end.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance
from acoustic_fem.cell.bent_bore import BentBore, check_bent_bore, solve_bent_bores
from acoustic_fem.cell.solid import Progress, checked_physics
from acoustic_fem.duct import plane_wave
from acoustic_fem.library.provenance import versions
from acoustic_fem.network.chain_matrices import TwoPort, join
from acoustic_fem.network.microphone import load_admittance
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.wound_tube import Winding
from geometry.design.design_file import prototype
from geometry.ground.typed import ComplexArray
from geometry.schema.part_fields import Microphone
from studies.bending.bending_rig import BendingRig, End

#: Rings of elements in the section of the bore: of the result, and of the mesh twice as coarse beside it.
FINE, COARSE = 4, 2
#: Lowest order with which the change by the bend converges (3.4 to 4.3, tests/acoustic_fem/cell/test_bent_bore.py).
ORDER = 3.4
#: The prototype whose microphone and air the rig has.
PROTOTYPE = "array-2x6"


@dataclass(frozen=True, eq=False)
class Bending:
    """Changes by bending."""

    rig: BendingRig
    """Tube and cylinder."""
    fidelity: str
    """Model of the bent bore."""
    medium: Medium
    """Air in the tube."""
    frequency: NDArray[np.float64]
    """Frequencies; (n_freq,) float64, Hz."""
    transfer_function: ComplexArray
    """Pressure at the far end over that at the near end, per angle; (n_angle, n_freq) complex128, Pa/Pa."""
    straight: ComplexArray
    """Pressure at the far end over that at the near end of the straight tube, exact; (n_freq,) complex128, Pa/Pa."""
    bend_change: ComplexArray
    """Relative change of the transfer admittance Y12 of the wound part alone; (n_angle, n_freq) complex128."""
    mesh_error: float
    """Share of the differences to the straight tube that the mesh may be wrong by, estimated from a mesh twice as
    coarse."""
    straight_error: float
    """Relative error of the mesh in the admittance of a straight bore, which is taken out."""
    unknowns: int
    """Number of unknowns of the largest system solved; 0 where nothing is bent."""
    seconds: float
    """Time taken, s."""
    made_by: dict[str, Any]
    """Versions and time."""

    @property
    def level_difference(self) -> NDArray[np.float64]:
        """Level less that of the straight tube; (n_angle, n_freq) float64, dB."""
        return np.asarray(20 * np.log10(np.abs(1 + self._relative_change)))

    @property
    def phase_difference(self) -> NDArray[np.float64]:
        """Phase less that of the straight tube; (n_angle, n_freq) float64, degrees."""
        return np.asarray(np.degrees(np.angle(1 + self._relative_change)))

    @property
    def _relative_change(self) -> ComplexArray:
        return (self.transfer_function - self.straight) / self.straight

    @property
    def largest_differences(self) -> NDArray[np.float64]:
        """Largest magnitudes of both differences over frequency; (n_angle, 2) float64: dB and degrees."""
        both = (self.level_difference, self.phase_difference)
        return np.stack([np.abs(values).max(axis=1) for values in both], axis=1)


def solve_bending(
    rig: BendingRig,
    frequency: FrequencyLike,
    fidelity: str = ONE_DESIGN,
    progress: Progress = lambda what, done: None,
) -> Bending:
    """Results of a tube at every angle.

    The joints of straight and bent bore are left out: each counts as about 0.4 bore radii more of the bend, both as
    2 % of what a quarter turn of the published rig changes. Walls are rigid and stay round.

    Args:
        rig: the tube.
        frequency: (n_freq,), Hz, ascending.
        fidelity: of the bent bore, ``"navier-stokes"`` or ``"helmholtz"``, see
            :func:`acoustic_fem.cell.bent_bore.solve_bent_bores`.
        progress: called with what is done and the fraction of all.

    Raises:
        Refusal: a bad frequency or fidelity, before any work.
        LinearSolverError, SweepError: as :func:`acoustic_fem.cell.bent_bore.solve_bent_bores`.
    """
    started = time.perf_counter()
    grid = frequency_grid(frequency)
    checked_physics(fidelity)
    medium = design_air(prototype(PROTOTYPE))
    load = end_load(rig.end, prototype(PROTOTYPE).microphone, grid, medium)
    # One piece per shape of the centre line: it serves every angle.
    shapes = list(dict.fromkeys(rig.winding(angle).pitch for angle in rig.angles if angle > 0))
    windings = [Winding(rig.diameter, 360.0, pitch) for pitch in shapes]
    check_bent_bore(metres(rig.bore) / 2, windings, grid, medium)

    def bores(rings: int, first: float, last: float) -> dict[float, BentBore]:
        def report(done: float) -> None:
            progress(f"bent bore, {6 * rings**2} elements a section", first + (last - first) * done)

        solved = solve_bent_bores(metres(rig.bore) / 2, windings, grid, medium, fidelity, rings, report)
        return dict(zip(shapes, solved, strict=True))

    coarse, fine = (bores(COARSE, 0.0, 0.1), bores(FINE, 0.1, 1.0)) if shapes else ({}, {})
    straight = transfer(rig, 0.0, {}, load, grid, medium)
    by_mesh = [np.stack([transfer(rig, a, b, load, grid, medium) for a in rig.angles]) for b in (coarse, fine)]
    largest = float(np.max(np.abs(by_mesh[1] - straight)))
    change = float(np.max(np.abs(by_mesh[1] - by_mesh[0])))
    progress("done", 1.0)
    return Bending(
        rig=rig,
        fidelity=fidelity,
        medium=medium,
        frequency=grid,
        transfer_function=by_mesh[1],
        straight=straight,
        bend_change=np.stack([bend_change(rig, angle, fine, grid, medium) for angle in rig.angles]),
        mesh_error=change / (2**ORDER - 1) / largest if largest > 0 else 0.0,
        straight_error=max((bore.straight_error for bore in fine.values()), default=0.0),
        unknowns=max((bore.unknowns for bore in fine.values()), default=0),
        seconds=time.perf_counter() - started,
        made_by=versions(None, ("numpy", "scikit-fem", "scipy")),
    )


def end_load(end: End, microphone: Microphone, frequency: NDArray[np.float64], medium: Medium) -> ComplexArray:
    """Admittance that closes the far end.

    The chamber's compliance and the microphone at one pressure; the entrance losses of the chamber and of the sound
    hole are left out, being the same at every angle.

    Args:
        end: what closes it.
        microphone: with its chamber.
        frequency: (n_freq,) float64, Hz.
        medium: the air.

    Returns:
        (n_freq,) complex128, m^3/(Pa s).
    """
    if end == "closed":
        return np.zeros(len(frequency), dtype=np.complex128)
    radius, height = metres(microphone.chamber_diameter) / 2, metres(microphone.chamber_height)
    chamber = 2j * np.pi * frequency * closed_cylinder_compliance(radius, height, frequency, medium)
    return chamber + load_admittance(microphone, frequency, medium)


def transfer(
    rig: BendingRig,
    angle: float,
    bores: dict[float, BentBore],
    load: ComplexArray,
    frequency: NDArray[np.float64],
    medium: Medium,
) -> ComplexArray:
    """Far over near pressure of the tube wound over an angle in its middle.

    Args:
        rig: the tube.
        angle: degrees.
        bores: the bent bores by the pitch of their helix.
        load: (n_freq,) complex128, admittance at the far end, m^3/(Pa s).
        frequency: (n_freq,) float64, Hz.
        medium: the air.

    Returns:
        (n_freq,) complex128, Pa/Pa.
    """
    radius, arc = metres(rig.bore) / 2, rig.winding(angle).arc_length
    rest = (rig.length - arc) / 2
    ends = [plane_wave.port_admittance(radius, metres(rest), frequency, medium)] if rest > 0 else []
    bent = [bores[rig.winding(angle).pitch].port_admittance(metres(arc))] if angle > 0 else []
    parts = [*ends, *bent, *ends]
    chain = [TwoPort(part[:, 0, 0], part[:, 0, 1], part[:, 1, 1]) for part in parts]
    whole = chain[0]
    for part in chain[1:]:
        whole = join(whole, part)
    return -whole.transfer / (whole.last + load)


def bend_change(
    rig: BendingRig, angle: float, bores: dict[float, BentBore], frequency: NDArray[np.float64], medium: Medium
) -> ComplexArray:
    """Relative change of the transfer admittance of the wound part alone.

    Args:
        rig: the tube.
        angle: degrees.
        bores: the bent bores by the pitch of their helix.
        frequency: (n_freq,) float64, Hz.
        medium: the air.

    Returns:
        (n_freq,) complex128.
    """
    if angle == 0:
        return np.zeros(len(frequency), dtype=np.complex128)
    winding = rig.winding(angle)
    length = metres(winding.arc_length)
    straight = plane_wave.port_admittance(metres(rig.bore) / 2, length, frequency, medium)
    return bores[winding.pitch].port_admittance(length)[:, 0, 1] / straight[:, 0, 1] - 1
