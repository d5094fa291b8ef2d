"""The base of a mold: cavities with their lands and overflow grooves, and the mark below."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

import cadquery as cq

from geometry.design.array_design import ArrayDesign
from geometry.molds.plan import MoldPlan
from geometry.solids.bodies import revolved
from geometry.solids.letters import letters_within, text_bars, text_size

#: Depth of the mark, mm.
_MARK_DEPTH = 0.3
#: Heights of its letters that are tried, mm, and the width of their strokes per height: 0.5 mm, which all processes of
#: this package print, or 0.4 mm.
_LETTER_HEIGHTS, _STROKE = (3.0, 2.4), 1 / 6
#: Share of the block's width and depth that the mark may take.
_MARK_SHARE = 0.85


def base_block(plan: MoldPlan) -> cq.Shape:
    """The block with a land around each cavity; between the lands it stays below the parting plane."""
    solid: cq.Shape = box(plan, plan.bottom, plan.gap)
    outer, (start, end) = plan.land[1], plan.groove
    top, depth = plan.gap, plan.gap - plan.groove_bottom
    narrowed = depth * plan.slope
    lands, pockets = [], []
    for centre in plan.centres:
        lands.append(revolved(((0, top), (start, top), (outer, 0), (0, 0)), centre))
        pockets.append(revolved(plan.profile, centre))
        floor = plan.groove_bottom
        groove = ((start, top), (start + narrowed, floor), (end - narrowed, floor), (end, top))
        pockets.append(revolved(groove, centre))
    return solid.fuse(*lands).cut(*pockets)


def box(plan: MoldPlan, bottom: float, top: float) -> cq.Solid:
    """A block over the whole mold between two heights, mm."""
    x, y = plan.half
    return cq.Solid.makeBox(2 * x, 2 * y, top - bottom, cq.Vector(-x, -y, bottom))


def mark_text(design: ArrayDesign) -> tuple[str, str]:
    """Thickness (mm) and material of the membrane as they are engraved."""
    material = design.membrane.material.removeprefix("silicone-").replace("shore-a-", "A").removeprefix("blend-")
    return f"{design.membrane.thickness:.3g}MM", re.sub(r"[^A-Z0-9.+-]", "", material.upper())


def mark(solid: cq.Shape, plan: MoldPlan, texts: Sequence[str]) -> cq.Shape:
    """Engrave texts into the lower face, to be read from below: the first one whole, of the others what has room."""
    width, depth = (2 * _MARK_SHARE * half for half in plan.half)
    for height in _LETTER_HEIGHTS:
        longest, most = letters_within(width, depth, height)
        lines = [line for text in texts for line in textwrap.wrap(text, max(longest, len(texts[0])))]
        if len(lines) <= most and longest >= len(texts[0]):
            break
    lines = lines[: max(most, 1)]
    height *= min(1.0, width / text_size(lines, height)[0])
    bars = text_bars(lines, height, _STROKE * height, _MARK_DEPTH)
    # Turned over about the x axis: its front looks downwards.
    place = cq.Location(cq.Vector(0, 0, plan.bottom + _MARK_DEPTH), cq.Vector(1, 0, 0), 180)
    return solid.cut(*(bar.moved(place) for bar in bars))
