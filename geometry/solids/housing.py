"""The housing of a microphone: a chamber with the ports of its lines, and a seat for the board with the package."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import cadquery as cq

from geometry.design.shell_rules import seat_underside
from geometry.ground.argument_checks import check_given
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import BOARD_SEAL, SEAT_SLOT, Microphone
from geometry.schema.ports import Port
from geometry.solids.round_solids import cylinder, one_solid
from geometry.solids.shell import cut_ports, refuse_thin_web


def build_housing(microphone: Microphone, printing: Printing, ports: Sequence[Port]) -> cq.Workplane:
    """Draw the housing: a cup around the chamber, its floor at z = 0, and on it the seat of the board.

    The board lies on the seat at the chamber's height and closes the chamber; the walls around it are as high
    as the package on it, so that both are potted. A slot towards -x lets the wires out. With a gasket, a groove
    for it surrounds the chamber. Ports are at mid height as in a shell; below the seat the tubes have free way.

    Raises:
        Refusal: no port, two that leave no wall between them, or the drawn housing is not one valid solid.
    """
    check_given("ports", ports, remedy="give a microphone housing at least one port")
    radius, wall, top = microphone.chamber_diameter / 2, microphone.wall_thickness, microphone.chamber_height
    for pair in combinations(ports, 2):
        refuse_thin_web("microphone housing", pair, (radius, radius), radius + printing.port_lip, printing.glue_gap)
    length, width = (side + 2 * microphone.board_gap for side in microphone.board_size)
    height = microphone.sound_hole_length + microphone.package_height
    outside = (length + 2 * wall, width + 2 * wall)
    hole = max(port.tube_diameter for port in ports) / 2 + printing.glue_gap
    head = _box(*outside, seat_underside(microphone, hole), top + height)
    out = length / 2 + wall
    slot = _box(out, SEAT_SLOT * width, top, top + height).moved(cq.Location(cq.Vector(-out / 2, 0, 0)))
    solid = cylinder(radius + wall, -wall, top).fuse(head)
    solid = solid.cut(_box(length, width, top, top + height), slot, cylinder(radius, 0, top))
    if microphone.gasket_width is not None:
        inner = radius + BOARD_SEAL
        ring = cylinder(inner + microphone.gasket_width, top - microphone.gasket_depth, top)
        solid = solid.cut(ring.cut(cylinder(inner, top - microphone.gasket_depth, top)))
    reach = max(radius + wall, sum(side**2 for side in outside) ** 0.5 / 2)
    return one_solid(cut_ports(solid, ports, printing, radius, reach, top / 2), "microphone housing")


def build_board(microphone: Microphone) -> cq.Workplane:
    """Draw the circuit board with the sound hole, its lower face at z = 0.

    It closes the chamber and carries the package.
    """
    board = _box(*microphone.board_size, 0, microphone.sound_hole_length)
    hole = cylinder(microphone.sound_hole_diameter / 2, 0, microphone.sound_hole_length)
    return one_solid(board.cut(hole), "microphone board")


def _box(length: float, width: float, bottom: float, top: float) -> cq.Solid:
    return cq.Solid.makeBox(length, width, top - bottom, cq.Vector(-length / 2, -width / 2, bottom))
