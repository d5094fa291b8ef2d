"""The two-part mold: pins on the base, a lid with sockets and vents, and shims that raise the lid."""

from __future__ import annotations

import cadquery as cq

from geometry.molds.base import box
from geometry.molds.plan import LID_THICKNESS, SHIM_WIDTH, SOCKET_SPARE, MoldPlan
from geometry.solids.bodies import cylinder

_PIN_CHAMFER = 0.3
#: Notches in the rim of a shim: width and depth, mm, and the angle between them, degrees; ten go round.
_NOTCH, _NOTCH_TURN = (0.6, 0.4), 36.0


def with_pins(base: cq.Shape, plan: MoldPlan) -> cq.Shape:
    """The base with its registration pins, chamfered at the tip."""
    pins = []
    for spot in plan.pins:
        pin = cylinder(plan.mold.pin_diameter / 2, plan.gap - 0.5, plan.pin_top, spot)
        pins.append(pin.chamfer(_PIN_CHAMFER, None, pin.faces(">Z").Edges()))
    return base.fuse(*pins)


def lid(plan: MoldPlan) -> cq.Shape:
    """A plate that lies on the lands, with a socket per pin and two vents per cavity above its groove.

    Through sockets trap nothing while printing, and the halves can be pushed apart in them.
    """
    through = plan.mold.sockets == "through"
    roof = LID_THICKNESS if through else plan.pin_top + SOCKET_SPARE
    holes = [cylinder(plan.socket_radius, 0, roof, spot) for spot in plan.pins]
    aside = sum(plan.groove) / 2
    for x, y in plan.centres:
        for side in (-1, 1):
            holes.append(cylinder(plan.mold.vent_diameter / 2, 0, LID_THICKNESS, (x + side * aside, y)))
    return box(plan, 0, LID_THICKNESS).cut(*holes)


def shim(plan: MoldPlan, step: int) -> cq.Shape:
    """A washer over a pin that holds the lid ``step`` steps above the lands; its lower face at z = 0.

    It has as many notches in its rim as steps: sets a few hundredths of a millimetre apart look alike.
    """
    height, radius = plan.mold.land_height + step * plan.mold.shim_step, plan.socket_radius + SHIM_WIDTH
    width, depth = _NOTCH
    notch = cq.Solid.makeBox(2 * depth, width, height, cq.Vector(radius - depth, -width / 2, 0))
    turns = [cq.Location(cq.Vector(), cq.Vector(0, 0, 1), _NOTCH_TURN * number) for number in range(step)]
    return cylinder(radius, 0, height).cut(cylinder(plan.socket_radius, 0, height), *(notch.moved(t) for t in turns))
