"""Leak tests of a build, computed from the design: pressure to apply, bulge to see, largest fall of a water gauge.

A leak of conductance G beside a compliance C is a high-pass of corner G / (2 pi C). It must lie a decade below the
high-pass of a stream, which is 3 Hz. A water gauge is a hose of section A, bent to a U, whose two levels part by the
height of the pressure. It holds the compliance A / (2 rho g), far more than the cell, so that the height falls slowly
enough to be read.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.membrane import bulge, design_disc, design_membrane
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.units import cubic_metres, metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal

#: Largest corner that a leak may have, Hz: a tenth of the high-pass of a stream.
LARGEST_CORNER = 0.3
#: Bore of the hose of the water gauge, m, and how long its level is watched, s.
GAUGE_BORE, WATCHED = 2e-3, 30.0
#: Pressures that are tried, Pa: the highest at which the membrane bulges by little; 2 kPa are 204 mm of water.
_PRESSURES = (2000.0, 1000.0, 500.0, 200.0, 100.0)
#: Largest bulge in the middle by the radius of the opening, at which silicone is far from tearing.
_LARGEST_BULGE = 0.15
#: Pressure of a metre of water, Pa.
_WATER = 9810.0
#: Length of the hole that the limit is translated into, m, and diameter of the bubble of soap water, m.
_HOLE_LENGTH, _BUBBLE = 1e-3, 1e-3


#: Blunt needles by their gauge: outside diameter, mm, by the usual scale of needles.
_NEEDLES = {
    18: 1.27, 20: 0.91, 21: 0.82, 22: 0.72, 23: 0.64, 25: 0.51, 26: 0.46, 27: 0.41, 28: 0.36, 30: 0.31, 32: 0.23,
    33: 0.21, 34: 0.18,
}  # fmt: skip


@dataclass(frozen=True)
class LeakTest:
    """Leak test of one kind of point and the tubes at it."""

    kind: str
    """Name of the kind of point; empty where all are alike."""
    pressure: float
    """Pressure to apply, Pa."""
    bulge: float
    """Rise of the middle of the membrane at that pressure, mm."""
    linear: bool
    """True if the bulge is that of the linear law, because the law of large deflections does not take the membrane."""
    largest_conductance: float
    """Largest leak of the whole assembly that passes, m^3/(Pa s)."""
    hole: float
    """Diameter of a hole 1 mm long with that conductance, mm."""
    largest_fall: float
    """Largest fall of the height between the two levels of the gauge in the time that it is watched, mm."""
    bubbles: float
    """Bubbles of 1 mm a second that the largest leak makes in soapy water."""
    cell: float
    """Compliance of the membrane and of the air of one point, m^3/Pa."""

    @property
    def water(self) -> float:
        """Height of water that makes the pressure, mm."""
        return 1e3 * self.pressure / _WATER

    @property
    def fall(self) -> str:
        """Largest fall, mm, in words."""
        return _in_words(self.largest_fall)

    def fall_of(self, points: int) -> str:
        """Largest fall, mm, in words, if the largest leak empties a piece of several points, which falls more slowly.

        Args:
            points: number of points of the piece.
        """
        return _in_words(_fall(self.pressure, self.largest_conductance, points * self.cell))


def needle_words(bore: float) -> str:
    """Blunt needle that joins the hose to a bore (mm)."""
    fitting = {gauge: outside for gauge, outside in _NEEDLES.items() if outside <= bore - 0.02}
    if not fitting:
        return f"a glass capillary thinner than {bore:g} mm"
    gauge, outside = max(fitting.items(), key=lambda each: each[1])
    return f"a blunt needle of gauge {gauge} ({outside:g} mm outside)"


def leak_tests(design: ArrayDesign) -> tuple[LeakTest, ...]:
    """Leak test of each kind of point of a design."""
    return tuple(_test_of(design.of_kind(kind), kind) for kind in design.kinds)


def _test_of(design: ArrayDesign, kind: str) -> LeakTest:
    air = design_air(design)
    membrane = float(np.real(design_disc(design).compliance(LARGEST_CORNER)))
    radius = metres(design.resonator.cavity_diameter) / 2
    # Slow changes are isothermal.
    cell = membrane + cubic_metres(design.resonator.cavity_volume) / air.pressure
    pressure, rise, linear = _bulge(design, membrane, radius)
    largest = 2 * math.pi * LARGEST_CORNER * cell
    fall, volume = _fall(pressure, largest, cell), math.pi / 6 * _BUBBLE**3
    bubbles, hole = largest * pressure / volume, 1e3 * _hole(largest, design)
    return LeakTest(kind, pressure, 1e3 * rise, linear, largest, hole, fall, bubbles, cell)


def _fall(pressure: float, conductance: float, compliance: float) -> float:
    """Fall of the gauge while it is watched, mm, with a leak (m^3/(Pa s)) and a compliance (m^3/Pa) beside it."""
    gauge = math.pi / 4 * GAUGE_BORE**2 / _WATER / 2
    return 1e3 * pressure / _WATER * -math.expm1(-WATCHED * conductance / (gauge + compliance))


def _in_words(fall: float) -> str:
    return f"{fall:.0f}" if fall >= 10 else f"{fall:.2g}"


def _bulge(design: ArrayDesign, compliance: float, radius: float) -> tuple[float, float, bool]:
    """Test pressure, Pa, rise of the middle of the membrane, m, and whether it is that of the linear law."""
    try:
        mounted = design_membrane(design)
    except Refusal:
        mounted = None
    # A clamped plate bulges as (1 - r^2/a^2)^2, of which the volume is pi a^2 / 3 times the middle.
    pressure, rise, linear = _PRESSURES[-1], 0.0, True
    for pressure in _PRESSURES:
        rise, linear = 3 * compliance * pressure / (math.pi * radius**2), True
        if mounted is not None:
            try:
                rise, linear = -float(bulge(mounted, pressure).deepest), False
            except Refusal:
                continue
        if rise <= _LARGEST_BULGE * radius:
            break
    return pressure, rise, linear


def _hole(conductance: float, design: ArrayDesign) -> float:
    """Diameter of a hole of the stated length with a conductance, m, by halving."""
    low, high = 1e-7, metres(design.resonator.cavity_diameter)
    air = design_air(design)
    while high / low > 1.001:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if leak_conductance(middle / 2, _HOLE_LENGTH, air) > conductance else (middle, high)
    return low
