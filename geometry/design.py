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

from geometry.design_fields import Count, Number, Section
from geometry.design_rules import check_consistency
from geometry.materials import MATERIALS, Material
from geometry.topology import check_topology

#: Ducts are cut this many bore radii away from a cavity: the stub belongs to the 3-D cell, so that the
#: entrance flow has decayed to a plane wave where the port is (its slowest mode decays as exp(-5 z/a)).
STUB_LENGTH_IN_RADII = 4.0

Millimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm"})]
MicrophoneName = Annotated[str, Field(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")]


class Resonator(Section):
    """Printed shell of one sensing point: a cylindrical air cavity, open at the top."""

    cavity_diameter: Millimetre = Field(ge=0.8, le=50, description="diameter of the air cavity")
    cavity_height: Millimetre = Field(ge=0.4, le=50, description="floor of the cavity to the membrane")
    wall_thickness: Millimetre = Field(ge=0.3, le=20, description="radial thickness of the shell")
    floor_thickness: Millimetre = Field(default=1.0, ge=0.3, le=20, description="thickness of the floor")
    port_height: Millimetre | None = Field(
        default=None, description="axis of the tube ports above the floor of the cavity; default: mid height"
    )

    @property
    def port_axis_height(self) -> float:
        """Height of the tube axis above the cavity floor, mm."""
        return self.cavity_height / 2 if self.port_height is None else self.port_height

    @property
    def outer_diameter(self) -> float:
        """Outside diameter of the shell, mm."""
        return self.cavity_diameter + 2 * self.wall_thickness

    @property
    def cavity_volume(self) -> float:
        """Volume of the air cavity, mm^3."""
        return math.pi / 4 * self.cavity_diameter**2 * self.cavity_height


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

    @property
    def mounted_thickness(self) -> float:
        """Thickness of the disc after it was stretched, at constant volume, mm."""
        return self.thickness / self.stretch**2


class Tube(Section):
    """Micro-tube: a close-wound coil spring inside a sheath.

    A file may give ``spring_outer_diameter`` instead of ``inner_diameter`` (bore = spring outer diameter
    - 2 x wire) and ``sheath_wall`` instead of ``outer_diameter``.
    """

    length: Millimetre = Field(ge=0.5, le=1000, description="bore from cavity wall to cavity wall")
    inner_diameter: Millimetre = Field(ge=0.05, le=5, description="bore")
    outer_diameter: Millimetre = Field(ge=0.1, le=8, description="outside of the sheath")
    wire_diameter: Millimetre = Field(ge=0.01, le=1, description="wire of the coil spring")

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
    source: str = Field(default="assumed", description="where the figures come from")

    @property
    def chamber_volume(self) -> float:
        """Volume of the chamber without the sound hole, mm^3."""
        return math.pi / 4 * self.chamber_diameter**2 * self.chamber_height


class Line(Section):
    """Resonators in series between two microphones; points are numbered from the first of them."""

    between: tuple[str, str] = Field(description="names of the two microphones at its ends")
    points: Count = Field(ge=1, le=1000, description="number of sensing points")
    tube: Tube | None = Field(default=None, description="tube between its points, where it differs")
    microphone_tube: Tube | None = Field(default=None, description="tube to its microphones, where it differs")


class Layout(Section):
    """Where the resonators lie."""

    kind: Literal["serpentine", "ring"] = Field(
        description="serpentine: rows of `columns` points, one block per line; ring: lines are the sides of a "
        "polygon, microphones its corners"
    )
    columns: Count = Field(default=1000, ge=1, le=1000, description="points per row of a serpentine")
    pitch: Millimetre | None = Field(default=None, description="distance of neighbours; default: tubes lie straight")


class Air(Section):
    """State of the air in the array."""

    temperature: Number = Field(
        default=20.0, ge=-20, le=60, description="temperature", json_schema_extra={"unit": "degC"}
    )
    humidity: Number = Field(default=0.5, ge=0, le=1, description="relative humidity, 0 to 1")
    pressure: Number = Field(
        default=101325.0, ge=5e4, le=1.2e5, description="static pressure", json_schema_extra={"unit": "Pa"}
    )


class Printing(Section):
    """How the shells and molds are printed and joined."""

    process: Literal["sla-resin", "dlp-fine"] = Field(default="sla-resin", description="process of the rules")
    material: str = Field(default="photopolymer-resin", description="material of shells and molds")
    glue_gap: Millimetre = Field(default=0.05, le=1, description="radial gap around a tube in its port")
    port_lip: Millimetre = Field(default=0.3, le=10, description="shoulder on which a tube stops in its port")


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
    membrane: Membrane = Field(description="silicone disc on each shell")
    tube: Tube = Field(description="tube between neighbouring points")
    microphone_tube: Tube = Field(description="tube from the end of a line to its microphone")
    microphone: Microphone = Field(description="the microphones, all alike")
    lines: tuple[Line, ...] = Field(min_length=1, description="the lines")
    layout: Layout = Field(description="where the resonators lie")
    air: Air = Field(default=Air(), description="state of the air")
    printing: Printing = Field(default=Printing(), description="how the parts are made")
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
