"""The parts of an array as a design states them: fields, units, limits, and what follows from them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Literal

from pydantic import Field, model_validator

from geometry.ground.refusal import Kind, Refusal
from geometry.schema.cavity_shapes import USUAL_BOX, Box, Dome
from geometry.schema.field_errors import Count, CubicMillimetre, Hertz, Millimetre, Number, Section, conflict

#: Ducts are cut this many bore radii away from a cavity: the stub belongs to the 3-D cell, so that the
#: entrance flow has decayed to a plane wave where the port is (its slowest mode decays as exp(-5 z/a)).
STUB_LENGTH_IN_RADII = 4.0

#: Where a tube opens into a cavity it resists like this many bore radii more of it: 1.5 mu / a^3
#: (:mod:`acoustic_fem.duct.tube_opening`) by 8 mu / (pi a^4).
OPENING_LENGTH_IN_RADII = 3 * math.pi / 16

#: Width on which the board of a microphone is glued, or bears on either side of a gasket, mm.
BOARD_SEAL = 0.6
#: Width of the slot for the wires per width of the seat.
SEAT_SLOT = 0.6


class Resonator(Section):
    """Printed shell of one sensing point: an air cavity, open at the top."""

    cavity_diameter: Millimetre = Field(ge=0.8, le=50, description="diameter of the air cavity")
    cavity_height: Millimetre = Field(ge=0.4, le=50, description="height from the floor of the cavity to the membrane")
    wall_thickness: Millimetre = Field(ge=0.3, le=20, description="radial thickness of the shell")
    floor_thickness: Millimetre = Field(default=1.0, ge=0.3, le=20, description="thickness of the floor")
    floor_material: str | None = Field(
        default=None, description="material of a floor that is not rigid; default: the floor is rigid"
    )
    port_height: Millimetre | None = Field(
        default=None,
        description="height of the axis of the tube ports above the floor of the cavity; default: mid height",
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
    leak_diameter: Number = Field(
        default=0.0,
        ge=0,
        le=0.1,
        description="diameter of a leak from the cavity to the outside; 0 for none",
        json_schema_extra={"unit": "mm"},
    )
    leak_length: Millimetre = Field(default=1.0, ge=0.1, le=5, description="length of that leak")

    @property
    def cavity_shape(self) -> Box | Dome | None:
        """Shape of the cavity; None for a cylinder."""
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

    def port_problem(self, height: float, bore_diameter: float) -> Refusal | None:
        """Why the wall of a box or a dome has no place for a bore at that height, both in mm; None where it has.

        Its field is ``height`` or ``bore_diameter``. Bores lie below the collar of a box, and where the wall of a bowl
        is steep or above the bowl.
        """
        shape, bore = self.cavity_shape, bore_diameter / 2
        if isinstance(shape, Box):
            highest = self.cavity_height - shape.collar_height - bore - SOCKET_COVER
            if height > highest + 1e-9:
                return conflict("height", height, f"at most {highest:.4g} mm, below resonator.collar_height")
            side = min(shape.length, shape.width)
            if bore_diameter > side / 2 + 1e-9:
                return conflict("bore_diameter", bore_diameter, f"at most half of the box's side ({side:.4g} mm)")
        if isinstance(shape, Dome) and height - bore < shape.depth - 1e-9:
            lowest = shape.lowest_port(self.cavity_diameter / 2)
            if height < lowest:
                least = min(lowest, shape.depth + bore)
                return conflict("height", height, f"at least {least:.4g} mm, above the flat part of the bowl")
        return None

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
    """Features that help to glue, mount and tell apart the printed shells; the air is the same with and without."""

    groove_width: Millimetre | None = Field(
        default=None, ge=0.2, le=5, description="width of a groove for glue in the seat of the membrane; default: none"
    )
    groove_depth: Millimetre = Field(default=0.2, ge=0.05, le=2, description="depth of that groove")
    feet: Count = Field(default=0, ge=0, le=4, description="number of mounting feet between the tubes")
    foot_length: Millimetre = Field(
        default=4.0, ge=1, le=20, description="length from the wall of the shell to the end of a foot"
    )
    foot_hole: Millimetre = Field(default=2.2, ge=0.3, le=10, description="diameter of the screw hole in a foot")
    label: Literal["none", "raised", "engraved"] = Field(
        default="none", description="numbers of the points on the walls: none, raised or engraved"
    )
    label_height: Millimetre | None = Field(
        default=None,
        ge=0.5,
        le=20,
        description="height of the digits; default: 0.8 of the wall above the floor, at most 3 mm",
    )
    label_relief: Millimetre = Field(default=0.2, ge=0.05, le=1, description="height or depth of the digits")


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
        default=1.0,
        ge=1,
        le=1.9,
        description="lengths in the plane of the mounted disc divided by those of the cast disc",
    )
    prestrain: Number = Field(
        default=0.0,
        ge=-0.02,
        le=0.05,
        description="small strain in the plane of the mounted disc, such as from shrinkage as it cures; negative: "
        "pressed together",
    )
    gluing_temperature: Number | None = Field(
        default=None,
        ge=-20,
        le=150,
        description="temperature at which the disc was glued without stress; default: that of the air, always",
        json_schema_extra={"unit": "degC"},
    )
    expansion_mismatch: Number = Field(
        default=220.0,
        ge=0,
        le=1000,
        description="linear thermal expansion of the disc beyond that of the shell; counts with gluing_temperature",
        json_schema_extra={"unit": "1e-6/K"},
    )
    glue_thickness: Number = Field(
        default=0.0,
        ge=0,
        le=1,
        description="thickness of the layer of glue under the rim; 0: the glue does not yield",
        json_schema_extra={"unit": "mm"},
    )
    glue_material: str | None = Field(default=None, description="material of that glue; default: that of the disc")
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

    length: Millimetre = Field(ge=0.5, le=1000, description="length of the bore from cavity wall to cavity wall")
    inner_diameter: Millimetre = Field(ge=0.05, le=5, description="diameter of the bore")
    outer_diameter: Millimetre = Field(ge=0.1, le=8, description="outer diameter of the sheath")
    wire_diameter: Millimetre = Field(ge=0.01, le=1, description="diameter of the wire of the coil spring")
    bore: Literal["coil", "smooth"] = Field(
        default="coil",
        description="coil: the wall has the grooves of the spring, and inner_diameter is measured at the crests; "
        "smooth: no grooves",
    )
    sheath_material: str | None = Field(
        default=None, description="material of a sheath that is not rigid; default: the sheath is rigid"
    )
    bend_radius: Millimetre | None = Field(
        default=None, le=1000, description="smallest bending radius of the axis; default: from spring and sheath"
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
                problem = f"is not allowed beside {derived}"
                raise Refusal(problem, kind=Kind.CONFLICT, field=given, value=value, remedy="give one of the two")
            if not _is_positive(value):
                kind = Kind.OUT_OF_RANGE if isinstance(value, (int, float)) else Kind.WRONG_TYPE
                raise Refusal(kind=kind, field=given, value=value, unit="mm", allowed="a number above 0 mm")
            if not _is_positive(wire):
                continue  # said of wire_diameter itself
            if given == "spring_outer_diameter":
                if value <= 2 * wire:
                    allowed = f"above 2 x wire_diameter ({2 * wire:g} mm)"
                    raise Refusal(kind=Kind.CONFLICT, field=given, value=value, unit="mm", allowed=allowed)
                data[derived] = round(value - 2 * wire, 9)
            elif _is_positive(data.get("inner_diameter")):
                data[derived] = round(data["inner_diameter"] + 2 * wire + 2 * value, 9)
        return data

    @property
    def spring_outer_diameter(self) -> float:
        """Outside diameter of the coil spring, mm."""
        return self.inner_diameter + 2 * self.wire_diameter

    @property
    def acoustic_diameter(self) -> float:
        """Diameter of the smooth bore through which air passes as it does between the turns of the spring, mm.

        Flow slips into the grooves of a close-wound spring a little: fitted to
        :attr:`acoustic_fem.duct.CoilBore.effective_radius`, off by at most 3.5e-5 for wires up to half of the bore and
        3e-3 up to the bore; thicker wires, of which no spring is wound, count as that. ``inner_diameter`` where the
        bore is smooth.
        """
        if self.bore == "smooth":
            return self.inner_diameter
        wire = min(self.wire_diameter / self.inner_diameter, 1.0)
        return self.inner_diameter * (1 + 0.0820 * wire + 0.0103 * wire**2)

    def acoustic_length(self, lip: float) -> float:
        """Length of that smooth bore which resists as the tube and its two openings do, mm.

        It is ``length`` where the bore is smooth. Where it is not, the openings and the lips on which the tube ends
        still have ``inner_diameter``.

        Args:
            lip: length of bore in a wall, before the spring begins, at either end of the tube, mm.
        """
        if self.bore == "smooth":
            return self.length
        widening = self.acoustic_diameter / self.inner_diameter
        openings = OPENING_LENGTH_IN_RADII * self.inner_diameter * (widening**4 - widening)
        return self.length + 2 * lip * (widening**4 - 1) + openings

    @property
    def sheath_wall(self) -> float:
        """Wall of the sheath around the coil spring, mm."""
        return (self.outer_diameter - self.spring_outer_diameter) / 2

    @property
    def smallest_bend_radius(self) -> float:
        """Smallest radius to which its axis may be bent, mm.

        By default the larger of two assumed limits. The spring's turns touch on the inside of a bend and gape on
        the outside, there by wire x D / (R - D / 2) with the spring's outside D: at R = 1.5 D by one wire, where
        the sheath begins to sink in. A sleeve of plastic kinks where R is below its own outside diameter.
        """
        return self.bend_radius or max(1.5 * self.spring_outer_diameter, self.outer_diameter)

    @property
    def stub_length(self) -> float:
        """Length of the stub that belongs to a cell, mm."""
        return STUB_LENGTH_IN_RADII * self.acoustic_diameter / 2


class Microphone(Section):
    """MEMS microphone on the ceiling of a cylindrical chamber; it joins the ends of one or more lines."""

    model: str = Field(default="SPH1878LR5H-C", description="part number")
    chamber_diameter: Millimetre = Field(ge=0.5, le=20, description="diameter of the chamber")
    chamber_height: Millimetre = Field(ge=0.3, le=20, description="height of the chamber")
    wall_thickness: Millimetre = Field(default=1.0, ge=0.3, le=20, description="thickness of the housing")
    sound_hole_diameter: Millimetre = Field(
        default=0.5, ge=0.1, le=5, description="diameter of the acoustic port of the package"
    )
    sound_hole_length: Millimetre = Field(default=0.3, ge=0.05, le=5, description="depth of the acoustic port")
    diaphragm_equivalent_volume: CubicMillimetre = Field(
        default=0.05, le=1000, description="volume of air with the (adiabatic) compliance of the diaphragm"
    )
    back_volume: CubicMillimetre = Field(
        default=2.0, le=1000, description="volume of air behind the diaphragm, closed except for the vent"
    )
    vent_corner: Hertz = Field(
        default=20.0, gt=0, le=1000, description="high-pass corner made by the vent in the diaphragm"
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
    noise_corner: Hertz = Field(
        default=100.0, ge=0, le=1e4, description="frequency below which the noise power rises as 1/f"
    )
    overload: Number = Field(
        default=28.3,
        ge=0.1,
        le=2000,
        description="peak pressure, well above the vent's corner, beyond which the output is clipped; "
        "28.3 Pa, the peak of a sine of 120 dB SPL, is assumed",
        json_schema_extra={"unit": "Pa"},
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
    source: str = Field(default="assumed", description="source of these values")

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


def _is_positive(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and 0 < value < math.inf


#: Thinnest wall above and below the socket of a tube and between two ports, mm: less does not survive the glue.
SOCKET_COVER = 0.1
