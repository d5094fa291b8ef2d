"""Serpentines of straight tubes whose parts lie so far apart that nothing can overlap: known from lengths alone."""

from __future__ import annotations

import math

from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import FOOT_EDGE
from geometry.stated.cavity_shapes import wall_distance
from geometry.stated.ports import Port, web_problem


def is_wide_apart(design: ArrayDesign) -> bool:
    """Whether the points lie on a square grid with straight tubes along its edges, and all is slimmer than its meshes.

    Said of no design that :func:`geometry.layout.overlaps.overlaps` finds fault with, in microseconds: sweeps ask it
    of every case. False says nothing.
    """
    ends = [name for line in design.lines for name in line.between]
    if design.layout.kind != "serpentine" or design.layout.pitch is not None or len(set(ends)) < len(ends):
        return False
    if len(design.lines) > 1 and any(_points_upwards(line.points, design.layout.columns) for line in design.lines):
        return False  # at the block of the next line
    resonator, chamber, gap = design.resonator, design.microphone, design.printing.glue_gap
    shell = resonator.outer_diameter / 2
    if design.shell.feet:
        shell += design.shell.foot_length + design.shell.foot_hole / 2 + FOOT_EDGE
    seat = (side + 2 * (chamber.board_gap + chamber.wall_thickness) for side in chamber.board_size)
    housing = max(math.hypot(*seat) / 2, chamber.chamber_diameter / 2 + chamber.wall_thickness)
    for line in design.lines:
        tubes = (design.tube_of(line), design.microphone_tube_of(line), *design.inner_tubes_of(line))
        tube = max(each.outer_diameter for each in tubes) / 2
        mesh = max(2 * shell, shell + housing, 2 * housing)
        lengths = [tube.length for tube in design.inner_tubes_of(line)]
        if len(set(lengths)) > 1 and line.points > design.layout.columns:
            return False  # rows of a graded line make no grid
        shortest = resonator.cavity_diameter + min(lengths, default=design.tube_of(line).length)
        if shortest < mesh or design.microphone_reach_of(line) < shell + housing:
            return False
        if tube > resonator.outer_diameter / 2 / math.sqrt(2):
            return False
        radius, height = resonator.cavity_diameter / 2, resonator.port_axis_height
        widest = [Port(angle, max(each.inner_diameter for each in tubes), 2 * tube) for angle in (0.0, 90.0)]
        shoulder = radius + design.printing.port_lip
        for shape in {design.of_kind(kind).resonator.cavity_shape for kind in design.kinds}:
            mouths = [wall_distance(shape, radius, height, port.angle) for port in widest]
            if web_problem((widest[0], widest[1]), (mouths[0], mouths[1]), shoulder, gap):
                return False
    return True


def _points_upwards(points: int, columns: int) -> bool:
    """Whether an end of a line points along the columns of its block."""
    return columns == 1 or (points > columns and points % columns == 1)
