"""Plan of a mold: the positions and sizes that base, lid, shims and scraper have in common."""

from __future__ import annotations

import math
from dataclasses import dataclass

from geometry.design.design_file import DesignLike, resolve_design
from geometry.schema.manufacture import Molding
from geometry.solids.membrane import membrane_profile

Spot = tuple[float, float]

#: Material around grooves and pins and below the deepest pocket, mm: stiff enough to be clamped.
MARGIN, FLOOR = 1.5, 2.0
#: Plate of the lid, mm, and what a pin stays below its top.
LID_THICKNESS, PIN_RECESS = 3.0, 0.5
#: A blind socket leaves this much of the lid and is this much deeper than its pin, mm.
SOCKET_ROOF, SOCKET_SPARE = 1.0, 0.3
#: Width of a shim around its pin and of the scraper's rails, mm.
SHIM_WIDTH, RAIL_WIDTH = 1.2, 0.8
#: How far an overflow groove goes below the gap between the halves, mm.
_GROOVE_DEPTH = 0.6


@dataclass(frozen=True)
class MoldPlan:
    """A mold as it lies when closed, mm: the parting plane is z = 0, the cavities lie below it."""

    mold: Molding
    """Section ``mold`` of the design."""
    profile: tuple[Spot, ...]
    """Half section of a cavity, corners (radius, height) in mm with the parting plane at 0: the membrane's, turned over
    and compensated for shrinkage.
    """
    centres: tuple[Spot, ...]
    """Axes of the cavities, mm, rows along x."""
    land: tuple[float, float]
    """Inner and outer radius of a land at the parting plane, mm."""
    groove: tuple[float, float]
    """Inner and outer radius of an overflow groove at its top, in the floor of the gap, mm."""
    groove_bottom: float
    """Height of the groove's floor, mm."""
    half: tuple[float, float]
    """Half length of the block along x and y, mm."""
    bottom: float
    """Height of the block's lower face, mm."""
    pins: tuple[Spot, ...]
    """Axes of the pins, mm, on three corners: the lid fits in one way only."""
    pin_top: float
    """Height of the pins' tips, mm."""

    @property
    def gap(self) -> float:
        """Height of the block beside the lands: the halves touch on the lands only, mm."""
        return -self.mold.land_height

    @property
    def socket_radius(self) -> float:
        """Radius of the sockets of the pins, mm."""
        return self.mold.pin_diameter / 2 + self.mold.pin_clearance

    @property
    def slope(self) -> float:
        """Tangent of the draft: how far a wall leans per height."""
        return math.tan(math.radians(self.mold.draft))


def plan_mold(design: DesignLike) -> MoldPlan:
    """Lay out the mold of a design's membranes."""
    design = resolve_design(design)
    mold = design.mold
    profile = tuple((radius * mold.scale, -height * mold.scale) for radius, height in membrane_profile(design))
    radius = max(r for r, _ in profile)
    slope = math.tan(math.radians(mold.draft))
    land = (radius, radius + mold.land_width)
    groove = (land[1] + mold.land_height * slope, land[1] + mold.land_height * slope + mold.groove_width)
    groove_bottom = -mold.land_height - _GROOVE_DEPTH
    pitch = 2 * groove[1] + MARGIN
    across, along = (mold.columns - 1) * pitch / 2, (mold.rows - 1) * pitch / 2
    centres = tuple(
        (column * pitch - across, along - row * pitch) for row in range(mold.rows) for column in range(mold.columns)
    )
    shim = mold.pin_diameter / 2 + mold.pin_clearance + SHIM_WIDTH
    # Pins stand on the diagonals of the corner cavities, their shims clear of the grooves.
    aside = (groove[1] + shim + 0.2) / math.sqrt(2)
    beside = groove[1] + MARGIN
    if mold.kind == "two-part":
        beside = max(beside, aside + shim + 0.3)
    pins = ((across + aside, along + aside), (-across - aside, along + aside), (-across - aside, -along - aside))
    length = LID_THICKNESS - (PIN_RECESS if mold.sockets == "through" else SOCKET_ROOF + SOCKET_SPARE)
    return MoldPlan(
        mold=mold,
        profile=profile,
        centres=centres,
        land=land,
        groove=groove,
        groove_bottom=groove_bottom,
        half=(across + beside, along + beside),
        bottom=min(groove_bottom, min(height for _, height in profile)) - FLOOR,
        pins=pins if mold.kind == "two-part" else (),
        pin_top=length,
    )
