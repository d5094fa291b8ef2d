"""Silicone in a closed mold: what flows over the rims, the room for it, and the film that a weight leaves."""

from __future__ import annotations

import math

from geometry.molds.mold_plan import MoldPlan

#: Weight on the lid, N, and how long it presses until the thickness of the film is stated, s.
CLOSING_FORCE, CLOSING_TIME = 10.0, 60.0
#: Viscosity of mixed silicone, Pa s; assumed, at the upper end of what makers state for casting silicones.
VISCOSITY = 30.0
#: Height to which silicone stands above the rims of the cavities before the lid is closed, mm; assumed.
OVERFILL = 0.2


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
