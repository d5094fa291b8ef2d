"""The rig on which a tube is bent: what is built, apart from how it is solved."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias, get_args

from acoustic_fem.quantities.checks import in_range
from geometry.air.wound_tube import Winding, closest_pitch
from geometry.ground.refusal import Refusal, counted

End: TypeAlias = Literal["microphone", "closed"]

#: Up to this angle an arc can lie flat; beyond, the straight ends or the turns would meet.
LARGEST_FLAT_ANGLE = 180.0
LARGEST_ANGLE = 3600.0
MOST_ANGLES = 12


@dataclass(frozen=True)
class BendingRig:
    """Rig of a tube wound on a cylinder; lengths in mm, defaults as published, the outside diameter assumed.

    Up to 180 degrees the arc lies flat, beyond it is a helix whose turns touch.
    """

    bore: float = 0.5
    """Inner diameter of the tube, mm."""
    length: float = 120.0
    """Length of the tube along its centre line, mm."""
    diameter: float = 11.6
    """Diameter of the cylinder on which the centre line lies, mm, the tightest reading of the publication."""
    outside: float = 0.9
    """Outer diameter of the tube, mm, which sets the pitch of the helix."""
    angles: tuple[float, ...] = (0.0, 90.0, 180.0, 270.0, 360.0)
    """Angles over which the tube is wound, degrees, each a case."""
    end: End = "microphone"
    """Closure of the far end: the microphone of the prototype array-2x6 in its chamber, or nothing."""

    def __post_init__(self) -> None:
        in_range("bore", self.bore, 0.05, 5.0, "mm")
        in_range("diameter", self.diameter, 0.1, 1000.0, "mm")
        if not self.bore < self.diameter:
            raise Refusal(f"bore = {self.bore:g} mm must be below diameter, the cylinder's {self.diameter:g} mm")
        if not self.bore < self.outside < self.diameter:
            raise Refusal(
                f"outside = {self.outside:g} mm must be above bore ({self.bore:g} mm) and below diameter "
                f"({self.diameter:g} mm)"
            )
        if not 1 <= len(self.angles) <= MOST_ANGLES:
            raise Refusal(f"angles holds {counted(len(self.angles), 'value')}; it must hold 1 to {MOST_ANGLES}")
        for angle in self.angles:
            in_range("angles", angle, 0.0, LARGEST_ANGLE, "degrees")
        if len(set(self.angles)) < len(self.angles):
            raise Refusal(f"angles = {', '.join(f'{angle:g}' for angle in self.angles)} must differ")
        in_range("length", self.length, 1.0, 10000.0, "mm")
        angle = max(self.angles)
        arc = self.winding(angle).arc_length
        if self.length < arc:
            raise Refusal(f"length = {self.length:g} mm must be at least the arc of {angle:g} degrees, {arc:.4g} mm")
        if self.end not in get_args(End):
            raise Refusal(f"end = {self.end!r} must be one of {', '.join(get_args(End))}")

    def winding(self, angle: float) -> Winding:
        """Centre line of the part that is wound by an angle, degrees."""
        flat = angle <= LARGEST_FLAT_ANGLE
        return Winding(self.diameter, angle, 0.0 if flat else closest_pitch(self.diameter, self.outside))
