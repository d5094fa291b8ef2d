"""Fields of the base plate that holds every shell and microphone in its place."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from geometry.schema.field_errors import Millimetre, Section


class Base(Section):
    """The printed plate under the array."""

    kind: Literal["none", "plate"] = Field(
        default="none",
        description="plate: a flat plate with a seat for every shell and microphone, a saddle for every tube and the "
        "numbers of the points",
    )
    thickness: Millimetre = Field(default=2.0, ge=0.8, le=20, description="thickness of the plate under the shells")
    seat_depth: Millimetre = Field(default=0.6, ge=0.3, le=5, description="depth of the seats, below the tubes")
    fit: Millimetre = Field(default=0.15, ge=0.02, le=1, description="gap around what stands in a seat; assumed")
    border: Millimetre = Field(default=8.0, ge=3, le=50, description="width of the plate around the array")
    mount: Literal["screws", "strap", "none"] = Field(
        default="screws", description="screws: a hole in each corner; strap: a slot at each short side"
    )
    screw_diameter: Millimetre = Field(default=3.2, ge=1, le=8, description="diameter of the screw holes")
    strap_width: Millimetre = Field(default=20.0, ge=5, le=100, description="width of the strap")
    saddle_length: Millimetre | None = Field(
        default=None,
        ge=1,
        le=20,
        description="length of the saddle in which each tube is glued down; default: 3 mm, and no saddle where a "
        "tube is too short for it",
    )
    label_height: Millimetre = Field(default=2.5, ge=1.2, le=10, description="height of the numbers beside the points")
