"""Static pressure of the air in a sensor that was filled elsewhere: warmed, worn, carried up a mountain."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from acoustic_fem.enclosed.sealed_sensor import SealedSensor
from acoustic_fem.membrane.design_discs import design_bulge_ratio
from acoustic_fem.quantities.local_air import LocalAir, checked_air
from acoustic_fem.quantities.medium import GAS_CONSTANT, saturation_pressure
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array

#: Zero degrees Celsius in kelvin.
_ZERO = 273.15
#: Seconds of an hour.
_HOUR = 3600.0


@dataclass(frozen=True)
class EnclosedAir:
    """Equilibrium of the air that is enclosed in a sensor with its membranes."""

    overpressure: float
    """Static pressure above that outside, Pa."""
    vapour: float
    """Partial pressure of water vapour inside, Pa."""
    volume: float
    """Volume with flat membranes, m^3."""
    bulge: float
    """Volume that all membranes sweep outwards, m^3."""
    compliance_ratio: float
    """Compliance of a membrane for small signals by that of the flat one, the mean of all membranes, a ratio."""


def enclosed_air(
    design: DesignLike,
    air: LocalAir | None = None,
    *,
    hours: float = 0.0,
    stiffness: float = 1.0,
) -> EnclosedAir:
    """Static pressure of the air in a sensor that was closed, or left to rest, in the air of its design.

    All cavities are connected, so there is one pressure. At first the sensor keeps its gas, whose pressure follows its
    temperature while the membranes bulge. Then air and vapour leave or enter through the silicone, and through leaks,
    until the partial pressures are those outside (:data:`acoustic_fem.enclosed.sealed_sensor.PERMEABILITY`). Vapour
    is a hundred times as fast. Vapour above saturation condenses.

    The static modulus is that of the material, which stays as it is with temperature.

    Args:
        design: the array, in the air in which it was closed; its own overpressure does not count.
        air: present air outside, at the membranes; values that are not given are those of the design. Its overpressure
            does not count.
        hours: time since the sensor came from one air into the other, at least 0; infinity for equilibrium.
        stiffness: Young's modulus of all membranes by that of the design, a ratio.

    Raises:
        Refusal: a value out of range, a membrane that is stretched or not flat, or no equilibrium as far as the law of
            the bulge goes.
    """
    checked_air(air)
    design = resolve_design(design)
    check_range("hours", hours, 0, math.inf, "h")
    filled, design = design.air, design.with_values((air or LocalAir()).design_values)
    present, sensor = design.air, SealedSensor.of(design, stiffness)
    before, kelvin = filled.temperature + _ZERO, present.temperature + _ZERO
    saturated, outside = saturation_pressure(kelvin), present.pressure
    wet = filled.humidity * saturation_pressure(before)
    amount = np.array([filled.pressure - wet, wet]) * sensor.volume / (GAS_CONSTANT * before)

    def state(moles: Array) -> tuple[float, float]:
        """Overpressure and partial pressure of vapour."""
        above = sensor.overpressure(float(moles.sum()), kelvin, outside)
        part = (outside + above) * float(moles[1] / moles.sum())
        if part <= saturated:
            return above, part
        # The rest is water: the dry air has what saturated vapour leaves of the pressure.
        return sensor.overpressure(float(moles[0]), kelvin, outside - saturated), saturated

    damp = present.humidity * saturated
    if hours > 0:
        if math.isinf(hours):
            return _equilibrium(design, sensor, 0.0, damp, stiffness)
        permeance = np.array([sensor.permeance("air"), sensor.permeance("vapour")])

        def flow(_: float, moles: Array) -> Array:
            above, inside = state(moles)
            partial = np.array([outside + above - inside, inside])
            around = np.array([outside - damp, damp])
            leaking = sensor.leak * above / (GAS_CONSTANT * kelvin) * (partial if above > 0 else around)
            return -(permeance * (partial - around) + leaking)

        scale = float(amount.sum())
        solved = solve_ivp(
            lambda t, y: flow(t, y * scale) / scale,
            (0.0, hours * _HOUR),
            amount / scale,
            method="LSODA",
            rtol=1e-8,
            atol=1e-10,
        )
        amount = solved.y[:, -1] * scale
    above, inside = state(amount)
    return _equilibrium(design, sensor, above, inside, stiffness)


def _equilibrium(
    design: ArrayDesign, sensor: SealedSensor, above: float, vapour: float, stiffness: float
) -> EnclosedAir:
    kinds = list(design.kind_of_point)
    ratios = np.array([float(design_bulge_ratio(design.of_kind(kind), above, stiffness)) for kind in design.kinds])
    return EnclosedAir(above, vapour, sensor.volume, sensor.bulge(above), float(ratios[kinds].mean()))
