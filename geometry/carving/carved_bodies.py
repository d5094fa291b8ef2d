"""A body with pockets, a skin around its shells and a template to drill by, each checked as a solid and for clashes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry.assembly.fit import FACET_VOLUME
from geometry.assembly.model import ArrayModel
from geometry.body.reading import Body
from geometry.body.samples import Samples, samples_of
from geometry.carving.patch import Patch, patch_under
from geometry.carving.pockets import CLEARANCE, Pocket, pockets, swept
from geometry.design.shell_rules import membrane_top
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from geometry.plan.routing import trimmed
from geometry.schema.field_errors import DesignError
from geometry.solids.measure import Tessellation

if TYPE_CHECKING:
    import manifold3d

#: Distance of a skin and of a template from the body, mm, so that they can be put on.
GAP = 0.1
#: How far a skin reaches beside its pockets, mm.
_RIM = 2.0
#: Largest hole of a skin that is filled, squares of the distance of neighbours.
_HOLE = 4.0
#: Edges of facets of the body, by the distance of neighbours, and at most, mm.
_FACETS, _LONGEST = 8, 1.5
#: Thickness of a drilling template, height of its bushes above the body, and diameter of its holes, mm.
_TEMPLATE, _BUSH, _DRILL = 1.5, 4.0, 1.0
#: Wall around the hole of a bush, mm.
_BUSH_WALL = 0.7
#: Edges shorter than this are taken out, mm: files in single precision cannot hold them.
_SHORTEST = 1e-5
#: Largest error of the balance of volumes, as a fraction of the blank.
_BALANCE = 1e-6


@dataclass(frozen=True)
class CarvedBody:
    """A printed solid that belongs to a body, as facets."""

    name: str
    """Name: ``host``, ``skin`` or ``drill-template``."""
    facets: Tessellation
    """Its surface."""
    balance: float
    """Error of its volume against that of the blank and of what was cut out, as a fraction of the blank."""
    blank_genus: int
    """Ways through the solid before anything was cut out."""
    openings: int
    """Further ways through it: the holes of a template."""
    facts: Mapping[str, float | int | str]
    """Numbers and words that go into its file."""

    @property
    def genus(self) -> int:
        """Ways through it."""
        return self.blank_genus + self.openings


@dataclass(frozen=True)
class CarvedBodies:
    """Solids that are printed or milled for an array on a body."""

    seat: str
    """``in``: pockets in the body; ``on``: a skin around the shells."""
    bodies: tuple[CarvedBody, ...]
    """The host or the skin, then the template."""
    clashes: Mapping[str, float]
    """Volume that each placed part shares with the wall around it, mm^3, by its label."""
    thinnest: float
    """Thinnest wall between pockets that do not open into each other, mm; infinite if there is none."""
    between: tuple[str, str]
    """Labels of the parts on both sides of it."""

    @property
    def worst_clash(self) -> tuple[str, float]:
        """Label of the part that shares most with the wall, and the volume, mm^3."""
        label = max(self.clashes, key=lambda each: self.clashes[each])
        return label, self.clashes[label]


def carve(
    model: ArrayModel, body: Body, report: Callable[[str, float], None] = lambda text, fraction: None
) -> CarvedBodies:
    """Cut the pockets of an array into its body, or into a skin around it, and make a template to drill by.

    Args:
        model: the array, whose places are frozen and which has a table ``[surface]``.
        body: the body that it was fitted to.
        report: called with what is done, in words, and the fraction of the work that is behind.

    Raises:
        Refusal: the design has no body, a solid is not one closed piece, a pocket goes through the host, or a part
            clashes with the wall around it.
    """
    design, stated = model.design, model.design.surface
    if stated is None or design.layout.frozen is None:
        raise DesignError(kind=Kind.MISSING, file=design.name, field="surface", allowed="a table with the body")
    report("pockets", 0.0)
    spacing = _spacing(model)
    ground = samples_of(body, min(spacing / _FACETS, _LONGEST))
    deep = stated.seat == "in"
    wall = 0.0 if deep else stated.base + design.resonator.floor_thickness + membrane_top(design)
    own = pockets(design, model.layout, ground, wall)
    cut = _union([pocket.solid for pocket in own])
    report("wall around the parts", 0.3)
    patch = _patch(model, ground, spacing)
    host = solid_of(body.vertices, body.triangles)
    blank = host if deep else patch.layer(GAP, wall)
    facts: dict[str, float | int | str] = {"clearance": CLEARANCE}
    if not deep:
        facts |= {"thickness": round(wall - GAP, 3), "gap_to_body": GAP}
    carved, solid = _cut("host" if deep else "skin", blank, cut, 0, facts)
    report("template", 0.6)
    template = _template(model, ground, patch)
    report("clash test", 0.7)
    clashes = _clashes(model, [solid] if deep else [solid, host])
    thinnest, between = _thinnest(own)
    found = CarvedBodies(stated.seat, (carved, template), clashes, thinnest, between)
    label, volume = found.worst_clash
    if volume > FACET_VOLUME:
        problem = f"and the {carved.name} are in each other's way: they share {volume:.3g} mm^3"
        raise DesignError(f"{label} {problem}", kind=Kind.CONFLICT, file=design.name, remedy="fit again")
    return found


def _spacing(model: ArrayModel) -> float:
    """Usual distance of neighbours, mm."""
    places = np.array([model.layout.frame(point).origin for point in model.layout.points])
    apart = np.linalg.norm(places[:, None] - places[None], axis=-1)
    np.fill_diagonal(apart, np.inf)
    return float(np.median(apart.min(axis=1)))


def _patch(model: ArrayModel, ground: Samples, spacing: float) -> Patch:
    """The part of the body under an array, with a rim beside its pockets."""
    design, layout = model.design, model.layout
    microphone = design.microphone
    corner = math.hypot(
        *(side / 2 + microphone.board_gap + microphone.wall_thickness for side in microphone.board_size)
    )
    groups: list[tuple[Any, float]] = [
        ([layout.frame(point).origin for point in layout.points], design.resonator.outer_diameter / 2),
        ([layout.frame(each).origin for each in layout.microphones], corner),
        *((tube.course, tube.tube.outer_diameter / 2) for tube in layout.tubes),
    ]
    places = np.vstack([np.asarray(own, float) for own, _ in groups])
    reach = np.concatenate([np.full(len(own), radius + CLEARANCE + _RIM) for own, radius in groups])
    foot, normals = ground.projected(places)
    return patch_under(ground, foot, normals, reach, _HOLE * spacing**2)


def solid_of(vertices: Array, triangles: NDArray[np.int64]) -> manifold3d.Manifold:
    """Solid of a closed surface: corners (n, 3) float64, mm, and those of each facet, (m, 3) int64."""
    import manifold3d

    mesh = manifold3d.Mesh64(np.array(vertices, np.float64, order="C"), np.array(triangles, np.uint64, order="C"))
    return manifold3d.Manifold(mesh)


def _union(solids: list[manifold3d.Manifold]) -> manifold3d.Manifold:
    import manifold3d

    return manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)


def _cut(
    name: str,
    blank: manifold3d.Manifold,
    cut: manifold3d.Manifold,
    openings: int,
    facts: Mapping[str, float | int | str],
) -> tuple[CarvedBody, manifold3d.Manifold]:
    """A blank without what is cut out, checked.

    Raises:
        Refusal: it is not one piece, has other ways through it than it should, or its volume does not add up.
    """
    exact = blank - cut
    solid = exact.simplify(_SHORTEST)
    pieces, genus = len(solid.decompose()), solid.genus()
    status = str(solid.status()).split(".")[-1]
    if status != "NoError" or pieces != 1:
        problem = f"is not one closed piece (pieces: {pieces}, state: {status})"
        raise Refusal(problem, kind=Kind.NO_RESULT, field=name)
    through = genus - blank.genus()
    if through != openings:
        problem = f"has {counted(through, 'way')} through it beside those of the blank; it must have {openings}"
        remedy = "choose lower shells, or a thicker body: pockets break through it"
        raise Refusal(problem, kind=Kind.CONFLICT, field=name, remedy=remedy)
    removed = float((blank ^ cut).volume())
    balance = (float(solid.volume()) + removed) / float(blank.volume()) - 1
    if abs(balance) > _BALANCE:
        problem = f"has a volume that is off by {balance:.2g} of its blank; it must be within {_BALANCE:g}"
        raise Refusal(problem, kind=Kind.NO_RESULT, field=name)
    mesh = solid.to_mesh64()
    places, corners = np.asarray(mesh.vert_properties, np.float64)[:, :3], np.asarray(mesh.tri_verts, np.int64)
    facets = Tessellation(places, corners, np.zeros(len(corners), np.int64), math.nan)
    return CarvedBody(name, facets, balance, int(blank.genus()), openings, dict(facts)), solid


def _template(model: ArrayModel, ground: Samples, patch: Patch) -> CarvedBody:
    """A thin layer on the body with a bush along the axis of each part, to drill or to mark by."""
    import manifold3d

    radius = _DRILL / 2
    layout = model.layout
    frames = [*map(layout.frame, layout.points), *map(layout.frame, layout.microphones)]
    feet, _ = ground.projected(np.array([frame.origin for frame in frames]))
    bushes: list[manifold3d.Manifold] = []
    holes: list[manifold3d.Manifold] = []
    for frame, foot in zip(frames, feet, strict=True):
        # Where the axis of the part meets the body.
        up = float((foot - np.asarray(frame.origin)) @ np.asarray(frame.axes[2]))
        matrix = np.column_stack([np.asarray(frame.axes).T, frame.at(0.0, 0.0, up)])
        for solids, own, low, high in (
            (bushes, radius + _BUSH_WALL, GAP + _TEMPLATE / 2, _BUSH),
            (holes, radius, -_BUSH, _BUSH + 1.0),
        ):
            solids.append(
                manifold3d.Manifold.cylinder(high - low, own, own, 48).translate([0, 0, low]).transform(matrix)
            )
    blank = _union([patch.layer(GAP, GAP + _TEMPLATE), *bushes])
    facts = {"thickness": _TEMPLATE, "gap_to_body": GAP, "holes": len(holes), "hole_diameter": _DRILL}
    return _cut("drill-template", blank, _union(holes), len(holes), facts)[0]


def _clashes(model: ArrayModel, walls: list[manifold3d.Manifold]) -> dict[str, float]:
    """Volume that each placed part shares with the walls, mm^3, by its label.

    Tubes are swept along their courses, which takes a thousandth of the time of facets of their solids.
    """
    rigid = (part for part in model.placed if part.kind not in ("spring", "sheath"))
    found = {part.label: model.facets.in_walls(part, walls) for part in rigid}
    for tube in model.layout.tubes:
        solid = swept(trimmed(tube.course, model.design.printing.port_lip), tube.tube.outer_diameter / 2)
        found[tube.label] = math.fsum(float((solid ^ wall).volume()) for wall in walls)
    return found


def _thinnest(own: list[Pocket]) -> tuple[float, tuple[str, str]]:
    """Thinnest wall between pockets that do not open into each other, mm, and the labels of both sides."""
    boxes = np.array([pocket.solid.bounding_box() for pocket in own])
    least, between = math.inf, ("", "")
    for number, pocket in enumerate(own):
        later = boxes[number + 1 :]
        apart = np.maximum(later[:, :3] - boxes[number, 3:], boxes[number, :3] - later[:, 3:]).max(axis=1)
        for other in (own[number + 1 + k] for k in np.flatnonzero(apart < min(least, 5.0))):
            # Two tubes that end in one shell are in its pocket.
            if pocket.joins & other.joins:
                continue
            gap = float(pocket.solid.min_gap(other.solid, min(least, 5.0)))
            if gap < least:
                least, between = gap, (pocket.label, other.label)
    return (least, between) if between[0] else (math.inf, between)
