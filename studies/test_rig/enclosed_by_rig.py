"""Enclosed air of a virtual rig's sensor that is worn or carried up: it bulges the membranes, each by its stiffness."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.enclosed import enclosed_air
from acoustic_fem.membrane import design_bulge_ratio
from acoustic_fem.quantities.local_air import LocalAir
from geometry.design.array_design import ArrayDesign


def bulged_sensor(
    hidden: ArrayParameters, rested: ArrayDesign, present: LocalAir, hours: float, stiffness: float
) -> tuple[ArrayParameters, float]:
    """Parameters of a sensor whose enclosed air is not at rest, and the pressure of that air above that outside, Pa.

    Args:
        hidden: of the sensor with flat membranes, a column for each point.
        rested: the design in the air in which the enclosed air was at rest.
        present: the air outside.
        hours: time since it is there, h.
        stiffness: Young's modulus of all membranes together by that of the design, a ratio.

    Raises:
        Refusal: a membrane that is stretched or not flat, air out of range, or no equilibrium.
    """
    found = enclosed_air(rested, present, hours=hours, stiffness=stiffness)
    nominal = np.array(
        [ArrayParameters.from_design(rested.of_kind(kind)).membrane_compliance[0, 0] for kind in rested.kinds]
    )
    kinds = np.array(rested.kind_of_point)
    own = nominal[kinds] / hidden.membrane_compliance[0]
    ratio = np.empty(len(kinds))
    for number, kind in enumerate(rested.kinds):
        alike = kinds == number
        ratio[alike] = design_bulge_ratio(rested.of_kind(kind), found.overpressure, own[alike])
    bulged = replace(
        hidden,
        membrane_compliance=hidden.membrane_compliance * ratio,
        membrane_frequency=hidden.membrane_frequency / np.sqrt(ratio)[:, None],
    )
    return bulged, found.overpressure
