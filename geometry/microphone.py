"""The housing of a microphone: a chamber with the ports of its lines, and a lid that carries the package."""

from __future__ import annotations

from collections.abc import Sequence

import cadquery as cq

from geometry.design import Microphone, Printing
from geometry.shell import cut_ports, cylinder, one_solid
from geometry.tube import Port


def build_housing(microphone: Microphone, printing: Printing, ports: Sequence[Port]) -> cq.Workplane:
    """Draw the cup around the chamber, its floor at z = 0, open at the top; ports at mid height as in a shell.

    Raises:
        ValueError: the drawn housing is not one valid solid.
    """
    radius, wall = microphone.chamber_diameter / 2, microphone.wall_thickness
    solid = cylinder(radius + wall, -wall, microphone.chamber_height)
    solid = solid.cut(cylinder(radius, 0, microphone.chamber_height))
    solid = cut_ports(solid, ports, printing, radius, radius + wall, microphone.chamber_height / 2)
    return one_solid(solid, "microphone housing")


def build_lid(microphone: Microphone) -> cq.Workplane:
    """Draw the flat lid with the sound hole, its lower face at z = 0.

    The package is sealed on it over the hole; where the hole of the package itself is the sound hole, the
    package takes the place of the lid.
    """
    radius = microphone.chamber_diameter / 2 + microphone.wall_thickness
    lid = cylinder(radius, 0, microphone.sound_hole_length)
    return one_solid(lid.cut(cylinder(microphone.sound_hole_diameter / 2, 0, microphone.sound_hole_length)), "lid")
