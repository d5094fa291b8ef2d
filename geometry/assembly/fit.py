"""Does it go together: overlaps and gaps of placed solids, and the fit of tubes in their ports, by measurement."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import geometry
from geometry.assembly.model import ArrayModel, plane_of
from geometry.assembly.part_list import PlacedPart
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.schema.ports import ANGLE_STEP

if TYPE_CHECKING:
    import cadquery as cq

#: Common volumes below this are contact, mm^3; of a tube and the lip that it stops on see :func:`_wedge`.
CONTACT_VOLUME = 1e-4
#: A hole belongs to a tube where their axes are within this angle (sine) and distance (mm).
_SAME_DIRECTION, _SAME_AXIS = 0.01, 0.1
#: Common volumes of facets below this are those of the facets, mm^3.
FACET_VOLUME = 1e-3
#: Kinds of parts that are swept along the course of a tube.
_OF_TUBES = ("spring", "sheath")
#: Kinds that lie in the seat of their own housing. What leaves it is the head of the board, which may be ordered as a
#: flexible one: the kit names the parts that it may touch.
_IN_SEATS = ("board", "package")
#: Misfits below this are rounding, mm: directions of ports are rounded to 0.1 degrees.
_ROUNDING = 0.01


@dataclass(frozen=True)
class Interference:
    """Two placed parts that overlap, by their labels."""

    first: str
    """Label of one part."""
    second: str
    """Label of the other."""
    volume: float
    """Volume that both share, mm^3."""


@dataclass(frozen=True)
class PortFit:
    """A tube in a port, as measured on the faces of their solids."""

    tube: str
    """Label of the sheath."""
    part: str
    """Label of the shell or housing."""
    bore: float
    """Diameter of the hole through the lip, mm."""
    counterbore: float
    """Diameter of the socket, mm."""
    spring_bore: float
    """Inside diameter of the spring, mm."""
    tube_outside: float
    """Outside diameter of the sheath, mm."""
    axis_offset: float
    """Largest distance of the spring's axis from that of the bore, from its shoulder to the outside of the part, mm."""

    @property
    def glue_gap(self) -> float:
        """Radial gap between tube and socket, mm."""
        return (self.counterbore - self.tube_outside) / 2


def interferences(model: ArrayModel) -> tuple[Interference, ...]:
    """Every pair of placed parts whose solids share more than :data:`CONTACT_VOLUME`.

    Tubes and the parts they end in may share what the rounding of ports makes of their contact.

    Boxes only sieve the pairs, solids decide; pairs that lie to each other as one before are not computed again. A
    spring and its sheath are swept along one course and touch everywhere, which no solid can share by more than
    rounding and a boolean of solids needs minutes to say. On a body no two pairs are alike. There :func:`port_fits`
    measures tubes in the parts that they end in, and other parts of different groups, which must not touch at all, are
    compared by their facets.
    """
    found = []
    shared: dict[object, float] = {}
    joined, wedge = _joined(model), _wedge(model)
    facets = model.facets if model.design.layout.frozen is not None else None
    for i, j in _near(model, 0.0):
        first, second = model.placed[i], model.placed[j]
        if first.group == second.group and {first.kind, second.kind} <= set(_OF_TUBES):
            continue
        if first.group != second.group and {first.kind, second.kind} & set(_IN_SEATS):
            continue
        if facets is not None and first.group != second.group:
            if frozenset((first.group, second.group)) not in joined:
                volume = facets.shared(first, second)
                if volume > FACET_VOLUME:
                    found.append(Interference(first.label, second.label, volume))
            continue
        key, other = _relative(model, i, j)
        if key not in shared:
            shared[key] = model.shapes[model.placed[i].part].intersect(other()).Volume()
        groups = model.placed[i].group, model.placed[j].group
        ends_in = groups[0] != groups[1] and frozenset(groups) in joined
        if shared[key] > CONTACT_VOLUME + (wedge if ends_in else 0.0):
            found.append(Interference(model.placed[i].label, model.placed[j].label, shared[key]))
    return tuple(found)


def port_fits(model: ArrayModel) -> tuple[PortFit, ...]:
    """Every tube end with the port it is glued in: twice as many as tubes that are not schematic.

    Raises:
        Refusal: a tube ends in no port, or in a port without a bore and a socket.
    """
    return tuple(_port_fit(*end) for end in _tube_ends(model))


def misfits(model: ArrayModel) -> tuple[str, ...]:
    """Reasons why an array cannot be put together, one line each: parts that overlap, tubes that fit no port.

    Tubes that are drawn schematically are left out, see :func:`geometry.layout.arrangement.lay_out`.
    """
    lines = [
        f"{found.first} and {found.second} are in each other's way: they share {found.volume:.3g} mm^3"
        for found in interferences(model)
    ]
    for end in _tube_ends(model):
        try:
            fit = _port_fit(*end)
        except Refusal as error:
            lines.append(str(error))
            continue
        if fit.glue_gap < -_ROUNDING:
            lines.append(
                f"{fit.tube} is {fit.tube_outside:.4g} mm wide, its socket in {fit.part} {fit.counterbore:.4g} mm"
            )
        if fit.axis_offset > max(fit.glue_gap, 0.0) + _ROUNDING:
            lines.append(
                f"{fit.tube} is {fit.axis_offset:.3g} mm beside the axis of its socket in {fit.part}, which leaves it "
                f"{fit.glue_gap:.3g} mm"
            )
    return tuple(lines)


# -- pairs ----------------------------------------------------------------------------------------------
def _near(model: ArrayModel, within: float) -> Iterator[tuple[int, int]]:
    """Pairs of placed parts whose boxes are no further apart than this, mm."""
    local = {}
    for name, shape in model.shapes.items():
        if model.design.layout.frozen is not None:
            # Tubes on a body are free curves, whose exact boxes take seconds each.
            local[name] = geometry.solids.quick_box(shape)
            continue
        box = shape.BoundingBox()
        local[name] = np.array([[box.xmin, box.ymin, box.zmin], [box.xmax, box.ymax, box.zmax]])
    lows, highs = [], []
    for part in model.placed:
        corners = np.stack(np.meshgrid(*local[part.part].T, indexing="ij"), -1).reshape(-1, 3)
        moved = corners @ part.matrix[:3, :3].T + part.matrix[:3, 3]
        lows.append(moved.min(axis=0))
        highs.append(moved.max(axis=0))
    low, high = np.array(lows), np.array(highs)
    for i in range(len(low) - 1):
        apart = np.maximum(low[i + 1 :] - high[i], low[i] - high[i + 1 :]).max(axis=1)
        for j in np.flatnonzero(apart <= within):
            yield i, int(i + 1 + j)


def _relative(model: ArrayModel, i: int, j: int) -> tuple[object, _Placed]:
    """Key that is the same for pairs that are alike, and part j as seen from part i."""
    first, second = model.placed[i], model.placed[j]
    matrix: Array = np.linalg.solve(first.matrix, second.matrix).astype(np.float64)
    key = (first.part, second.part, tuple((np.round(matrix[:3], 5) + 0.0).ravel().tolist()))
    return key, _Placed(model.shapes[second.part], matrix)


def _wedge(model: ArrayModel) -> float:
    """Volume that the widest tube shares with the lip that it stops on, mm^3, whose direction is rounded."""
    radius = max((tube.tube.outer_diameter / 2 for tube in model.layout.tubes), default=0.0)
    return 2 / 3 * radius**3 * math.tan(math.radians(ANGLE_STEP / 2))


@dataclass(frozen=True)
class _Placed:
    """A shape to be moved where it is needed."""

    shape: cq.Shape
    matrix: Array

    def __call__(self) -> cq.Shape:
        import cadquery as cq

        return self.shape.moved(cq.Location(plane_of(self.matrix)))


def _joined(model: ArrayModel) -> set[frozenset[str]]:
    """Pairs of groups that touch by design: tubes with the points and microphones at their ends, each with itself."""
    pairs = {frozenset((part.group,)) for part in model.placed}
    return pairs | {frozenset((tube, body)) for tube, mouths in _mouths(model).items() for body in mouths}


def _mouths(model: ArrayModel) -> dict[str, dict[str, Array]]:
    """Group of a tube -> groups of the bodies it ends in -> where its axis meets the wall of the cavity, (3,), mm."""
    found: dict[str, dict[str, Array]] = {}
    number = {(p.line, p.place): p.number for p in model.layout.points}
    for tube in model.layout.tubes:
        line = model.design.lines[tube.line]
        ends = (tube.segment - 1, line.between[0], tube.course[0]), (tube.segment, line.between[1], tube.course[-1])
        found[tube.label] = {
            f"point {number[tube.line, place]}" if 0 <= place < line.points else f"microphone {microphone}": mouth
            for place, microphone, mouth in ends
        }
    return found


# -- faces ----------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Cylinder:
    """A cylindrical face: a point on its axis, the direction, radius and both ends along the axis, mm."""

    point: Array
    direction: Array
    radius: float
    ends: Array
    """(2, 3) float64."""


def _cylinders(shape: cq.Shape) -> list[_Cylinder]:
    from OCP.BRepAdaptor import BRepAdaptor_Surface

    found = []
    for face in shape.Faces():
        if face.geomType() != "CYLINDER":
            continue
        surface = BRepAdaptor_Surface(face.wrapped)
        cylinder = surface.Cylinder()
        place, along = cylinder.Axis().Location(), cylinder.Axis().Direction()
        point, direction = np.array([place.X(), place.Y(), place.Z()]), np.array([along.X(), along.Y(), along.Z()])
        ends = point + np.outer([surface.FirstVParameter(), surface.LastVParameter()], direction)
        found.append(_Cylinder(point, direction, cylinder.Radius(), ends))
    return found


def _in_space(cylinders: list[_Cylinder], part: PlacedPart) -> list[_Cylinder]:
    turn, move = part.matrix[:3, :3], part.matrix[:3, 3]
    return [_Cylinder(turn @ c.point + move, turn @ c.direction, c.radius, c.ends @ turn.T + move) for c in cylinders]


def _tube_ends(
    model: ArrayModel,
) -> Iterator[tuple[PlacedPart, list[_Cylinder], list[_Cylinder], PlacedPart, list[_Cylinder], Array]]:
    """Sheaths with their cylinders and those of their springs, once for each body they end in.

    With each are that body, its cylinders, and the place where the axis of the tube meets the wall of its cavity, mm.
    """
    holes = {name: _cylinders(shape) for name, shape in model.shapes.items()}
    bodies = {p.group: p for p in model.placed if p.kind in ("shell", "housing")}
    springs = {p.group: p for p in model.placed if p.kind == "spring"}
    mouths = _mouths(model)
    for sheath in model.placed:
        if sheath.kind != "sheath":
            continue
        sleeve, spring = _in_space(holes[sheath.part], sheath), _in_space(holes[springs[sheath.group].part], sheath)
        for group, mouth in sorted(mouths[sheath.group].items(), key=lambda end: end[0]):
            body = bodies[group]
            yield sheath, sleeve, spring, body, _in_space(holes[body.part], body), mouth


def _port_fit(
    sheath: PlacedPart,
    sleeve: list[_Cylinder],
    spring: list[_Cylinder],
    body: PlacedPart,
    walls: list[_Cylinder],
    mouth: Array,
) -> PortFit:
    centre = np.array(body.position)
    # by the mouth, since a bent tube may come nearer to the middle of the body elsewhere: below it, for one
    outside = max(sleeve, key=lambda c: (round(c.radius, 9), -_distance(mouth, c)))
    inside = min(spring, key=lambda c: (round(c.radius, 9), _distance(mouth, c)))
    ports = [
        wall
        for wall in walls
        if np.linalg.norm(np.cross(wall.direction, inside.direction)) < _SAME_DIRECTION
        and _offset(wall.point, inside) < _SAME_AXIS
        and float((wall.ends.mean(axis=0) - centre) @ (_nearest_end(mouth, inside) - centre)) > 0
    ]
    radii = sorted({round(port.radius, 9) for port in ports})
    if len(radii) < 2:
        problem = f"{sheath.label} ends in {body.label} where no bore with a socket is"
        raise Refusal(problem, kind=Kind.UNSUITABLE)
    return PortFit(
        tube=sheath.label,
        part=body.label,
        bore=2 * radii[0],
        counterbore=2 * radii[-1],
        spring_bore=2 * inside.radius,
        tube_outside=2 * outside.radius,
        axis_offset=max(_offset(end, inside) for port in ports for end in port.ends),
    )


def _offset(point: Array, cylinder: _Cylinder) -> float:
    """Distance of a point from the axis of a cylinder, mm."""
    return float(np.linalg.norm(np.cross(point - cylinder.point, cylinder.direction)))


def _distance(point: Array, cylinder: _Cylinder) -> float:
    return float(np.linalg.norm(cylinder.ends - point, axis=1).min())


def _nearest_end(point: Array, cylinder: _Cylinder) -> Array:
    return np.asarray(cylinder.ends[np.linalg.norm(cylinder.ends - point, axis=1).argmin()])
