"""Effect of the air that a sealed sensor encloses: worn, sweating and carried up, and the vent that would help."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from acoustic_fem import Library, LocalAir
from acoustic_fem.enclosed import SealedSensor, Vent, design_vent, enclosed_air, suggested_vent, vent_level
from acoustic_fem.membrane import design_stiffening
from acoustic_fem.quantities.medium import GAS_CONSTANT
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal

WARMING = 12.0
"""Warming of a sensor that is worn on the skin, K."""
SWEAT = 0.85
"""Relative humidity at the membranes of a sensor on sweating skin."""
CLIMB = 1000.0
"""Height of a fast climb, by car or cable car, m."""
QUIET = 1e-3
"""Transfer function below which a change is not counted, Pa/Pa: far points of long lines lose hundreds of dB, and a
stiffer membrane changes these by many orders of magnitude.
"""


@dataclass(frozen=True)
class EnclosedChange:
    """State of a sealed sensor whose enclosed air is not at rest, against the sensor at rest."""

    state: str
    """Name of the state, in words."""
    overpressure: float
    """Static pressure of the enclosed air above that outside, Pa."""
    compliance: float
    """Change of the compliance of the membranes, %."""
    response: float
    """Largest change of a transfer function above :data:`QUIET` at the checked frequencies, gas and membranes, %."""


@dataclass(frozen=True)
class EnclosedFindings:
    """Effect of enclosed air on a design."""

    changes: tuple[EnclosedChange, ...]
    """States, each shortly after the change; empty if the bulge of the membranes is not known."""
    hours: float
    """Time in which air leaves through the silicone, to 1/e, h."""
    leak_seconds: float
    """Time in which a static pressure falls to 1/e through the leaks of the design, s; infinity if it is tight."""
    vent: Vent | None
    """The one vent that would help; None if the design has a leak, or the bulge of its membranes is not known."""
    unknown: str = ""
    """Reason why nothing is known of the bulge; empty if it is."""

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """Name and value of how long a static pressure lasts, and of the vent that would help."""
        if self.unknown:
            return (("enclosed air", f"is not checked: {self.unknown}"),)
        if self.vent is None:
            return (
                ("these pressures last", f"{self.leak_seconds:.2g} s, because of the leak"),
                ("the leak takes", _levels(self.leak_seconds)),
            )
        vent = self.vent
        return (
            ("these pressures last", f"{self.hours:.2g} h, until air has left through the silicone"),
            (
                "a vent would help",
                f"{vent.diameter:.2g} mm bore, {vent.length:g} mm long, in one resonator (point_kinds, leak_diameter)",
            ),
            ("with it they last", f"{vent.time_constant:.2g} s"),
            ("and it takes", _levels(vent.time_constant)),
        )

    def to_dict(self) -> dict[str, Any]:
        """Findings as JSON can hold them; null for what is infinite."""
        return {
            "changes": [asdict(each) for each in self.changes],
            "hours": self.hours if math.isfinite(self.hours) else None,
            "leak_seconds": self.leak_seconds if math.isfinite(self.leak_seconds) else None,
            "vent": None if self.vent is None else asdict(self.vent),
            "unknown": self.unknown,
        }


def enclosed_findings(design: ArrayDesign, library: Library) -> EnclosedFindings:
    """Effect of enclosed air on a design at rest.

    Args:
        design: the array; its own overpressure does not count.
        library: computed transfer functions of it, at the frequencies that are checked.
    """
    air = design.air
    there = {
        f"worn, {WARMING:g} K warmer": (LocalAir(temperature_c=min(air.temperature + WARMING, 60.0)), 0.0),
        "worn and sweating": (LocalAir(temperature_c=min(air.temperature + WARMING, 60.0), humidity=SWEAT), 0.25),
        f"fast climb of {CLIMB:g} m": (LocalAir(pressure=air.pressure * _climbed()), 0.0),
    }
    changes = []
    try:
        sensor = SealedSensor.of(design)
        tight = design.with_values(_without_leaks(design))
        for state, (place, hours) in there.items():
            found = enclosed_air(tight, place, hours=hours)
            moved = library.in_air(LocalAir(**{**asdict(place), "overpressure": found.overpressure}))
            at_rest = library.transfer_function.values
            loud = np.abs(at_rest) >= min(QUIET, np.abs(at_rest).max())
            ratio = moved.transfer_function.values[loud] / at_rest[loud]
            changes.append(
                EnclosedChange(
                    state,
                    found.overpressure,
                    100 * (_softer(design, moved.design) - 1),
                    100 * float(np.abs(ratio - 1).max()),
                )
            )
    except Refusal as problem:
        return EnclosedFindings((), math.inf, math.inf, None, str(problem))
    conductance = sensor.permeance("air") * GAS_CONSTANT * (air.temperature + 273.15) / air.pressure
    hours = sensor.time_constant(air.pressure, conductance) / 3600
    vent = suggested_vent(design) if sensor.leak == 0 else None
    return EnclosedFindings(tuple(changes), hours, design_vent(design), vent)


def _softer(before: ArrayDesign, after: ArrayDesign) -> float:
    """Compliance of the membranes by that before, the mean of all points: by their bulge and their strain."""
    ratios = [design_stiffening(before.of_kind(kind)) / design_stiffening(after.of_kind(kind)) for kind in before.kinds]
    return float(np.mean([ratios[kind] for kind in before.kind_of_point]))


def _levels(seconds: float) -> str:
    """Words on the level that a vent takes from low frequencies, by the time in which a pressure falls to 1/e."""
    each = (f"{-vent_level(seconds, frequency):.2g} dB at {frequency:g} Hz" for frequency in (1.0, 0.1))
    return " and ".join(each)


def _climbed() -> float:
    """Pressure above a climb by that below it, a ratio."""
    from_sea = LocalAir(altitude=CLIMB).design_values["air.pressure"]
    return from_sea / LocalAir(altitude=0.0).design_values["air.pressure"]


def _without_leaks(design: ArrayDesign) -> dict[str, float]:
    """Values that close all leaks of a design."""
    kinds = (f"point_kinds.{name}.leak_diameter" for name, kind in design.point_kinds.items() if kind.leak_diameter)
    return {"resonator.leak_diameter": 0.0, **dict.fromkeys(kinds, 0.0)}
