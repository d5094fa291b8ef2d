"""Parts of a mold as solids: the marked base with its lands and grooves; pins, lid and shims; rails and scraper."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

import cadquery as cq

from geometry.design.array_design import ArrayDesign
from geometry.molds.mold_forces import LID_THICKNESS, PRY_DEPTH, PRY_HEIGHT
from geometry.molds.mold_plan import CORNER, PLUG_PLATE, RAIL_WIDTH, SHIM_WIDTH, SOCKET_SPARE, MoldPlan
from geometry.solids.round_solids import cylinder, revolved
from geometry.solids.stroke_font import letters_within, text_bars, text_size

#: Depth of the mark, mm.
_MARK_DEPTH = 0.3
#: Heights of its letters that are tried, mm, and the width of their strokes per height: 0.5 mm, which all processes of
#: this package print, or 0.4 mm.
_LETTER_HEIGHTS, _STROKE = (3.0, 2.4), 1 / 6
#: Share of the block's width and depth that the mark may take.
_MARK_SHARE = 0.85
#: Chamfer of the tip of a pin, mm.
_PIN_CHAMFER = 0.3
#: Chamfer of an ejector hole where its pin enters, mm.
_LEAD_IN = 0.3
#: Notches in the rim of a shim: width and depth, mm, and the angle between them, degrees; ten go round.
_NOTCH, _NOTCH_TURN = (0.6, 0.4), 36.0
#: Flat of the blade, height of the scraper above the lands, width of its back and of its guides, mm.
_EDGE, _HEIGHT, _BACK, _GUIDE = 0.4, 8.0, 4.0, 2.0


def base_block(plan: MoldPlan) -> cq.Shape:
    """The block with a land around each cavity; between the lands it stays below the parting plane."""
    solid: cq.Shape = box(plan, plan.bottom, plan.gap)
    outer, (start, end) = plan.land[1], plan.groove
    top, depth = plan.gap, plan.gap - plan.groove_bottom
    narrowed = depth * plan.slope
    lands, pockets = [], []
    for centre in plan.centres:
        lands.append(revolved(((0, top), (start, top), (outer, 0), (0, 0)), centre))
        pockets.append(revolved(plan.profile, centre))
        floor = plan.groove_bottom
        groove = ((start, top), (start + narrowed, floor), (end - narrowed, floor), (end, top))
        pockets.append(revolved(groove, centre))
    if plan.mold.kind == "two-part":
        pockets += pry_slots(plan, top - PRY_HEIGHT, top)
    if plan.ejector:
        hole, wide = plan.ejector.hole, plan.ejector.hole + _LEAD_IN
        below, top = plan.bottom, plan.ejector.top + 1e-3
        section = ((0, below), (wide, below), (hole, below + _LEAD_IN), (hole, top), (0, top))
        pockets += [revolved(section, spot) for spot in plan.ejector_spots]
    return solid.fuse(*lands).cut(*pockets)


def box(plan: MoldPlan, bottom: float, top: float) -> cq.Solid:
    """A block over the whole mold between two heights, mm; a two-part mold lacks the corner that has no pin."""
    x, y = plan.half
    block = cq.Solid.makeBox(2 * x, 2 * y, top - bottom, cq.Vector(-x, -y, bottom))
    if plan.mold.kind != "two-part":
        return block
    (edge,) = (edge for edge in block.Edges() if edge.Center().x > x - 1e-6 and edge.Center().y < 1e-6 - y)
    return block.chamfer(CORNER, None, [edge])


def pry_slots(plan: MoldPlan, bottom: float, top: float) -> list[cq.Solid]:
    """Room for a flat blade in the middle of each side, between two heights, mm."""
    slots = []
    for along, width, turn in zip(plan.half, plan.slots, (0, 90), strict=True):
        slot = cq.Solid.makeBox(PRY_DEPTH, width, top - bottom, cq.Vector(along - PRY_DEPTH, -width / 2, bottom))
        slots += [slot.rotate(cq.Vector(), cq.Vector(0, 0, 1), turn + opposite) for opposite in (0, 180)]
    return slots


def plugs(plan: MoldPlan) -> cq.Shape:
    """The plate below the base whose pins close the ejector holes, flush with the floors of the cavities.

    Slots in two sides let a blade between the plate and the base.
    """
    pins = plan.ejector
    if pins is None:
        message = "the cavities are blind"
        raise AssertionError(message)
    low = plan.bottom - PLUG_PLATE
    stems = [cylinder(pins.radius, plan.bottom - PLUG_PLATE / 2, pins.top, spot) for spot in plan.ejector_spots]
    slots = pry_slots(plan, plan.bottom - PLUG_PLATE / 2, plan.bottom)
    return box(plan, low, plan.bottom).cut(*slots).fuse(*stems)


def mark_text(design: ArrayDesign) -> tuple[str, str]:
    """Thickness (mm) and material of the membrane as they are engraved."""
    material = design.membrane.material.removeprefix("silicone-").replace("shore-a-", "A").removeprefix("blend-")
    return f"{design.membrane.thickness:.3g}MM", re.sub(r"[^A-Z0-9.+-]", "", material.upper())


def mark(solid: cq.Shape, plan: MoldPlan, texts: Sequence[str]) -> cq.Shape:
    """Engrave texts into the lower face, to be read from below: the first one whole, of the others what has room."""
    low = solid.BoundingBox().zmin
    width, depth = (2 * _MARK_SHARE * half for half in plan.half)
    for height in _LETTER_HEIGHTS:
        longest, most = letters_within(width, depth, height)
        lines = [line for text in texts for line in textwrap.wrap(text, max(longest, len(texts[0])))]
        if len(lines) <= most and longest >= len(texts[0]):
            break
    lines = lines[: max(most, 1)]
    height *= min(1.0, width / text_size(lines, height)[0])
    bars = text_bars(lines, height, _STROKE * height, _MARK_DEPTH)
    # Turned over about the x axis: its front looks downwards.
    place = cq.Location(cq.Vector(0, 0, low + _MARK_DEPTH), cq.Vector(1, 0, 0), 180)
    return solid.cut(*(bar.moved(place) for bar in bars))


# -- two-part -------------------------------------------------------------------------------------
def with_pins(base: cq.Shape, plan: MoldPlan) -> cq.Shape:
    """The base with its registration pins, chamfered at the tip."""
    pins = []
    for spot in plan.pins:
        pin = cylinder(plan.mold.pin_diameter / 2, plan.gap - 0.5, plan.pin_top, spot)
        pins.append(pin.chamfer(_PIN_CHAMFER, None, pin.faces(">Z").Edges()))
    return base.fuse(*pins)


def lid(plan: MoldPlan) -> cq.Shape:
    """A plate that lies on the lands, with a socket per pin, two vents per cavity above its groove, and pry slots.

    Through sockets trap nothing while printing, and the halves can be pushed apart in them.
    """
    through = plan.mold.sockets == "through"
    roof = LID_THICKNESS if through else plan.pin_top + SOCKET_SPARE
    holes = [cylinder(plan.socket_radius, 0, roof, spot) for spot in plan.pins]
    aside = sum(plan.groove) / 2
    for x, y in plan.centres:
        for side in (-1, 1):
            holes.append(cylinder(plan.mold.vent_diameter / 2, 0, LID_THICKNESS, (x + side * aside, y)))
    return box(plan, 0, LID_THICKNESS).cut(*holes, *pry_slots(plan, 0, PRY_HEIGHT))


def shim(plan: MoldPlan, step: int) -> cq.Shape:
    """A washer over a pin that holds the lid ``step`` steps above the lands; its lower face at z = 0.

    It has as many notches in its rim as steps: sets a few hundredths of a millimetre apart look alike.
    """
    height, radius = plan.mold.land_height + step * plan.mold.shim_step, plan.socket_radius + SHIM_WIDTH
    width, depth = _NOTCH
    notch = cq.Solid.makeBox(2 * depth, width, height, cq.Vector(radius - depth, -width / 2, 0))
    turns = [cq.Location(cq.Vector(), cq.Vector(0, 0, 1), _NOTCH_TURN * number) for number in range(step)]
    return cylinder(radius, 0, height).cut(cylinder(plan.socket_radius, 0, height), *(notch.moved(t) for t in turns))


# -- open-face ------------------------------------------------------------------------------------
def with_rails(base: cq.Shape, plan: MoldPlan) -> cq.Shape:
    """The base with a rail as high as the lands along both long sides: the blade never tips."""
    x, y = plan.half
    corners = (-y, y - RAIL_WIDTH)
    rails = [cq.Solid.makeBox(2 * x, RAIL_WIDTH, -plan.gap, cq.Vector(-x, corner, plan.gap)) for corner in corners]
    return base.fuse(*rails)


def scraper(plan: MoldPlan) -> cq.Shape:
    """A blade across the mold with a guide at each end, as it stands over the middle: the edge at z = 0.

    It is pushed along x; the silicone is drawn off at the height of the lands.
    """
    inside = plan.half[1] + plan.mold.pin_clearance
    outside = inside + _GUIDE
    slant = (_BACK - _EDGE) / 2
    section = [(-_EDGE / 2, 0.0), (_EDGE / 2, 0.0), (_BACK / 2, slant), (_BACK / 2, _HEIGHT)]
    section += [(-x, z) for x, z in reversed(section[2:])]
    outline = cq.Wire.makePolygon([cq.Vector(x, -outside, z) for x, z in section], close=True)
    solid: cq.Shape = cq.Solid.extrudeLinear(outline, [], cq.Vector(0, 2 * outside, 0))
    low = plan.bottom / 2
    guides = [
        cq.Solid.makeBox(_BACK, _GUIDE, _HEIGHT - low, cq.Vector(-_BACK / 2, corner, low))
        for corner in (-outside, inside)
    ]
    return solid.fuse(*guides)
