"""Pockets and channels: what the parts of an array take out of the wall around them, open outwards."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from geometry.body.samples import Samples
from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import membrane_top
from geometry.ground.typed import Array
from geometry.layout.placement import ArrayLayout, TubePlacement
from geometry.layout.prism import Prism, prisms

if TYPE_CHECKING:
    import manifold3d

#: Gap beside parts and below them, mm.
CLEARANCE, BELOW = 0.1, 0.05
#: How far pockets reach out of the wall, mm, so that they are open where it is bent.
_OUT = 1.5
#: Corners around an outline and around a tube; pieces that a tube is divided into.
_AROUND, _ROUND, _PIECES = 48, 16, 14


@dataclass(frozen=True)
class Pocket:
    """Space that a part takes out of a wall."""

    label: str
    """Part that lies in it: ``shell 3``, ``microphone A``, ``tube 2 of line 1``."""
    joins: frozenset[str]
    """Labels of the pockets that open into this one by design, and its own."""
    solid: manifold3d.Manifold
    """The space, mm."""


def pockets(design: ArrayDesign, layout: ArrayLayout, ground: Samples, wall: float) -> list[Pocket]:
    """Pockets of all shells and housings, then the channels of all tubes.

    Each reaches from below its part straight outwards, so that lines which were glued and tested on the bench are laid
    in from outside, and glue and wires have access from there.

    Args:
        design: the array.
        layout: where its parts lie.
        ground: samples of the body.
        wall: height of the outside of the wall above the body, mm: 0 for the body itself.
    """
    names = [f"shell {p.number}" for p in layout.points] + [f"microphone {m.name}" for m in layout.microphones]
    top = membrane_top(design)
    found: dict[int, list[manifold3d.Manifold]] = {}
    for prism in prisms(design, layout):
        found.setdefault(prism.body, []).append(_upright(prism, max(top, prism.heights[1]) + _OUT))
    joins: dict[str, set[str]] = {name: {name} for name in names}
    channels = []
    for tube in layout.tubes:
        ends = _ends(design, layout, tube)
        for end in ends:
            joins[end].add(tube.label)
        channels.append(Pocket(tube.label, frozenset((tube.label, *ends)), _channel(tube, ground, wall)))
    housings = [Pocket(names[body], frozenset(joins[names[body]]), _union(own)) for body, own in found.items()]
    return [*housings, *channels]


def _ends(design: ArrayDesign, layout: ArrayLayout, tube: TubePlacement) -> tuple[str, str]:
    """Labels of the two parts that a tube joins."""
    line = design.lines[tube.line]
    own = {p.place: p.number for p in layout.points if p.line == tube.line}
    first = f"microphone {line.between[0]}" if tube.segment == 0 else f"shell {own[tube.segment - 1]}"
    last = f"microphone {line.between[1]}" if tube.segment == line.points else f"shell {own[tube.segment]}"
    return first, last


def _union(solids: list[manifold3d.Manifold]) -> manifold3d.Manifold:
    import manifold3d

    return solids[0] if len(solids) == 1 else manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)


def _upright(prism: Prism, high: float) -> manifold3d.Manifold:
    """Space of a prism with its clearance, from below it up to a height, mm."""
    import manifold3d

    angles = 2 * math.pi * np.arange(_AROUND) / _AROUND
    # Corners lie outside of the circle, so that no chord cuts into it.
    radius = (prism.radius + CLEARANCE) / math.cos(math.pi / _AROUND)
    ring = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    plan = (prism.corners[:, None] + ring[None]).reshape(-1, 2)
    ends = [np.column_stack([plan, np.full(len(plan), z)]) for z in (prism.heights[0] - BELOW, high)]
    axes = np.asarray(prism.frame.axes)
    return manifold3d.Manifold.hull_points(np.vstack(ends) @ axes + np.asarray(prism.frame.origin))


def _channel(tube: TubePlacement, ground: Samples, wall: float) -> manifold3d.Manifold:
    """Space along a tube: round below, with straight sides outwards."""
    import manifold3d

    course = _evenly(tube.course, _PIECES + 1)
    foot, normals = ground.projected(course)
    height = np.einsum("nc,nc->n", course - foot, normals)
    up = np.maximum(wall - height, 0.0) + _OUT
    bend = np.linalg.norm(np.diff(course, 2, axis=0), axis=1).max(initial=0.0) / 8
    ball = _ball(tube.tube.outer_diameter / 2 + CLEARANCE + float(bend))
    pieces = []
    for (start, end), (lift, other) in zip(pairwise(course), pairwise(up[:, None] * normals), strict=True):
        clouds = [at + ball for at in (start, end, start + lift, end + other)]
        pieces.append(manifold3d.Manifold.hull_points(np.vstack(clouds)))
    return _union(pieces)


def _ball(radius: float) -> Array:
    """Corners of a facetted ball that holds a round one of a radius, (n, 3) float64, mm."""
    outer = radius / math.cos(math.pi / _ROUND) ** 2
    up, around = np.meshgrid(
        np.pi * (np.arange(_ROUND // 2 + 1) / (_ROUND // 2) - 0.5), 2 * np.pi * np.arange(_ROUND) / _ROUND
    )
    directions = [np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)]
    return np.unique(np.round(outer * np.stack([each.ravel() for each in directions], axis=1), 12), axis=0)


def swept(course: Array, radius: float) -> manifold3d.Manifold:
    """A round rod along a polyline (n, 3), mm: its cross-sections are turned as little as possible."""
    import manifold3d

    along = np.gradient(course, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    across = np.cross(along[0], np.roll(along[0], 1))
    angles = 2 * math.pi * np.arange(_ROUND) / _ROUND
    rings = []
    for at, way in zip(course, along, strict=True):
        across = across - (across @ way) * way
        across = across / np.linalg.norm(across)
        ring = np.cos(angles)[:, None] * across + np.sin(angles)[:, None] * np.cross(way, across)
        rings.append(at + radius * ring)
    count, k = len(course), np.arange(_ROUND)
    following = (k + 1) % _ROUND
    facets = []
    for base in _ROUND * np.arange(count - 1):
        facets.append(np.column_stack([base + k, base + following, base + _ROUND + following]))
        facets.append(np.column_stack([base + k, base + _ROUND + following, base + _ROUND + k]))
    first, last = _ROUND * count, _ROUND * count + 1
    facets.append(np.column_stack([np.full(_ROUND, first), following, k]))
    facets.append(np.column_stack([np.full(_ROUND, last), _ROUND * (count - 1) + k, _ROUND * (count - 1) + following]))
    places = np.vstack([*rings, course[:1], course[-1:]])
    mesh = manifold3d.Mesh64(places, np.array(np.vstack(facets), np.uint64, order="C"))
    return manifold3d.Manifold(mesh)


def _evenly(course: Array, count: int) -> Array:
    """Places along a polyline, evenly by its length; (count, 3) float64, mm."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(course, axis=0), axis=1))])
    at = np.linspace(0.0, along[-1], count)
    return np.column_stack([np.interp(at, along, course[:, k]) for k in range(3)])
