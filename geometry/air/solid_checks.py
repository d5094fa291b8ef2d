"""Checks of a CAD solid before any work on it: one closed body of a size and fineness that can be meshed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from geometry.ground.refusal import Kind, Refusal, counted, said_by

if TYPE_CHECKING:
    import cadquery

#: Smallest and largest extent of a body of air, mm.
SMALLEST_EXTENT, LARGEST_EXTENT = 0.01, 1000.0
#: Shortest edge and narrowest face, mm: below a micrometre nothing is made.
SMALLEST_FEATURE = 1e-3
#: Most faces of a body.
MOST_FACES = 500
#: Tetrahedra per volume of a cube as long as their edges: those of a mesh by gmsh.
_PER_CUBE = 8.5


def sound_solid(shape: cadquery.Shape) -> cadquery.Solid:
    """The one solid of a shape, fit to be meshed; milliseconds, whatever the shape.

    Raises:
        Refusal: none or several solids, a corner or an extent that is not finite, an extent too large or too small, no
            volume, too many faces, an edge or a face too small, or one that the CAD kernel finds fault with.
    """
    from OCP.Standard import Standard_Failure

    solids = shape.Solids()
    if len(solids) != 1:
        raise Refusal(f"has {counted(len(solids), 'solid')}; it must have one", kind=Kind.UNSUITABLE, field="shape")
    try:
        problem = next(_problems(solids[0]), "")
    except (Standard_Failure, ValueError, RuntimeError) as error:  # such as an edge without an end
        problem = f"cannot be measured by the CAD kernel: {said_by(error)}"
    if problem:
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="solid")
    return solids[0]


def _problems(solid: cadquery.Solid) -> Iterator[str]:
    """Faults of a solid, the cheapest to find first: later checks may take for ever where an earlier one fails."""
    from OCP.BRep import BRep_Tool

    for corner in solid.Vertices():
        if not all(map(math.isfinite, place := corner.toTuple())):
            yield f"has a corner at {', '.join(f'{each:g}' for each in place)}; it must be finite"
    if not all(BRep_Tool.IsClosed_s(shell.wrapped) for shell in solid.Shells()):
        yield "has no end: its faces do not close"
    extents = _extents(solid)
    for extent in extents:
        if not extent <= LARGEST_EXTENT:
            yield f"is {extent:g} mm long; it must be at most {LARGEST_EXTENT:g} mm"
    if not extents or not min(extents) >= SMALLEST_EXTENT:
        yield f"is {min(extents, default=0.0):.3g} mm across; it must be at least {SMALLEST_EXTENT:g} mm"
    faces = solid.Faces()
    if len(faces) > MOST_FACES:
        yield f"has {len(faces)} faces; it must have at most {MOST_FACES}"
    shortest = min(
        (edge.Length() for edge in solid.Edges() if not BRep_Tool.Degenerated_s(edge.wrapped)), default=math.inf
    )
    narrowest = min((_width(face) for face in faces), default=math.inf)
    for what, size in (("an edge", shortest), ("a face", narrowest)):
        if not size >= SMALLEST_FEATURE:
            length = "long" if what == "an edge" else "wide"
            yield f"has {what} {size:.3g} mm {length}; it must be at least {SMALLEST_FEATURE:g} mm"
    volume = solid.Volume()
    if not 0 < volume < math.inf:
        yield f"has a volume of {volume:g} mm^3; it must be above 0 (is it inside out?)"
    if not solid.isValid():
        yield "is not valid for the CAD kernel: its faces do not close or cross each other"


def _extents(solid: cadquery.Solid) -> tuple[float, ...]:
    """Sides of a box around a solid, mm; none where there is nothing or it has no end."""
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    BRepBndLib.Add_s(solid.wrapped, box, False)
    if box.IsVoid():
        return ()
    low_x, low_y, low_z, high_x, high_y, high_z = box.Get()
    return high_x - low_x, high_y - low_y, high_z - low_z


def _width(face: cadquery.Face) -> float:
    """Width of a face, mm: that of a long strip of its area and outline, or half of that of a square."""
    around = sum(edge.Length() for edge in face.Edges())
    return 2 * face.Area() / around if around > 0 else math.inf


def estimated_elements(solid: cadquery.Solid, largest: float, tube: float, growth: float, wall: float | None) -> float:
    """Number of tetrahedra that a mesh of these sizes will have, to a factor of about three.

    As many cubes of the largest size as fill the volume, and along every face a layer of its own size, which grows
    into the solid: of curved faces the size goes by their narrowest radius.

    Args:
        solid: one closed solid, mm.
        largest: size, mm.
        tube: size on curved faces, in their radii of curvature.
        growth: increase of size per distance from a face.
        wall: size near every face, mm; None where it is the largest.
    """
    volume = solid.Volume()
    count = volume / largest**3
    for face in solid.Faces():
        size = largest if wall is None else min(wall, largest)
        if face.geomType() != "PLANE":
            size = min(size, tube * _radius(face))
        if size < largest:
            count += min(face.Area() * (1 + 1 / (2 * growth)) * size, volume) / size**3
    return _PER_CUBE * count


def _radius(face: cadquery.Face) -> float:
    """Smallest radius of curvature in the middle of a curved face, mm."""
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.BRepLProp import BRepLProp_SLProps

    surface = BRepAdaptor_Surface(face.wrapped)
    ends = (surface.FirstUParameter(), surface.LastUParameter()), (surface.FirstVParameter(), surface.LastVParameter())
    (u, v) = (sum(pair) / 2 for pair in ends)
    properties = BRepLProp_SLProps(surface, u, v, 2, 1e-9)
    if not properties.IsCurvatureDefined():
        return math.inf
    curvature = max(abs(properties.MaxCurvature()), abs(properties.MinCurvature()))
    return 1 / curvature if curvature > 0 else math.inf
