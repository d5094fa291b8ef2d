"""Fields of ``[surface]``: the body on which ``acoustic-fem fit`` lays an array, where on it, and how."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from geometry.schema.field_errors import Count, Degree, Millimetre, Number, Section
from geometry.schema.frozen_fields import Triple


class NormalCone(Section):
    """The part of a body that faces a direction."""

    towards: Triple = Field(description="direction; its length does not matter")
    within: Degree = Field(gt=0, le=180, description="largest angle between a normal of the body and the direction")


class HalfSpace(Section):
    """The part of space on one side of a plane."""

    point: Triple = Field(description="a place on the plane", json_schema_extra={"unit": "mm"})
    normal: Triple = Field(description="direction away from the plane into the part; its length does not matter")


class SurfaceRegion(Section):
    """Part of the body that carries points: all that is stated must hold."""

    faces: tuple[Count, ...] = Field(
        default=(),
        max_length=1000,
        description="numbers of the faces of a STEP file or of the painted groups of a mesh, from 1; default: all",
    )
    normal: NormalCone | None = Field(default=None, description="direction that the region faces")
    above: tuple[HalfSpace, ...] = Field(default=(), max_length=12, description="planes above which the region lies")
    least_radius: Millimetre | None = Field(
        default=None, description="smallest radius of the body where points may be; default: what a shell takes"
    )


class MicrophoneWish(Section):
    """Place at which a microphone is wanted."""

    name: str = Field(description="name of the microphone")
    at: Triple = Field(
        description="place on the body; the microphone moves to the nearest one with room",
        json_schema_extra={"unit": "mm"},
    )


class SurfaceFit(Section):
    """Body, region and options of ``acoustic-fem fit``."""

    body: str = Field(
        min_length=1,
        max_length=300,
        description="file of the body beside the design: .step, .stp, .stl, .3mf, .obj or .ply",
    )
    unit: Literal["mm", "cm", "m", "inch"] = Field(default="mm", description="unit of lengths in a mesh file")
    skin: Count | None = Field(
        default=None, ge=1, le=1000, description="which of several closed skins of the file, the largest first"
    )
    seat: Literal["on", "in"] = Field(
        default="on",
        description="on: shells stand on the body, in a skin; in: shells lie in pockets, their membranes flush with it",
    )
    base: Number = Field(
        default=0.4, ge=0, le=20, description="distance from the body to the floors of shells that stand on it",
        json_schema_extra={"unit": "mm"},
    )  # fmt: skip
    pitch: Millimetre | None = Field(
        default=None, le=500, description="distance between neighbours, instead of a number of points"
    )
    edge: Number = Field(
        default=0.4, ge=0, le=100, description="distance from shells to the edge of the region",
        json_schema_extra={"unit": "mm"},
    )  # fmt: skip
    port_step: Degree = Field(
        default=15.0, ge=1, le=60, description="step of the angle between the two ports of a shell: a larger one makes "
        "fewer kinds of shells",
    )  # fmt: skip
    tubes: Literal["as they lie", "equal"] = Field(
        default="as they lie",
        description="as they lie: each tube between two points has the length of its gap; equal: points are moved "
        "until all of these tubes have one length",
    )
    length_step: Millimetre = Field(
        default=0.5, ge=0.01, le=5, description="step of the lengths of tubes; finer where tubes would bend too far"
    )
    seed: Count = Field(default=0, ge=0, le=1_000_000, description="seed of the search for places")
    region: SurfaceRegion = Field(default=SurfaceRegion(), description="part of the body that carries points")
    microphones: tuple[MicrophoneWish, ...] = Field(
        default=(),
        max_length=16,
        description="places where microphones are wanted; default: spread at the edge of the region",
    )
    forbidden: tuple[Count, ...] = Field(
        default=(), max_length=1000, description="numbers of the faces or groups where no microphone may be"
    )
