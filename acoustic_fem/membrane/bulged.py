"""Membranes that a static pressure bulges: the volume under them, and how much stiffer they are for small signals.

Air that is enclosed in a sensor is warmed, or the pressure outside falls: the membranes bulge outwards and stiffen.
Suction draws them in, which softens them at first. The law is that of :func:`acoustic_fem.membrane.bulge`, at finite
strain. It is dimensionless, so one table serves all moduli.

The small signals of a bulged membrane count as those of a flat one whose modulus is divided by the incremental
compliance over that of the flat one. Shapes of modes, and the ratio of volumes per force to volumes per pressure, stay.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator

from acoustic_fem.membrane.half_section import DiscShape
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array

if TYPE_CHECKING:
    from acoustic_fem.membrane.equilibrium import LoadKind
    from acoustic_fem.membrane.press_table import PressTable


@dataclass(frozen=True, eq=False)
class BulgeLaw:
    """Bulge of a flat disc under a static pressure of either sign; pressures by Young's modulus.

    The tables of both signs are solved when they are first needed, in some seconds, and then kept on disk.
    """

    shape: DiscShape
    """The disc, flat and without prestress."""
    floor: float | None = None
    """Depth of the floor below the relaxed lower face by the radius of the opening, a ratio; None without a floor."""

    def volume(self, pressure: ArrayLike) -> Array:
        """Volume swept outwards by the cube of the radius; shape of the pressures, float64.

        Args:
            pressure: in the cavity above that outside, by Young's modulus, ratios of any shape.

        Raises:
            Refusal: a pressure beyond the last equilibrium that was found.
        """
        return self._of_signs(pressure, lambda side: side.volume)

    def compliance_ratio(self, pressure: ArrayLike) -> Array:
        """Volume per small change of the pressure, by that of the flat disc; shape of the pressures, float64.

        Args:
            pressure: in the cavity above that outside, by Young's modulus, ratios of any shape.

        Raises:
            Refusal: a pressure beyond the last equilibrium that was found.
        """
        return self._of_signs(pressure, lambda side: side.ratio)

    def largest(self, outwards: bool) -> float:
        """Largest pressure outwards, or suction, for which there is an equilibrium, by Young's modulus."""
        return (self._outwards if outwards else self._inwards).last

    @cached_property
    def _inwards(self) -> _Side:
        return _Side.of(_solved(self.shape, "suction", self.floor), -1.0)

    @cached_property
    def _outwards(self) -> _Side:
        return _Side.of(_solved(self.shape, "pressure", None), 1.0)

    def _of_signs(self, pressure: ArrayLike, column: Callable[[_Side], Callable[[Array], Array]]) -> Array:
        given = np.asarray(pressure, np.float64)
        flat = np.abs(given).ravel()
        found, inwards = np.empty(flat.shape), (given < 0).ravel()
        for chosen, outwards in ((inwards, False), (~inwards, True)):
            if not chosen.any():
                continue
            side = self._outwards if outwards else self._inwards
            check_range("overpressure", float(flat[chosen].max()), high=side.last, why=f"of the modulus, as {side.end}")
            found[chosen] = column(side)(flat[chosen])
        return found.reshape(given.shape)


@dataclass(frozen=True, eq=False)
class _Side:
    """Bulge of one sign, by the size of the pressure."""

    volume: Callable[[Array], Array]
    ratio: Callable[[Array], Array]
    last: float
    end: str

    @classmethod
    def of(cls, table: PressTable, sign: float) -> _Side:
        load = np.concatenate([[0.0], table.rows["load"]])
        slope = np.abs(table.rows["volume_slope"])
        slope = np.concatenate([slope[:1], slope])
        volume = sign * np.concatenate([[0.0], np.abs(table.rows["volume"])])
        ratio = PchipInterpolator(load, slope / slope[0])
        return cls(CubicHermiteSpline(load, volume, sign * slope), ratio, float(load[-1]), table.end)


def _solved(shape: DiscShape, load: LoadKind, floor: float | None) -> PressTable:
    # Here, because flat membranes, which every command has, need no finite elements.
    from acoustic_fem.membrane.equilibrium import Setup
    from acoustic_fem.membrane.press_table import solved_press

    return solved_press(shape, Setup(load, floor=floor))


@lru_cache(maxsize=64)
def bulge_law(shape: DiscShape, floor: float | None) -> BulgeLaw:
    """The law of a disc above a floor, one object for all who ask; arguments as for :class:`BulgeLaw`."""
    return BulgeLaw(shape, floor)
