"""The two-part casting mold of the membrane.

The base holds the cavity, open at the parting plane z = membrane thickness; the lid's flat face closes it.
What is poured too much flows over a narrow land into a groove and out of vents in the lid. No draft: the
cavity is exactly the disc, and soft silicone is peeled out.
"""

from __future__ import annotations

from dataclasses import dataclass

import cadquery as cq

from geometry.design import Membrane, Resonator
from geometry.membrane import membrane_radius
from geometry.shell import cylinder, one_solid

_LAND = 0.6  # between cavity and groove: narrow, so that flash is thin
_GROOVE_WIDTH, _GROOVE_DEPTH = 1.2, 0.8
_PIN_DIAMETER, _PIN_CLEARANCE = 2.5, 0.1
_VENT_DIAMETER = 1.0
_MARGIN = 1.5  # around grooves, pins and below the cavity: stiff enough to be clamped
_LID_THICKNESS = 2.5


@dataclass(frozen=True)
class Mold:
    """Both halves as they lie when closed: the membrane's lower face at z = 0, its axis z."""

    base: cq.Workplane
    lid: cq.Workplane


def build_mold(resonator: Resonator, membrane: Membrane) -> Mold:
    """Draw the mold of a design's membrane.

    Raises:
        ValueError: a half is not one valid solid.
    """
    radius, parting = membrane_radius(resonator, membrane), membrane.thickness
    groove = (radius + _LAND, radius + _LAND + _GROOVE_WIDTH)
    # Pins on three corners of the block: the lid fits in one way only.
    pin_at = (groove[1] + _MARGIN / 2 + _PIN_DIAMETER / 2) / 2**0.5
    corners = [(pin_at, pin_at), (-pin_at, pin_at), (-pin_at, -pin_at)]
    half = max(groove[1], pin_at + _PIN_DIAMETER / 2) + _MARGIN
    floor, pin_top = -max(_MARGIN, _GROOVE_DEPTH + _MARGIN - parting), parting + _LID_THICKNESS - 0.5

    base = _block(half, floor, parting).cut(cylinder(radius, 0, parting))
    ring = cylinder(groove[1], parting - _GROOVE_DEPTH, parting)
    base = base.cut(ring.cut(cylinder(groove[0], parting - _GROOVE_DEPTH, parting)))
    for corner in corners:
        pin = cylinder(_PIN_DIAMETER / 2, floor, pin_top, corner)
        top = pin.faces(">Z").Edges()
        base = base.fuse(pin.chamfer(0.3, None, top))

    lid = _block(half, parting, parting + _LID_THICKNESS)
    for corner in corners:
        # Through holes: nothing is trapped while printing, and the halves can be pushed apart.
        lid = lid.cut(cylinder(_PIN_DIAMETER / 2 + _PIN_CLEARANCE, parting, parting + _LID_THICKNESS, corner))
    for side in (-1, 1):
        vent = (side * (groove[0] + groove[1]) / 2, 0.0)
        lid = lid.cut(cylinder(_VENT_DIAMETER / 2, parting, parting + _LID_THICKNESS, vent))
    return Mold(one_solid(base, "mold-base"), one_solid(lid, "mold-lid"))


def _block(half: float, bottom: float, top: float) -> cq.Shape:
    return cq.Solid.makeBox(2 * half, 2 * half, top - bottom, cq.Vector(-half, -half, bottom))
