"""Leaks of cavities to the outside: capillaries so narrow that only their resistance counts."""

from __future__ import annotations

import numpy as np

from acoustic_fem.duct.tube_opening import RESISTANCE
from acoustic_fem.quantities.local_air import AirLike, medium_of
from geometry.ground.argument_checks import check_range, positive_numbers


def leak_conductance(radius: float, length: float, air: AirLike) -> float:
    """Flow out of a round capillary per pressure before it, 1 / (8 mu L / (pi a^4) + 3 mu / a^3), m^3/(Pa s).

    Poiseuille's resistance and that of both openings. Against the capillary as a duct with openings, inertia and gas
    included, up to 100 Hz: within 0.5 % for a bore of 50 um and a length of 1 mm, 2 % for 100 um.

    Args:
        radius: of its bore, m; 0: no leak.
        length: m.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
    """
    medium = medium_of(air)
    check_range("radius", radius, 0, np.inf, "m")
    positive_numbers("length", length, "m")
    poiseuille, openings = 8 * length / np.pi, 2 * RESISTANCE * radius
    return float(radius**4 / (medium.viscosity * (poiseuille + openings)))
