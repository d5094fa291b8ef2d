"""Air and rubber of as-built sensors: what the place of use and the batch of rubber change beside the sizes of parts.

A library holds one air and one law of the rubber. A sensor may be used at another altitude or temperature, and the
modulus of its rubber may rise more or less with frequency than its material states. Both shift the transfer functions
of all points together, as no scatter of single parts does.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from acoustic_fem.batch.elements import membrane_modulus
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters
from acoustic_fem.quantities.local_air import AirLike, LocalAir, medium_of
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

MIDDLE = 10.0
"""Frequency at which the modulus of a membrane stays as it is when its slope changes, Hz: the middle of 1 to 100 Hz on
a logarithmic scale. The scatter of the modulus itself is a tolerance of its own."""
_STREAM = 1


@dataclass(frozen=True)
class AirAndRubber:
    """Ranges from which the air of as-built sensors and the slope of their rubber's modulus are drawn, each evenly.

    Raises:
        Refusal: a range that descends, or a value that is not allowed.
    """

    pressure: tuple[float, float] = (77e3, 103e3)
    """Lowest and highest static pressure of the place, 5e4 to 1.2e5 Pa. The default reaches from 2200 m above the sea
    to high pressure at the sea."""
    temperature_c: tuple[float, float] = (5.0, 35.0)
    """Lowest and highest temperature of the air, -20 to 60 degC; the rubber does not change with it."""
    slope: tuple[float, float] = (0.0, 2.0)
    """Smallest and largest exponent of frequency of the membranes' modulus over that of their material, 0 to 5, ratios.
    Relaxing moduli of a table are multiplied by it; a constant modulus stays constant."""
    stiffening: tuple[float, float] = (1.0, 1.0)
    """Smallest and largest modulus of all membranes together over that of their rubber, 0.5 to 5, ratios, drawn evenly
    in its logarithm: enclosed air that bulges the membranes, or a stress in them. By default there is none."""
    fraction: float = 0.4
    """Fraction of the sensors that have an air and a slope of their own, 0 to 1; the others keep those of the
    design. On 36 points in line, 0.5 locates 2 to 4 % more touches at 2000 m than 0.3, and 1 to 9 % fewer of a modulus
    20 % below the design's."""

    def __post_init__(self) -> None:
        ranges = {
            "pressure": (5e4, 1.2e5, "Pa"),
            "temperature_c": (-20.0, 60.0, "degC"),
            "slope": (0.0, 5.0, ""),
            "stiffening": (0.5, 5.0, ""),
        }
        for name, (least, most, unit) in ranges.items():
            low, high = getattr(self, name)
            for value in (low, high):
                check_range(f"air_and_rubber.{name}", value, least, most, unit)
            if low > high:
                raise Refusal(
                    kind=Kind.OUT_OF_RANGE,
                    field=f"air_and_rubber.{name}",
                    value=(low, high),
                    unit=unit,
                    allowed="two values, the lower one first",
                )
        check_range("air_and_rubber.fraction", self.fraction, 0.0, 1.0)

    def draws(self, first: int, count: int, seed: int, design: ArrayDesign, air: AirLike = None) -> DrawnAirAndRubber:
        """Air and slopes of sensors ``first`` to ``first + count - 1``; sensor k depends on (seed, k) alone.

        Args:
            first: number of the first sensor, from 0.
            count: how many.
            seed: of all sensors.
            design: of the sensors; its humidity is that of every air.
            air: air of the sensors that draw none; by default that of the design.
        """
        media, slopes, stiffer = [medium_of(air, design)] * count, np.ones(count), np.ones(count)
        ranges = np.array([self.pressure, self.temperature_c, self.slope, np.log(self.stiffening)])
        for row, number in enumerate(range(first, first + count)):
            if int((number + 1) * self.fraction) == int(number * self.fraction):
                continue
            stream = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(number, _STREAM)))
            pressure, temperature, slopes[row], bulged = map(float, stream.uniform(*ranges.T))
            stiffer[row] = np.exp(bulged)
            media[row] = medium_of(LocalAir(pressure, temperature_c=temperature), design)
        return DrawnAirAndRubber(MediumParameters.from_media(media), slopes, stiffer)


UNKNOWN_AIR_AND_RUBBER = AirAndRubber()
"""Air and rubber assumed of a sensor that nobody calibrated, beside the tolerances ``UNCALIBRATED``."""
SEALED_AIR_AND_RUBBER = AirAndRubber(stiffening=(1.0, 2.0))
"""The same of a sealed sensor without a vent that is worn or carried up: its enclosed air bulges the membranes
(:func:`acoustic_fem.enclosed.enclosed_air`), which doubles their stiffness after a fast climb of 1000 m."""


@dataclass(frozen=True, eq=False)
class DrawnAirAndRubber:
    """Air of each of several sensors, and the slope and stiffening of the modulus of its membranes."""

    medium: MediumParameters
    """Air of each sensor; fields (count,) float64."""
    slope: Array
    """Exponent of frequency of the membranes' modulus over that of their material, (count,) float64, ratios."""
    stiffening: Array
    """Modulus of the membranes over that of their rubber, (count,) float64, ratios."""

    def changed(self, parameters: ArrayParameters) -> ArrayParameters:
        """Parameters of the sensors with their slopes, which leave the modulus at :data:`MIDDLE`, and stiffening.

        Args:
            parameters: of as many sensors, or of one, as NumPy arrays.
        """
        slope = self.slope[:, None]
        steeper = replace(
            parameters,
            membrane_slope=parameters.membrane_slope * slope,
            membrane_relaxation=parameters.membrane_relaxation * slope[..., None],
        )
        before, after = (np.abs(membrane_modulus(each, np.array([MIDDLE])))[..., 0] for each in (parameters, steeper))
        compliance = after / before / self.stiffening[:, None]
        return replace(
            steeper,
            membrane_compliance=parameters.membrane_compliance * compliance,
            membrane_frequency=parameters.membrane_frequency / np.sqrt(compliance)[..., None],
        )
