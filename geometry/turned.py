"""Bodies of revolution about an upright axis."""

from __future__ import annotations

from collections.abc import Sequence

import cadquery as cq


def turned(profile: Sequence[tuple[float, float]], at: tuple[float, float] = (0.0, 0.0)) -> cq.Solid:
    """The body that a closed half section sweeps around its axis.

    Args:
        profile: corners (radius, height), mm, in order around the section; the last joins the first.
        at: x and y of the axis, mm.
    """
    outline = cq.Wire.makePolygon([cq.Vector(radius, 0, height) for radius, height in profile], close=True)
    body = cq.Solid.revolve(outline, [], 360.0, cq.Vector(0, 0, 0), cq.Vector(0, 0, 1))
    return body.moved(cq.Location(cq.Vector(*at, 0)))
