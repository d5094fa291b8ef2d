"""The air of the place where a sensor is used, where it differs from that of its design, and the air inside."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from acoustic_fem.quantities.medium import Medium
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal

if TYPE_CHECKING:
    from geometry.design.array_design import ArrayDesign

#: m, between which :func:`standard_pressure` stays within what :class:`acoustic_fem.Medium` takes.
ALTITUDES = (-1000.0, 5500.0)
#: Pa, largest static pressure of enclosed air above that outside, and largest one below it.
LARGEST_OVERPRESSURE = 2e4


def standard_pressure(altitude: float) -> float:
    """Static pressure of the standard atmosphere, Pa; ISO 2533:1975, below 11 km.

    Weather moves it by about 2 % to either side.

    Args:
        altitude: above the sea, -1000 to 5500 m.

    Raises:
        Refusal: an altitude out of range.
    """
    return 101325.0 * (1 - 2.25577e-5 * check_range("altitude", altitude, *ALTITUDES, "m")) ** 5.25588


def checked_air(air: object, *, gas: bool = False) -> None:
    """Refuse an argument ``air`` that is not an air: a text, a mapping or a number would be ignored.

    Args:
        air: the argument; None stands for the air of the design.
        gas: whether a :class:`acoustic_fem.Medium` is allowed too.

    Raises:
        Refusal: neither None nor a :class:`LocalAir`, nor a medium where one is allowed.
    """
    if air is None or isinstance(air, LocalAir) or (gas and isinstance(air, Medium)):
        return
    allowed = "an acoustic_fem.LocalAir or an acoustic_fem.Medium" if gas else "an acoustic_fem.LocalAir"
    remedy = "for example LocalAir(altitude=1000)"
    raise Refusal(kind=Kind.WRONG_TYPE, field="air", value=air, allowed=allowed, remedy=remedy)


@dataclass(frozen=True)
class LocalAir:
    """Air of a place; values that you do not give are those of the design."""

    pressure: float | None = None
    """Static pressure, not reduced to sea level, 5e4 to 1.2e5 Pa."""
    altitude: float | None = None
    """In place of the pressure: height above the sea, -1000 to 5500 m, see :func:`standard_pressure`."""
    temperature_c: float | None = None
    """Temperature, -20 to 60 degC."""
    humidity: float | None = None
    """Relative humidity, 0 to 1."""
    overpressure: float | None = None
    """Static pressure of the enclosed air above that outside, -2e4 to 2e4 Pa, see
    :func:`acoustic_fem.enclosed.enclosed_air`; it bulges the membranes."""

    def __post_init__(self) -> None:
        if self.pressure is not None and self.altitude is not None:
            raise Refusal(
                ("must not be given beside ", Field("altitude"), f" = {self.altitude:g} m"),
                kind=Kind.CONFLICT,
                field="pressure",
                value=self.pressure,
                unit="Pa",
                remedy="give one of them",
            )
        if self.altitude is not None:
            standard_pressure(self.altitude)
        if self.overpressure is not None:
            check_range("overpressure", self.overpressure, -LARGEST_OVERPRESSURE, LARGEST_OVERPRESSURE, "Pa")
        stated = {name: getattr(self, name) for name in ("pressure", "temperature_c", "humidity")}
        Medium.at(**{name: value for name, value in stated.items() if value is not None})  # which knows the ranges

    @property
    def design_values(self) -> dict[str, float]:
        """Values of the design that it changes, by dotted name; empty if no value is given."""
        pressure = self.pressure if self.altitude is None else standard_pressure(self.altitude)
        stated = {
            "air.pressure": pressure,
            "air.temperature": self.temperature_c,
            "air.humidity": self.humidity,
            "air.overpressure": self.overpressure,
        }
        return {name: float(value) for name, value in stated.items() if value is not None}


AirLike: TypeAlias = LocalAir | Medium | None
"""An argument ``air``: the air of a place, a gas of its own, or None for the air of the design."""


def medium_of(air: AirLike, design: ArrayDesign | None = None) -> Medium:
    """The gas of an argument ``air``, at the pressure that it has in the sensor.

    Args:
        air: of a place, whose values that are not given are those of the design; or a gas, which is handed back.
        design: where there is none, its air counts as 20 degC, 50 % relative humidity and 101325 Pa.

    Raises:
        Refusal: an air of another type.
    """
    if isinstance(air, Medium):
        return air
    checked_air(air, gas=True)
    values: dict[str, float] = {
        "air.temperature": 20.0,
        "air.humidity": 0.5,
        "air.pressure": 101325.0,
        "air.overpressure": 0.0,
    }
    if design is not None:
        values = {name: getattr(design.air, name.removeprefix("air.")) for name in values}
    values |= air.design_values if air else {}
    temperature, humidity, outside, overpressure = values.values()
    return Medium.at(temperature, humidity, outside + overpressure)


def design_air(design: ArrayDesign) -> Medium:
    """The air that a design states."""
    return medium_of(None, design)
