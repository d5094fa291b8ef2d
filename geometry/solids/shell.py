"""The printed shell of a sensing point: a cup with a port per tube and a seat for the membrane."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import cadquery as cq

from geometry.design.shell_rules import cavity_problems, feature_problems, ledge_height
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.plan.routing import unit
from geometry.schema.cavity_shapes import draw_cavity, wall_distance
from geometry.schema.field_errors import conflict
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import SOCKET_COVER, Membrane, Resonator, Shell
from geometry.schema.ports import Port, web_problem
from geometry.solids.round_solids import cylinder, one_solid
from geometry.solids.shell_features import add_feet, add_label, cut_groove

#: Most ports of a shell.
MOST_PORTS = 6


def build_shell(
    resonator: Resonator,
    membrane: Membrane,
    printing: Printing,
    ports: Sequence[Port],
    features: Shell | None = None,
    label: str | None = None,
) -> cq.Workplane:
    """Draw a shell. The cavity's floor lies at z = 0, its axis is z, the membrane's seat at the cavity's height.

    Each port is a bore through the lip at the cavity, on which the tube stops, and a socket from there out: the
    lip ends at the cavity's radius plus ``printing.port_lip``, whatever the shape of the cavity. A box has its
    first side along x. Where the shell is wide enough, a ledge half as high as the membrane surrounds the seat and
    centres it.

    Args:
        resonator: sizes of the cavity and its walls.
        membrane: what the seat carries.
        printing: lip and glue gap of the ports.
        ports: one to six, at any angles and heights.
        features: glue groove, feet and label; by default none.
        label: digits, drawn where ``features.label`` asks for them.

    Raises:
        Refusal: ports that do not fit, or the drawn shell is not one valid solid.
    """
    features = features or Shell()
    for problem in cavity_problems(resonator):
        raise problem
    check_ports(resonator, printing, ports)
    sockets = [(port_height(port, resonator), port.tube_diameter / 2 + printing.glue_gap) for port in ports]
    for problem in feature_problems(features, resonator, membrane.rim_width, sockets):
        raise problem
    if membrane.rim_width > resonator.wall_thickness:
        allowed = f"at most resonator.wall_thickness ({resonator.wall_thickness:g} mm)"
        raise conflict("membrane.rim_width", membrane.rim_width, allowed)
    radius, outer = resonator.cavity_diameter / 2, resonator.outer_diameter / 2
    top = resonator.cavity_height
    seat = radius + membrane.rim_width + printing.glue_gap
    ledge = ledge_height(resonator, membrane, printing)
    solid: cq.Shape = cylinder(outer, -resonator.floor_thickness, top + ledge)
    if features.feet:
        solid = add_feet(solid, outer, resonator.floor_thickness, [port.angle for port in ports], features)
    if ledge:
        solid = solid.cut(cylinder(seat, top, top + 2 * ledge))
    solid = solid.cut(draw_cavity(resonator.cavity_shape, radius, top, top + ledge))
    if features.groove_width is not None:
        solid = cut_groove(solid, radius + membrane.rim_width / 2, top, features)
    solid = cut_ports(solid, ports, printing, radius, outer, resonator.port_axis_height)
    if label is not None and features.label != "none":
        sides = [(port.angle, hole) for port, (_, hole) in zip(ports, sockets, strict=True)]
        # Beside the floor are feet, and in a carrier its webs and necks: digits stand above it.
        solid = add_label(solid, label, outer, resonator.wall_thickness, (0.0, top + ledge), sides, features)
    return one_solid(solid, "shell")


def check_ports(resonator: Resonator, printing: Printing, ports: Sequence[Port]) -> None:
    """Refuse ports that the wall of a shell has no room for.

    Raises:
        Refusal: none or more than six, one that leaves the wall, or two that leave no wall between them.
    """
    if not 1 <= len(ports) <= MOST_PORTS:
        problem = f"has {counted(len(ports), 'entry')} for a shell; it must have 1 to {MOST_PORTS}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="ports")
    radius, outer, lip = resonator.cavity_diameter / 2, resonator.outer_diameter / 2, printing.port_lip
    for number, port in enumerate(ports):
        where = f"ports.{number}"
        height = port_height(port, resonator)
        hole, bore = port.tube_diameter / 2 + printing.glue_gap, port.bore_diameter / 2
        if not 0 < bore < hole:
            raise conflict(f"{where}.bore_diameter", 2 * bore, f"above 0 and below {2 * hole:g} mm")
        lowest = max(bore, hole + SOCKET_COVER - resonator.floor_thickness)
        highest = resonator.cavity_height - hole - SOCKET_COVER
        if not lowest - 1e-9 <= height <= highest + 1e-9:
            raise conflict(f"{where}.height", height, f"between {lowest:g} and {highest:g} mm")
        if hole >= outer or (outer**2 - hole**2) ** 0.5 <= radius + lip:
            problem = f"has a socket of {2 * hole:g} mm, which is not wholly in the wall beyond the lip"
            raise conflict(f"{where}.tube_diameter", port.tube_diameter, problem=problem)
        if found := resonator.port_problem(height, 2 * bore):
            raise Refusal.of(found, field=f"{where}.{found.field}")
    for pair in combinations(ports, 2):
        heights = [port_height(port, resonator) for port in pair]
        mouths = tuple(
            wall_distance(resonator.cavity_shape, radius, height, port.angle)
            for port, height in zip(pair, heights, strict=True)
        )
        refuse_thin_web("shell", pair, mouths, radius + lip, printing.glue_gap, heights[0] - heights[1])


def refuse_thin_web(
    name: str, ports: Sequence[Port], mouths: Sequence[float], shoulder: float, glue_gap: float, rise: float = 0.0
) -> None:
    """Refuse two ports that leave too little wall between them.

    Args: see :func:`geometry.schema.ports.web_problem`; ``name`` is that of the part.

    Raises:
        Refusal: they do.
    """
    problem = web_problem((ports[0], ports[1]), (mouths[0], mouths[1]), shoulder, glue_gap, rise)
    if problem:
        raise Refusal(f"of the {name} {problem}", kind=Kind.CONFLICT, field="ports")


def port_height(port: Port, resonator: Resonator) -> float:
    """Height of a port's axis above the floor of the cavity, mm."""
    return resonator.port_axis_height if port.height is None else port.height


def cut_ports(
    solid: cq.Shape, ports: Sequence[Port], printing: Printing, inner_radius: float, outer_radius: float, height: float
) -> cq.Shape:
    """Cut bores and sockets through the wall of a hollow housing whose axis is z (mm).

    Args:
        solid: the housing, hollow already.
        ports: at their own heights, else at ``height``.
        printing: lip and glue gap.
        inner_radius: from where the lip counts.
        outer_radius: of the housing.
        height: of the ports' axes.
    """
    for port in ports:
        x, y = unit(port.angle)
        direction, centre = cq.Vector(x, y, 0), cq.Vector(0, 0, height if port.height is None else port.height)
        shoulder = inner_radius + printing.port_lip
        bore = cq.Solid.makeCylinder(port.bore_diameter / 2, shoulder + printing.port_lip, centre, direction)
        socket = cq.Solid.makeCylinder(
            port.tube_diameter / 2 + printing.glue_gap, outer_radius, centre + direction * shoulder, direction
        )
        solid = solid.cut(bore, socket)
    return solid
