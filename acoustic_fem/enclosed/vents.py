"""Vents that let the static pressure of enclosed air out, and what they cost at low frequencies."""

from __future__ import annotations

import math
from dataclasses import dataclass

from scipy.optimize import brentq

from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.enclosed.sealed_sensor import SealedSensor
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.units import metres
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range

NARROWEST = 0.02
"""Narrowest bore of a vent that is suggested, mm: that of fused-silica capillaries; narrower ones clog."""
WIDEST = 0.1
"""Widest bore of a vent that is suggested, mm: that of design files."""


@dataclass(frozen=True)
class Vent:
    """A capillary from the enclosed air to the outside, one for the whole sensor."""

    diameter: float
    """Bore, mm."""
    length: float
    """Length, mm."""
    time_constant: float
    """Time in which a static pressure falls to 1/e, s."""

    @property
    def corner(self) -> float:
        """Frequency below which a pressure in all cavities is let out, 3 dB at it, Hz."""
        return 1 / (2 * math.pi * self.time_constant)

    def level(self, frequency: float) -> float:
        """Level of a pressure in all cavities by that without the vent, at most 0, dB.

        Args:
            frequency: Hz.

        Raises:
            Refusal: a frequency that is not above 0.
        """
        return vent_level(self.time_constant, frequency)


def vent_level(time_constant: float, frequency: float) -> float:
    """Level of a pressure in all cavities with a vent by that without it, at most 0, dB.

    Args:
        time_constant: time in which a static pressure falls to 1/e, s.
        frequency: Hz.

    Raises:
        Refusal: a frequency that is not above 0.
    """
    check_range("frequency", frequency, 0, math.inf, "Hz", excluded="low")
    return -10 * math.log10(1 + 1 / (2 * math.pi * time_constant * frequency) ** 2)


def design_vent(design: DesignLike) -> float:
    """Time in which a static pressure falls to 1/e through the leaks of a design, s; infinity where it is tight.

    Raises:
        Refusal: a membrane that is stretched or not flat.
    """
    design = resolve_design(design)
    sensor = SealedSensor.of(design)
    return sensor.time_constant(design.air.pressure, sensor.leak)


def suggested_vent(design: DesignLike, time_constant: float = 10.0) -> Vent:
    """One vent for the whole sensor through the wall of a resonator, by the time that a static pressure may last.

    The tubes between the cavities resist far less than the vent, so one is enough. The bore is at least
    :data:`NARROWEST` and at most :data:`WIDEST`: then the time is what it gives.

    Args:
        design: the array, whose own leaks do not count.
        time_constant: time in which a static pressure falls to 1/e, 0.1 to 1000 s.

    Raises:
        Refusal: a time out of range, or a membrane that is stretched or not flat.
    """
    check_range("time_constant", time_constant, 0.1, 1000, "s")
    design = resolve_design(design)
    sensor, air, length = SealedSensor.of(design), design_air(design), design.resonator.wall_thickness

    def lasts(diameter: float) -> float:
        return sensor.time_constant(air.pressure, leak_conductance(metres(diameter) / 2, metres(length), air))

    if lasts(NARROWEST) <= time_constant:
        diameter = NARROWEST
    elif lasts(WIDEST) >= time_constant:
        diameter = WIDEST
    else:
        diameter = float(brentq(lambda bore: math.log(lasts(bore) / time_constant), NARROWEST, WIDEST))
    return Vent(diameter, length, lasts(diameter))
