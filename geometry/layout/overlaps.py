"""What of a layout cannot be built as drawn: shells, housings and tubes that get into each other's way."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from geometry.design.array_design import ArrayDesign
from geometry.layout.placement import ArrayLayout, TubePlacement
from geometry.plan.routing import path_length, resampled, tightest_bend

#: Overlaps below this are contact, mm.
_CONTACT = 1e-3
#: Bends closer to their limit than this (relative) keep it.
_ROUNDING = 1e-6
#: Points per rim of a body that is tilted against another.
_RIM = 180


def buildability_notes(design: ArrayDesign, layout: ArrayLayout) -> tuple[str, ...]:
    """Sentences on what is drawn but could not be built as drawn; measuring it takes longer than laying it out.

    Args:
        design: the array.
        layout: where its parts lie.

    Returns:
        Microphones drawn schematically, then every overlap of shells, housings and tubes and every bend that is too
        tight, by name and size.
    """
    return (*_schematic_notes(design, layout), *overlaps(design, layout))


def overlaps(design: ArrayDesign, layout: ArrayLayout) -> list[str]:
    """Name and measure every overlap of a layout.

    Checked in space: bodies (shells and microphone housings, as upright cylinders) against bodies, tubes against
    the bodies they do not end in, tubes against tubes outside the stop shoulders of their ports, and the bend of
    tubes. Tubes that are drawn schematically are left out: their way is not real.
    """
    bodies = _Bodies(design, layout)
    tubes = [tube for tube in layout.tubes if not tube.schematic]
    lip = design.printing.port_lip
    samples = [resampled(tube.course, 0.2 * tube.tube.outer_diameter, min(lip, tube.tube.length / 4)) for tube in tubes]
    return [
        *_bodies_in_bodies(bodies),
        *_tubes_in_bodies(design, layout, bodies, tubes, samples),
        *_tubes_in_tubes(tubes, samples),
        *_tight_bends(tubes),
    ]


def _schematic_notes(design: ArrayDesign, layout: ArrayLayout) -> list[str]:
    notes = []
    for microphone in layout.microphones:
        drawn = []
        for port in microphone.ports:
            segment = 0 if port.end == 0 else design.lines[port.line].points
            tube = next(t for t in layout.tubes if (t.line, t.segment) == (port.line, segment))
            if tube.schematic:
                drawn.append(f"{tube.label} is {tube.tube.length:g} mm, drawn {path_length(tube.path):.1f} mm")
        if drawn:
            ends = f"{len(microphone.ports)} line end" + ("s" if len(microphone.ports) > 1 else "")
            notes.append(f"microphone {microphone.name} joins {ends} and is drawn schematically: {'; '.join(drawn)}")
    if notes:
        count = sum(tube.schematic for tube in layout.tubes)
        notes.insert(0, f"simulated study: not buildable as drawn; {count} microphone tubes are drawn schematically")
    return notes


class _Bodies:
    """Shells and microphone housings as cylinders: names, frames, radii (n,) and heights of both ends (n, 2), mm."""

    def __init__(self, design: ArrayDesign, layout: ArrayLayout) -> None:
        resonator, microphone = design.resonator, design.microphone
        shell = (-resonator.floor_thickness, resonator.cavity_height)
        floor = resonator.port_axis_height - microphone.chamber_height / 2
        top = floor + microphone.chamber_height + microphone.sound_hole_length + microphone.package_height
        housing = (floor - microphone.wall_thickness, top)
        across = max(microphone.chamber_diameter, *microphone.board_size) / 2 + microphone.wall_thickness
        placed = [(f"shell {p.number}", layout.frame(p), resonator.outer_diameter / 2, shell) for p in layout.points]
        placed += [(f"microphone {m.name}", layout.frame(m), across, housing) for m in layout.microphones]
        self.names = [name for name, _, _, _ in placed]
        self.frames = [frame for _, frame, _, _ in placed]
        self.radii = np.array([radius for _, _, radius, _ in placed])
        self.heights = np.array([heights for _, _, _, heights in placed])
        self.tree = cKDTree(np.array([frame.origin for frame in self.frames]))
        self.reach = float(np.hypot(self.radii, np.abs(self.heights).max(axis=1)).max())

    def depth(self, i: int, j: int) -> float:
        """How far two bodies are in each other, mm; negative where they are not."""
        if math.isclose(float(np.dot(self.frames[i].axes[2], self.frames[j].axes[2])), 1.0, abs_tol=1e-12):
            x, y, _ = self.frames[j].seen(np.array([self.frames[i].origin]))[0]
            return float(self.radii[i] + self.radii[j] - math.hypot(x, y))
        return max(self._rims_inside(i, j), self._rims_inside(j, i))

    def _rims_inside(self, i: int, j: int) -> float:
        """How deep the rims of body i are inside body j, mm."""
        turns = np.linspace(0, 2 * np.pi, _RIM, endpoint=False)
        rim = self.radii[i] * np.column_stack([np.cos(turns), np.sin(turns)])
        own = np.vstack([np.column_stack([rim, np.full(_RIM, z)]) for z in self.heights[i]])
        in_space = own @ np.asarray(self.frames[i].axes) + np.asarray(self.frames[i].origin)
        x, y, z = self.frames[j].seen(in_space).T
        low, high = self.heights[j]
        return float(np.minimum(np.minimum(self.radii[j] - np.hypot(x, y), z - low), high - z).max())

    def gap(self, body: int, path: NDArray[np.float64]) -> float:
        """Distance of a body from the nearest of points (n, 3) in space, mm; negative inside."""
        x, y, z = self.frames[body].seen(path).T
        low, high = self.heights[body]
        beside, above = np.hypot(x, y) - self.radii[body], np.maximum(low - z, z - high)
        outside = np.hypot(np.maximum(beside, 0), np.maximum(above, 0))
        # In plan the way out of a body is sideways, although its lid or floor may be nearer.
        return float(np.where(above > 0, outside, beside).min())


def _bodies_in_bodies(bodies: _Bodies) -> list[str]:
    notes = []
    for i, j in sorted(bodies.tree.query_pairs(2 * bodies.reach)):
        depth = bodies.depth(i, j)
        if depth > _CONTACT:
            notes.append(f"{bodies.names[i]} overlaps {bodies.names[j]} by {depth:.2g} mm")
    return notes


def _tubes_in_bodies(
    design: ArrayDesign,
    layout: ArrayLayout,
    bodies: _Bodies,
    tubes: list[TubePlacement],
    samples: list[NDArray[np.float64]],
) -> list[str]:
    point_at = {(p.line, p.place): k for k, p in enumerate(layout.points)}
    microphone_at = {m.name: len(layout.points) + k for k, m in enumerate(layout.microphones)}
    notes = []
    for tube, path in zip(tubes, samples, strict=True):
        line = design.lines[tube.line]
        before = microphone_at[line.between[0]] if tube.segment == 0 else point_at[tube.line, tube.segment - 1]
        last = tube.segment == line.points
        after = microphone_at[line.between[1]] if last else point_at[tube.line, tube.segment]
        half = tube.tube.outer_diameter / 2
        near = np.concatenate(bodies.tree.query_ball_point(path, bodies.reach + half)).astype(int)
        for body in sorted(set(near.tolist()) - {before, after}):
            gap = bodies.gap(body, path) - half
            if gap < -_CONTACT:
                notes.append(f"{tube.label} passes {-gap:.2g} mm inside {bodies.names[body]}")
    return notes


def _tubes_in_tubes(tubes: list[TubePlacement], samples: list[NDArray[np.float64]]) -> list[str]:
    if not tubes:
        return []
    owner = np.repeat(np.arange(len(tubes)), [len(path) for path in samples])
    outer = np.array([tube.tube.outer_diameter for tube in tubes])
    points = np.vstack(samples)
    pairs = cKDTree(points).query_pairs(outer.max(), output_type="ndarray")
    pairs = pairs[owner[pairs[:, 0]] != owner[pairs[:, 1]]]
    apart = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    depth = (outer[owner[pairs[:, 0]]] + outer[owner[pairs[:, 1]]]) / 2 - apart
    worst: dict[tuple[int, int], float] = {}
    for (i, j), d in zip(np.sort(owner[pairs], axis=1).tolist(), depth.tolist(), strict=True):
        if d > max(_CONTACT, worst.get((i, j), 0.0)):
            worst[i, j] = d
    return [f"{tubes[i].label} overlaps {tubes[j].label} by {d:.2g} mm" for (i, j), d in sorted(worst.items())]


def _tight_bends(tubes: list[TubePlacement]) -> list[str]:
    notes = []
    for tube in tubes:
        radius, smallest = tightest_bend(tube.course), tube.tube.smallest_bend_radius
        if radius < smallest * (1 - _ROUNDING):
            notes.append(
                f"{tube.label} bends to a radius of {radius:.2g} mm, below the {smallest:.3g} mm that it may be bent to"
            )
    return notes
