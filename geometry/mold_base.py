"""The base of a mold: cavities with their lands and overflow grooves, and the mark below."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

import cadquery as cq

from geometry.design import ArrayDesign
from geometry.mold_plan import MoldPlan
from geometry.turned import turned

#: Depth of the mark, mm, and the share of the block's width and depth it takes.
_MARK_DEPTH, _MARK_SHARE = 0.3, 0.7
#: Largest height of its letters, mm, and their width per height.
_LETTER_HEIGHT, _LETTER_WIDTH = 3.0, 0.75
#: Letters of a material's name that are engraved, and how many on a line.
_MOST_LETTERS, _LINE = 24, 8


def base_block(plan: MoldPlan) -> cq.Shape:
    """The block with a land around each cavity; between the lands it stays below the parting plane."""
    solid: cq.Shape = box(plan, plan.bottom, plan.gap)
    outer, (start, end) = plan.land[1], plan.groove
    top, depth = plan.gap, plan.gap - plan.groove_bottom
    narrowed = depth * plan.slope
    lands, pockets = [], []
    for centre in plan.centres:
        lands.append(turned(((0, top), (start, top), (outer, 0), (0, 0)), centre))
        pockets.append(turned(plan.profile, centre))
        floor = plan.groove_bottom
        groove = ((start, top), (start + narrowed, floor), (end - narrowed, floor), (end, top))
        pockets.append(turned(groove, centre))
    return solid.fuse(*lands).cut(*pockets)


def box(plan: MoldPlan, bottom: float, top: float) -> cq.Solid:
    """A block over the whole mold between two heights, mm."""
    x, y = plan.half
    return cq.Solid.makeBox(2 * x, 2 * y, top - bottom, cq.Vector(-x, -y, bottom))


def mark_text(design: ArrayDesign) -> tuple[str, ...]:
    """Thickness and material of the membrane as they are engraved, line by line."""
    material = design.membrane.material.removeprefix("silicone-").replace("shore-a-", "A")
    code = re.sub(r"[^A-Za-z0-9.+-]", "", material)[:_MOST_LETTERS]
    return f"{design.membrane.thickness:g} mm", *textwrap.wrap(code, _LINE)


def mark(solid: cq.Shape, plan: MoldPlan, lines: Sequence[str]) -> cq.Shape:
    """Engrave lines of text into the lower face, to be read from below."""
    width, depth = (2 * _MARK_SHARE * half for half in plan.half)
    height = min(_LETTER_HEIGHT, width / (_LETTER_WIDTH * max(map(len, lines))), depth / (1.5 * len(lines)))
    text = cq.Compound.makeText("\n".join(lines), height, _MARK_DEPTH, halign="center", valign="center")
    # Turned over about the x axis: its front looks downwards.
    turned_over = text.rotate(cq.Vector(0, 0, 0), cq.Vector(1, 0, 0), 180)
    return solid.cut(turned_over.moved(cq.Location(cq.Vector(0, 0, plan.bottom + _MARK_DEPTH))))
