"""Overhangs and cups of a part, measured on its facets, each with the place of the worst spot. Lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from geometry.ground.typed import Array

if TYPE_CHECKING:
    from geometry.solids.measure import Tessellation

Place = tuple[float, float, float]

#: Where an overhang is probed for its middle: this many places per patch.
_SAMPLES = 1000
#: The grid in which cups are looked for: steps per narrowest hole and across the part, cells in all at most.
_STEPS_PER_HOLE, _STEPS_ACROSS, _MOST_CELLS = 2.5, 12, 3_000_000
#: Facets and grid cells treated at once, to bound the memory.
_BLOCK = 2_000_000


@dataclass(frozen=True)
class Spot:
    """A measure and where it is."""

    value: float
    """The measure: a length in mm, a volume in mm^3."""
    place: Place | None
    """Position in the part's own coordinates, mm; None where there is no single place."""


@dataclass(frozen=True)
class Overhang:
    """An overhang without support."""

    span: float
    """Diameter of the widest circle in any one patch that hangs, mm."""
    place: Place | None
    """Centre of that circle, mm, in the part's own coordinates; None where nothing hangs."""
    area: float
    """Area of all that hangs, mm^2."""


class Skin:
    """The facets of a part with areas and outward normals, those of no area left out."""

    def __init__(self, facets: Tessellation) -> None:
        corners = facets.vertices[facets.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = np.linalg.norm(normals, axis=1)
        keep = lengths > 1e-12
        self.vertices, self.triangles = facets.vertices, facets.triangles[keep]
        self.corners, self.faces = corners[keep], facets.faces[keep]
        self.areas, self.normals = lengths[keep] / 2, normals[keep] / lengths[keep, None]


def inside(corners: Array, random: np.random.Generator) -> Array:
    """A random place in each triangle, uniform in its area, from barycentric coordinates.

    Args:
        corners: (n, 3, 3) float64, mm: triangle, corner, coordinate.
        random: where the numbers come from.

    Returns:
        (n, 3) float64, mm.
    """
    a, b = random.random((2, len(corners), 1))
    root = np.sqrt(a)
    return np.asarray((1 - root) * corners[:, 0] + root * (1 - b) * corners[:, 1] + root * b * corners[:, 2])


# -- overhangs ------------------------------------------------------------------------------------------------
def overhangs(facets: Tessellation, angle: float, upside_down: bool = False) -> Overhang:
    """Overhangs of a part built along z: faces that look down flatter than an angle, off the build plate.

    The widest circle is found on samples: a few per cent too small.

    Args:
        facets: of the part.
        angle: from the horizontal, degrees.
        upside_down: built from its top.
    """
    skin = Skin(facets)
    chosen = np.flatnonzero(_hanging(skin, angle, upside_down))
    if not len(chosen):
        return Overhang(0.0, None, 0.0)
    random = np.random.default_rng(0)
    triangles = skin.triangles[chosen]
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, edge_of = np.unique(edges, axis=0, return_inverse=True)
    edge_of = edge_of.reshape(-1)
    owner = np.repeat(np.arange(len(chosen)), 3)
    shared = coo_array((np.ones(len(owner)), (owner, edge_of)), shape=(len(chosen), len(unique))).tocsr()
    patches, patch = connected_components(shared @ shared.T, directed=False)
    border = np.bincount(edge_of)[edge_of] == 1
    span, place = 0.0, None
    for index in range(patches):
        own = chosen[patch == index]
        samples = inside(skin.corners[random.choice(own, _SAMPLES, p=skin.areas[own] / skin.areas[own].sum())], random)
        rim = skin.vertices[edges[border & (patch[owner] == index)]][:, :, :2]
        inner = _distances(samples[:, :2], rim)
        worst = int(np.argmax(inner))
        if 2 * inner[worst] > span:
            x, y, z = samples[worst].tolist()
            span, place = 2 * float(inner[worst]), (x, y, z)
    return Overhang(span, place, float(skin.areas[chosen].sum()))


def hanging_area(facets: Tessellation, angle: float, upside_down: bool = False) -> float:
    """The area, mm^2, of what :func:`overhangs` finds, without looking for its widest circle."""
    skin = Skin(facets)
    return float(skin.areas[_hanging(skin, angle, upside_down)].sum())


def _hanging(skin: Skin, angle: float, upside_down: bool) -> NDArray[np.bool_]:
    sense = -1.0 if upside_down else 1.0
    heights = sense * skin.corners[:, :, 2]
    hangs = -sense * skin.normals[:, 2] > math.cos(math.radians(angle)) + 1e-9
    return np.asarray(hangs & (heights.max(axis=1) > heights.min() + 1e-6))


def _distances(points: Array, segments: Array) -> Array:
    """Distance of (n, 2) points from the nearest of (m, 2, 2) segments, in blocks of segments."""
    nearest = np.full(len(points), np.inf)
    for start in range(0, len(segments), 1000):
        a, b = segments[start : start + 1000, 0], segments[start : start + 1000, 1]
        along = b - a
        length = np.maximum(np.einsum("ij,ij->i", along, along), 1e-30)
        to = points[:, None] - a[None]
        fraction = np.clip(np.einsum("ijk,jk->ij", to, along) / length, 0, 1)
        gap = np.linalg.norm(to - fraction[:, :, None] * along, axis=2)
        nearest = np.minimum(nearest, gap.min(axis=1))
    return nearest


# -- cups -----------------------------------------------------------------------------------------------------
def sealed_cup(facets: Tessellation, narrowest_hole: float, upside_down: bool = False) -> Spot:
    """Largest volume that the part and the film under the resin enclose at some layer of the print, mm^3.

    The part hangs from the plate and grows towards the film; what of its air has no way out sideways is held by
    the film like a sucker. Found on a grid that resolves the narrowest hole, as far as the memory allows.

    Args:
        facets: of the part.
        narrowest_hole: vents narrower than this need not be seen, mm.
        upside_down: built from its top.
    """
    skin = Skin(facets)
    low, size = skin.vertices.min(axis=0), np.ptp(skin.vertices, axis=0)
    finest = min(narrowest_hole / _STEPS_PER_HOLE, float(size.min()) / _STEPS_ACROSS)
    step = max(finest, float(np.prod(size) / _MOST_CELLS) ** (1 / 3))
    solid = _grid(skin, low, size, step)
    order = range(solid.shape[2])
    groups = _Groups()
    before = np.zeros(solid.shape[:2], dtype=np.int64)
    largest, place = 0.0, None
    for layer in reversed(order) if upside_down else order:
        labels, count = ndimage.label(~solid[:, :, layer])
        labels, shown = groups.add(labels, count)
        touching = (labels > 0) & (before > 0)
        bound = shown.stop  # more than any group before: two numbers as one, which sorts much faster than pairs
        for pair in np.unique(labels[touching] * bound + before[touching]).tolist():
            groups.join(*divmod(pair, bound))
        cells, root = groups.largest_closed(shown)
        if cells * step**3 > largest:
            i, j = np.argwhere(labels > 0)[np.flatnonzero([groups.root(k) == root for k in labels[labels > 0]])[0]]
            x, y, z = (low + (np.array([i - 1, j - 1, layer]) + 0.5) * step).tolist()
            largest, place = cells * step**3, (x, y, z)
        before = labels
    return Spot(largest, place)


class _Groups:
    """Connected air of the layers printed so far: group 0 is the outside."""

    def __init__(self) -> None:
        self._parent = [0]
        self._cells = [0]

    def add(self, labels: NDArray[Any], count: int) -> tuple[NDArray[np.int64], range]:
        """New groups for the labels of a layer, in it and in all; what touches its border or corner is outside."""
        shift = len(self._parent) - 1
        self._parent += range(shift + 1, shift + 1 + count)
        self._cells += np.bincount(labels.ravel(), minlength=count + 1)[1:].tolist()
        placed = np.where(labels > 0, labels.astype(np.int64) + shift, 0)
        self.join(int(placed[0, 0]), 0)
        return placed, range(shift + 1, shift + 1 + count)

    def root(self, group: int) -> int:
        """The group that a group was joined to."""
        while self._parent[group] != group:
            self._parent[group] = self._parent[self._parent[group]]
            group = self._parent[group]
        return group

    def join(self, first: int, second: int) -> None:
        """Make two groups one; the outside swallows the other."""
        keep, drop = sorted((self.root(first), self.root(second)))
        if keep != drop:
            self._parent[drop] = keep
            self._cells[keep] += self._cells[drop]

    def largest_closed(self, shown: range) -> tuple[int, int]:
        """Cells and root of the largest group that shows in a layer and is not outside."""
        roots = {self.root(group) for group in shown} - {0}
        return max(((self._cells[root], root) for root in roots), default=(0, 0))


def _grid(skin: Skin, low: Array, size: Array, step: float) -> NDArray[np.bool_]:
    """Mask of the cells of a grid around a part that are solid at their centres, with one empty cell at its sides."""
    counts = np.maximum(np.ceil(size / step).astype(int), 1)
    change = np.zeros((counts[0] + 2, counts[1] + 2, counts[2] + 1), dtype=np.int32)
    for i, j, z, enters in _crossings(skin, low, step, counts):
        layer = np.clip(np.ceil((z - low[2]) / step - 0.5), 0, counts[2]).astype(int)
        np.add.at(change, (i + 1, j + 1, layer), np.where(enters, 1, -1))
    return np.asarray(np.cumsum(change, axis=2)[:, :, :-1] > 0)


def _crossings(
    skin: Skin, low: Array, step: float, counts: NDArray[np.int_]
) -> Iterator[tuple[NDArray[np.int_], NDArray[np.int_], Array, NDArray[np.bool_]]]:
    """Crossings of facets by vertical lines through the cells' centres: column, row, height, True into the solid."""
    upright = np.abs(skin.normals[:, 2]) > 1e-9
    corners, enters = skin.corners[upright], skin.normals[upright, 2] < 0
    # Lines a hair off the centres do not run along edges, which lie at round numbers.
    flat = (corners[:, :, :2] - low[:2]) / step - 0.5 - np.array([1.37e-4, 2.11e-4])
    first = np.clip(np.ceil(flat.min(axis=1)), 0, None).astype(int)
    last = np.minimum(np.floor(flat.max(axis=1)), counts[:2] - 1).astype(int)
    spans = np.maximum(last - first + 1, 0)
    pairs = spans.prod(axis=1)
    kept = np.flatnonzero(pairs)
    blocks = np.split(kept, np.flatnonzero(np.diff(np.cumsum(pairs[kept]) // _BLOCK)) + 1)
    for block in blocks:
        which = np.repeat(block, pairs[block])
        rank = np.arange(len(which)) - np.repeat(np.cumsum(pairs[block]) - pairs[block], pairs[block])
        i, j = first[which, 0] + rank // spans[which, 1], first[which, 1] + rank % spans[which, 1]
        a, b, c = (flat[which, k] for k in range(3))
        whole = _turn(a, b, c)
        here = np.column_stack([i, j]).astype(float)
        u, v = _turn(a, here, c) / whole, _turn(a, b, here) / whole
        hit = (u >= 0) & (v >= 0) & (u + v <= 1)
        z = corners[which, :, 2][hit]
        height = z[:, 0] + u[hit] * (z[:, 1] - z[:, 0]) + v[hit] * (z[:, 2] - z[:, 0])
        yield i[hit], j[hit], height, enters[which][hit]


def _turn(a: Array, b: Array, c: Array) -> Array:
    """Twice the signed area of (n, 2) triangles."""
    return np.asarray((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0]))
