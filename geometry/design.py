"""The design of an array: fields, units, limits.

Lengths are millimetres, moduli megapascals, frequencies hertz. A design is immutable; changed copies
come from :meth:`ArrayDesign.with_values`. Every section refuses unknown keys and non-finite numbers
with a :class:`geometry.DesignError` of one line. Reading and writing live in
:mod:`geometry.design_file`, the rules between fields in :mod:`geometry.design_rules`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from geometry.cavity_shapes import USUAL_BOX, Box, Dome
from geometry.design_fields import Count, Number, Section
from geometry.design_rules import SOCKET_COVER, check_consistency
from geometry.materials import MATERIALS, Material
from geometry.topology import check_topology

#: Ducts are cut this many bore radii away from a cavity: the stub belongs to the 3-D cell, so that the
#: entrance flow has decayed to a plane wave where the port is (its slowest mode decays as exp(-5 z/a)).
STUB_LENGTH_IN_RADII = 4.0

#: Width on which the board of a microphone is glued, or bears on either side of a gasket, mm.
BOARD_SEAL = 0.6
#: Width of the slot for the wires per width of the seat.
SEAT_SLOT = 0.6

Millimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm"})]
CubicMillimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm^3"})]
Ratio = Annotated[Number, Field(gt=0)]
MicrophoneName = Annotated[str, Field(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")]


class Resonator(Section):
    """Printed shell of one sensing point: an air cavity, open at the top."""

    cavity_diameter: Millimetre = Field(ge=0.8, le=50, description="diameter of the air cavity")
    cavity_height: Millimetre = Field(ge=0.4, le=50, description="floor of the cavity to the membrane")
    wall_thickness: Millimetre = Field(ge=0.3, le=20, description="radial thickness of the shell")
    floor_thickness: Millimetre = Field(default=1.0, ge=0.3, le=20, description="thickness of the floor")
    port_height: Millimetre | None = Field(
        default=None, description="axis of the tube ports above the floor of the cavity; default: mid height"
    )
    shape: Literal["cylinder", "box", "dome"] = Field(
        default="cylinder",
        description="cylinder; box: inside the circle of the membrane, under a round collar; dome: the floor is a bowl",
    )
    box_length: Millimetre | None = Field(
        default=None, le=50, description="side of a box along a tube (see above); default: its width, or a square"
    )
    box_width: Millimetre | None = Field(default=None, le=50, description="other side of a box; default: its length")
    corner_radius: Millimetre | None = Field(
        default=None, ge=0.05, le=20, description="upright edges of a box; default: 0.1 cavity diameters"
    )
    collar_height: Millimetre | None = Field(
        default=None, ge=0.1, le=20, description="round collar between a box and the membrane; default: 0.2 heights"
    )
    dome_depth: Millimetre | None = Field(
        default=None,
        ge=0.05,
        le=25,
        description="depth of the bowl of a dome; default: a third of the height, at most a quarter of the diameter",
    )

    @property
    def cavity_shape(self) -> Box | Dome | None:
        """What makes the cavity differ from a cylinder; None for a cylinder."""
        diameter, height = self.cavity_diameter, self.cavity_height
        if self.shape == "dome":
            return Dome(self.dome_depth or min(diameter / 4, height / 3))
        if self.shape == "box":
            corner = self.corner_radius or 0.1 * diameter
            usual = math.sqrt(2) * (USUAL_BOX * diameter / 2 - corner) + 2 * corner
            length = self.box_length or self.box_width or usual
            return Box(length, self.box_width or length, corner, self.collar_height or 0.2 * height)
        return None

    @property
    def port_axis_height(self) -> float:
        """Height of the tube axis above the cavity floor, mm."""
        return self.cavity_height / 2 if self.port_height is None else self.port_height

    def port_problem(self, height: float, bore_diameter: float) -> str:
        """Why the wall of a box or a dome has no place for a bore at that height; empty where it has.

        Bores lie below the collar of a box, and where the wall of a bowl is steep or above the bowl.
        """
        shape, bore = self.cavity_shape, bore_diameter / 2
        if isinstance(shape, Box):
            highest = self.cavity_height - shape.collar_height - bore - SOCKET_COVER
            if height > highest + 1e-9:
                return f"lies at {height:g} mm; it must lie at most at {highest:.4g} mm, below resonator.collar_height"
            if bore_diameter > min(shape.length, shape.width) / 2 + 1e-9:
                return (
                    f"has a bore of {bore_diameter:g} mm; it must be at most half of the box's side "
                    f"({min(shape.length, shape.width):.4g} mm)"
                )
        if isinstance(shape, Dome) and height - bore < shape.depth - 1e-9:
            lowest = shape.lowest_port(self.cavity_diameter / 2)
            if height < lowest:
                return (
                    f"lies at {height:g} mm on the flat part of the bowl; it must lie at least at "
                    f"{min(lowest, shape.depth + bore):.4g} mm"
                )
        return ""

    @property
    def outer_diameter(self) -> float:
        """Outside diameter of the shell, mm."""
        return self.cavity_diameter + 2 * self.wall_thickness

    @property
    def cavity_volume(self) -> float:
        """Volume of the air cavity, mm^3."""
        shape = self.cavity_shape
        if shape is not None:
            return shape.volume(self.cavity_diameter / 2, self.cavity_height)
        return math.pi / 4 * self.cavity_diameter**2 * self.cavity_height


class Shell(Section):
    """What helps to glue, mount and tell apart the printed shells; the air is the same with and without."""

    groove_width: Millimetre | None = Field(
        default=None, ge=0.2, le=5, description="width of a groove for glue in the seat of the membrane; default: none"
    )
    groove_depth: Millimetre = Field(default=0.2, ge=0.05, le=2, description="depth of that groove")
    feet: Count = Field(default=0, ge=0, le=4, description="number of mounting feet between the tubes")
    foot_length: Millimetre = Field(default=4.0, ge=1, le=20, description="wall of the shell to the end of a foot")
    foot_hole: Millimetre = Field(default=2.2, ge=0.3, le=10, description="screw hole in a foot")
    label: Literal["none", "raised", "engraved"] = Field(
        default="none", description="number of the point on the wall, in digits of straight strokes"
    )
    label_height: Millimetre | None = Field(
        default=None, ge=0.5, le=20, description="height of the digits; default: 0.8 of the wall's height, at most 3 mm"
    )
    label_relief: Millimetre = Field(default=0.2, ge=0.05, le=1, description="how far they stand out or are cut in")


class Membrane(Section):
    """Silicone disc held on the rim of the shell."""

    material: str = Field(description="name of a silicone: built in, or defined under [materials.NAME]")
    thickness: Millimetre = Field(ge=0.05, le=10, description="thickness of the disc as cast")
    rim_width: Millimetre = Field(ge=0.2, le=20, description="width of the glued annulus around the cavity")
    mounting: Literal["rim", "clamped"] = Field(
        default="rim",
        description="rim: glued by its lower face; clamped: the rim cannot move, so the disc ends at the cavity's wall",
    )
    stretch: Number = Field(
        default=1.0, ge=1, le=1.9, description="lengths in the plane of the mounted disc per those as cast"
    )
    shape: Literal["flat", "rim", "boss"] = Field(
        default="flat",
        description="flat: a disc; rim: thicker on the rim, outside the cavity; boss: with a button to be touched",
    )
    rim_height: Millimetre | None = Field(
        default=None, ge=0.05, le=10, description="height of the rim above the disc; for shape = 'rim' only"
    )
    boss_diameter: Millimetre | None = Field(
        default=None,
        ge=0.2,
        le=40,
        description="diameter of the button where it meets the disc; for shape = 'boss' only",
    )
    boss_height: Millimetre | None = Field(
        default=None, ge=0.05, le=10, description="height of the button above the disc; for shape = 'boss' only"
    )

    @property
    def mounted_thickness(self) -> float:
        """Thickness of the disc after it was stretched, at constant volume, mm."""
        return self.thickness / self.stretch**2

    @property
    def total_height(self) -> float:
        """Height as cast with the rim or the boss, mm."""
        return self.thickness + (self.rim_height or self.boss_height or 0.0)


class Tube(Section):
    """Micro-tube: a close-wound coil spring inside a sheath.

    A file may give ``spring_outer_diameter`` instead of ``inner_diameter`` (bore = spring outer diameter
    - 2 x wire) and ``sheath_wall`` instead of ``outer_diameter``.
    """

    length: Millimetre = Field(ge=0.5, le=1000, description="bore from cavity wall to cavity wall")
    inner_diameter: Millimetre = Field(ge=0.05, le=5, description="bore")
    outer_diameter: Millimetre = Field(ge=0.1, le=8, description="outside of the sheath")
    wire_diameter: Millimetre = Field(ge=0.01, le=1, description="wire of the coil spring")
    bend_radius: Millimetre | None = Field(
        default=None, le=1000, description="smallest radius of its axis; default: from spring and sheath"
    )

    @model_validator(mode="before")
    @classmethod
    def _from_spring_and_sheath(cls, data: Any) -> Any:
        if not isinstance(data, Mapping):
            return data
        data = dict(data)
        wire = data.get("wire_diameter")
        for given, derived in (("spring_outer_diameter", "inner_diameter"), ("sheath_wall", "outer_diameter")):
            if given not in data:
                continue
            value = data.pop(given)
            if derived in data:
                raise ValueError(f"{given} = {value!r} must not be given beside {derived}; give one of the two")
            if not _is_positive(value):
                raise ValueError(f"{given} = {value!r} must be a number above 0 mm")
            if not _is_positive(wire):
                continue  # said of wire_diameter itself
            if given == "spring_outer_diameter":
                if value <= 2 * wire:
                    raise ValueError(f"{given} = {value:g} mm must be above 2 x wire_diameter ({2 * wire:g} mm)")
                data[derived] = round(value - 2 * wire, 9)
            elif _is_positive(data.get("inner_diameter")):
                data[derived] = round(data["inner_diameter"] + 2 * wire + 2 * value, 9)
        return data

    @property
    def spring_outer_diameter(self) -> float:
        """Outside diameter of the coil spring, mm."""
        return self.inner_diameter + 2 * self.wire_diameter

    @property
    def smallest_bend_radius(self) -> float:
        """Smallest radius to which its axis may be bent, mm.

        By default the larger of two assumed limits. The spring's turns touch on the inside of a bend and gape on
        the outside, there by wire x D / (R - D / 2) with the spring's outside D: at R = 1.5 D by one wire, where
        the sheath begins to sink in. A sleeve of plastic kinks where R is below its own outside diameter.
        """
        return self.bend_radius or max(1.5 * self.spring_outer_diameter, self.outer_diameter)

    @property
    def sheath_wall(self) -> float:
        """Wall of the sheath around the coil spring, mm."""
        return (self.outer_diameter - self.spring_outer_diameter) / 2

    @property
    def stub_length(self) -> float:
        """Length of the stub that belongs to a cell, mm."""
        return STUB_LENGTH_IN_RADII * self.inner_diameter / 2


class Microphone(Section):
    """MEMS microphone on the ceiling of a cylindrical chamber; it joins the ends of one or more lines."""

    model: str = Field(default="SPH1878LR5H-C", description="part number")
    chamber_diameter: Millimetre = Field(ge=0.5, le=20, description="diameter of the chamber")
    chamber_height: Millimetre = Field(ge=0.3, le=20, description="height of the chamber")
    wall_thickness: Millimetre = Field(default=1.0, ge=0.3, le=20, description="thickness of the housing")
    sound_hole_diameter: Millimetre = Field(default=0.5, ge=0.1, le=5, description="acoustic port of the package")
    sound_hole_length: Millimetre = Field(default=0.3, ge=0.05, le=5, description="depth of the acoustic port")
    diaphragm_equivalent_volume: Number = Field(
        default=0.05,
        gt=0,
        le=1000,
        description="air volume as compliant (adiabatic) as the diaphragm",
        json_schema_extra={"unit": "mm^3"},
    )
    back_volume: Number = Field(
        default=2.0,
        gt=0,
        le=1000,
        description="air behind the diaphragm, closed but for the vent",
        json_schema_extra={"unit": "mm^3"},
    )
    vent_corner: Number = Field(
        default=20.0,
        gt=0,
        le=1000,
        description="high-pass corner made by the vent in the diaphragm",
        json_schema_extra={"unit": "Hz"},
    )
    sensitivity: Number = Field(
        default=-38.0,
        ge=-80,
        le=0,
        description="output at 94 dB SPL, 1 kHz",
        json_schema_extra={"unit": "dB re 1 V/Pa"},
    )
    noise_density: Number = Field(
        default=5e-6,
        gt=0,
        le=1,
        description="white equivalent input noise",
        json_schema_extra={"unit": "Pa/sqrt(Hz)"},
    )
    noise_corner: Number = Field(
        default=100.0,
        ge=0,
        le=1e4,
        description="below it the noise power rises as 1/f",
        json_schema_extra={"unit": "Hz"},
    )
    package_length: Millimetre = Field(default=3.5, ge=0.5, le=20, description="length of the package; assumed")
    package_width: Millimetre = Field(default=2.65, ge=0.5, le=20, description="width of the package; assumed")
    package_height: Millimetre = Field(default=0.98, ge=0.2, le=10, description="height of the package; assumed")
    board_length: Millimetre | None = Field(
        default=None,
        ge=1,
        le=40,
        description="length of the board that closes the chamber; default: covers package, chamber and gasket",
    )
    board_width: Millimetre | None = Field(
        default=None, ge=1, le=40, description="width of the board; default: covers package, chamber and gasket"
    )
    board_gap: Millimetre = Field(default=0.1, ge=0.02, le=1, description="gap around the board in its seat; assumed")
    gasket_width: Millimetre | None = Field(
        default=None,
        ge=0.3,
        le=5,
        description="width of a groove for a seal under the board; default: none, the board is glued",
    )
    gasket_depth: Millimetre = Field(default=0.2, ge=0.1, le=5, description="depth of that groove")
    source: str = Field(default="assumed", description="where the figures come from")

    @property
    def chamber_volume(self) -> float:
        """Volume of the chamber without the sound hole, mm^3."""
        return math.pi / 4 * self.chamber_diameter**2 * self.chamber_height

    @property
    def least_board_length(self) -> float:
        """Shortest board that covers the package, the chamber and the gasket, mm."""
        return self._board_size(self.package_length)

    @property
    def least_board_width(self) -> float:
        """Narrowest board that covers the package, the chamber and the gasket, mm."""
        return self._board_size(self.package_width)

    @property
    def board_size(self) -> tuple[float, float]:
        """Length and width of the board, mm; by default 0.5 mm around the package."""
        return (
            self.board_length or max(self.least_board_length, self.package_length + 1.0),
            self.board_width or max(self.least_board_width, self.package_width + 1.0),
        )

    def _board_size(self, package: float) -> float:
        sealed = self.chamber_diameter + 2 * BOARD_SEAL
        if self.gasket_width is not None:
            sealed += 2 * (self.gasket_width + BOARD_SEAL)
        return max(package, sealed)


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
        default="none", description="all shells in one piece besides: joined in a row or a sheet by snap-off necks"
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


def _is_positive(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and 0 < value < math.inf
