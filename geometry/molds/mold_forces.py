"""Forces on a mold: the weight that closes it, and the blade in a slot that opens it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from geometry.molds.mold_plan import MoldPlan

#: Pressure of the air on a lid below which there is none, MPa: no lid is held by a stronger suction.
ATMOSPHERE = 0.101325
#: Largest bending stress in a printed part, MPa; assumed: half of the flexural strength of rigid resins, 80 to 110 MPa.
ALLOWED_STRESS = 45.0
#: Lid, and what a slot for a blade takes of it, mm.
LID_THICKNESS, PRY_DEPTH, PRY_HEIGHT = 3.0, 3.0, 0.9
#: Weight on the lid, N, and how long it presses until the thickness of the film is stated, s.
CLOSING_FORCE, CLOSING_TIME = 10.0, 60.0
#: Viscosity of mixed silicone, Pa s; assumed, at the upper end of what makers state for casting silicones.
VISCOSITY = 30.0
#: Height to which silicone stands above the rims of the cavities before the lid is closed, mm; assumed.
OVERFILL = 0.2


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


def closed_film(plan: MoldPlan) -> float:
    """Thickness of the silicone that stays on the lands after a minute below 1 kg, mm.

    Stefan's equation of a long strip: F = viscosity L w^3 / h^3 |dh/dt|, so h = sqrt(viscosity L w^3 / (2 F t)).
    It holds for a film much thinner than the strip is wide, and parallel faces.
    """
    inner, outer = (1e-3 * radius for radius in plan.land)
    length = len(plan.centres) * math.pi * (inner + outer)
    return 1e3 * math.sqrt(VISCOSITY * length * (outer - inner) ** 3 / (2 * CLOSING_FORCE * CLOSING_TIME))


def overflow(plan: MoldPlan) -> float:
    """Silicone that stands above the rims of all cavities and goes into the grooves and the gap, mm^3."""
    return len(plan.centres) * math.pi * plan.land[0] ** 2 * OVERFILL


def room_for_overflow(plan: MoldPlan) -> float:
    """Room in the grooves and in the gap between the halves, mm^3."""
    start, end = plan.groove
    groove = math.pi * (end**2 - start**2) * (plan.gap - plan.groove_bottom)
    cavities = len(plan.centres)
    gap = (4 * plan.half[0] * plan.half[1] - cavities * math.pi * start**2) * -plan.gap
    return gap + cavities * groove
