"""The rig on which a tube is bent: what is built, apart from how it is solved."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias, get_args

from geometry.air.wound_tube import Winding, closest_pitch
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.refusal import Kind, Refusal, counted

End: TypeAlias = Literal["microphone", "closed"]

#: Up to this angle an arc can lie flat; beyond, the straight ends or the turns would meet.
LARGEST_FLAT_ANGLE = 180.0
LARGEST_ANGLE = 3600.0
MOST_ANGLES = 12


@dataclass(frozen=True)
class BendingRig:
    """Rig with a tube that is wound on a cylinder. Lengths are in mm. Defaults are those of the publication; its outer
    diameter is assumed.

    Up to 180 degrees the arc lies in a plane. Beyond, it is a helix whose turns touch.
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
        check_range("bore", self.bore, 0.05, 5.0, "mm")
        check_range("diameter", self.diameter, 0.1, 1000.0, "mm")
        if not self.bore < self.diameter:
            raise _conflict("bore", self.bore, f"below the diameter of the cylinder, {self.diameter:g} mm")
        if not self.bore < self.outside < self.diameter:
            between = f"above the bore, {self.bore:g} mm, and below the diameter of the cylinder, {self.diameter:g} mm"
            raise _conflict("outside", self.outside, between)
        if not 1 <= len(self.angles) <= MOST_ANGLES:
            problem = f"has {counted(len(self.angles), 'value')}; it must have 1 to {MOST_ANGLES}"
            raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="angles")
        for angle in self.angles:
            check_range("angles", angle, 0.0, LARGEST_ANGLE, "degrees")
        if len(set(self.angles)) < len(self.angles):
            raise Refusal(kind=Kind.CONFLICT, field="angles", value=self.angles, allowed="different from each other")
        check_range("length", self.length, 1.0, 10000.0, "mm")
        angle = max(self.angles)
        arc = self.winding(angle).arc_length
        if self.length < arc:
            raise _conflict("length", self.length, f"at least the arc of {angle:g} degrees, {arc:.4g} mm")
        check_choice("end", self.end, get_args(End))

    def winding(self, angle: float) -> Winding:
        """Centre line of the part that is wound by an angle, degrees."""
        flat = angle <= LARGEST_FLAT_ANGLE
        return Winding(self.diameter, angle, 0.0 if flat else closest_pitch(self.diameter, self.outside))


def _conflict(field: str, value: float, allowed: str) -> Refusal:
    return Refusal(kind=Kind.CONFLICT, field=field, value=value, unit="mm", allowed=allowed)
