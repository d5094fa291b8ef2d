"""The open-face mold: rails beside the cavities and a scraper whose blade rides on them and on the lands."""

from __future__ import annotations

import cadquery as cq

from geometry.molds.plan import RAIL_WIDTH, MoldPlan

#: Flat of the blade, height of the scraper above the lands, width of its back and of its guides, mm.
_EDGE, _HEIGHT, _BACK, _GUIDE = 0.4, 8.0, 4.0, 2.0


def with_rails(base: cq.Shape, plan: MoldPlan) -> cq.Shape:
    """The base with a rail as high as the lands along both long sides: the blade never tips."""
    x, y = plan.half
    corners = (-y, y - RAIL_WIDTH)
    rails = [cq.Solid.makeBox(2 * x, RAIL_WIDTH, -plan.gap, cq.Vector(-x, corner, plan.gap)) for corner in corners]
    return base.fuse(*rails)


def scraper(plan: MoldPlan) -> cq.Shape:
    """A blade across the mold with a guide at each end, as it stands over the middle: the edge at z = 0.

    It is pushed along x; the silicone is drawn off at the height of the lands.
    """
    inside = plan.half[1] + plan.mold.pin_clearance
    outside = inside + _GUIDE
    slant = (_BACK - _EDGE) / 2
    section = [(-_EDGE / 2, 0.0), (_EDGE / 2, 0.0), (_BACK / 2, slant), (_BACK / 2, _HEIGHT)]
    section += [(-x, z) for x, z in reversed(section[2:])]
    outline = cq.Wire.makePolygon([cq.Vector(x, -outside, z) for x, z in section], close=True)
    solid: cq.Shape = cq.Solid.extrudeLinear(outline, [], cq.Vector(0, 2 * outside, 0))
    low = plan.bottom / 2
    guides = [
        cq.Solid.makeBox(_BACK, _GUIDE, _HEIGHT - low, cq.Vector(-_BACK / 2, corner, low))
        for corner in (-outside, inside)
    ]
    return solid.fuse(*guides)
