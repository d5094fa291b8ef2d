"""The design of an array: fields, units, limits.

Lengths are millimetres, moduli megapascals, frequencies hertz. A design is immutable; changed copies
come from :meth:`ArrayDesign.with_values`. Reading, writing and error wording live in
:mod:`geometry.design_file`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from geometry.materials import MATERIALS, Material
from geometry.topology import check_topology

#: Ducts are cut this many bore radii away from a cavity: the stub belongs to the 3-D cell, so that the
#: entrance flow has decayed to a plane wave where the port is (its slowest mode decays as exp(-5 z/a)).
STUB_LENGTH_IN_RADII = 4.0

Millimetre = Annotated[float, Field(gt=0, json_schema_extra={"unit": "mm"})]


class Section(BaseModel):
    """Base of every section of a design file: unknown keys and non-finite numbers are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


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
    """Silicone disc glued by its lower face on the rim of the shell."""

    material: str = Field(description="name of a silicone: built in, or defined under [materials.NAME]")
    thickness: Millimetre = Field(ge=0.05, le=10, description="thickness of the disc")
    rim_width: Millimetre = Field(ge=0.2, le=20, description="width of the glued annulus around the cavity")


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
        for given, derived, base, step in (
            ("spring_outer_diameter", "inner_diameter", None, -2.0),
            ("sheath_wall", "outer_diameter", "inner_diameter", 2.0),
        ):
            if given not in data:
                continue
            if derived in data:
                raise ValueError(f"{given} and {derived} are both given; give one of them")
            value = data.pop(given)
            numbers = [value, wire] if base is None else [value, wire, data.get(base)]
            if not all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in numbers):
                raise ValueError(f"{given} = {value!r} needs numbers for it, wire_diameter and the bore")
            if not value > 0:
                raise ValueError(f"{given} = {value:g} mm must be above 0 mm")
            start = value if base is None else data[base] + 2 * wire
            data[derived] = round(start + step * (wire if base is None else value), 9)
        return data

    @property
    def spring_outer_diameter(self) -> float:
        """Outside diameter of the coil spring, mm."""
        return self.inner_diameter + 2 * self.wire_diameter

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
    diaphragm_equivalent_volume: float = Field(
        default=0.05,
        gt=0,
        le=1000,
        description="air volume as compliant (adiabatic) as the diaphragm",
        json_schema_extra={"unit": "mm^3"},
    )
    back_volume: float = Field(
        default=2.0,
        gt=0,
        le=1000,
        description="air behind the diaphragm, closed but for the vent",
        json_schema_extra={"unit": "mm^3"},
    )
    vent_corner: float = Field(
        default=20.0,
        gt=0,
        le=1000,
        description="high-pass corner made by the vent in the diaphragm",
        json_schema_extra={"unit": "Hz"},
    )
    sensitivity: float = Field(
        default=-38.0,
        ge=-80,
        le=0,
        description="output at 94 dB SPL, 1 kHz",
        json_schema_extra={"unit": "dB re 1 V/Pa"},
    )
    noise_density: float = Field(
        default=5e-6,
        gt=0,
        le=1,
        description="white equivalent input noise",
        json_schema_extra={"unit": "Pa/sqrt(Hz)"},
    )
    noise_corner: float = Field(
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
    points: int = Field(ge=1, le=1000, description="number of sensing points")
    tube: Tube | None = Field(default=None, description="tube between its points, where it differs")
    microphone_tube: Tube | None = Field(default=None, description="tube to its microphones, where it differs")


class Layout(Section):
    """Where the resonators lie."""

    kind: Literal["serpentine", "ring"] = Field(
        description="serpentine: rows of `columns` points, one block per line; ring: lines on the sides of a "
        "polygon whose corners are the microphones"
    )
    columns: int = Field(default=1000, ge=1, le=1000, description="points per row of a serpentine")
    pitch: Millimetre | None = Field(default=None, description="distance of neighbours; default: tubes lie straight")


class Air(Section):
    """State of the air in the array."""

    temperature: float = Field(
        default=20.0, ge=-20, le=60, description="temperature", json_schema_extra={"unit": "degC"}
    )
    humidity: float = Field(default=0.5, ge=0, le=1, description="relative humidity, 0 to 1")
    pressure: float = Field(
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

    name: str = Field(min_length=1, max_length=80, pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")
    description: str = ""
    microphones: tuple[str, ...] = Field(min_length=2, max_length=16, description="names of the microphones")
    resonator: Resonator
    membrane: Membrane
    tube: Tube = Field(description="tube between neighbouring points")
    microphone_tube: Tube = Field(description="tube from the end of a line to its microphone")
    microphone: Microphone
    lines: tuple[Line, ...] = Field(min_length=1, description="the lines")
    layout: Layout
    air: Air = Air()
    printing: Printing = Printing()
    materials: dict[str, Material] = Field(default_factory=dict, description="materials beside the built-in ones")

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        check_topology(self.microphones, [(line.between, line.points) for line in self.lines])
        for message in _inconsistencies(self):
            raise ValueError(message)
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


def _inconsistencies(design: ArrayDesign):  # noqa: ANN202 - yields one message per broken rule
    """Yield a sentence for every combination of fields that cannot be built."""
    resonator, membrane = design.resonator, design.membrane
    for field, name in (("membrane.material", membrane.material), ("printing.material", design.printing.material)):
        if name not in design.materials and name not in MATERIALS:
            known = ", ".join(sorted({*MATERIALS, *design.materials}))
            yield f"{field} = {name!r} must be one of: {known}"
    if membrane.rim_width > resonator.wall_thickness:
        yield (
            f"membrane.rim_width = {membrane.rim_width:g} mm must be at most resonator.wall_thickness "
            f"({resonator.wall_thickness:g} mm)"
        )
    axis = resonator.port_axis_height
    tubes = [("tube", design.tube, True), ("microphone_tube", design.microphone_tube, True)]
    for index, line in enumerate(design.lines):
        tubes += [
            (f"lines.{index}.{kind}", tube, True)
            for kind, tube in (("tube", line.tube), ("microphone_tube", line.microphone_tube))
            if tube is not None
        ]
    gap = design.printing.glue_gap
    chamber = design.microphone
    for field, tube, _ in tubes:
        if tube.inner_diameter >= tube.outer_diameter:
            yield (
                f"{field}.inner_diameter = {tube.inner_diameter:g} mm must be below {field}.outer_diameter "
                f"({tube.outer_diameter:g} mm)"
            )
        if tube.spring_outer_diameter > tube.outer_diameter + 1e-9:
            yield (
                f"{field}.wire_diameter = {tube.wire_diameter:g} mm must be at most "
                f"{(tube.outer_diameter - tube.inner_diameter) / 2:g} mm, the wall between bore and outside"
            )
        if tube.outer_diameter > resonator.cavity_height:
            yield (
                f"{field}.outer_diameter = {tube.outer_diameter:g} mm must be at most resonator.cavity_height "
                f"({resonator.cavity_height:g} mm)"
            )
        hole = tube.outer_diameter / 2 + gap
        if axis + hole > resonator.cavity_height or axis - tube.inner_diameter / 2 < 0:
            yield (
                f"resonator.port_height = {axis:g} mm must be between {tube.inner_diameter / 2:g} and "
                f"{resonator.cavity_height - hole:g} mm for {field} to open into the wall"
            )
        if tube.inner_diameter > resonator.cavity_diameter / 2:
            yield (
                f"{field}.inner_diameter = {tube.inner_diameter:g} mm must be at most half of "
                f"resonator.cavity_diameter ({resonator.cavity_diameter / 2:g} mm)"
            )
        if tube.length < 2 * tube.stub_length:
            yield (
                f"{field}.length = {tube.length:g} mm must be at least {2 * tube.stub_length:g} mm, "
                f"{2 * STUB_LENGTH_IN_RADII:g} bore radii: shorter tubes have no plane-wave part"
            )
        if field.endswith("microphone_tube"):
            if tube.inner_diameter > min(chamber.chamber_height, chamber.chamber_diameter / 2):
                yield (
                    f"{field}.inner_diameter = {tube.inner_diameter:g} mm must be at most "
                    f"{min(chamber.chamber_height, chamber.chamber_diameter / 2):g} mm, the smaller of "
                    "microphone.chamber_height and half of microphone.chamber_diameter"
                )
    if design.printing.port_lip >= resonator.wall_thickness:
        yield (
            f"printing.port_lip = {design.printing.port_lip:g} mm must be below resonator.wall_thickness "
            f"({resonator.wall_thickness:g} mm)"
        )
    if chamber.sound_hole_diameter >= chamber.chamber_diameter:
        yield (
            f"microphone.sound_hole_diameter = {chamber.sound_hole_diameter:g} mm must be below "
            f"microphone.chamber_diameter ({chamber.chamber_diameter:g} mm)"
        )
    pitch = design.layout.pitch
    if pitch is not None:
        shortest = min(design.tube_of(line).length for line in design.lines)
        reach = resonator.cavity_diameter + shortest
        if not resonator.outer_diameter <= pitch <= reach + 1e-9:
            yield (
                f"layout.pitch = {pitch:g} mm must be between {resonator.outer_diameter:g} mm (shells touch) and "
                f"{reach:g} mm (tubes straight)"
            )
