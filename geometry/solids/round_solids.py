"""Bodies of revolution about an upright axis."""

from __future__ import annotations

from collections.abc import Sequence

import cadquery as cq

from geometry.ground.refusal import Kind, Refusal
from geometry.solids.measure import pinched_edges


def revolved(profile: Sequence[tuple[float, float]], at: tuple[float, float] = (0.0, 0.0)) -> cq.Solid:
    """The body that a closed half section sweeps around its axis.

    Args:
        profile: corners (radius, height), mm, in order around the section; the last joins the first.
        at: x and y of the axis, mm.
    """
    outline = cq.Wire.makePolygon([cq.Vector(radius, 0, height) for radius, height in profile], close=True)
    body = cq.Solid.revolve(outline, [], 360.0, cq.Vector(0, 0, 0), cq.Vector(0, 0, 1))
    return body.moved(cq.Location(cq.Vector(*at, 0)))


def cylinder(radius: float, bottom: float, top: float, at: tuple[float, float] = (0.0, 0.0)) -> cq.Solid:
    """An upright cylinder of a radius, from its bottom to its top height, about an axis at (x, y); all mm."""
    return cq.Solid.makeCylinder(radius, top - bottom, cq.Vector(at[0], at[1], bottom))


def one_solid(shape: cq.Shape, name: str) -> cq.Workplane:
    """The shape as a workplane with one solid.

    Raises:
        Refusal: it is not one valid solid.
    """
    solids = shape.Solids()
    if len(solids) != 1 or not solids[0].isValid():
        problem = f"is drawn as {len(solids)} solids instead of one valid solid; its features cut it apart"
        raise Refusal(problem, kind=Kind.NO_RESULT, field=name)
    if pinched_edges(solids[0]):
        problem = "is drawn as a solid that touches itself along a line"
        raise Refusal(problem, kind=Kind.NO_RESULT, field=name, remedy="move what meets there")
    return cq.Workplane(solids[0])
