"""Places of all parts of an array on a body, as a design holds them: where each is and how it stands."""

from __future__ import annotations

from pydantic import Field

from geometry.schema.field_errors import Count, Degree, Millimetre, Number, Section

Triple = tuple[Number, Number, Number]


class FrozenPart(Section):
    """Place of a shell or of a housing in space."""

    at: Triple = Field(
        description="where its axis meets the level of the floors of the cavities", json_schema_extra={"unit": "mm"}
    )
    normal: Triple = Field(description="direction of its axis, away from the body; its length does not matter")
    x: Triple = Field(description="direction from which its angles count; what is along the normal does not matter")
    ports: tuple[Degree, ...] = Field(
        min_length=1,
        max_length=32,
        description="directions of its tubes, anticlockwise from x seen from outside, in the order of the lines: of a "
        "point towards the one before and the one after",
        json_schema_extra={"unit": "degrees"},
    )
    plan: tuple[Number, Number] = Field(
        description="its place in the unrolled plan, where touches and tracks are computed",
        json_schema_extra={"unit": "mm"},
    )


class FrozenTube(Section):
    """Course of one tube, where it is not the smooth curve between its two ports."""

    side: Number = Field(
        default=1.0,
        ge=-1,
        le=1,
        description="side to which a longer tube bulges, seen from outside: 1 left, -1 right of its line",
    )
    course: tuple[Triple, ...] = Field(
        default=(),
        max_length=500,
        description="places along its axis, from wall to wall of the cavities; default: a smooth curve of its length",
        json_schema_extra={"unit": "mm"},
    )


class FrozenCell(Section):
    """Part of the body's region that is nearer to one point than to the others."""

    area: Number = Field(ge=0, description="its area", json_schema_extra={"unit": "mm^2"})
    distances: tuple[Number, ...] = Field(
        min_length=2,
        max_length=200,
        description="distances from the rim of the point's membrane, in ascending order: of its nearest place, of "
        "places at equal steps of the area, and of its furthest place",
        json_schema_extra={"unit": "mm"},
    )


class FrozenSizes(Section):
    """Sizes for which the places were made; a design with other sizes is refused."""

    shell_diameter: Millimetre | None = Field(default=None, description="outside diameter of the shells")
    cavity_diameter: Millimetre | None = Field(default=None, description="diameter of the cavities")
    chamber_diameter: Millimetre | None = Field(default=None, description="diameter of the microphones' chambers")
    seat_length: Millimetre | None = Field(default=None, description="outside length of the microphones' seats")
    seat_width: Millimetre | None = Field(default=None, description="outside width of the microphones' seats")
    floor_thickness: Millimetre | None = Field(
        default=None, description="thickness of the floors of shells that stand on the body"
    )
    membrane_height: Millimetre | None = Field(
        default=None,
        description="height of the membranes above the floors of shells in pockets, whose membranes are flush with the "
        "body",
    )


class FrozenPlaces(Section):
    """Places of all parts of a layout of kind 'surface'; ``acoustic-fem fit`` writes them, other tools may."""

    points: tuple[FrozenPart, ...] = Field(min_length=1, max_length=1000, description="every point, in their order")
    microphones: tuple[FrozenPart, ...] = Field(
        min_length=2, max_length=16, description="every microphone, in the order of the design"
    )
    tubes: tuple[FrozenTube, ...] = Field(
        default=(),
        max_length=2000,
        description="every tube, line by line from the first microphone to the second; default: all are smooth curves",
    )
    cells: tuple[FrozenCell, ...] = Field(
        default=(), max_length=1000, description="the region of the body by its nearest point, one cell for every point"
    )
    furthest: Triple | None = Field(
        default=None,
        description="place of the region that is furthest from a membrane",
        json_schema_extra={"unit": "mm"},
    )
    sizes: FrozenSizes = Field(default=FrozenSizes(), description="sizes for which the places were made")
    body: str = Field(default="", max_length=64, description="SHA-256 of the file of the body")
    inputs: str = Field(default="", max_length=64, description="SHA-256 of what the places were fitted to")
    seed: Count = Field(default=0, ge=0, description="seed with which the places were found")
    findings: tuple[str, ...] = Field(default=(), max_length=200, description="what the fit found")
