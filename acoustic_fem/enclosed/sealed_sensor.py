"""Volume that a sensor encloses, how it grows with the pressure inside, and how fast gas leaves it."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import Literal

from scipy.optimize import brentq

from acoustic_fem.membrane.bulged import BulgeLaw
from acoustic_fem.membrane.design_discs import design_bulge, mounted_modulus
from acoustic_fem.network.yielding import design_leak
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import GAS_CONSTANT
from acoustic_fem.quantities.units import cubic_metres, metres
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import positive_numbers
from geometry.ground.refusal import Kind, Refusal

BARRER = 3.348e-16
"""One barrer, mol m / (m^2 s Pa)."""
PERMEABILITY = {"air": 340 * BARRER, "vapour": 36000 * BARRER}
"""Permeability of silicone rubber for air (nitrogen 280 and oxygen 600 barrer by their fractions) and for water
vapour, mol m / (m^2 s Pa), at 25 degC; W. L. Robb, "Thin silicone membranes", Ann. N. Y. Acad. Sci. 146 (1968) 119."""

Gas = Literal["air", "vapour"]


@dataclass(frozen=True)
class Bulging:
    """Membranes of one kind."""

    count: int
    """Number of them."""
    radius: float
    """Radius of the opening, m."""
    thickness: float
    """Thickness, m."""
    youngs_modulus: float
    """Young's modulus of a slow load, Pa."""
    law: BulgeLaw
    """Law of their bulge."""

    def volume(self, overpressure: float) -> float:
        """Volume that all of them sweep outwards at a pressure in Pa, m^3."""
        return self.count * self.radius**3 * float(self.law.volume(overpressure / self.youngs_modulus))

    @property
    def compliance(self) -> float:
        """Volume that all of them sweep per small pressure, flat, m^3/Pa."""
        small = 1e-6
        return self.count * self.radius**3 * float(self.law.volume(small)) / (small * self.youngs_modulus)

    @property
    def largest(self) -> tuple[float, float]:
        """Largest suction and largest pressure for which there is an equilibrium, Pa."""
        return self.law.largest(False) * self.youngs_modulus, self.law.largest(True) * self.youngs_modulus


@dataclass(frozen=True)
class SealedSensor:
    """Enclosed air of a sensor: cavities, tubes, chambers and microphones, which are connected, under its membranes."""

    volume: float
    """Volume with flat membranes, m^3."""
    membranes: tuple[Bulging, ...]
    """Membranes, by the kinds of points."""
    leak: float
    """Conductance of all leaks together at the air of the design, m^3/(Pa s); 0 if the sensor is tight."""

    @classmethod
    def of(cls, design: DesignLike, stiffness: float = 1.0) -> SealedSensor:
        """The sensor of a design.

        Soft floors and soft sheaths count as rigid.

        Args:
            design: the array.
            stiffness: Young's modulus of all membranes by that of the design, a ratio.

        Raises:
            Refusal: a membrane that is stretched or not flat, or a stiffness that is not above 0.
        """
        design = resolve_design(design)
        positive_numbers("stiffness", stiffness)
        air, kinds = design_air(design), Counter(design.kind_of_point)
        membranes, volume, leak = [], _tubes_and_microphones(design), 0.0
        for number, kind in enumerate(design.kinds):
            alike, count = design.of_kind(kind), kinds[number]
            membranes.append(
                Bulging(
                    count,
                    metres(alike.resonator.cavity_diameter) / 2,
                    metres(alike.membrane.thickness),
                    stiffness * mounted_modulus(alike),
                    design_bulge(alike),
                )
            )
            volume += count * cubic_metres(alike.resonator.cavity_volume)
            leak += count * design_leak(alike, air)
        return cls(volume, tuple(membranes), leak)

    def bulge(self, overpressure: float) -> float:
        """Volume that the membranes sweep outwards at a pressure above that outside, m^3.

        Args:
            overpressure: of either sign, Pa.

        Raises:
            Refusal: a pressure beyond the last equilibrium of a membrane.
        """
        return sum(each.volume(overpressure) for each in self.membranes)

    @property
    def compliance(self) -> float:
        """Volume that the flat membranes sweep together per small pressure, m^3/Pa."""
        return sum(each.compliance for each in self.membranes)

    def permeance(self, gas: Gas) -> float:
        """Flow of a gas out through the openings of all membranes per difference of its partial pressure, mol/(Pa s).

        Args:
            gas: "air" or "vapour".
        """
        return sum(
            each.count * math.pi * each.radius**2 / each.thickness * PERMEABILITY[gas] for each in self.membranes
        )

    def overpressure(self, moles: float, kelvin: float, outside: float) -> float:
        """Pressure of the enclosed gas above that outside, in equilibrium with the membranes.

        The volume grows as the membranes bulge, and the pressure falls with it: (p + dp)(V + bulge(dp)) = n R T.

        Args:
            moles: amount of gas, mol.
            kelvin: its temperature.
            outside: static pressure outside, Pa.

        Raises:
            Refusal: there is no equilibrium as far as the law of the bulge goes.
        """

        def excess(pressure: float) -> float:
            return (outside + pressure) * (self.volume + self.bulge(pressure)) - moles * GAS_CONSTANT * kelvin

        start = excess(0.0)
        if start == 0:
            return 0.0
        outwards = start < 0
        ends = [each.largest[outwards] for each in self.membranes]
        end = min(ends) if outwards else -min(*ends, 0.999 * outside)
        if excess(end) * start > 0:
            raise Refusal(
                f"is beyond {end:+.3g} Pa, where the law of the bulge of its membranes ends",
                kind=Kind.NO_RESULT,
                field="overpressure",
                remedy="give the sensor a vent",
            )
        return float(brentq(excess, 0.0, end, xtol=1e-6, rtol=1e-12))

    def time_constant(self, pressure: float, conductance: float) -> float:
        """Time in which a small static pressure falls to 1/e through a leak, s.

        The gas in the volume and the membranes give way together: (V / p + C) / G. The temperature stays.

        Args:
            pressure: static pressure, Pa.
            conductance: of the leak, m^3/(Pa s); 0 gives infinity.
        """
        held = self.volume / pressure + self.compliance
        return held / conductance if conductance > 0 else math.inf


def _tubes_and_microphones(design: ArrayDesign) -> float:
    """Volume of all tubes and of chambers, sound holes and back volumes of all microphones, m^3."""
    lip = design.printing.port_lip
    tubes = sum(
        math.pi / 4 * tube.acoustic_diameter**2 * tube.acoustic_length(lip)
        for line in design.lines
        for tube in design.tubes_of(line)
    )
    own = design.microphone
    chamber = math.pi / 4 * own.chamber_diameter**2 * own.chamber_height
    hole = math.pi / 4 * own.sound_hole_diameter**2 * own.sound_hole_length
    return cubic_metres(tubes + len(design.microphones) * (chamber + hole + own.back_volume))
