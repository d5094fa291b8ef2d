"""What of a layout cannot be built as drawn: shells, housings and tubes that get into each other's way."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from geometry.design import ArrayDesign
from geometry.routing import bow_angle, bow_radius, resampled

if TYPE_CHECKING:
    from geometry.layout import ArrayLayout, TubePlacement

#: Overlaps below this are contact, mm.
_CONTACT = 1e-3


def overlaps(design: ArrayDesign, layout: ArrayLayout) -> list[str]:
    """Name and measure every overlap of a layout.

    Checked in plan: bodies (shells and microphone housings) against bodies, tubes against the bodies they
    do not end in, tubes against tubes outside the stop shoulders of their ports, and the bend of bowed
    tubes. Tubes that are drawn schematically are left out: their way is not real.
    """
    bodies = _Bodies(design, layout)
    tubes = [tube for tube in layout.tubes if not tube.schematic]
    lip = design.printing.port_lip
    samples = [
        resampled(tube.path[:, :2], 0.2 * tube.tube.outer_diameter, min(lip, tube.tube.length / 4)) for tube in tubes
    ]
    return [
        *_bodies_in_bodies(bodies),
        *_tubes_in_bodies(design, layout, bodies, tubes, samples),
        *_tubes_in_tubes(tubes, samples),
        *_tight_bends(design, layout),
    ]


class _Bodies:
    """Centres (n, 2) and radii (n,) of shells and microphone housings in plan, with their names."""

    def __init__(self, design: ArrayDesign, layout: ArrayLayout) -> None:
        housing = design.microphone.chamber_diameter / 2 + design.microphone.wall_thickness
        placed = [(f"shell {p.number}", p.position, design.resonator.outer_diameter / 2) for p in layout.points]
        placed += [(f"microphone {m.name}", m.position, housing) for m in layout.microphones]
        self.names = [name for name, _, _ in placed]
        self.centres = np.array([centre for _, centre, _ in placed])
        self.radii = np.array([radius for _, _, radius in placed])
        self.tree = cKDTree(self.centres)


def _bodies_in_bodies(bodies: _Bodies) -> list[str]:
    notes = []
    for i, j in sorted(bodies.tree.query_pairs(2 * bodies.radii.max())):
        depth = bodies.radii[i] + bodies.radii[j] - math.dist(bodies.centres[i], bodies.centres[j])
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
        near = bodies.tree.query_ball_point(path, bodies.radii.max() + half)
        for body in sorted({k for found in near for k in found} - {before, after}):
            gap = np.linalg.norm(path - bodies.centres[body], axis=1).min() - bodies.radii[body] - half
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


def _tight_bends(design: ArrayDesign, layout: ArrayLayout) -> list[str]:
    """Bows tighter than the sheath's own diameter, where a sleeve of plastic kinks (assumed limit)."""
    cavity, outer = design.resonator.cavity_diameter / 2, design.resonator.outer_diameter / 2
    centres = {(p.line, p.place): p.position for p in layout.points}
    notes = []
    for tube in layout.tubes:
        if not 0 < tube.segment < design.lines[tube.line].points:
            continue
        distance = math.dist(centres[tube.line, tube.segment - 1], centres[tube.line, tube.segment])
        radius = bow_radius(bow_angle(tube.tube.length, distance, cavity, outer), distance, outer)
        if radius < tube.tube.outer_diameter:
            notes.append(
                f"{tube.label} bends to a radius of {radius:.2g} mm, below its outside diameter "
                f"{tube.tube.outer_diameter:g} mm"
            )
    return notes
