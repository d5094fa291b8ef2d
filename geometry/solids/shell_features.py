"""Features of a shell beside its cavity: a glue groove, mounting feet and its number. Lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Sequence

import cadquery as cq

from geometry.design.shell_rules import FOOT_EDGE
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.field_errors import conflict
from geometry.schema.part_fields import Shell
from geometry.schema.ports import foot_directions, largest_gap
from geometry.solids.stroke_font import SPACE, WIDTH, strokes

#: Width of a digit's strokes in its heights: as wide as the gap between the two sides of a 0.
_STROKE = WIDTH / 3
#: Wall between an engraved digit and a socket, mm.
_BESIDE = 0.1
#: Largest height of digits that is chosen, and the smallest that is drawn.
_USUAL_DIGITS, _SMALLEST_DIGITS = 3.0, 0.5
#: Widest label in diameters of the shell: further round the wall digits would be seen from the side.
_WIDEST_LABEL = 0.6


def add_feet(
    solid: cq.Shape, outer_radius: float, floor_thickness: float, ports: Sequence[float], features: Shell
) -> cq.Shape:
    """Fuse mounting feet to the floor, each in the middle of the widest gap that ports and feet leave.

    Args:
        solid: the shell, its floor from -floor_thickness to 0.
        outer_radius: of the shell.
        floor_thickness: of the shell and of the feet.
        ports: directions of the ports, degrees.
        features: number and sizes of the feet.
    """
    half = features.foot_hole / 2 + FOOT_EDGE
    end = outer_radius + features.foot_length - half
    for angle in foot_directions(ports, features.feet):
        foot: cq.Shape = cq.Solid.makeBox(end, 2 * half, floor_thickness, cq.Vector(0, -half, -floor_thickness))
        tip, low = cq.Vector(end, 0, -floor_thickness), cq.Vector(end, 0, -2 * floor_thickness)
        foot = foot.fuse(cq.Solid.makeCylinder(half, floor_thickness, tip))
        foot = foot.cut(cq.Solid.makeCylinder(features.foot_hole / 2, 3 * floor_thickness, low))
        solid = solid.fuse(foot.rotate(cq.Vector(0, 0, 0), cq.Vector(0, 0, 1), angle))
    return solid.clean()


def cut_groove(solid: cq.Shape, middle: float, top: float, features: Shell) -> cq.Shape:
    """Cut the glue groove into the seat at that height, around the circle of that radius."""
    half = (features.groove_width or 0.0) / 2
    low, height = cq.Vector(0, 0, top - features.groove_depth), 2 * features.groove_depth
    ring = cq.Solid.makeCylinder(middle + half, height, low).cut(cq.Solid.makeCylinder(middle - half, height, low))
    return solid.cut(ring)


def add_label(
    solid: cq.Shape,
    text: str,
    outer_radius: float,
    wall: float,
    span: tuple[float, float],
    ports: Sequence[tuple[float, float]],
    features: Shell,
) -> cq.Shape:
    """Raise or engrave digits on the round wall, in the middle of the span and of the widest gap between ports.

    Args:
        solid: the shell.
        text: one to four digits.
        outer_radius: of the shell.
        wall: its radial thickness.
        span: lower and upper end of the wall, mm.
        ports: per port its direction (degrees) and the radius of its socket.
        features: kind, height and relief of the digits.

    Raises:
        Refusal: the text is not a number, or it does not fit.
    """
    if not (text.isascii() and text.isdigit() and len(text) <= 4):
        raise Refusal(kind=Kind.WRONG_TYPE, field="label", value=text, allowed="one to four digits")
    angle, gap = largest_gap([port for port, _ in ports])
    socket, bottom_radius = max(radius for _, radius in ports), outer_radius
    if features.label == "engraved":  # towards its bottom a digit covers more of the way round to the sockets
        socket, bottom_radius = socket + _BESIDE, outer_radius - features.label_relief
    free = math.radians(gap / 2) - math.asin(min(socket / bottom_radius, 1.0))
    widest = min(_WIDEST_LABEL * 2 * outer_radius, 2 * bottom_radius * math.sin(min(max(free, 0.0), math.pi / 2)))
    width = len(text) * WIDTH + (len(text) - 1) * SPACE
    room = min(0.8 * (span[1] - span[0]), widest / width)
    height = min(_USUAL_DIGITS, room) if features.label_height is None else features.label_height
    if height > room + 1e-9 or height < _SMALLEST_DIGITS:
        allowed = f"{_SMALLEST_DIGITS:g} to {room:.3g} mm for {text!r} to fit on the wall"
        raise conflict("shell.label_height", round(height, 3), allowed)
    if features.label == "engraved" and features.label_relief > wall / 3:
        allowed = f"at most {wall / 3:g} mm, a third of resonator.wall_thickness, where digits are engraved"
        raise conflict("shell.label_relief", features.label_relief, allowed)
    raised = features.label == "raised"
    rim = outer_radius + features.label_relief if raised else outer_radius + 1.0
    root = outer_radius - (min(0.05, wall / 4) if raised else features.label_relief)
    low, tall = cq.Vector(0, 0, span[0]), span[1] - span[0]
    skin = cq.Solid.makeCylinder(rim, tall, low).cut(cq.Solid.makeCylinder(root, tall, low))
    bottom, left = (span[0] + span[1] - height) / 2, -width * height / 2
    bars = [
        bar
        for place, digit in enumerate(text)
        for bar in _strokes(digit, left + place * (WIDTH + SPACE) * height, bottom, height, rim)
    ]
    digits = [bar.intersect(skin).rotate(cq.Vector(0, 0, 0), cq.Vector(0, 0, 1), angle) for bar in bars]
    return (solid.fuse(*digits) if raised else solid.cut(*digits)).clean()


def _strokes(digit: str, left: float, bottom: float, height: float, depth: float) -> list[cq.Solid]:
    """The strokes of a digit as bars along x from the axis outwards, read from outside: y to the right, z up."""
    thick = _STROKE * height
    wide, tall = WIDTH * height - thick, height - thick
    bars = []
    for ends in strokes(digit):
        (x0, z0), (x1, z1) = sorted(ends)
        low, high = sorted((z0, z1))
        corner = cq.Vector(0, left + x0 * wide, bottom + low * tall)
        bars.append(cq.Solid.makeBox(2 * depth, (x1 - x0) * wide + thick, (high - low) * tall + thick, corner))
    return bars
