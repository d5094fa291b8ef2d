"""Holes in the floor of a cavity through which a membrane is pushed out, closed by pins while it is cast."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.design.array_design import ArrayDesign

#: Largest and smallest diameter of a pin under the rim, mm: as wide as a hex key, and stiff enough to print.
_LARGEST, _SMALLEST = 1.2, 0.7
#: Share of the rim that a hole may take, and share of the diameter of a membrane that a pin in its middle takes.
_OF_RIM, _OF_MIDDLE = 0.9, 0.25
#: Smallest pin in the middle, mm.
_LEAST = 0.5


@dataclass(frozen=True)
class Ejector:
    """Ejector pins of one cavity, mm."""

    radius: float
    """Radius of a pin."""
    hole: float
    """Radius of its hole."""
    top: float
    """Height of the floor of the cavity there, which is the tip of the pin."""
    spots: tuple[tuple[float, float], ...]
    """Axes of the pins from the axis of the cavity."""

    @property
    def on_rim(self) -> bool:
        """True where the pins lie under the glued rim, which does not vibrate."""
        return len(self.spots) > 1


def ejector_of(design: ArrayDesign, profile: tuple[tuple[float, float], ...]) -> Ejector | None:
    """Two pins under the rim, which is glued and does not vibrate; one in the middle where the rim is too narrow.

    Args:
        design: the array.
        profile: half section of the cavity, corners (radius, height) in mm.

    Returns:
        The pins, or None where a boss has no room for one.
    """
    mold, membrane = design.mold, design.membrane
    # Corners run along the parting plane outwards, then along wall and floor back to the axis.
    floor = [corner for corner in profile if corner[1] < 0][::-1]
    outer = floor[-1][0]
    inner = floor[-2][0] if membrane.shape == "rim" else outer - membrane.rim_width / membrane.stretch * mold.scale
    diameter, at = min(_LARGEST, _OF_RIM * (outer - inner) - 2 * mold.pin_clearance), (outer + inner) / 2
    spots: tuple[tuple[float, float], ...] = ((at, 0.0), (-at, 0.0))
    if diameter < _SMALLEST:
        diameter, at, spots = min(_LARGEST, max(_LEAST, _OF_MIDDLE * 2 * outer)), 0.0, ((0.0, 0.0),)
        if diameter / 2 + mold.pin_clearance > _OF_RIM * floor[1][0]:
            return None
    top = float(np.interp(at, [radius for radius, _ in floor], [height for _, height in floor]))
    return Ejector(diameter / 2, diameter / 2 + mold.pin_clearance, top, spots)
