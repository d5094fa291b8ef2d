"""Membranes of a virtual rig's sensor: mounted with strain and on glue, bulged by its enclosed air, and relaxing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from acoustic_fem.batch.elements import membrane_modulus
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.enclosed import enclosed_air
from acoustic_fem.membrane import design_bulge_ratio, design_mounting_ratio
from acoustic_fem.quantities.local_air import LocalAir
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

#: Hz, about which the rubber of a batch rises more steeply or less; and where its relaxations lie.
_MIDDLE, _RELAXATIONS = 10.0, 10.0 ** np.arange(-1.0, 4.0)


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
        Refusal: a design whose enclosed air is not at rest, a membrane that is stretched or not flat, air out of range,
            or no equilibrium.
    """
    if rested.air.overpressure:
        problem = "must be 0 if the rig is warmed, carried up or in other humidity, because its air was at rest before"
        raise Refusal(problem, kind=Kind.CONFLICT, field="air.overpressure", value=rested.air.overpressure, unit="Pa")
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
    return softened(hidden, ratio), found.overpressure


def mounted_sensor(
    hidden: ArrayParameters, design: ArrayDesign, prestrain: float, glue_thickness: float
) -> ArrayParameters:
    """Parameters of a sensor whose membranes are mounted with further strain and on more glue than the design states.

    Args:
        hidden: of the sensor with membranes as the design states, a column for each point.
        design: the nominal array.
        prestrain: further strain, a ratio.
        glue_thickness: further thickness of the glue, m.

    Raises:
        Refusal: a membrane that is stretched or not flat, or that is pressed together until it all but buckles.
    """
    if prestrain == 0 and glue_thickness == 0:
        return hidden
    alike = [design.of_kind(kind) for kind in design.kinds]
    ratio = [design_mounting_ratio(each, prestrain, glue_thickness) / design_mounting_ratio(each) for each in alike]
    return softened(hidden, np.array(ratio)[list(design.kind_of_point)])


def relaxing_sensor(parameters: ArrayParameters, slope: float) -> ArrayParameters:
    """Membranes whose modulus rises with frequency by a further exponent about 10 Hz, where it stays as it is.

    One relaxation a decade, all of one strength: a causal law whatever the slope (Ferry 1980, chapter 3).

    Args:
        parameters: of the sensor.
        slope: further exponent, from 0.
    """
    if slope == 0:
        return parameters
    before = np.abs(membrane_modulus(parameters, np.array([_MIDDLE])))[..., 0]
    strength = slope * np.log(10) * before[..., None] * np.ones(len(_RELAXATIONS))
    times = np.broadcast_to(1 / (2 * np.pi * _RELAXATIONS), strength.shape)
    joined = replace(
        parameters,
        membrane_relaxation=np.concatenate([parameters.membrane_relaxation, strength], axis=2),
        membrane_relaxation_time=np.concatenate([parameters.membrane_relaxation_time, times], axis=2),
    )
    stiffer = np.abs(membrane_modulus(joined, np.array([_MIDDLE])))[..., 0] / before
    return replace(
        joined,
        membrane_compliance=joined.membrane_compliance * stiffer,
        membrane_frequency=joined.membrane_frequency / np.sqrt(stiffer)[..., None],
    )


def softened(parameters: ArrayParameters, ratio: Array) -> ArrayParameters:
    """Parameters with compliances of the membranes multiplied by a ratio of each point, (n_point,) float64."""
    return replace(
        parameters,
        membrane_compliance=parameters.membrane_compliance * ratio,
        membrane_frequency=parameters.membrane_frequency / np.sqrt(ratio)[:, None],
    )
