"""Fields of the whole array in a design file, and the lengths that follow, before any rule between the fields."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from typing import Annotated, Literal, Self

from pydantic import Field

from geometry.schema.base_fields import Base
from geometry.schema.field_errors import Count, Degree, Millimetre, Number, Section
from geometry.schema.frozen_fields import FrozenPlaces
from geometry.schema.kinds import PLAIN, Pattern, PointKind
from geometry.schema.manufacture import Molding, Printing
from geometry.schema.materials import MATERIALS, Material
from geometry.schema.part_fields import Membrane, Microphone, Resonator, Shell, Tube
from geometry.schema.surface_fields import SurfaceFit
from geometry.schema.target import Target

MicrophoneName = Annotated[str, Field(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$")]


class Line(Section):
    """Resonators in series between two microphones; points are numbered from the first of them."""

    between: tuple[str, str] = Field(description="names of the two microphones at its ends")
    points: Count = Field(ge=1, le=1000, description="number of sensing points")
    tube: Tube | None = Field(default=None, description="tube between its points, if it differs from the design's")
    microphone_tube: Tube | None = Field(
        default=None, description="tube to its microphones, if it differs from the design's"
    )
    pattern: Pattern | None = Field(default=None, description="kinds of its points and tubes, if they differ")
    lengths: tuple[Millimetre, ...] | None = Field(
        default=None,
        max_length=1001,
        description="length of each of its tubes from its first microphone to its second, one more than points; "
        "default: those of the tubes",
        json_schema_extra={"unit": "mm"},
    )


class PointPlace(Section):
    """Place of one point of a layout of ``places``."""

    x: Number = Field(ge=-2000, le=2000, description="axis of the point", json_schema_extra={"unit": "mm"})
    y: Number = Field(ge=-2000, le=2000, description="axis of the point", json_schema_extra={"unit": "mm"})
    angle: Degree | None = Field(
        default=None,
        ge=-360,
        le=360,
        description="direction in which the line runs straight through the shell; default: each tube leaves towards "
        "its neighbour",
    )


class Layout(Section):
    """Arrangement of the resonators."""

    kind: Literal["serpentine", "ring", "area", "cylinder", "hand", "places", "surface"] = Field(
        description="serpentine: rows of `columns` points, one block per line; ring: lines are the sides of a "
        "polygon, microphones its corners; area: all lines one after the other over rows of `columns` points; "
        "cylinder: a serpentine wound on a cylinder; hand: fingers of `columns` points that fan out from the wrist; "
        "places, surface: every point where it is stated"
    )
    columns: Count = Field(
        default=1000, ge=1, le=1000, description="points per row of a serpentine or an area, or per finger"
    )
    pitch: Millimetre | None = Field(
        default=None, description="distance between neighbours; default: that at which tubes are straight"
    )
    diameter: Millimetre | None = Field(
        default=None, ge=2, le=2000, description="cylinder on which the shells stand; for kind = 'cylinder' only"
    )
    palm: Millimetre | None = Field(
        default=None,
        ge=5,
        le=300,
        description="distance from the wrist to the first point of each finger; for kind = 'hand' only",
    )
    spread: Degree | None = Field(
        default=None, ge=1, le=60, description="angle between neighbouring fingers; for kind = 'hand' only"
    )
    places: tuple[PointPlace, ...] = Field(
        default=(), max_length=1000, description="place of every point, in their order; for kind = 'places' only"
    )
    frozen: FrozenPlaces | None = Field(
        default=None,
        description="places of all parts on a body; for kind = 'surface' only. A file gives `places`, the name of the "
        "file that holds them, instead",
    )
    microphone_side: Literal["ends", "left", "right", "front", "back", "below"] = Field(
        default="ends",
        description="ends: microphones lie straight on from the ends of the lines; left (-x), right (+x), front (-y) "
        "and back (+y): beside the array; below: under the shells. A side is for two microphones on one line",
    )
    depth: Millimetre | None = Field(
        default=None,
        ge=1,
        le=50,
        description="distance of the microphones' ports below those of the shells; for microphone_side = 'below' only; "
        "default: housings are close under the shells",
    )


class Air(Section):
    """State of the air in the array."""

    temperature: Number = Field(
        default=20.0, ge=-20, le=60, description="temperature", json_schema_extra={"unit": "degC"}
    )
    humidity: Number = Field(default=0.5, ge=0, le=1, description="relative humidity, 0 to 1")
    pressure: Number = Field(
        default=101325.0, ge=5e4, le=1.2e5, description="static pressure outside", json_schema_extra={"unit": "Pa"}
    )
    overpressure: Number = Field(
        default=0.0,
        ge=-2e4,
        le=2e4,
        description="static pressure of the enclosed air above that outside; it bulges the membranes",
        json_schema_extra={"unit": "Pa"},
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
    description: str = Field(default="", description="description of the array, used in reports")
    microphones: tuple[MicrophoneName, ...] = Field(min_length=2, max_length=16, description="names of the microphones")
    resonator: Resonator = Field(description="printed shell of a sensing point")
    shell: Shell = Field(default=Shell(), description="further features that are printed on the shells")
    membrane: Membrane = Field(description="silicone disc on each shell")
    tube: Tube = Field(description="tube between neighbouring points")
    microphone_tube: Tube = Field(
        default_factory=lambda stated: stated.get("tube"), description="tube from the end of a line to its microphone"
    )
    microphone: Microphone = Field(description="microphones, which are all alike")
    lines: tuple[Line, ...] = Field(min_length=1, description="lines of points")
    layout: Layout = Field(description="positions of the points")
    surface: SurfaceFit | None = Field(default=None, description="body on which `acoustic-fem fit` lays the array")
    air: Air = Field(default=Air(), description="temperature, humidity and pressure of the air")
    printing: Printing = Field(default=Printing(), description="printing of the parts")
    base: Base = Field(default=Base(), description="plate that holds the array")
    mold: Molding = Field(default=Molding(), description="mold in which the membranes are cast")
    target: Target = Field(default=Target(), description="use against which the verdict on the design is given")
    materials: dict[str, Material] = Field(
        default_factory=dict, description="materials in addition to the built-in ones"
    )
    point_kinds: dict[str, PointKind] = Field(
        default_factory=dict, description="kinds of points that patterns of lines use"
    )
    tube_kinds: dict[str, Tube] = Field(default_factory=dict, description="kinds of tubes that patterns of lines use")

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

    def stated_tubes(self) -> Iterator[tuple[str, Tube, bool]]:
        """Every tube that is stated: name of its field, itself, whether it leads to a microphone."""
        yield "tube", self.tube, False
        yield "microphone_tube", self.microphone_tube, True
        for index, line in enumerate(self.lines):
            if line.tube is not None:
                yield f"lines.{index}.tube", line.tube, False
            if line.microphone_tube is not None:
                yield f"lines.{index}.microphone_tube", line.microphone_tube, True
        for name, tube in self.tube_kinds.items():
            yield f"tube_kinds.{name}", tube, False

    def materials_in_use(self) -> Iterator[tuple[str, str]]:
        """Names of the materials of all parts, each after its field."""
        yield "membrane.material", self.membrane.material
        yield "printing.material", self.printing.material
        if self.membrane.glue_material is not None:
            yield "membrane.glue_material", self.membrane.glue_material
        if self.resonator.floor_material is not None:
            yield "resonator.floor_material", self.resonator.floor_material
        for field, tube, _ in self.stated_tubes():
            if tube.sheath_material is not None:
                yield f"{field}.sheath_material", tube.sheath_material

    # -- kinds ------------------------------------------------------------------------------------------
    def kind_at(self, line: Line, place: int) -> str:
        """Name of the kind of a point, from 0 along its line; that of what is stated for all is empty."""
        if line.pattern is None or line.pattern.points is None:
            return PLAIN
        return line.pattern.points[line.pattern.index(place, line.points)]

    @property
    def kinds(self) -> tuple[str, ...]:
        """Names of the kinds of points in use, each once in the order of the points; see :meth:`kind_at`."""
        if not self.point_kinds:
            return (PLAIN,)
        return tuple(dict.fromkeys(self.kind_at(line, place) for line in self.lines for place in range(line.points)))

    @property
    def kind_of_point(self) -> tuple[int, ...]:
        """Index into :attr:`kinds` of every point, in the order of the numbers."""
        if not self.point_kinds:
            return (0,) * self.point_count
        index = {name: k for k, name in enumerate(self.kinds)}
        return tuple(index[self.kind_at(line, place)] for line in self.lines for place in range(line.points))

    def of_kind(self, kind: str) -> Self:
        """The same array with all its points of one kind: its resonator and membrane are those of the kind."""
        if not self.point_kinds:
            return self
        own = PointKind() if kind == PLAIN else self.point_kinds[kind]
        lines = [
            line.model_copy(update={"pattern": line.pattern and line.pattern.model_copy(update={"points": None})})
            for line in self.lines
        ]
        alike = {"resonator": own.resonator(self.resonator), "membrane": own.membrane(self.membrane)}
        return self.model_copy(update={**alike, "lines": tuple(lines), "point_kinds": {}})

    def resonator_at(self, line: Line, place: int) -> Resonator:
        """Shell of a point, from 0 along its line."""
        kind = self.kind_at(line, place)
        return self.resonator if kind == PLAIN else self.point_kinds[kind].resonator(self.resonator)

    def membrane_at(self, line: Line, place: int) -> Membrane:
        """Membrane of a point, from 0 along its line."""
        kind = self.kind_at(line, place)
        return self.membrane if kind == PLAIN else self.point_kinds[kind].membrane(self.membrane)

    def tube_of(self, line: Line) -> Tube:
        """Tube between the points of a line that has no pattern of tubes."""
        return line.tube or self.tube

    def microphone_tube_of(self, line: Line) -> Tube:
        """Tube from the ends of a line to its microphones; its length is theirs where the line states no lengths."""
        return line.microphone_tube or self.microphone_tube

    def end_tube_of(self, line: Line, end: int) -> Tube:
        """Tube from an end of a line, 0 or 1, to its microphone."""
        return self.tube_at(line, line.points if end else 0)

    def tube_kind_at(self, line: Line, segment: int) -> str:
        """Name of the kind of tube that a pattern gives at a place of a line, as :meth:`tube_at`; else empty."""
        count = line.points - 1
        if line.pattern is None or line.pattern.tubes is None or not 0 < segment <= count:
            return PLAIN
        return line.pattern.tubes[line.pattern.index(segment - 1, count)]

    def tube_at(self, line: Line, segment: int) -> Tube:
        """Tube of a line that has so many of its points before it: 0 and all of them lead to its microphones."""
        if segment in (0, line.points):
            tube = self.microphone_tube_of(line)
        else:
            kind = self.tube_kind_at(line, segment)
            tube = self.tube_of(line) if kind == PLAIN else self.tube_kinds[kind]
        return tube if line.lengths is None else tube.model_copy(update={"length": line.lengths[segment]})

    def segments_of(self, line: Line) -> tuple[Tube, ...]:
        """Tubes between the points of a line, in its order: one less than points."""
        if line.lengths is None and (line.pattern is None or line.pattern.tubes is None):
            return (self.tube_of(line),) * (line.points - 1)
        return tuple(self.tube_at(line, segment) for segment in range(1, line.points))

    def segment_counts_of(self, line: Line) -> tuple[tuple[Tube, int], ...]:
        """The different ones of :meth:`segments_of` by kind and stated length, each with how many there are."""
        if line.points == 1:
            return ()
        if line.lengths is not None:
            return tuple(Counter(self.segments_of(line)).items())
        if line.pattern is None or line.pattern.tubes is None:
            return ((self.tube_of(line), line.points - 1),)
        counts = Counter(self.tube_kind_at(line, segment) for segment in range(1, line.points))
        return tuple((self.tube_kinds[kind], count) for kind, count in counts.items())

    def inner_tubes_of(self, line: Line) -> tuple[Tube, ...]:
        """The different ones of :meth:`segments_of` by kind and stated length."""
        return tuple(tube for tube, _ in self.segment_counts_of(line))

    @property
    def tubes(self) -> tuple[Tube, ...]:
        """Tubes that the array uses, one per kind and line: those between points, then those to microphones."""
        inner = [tube for line in self.lines for tube in self.inner_tubes_of(line)]
        outer = (
            self.end_tube_of(line, end) for line in self.lines for end in ((0,) if line.lengths is None else (0, 1))
        )
        return (*inner, *outer)

    def tubes_of(self, line: Line) -> tuple[Tube, ...]:
        """Tubes of a line from its first microphone to its second: one more than points."""
        return (self.end_tube_of(line, 0), *self.segments_of(line), self.end_tube_of(line, 1))

    def tube_fields_of(self, number: int) -> tuple[str, ...]:
        """Dotted names of where the design states the tubes of a line, by its index, as :meth:`tubes_of` has them."""
        line = self.lines[number]
        if line.lengths is not None:
            return tuple(f"lines.{number}.lengths.{segment}" for segment in range(line.points + 1))
        outer = "microphone_tube" if line.microphone_tube is None else f"lines.{number}.microphone_tube"
        inner = "tube" if line.tube is None else f"lines.{number}.tube"
        if line.pattern is None or line.pattern.tubes is None:
            return (outer, *(inner,) * (line.points - 1), outer)
        kinds = (self.tube_kind_at(line, segment) for segment in range(1, line.points))
        return (outer, *(inner if kind == PLAIN else f"tube_kinds.{kind}" for kind in kinds), outer)

    # -- lengths ----------------------------------------------------------------------------------------
    def steps_of(self, line: Line) -> tuple[float, ...]:
        """Distances of neighbouring axes along a line, one less than points, mm."""
        diameter = self.resonator.cavity_diameter
        return tuple(self.layout.pitch or diameter + tube.length for tube in self.segments_of(line))

    def span_of(self, line: Line) -> float:
        """Distance of the axes of a line's first and last point where its tubes lie as designed, mm."""
        steps = self.steps_of(line)
        # Equal steps are multiplied, not summed: the same to the last digit as for a line without a pattern.
        return len(steps) * steps[0] if len(set(steps)) == 1 else math.fsum(steps)

    def pitch_of(self, line: Line) -> float:
        """Largest distance of neighbouring axes on a line, mm."""
        longest = max((tube.length for tube in self.inner_tubes_of(line)), default=self.tube_of(line).length)
        return self.layout.pitch or self.resonator.cavity_diameter + longest

    def microphone_reach_of(self, line: Line, end: int) -> float:
        """Distance of the axes of the point at an end of a line, 0 or 1, and its microphone if the tube is straight."""
        length = self.end_tube_of(line, end).length
        return self.resonator.cavity_diameter / 2 + length + self.microphone.chamber_diameter / 2
