"""Kinds of points and tubes that a design names, and the pattern in which a line has them."""

from __future__ import annotations

from pydantic import Field

from geometry.schema.field_errors import Flag, Millimetre, Number, Section
from geometry.schema.part_fields import Membrane, Resonator

#: Name of what :class:`geometry.schema.array_fields.StatedArray` states for all points, where a line has no pattern.
PLAIN = ""


class PointKind(Section):
    """A kind of sensing point: how its shell and its membrane differ from those that the design states.

    Shells of all kinds stand on one floor and have their ports at one height, that of the stated resonator: tubes lie
    level, and the membranes of higher cavities lie higher.
    """

    cavity_height: Millimetre | None = Field(
        default=None,
        ge=0.4,
        le=50,
        description="height from the floor of the cavity to the membrane; default: that of the resonator",
    )
    membrane_thickness: Millimetre | None = Field(
        default=None, ge=0.05, le=10, description="thickness of the disc as cast; default: that of the membrane"
    )
    leak_diameter: Number | None = Field(
        default=None,
        ge=0,
        le=0.1,
        description="diameter of a leak to the outside, such as a sensor's only vent; default: that of the resonator",
        json_schema_extra={"unit": "mm"},
    )

    def resonator(self, stated: Resonator) -> Resonator:
        """The shell of this kind, made from the stated one."""
        own: dict[str, float] = {}
        if self.leak_diameter is not None and self.leak_diameter != stated.leak_diameter:
            own["leak_diameter"] = self.leak_diameter
        if self.cavity_height is not None and self.cavity_height != stated.cavity_height:
            own |= {"cavity_height": self.cavity_height, "port_height": stated.port_axis_height}
        return stated.model_copy(update=own) if own else stated

    def membrane(self, stated: Membrane) -> Membrane:
        """The membrane of this kind, made from the stated one."""
        if self.membrane_thickness is None or self.membrane_thickness == stated.thickness:
            return stated
        return stated.model_copy(update={"thickness": self.membrane_thickness})


class Pattern(Section):
    """Kind of point or tube at each place of a line."""

    points: tuple[str, ...] | None = Field(
        default=None,
        description="name of a kind for each point, in the order of the line; default: none, so all are as the design "
        "states",
    )
    tubes: tuple[str, ...] | None = Field(
        default=None,
        description="name of a kind for each tube between its points; default: none, so all are as the design states",
    )
    mirrored: Flag = Field(
        default=False, description="both lists end in the middle of the line, and its second half is the mirror image"
    )

    def entries(self, count: int) -> int:
        """Number of names that a list for so many places must have."""
        return (count + 1) // 2 if self.mirrored else count

    def index(self, place: int, count: int) -> int:
        """Index of the name of a place, from 0, of so many."""
        return min(place, count - 1 - place) if self.mirrored else place
