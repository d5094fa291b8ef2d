"""A tube wound on a cylinder: its centre line, and the air of a bent piece of its bore as a swept mesh.

The mesh repeats one curved mesh of the section along the centre line. The same section along a straight line
of the same length gives a mesh of the same topology, so that what the mesh does wrong cancels in a comparison;
meshes of a CAD kernel's solids would differ by more than a bend does.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.air.curved_tetrahedra import EDGES
from geometry.air.mesh import WALL, SolidMesh, checked_mesh
from geometry.ground.argument_checks import out_of_range
from geometry.ground.typed import Array

#: Names of the ends of a swept mesh.
FIRST, LAST = "first", "last"


@dataclass(frozen=True)
class Winding:
    """Centre line of a tube: straight, a circular or helical arc about the z axis, straight again; mm.

    The straight ends follow the tangents of the arc. ``at(0)`` lies at the azimuth 0 where the arc begins.
    """

    diameter: float
    """Diameter of the cylinder that holds the arc, mm."""
    angle: float
    """Azimuth wound, degrees."""
    pitch: float = 0.0
    """Rise per turn, mm; 0 gives a flat arc."""

    @property
    def arc_length(self) -> float:
        """Length of the arc, mm."""
        return math.radians(self.angle) * self._per_radian

    @property
    def curvature(self) -> float:
        """Curvature of the arc, 1/mm: r / (r^2 + b^2), b = pitch / 2 pi."""
        return self.diameter / 2 / self._per_radian**2

    @property
    def torsion(self) -> float:
        """Torsion of the arc, 1/mm: b / (r^2 + b^2)."""
        return self.pitch / (2 * math.pi) / self._per_radian**2

    @property
    def _per_radian(self) -> float:
        return math.hypot(self.diameter / 2, self.pitch / (2 * math.pi))

    def at(self, along: Array) -> tuple[Array, Array]:
        """Points of the centre line and frames across it.

        Args:
            along: (n,) float64, mm, the arc from 0 to ``arc_length``, the straight ends outside.

        Returns:
            Points (n, 3) float64, mm, and frames (n, 3, 3) float64: rows away from the axis, across, and along the
            line.
        """
        along = np.asarray(along, dtype=np.float64)
        on_arc = np.clip(along, 0.0, self.arc_length)
        turned = on_arc / self._per_radian
        cos, sin, zero = np.cos(turned), np.sin(turned), np.zeros_like(turned)
        radius, rise = self.diameter / 2, self.pitch / (2 * math.pi)
        outward = np.stack([cos, sin, zero], -1)
        tangent = np.stack([-radius * sin, radius * cos, zero + rise], -1) / self._per_radian
        points = radius * outward + np.stack([zero, zero, rise * turned], -1)
        points += (along - on_arc)[:, None] * tangent
        return points, np.stack([outward, np.cross(tangent, outward), tangent], 1)


def closest_pitch(diameter: float, outside: float) -> float:
    """Rise per turn (mm) at which the turns of a tube of that outside diameter (mm) just touch.

    The distance of neighbouring turns is the pitch times the cosine of the lead angle.

    Raises:
        Refusal: the tube is as wide as the circumference of its cylinder.
    """
    fraction = outside / (math.pi * diameter)
    if not fraction < 1:
        raise out_of_range("outside", outside, f"below the circumference {math.pi * diameter:g} mm", "mm")
    return outside / math.sqrt((1 - fraction) * (1 + fraction))


def swept_mesh(section: Array, triangles: NDArray[np.int64], winding: Winding | None, along: Array) -> SolidMesh:
    """Curved second-order tetrahedra of a disc swept along a centre line; its ends are ``FIRST`` and ``LAST``.

    Every layer of prisms is cut into tetrahedra in the same way; corners and the middles of edges lie exactly
    on the swept shape.

    Args:
        section: (n, 2) float64 nodes of the disc around (0, 0), mm: away from the axis of the winding, and across.
        triangles: (m, 6) int64 second-order triangles, counter-clockwise: corners, then the middles of 01, 12, 20.
        winding: the centre line; None for a straight one.
        along: (k + 1,) float64 ascending places of the layers, mm; the corners of a bend should be among them.

    Raises:
        InvertedElementsError: a layer is too long, or the bend too tight for the section.
    """
    layers, n = len(along) - 1, len(section)
    levels = np.interp(np.arange(2 * layers + 1), 2 * np.arange(layers + 1), along)
    if winding is None:
        centres = np.stack([0 * levels, 0 * levels, levels], -1)
        frames = np.broadcast_to(np.eye(3), (len(levels), 3, 3))
    else:
        centres, frames = winding.at(levels)
    nodes = (centres[:, None] + np.einsum("ni,lid->lnd", section, frames[:, :2])).reshape(-1, 3)

    middle = np.full((n, n), -1, dtype=np.int64)
    corners = triangles[:, :3]
    for k in range(3):
        a, b = corners[:, k], corners[:, (k + 1) % 3]
        middle[a, b] = middle[b, a] = triangles[:, 3 + k]
    vertex = np.unique(corners)
    middle[vertex, vertex] = vertex
    # Ordered by number, neighbours cut their common side along the same diagonal.
    low, mid, high = np.sort(corners, axis=1).T
    place = np.concatenate([np.stack(tetrahedron, 1) for tetrahedron in (
        (low, mid, high, high), (low, mid, mid, high), (low, low, mid, high))])  # fmt: skip
    level = np.repeat([[0, 0, 0, 2], [0, 0, 2, 2], [0, 2, 2, 2]], len(corners), axis=0)
    first, second = np.array(EDGES).T
    place = np.hstack([place, middle[place[:, first], place[:, second]]])
    level = np.hstack([level, (level[:, first] + level[:, second]) // 2])
    one_layer = place + n * level
    tetrahedra = (one_layer[None] + 2 * n * np.arange(layers)[:, None, None]).reshape(-1, 10)
    tetrahedra = _right_handed(nodes, tetrahedra)

    ends = {FIRST: corners, LAST: corners + 2 * layers * n}
    directed = np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)])
    _, first_seen, times = np.unique(np.sort(directed, axis=1), axis=0, return_index=True, return_counts=True)
    rim = np.sort(directed[first_seen[times == 1]], axis=1)
    a, b = rim.T
    side = np.concatenate([np.stack([a, b, b + 2 * n], 1), np.stack([a, a + 2 * n, b + 2 * n], 1)])
    wall = (side[None] + 2 * n * np.arange(layers)[:, None, None]).reshape(-1, 3)
    normals = {FIRST: -frames[0, 2], LAST: frames[-1, 2]}
    # Pappus: the centre line runs through the middle of the disc.
    volume = math.pi * float(np.max(np.sum(section**2, 1))) * (along[-1] - along[0])
    return checked_mesh(nodes, tetrahedra, {**ends, WALL: wall}, normals, volume)


def _right_handed(nodes: Array, tetrahedra: NDArray[np.int64]) -> NDArray[np.int64]:
    """Tetrahedra with positive volume: two corners exchanged where it is negative."""
    origin, *others = (nodes[tetrahedra[:, k]] for k in range(4))
    left = np.linalg.det(np.stack([other - origin for other in others], 1)) < 0
    mirrored = tetrahedra[:, [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]]
    return np.where(left[:, None], mirrored, tetrahedra)
