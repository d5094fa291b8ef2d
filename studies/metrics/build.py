"""Volume, mass, cost and thinnest wall of a design from its fields alone, microseconds each. Lengths in mm.

Parts are counted as closed forms: cylinders less their cavities, bores and sockets. Prices are those of the bill of
materials; densities that a design file does not state are data here, each with its source.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

from geometry.assembly.bill import Waste
from geometry.boards.board_plan import shown_board
from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import seat_underside
from geometry.schema.part_fields import BOARD_SEAL, SEAT_SLOT, Microphone, Tube
from geometry.stock import Found, catalogue

#: kg/m^3
DENSITIES = {
    "wire": (7900.0, "stainless steel"),
    "sheath": (950.0, "polyethylene, polyurethane 1100: assumed"),
    "boards": (1850.0, "glass-fibre epoxy laminate"),
}
#: Name -> volume of all such parts, mm^3, and density, kg/m^3.
Volumes = dict[str, tuple[float, float]]
MICROPHONE_MASS = (0.025, "g, a MEMS package of 3.5 x 2.65 x 1 mm: assumed")


def volume(design: ArrayDesign, parts: Volumes | None = None) -> float:
    """Volume of shells, housings, boards, membranes and tubes, without the air in them, mm^3.

    Here and below ``parts`` are those of :func:`volumes_of`, where they are known already.
    """
    return sum(part for part, _ in (parts or volumes_of(design)).values())


def mass(design: ArrayDesign, parts: Volumes | None = None) -> float:
    """Mass of all parts and the microphones, g."""
    own = sum(part * density * 1e-6 for part, density in (parts or volumes_of(design)).values())
    return own + len(design.microphones) * MICROPHONE_MASS[0]


def cost(design: ArrayDesign, parts: Volumes | None = None) -> float:
    """Cost of one array without its molds, as :func:`geometry.bill_of_materials` has it, USD."""
    volumes, waste, sold = parts or volumes_of(design), Waste(), catalogue()
    microphones, resin = len(design.microphones), volumes["shells"][0] + volumes["housings"][0]
    sealed = design.microphone.gasket_width is not None
    joints = {"tube": 0, "membrane": design.point_count, "board": 0 if sealed else microphones}
    total = _price(sold.resin(design)) * waste.resin_factor * resin / 1e3
    total += _price(sold.silicone(design)) * waste.silicone_factor * volumes["membranes"][0] / 1e3
    for tube, count in _tubes(design):
        # As if no spring were bent: the bends are not worth a layout.
        length = count * (tube.length - 2 * design.printing.port_lip + waste.cutting_loss)
        total += (_price(sold.spring(tube)) + _price(sold.sheath(tube))) * length / 1e3
        joints["tube"] += 2 * count
    pieces = [sold.microphone_part(design.microphone), sold.sundry("microphone-board")]
    pieces += [sold.sundry("gasket")] if sealed else []
    total += microphones * sum(map(_price, pieces))
    for joint, number in joints.items():
        for glue in sold.glues(joint)[:1]:
            total += number * glue.joint_volume * glue.price
    return total


def _price(found: Found | None) -> float:
    return 0.0 if found is None or found.part is None else found.part.price


def smallest_wall(design: ArrayDesign) -> float:
    """Thinnest printed wall, mm: of shells and housings, floors, lips, and what covers a tube's socket."""
    return min(_walls(design))


def _walls(design: ArrayDesign) -> Iterator[float]:
    resonator, microphone, printing = design.resonator, design.microphone, design.printing
    yield from (resonator.wall_thickness, resonator.floor_thickness, microphone.wall_thickness, printing.port_lip)
    lowest = min(design.of_kind(kind).resonator.cavity_height for kind in design.kinds)
    for tube, _ in _tubes(design):
        hole = tube.outer_diameter / 2 + printing.glue_gap
        yield resonator.port_axis_height + resonator.floor_thickness - hole
        yield lowest - resonator.port_axis_height - hole
    holes = [design.microphone_tube_of(line).outer_diameter / 2 + printing.glue_gap for line in design.lines]
    underside = seat_underside(microphone, max(holes))
    for hole in holes:
        socket = microphone.chamber_height / 2 - hole
        yield socket + microphone.wall_thickness
        yield socket
        if socket > underside:  # outside the chamber's wall the seat is all that is below the socket
            yield socket - underside


def volumes_of(design: ArrayDesign) -> Volumes:
    """Name -> volume of all such parts, mm^3, and density, kg/m^3."""
    resonator, microphone, membrane = design.resonator, design.microphone, design.membrane
    resin = design.material(design.printing.material).density
    silicone = design.material(membrane.material).density
    sockets_of_shells = sockets_of_housings = 0.0
    for line in design.lines:
        outer = design.microphone_tube_of(line)
        wall = resonator.wall_thickness
        for inner, count in design.segment_counts_of(line):
            sockets_of_shells += 2 * count * _port(design, inner, wall)
        sockets_of_shells += 2 * _port(design, outer, wall)
        sockets_of_housings += 2 * _port(design, outer, microphone.wall_thickness)
    shells = discs = 0.0
    for kind, count in Counter(design.kind_of_point).items():
        alike = design.of_kind(design.kinds[kind])
        own = _disc(resonator.outer_diameter, resonator.floor_thickness + alike.resonator.cavity_height)
        shells += count * (own - alike.resonator.cavity_volume)
        width = resonator.cavity_diameter + 2 * membrane.rim_width
        discs += count * _disc(width, alike.membrane.mounted_thickness)
    wire = sheath = 0.0
    for tube, count in _tubes(design):
        turns = math.pi / 4 * (tube.spring_outer_diameter**2 - tube.inner_diameter**2)
        wire += count * tube.length * turns * math.pi / 4  # a close-wound round wire fills pi/4 of its ring
        sheath += count * tube.length * math.pi / 4 * (tube.outer_diameter**2 - tube.spring_outer_diameter**2)
    return {
        "shells": (shells - sockets_of_shells, resin),
        "housings": (len(design.microphones) * _housing(microphone) - sockets_of_housings, resin),
        "boards": (len(design.microphones) * _board(design), DENSITIES["boards"][0]),
        "membranes": (discs, silicone),
        "wire": (wire, DENSITIES["wire"][0]),
        "sheath": (sheath, DENSITIES["sheath"][0]),
    }


def _housing(microphone: Microphone) -> float:
    """The cup with the seat of its board, mm^3."""
    radius, wall, top = microphone.chamber_diameter / 2, microphone.wall_thickness, microphone.chamber_height
    length, width = _seat(microphone)
    along, across = length / 2 + wall, width / 2 + wall
    gasket = microphone.gasket_depth if microphone.gasket_width is not None else 0.0
    height, underside = microphone.sound_hole_length + microphone.package_height, max(top - wall - gasket, 0.0)
    footprint = 4 * along * across + 2 * _segment(radius + wall, along) + 2 * _segment(radius + wall, across)
    cup = _disc(2 * (radius + wall), wall + underside) + footprint * (top - underside) - microphone.chamber_volume
    rim = (4 * along * across - length * width - wall * SEAT_SLOT * width) * height
    if microphone.gasket_width is not None:
        inner = microphone.chamber_diameter + 2 * BOARD_SEAL
        cup -= _disc(inner + 2 * microphone.gasket_width, gasket) - _disc(inner, gasket)
    return cup + rim


def _board(design: ArrayDesign) -> float:
    """The whole board, or what lies in the seat where the solids show no more, mm^3."""
    plan, microphone = shown_board(design), design.microphone
    if plan is not None:
        return plan.volume
    length, width = microphone.board_size
    return length * width * microphone.sound_hole_length - _disc(
        microphone.sound_hole_diameter, microphone.sound_hole_length
    )


def _seat(microphone: Microphone) -> tuple[float, float]:
    """Length and width of the seat of the board, mm."""
    length, width = microphone.board_size
    return length + 2 * microphone.board_gap, width + 2 * microphone.board_gap


def _segment(radius: float, distance: float) -> float:
    """Area of a disc beyond a line at a distance from its middle, mm^2."""
    if distance >= radius:
        return 0.0
    return radius**2 * math.acos(distance / radius) - distance * math.sqrt(radius**2 - distance**2)


def _port(design: ArrayDesign, tube: Tube, wall: float) -> float:
    """Volume that a bore and its socket take out of the wall of a round housing, mm^3."""
    lip = min(design.printing.port_lip, wall)
    socket = _disc(tube.outer_diameter + 2 * design.printing.glue_gap, wall - lip)
    return _disc(tube.inner_diameter, lip) + socket


def _tubes(design: ArrayDesign) -> Iterator[tuple[Tube, int]]:
    for line in design.lines:
        yield from Counter(design.end_tube_of(line, end) for end in (0, 1)).items()
        yield from design.segment_counts_of(line)


def _disc(diameter: float, height: float) -> float:
    return math.pi / 4 * diameter**2 * height
