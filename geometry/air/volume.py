"""The air of a cell as a CAD solid, with a point on every face that a port or a membrane occupies."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

from geometry.air.cells import Cell
from geometry.air.mesh import Point
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.cavity_shapes import draw_cavity, separation
from geometry.schema.ports import CellPort

if TYPE_CHECKING:
    import cadquery

#: Name of the face that the membrane or the microphone's diaphragm closes.
OPENING = "opening"
#: Names of the planes that halve a symmetric cell: upright, through all tubes, and level, through all tubes.
MIRROR, MIDPLANE = "mirror", "midplane"


@dataclass(frozen=True)
class AirVolume:
    """Air of a cell, mm. The cavity's floor lies at z = 0, its axis is z."""

    solid: cadquery.Solid
    """The air, or its part on one side of each mirror plane, mm."""
    ports: dict[str, Point]
    """A point on the flat end of the stub of each tube port, mm, in the order of ``Cell.ports``."""
    opening: Point
    """A point on the membrane, or on the inner end of the microphone's sound hole, mm."""
    centre: Point
    """Centre of the opening, mm."""
    mirrors: dict[str, Point]
    """A point on each mirror plane, mm: :data:`MIRROR` is y = 0, of which the side of positive y is drawn,
    :data:`MIDPLANE` that at half the height, below a membrane that is not a mirror image of the floor.
    """

    @property
    def faces(self) -> dict[str, Point]:
        """A point on every face that is not a wall, mm."""
        return {**self.ports, OPENING: self.opening, **self.mirrors}


def port_names(cell: Cell) -> tuple[str, ...]:
    """Names of a cell's tube ports, in the order of ``Cell.ports``."""
    return tuple(f"port-{k}" for k in range(len(cell.ports)))


def air_solid(cell: Cell) -> cadquery.Solid:
    """Draw the whole air of a cell: the cavity, its tube stubs and, for a microphone, the sound hole.

    A stub of length L ends at the distance diameter / 2 + L from the axis: tube lengths count from the radius
    of the cavity, where the tube's axis meets the wall of a cylinder.

    Raises:
        Refusal: no port, two ports overlap, or the drawn solid is not one valid solid.
    """
    return _checked(_drawn(cell), cell)


def air_volume(cell: Cell, level: bool = True) -> AirVolume:
    """Draw the air of a cell as :func:`air_solid` does, with its faces.

    Where every tube lies in the plane y = 0 the cell is its own mirror image and one half is drawn; so it is for a
    cylinder under a membrane whose tubes all lie at half its height.

    Args:
        cell: lengths in mm.
        level: whether to cut at :data:`MIDPLANE` too.

    Raises:
        Refusal: no port, two ports overlap, or the drawn solid is not one valid solid.
    """
    import cadquery as cq

    air = _drawn(cell)
    radius = cell.diameter / 2
    ports = {}
    for name, port in zip(port_names(cell), cell.ports, strict=True):
        end = _direction(port) * (radius + port.stub_length)
        ports[name] = (end.x, end.y, cell.height_of(port))
    centre = (0.0, 0.0, cell.height + cell.opening_length)
    upright = all(port.angle in (0.0, 180.0) for port in cell.ports)
    level = level and cell.shape is None and cell.opening_length == 0
    level = level and all(cell.height_of(port) == cell.height / 2 for port in cell.ports)
    size = 2 * max(radius + port.stub_length for port in cell.ports) + 2 * (cell.height + cell.opening_length)
    corner = cq.Vector(-size, 0 if upright else -size, cell.height / 2 if level else -size)
    if upright or level:
        air = air.intersect(cq.Solid.makeBox(2 * size, 2 * size, 2 * size, corner))
    # Points leave the planes that cut their faces.
    inwards = 0.1 * min(cell.opening_diameter, *(port.bore_diameter for port in cell.ports))
    along, up = inwards if upright else 0.0, inwards if level else 0.0
    ports = {name: (x, y + along, z + up) for name, (x, y, z) in ports.items()}
    mirrors = {}
    if upright:
        mirrors[MIRROR] = (0.0, 0.0, cell.height / 2 + up)
    if level:
        mirrors[MIDPLANE] = (0.0, along, cell.height / 2)
    return AirVolume(_checked(air, cell), ports, (0.0, along, centre[2]), centre, mirrors)


def _drawn(cell: Cell) -> cadquery.Shape:
    import cadquery as cq

    if not cell.ports:
        raise Refusal(f"the air of {cell.label} has no port; it needs at least one tube", kind=Kind.UNSUITABLE)
    radius = cell.diameter / 2
    for first, second in combinations(cell.ports, 2):
        near = min(cell.mouth_of(first), cell.mouth_of(second))
        apart = separation(near, first.angle - second.angle, cell.height_of(first) - cell.height_of(second))
        if apart <= (first.bore_diameter + second.bore_diameter) / 2:
            angles = f"{first.angle:g} and {second.angle:g} deg"
            raise Refusal(f"the air of {cell.label} has overlapping ports at {angles}", kind=Kind.CONFLICT)
    air: cq.Shape = draw_cavity(cell.shape, radius, cell.height)
    for port in cell.ports:
        direction, middle = _direction(port), cq.Vector(0, 0, cell.height_of(port))
        # Wholly inside the cavity, where the floor of a bowl rises towards the wall.
        start = radius / 2 if cell.shape is None else cell.mouth_of(port) / 10
        length = radius + port.stub_length - start
        air = air.fuse(cq.Solid.makeCylinder(port.bore_diameter / 2, length, middle + direction * start, direction))
    if cell.opening_length > 0:
        hole = cell.opening_diameter / 2
        air = air.fuse(cq.Solid.makeCylinder(hole, cell.opening_length, cq.Vector(0, 0, cell.height)))
    return air


def _direction(port: CellPort) -> cadquery.Vector:
    import cadquery as cq

    return cq.Vector(math.cos(math.radians(port.angle)), math.sin(math.radians(port.angle)), 0)


def _checked(air: cadquery.Shape, cell: Cell) -> cadquery.Solid:
    solids = air.Solids()
    if len(solids) != 1 or not solids[0].isValid():
        raise Refusal(f"the air of {cell.label} is not one valid solid", kind=Kind.NO_RESULT)
    return solids[0].clean()
