"""The base plate: seats, saddles of tubes, numbers, holes, and the pieces that it is printed in. Lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import cadquery as cq
import numpy as np

from geometry.solids.round_solids import one_solid
from geometry.solids.stroke_font import text_bars

#: Wall of a seat or a saddle that stands above the plate.
RIM = 1.0
#: Corners of the plate are rounded to this radius; marks are so deep, their strokes this part of their height wide.
_CORNER, _MARK, _STROKE = 2.0, 0.4, 0.16
#: How far a saddle goes beyond the axis of its tube, in radii: the tube is pressed in and stays.
_CLASP = 0.3
#: Dovetails: width at the neck and at the head, depth.
NECK, HEAD, DEPTH = 3.4, 5.0, 4.0
#: Pieces of less than this are the rounding of a cut, mm^3.
_NOTHING = 1e-3
#: Beyond all of a plate.
_FAR = 1e4

Corner = tuple[float, float]
#: Axis across which a plate is cut.
Across = Literal["x", "y"]


@dataclass(frozen=True)
class Seat:
    """A round pocket for a shell or a housing, with arms for the feet of a shell."""

    place: Corner
    """Its axis."""
    radius: float
    """Radius of what stands in it."""
    bottom: float
    """Height of its floor."""
    top: float
    """Height of its rim."""
    feet: tuple[float, ...] = ()
    """Directions of the feet, degrees."""
    foot_reach: float = 0.0
    """Distance of the screw of a foot from the axis."""
    foot_half: float = 0.0
    """Half of the width of a foot."""
    foot_hole: float = 0.0
    """Diameter of the screw hole."""


@dataclass(frozen=True)
class Saddle:
    """A block with a channel for a tube."""

    name: str
    """Name of the tube."""
    place: Corner
    """Middle of it."""
    angle: float
    """Direction of the tube, degrees."""
    radius: float
    """Radius of the channel."""
    height: float
    """Height of the tube's axis."""
    length: float
    """Length along the tube."""


@dataclass(frozen=True)
class Mark:
    """A number or a name engraved beside its place."""

    text: str
    """Letters of :func:`geometry.solids.stroke_font.strokes`."""
    place: Corner
    """Middle of it."""
    height: float
    """Height of a letter."""


@dataclass(frozen=True)
class Cut:
    """A straight cut with dovetails."""

    across: Across
    """Coordinate that is constant on it."""
    at: float
    """That coordinate."""
    tabs: tuple[float, ...]
    """Middles of the dovetails along it; they reach towards higher coordinates."""


@dataclass(frozen=True)
class BasePlate:
    """Everything that a base plate is drawn from."""

    low: Corner
    """Corner of the plate."""
    high: Corner
    """Opposite corner."""
    bottom: float
    """Height of its lower face."""
    top: float
    """Height of its upper face."""
    fit: float
    """Gap around what stands in a seat, and between pieces."""
    seats: tuple[Seat, ...]
    """Seats of shells, then of microphones."""
    saddles: tuple[Saddle, ...]
    """Saddles of tubes."""
    marks: tuple[Mark, ...]
    """Numbers of points and names of microphones."""
    holes: tuple[Corner, ...]
    """Axes of the screw holes."""
    hole: float
    """Diameter of the screw holes."""
    slots: tuple[tuple[Corner, Corner], ...]
    """Opposite corners of the slots of a strap."""
    cuts: tuple[Cut, ...]
    """Cuts into pieces, those across x first."""


def draw_base(plan: BasePlate) -> tuple[cq.Workplane, ...]:
    """Pieces of a base plate, in the coordinates of the array, from the lowest x and y on.

    Raises:
        Refusal: a piece is not one valid solid.
    """
    (x0, y0), (x1, y1) = plan.low, plan.high
    blank = cq.Workplane().box(x1 - x0, y1 - y0, plan.top - plan.bottom, centered=False).edges("|Z").fillet(_CORNER)
    solid: cq.Shape = blank.val().translate(cq.Vector(x0, y0, plan.bottom))
    raised = [_pedestal(plan, seat) for seat in plan.seats if max(seat.top, seat.bottom) > plan.top + 1e-9]
    blocks = [_turned(_block(plan, saddle), saddle) for saddle in plan.saddles]
    if raised or blocks:
        solid = solid.fuse(*raised, *blocks)
    solid = solid.cut(
        *(tool for seat in plan.seats for tool in _pocket(plan, seat)),
        *(_turned(_channel(saddle), saddle) for saddle in plan.saddles),
        *(_pin(place, plan.hole / 2, plan.bottom - 1, plan.top + 1) for place in plan.holes),
        *(_slot(plan, *corners) for corners in plan.slots),
    )
    bars = [
        bar.translate(cq.Vector(*mark.place, plan.top - _MARK))
        for mark in plan.marks
        for bar in text_bars([mark.text], mark.height, _STROKE * mark.height, 2 * _MARK)
    ]
    if bars:
        solid = solid.cut(*bars)
    pieces = [solid]
    for cut in plan.cuts:
        tongue, groove = _side(cut, 0.0), _side(cut, plan.fit)
        divided = [(piece.intersect(tongue), piece.cut(groove)) for piece in pieces]
        pieces = [half for both in divided for half in both if half.Volume() > _NOTHING]
    return tuple(one_solid(piece.clean(), "base") for piece in pieces)


def _pin(place: Corner, radius: float, low: float, high: float) -> cq.Solid:
    return cq.Solid.makeCylinder(radius, high - low, cq.Vector(*place, low))


def _pedestal(plan: BasePlate, seat: Seat) -> cq.Solid:
    return _pin(seat.place, seat.radius + plan.fit + RIM, plan.bottom, max(seat.top, seat.bottom))


def _pocket(plan: BasePlate, seat: Seat) -> list[cq.Shape]:
    """The room of a shell with its feet, up to all above it, and the screws of its feet."""
    above = seat.top + 50.0
    tools: list[cq.Shape] = [_pin(seat.place, seat.radius + plan.fit, seat.bottom, above)]
    half = seat.foot_half + plan.fit
    for angle in seat.feet:
        turned = math.radians(angle)
        tip = (
            seat.place[0] + seat.foot_reach * math.cos(turned),
            seat.place[1] + seat.foot_reach * math.sin(turned),
        )
        arm = cq.Solid.makeBox(seat.foot_reach, 2 * half, above - seat.bottom, cq.Vector(0, -half, 0))
        arm = arm.rotate(cq.Vector(), cq.Vector(0, 0, 1), angle)
        tools.append(arm.translate(cq.Vector(*seat.place, seat.bottom)))
        tools += [_pin(tip, half, seat.bottom, above), _pin(tip, seat.foot_hole / 2, plan.bottom - 1, above)]
    return tools


def _turned(shape: cq.Shape, saddle: Saddle) -> cq.Shape:
    return shape.rotate(cq.Vector(), cq.Vector(0, 0, 1), saddle.angle).translate(cq.Vector(*saddle.place, 0))


def _block(plan: BasePlate, saddle: Saddle) -> cq.Shape:
    half, low = saddle.radius + RIM, (plan.bottom + plan.top) / 2
    height = saddle.height + _CLASP * saddle.radius - low
    return cq.Solid.makeBox(saddle.length, 2 * half, height, cq.Vector(-saddle.length / 2, -half, low))


def _channel(saddle: Saddle) -> cq.Shape:
    """The channel, open upwards by a little less than the tube is wide."""
    length, axis = saddle.length + 2 * RIM, cq.Vector(1, 0, 0)
    return cq.Solid.makeCylinder(saddle.radius, length, cq.Vector(-length / 2, 0, saddle.height), axis)


def _slot(plan: BasePlate, low: Corner, high: Corner) -> cq.Shape:
    size = (high[0] - low[0], high[1] - low[1], plan.top - plan.bottom + 2)
    return cq.Solid.makeBox(*size, cq.Vector(*low, plan.bottom - 1))


def _side(cut: Cut, gap: float) -> cq.Shape:
    """The side of a cut with lower coordinates and its dovetails, wider by a gap, as a body of all heights."""
    import manifold3d

    outline: list[Corner] = [(-_FAR, -_FAR), (cut.at, -_FAR)]
    for middle in sorted(cut.tabs):
        outline += [
            *((cut.at, middle - NECK / 2), (cut.at + DEPTH, middle - HEAD / 2)),
            *((cut.at + DEPTH, middle + HEAD / 2), (cut.at, middle + NECK / 2)),
        ]
    outline += [(cut.at, _FAR), (-_FAR, _FAR)]
    section = manifold3d.CrossSection([np.array(outline)])
    if gap:
        section = section.offset(gap, manifold3d.JoinType.Miter, 4.0)
    corners: Sequence[Corner] = [(float(x), float(y)) for x, y in section.to_polygons()[0]]
    if cut.across == "y":
        corners = [(y, x) for x, y in corners]
    body = cq.Workplane().polyline(list(corners)).close().extrude(2000.0)
    return body.val().translate(cq.Vector(0, 0, -1000.0))
