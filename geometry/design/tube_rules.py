"""Rules of tubes: what they need in themselves and of the parts at their ends."""

from __future__ import annotations

import math
from collections.abc import Iterator

from geometry.ground.refusal import Refusal, counted
from geometry.plan import area, hand, ring
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import conflict
from geometry.schema.part_fields import SOCKET_COVER, STUB_LENGTH_IN_RADII
from geometry.schema.ports import least_angle


def tube_rules(design: StatedArray) -> Iterator[Refusal]:
    """Problems of a tube in itself and with the parts at its ends."""
    resonator, chamber, lip = design.resonator, design.microphone, design.printing.port_lip
    for field, tube, to_microphone in design.stated_tubes():
        if tube.inner_diameter >= tube.outer_diameter:
            yield conflict(
                f"{field}.inner_diameter",
                tube.inner_diameter,
                f"below {field}.outer_diameter ({tube.outer_diameter:g} mm)",
            )
        if tube.spring_outer_diameter > tube.outer_diameter + 1e-9:
            yield conflict(
                f"{field}.wire_diameter",
                tube.wire_diameter,
                f"at most {(tube.outer_diameter - tube.inner_diameter) / 2:g} mm, the wall between bore and outside",
            )
        if tube.outer_diameter > resonator.cavity_height:
            yield conflict(
                f"{field}.outer_diameter",
                tube.outer_diameter,
                f"at most resonator.cavity_height ({resonator.cavity_height:g} mm)",
            )
        if tube.inner_diameter > resonator.cavity_diameter / 2:
            yield conflict(
                f"{field}.inner_diameter",
                tube.inner_diameter,
                f"at most half of resonator.cavity_diameter ({resonator.cavity_diameter / 2:g} mm)",
            )
        if to_microphone and tube.inner_diameter > chamber.chamber_diameter / 2:
            yield conflict(
                f"{field}.inner_diameter",
                tube.inner_diameter,
                f"at most half of microphone.chamber_diameter ({chamber.chamber_diameter / 2:g} mm)",
            )
        if tube.length < (stubs := STUB_LENGTH_IN_RADII * tube.inner_diameter):
            yield conflict(
                f"{field}.length",
                tube.length,
                f"at least {stubs:g} mm, 8 bore radii: shorter tubes have no plane-wave part",
            )
        walls = resonator.wall_thickness + (chamber if to_microphone else resonator).wall_thickness
        if tube.length <= walls:
            yield conflict(f"{field}.length", tube.length, f"above {walls:g} mm, the two walls it passes through")
        if tube.length <= 2 * lip:
            yield conflict(f"{field}.length", tube.length, f"above {2 * lip:g} mm, the lips of its two ports")


def socket_rules(design: StatedArray) -> Iterator[Refusal]:
    """Tubes are glued in sockets: counterbores that leave a lip towards the air."""
    resonator, chamber, printing = design.resonator, design.microphone, design.printing
    for field, tube, to_microphone in design.stated_tubes():
        hole = tube.outer_diameter / 2 + printing.glue_gap
        bore = tube.inner_diameter / 2
        lowest = max(bore, hole + SOCKET_COVER - resonator.floor_thickness)
        highest = resonator.cavity_height - hole - SOCKET_COVER
        if highest < lowest:
            widest = 2 * (resonator.cavity_height - bore - printing.glue_gap - SOCKET_COVER)
            yield conflict(
                f"{field}.outer_diameter",
                tube.outer_diameter,
                (
                    f"at most {widest:g} mm for its socket to fit beside resonator.cavity_height "
                    f"({resonator.cavity_height:g} mm)"
                ),
            )
        axis = resonator.port_axis_height
        if not lowest - 1e-9 <= axis <= highest + 1e-9:
            given = resonator.port_height is not None
            allowed = f"between {lowest:g} and {highest:g} mm for the socket of {field} to stay in the wall"
            remedy = "" if given else "its default is mid height"
            yield conflict("resonator.port_height", axis, allowed, remedy=remedy)
        if to_microphone and hole + SOCKET_COVER > chamber.chamber_height / 2 + 1e-9:
            yield conflict(
                f"{field}.outer_diameter",
                tube.outer_diameter,
                (
                    f"at most {chamber.chamber_height - 2 * (printing.glue_gap + SOCKET_COVER):g} mm for its socket to "
                    f"fit beside microphone.chamber_height ({chamber.chamber_height:g} mm)"
                ),
            )
        walls = [("resonator", resonator.cavity_diameter / 2, resonator.wall_thickness)]
        if to_microphone:
            walls.append(("microphone", chamber.chamber_diameter / 2, chamber.wall_thickness))
        for part, inside, wall in walls:
            deepest = _socket_depth(inside + wall, hole) - inside
            if printing.port_lip >= deepest:
                yield conflict(
                    "printing.port_lip",
                    printing.port_lip,
                    (
                        f"below {deepest:g} mm, what {part}.wall_thickness ({wall:g} mm) leaves beside the socket of "
                        f"{field}"
                    ),
                )


def _socket_depth(outside: float, hole: float) -> float:
    """Distance from the axis of a round shell to where a socket of that radius is wholly in its wall."""
    return math.sqrt(max(outside**2 - hole**2, 0.0))


def microphone_socket_rules(design: StatedArray) -> Iterator[Refusal]:
    """Lines enter a chamber at equal angles, along the sides of a ring, else as they meet."""
    chamber, printing = design.microphone, design.printing
    at_corners = design.layout.kind == "ring"
    angles = ring.corner_angles(ring.corners(ring.side_lengths(design))) if at_corners else None
    for index, name in enumerate(design.microphones):
        ends = [design.microphone_tube_of(line) for line in design.lines if name in line.between]
        if len(ends) > 1:
            apart = 360 / len(ends) if angles is None else float(angles[index])
            if design.layout.kind == "hand":
                apart = hand.meeting_angle(design, name) or apart
            if design.layout.kind == "area":
                apart = area.outside_angle(design, name) or apart
            if design.layout.frozen is not None:
                apart = least_angle(design.layout.frozen.microphones[index].ports)
            hole = max(tube.outer_diameter for tube in ends) / 2 + printing.glue_gap
            bore = max(tube.inner_diameter for tube in ends) / 2
            half = math.radians(min(apart, 360 - apart)) / 2
            # Sockets begin at the lip, bores where the round wall ends beside them; nearest are their inner corners.
            socket, mouth = ((SOCKET_COVER / 2 + r * math.cos(half)) / math.sin(half) for r in (hole, bore))
            least = 2 * max(socket - printing.port_lip, math.hypot(mouth, bore))
            if chamber.chamber_diameter < least - 1e-9:
                yield conflict(
                    "microphone.chamber_diameter",
                    chamber.chamber_diameter,
                    (
                        f"at least {least:.4g} mm for the ports of the {counted(len(ends), 'line')} that end at "
                        f"{name!r} to fit around it, {apart:.4g} degrees apart with {SOCKET_COVER:g} mm of wall between"
                        " them"
                    ),
                )
