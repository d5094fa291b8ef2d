"""Use of a design: the size, the touch and the price against which its verdict is given."""

from __future__ import annotations

from pydantic import Field

from geometry.schema.field_errors import Millimetre, Number, Section


class Target(Section):
    """Use that the designer has in mind. No part depends on it, only the verdict on the design."""

    size: tuple[Millimetre, Millimetre] | None = Field(
        default=None,
        description="length and width, in mm, in which the array must fit, either way round; default: no limit",
    )
    force: Number = Field(
        default=0.1,
        ge=1e-6,
        le=100,
        description="smallest force of a touch that must be located",
        json_schema_extra={"unit": "N"},
    )
    contact_radius: Millimetre = Field(
        default=6.0, ge=0.1, le=200, description="radius of the area that a touch covers"
    )
    budget: Number | None = Field(
        default=None,
        gt=0,
        le=1e6,
        description="highest cost of the parts of one array; default: no limit",
        json_schema_extra={"unit": "USD"},
    )
