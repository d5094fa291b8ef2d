"""Checks of a surface of facets: whether it is closed, one, right side out and does not cross itself."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array

Corners = NDArray[np.int64]

_EXPORT = "export it as one closed solid"
#: Pairs of facets that are looked at together, for memory, and crossing ones after which no more are sought.
_TOGETHER, _MANY = 1_000_000, 1000


def _at(places: Array) -> str:
    """The middle of places in words."""
    x, y, z = places.reshape(-1, 3).mean(axis=0)
    return f"around ({x:.1f}, {y:.1f}, {z:.1f}) mm"


def check_size(path: Path, vertices: Array, least: float, most: float) -> None:
    """Refuse a body whose size makes no sense: it is in other units.

    Raises:
        Refusal: smaller than ``least`` or larger than ``most``, mm.
    """
    size = float(np.ptp(vertices, axis=0).max())
    if not least <= size <= most:
        what = "metres or inches" if size < least else "micrometres"
        problem = f"is {size:.3g} mm long in all; it must be between {least:.3g} and {most:.4g} mm"
        remedy = f"state its unit with surface.unit if it is in {what}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, file=path, remedy=remedy)


def check_closed(path: Path, vertices: Array, triangles: Corners) -> None:
    """Refuse a surface with open or forked edges, facets that face both ways, or the inside outside.

    Raises:
        Refusal: with the number of bad edges and their place.
    """
    directed = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    edges, count = np.unique(np.sort(directed, axis=1), axis=0, return_counts=True)
    if (count != 2).any():
        open_, forked = int((count == 1).sum()), int((count > 2).sum())
        found = [
            f"{counted(number, 'edge')} {words}"
            for number, words in ((open_, "with one facet"), (forked, "with more than two facets"))
            if number
        ]
        problem = f"is not closed: {' and '.join(found)}, {_at(vertices[edges[count != 2]])}"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, remedy=_EXPORT)
    ways, often = np.unique(directed, axis=0, return_counts=True)
    if (often > 1).any():
        bad = ways[often > 1]
        problem = f"has facets that face both ways at {counted(len(bad), 'edge')}, {_at(vertices[bad])}"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, remedy=_EXPORT)
    a, b, c = (vertices[triangles[:, k]] - vertices.mean(axis=0) for k in range(3))
    if float(np.einsum("ij,ij->", a, np.cross(b, c))) <= 0:
        remedy = "turn its normals in your CAD program"
        raise Refusal("is inside out", kind=Kind.UNSUITABLE, file=path, remedy=remedy)


def skins(triangles: Corners, count: int) -> NDArray[np.int32]:
    """Number of the connected surface, from 0, that each facet belongs to, (m,) int32."""
    a, b = triangles[:, [0, 1]].T
    c = triangles[:, 2]
    pairs = np.ones(2 * len(triangles), bool), (np.concatenate([a, b]), np.concatenate([b, c]))
    _, label = connected_components(coo_array(pairs, shape=(count, count)), directed=False)
    _, own = np.unique(label[triangles[:, 0]], return_inverse=True)
    return np.asarray(own, np.int32)


def check_crossings(path: Path, vertices: Array, triangles: Corners) -> None:
    """Refuse a surface with facets that cross without sharing a corner.

    Raises:
        Refusal: with the number of crossing pairs, or that they are many, and their place.
    """
    crossing = np.zeros((0, 2), np.int64)
    for pairs in _near_facets(vertices, triangles):
        hit = np.zeros(len(pairs), bool)
        for one, other in ((0, 1), (1, 0)):
            hit |= _pierces(vertices[triangles[pairs[:, one]]], vertices[triangles[pairs[:, other]]])
        crossing = np.vstack([crossing, pairs[hit]])
        if len(crossing) > _MANY:
            break
    if len(crossing):
        number = f"more than {_MANY} pairs" if len(crossing) > _MANY else counted(len(crossing), "pair")
        problem = f"crosses itself: {number} of facets, {_at(vertices[triangles[crossing.ravel()]])}"
        remedy = "unite its parts in your CAD program"
        raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, remedy=remedy)


def _near_facets(vertices: Array, triangles: Corners) -> Iterator[Corners]:
    """Pairs of facets whose boxes meet and that share no corner, each once, (n, 2), so many at a time as fit."""
    corners = vertices[triangles]
    low, high = corners.min(axis=1), corners.max(axis=1)
    middle, radius = (low + high) / 2, np.linalg.norm(high - low, axis=1) / 2
    # By size, so that a few large facets do not make all small ones neighbours.
    bounds = np.quantile(radius, [0.5, 0.8, 0.95, 0.99, 1])
    group = np.searchsorted(bounds[:-1], radius)
    for number, most in enumerate(bounds):
        own, upto = np.flatnonzero(group == number), np.flatnonzero(group <= number)
        if not len(own):
            continue
        tree = cKDTree(middle[upto])
        count = tree.query_ball_point(middle[own], radius[own] + most, return_length=True)
        ends = np.flatnonzero(np.diff(np.cumsum(count) // _TOGETHER)) + 1
        for part in np.split(np.arange(len(own)), ends):
            near = tree.query_ball_point(middle[own[part]], radius[own[part]] + most, return_sorted=False)
            i, j = np.repeat(own[part], count[part]), upto[np.concatenate(near).astype(int)]
            meet = (group[j] < number) | (i < j)
            meet &= (low[i] <= high[j]).all(axis=1) & (high[i] >= low[j]).all(axis=1)
            i, j = i[meet], j[meet]
            apart = ~(triangles[i][:, :, None] == triangles[j][:, None, :]).any(axis=(1, 2))
            yield np.sort(np.column_stack([i[apart], j[apart]]), axis=1)


def _pierces(first: Array, second: Array) -> NDArray[np.bool_]:
    """True where an edge of a facet goes through another facet (Moeller and Trumbore 1997); corners (n, 3, 3)."""
    along, across = second[:, 1] - second[:, 0], second[:, 2] - second[:, 0]
    hit = np.zeros(len(first), bool)
    for k in range(3):
        origin, step = first[:, k], first[:, (k + 1) % 3] - first[:, k]
        h = np.cross(step, across)
        det = np.einsum("ij,ij->i", along, h)
        good = np.abs(det) > 1e-12
        inverse = 1 / np.where(good, det, 1.0)
        off = origin - second[:, 0]
        u = inverse * np.einsum("ij,ij->i", off, h)
        q = np.cross(off, along)
        v, t = inverse * np.einsum("ij,ij->i", step, q), inverse * np.einsum("ij,ij->i", across, q)
        edge = 1e-9
        hit |= good & (u > edge) & (v > edge) & (u + v < 1 - edge) & (t > edge) & (t < 1 - edge)
    return hit
