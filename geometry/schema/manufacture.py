"""How the parts of a design are made: the process they are printed in, and the mold of its membranes."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from geometry.schema.field_errors import Count, CubicMillimetre, Degree, Millimetre, Number, Section

Ratio = Annotated[Number, Field(gt=0)]


class PrintRules(Section):
    """Figures of the printing process that differ from the built-in ones; nothing given changes nothing."""

    wall: Millimetre | None = Field(default=None, description="thinnest wall")
    wall_advised: Millimetre | None = Field(default=None, description="thinnest wall without risk")
    hole: Millimetre | None = Field(default=None, description="narrowest round hole")
    hole_advised: Millimetre | None = Field(default=None, description="narrowest round hole without risk")
    slot: Millimetre | None = Field(default=None, description="narrowest gap between walls")
    slot_advised: Millimetre | None = Field(default=None, description="narrowest gap between walls without risk")
    clearance: Millimetre | None = Field(default=None, description="narrowest radial gap between mating parts")
    clearance_advised: Millimetre | None = Field(
        default=None, description="narrowest radial gap between mating parts without risk"
    )
    pin_aspect: Ratio | None = Field(default=None, description="largest ratio of a pin's height to its diameter")
    pin_aspect_advised: Ratio | None = Field(
        default=None, description="largest ratio of a pin's height to its diameter without risk"
    )
    overhang_angle: Degree | None = Field(
        default=None, gt=0, lt=90, description="faces that point down and are flatter than this angle are overhangs"
    )
    overhang_span: Millimetre | None = Field(default=None, description="widest overhang")
    overhang_span_advised: Millimetre | None = Field(default=None, description="widest overhang without support")
    cup_volume: CubicMillimetre | None = Field(default=None, description="largest cup sealed on the resin's film")
    cup_volume_advised: CubicMillimetre | None = Field(default=None, description="largest sealed cup without risk")
    cast_thickness: Millimetre | None = Field(default=None, description="thinnest cast disc")
    cast_thickness_advised: Millimetre | None = Field(default=None, description="thinnest cast disc without risk")
    pixel: Millimetre | None = Field(default=None, description="width of a pixel, laser spot or nozzle")
    tolerance: Millimetre | None = Field(default=None, description="tolerance (plus or minus) of a printed length")
    layer: Millimetre | None = Field(default=None, description="height of a layer")
    bleed: Millimetre | None = Field(
        default=None, description="depth to which light hardens resin below a layer, a whole number of layers"
    )
    first_layers: Count | None = Field(default=None, description="layers at the plate that are exposed longer")
    build_volume: tuple[Millimetre, Millimetre, Millimetre] | None = Field(
        default=None, description="width, depth and height of the machine, mm"
    )


class Printing(Section):
    """How the shells and molds are printed and joined."""

    process: Literal["sla-resin", "dlp-fine", "fdm", "mjf"] = Field(
        default="sla-resin", description="process whose print rules apply"
    )
    material: str = Field(default="photopolymer-resin", description="material of shells and molds")
    glue_gap: Millimetre = Field(default=0.05, le=1, description="radial gap around a tube in its port")
    port_lip: Millimetre = Field(
        default=0.3, le=10, description="width of the shoulder at which a tube stops in its port"
    )
    carrier: Literal["none", "row", "sheet"] = Field(
        default="none",
        description="none: single shells; row or sheet: all shells in one piece, joined by snap-off necks",
    )
    carrier_gap: Millimetre = Field(
        default=4.0, ge=2, le=50, description="gap between neighbouring shells of a carrier"
    )
    carrier_neck: Millimetre = Field(default=0.5, ge=0.2, le=3, description="width and height of a snap-off neck")
    rules: PrintRules = Field(default=PrintRules(), description="limits that differ from those of the process")


class Molding(Section):
    """The mold in which membranes are cast."""

    kind: Literal["two-part", "open-face"] = Field(
        default="two-part", description="two-part: base and lid; open-face: base and a scraper that rides on its lands"
    )
    rows: Count | None = Field(
        default=None,
        ge=1,
        le=20,
        description="rows of cavities; without rows and columns the mold has a cavity for every membrane of the array, "
        "as far as the printer has room",
    )
    columns: Count | None = Field(default=None, ge=1, le=20, description="cavities per row; see rows")
    draft: Degree = Field(
        default=1.0, ge=0, le=10, description="slope of the walls and of the membranes' edges; assumed"
    )
    land_width: Millimetre = Field(default=0.6, ge=0.2, le=5, description="width of the land around a cavity; assumed")
    land_height: Millimetre = Field(
        default=0.5, ge=0.2, le=5, description="height of the lands, the gap between the halves elsewhere; assumed"
    )
    groove_width: Millimetre = Field(default=1.2, ge=0.5, le=5, description="width of the overflow groove; assumed")
    vent_diameter: Millimetre = Field(
        default=1.0, ge=0.3, le=5, description="diameter of the two vents per cavity in the lid; assumed"
    )
    pin_diameter: Millimetre = Field(default=2.5, ge=1, le=10, description="diameter of the registration pins; assumed")
    pin_clearance: Millimetre = Field(
        default=0.1,
        ge=0.02,
        le=1,
        description="radial gap of a pin in its socket, gap of the scraper's guides; assumed",
    )
    sockets: Literal["through", "blind"] = Field(
        default="through",
        description="sockets of the pins in the lid; with blind sockets the halves cannot be pushed apart from outside",
    )
    shim_step: Millimetre = Field(
        default=0.05, ge=0.01, le=0.5, description="height by which a shim raises the lid, one set per step; assumed"
    )
    shim_count: Count = Field(default=2, ge=0, le=10, description="sets of shims for thicker membranes; assumed")
    trim: Number = Field(
        default=0.0,
        ge=-1,
        le=1,
        description="depth that is added to the cavities: stated minus measured thickness of the last cast",
        json_schema_extra={"unit": "mm"},
    )
    silicone_shrinkage: Number = Field(
        default=0.001,
        ge=0,
        le=0.1,
        description="linear shrinkage on curing; data sheets of platinum-cure silicones: at most 0.001",
    )
    resin_shrinkage: Number = Field(
        default=0.0,
        ge=0,
        le=0.1,
        description="linear shrinkage of the printed mold that the printer does not correct; assumed",
    )
    ejector: Literal["pins", "none"] = Field(
        default="pins",
        description="pins: holes in the floor of each cavity, closed by the pins of a plate while you cast, through "
        "which you push the membranes out; none: blind cavities",
    )

    @property
    def scale(self) -> float:
        """Lengths of the drawn cavity per those of the membrane."""
        return 1 / ((1 - self.silicone_shrinkage) * (1 - self.resin_shrinkage))
