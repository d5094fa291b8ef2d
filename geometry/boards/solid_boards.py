"""A circuit board as a solid: seat, neck and head with their holes, as it is ordered."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.boards.board_pieces import BoardPlan
from geometry.boards.board_plan import shown_board
from geometry.design.array_design import ArrayDesign
from geometry.solids.housing import build_board
from geometry.solids.round_solids import cylinder, one_solid

if TYPE_CHECKING:
    import cadquery as cq


def board_solid(design: ArrayDesign) -> cq.Workplane:
    """Board of the microphones of an array with its lower face at z = 0 and the axis of the chamber at the origin."""
    plan = shown_board(design)
    return build_board(design.microphone) if plan is None else solid_of_plan(plan)


def solid_of_plan(plan: BoardPlan) -> cq.Workplane:
    """The whole board: its outline as high as it is thick, with sound hole, tie hole and the holes of the pins."""
    import cadquery as cq

    outline = cq.Wire.makePolygon([cq.Vector(x, y, 0) for x, y in plan.outline], close=True)
    block = cq.Solid.extrudeLinear(outline, [], cq.Vector(0, 0, plan.thickness))
    holes = [cylinder(diameter / 2, 0, plan.thickness, place) for diameter, place in plan.holes]
    return one_solid(block.cut(*holes), "microphone board")
