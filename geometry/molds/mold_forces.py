"""Forces of a blade in a slot that opens a mold."""

from __future__ import annotations

import math
from dataclasses import dataclass

#: Pressure of the air on a lid below which there is none, MPa: no lid is held by a stronger suction.
ATMOSPHERE = 0.101325
#: Largest bending stress in a printed part, MPa; assumed: half of the flexural strength of rigid resins, 80 to 110 MPa.
ALLOWED_STRESS = 45.0
#: Lid, and what a slot for a blade takes of it, mm.
LID_THICKNESS, PRY_DEPTH, PRY_HEIGHT = 3.0, 3.0, 0.9


@dataclass(frozen=True)
class OpeningForces:
    """Forces and stresses while a blade in one slot lifts the lid, at most: air sucks on all cavities and lands.

    The path of the force: the blade stands on the floor of the slot in the base and lifts the roof of the slot in the
    lid. The lid turns about its opposite edge, so the slot takes half of the suction.
    """

    suction: float
    """Force that holds the lid, N."""
    blade: float
    """Force of the blade on the roof of the slot and on its floor, N."""
    roof_stress: float
    """Bending stress in the roof of the slot, MPa."""
    lid_stress: float
    """Bending stress in the middle of the lid, MPa."""

    @property
    def holds(self) -> bool:
        """True where no stress is above the allowed one."""
        return max(self.roof_stress, self.lid_stress) <= ALLOWED_STRESS


def opening_forces(cavities: int, land: float, block: tuple[float, float], slot: float) -> OpeningForces:
    """Forces while a lid is lifted at a short side.

    Args:
        cavities: number of cavities.
        land: outer radius of their lands, mm.
        block: length of the lid along x and y, mm.
        slot: width of the slot, mm.
    """
    suction = ATMOSPHERE * cavities * math.pi * land**2
    blade = suction / 2
    # Roof: a cantilever as wide as the slot that the tip of the blade bends at its end.
    roof = 6 * blade * PRY_DEPTH / (slot * (LID_THICKNESS - PRY_HEIGHT) ** 2)
    # Lid: a beam between the blade and the opposite edge under an even load.
    bend = 6 * suction * max(block) / 8 / (min(block) * LID_THICKNESS**2)
    return OpeningForces(suction, blade, roof, bend)
