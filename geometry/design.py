"""The design of an array: its parts, how they are joined, laid out and made.

Lengths are millimetres, moduli megapascals, frequencies hertz. A design is immutable; changed copies
come from :meth:`ArrayDesign.with_values`. Every section refuses unknown keys and non-finite numbers
with a :class:`geometry.DesignError` of one line. The fields of the parts live in
:mod:`geometry.design_parts`, reading and writing in :mod:`geometry.design_file`, the rules between fields in
:mod:`geometry.design_rules`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from geometry.design_fields import Count, Millimetre, Number, Section
from geometry.design_parts import Membrane, Microphone, Resonator, Shell, Tube
from geometry.design_rules import check_consistency
from geometry.materials import MATERIALS, Material
from geometry.topology import check_topology

CubicMillimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm^3"})]
Ratio = Annotated[Number, Field(gt=0)]
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


class PrintRules(Section):
    """Figures of the printing process that differ from the built-in ones; nothing given changes nothing."""

    wall: Millimetre | None = Field(default=None, description="thinnest wall")
    wall_advised: Millimetre | None = Field(default=None, description="thinnest wall without risk")
    hole: Millimetre | None = Field(default=None, description="narrowest round hole")
    hole_advised: Millimetre | None = Field(default=None, description="narrowest round hole without risk")
    slot: Millimetre | None = Field(default=None, description="narrowest gap between walls")
    slot_advised: Millimetre | None = Field(default=None, description="narrowest gap between walls without risk")
    clearance: Millimetre | None = Field(default=None, description="narrowest radial gap between parts that mate")
    clearance_advised: Millimetre | None = Field(default=None, description="the same without risk")
    pin_aspect: Ratio | None = Field(default=None, description="largest height of a pin per its diameter")
    pin_aspect_advised: Ratio | None = Field(default=None, description="the same without risk")
    overhang_angle: Number | None = Field(
        default=None,
        gt=0,
        lt=90,
        description="faces that look down and are flatter than this hang",
        json_schema_extra={"unit": "degrees"},
    )
    overhang_span: Millimetre | None = Field(default=None, description="widest overhang")
    overhang_span_advised: Millimetre | None = Field(default=None, description="widest overhang without support")
    cup_volume: CubicMillimetre | None = Field(default=None, description="largest cup sealed on the resin's film")
    cup_volume_advised: CubicMillimetre | None = Field(default=None, description="the same without risk")
    cast_thickness: Millimetre | None = Field(default=None, description="thinnest cast disc")
    cast_thickness_advised: Millimetre | None = Field(default=None, description="thinnest cast disc without risk")
    pixel: Millimetre | None = Field(default=None, description="width of a pixel, laser spot or nozzle")
    tolerance: Millimetre | None = Field(default=None, description="a printed length is true to plus or minus this")
    build_volume: tuple[Millimetre, Millimetre, Millimetre] | None = Field(
        default=None, description="width, depth and height of the machine, mm"
    )


class Printing(Section):
    """How the shells and molds are printed and joined."""

    process: Literal["sla-resin", "dlp-fine", "fdm", "mjf"] = Field(
        default="sla-resin", description="process of the rules"
    )
    material: str = Field(default="photopolymer-resin", description="material of shells and molds")
    glue_gap: Millimetre = Field(default=0.05, le=1, description="radial gap around a tube in its port")
    port_lip: Millimetre = Field(default=0.3, le=10, description="shoulder on which a tube stops in its port")
    carrier: Literal["none", "row", "sheet"] = Field(
        default="none",
        description="all shells in one piece instead of singly: joined in a row or a sheet by snap-off necks",
    )
    carrier_gap: Millimetre = Field(default=4.0, ge=2, le=50, description="between neighbouring shells of a carrier")
    carrier_neck: Millimetre = Field(default=0.5, ge=0.2, le=3, description="width and height of a snap-off neck")
    rules: PrintRules = Field(default=PrintRules(), description="figures of the process that differ")


class Molding(Section):
    """The mold in which membranes are cast."""

    kind: Literal["two-part", "open-face"] = Field(
        default="two-part", description="two-part: base and lid; open-face: base and a scraper that rides on its lands"
    )
    rows: Count = Field(default=1, ge=1, le=20, description="rows of cavities")
    columns: Count = Field(default=1, ge=1, le=20, description="cavities per row")
    draft: Number = Field(
        default=1.0,
        ge=0,
        le=10,
        description="slope of the walls, membranes included; assumed",
        json_schema_extra={"unit": "degrees"},
    )
    land_width: Millimetre = Field(default=0.6, ge=0.2, le=5, description="width of the land around a cavity; assumed")
    land_height: Millimetre = Field(
        default=0.5, ge=0.2, le=5, description="height of the lands, the gap between the halves elsewhere; assumed"
    )
    groove_width: Millimetre = Field(default=1.2, ge=0.5, le=5, description="width of the overflow groove; assumed")
    vent_diameter: Millimetre = Field(
        default=1.0, ge=0.3, le=5, description="two vents per cavity, through the lid; assumed"
    )
    pin_diameter: Millimetre = Field(default=2.5, ge=1, le=10, description="registration pins; assumed")
    pin_clearance: Millimetre = Field(
        default=0.1,
        ge=0.02,
        le=1,
        description="radial gap of a pin in its socket, gap of the scraper's guides; assumed",
    )
    sockets: Literal["through", "blind"] = Field(
        default="through", description="of the pins in the lid; blind ones cannot be pushed apart from outside"
    )
    shim_step: Millimetre = Field(
        default=0.05, ge=0.01, le=0.5, description="by this the shims raise the lid, one set per step; assumed"
    )
    shim_count: Count = Field(default=2, ge=0, le=10, description="sets of shims for thicker membranes; assumed")
    silicone_shrinkage: Number = Field(
        default=0.001,
        ge=0,
        le=0.1,
        description="linear, on curing; data sheets of platinum-cure silicones: at most 0.001",
    )
    resin_shrinkage: Number = Field(
        default=0.0, ge=0, le=0.1, description="linear, of the printed mold beyond what the printer corrects; assumed"
    )

    @property
    def scale(self) -> float:
        """Lengths of the drawn cavity per those of the membrane."""
        return 1 / ((1 - self.silicone_shrinkage) * (1 - self.resin_shrinkage))


class ArrayDesign(Section):
    """Everything one array is made of.

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
    microphone_tube: Tube = Field(description="tube from the end of a line to its microphone")
    microphone: Microphone = Field(description="the microphones, all alike")
    lines: tuple[Line, ...] = Field(min_length=1, description="the lines")
    layout: Layout = Field(description="where the resonators lie")
    air: Air = Field(default=Air(), description="state of the air")
    printing: Printing = Field(default=Printing(), description="how the parts are made")
    mold: Molding = Field(default=Molding(), description="how the membranes are cast")
    materials: dict[str, Material] = Field(default_factory=dict, description="materials beside the built-in ones")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        check_topology(self.microphones, [(line.between, line.points) for line in self.lines])
        check_consistency(self)
        return self

    # -- derived ------------------------------------------------------------------------------------
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
        """From the axis of a line's last point to the axis of its microphone's chamber if the tube is straight, mm."""
        length = self.microphone_tube_of(line).length
        return self.resonator.cavity_diameter / 2 + length + self.microphone.chamber_diameter / 2

    # -- changed copies -----------------------------------------------------------------------------
    def with_values(self, values: Mapping[str, Any]) -> ArrayDesign:
        """A copy with fields changed by dotted name, checked again as a whole.

        Args:
            values: for example ``{"tube.inner_diameter": 0.5, "lines.0.points": 6}``.

        Raises:
            DesignError: no such field, or the changed design is not valid.
        """
        from geometry.design_file import changed_design

        return changed_design(self, values)

    def completed(self) -> ArrayDesign:
        """The same design with the built-in materials it uses written out, so that it stands alone."""
        used = {self.membrane.material, self.printing.material}
        return self.model_copy(
            update={"materials": {**{name: self.material(name) for name in sorted(used)}, **self.materials}}
        )
