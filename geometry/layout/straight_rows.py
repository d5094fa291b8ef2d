"""Serpentines of straight tubes, known from lengths alone: whether nothing can overlap, and how large they are."""

from __future__ import annotations

import math

from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import FOOT_EDGE, ledge_height, membrane_top
from geometry.layout.lines_in_plan import serpentine_runs
from geometry.plan.cylinder import Plane
from geometry.schema.cavity_shapes import wall_distance
from geometry.schema.ports import Port, web_problem


def is_wide_apart(design: ArrayDesign) -> bool:
    """True where points lie on a square grid with straight tubes along its edges, and all is slimmer than its meshes.

    Said of no design that :func:`geometry.layout.overlaps.overlaps` finds fault with, in microseconds: sweeps ask it
    of every case. False says nothing.
    """
    ends = [name for line in design.lines for name in line.between]
    layout = design.layout
    if layout.kind != "serpentine" or layout.pitch is not None or len(set(ends)) < len(ends):
        return False
    if layout.microphone_side != "ends":
        return False  # beside each other, or below
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
        if shortest < mesh or min(design.microphone_reach_of(line, end) for end in (0, 1)) < shell + housing:
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


def straight_size(design: ArrayDesign) -> tuple[float, float, float]:
    """Extent along x, y and z, mm, of an array without feet that :func:`is_wide_apart` holds of.

    It equals :func:`geometry.layout.size.array_size`, by lengths alone: its tubes lie between housings that are wider,
    and every seat of a board along x or y.
    """
    microphone, axis = design.microphone, design.resonator.port_axis_height
    bottom = axis - microphone.chamber_height / 2
    seat = bottom + microphone.chamber_height
    reach, heights = 0.0, [bottom - microphone.wall_thickness, seat]
    heights.append(seat + microphone.sound_hole_length + microphone.package_height)
    heights += [axis + side * tube.outer_diameter / 2 for tube in design.tubes for side in (-1, 1)]
    for kind in design.kinds:
        alike = design.of_kind(kind)
        resonator, membrane = alike.resonator, alike.membrane
        reach = max(reach, resonator.outer_diameter / 2, resonator.cavity_diameter / 2 + membrane.rim_width)
        wall = resonator.cavity_height + ledge_height(resonator, membrane, design.printing)
        heights += [-resonator.floor_thickness, wall, membrane_top(alike)]
    chamber = microphone.chamber_diameter / 2 + microphone.wall_thickness
    length, width = (
        max(side / 2 + microphone.board_gap + microphone.wall_thickness, chamber) for side in microphone.board_size
    )
    across: list[float] = []
    along: list[float] = []
    for run in serpentine_runs(design, Plane()):
        x, y = run.positions.T.tolist()
        across += (min(x) - reach, max(x) + reach)
        along += (min(y) - reach, max(y) + reach)
        for end in run.ends:
            x, y = end.target.tolist()
            beside, before = (width, length) if end.direction in (90.0, 270.0) else (length, width)
            across += (x - beside, x + beside)
            along += (y - before, y + before)
    size = (max(values) - min(values) for values in (across, along, heights))
    x, y, z = (round(side, 9) for side in size)
    return x, y, z


def _points_upwards(points: int, columns: int) -> bool:
    """True where an end of a line points along the columns of its block."""
    return columns == 1 or (points > columns and points % columns == 1)
