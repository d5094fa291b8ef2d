"""What a design file states of the whole array, and the lengths that follow, before any rule between its fields."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from geometry.stated.fields import Count, Millimetre, Number, Section
from geometry.stated.making import Molding, Printing
from geometry.stated.materials import MATERIALS, Material
from geometry.stated.parts import Membrane, Microphone, Resonator, Shell, Tube

MicrophoneName = Annotated[str, Field(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")]


class Line(Section):
    """Resonators in series between two microphones; points are numbered from the first of them."""

    between: tuple[str, str] = Field(description="names of the two microphones at its ends")
    points: Count = Field(ge=1, le=1000, description="number of sensing points")
    tube: Tube | None = Field(default=None, description="tube between its points, where it differs")
    microphone_tube: Tube | None = Field(default=None, description="tube to its microphones, where it differs")


class Layout(Section):
    """Where the resonators lie."""

    kind: Literal["serpentine", "ring", "cylinder", "hand"] = Field(
        description="serpentine: rows of `columns` points, one block per line; ring: lines are the sides of a "
        "polygon, microphones its corners; cylinder: a serpentine wound on a cylinder, rows around it; hand: "
        "fingers of `columns` points that fan out from the wrist"
    )
    columns: Count = Field(default=1000, ge=1, le=1000, description="points per row of a serpentine, or per finger")
    pitch: Millimetre | None = Field(default=None, description="distance of neighbours; default: tubes lie straight")
    diameter: Millimetre | None = Field(
        default=None, ge=2, le=2000, description="cylinder on which the shells stand; for kind = 'cylinder' only"
    )
    palm: Millimetre | None = Field(
        default=None, ge=5, le=300, description="wrist to the first point of each finger; for kind = 'hand' only"
    )
    spread: Number | None = Field(
        default=None,
        ge=1,
        le=60,
        description="angle between neighbouring fingers; for kind = 'hand' only",
        json_schema_extra={"unit": "degrees"},
    )


class Air(Section):
    """State of the air in the array."""

    temperature: Number = Field(
        default=20.0, ge=-20, le=60, description="temperature", json_schema_extra={"unit": "degC"}
    )
    humidity: Number = Field(default=0.5, ge=0, le=1, description="relative humidity, 0 to 1")
    pressure: Number = Field(
        default=101325.0, ge=5e4, le=1.2e5, description="static pressure", json_schema_extra={"unit": "Pa"}
    )


class StatedArray(Section):
    """Everything one array is made of, each field allowed in itself; whether they go together is not yet checked.

    The fields are documented by ``acoustic-fem check --fields`` and in docs/design-file.md.
    """

    name: str = Field(
        min_length=1,
        max_length=80,
        pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$",
        description="name of the array, also in file names",
    )
    description: str = Field(default="", description="what it is, for people")
    microphones: tuple[MicrophoneName, ...] = Field(min_length=2, max_length=16, description="names of the microphones")
    resonator: Resonator = Field(description="printed shell of a sensing point")
    shell: Shell = Field(default=Shell(), description="what else is printed on the shells")
    membrane: Membrane = Field(description="silicone disc on each shell")
    tube: Tube = Field(description="tube between neighbouring points")
    microphone_tube: Tube = Field(
        default_factory=lambda stated: stated.get("tube"), description="tube from the end of a line to its microphone"
    )
    microphone: Microphone = Field(description="the microphones, all alike")
    lines: tuple[Line, ...] = Field(min_length=1, description="the lines")
    layout: Layout = Field(description="where the resonators lie")
    air: Air = Field(default=Air(), description="state of the air")
    printing: Printing = Field(default=Printing(), description="how the parts are made")
    mold: Molding = Field(default=Molding(), description="how the membranes are cast")
    materials: dict[str, Material] = Field(default_factory=dict, description="materials beside the built-in ones")

    @property
    def followers(self) -> frozenset[str]:
        """Tables that nobody stated and that are as others are, however these change: the microphone tube's."""
        return frozenset({"microphone_tube"}) - self.model_fields_set

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return sum(line.points for line in self.lines)

    def material(self, name: str) -> Material:
        """The material of that name: the design's own, else the built-in one."""
        return self.materials[name] if name in self.materials else MATERIALS[name]

    def tube_of(self, line: Line) -> Tube:
        """Tube between the points of a line."""
        return line.tube or self.tube

    def microphone_tube_of(self, line: Line) -> Tube:
        """Tube from the ends of a line to its microphones."""
        return line.microphone_tube or self.microphone_tube

    def pitch_of(self, line: Line) -> float:
        """Distance of neighbouring axes on a line, mm."""
        return self.layout.pitch or self.resonator.cavity_diameter + self.tube_of(line).length

    def microphone_reach_of(self, line: Line) -> float:
        """Distance of the axes of a line's last point and its microphone's chamber if the tube is straight, mm."""
        length = self.microphone_tube_of(line).length
        return self.resonator.cavity_diameter / 2 + length + self.microphone.chamber_diameter / 2
