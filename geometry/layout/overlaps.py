"""Parts of a layout that cannot be built: shells, housings and tubes that overlap, tubes bent too far."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import groupby

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.refusal import counted
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out
from geometry.layout.neighbours import near_pairs
from geometry.layout.placement import ArrayLayout, TubePlacement
from geometry.layout.prism import Prism, depth, prisms
from geometry.layout.straight_rows import is_wide_apart
from geometry.plan.routing import path_length, resampled, tightest_bend
from geometry.schema.cavity_shapes import wall_distance
from geometry.schema.field_errors import DesignError
from geometry.schema.ports import web_problem

#: Overlaps below this are contact, mm.
_CONTACT = 1e-4
#: Bends closer to their limit than this (relative) keep it.
_ROUNDING = 1e-6
#: Steps along a tube in its outside diameters, and into how many each is divided where a body is near.
_STEP, _FINE = 0.2, 64


class OverlapError(DesignError):
    """A design that cannot be built; ``problems`` has one for every line of :func:`overlaps`."""


def refuse_overlaps(design: DesignLike, layout: ArrayLayout | None = None) -> None:
    """Refuse a design that cannot be built as it is laid out.

    Args:
        design: the array.
        layout: layout of the array, if you have it already.

    Raises:
        OverlapError: see :func:`overlaps`.
    """
    design = resolve_design(design)
    if is_wide_apart(design):
        return
    found = overlaps(design, lay_out(design) if layout is None else layout)
    if found:
        raise OverlapError.of_notes(design.name, found)


def buildability_notes(design: DesignLike, layout: ArrayLayout) -> tuple[str, ...]:
    """Sentences on what is drawn but could not be built as drawn; measuring it takes longer than laying it out.

    Args:
        design: the array.
        layout: where its parts lie.

    Returns:
        Microphones drawn schematically, then :func:`overlaps`.
    """
    design = resolve_design(design)
    return (*schematic_notes(design, layout), *overlaps(design, layout))


def schematic_notes(design: DesignLike, layout: ArrayLayout) -> tuple[str, ...]:
    """Sentences on the microphones whose tubes are drawn for the eye only: what is studied, not what overlaps."""
    design = resolve_design(design)
    notes = []
    for microphone in layout.microphones:
        drawn = []
        for port in microphone.ports:
            segment = 0 if port.end == 0 else design.lines[port.line].points
            tube = next(t for t in layout.tubes if (t.line, t.segment) == (port.line, segment))
            if tube.schematic:
                drawn.append(f"{tube.label} is {tube.tube.length:g} mm, drawn {path_length(tube.path):.1f} mm")
        if drawn:
            ends = counted(len(microphone.ports), "line end")
            notes.append(f"microphone {microphone.name} joins {ends} and is drawn schematically: {'; '.join(drawn)}")
    if notes:
        count = sum(tube.schematic for tube in layout.tubes)
        notes.insert(0, f"simulated study: not buildable as drawn; {count} microphone tubes are drawn schematically")
    return tuple(notes)


def overlaps(design: ArrayDesign, layout: ArrayLayout) -> tuple[str, ...]:
    """Name and measure everything of a layout that cannot be built.

    Checked in space: bodies (shells with their feet, housings with the seats of their boards) against bodies, tubes
    against bodies and against each other outside the walls they end in, the bend of tubes, and the walls between the
    ports of a shell. Tubes that are drawn schematically are left out: their way is not real.
    """
    bodies = _Bodies(design, layout)
    tubes = [_Tube(design, placed, bodies) for placed in layout.tubes if not placed.schematic]
    return (
        *_bodies_in_bodies(bodies),
        *_tubes_in_bodies(bodies, tubes),
        *_tubes_in_tubes(tubes),
        *_tight_bends(tubes),
        *_thin_webs(design, layout),
    )


class _Bodies:
    """Bodies by number: their names and the prisms they consist of."""

    def __init__(self, design: ArrayDesign, layout: ArrayLayout) -> None:
        self.names = [f"shell {p.number}" for p in layout.points] + [f"microphone {m.name}" for m in layout.microphones]
        self.point_at = {(p.line, p.place): k for k, p in enumerate(layout.points)}
        self.microphone_at = {m.name: len(layout.points) + k for k, m in enumerate(layout.microphones)}
        self.prisms = list(prisms(design, layout))
        self.reach = np.array([prism.reach for prism in self.prisms])
        self.origins = np.array([prism.frame.origin for prism in self.prisms])


class _Tube:
    """A tube where it is outside the walls that it ends in.

    Its way is a polyline; between its points an arc lies a little further out, by which the tube counts as thicker.
    """

    def __init__(self, design: ArrayDesign, placed: TubePlacement, bodies: _Bodies) -> None:
        self.placed, self.label = placed, placed.label
        line, tube = design.lines[placed.line], placed.tube
        shell, chamber = design.resonator.wall_thickness, design.microphone.wall_thickness
        first, last = placed.segment == 0, placed.segment == line.points
        self.ends = (
            bodies.microphone_at[line.between[0]] if first else bodies.point_at[placed.line, placed.segment - 1],
            bodies.microphone_at[line.between[1]] if last else bodies.point_at[placed.line, placed.segment],
        )
        walls = (chamber if first else shell, chamber if last else shell)
        self.bend = tightest_bend(placed.course)
        self.step = _STEP * tube.outer_diameter
        chord = float(np.linalg.norm(np.diff(placed.course[1:-1], axis=0), axis=1).max(initial=0.0))
        sag = 0.0 if math.isinf(self.bend) else (chord**2 + self.step**2) / (8 * self.bend)
        self.radius = tube.outer_diameter / 2 + sag
        self.points = resampled(placed.course, self.step, walls)
        self.gap = design.printing.glue_gap

    def beside(self, prism: Prism) -> Array:
        """Its points, (n, 3) float64, mm, that could get in the way of a prism.

        In a body that it ends in, only points that have left the wall by more than the tube is wide; of the seat on a
        chamber, those that are no longer in its socket.
        """
        if not prism.is_trunk or prism.body not in self.ends:
            return self.points
        outwards = self.points if prism.body == self.ends[0] else self.points[::-1]
        if len(prism.corners) == 1:
            return outwards[1 + math.ceil(2 * self.radius / self.step) :]
        along = outwards[1] - outwards[0]
        off = np.cross(outwards - outwards[0], along) / np.linalg.norm(along)
        return outwards[np.linalg.norm(off, axis=1) > self.gap]


def _bodies_in_bodies(bodies: _Bodies) -> Iterator[str]:
    worst: dict[tuple[int, int], float] = {}
    pairs = near_pairs(bodies.origins, bodies.origins, 2 * float(bodies.reach.max()))
    for i, j in sorted(pairs[pairs[:, 0] < pairs[:, 1]].tolist()):
        first, second = bodies.prisms[i], bodies.prisms[j]
        apart = float(np.linalg.norm(bodies.origins[i] - bodies.origins[j]))
        if first.body == second.body or apart > first.reach + second.reach:
            continue
        deep, pair = depth(first, second), (first.body, second.body)
        if deep > max(_CONTACT, worst.get(pair, 0.0)):
            worst[pair] = deep
    for (i, j), deep in worst.items():
        yield f"{bodies.names[i]} overlaps {bodies.names[j]} by {deep:.2g} mm"


def _tubes_in_bodies(bodies: _Bodies, tubes: list[_Tube]) -> Iterator[str]:
    if not tubes:
        return
    owner = np.repeat(np.arange(len(tubes)), [len(tube.points) for tube in tubes])
    reach = float(bodies.reach.max()) + max(tube.radius for tube in tubes)
    near = near_pairs(np.vstack([tube.points for tube in tubes]), bodies.origins, reach)
    found = np.unique(np.column_stack([owner[near[:, 0]], near[:, 1]]), axis=0).tolist()
    for tube, numbers in groupby(found, key=lambda pair: tubes[pair[0]]):
        worst: dict[int, float] = {}
        for _, number in numbers:
            prism = bodies.prisms[number]
            deep = tube.radius - _least_gap(prism, tube.beside(prism), tube.radius, tube.step)
            if deep > max(_CONTACT, worst.get(prism.body, 0.0)):
                worst[prism.body] = deep
        for body, deep in worst.items():
            yield f"{tube.label} passes {deep:.2g} mm inside {bodies.names[body]}"


def _least_gap(prism: Prism, points: Array, radius: float, step: float) -> float:
    """Distance of a prism from a polyline (n, 3), mm; exact only where it is below the radius."""
    if not len(points):
        return math.inf
    gaps = prism.gaps(points)
    nearest = int(np.argmin(gaps))
    if gaps[nearest] > radius + step:
        return float(gaps[nearest])
    around = points[max(nearest - 1, 0) : nearest + 2]
    at = np.linspace(0, len(around) - 1, 2 * _FINE + 1)
    fine = np.column_stack([np.interp(at, np.arange(len(around)), around[:, k]) for k in range(3)])
    return float(prism.gaps(fine).min())


def _tubes_in_tubes(tubes: list[_Tube]) -> Iterator[str]:
    if len(tubes) < 2:
        return
    owner = np.repeat(np.arange(len(tubes)), [len(tube.points) - 1 for tube in tubes])
    starts = np.vstack([tube.points[:-1] for tube in tubes])
    steps = np.vstack([np.diff(tube.points, axis=0) for tube in tubes])
    radius, step = (np.array([getattr(tube, name) for tube in tubes]) for name in ("radius", "step"))
    pairs = near_pairs(starts, starts, 2 * (radius + step).max())
    pairs = pairs[owner[pairs[:, 0]] < owner[pairs[:, 1]]]
    i, j = pairs.T
    deep = radius[owner[i]] + radius[owner[j]] - _apart(starts[i], steps[i], starts[j], steps[j])
    worst: dict[tuple[int, int], float] = {}
    for (a, b), d in zip(owner[pairs].tolist(), deep.tolist(), strict=True):
        if d > max(_CONTACT, worst.get((a, b), 0.0)):
            worst[a, b] = d
    for (a, b), d in sorted(worst.items()):
        yield f"{tubes[a].label} overlaps {tubes[b].label} by {d:.2g} mm"


def _apart(first: Array, along: Array, second: Array, across: Array) -> Array:
    """Distances of straight pieces that begin at places (n, 3) and go steps (n, 3), (n,) float64, mm.

    The nearest places of the lines through both, cut to the pieces one after the other (Ericson, Real-Time Collision
    Detection, 2005, section 5.1.9).
    """
    off = first - second

    def dot(a: Array, b: Array) -> Array:
        return np.einsum("nk,nk->n", a, b)

    aa, bb, ab, ao, bo = dot(along, along), dot(across, across), dot(along, across), dot(along, off), dot(across, off)
    square = aa * bb - ab**2
    flat = square <= 1e-12 * aa * bb
    s = np.where(flat, 0.0, np.clip((ab * bo - ao * bb) / np.where(flat, 1.0, square), 0, 1))
    t = np.clip((ab * s + bo) / bb, 0, 1)
    s = np.clip((ab * t - ao) / aa, 0, 1)
    return np.asarray(np.linalg.norm(off + s[:, None] * along - t[:, None] * across, axis=1))


def _tight_bends(tubes: list[_Tube]) -> Iterator[str]:
    for tube in tubes:
        # Below its own radius a tube would bend into itself, whatever is said of it.
        smallest = max(tube.placed.tube.smallest_bend_radius, tube.placed.tube.outer_diameter / 2)
        if tube.bend < smallest * (1 - _ROUNDING):
            yield (
                f"{tube.label} bends to a radius of {tube.bend:.2g} mm, below the {smallest:.3g} mm that it may be "
                "bent to"
            )


def _thin_webs(design: ArrayDesign, layout: ArrayLayout) -> Iterator[str]:
    """Ports of a shell that leave no wall between them, as :func:`geometry.solids.shell.build_shell` refuses them."""
    printing, radius = design.printing, design.resonator.cavity_diameter / 2
    height = design.resonator.port_axis_height
    known: dict[object, str] = {}
    for point in layout.points:
        first, second = ports = point.turned[0]
        shape = design.resonator_at(design.lines[point.line], point.place).cavity_shape
        if (ports, shape) not in known:
            mouths = [wall_distance(shape, radius, height, port.angle) for port in ports]
            known[ports, shape] = web_problem(
                (first, second), (mouths[0], mouths[1]), radius + printing.port_lip, printing.glue_gap
            )
        if known[ports, shape]:
            yield f"ports of shell {point.number} {known[ports, shape]}"
