"""The printed shell of a sensing point: a cup with a port per tube and a seat for the membrane."""

from __future__ import annotations

from collections.abc import Sequence

import cadquery as cq

from geometry.design import Membrane, Printing, Resonator
from geometry.routing import unit
from geometry.tube import Port

#: Narrowest rim that is raised around the membrane to centre it, mm; narrower ones break off.
_LEDGE_WIDTH = 0.4


def build_shell(resonator: Resonator, membrane: Membrane, printing: Printing, ports: Sequence[Port]) -> cq.Workplane:
    """Draw a shell. The cavity's floor lies at z = 0, its axis is z, the membrane's seat at the cavity's height.

    Each port is a bore through the lip at the cavity, on which the tube stops, and a socket from there out.
    Where the shell is wide enough, a ledge half as high as the membrane surrounds the seat and centres it.

    Raises:
        ValueError: the drawn shell is not one valid solid.
    """
    radius, outer = resonator.cavity_diameter / 2, resonator.outer_diameter / 2
    top = resonator.cavity_height
    seat = radius + membrane.rim_width + printing.glue_gap
    ledge = membrane.thickness / 2 if outer - seat >= _LEDGE_WIDTH - 1e-9 else 0.0
    solid = cylinder(outer, -resonator.floor_thickness, top + ledge)
    if ledge:
        solid = solid.cut(cylinder(seat, top, top + 2 * ledge))
    solid = solid.cut(cylinder(radius, 0, top + ledge))
    solid = cut_ports(solid, ports, printing, radius, outer, resonator.port_axis_height)
    return one_solid(solid, "shell")


def cut_ports(
    solid: cq.Shape,
    ports: Sequence[Port],
    printing: Printing,
    inner_radius: float,
    outer_radius: float,
    height: float,
) -> cq.Shape:
    """Cut bores and sockets through the wall of a round housing whose axis is z (mm)."""
    for port in ports:
        x, y = unit(port.angle)
        direction, centre = cq.Vector(x, y, 0), cq.Vector(0, 0, height)
        start, shoulder = 0.5 * inner_radius, inner_radius + printing.port_lip
        bore = cq.Solid.makeCylinder(
            port.bore_diameter / 2, shoulder - start + printing.port_lip, centre + direction * start, direction
        )
        socket = cq.Solid.makeCylinder(
            port.tube_diameter / 2 + printing.glue_gap, outer_radius, centre + direction * shoulder, direction
        )
        solid = solid.cut(bore, socket)
    return solid


def cylinder(radius: float, bottom: float, top: float, at: tuple[float, float] = (0.0, 0.0)) -> cq.Solid:
    """An upright cylinder between two heights, mm."""
    return cq.Solid.makeCylinder(radius, top - bottom, cq.Vector(at[0], at[1], bottom))


def one_solid(shape: cq.Shape, name: str) -> cq.Workplane:
    """The shape as a workplane with one solid.

    Raises:
        ValueError: it is not one valid solid.
    """
    solids = shape.Solids()
    if len(solids) != 1 or not solids[0].isValid():
        raise ValueError(f"{name}: drawn as {len(solids)} solids instead of one valid solid; its features cut it apart")
    return cq.Workplane(solids[0])
