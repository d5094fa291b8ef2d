"""Rules of the cavity's shape and of what is printed on a shell: what cannot be built is refused by name."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations

from geometry.ground.refusal import Refusal
from geometry.schema.array_fields import StatedArray
from geometry.schema.cavity_shapes import WIDEST_BOX, Box, Dome
from geometry.schema.field_errors import conflict
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import SOCKET_COVER, Membrane, Microphone, Resonator, Shell

#: Material on either side of a glue groove, mm.
_GROOVE_EDGE = 0.15
#: Material around the screw hole of a foot and between it and the wall, mm.
FOOT_EDGE, FOOT_CLEARANCE = 1.0, 0.3
#: Narrowest rim that is raised around the membrane to centre it, mm; narrower ones break off.
_LEDGE_WIDTH = 0.4
#: Fields that only one shape of cavity has.
_OWN_FIELDS = {
    "box": ("box_length", "box_width", "corner_radius", "collar_height"),
    "dome": ("dome_depth",),
}


def cavity_shape(design: StatedArray) -> Iterator[Refusal]:
    """Sizes of a box or a bowl, and where tubes enter them."""
    resonator = design.resonator
    yield from cavity_problems(resonator)
    for field, tube, _ in design.stated_tubes():
        problem = resonator.port_problem(resonator.port_axis_height, tube.inner_diameter)
        if problem is not None:
            at = "resonator.port_height" if problem.field == "height" else f"{field}.inner_diameter"
            yield Refusal.of(problem, field=at, allowed=f"{problem.allowed}, for the port of {field}")


def cavity_problems(resonator: Resonator) -> Iterator[Refusal]:
    """Sizes of a box or a bowl that the circle of the membrane and the height do not leave."""
    for shape, fields in _OWN_FIELDS.items():
        for field in fields:
            if shape != resonator.shape and getattr(resonator, field) is not None:
                problem = f"is for resonator.shape = {shape!r}, not {resonator.shape!r}"
                yield conflict(f"resonator.{field}", getattr(resonator, field), problem=problem)
    radius, height, cavity = resonator.cavity_diameter / 2, resonator.cavity_height, resonator.cavity_shape
    if isinstance(cavity, Box):
        short = min(cavity.length, cavity.width)
        if cavity.corner_radius > 0.45 * short:
            yield conflict(
                "resonator.corner_radius",
                cavity.corner_radius,
                f"at most {0.45 * short:.4g} mm, 0.45 of the shorter side of the box ({short:.4g} mm)",
            )
        if cavity.reach > WIDEST_BOX * radius + 1e-9:
            problem = (
                f"with box_width = {cavity.width:.4g} mm reaches {cavity.reach:.4g} mm from the axis; it must reach at "
                f"most {WIDEST_BOX * radius:.4g} mm to carry the round collar of resonator.cavity_diameter "
                f"({2 * radius:g} mm)"
            )
            yield conflict("resonator.box_length", round(cavity.length, 4), problem=problem)
        if cavity.collar_height > 0.8 * height:
            yield conflict(
                "resonator.collar_height",
                cavity.collar_height,
                f"at most {0.8 * height:g} mm, 0.8 of resonator.cavity_height ({height:g} mm)",
            )
    if isinstance(cavity, Dome):
        deepest = min(radius, height)
        if cavity.depth > deepest + 1e-9:
            yield conflict(
                "resonator.dome_depth",
                cavity.depth,
                f"at most {deepest:g} mm, the smaller of radius and height of the cavity",
            )


def shell_features(design: StatedArray) -> Iterator[Refusal]:
    """Room for a glue groove, feet, numbers and a carrier."""
    shell, resonator, printing = design.shell, design.resonator, design.printing
    sockets = [
        (resonator.port_axis_height, tube.outer_diameter / 2 + printing.glue_gap)
        for line in design.lines
        for tube in (*design.inner_tubes_of(line), design.tube_of(line), design.microphone_tube_of(line))
    ]
    yield from feature_problems(shell, resonator, design.membrane.rim_width, sockets)
    neck, floor = printing.carrier_neck, resonator.floor_thickness
    if printing.carrier != "none" and neck > floor:
        yield conflict("printing.carrier_neck", neck, f"at most resonator.floor_thickness ({floor:g} mm)")
    if shell.label != "none" and printing.carrier == "none":
        yield conflict(
            "shell.label",
            shell.label,
            "'none' without printing.carrier: shells of one shape are one part, in a carrier each has its number",
            unit="",
        )
    if shell.feet:
        nearest = nearest_step(design)
        apart = nearest - resonator.outer_diameter
        if 2 * shell.foot_length > apart and design.point_count > 1:
            yield conflict(
                "shell.foot_length",
                shell.foot_length,
                f"at most {apart / 2:g} mm, half of the space between neighbouring shells",
            )
        if printing.carrier != "none":
            yield conflict("printing.carrier", printing.carrier, "'none' for shells with feet (shell.feet)", unit="")


def nearest_step(design: StatedArray) -> float:
    """Smallest distance of neighbouring axes, mm: along the lines, of all points where places are frozen."""
    if design.layout.frozen is None:
        return min(min(design.steps_of(line), default=design.pitch_of(line)) for line in design.lines)
    places = [point.at for point in design.layout.frozen.points]
    return min((math.dist(one, other) for one, other in combinations(places, 2)), default=math.inf)


def feature_problems(
    shell: Shell, resonator: Resonator, rim_width: float, sockets: Sequence[tuple[float, float]]
) -> Iterator[Refusal]:
    """Glue groove and feet that a shell has no room for.

    Args:
        shell: what is asked for.
        resonator: the shell itself.
        rim_width: of the membrane's seat, mm.
        sockets: per port the height of its axis and the radius of its socket, mm.
    """
    if shell.groove_width is not None:
        widest = rim_width - 2 * _GROOVE_EDGE
        if shell.groove_width > widest + 1e-9:
            yield conflict(
                "shell.groove_width",
                shell.groove_width,
                (
                    f"at most {widest:.4g} mm, membrane.rim_width ({rim_width:g} mm) less {_GROOVE_EDGE:g} mm on either"
                    " side"
                ),
            )
        deepest = resonator.cavity_height - 0.1 - max(height + hole for height, hole in sockets)
        if shell.groove_depth > deepest + 1e-9:
            yield conflict(
                "shell.groove_depth",
                shell.groove_depth,
                f"at most {deepest:.4g} mm, what the sockets of the tubes leave below the seat",
            )
    if shell.feet:
        shortest = shell.foot_hole + FOOT_EDGE + FOOT_CLEARANCE
        if shell.foot_length < shortest - 1e-9:
            yield conflict(
                "shell.foot_length",
                shell.foot_length,
                f"at least {shortest:g} mm for the screw hole to be clear of the wall",
            )
        if shell.foot_hole + 2 * FOOT_EDGE > resonator.outer_diameter:
            yield conflict(
                "shell.foot_hole",
                shell.foot_hole,
                f"at most {resonator.outer_diameter - 2 * FOOT_EDGE:g} mm for feet no wider than the shell",
            )
        height, hole = min(sockets, key=lambda socket: socket[0] - socket[1])
        if height < hole:
            yield conflict(
                "resonator.port_height",
                height,
                f"at least {hole:g} mm, so that the tubes pass over the feet (shell.feet)",
            )


def seat_underside(microphone: Microphone, hole: float) -> float:
    """Height above the floor of a chamber at which the seat of its board begins to widen the housing, mm.

    Args:
        microphone: the microphone.
        hole: radius of the widest socket, mm; one that grazed the underside would leave a wall of no thickness.
    """
    top = microphone.chamber_height
    gasket = microphone.gasket_depth if microphone.gasket_width is not None else 0.0
    underside = max(top - microphone.wall_thickness - gasket, 0.0)
    for edge in (top / 2 + hole, top / 2 - hole):
        if abs(underside - edge) < SOCKET_COVER:
            underside = max(edge - SOCKET_COVER, 0.0)
    return underside


def membrane_top(design: StatedArray) -> float:
    """Height of the membrane's top with its rim or boss above the floor of the cavity, mm; of points that are alike."""
    membrane = design.membrane
    return design.resonator.cavity_height + membrane.mounted_thickness + membrane.total_height - membrane.thickness


def ledge_height(resonator: Resonator, membrane: Membrane, printing: Printing) -> float:
    """Height of the ledge that centres the membrane on the seat of a shell, mm; 0 where the shell is too narrow."""
    seat = resonator.cavity_diameter / 2 + membrane.rim_width + printing.glue_gap
    return membrane.thickness / 2 if resonator.outer_diameter / 2 - seat >= _LEDGE_WIDTH - 1e-9 else 0.0
