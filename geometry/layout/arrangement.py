"""Positions of all resonators, tubes and microphones."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.typed import Array
from geometry.layout.below import led_below
from geometry.layout.frozen_layout import frozen_housings, frozen_layout
from geometry.layout.lines_in_plan import End, Run, area_runs, hand_runs, place_runs, ring_runs, serpentine_runs
from geometry.layout.placement import (
    ArrayLayout,
    Housings,
    MicrophonePlacement,
    MicrophonePort,
    PointPlacement,
    TubePlacement,
)
from geometry.plan.cylinder import Cylinder, Plane, surface_of
from geometry.plan.routing import bearing, bow_angle, bowed_path, directions, drawn_path, routed_path, tidy, unit
from geometry.schema.part_fields import Tube
from geometry.schema.ports import Port

#: Directions are rounded to 1e-6 degrees: places closer than this are one, mm.
_SAME_PLACE = 1e-4


def lay_out(design: DesignLike) -> ArrayLayout:
    """Lay out a design in plan and in space.

    ``serpentine``: rows of ``columns`` points, every second row backwards; lines are blocks above each
    other. Where the pitch is shorter than a straight tube, tubes bow out along one circular arc of exactly
    their length: in rows towards +y, at the turns outwards. The microphone of a single line end lies
    straight out at its tube's length. A microphone that joins several ends cannot lie at its tubes' length
    from all of them: it is drawn beside the blocks.

    ``cylinder``: a serpentine whose rows run around a cylinder; the plan is unrolled at the height of the ports.
    Tubes of a row are arcs between the shells, those from row to row straight, all of exactly their length.

    ``area``: see :mod:`geometry.plan.area`.

    ``hand``: see :mod:`geometry.plan.hand`.

    ``ring``: the lines are the sides of a polygon at their true length, the microphones its corners (see
    :func:`geometry.plan.ring.corners`). Microphone tubes lie straight, other tubes bow outwards.

    ``places``: points lie where the design states them. A longer tube bows to the left of its line, or leaves and
    arrives in the stated directions along a smooth curve of exactly its length.

    Two microphones on one line may lie at a side of the array, or below the shells: see
    :mod:`geometry.plan.tube_descent`.

    ``surface``: every part stands on a body where ``layout.frozen`` states it. Tubes that have no stated course are
    smooth curves of exactly their length (see :func:`geometry.plan.frozen.smooth_courses`).

    Parts that could not be built as drawn are listed by :func:`geometry.layout.overlaps.buildability_notes`.

    Raises:
        DesignError: not a design, or a microphone tube that is too short to lead below the shells.
    """
    design = resolve_design(design)
    if design.layout.frozen is not None:
        return frozen_layout(design, design.layout.frozen)
    housings, surface, runs, bows = _housed(design)
    tubes = _tubes(design, runs, bows, housings, surface)
    return ArrayLayout(housings.points, housings.microphones, housings.surface, tuple(tubes))


def place_housings(design: DesignLike) -> Housings:
    """Shells and microphones placed as by :func:`lay_out`, without the courses of the tubes between them."""
    design = resolve_design(design)
    if design.layout.frozen is not None:
        return frozen_housings(design, design.layout.frozen)
    return _housed(design)[0]


def point_axes(design: ArrayDesign) -> Array:
    """Axes of all points in plan, those of :func:`lay_out`; (n_point, 2) float64, mm."""
    if design.layout.frozen is not None:
        return np.array([point.plan for point in design.layout.frozen.points])
    return np.vstack([run.positions for run in _runs(design, surface_of(design))])


def _runs(design: ArrayDesign, surface: Plane | Cylinder) -> list[Run]:
    builders = {
        "serpentine": serpentine_runs,
        "cylinder": serpentine_runs,
        "ring": ring_runs,
        "area": area_runs,
        "hand": hand_runs,
        "places": place_runs,
    }
    return builders[design.layout.kind](design, surface)


def _housed(design: ArrayDesign) -> tuple[Housings, Plane | Cylinder, list[Run], list[list[float]]]:
    """The housings, what they stand on, their lines, and how far each tube between points bows, degrees."""
    surface = surface_of(design)
    runs = _runs(design, surface)
    if design.layout.microphone_side == "below":
        runs = led_below(design, runs)
    ends = [end for run in runs for end in run.ends]
    microphones = _microphones(design, ends, np.vstack([run.positions for run in runs]))
    bows = [_bows(design, index, run, surface) for index, run in enumerate(runs)]
    points: list[PointPlacement] = []
    for index, run in enumerate(runs):
        points += _points(index, run, bows[index], design.tubes_of(design.lines[index]), len(points))
    return Housings(tuple(points), tuple(microphones), surface), surface, runs, bows


# -- microphones --------------------------------------------------------------------------------------
def _microphones(design: ArrayDesign, ends: list[End], points: Array) -> list[MicrophonePlacement]:
    """Microphones, each where straight tubes of all its line ends meet, else beside the array."""
    housing = design.microphone.chamber_diameter / 2 + design.microphone.wall_thickness
    joined = {name: [end for end in ends if end.microphone == name] for name in design.microphones}
    middle = (points[:, 0].min() + points[:, 0].max()) / 2
    # Beside the blocks and beyond every chamber that lies at its tube's length.
    beyond = max(end.distance for end in ends) + 4 * housing
    sides: dict[int, list[tuple[float, str]]] = {-1: [], 1: []}
    for name, own in joined.items():
        if any(np.linalg.norm(end.target - own[0].target) > _SAME_PLACE for end in own):
            mean = np.mean([end.target for end in own], axis=0)
            sides[1 if mean[0] > middle + 1e-9 else -1].append((float(mean[1]), name))
    drawn = {}
    for side, column in sides.items():
        edge = points[:, 0].max() if side > 0 else points[:, 0].min()
        heights = _spread([height for height, _ in sorted(column)], 4 * housing)
        for height, (_, name) in zip(heights, sorted(column), strict=True):
            drawn[name] = np.array([edge + side * beyond, height])
    microphones = []
    for name, own in joined.items():
        if name in drawn:
            position = drawn[name]
            angles = _equally_spaced([bearing(position, end.point) for end in own])
        else:
            position = own[0].target
            angles = [end.arrival for end in own]
        tubes = [design.microphone_tube_of(design.lines[end.line]) for end in own]
        ports = tuple(
            MicrophonePort(end.line, end.end, _port(angle, tube))
            for end, angle, tube in zip(own, angles, tubes, strict=True)
        )
        depth = own[0].descent.depth if own[0].descent is not None else 0.0
        microphones.append(MicrophonePlacement(name, _pair(position), ports, depth))
    return microphones


def _spread(values: list[float], least: float) -> list[float]:
    """Sorted values moved apart to at least ``least`` with their mean kept."""
    moved: list[float] = []
    for value in values:
        moved.append(max(value, moved[-1] + least) if moved else value)
    shift = (sum(values) - sum(moved)) / len(values) if values else 0.0
    return [value + shift for value in moved]


def _equally_spaced(bearings: list[float]) -> list[float]:
    """Directions at equal angles, dealt out so that each is as close as possible to its bearing (degrees)."""
    count = len(bearings)
    ranking = sorted(range(count), key=lambda k: (bearings[k], k))
    best: tuple[float, list[float]] = (math.inf, [])
    for shift in range(count):
        slots = [0.0] * count
        for rank, k in enumerate(ranking):
            slots[k] = 360 * ((rank + shift) % count) / count
        left = [math.radians(b - s) for b, s in zip(bearings, slots, strict=True)]
        offset = math.atan2(sum(map(math.sin, left)), sum(map(math.cos, left)))
        cost = -sum(math.cos(x - offset) for x in left)
        if cost < best[0] - 1e-9:
            best = (cost, [slot + math.degrees(offset) for slot in slots])
    return best[1]


# -- points -------------------------------------------------------------------------------------------
def _bows(design: ArrayDesign, line: int, run: Run, surface: Plane | Cylinder) -> list[float]:
    """Angles by which the tubes between the points of a line bow, degrees."""
    # On a cylinder the points lie where unbowed tubes put them.
    if not isinstance(surface, Plane):
        return [0.0] * len(run.sides)
    cavity, outer = design.resonator.cavity_diameter / 2, design.resonator.outer_diameter / 2
    distances = np.linalg.norm(np.diff(run.positions, axis=0), axis=1).tolist()
    tubes = design.segments_of(design.lines[line])
    known: dict[tuple[float, float], float] = {}
    for tube, distance in zip(tubes, distances, strict=True):
        if (tube.length, distance) not in known:
            known[tube.length, distance] = bow_angle(tube.length, distance, cavity, outer)
    return [known[tube.length, distance] for tube, distance in zip(tubes, distances, strict=True)]


def _points(line: int, run: Run, bows: list[float], tubes: Sequence[Tube], before: int) -> Iterator[PointPlacement]:
    """Points of a line with its tubes; ``before`` is the number of points in the lines before it."""
    places = run.positions.tolist()
    first, last = run.ends
    backward, forward = [first.direction], []
    for place, bow in enumerate(bows):
        leaving, arriving = _ends_of_tube(run, place, bow)
        forward.append(leaving)
        backward.append(arriving)
    forward.append(last.direction)
    for place, position in enumerate(places):
        ports = _port(backward[place], tubes[place]), _port(forward[place], tubes[place + 1])
        yield PointPlacement(before + place + 1, line, place, _pair(position), ports)


def _ends_of_tube(run: Run, place: int, bow: float) -> tuple[float, float]:
    """Directions in which the tube after a point leaves it and, seen from there, the next one, degrees."""
    ends = run.positions[place], run.positions[place + 1]
    if run.is_bowed(place):
        direction = bearing(*ends)
        return direction + run.sides[place] * bow, direction + 180 - run.sides[place] * bow
    return directions(ends, run.angles[place], run.angles[place + 1])


def _port(angle: float, tube: Tube) -> Port:
    """Port in which a tube ends, in its direction from the housing's axis, degrees."""
    return Port(tidy(angle), tube.inner_diameter, tube.outer_diameter)


# -- tubes --------------------------------------------------------------------------------------------
def _tubes(
    design: ArrayDesign, runs: list[Run], bows: list[list[float]], housings: Housings, surface: Plane | Cylinder
) -> Iterator[TubePlacement]:
    cavity, outer = design.resonator.cavity_diameter / 2, design.resonator.outer_diameter / 2
    microphones = {each.name: each for each in housings.microphones}
    for index, (line, run) in enumerate(zip(design.lines, runs, strict=True)):
        first, last = run.ends
        yield _microphone_tube(design, first, microphones[first.microphone], runs, surface)
        between = zip(
            run.positions[:-1], run.positions[1:], run.sides, design.segments_of(line), bows[index], strict=True
        )
        for segment, (start, end, side, tube, bow) in enumerate(between, start=1):
            if run.is_bowed(segment - 1):
                plan = bowed_path(start, end, bow, side, cavity, outer)
            else:
                leaving, arriving = _ends_of_tube(run, segment - 1, bow)
                plan = routed_path((start, leaving), (end, arriving), cavity, outer, tube.length)
            path = _at_port_height(design, plan)
            course = _course(surface, path, (start, end), (cavity, cavity), (outer, outer))
            yield TubePlacement(index, segment, tube, path, course)
        yield _microphone_tube(design, last, microphones[last.microphone], runs, surface)


def _microphone_tube(
    design: ArrayDesign, end: End, microphone: MicrophonePlacement, runs: list[Run], surface: Plane | Cylinder
) -> TubePlacement:
    """The tube of a line's end, always drawn from the line's first microphone towards its second."""
    line = design.lines[end.line]
    tube = design.end_tube_of(line, end.end)
    cavity, chamber = design.resonator.cavity_diameter / 2, design.microphone.chamber_diameter / 2
    centre = np.array(microphone.position)
    if end.descent is not None:
        path, schematic = end.descent.path(cavity, chamber, design.resonator.port_axis_height), False
        course = surface.mapped(path)
    elif np.linalg.norm(centre - end.target) < _SAME_PLACE:
        out = unit(end.direction)
        path = _at_port_height(design, np.array([end.point + cavity * out, end.target - chamber * out]))
        outer = (design.resonator.outer_diameter / 2, chamber + design.microphone.wall_thickness)
        course = _course(surface, path, (end.point, end.target), (cavity, chamber), outer)
        schematic = False
    else:
        port = next(port for port in microphone.ports if (port.line, port.end) == (end.line, end.end))
        plan = drawn_path(
            end.point,
            end.direction,
            (cavity, design.resonator.outer_diameter / 2),
            centre,
            port.angle,
            (chamber, chamber + design.microphone.wall_thickness),
        )
        path, schematic = _at_port_height(design, plan), True
        others = np.vstack([run.positions for run in runs])
        others = others[np.linalg.norm(others - end.point, axis=1) > 1e-6]
        clear = design.resonator.outer_diameter / 2 + tube.outer_diameter
        # Only points within reach of the way's own box can be too close to it.
        others = others[((others > plan.min(axis=0) - clear) & (others < plan.max(axis=0) + clear)).all(axis=1)]
        gaps = np.linalg.norm(plan[:, None] - others[None], axis=2)
        if gaps.size and gaps.min() < clear:
            # Lead it over the membranes, so that the picture shows which ends are joined.
            alike = [design.of_kind(kind) for kind in design.kinds]
            axis = design.resonator.port_axis_height
            lift = max(each.resonator.cavity_height - axis + each.membrane.thickness for each in alike)
            s = np.linspace(0, 1, len(plan) - 2)
            path[1:-1, 2] += (lift + 2 * tube.outer_diameter) * np.minimum(1, 4 * np.sin(np.pi * s) ** 2)
        course = surface.mapped(path)
    if end.end == 0:
        path, course = path[::-1].copy(), course[::-1].copy()
    return TubePlacement(end.line, 0 if end.end == 0 else line.points, tube, path, course, schematic)


def _course(
    surface: Plane | Cylinder,
    path: Array,
    axes: tuple[Array, Array],
    inner: tuple[float, float],
    outer: tuple[float, float],
) -> Array:
    """The way of a tube in space between two housings (axes in plan, inner and outer radii, mm)."""
    if isinstance(surface, Plane) or abs(axes[0][0] - axes[1][0]) < _SAME_PLACE:
        return surface.mapped(path)
    (x0, y0), (x1, y1) = axes
    return surface.wound((x0, y0), (x1, y1), inner, outer)


def _at_port_height(design: ArrayDesign, plan: Array) -> Array:
    path = np.empty((len(plan), 3))
    path[:, :2], path[:, 2] = plan, design.resonator.port_axis_height
    return path


def _pair(position: Sequence[float] | Array) -> tuple[float, float]:
    return (round(float(position[0]), 9) + 0.0, round(float(position[1]), 9) + 0.0)
