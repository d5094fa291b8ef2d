"""Places of the microphones on a body: near where the design wants them, with room, and with tubes that can be laid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from geometry.body.samples import Samples
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.plan.frozen import Ways, smooth_courses
from geometry.schema.surface_fields import SurfaceFit
from geometry.surface.regions import RIM_GAP, Mask, Region
from geometry.surface.tubes import bends, directions, rounded_ports

#: How far the body may bend away below the corners of a board's seat, mm. The seat stands above the floor of its
#: housing, which is narrower and leaves a gap like that of a shell.
_CORNER_DROP = 1.2
#: Clearance of housings from shells and from each other, mm.
CLEARANCE = 0.4
#: Most places that are tried for a microphone.
_TRIED = 240
#: Cost of a millimetre of overlap, of length, and of distance from the wanted place.
_OVERLAP, _LENGTH, _AWAY = 60.0, 0.3, 0.2
#: Least distance between the mouths of a tube to a microphone, by its outside diameter.
_GAP = 3.0
#: Radius of the bends of these tubes that costs nothing, by the smallest allowed.
_SPARE = 1.8
#: Angle below which two tubes at a part cost, degrees.
_WIDE = 65.0


@dataclass(frozen=True)
class Seats:
    """Sizes of shells and housings that microphones need room for, mm."""

    shell: tuple[float, float]
    """Inner and outer radius of a shell."""
    chamber: float
    """Radius of a chamber."""
    trunk: float
    """Radius of the floor of a housing."""
    corner: float
    """Distance from the axis of a housing to the corner of its seat."""
    tube: float
    """Outside diameter of the tubes to the microphones."""
    smallest_bend: float
    """Radius to which these may be bent."""

    @classmethod
    def of(cls, design: ArrayDesign) -> Seats:
        """Sizes of a design."""
        resonator, microphone = design.resonator, design.microphone
        sides = [side / 2 + microphone.board_gap + microphone.wall_thickness for side in microphone.board_size]
        tubes = [design.microphone_tube_of(line) for line in design.lines]
        return cls(
            (resonator.cavity_diameter / 2, resonator.outer_diameter / 2),
            microphone.chamber_diameter / 2,
            microphone.chamber_diameter / 2 + microphone.wall_thickness,
            math.hypot(*sides),
            max(tube.outer_diameter for tube in tubes),
            max(max(tube.smallest_bend_radius, tube.outer_diameter / 2) for tube in tubes),
        )


@dataclass(frozen=True)
class Found:
    """A microphone on the surface."""

    place: Array
    """Its axis at the height of its ports, (3,) float64, mm."""
    normal: Array
    """Outwards, (3,) float64."""


def room_for_microphones(samples: Samples, stated: SurfaceFit, seats: Seats) -> Mask:
    """Samples of a body where a housing may stand, (n,) bool.

    Raises:
        Refusal: there is none.
    """
    least = max(seats.corner**2 / (2 * _CORNER_DROP), seats.trunk**2 / (2 * RIM_GAP))
    room = samples.bend(seats.corner) * least <= 1
    room &= ~np.isin(samples.faces, stated.forbidden)
    if not room.any():
        raise Refusal(
            f"has no place for a microphone, whose housing needs a radius of {least:.3g} mm",
            kind=Kind.CONFLICT,
            field="surface.microphones",
            file=stated.body,
            remedy="allow other faces, or choose a smaller board",
        )
    return room


def wanted_places(
    samples: Samples,
    room: Mask,
    region: Region,
    names: Sequence[str],
    stated: SurfaceFit,
    reach: float,
    corner: float,
) -> tuple[list[int], list[str]]:
    """Samples near which the microphones are wanted, and findings in words.

    Stated ones are the nearest with room; others are spread at the edge of the region, in the order of the lines.

    Args:
        samples: at the height of the ports.
        room: where a housing may stand.
        region: where points may be.
        names: of the microphones in the order of the lines.
        stated: the table ``[surface]``.
        reach: how far from the edge of the region a microphone may be, mm.
        corner: distance from the axis of a housing to its corner, mm.

    Raises:
        Refusal: there is no room near the region.
    """
    findings, found = [], {}
    where = np.flatnonzero(room)
    for number, wish in enumerate(stated.microphones):
        name, place = wish.name, wish.at
        if name not in names or name in found:
            problem = "is not a microphone of the lines" if name not in names else "is given twice"
            field = f"surface.microphones.{number}.name"
            raise Refusal(problem, kind=Kind.UNKNOWN, field=field, value=name, allowed=list(names))
        nearest = int(where[np.argmin(np.linalg.norm(samples.places[where] - np.array(place), axis=1))])
        moved = float(np.linalg.norm(samples.places[nearest] - np.array(place)))
        if moved > reach:
            findings.append(f"microphone {name} is {moved:.3g} mm from its stated place: no room is nearer")
        found[name] = nearest
    left = [name for name in names if name not in found]
    if left:
        inside = cKDTree(samples.places[region.inside])
        outside = inside.query(samples.places[where])[0]
        depth = np.where(region.inside[where], region.from_edge[where], 0.0)
        # Beside the region rather than in it, where they would take the room of points.
        beside = np.asarray((outside >= 0.6 * corner) & (outside <= reach))
        near = where[beside] if beside.any() else where[(outside <= reach) & (depth <= reach)]
        if not len(near):
            raise Refusal(
                f"has no room for a microphone within {reach:.3g} mm of the region's edge",
                kind=Kind.CONFLICT,
                field="surface.microphones",
                file=stated.body,
                remedy="state their places",
            )
        middle = samples.places[region.inside].mean(axis=0)
        apart = np.linalg.norm(samples.places[near] - middle, axis=1)
        taken = [samples.places[index] for index in found.values()]
        for _ in left:
            if taken:
                apart = np.min([np.linalg.norm(samples.places[near] - place, axis=1) for place in taken], axis=0)
            index = int(near[np.argmax(apart)])
            taken.append(samples.places[index])
            found[left[len(taken) - 1 - (len(names) - len(left))]] = index
        if len(left) == len(names) > 2:
            found = dict(zip(names, _in_order(samples.places, list(found.values())), strict=True))
    return [found[name] for name in names], findings


def _in_order(places: Array, found: list[int]) -> list[int]:
    """Places so that each is followed by the nearest that is left; the first is that of the two furthest apart."""
    at = places[found]
    apart = np.linalg.norm(at[:, None] - at[None], axis=-1)
    tour = [int(np.argmax(apart.max(axis=1)))]
    while len(tour) < len(found):
        left = [k for k in range(len(found)) if k not in tour]
        tour.append(min(left, key=lambda k: apart[tour[-1], k]))
    return [found[k] for k in tour]


def placed_microphone(
    samples: Samples,
    room: Mask,
    wanted: int,
    ends: Sequence[tuple[int, int | None]],
    points: tuple[Array, Array],
    others: Sequence[Found],
    tubes: Array,
    seats: Seats,
    reach: float,
    port_step: float,
) -> tuple[Found, Array]:
    """The place near a wanted one from which the tubes to the ends of its lines can be laid best.

    Args:
        samples: at the height of the microphone's ports.
        room: where a housing may stand.
        wanted: sample near which it is wanted.
        ends: last point of each line that ends there, and the one before it.
        points: axes of all points at the height of their ports and their normals, (n, 3) float64.
        others: microphones that stand already.
        tubes: places along other tubes, (k, 3) float64, mm.
        seats: sizes.
        reach: how far from the wanted place it may be, mm.
        port_step: to which the angle between the ports of a shell is rounded, degrees.

    Returns:
        The microphone, and places along its tubes, (m, 3).
    """
    at, normals = points
    last = [end for end, _ in ends]
    target = samples.places[wanted]
    # Beside the wanted place, or beside the points that it serves.
    middle = at[last].mean(axis=0)
    off = np.minimum(
        np.linalg.norm(samples.places - target, axis=1), np.linalg.norm(samples.places - middle, axis=1) + reach / 4
    )
    candidates = np.flatnonzero(room & (off <= reach))
    if len(candidates):
        free = cKDTree(at).query(samples.places[candidates])[0] - seats.shell[1] - seats.corner - CLEARANCE
        for other in others:
            gap = np.linalg.norm(samples.places[candidates] - other.place, axis=1) - 2 * seats.corner - CLEARANCE
            free = np.minimum(free, gap)
        ranked = np.argsort(off[candidates] + _OVERLAP * np.maximum(-free, 0), kind="stable")
        candidates = _thinned(samples.places, candidates[ranked], 0.2 * seats.corner)[:_TRIED]
    else:
        candidates = np.array([wanted])
    place, normal = samples.places[candidates], samples.normals[candidates]
    nearest = cKDTree(at).query(place)[0] - seats.shell[1] - seats.corner - CLEARANCE / 2
    cost = _OVERLAP * np.maximum(-nearest, 0) + _AWAY * np.linalg.norm(place - target, axis=1)
    for other in others:
        gap = np.linalg.norm(place - other.place, axis=1) - 2 * seats.corner - CLEARANCE / 2
        cost += _OVERLAP * np.maximum(-gap, 0)
    laid = []
    leaving = []
    for end, before in ends:
        count = len(candidates)
        start, start_normal = np.repeat(at[end][None], count, 0), np.repeat(normals[end][None], count, 0)
        out, back = directions(start, start_normal, place), directions(place, normal, start)
        if before is not None:
            along = directions(at[end][None], normals[end][None], at[before][None])[0]
            cost += _narrow(out @ along)
            out = rounded_ports(out, np.repeat(along[None], count, 0), start_normal, port_step)[0]
        ways = Ways(
            (start, place),
            (out, back),
            (np.full(count, seats.shell[0]), np.full(count, seats.chamber)),
            (np.full(count, seats.shell[1]), np.full(count, seats.corner)),
            (start_normal + normal) / 2,
            np.ones(count),
        )
        length = ways.smooth
        courses = smooth_courses(ways, length)
        laid.append(courses)
        leaving.append(back)
        cost += _LENGTH * length + _OVERLAP * np.maximum(_SPARE * seats.smallest_bend - bends(courses), 0)
        cost += _OVERLAP * _overlap(courses, np.delete(at, end, axis=0), seats.shell[1] + seats.tube / 2 + 0.1)
        if len(tubes):
            away = tubes[np.linalg.norm(tubes - at[end], axis=1) > seats.shell[1] + 1.2 * seats.tube]
            beyond = np.linalg.norm(courses - at[end], axis=2) > seats.shell[1] + 1.2 * seats.tube
            cost += _OVERLAP * _overlap(courses, away, seats.tube + 0.1, beyond)
        for other in others:
            cost += _OVERLAP * _overlap(courses, other.place[None], seats.corner + seats.tube / 2 + 0.1)
        off_surface = np.einsum("nmc,nmc->nm", *_seen(samples, courses))
        cost += _OVERLAP * np.maximum(-off_surface.min(axis=1) - seats.tube, 0)
        first_mouth, last_mouth = ways.mouths
        gap = np.linalg.norm(last_mouth - first_mouth, axis=1)
        cost += _OVERLAP * np.maximum(_GAP * seats.tube - gap, 0)
    for one in range(len(leaving)):
        for other_way in leaving[one + 1 :]:
            cost += _narrow(np.einsum("nc,nc->n", leaving[one], other_way))
    best = int(np.argmin(cost))
    return Found(place[best], normal[best]), np.vstack([courses[best] for courses in laid])


def _thinned(places: Array, ranked: NDArray[np.intp], least: float) -> NDArray[np.intp]:
    """The first of ranked places that are no closer to each other than a distance."""
    kept: list[int] = []
    grid: set[tuple[int, ...]] = set()
    for index in ranked.tolist():
        cell = tuple((places[index] // least).astype(int).tolist())
        if cell not in grid:
            grid.add(cell)
            kept.append(index)
    return np.array(kept, np.intp)


def _overlap(courses: Array, obstacles: Array, reach: float, counts: NDArray[np.bool_] | None = None) -> Array:
    """How far each course is within a distance of the nearest obstacle, (n,) float64, mm."""
    if not len(obstacles):
        return np.zeros(len(courses))
    apart = np.asarray(cKDTree(obstacles).query(courses.reshape(-1, 3))[0]).reshape(courses.shape[:2])
    if counts is not None:
        apart = np.where(counts, apart, np.inf)
    return np.asarray(np.maximum(reach - apart.min(axis=1), 0.0))


def _seen(samples: Samples, courses: Array) -> tuple[Array, Array]:
    """Offsets of places along courses from the nearest sample, and the normals there; both (n, m, 3)."""
    near = samples.tree.query(courses.reshape(-1, 3))[1].reshape(courses.shape[:2])
    return courses - samples.places[near], samples.normals[near]


def _narrow(cosine: Array) -> Array:
    """Cost of an angle between two tubes at a part, by its cosine."""
    return np.asarray(_OVERLAP * 3 * np.maximum(cosine - math.cos(math.radians(_WIDE)), 0))
