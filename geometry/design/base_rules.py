"""Rules between the base plate and the rest of a design; what depends on the layout is refused when it is planned."""

from __future__ import annotations

from collections.abc import Iterator

from geometry.ground.refusal import Refusal
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import conflict

#: Layouts whose parts stand on one plane.
_FLAT = ("serpentine", "ring", "area", "hand", "places")
#: Free height between the rim of a seat and the tubes above it, mm.
_BELOW_TUBES = 0.1


def base_rules(design: StatedArray) -> Iterator[Refusal]:
    """Seats that reach up to the tubes, and layouts that do not stand on one plane."""
    base = design.base
    if base.kind == "none":
        return
    if design.layout.kind not in _FLAT:
        yield conflict("base.kind", base.kind, f"'none' for layout.kind = {design.layout.kind!r}", unit="")
    if design.layout.microphone_side == "below":
        yield conflict("base.kind", base.kind, "'none' for layout.microphone_side = 'below'", unit="")
    widest = max(tube.outer_diameter for _, tube, _ in design.stated_tubes()) / 2
    axis, microphone = design.resonator.port_axis_height, design.microphone
    shells = axis - widest + design.resonator.floor_thickness
    housings = microphone.chamber_height / 2 - widest + microphone.wall_thickness
    deepest = min(shells, housings) - _BELOW_TUBES
    if base.seat_depth > deepest + 1e-9:
        yield conflict("base.seat_depth", base.seat_depth, f"at most {deepest:.4g} mm, below the lowest tube")
