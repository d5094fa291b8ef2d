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
class Cups:
    """Volumes that a part and the film under the resin enclose while it is printed.

    The part hangs from the plate and grows towards the film; what of its air has no way out sideways is held by
    the film like a sucker. Found on a grid that resolves the narrowest hole, as far as the memory allows.

    Args:
        facets: of the part.
        narrowest_hole: vents narrower than this need not be seen, mm.
    """

    def __init__(self, facets: Tessellation, narrowest_hole: float) -> None:
        skin = Skin(facets)
        self._low, size = skin.vertices.min(axis=0), np.ptp(skin.vertices, axis=0)
        finest = min(narrowest_hole / _STEPS_PER_HOLE, float(size.min()) / _STEPS_ACROSS)
        self._step = max(finest, float(np.prod(size) / _MOST_CELLS) ** (1 / 3))
        self._solid = _grid(skin, self._low, size, self._step)

    def largest(self, upside_down: bool = False) -> Spot:
        """Largest volume that is enclosed at some layer of the print, mm^3.

        Args:
            upside_down: built from its top.
        """
        order = range(len(self._solid))
        groups = _Groups()
        labels, shown = np.zeros(self._solid.shape[1:], dtype=np.int64), range(0)
        most, place, last = 0, None, None
        for layer in reversed(order) if upside_down else order:
            if last is not None and np.array_equal(self._solid[layer], self._solid[last]):
                groups.grow(shown)
            else:
                before = labels
                labels, shown = groups.add(*ndimage.label(~self._solid[layer]))
                touching = (labels > 0) & (before > 0)
                bound = shown.stop  # more than any group before: two numbers as one, which sorts faster than pairs
                for pair in np.unique(labels[touching] * bound + before[touching]).tolist():
                    groups.join(*divmod(pair, bound))
            cells, root = groups.largest_closed(shown)
            if cells > most:
                own = [group for group in shown if groups.root(group) == root]
                i, j = np.argwhere(np.isin(labels, own))[0]
                x, y, z = (self._low + (np.array([i - 1, j - 1, layer]) + 0.5) * self._step).tolist()
                most, place = cells, (x, y, z)
            last = layer
        return Spot(most * self._step**3, place)


class _Groups:
    """Connected air of the layers printed so far: group 0 is the outside."""

    def __init__(self) -> None:
        self._parent = [0]
        self._cells = [0]
        self._shown_cells: list[int] = []

    def add(self, labels: NDArray[Any], count: int) -> tuple[NDArray[np.int64], range]:
        """New groups for the labels of a layer, in it and in all; what touches its border or corner is outside."""
        shift = len(self._parent) - 1
        self._parent += range(shift + 1, shift + 1 + count)
        self._shown_cells = np.bincount(labels.ravel(), minlength=count + 1)[1:].tolist()
        self._cells += self._shown_cells
        placed = np.where(labels > 0, labels.astype(np.int64) + shift, 0)
        self.join(int(placed[0, 0]), 0)
        return placed, range(shift + 1, shift + 1 + count)

    def grow(self, shown: range) -> None:
        """Count the groups of the last layer once more: the next layer is like it."""
        for group, cells in zip(shown, self._shown_cells, strict=True):
            self._cells[self.root(group)] += cells

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
    """Mask, (layer, column, row), of the cells about a part that are solid at their centres.

    One empty cell is at each side, none below and above.
    """
    counts = np.maximum(np.ceil(size / step).astype(int), 1)
    shape = (counts[2] + 1, counts[0] + 2, counts[1] + 2)
    change = np.zeros(shape, dtype=np.int32)
    for i, j, z, enters in _crossings(skin, low, step, counts):
        layer = np.clip(np.ceil((z - low[2]) / step - 0.5), 0, counts[2]).astype(int)
        at = np.ravel_multi_index((layer, i + 1, j + 1), shape)
        np.add.at(change.reshape(-1), at, np.where(enters, np.int32(1), np.int32(-1)))
    return np.asarray(np.cumsum(change, axis=0, dtype=np.int32)[:-1] > 0)


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
    u, v = _barycentric(flat, first)
    rise = corners[:, 1:, 2] - corners[:, :1, 2]
    kept = np.flatnonzero(pairs)
    blocks = np.split(kept, np.flatnonzero(np.diff(np.cumsum(pairs[kept]) // _BLOCK)) + 1)
    for block in blocks:
        which = np.repeat(block, pairs[block])
        rank = np.arange(len(which)) - np.repeat(np.cumsum(pairs[block]) - pairs[block], pairs[block])
        across, along = np.divmod(rank, spans[which, 1])
        here_u, here_v = (each[0][which] + each[1][which] * across + each[2][which] * along for each in (u, v))
        hit = np.flatnonzero((here_u >= 0) & (here_v >= 0) & (here_u + here_v <= 1))
        which = which[hit]
        height = corners[which, 0, 2] + here_u[hit] * rise[which, 0] + here_v[hit] * rise[which, 1]
        yield first[which, 0] + across[hit], first[which, 1] + along[hit], height, enters[which]


def _barycentric(flat: Array, at: NDArray[np.int_]) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
    """Coordinates along the first and the last side of (n, 3, 2) triangles: at (n, 2), and their rise per column, row.

    Six (n,) arrays.
    """
    (bx, by), (cx, cy) = (flat[:, 1] - flat[:, 0]).T, (flat[:, 2] - flat[:, 0]).T
    x, y = (at - flat[:, 0]).T
    whole = bx * cy - by * cx
    whole[whole == 0] = np.nan  # all but upright: no line goes through it
    u, v = (cy / whole, -cx / whole), (-by / whole, bx / whole)
    return (u[0] * x + u[1] * y, *u), (v[0] * x + v[1] * y, *v)
