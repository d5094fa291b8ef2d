"""A smooth curve as a chain of arcs that are tangent to each other, so that a tube along it has round faces only."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from geometry.ground.typed import Array

#: Largest distance of the curve's points from the arcs, mm: a fraction of what a printer or a spring follows.
_DEVIATION = 0.003


def arc_ends(points: Array) -> Array:
    """Ends of tangent arcs along a smooth curve, in order, (m, 3) float64, mm.

    The curve begins and ends straight: its first and its last segment are lines, and the arcs lie between them. Two
    arcs (a biarc; Bolton 1975) join two points of the curve in its direction at both, and as few points are taken as
    keep the others within 0.003 mm.

    Args:
        points: of the curve, (n, 3) float64, mm; the directions between them change little.
    """
    along = _directions(points)
    last = len(points) - 2
    ends: list[Array] = []
    for count in range(1, max(2, (last + 1) // 2)):
        chosen = np.linspace(1, last, count + 1).round().astype(int).tolist()
        ends, furthest = [], 0.0
        for i, j in pairwise(chosen):
            middle = _joint(points[i], along[i], points[j], along[j])
            turned = _direction_at_end(points[i], along[i], middle)
            own = points[i : j + 1]
            first = np.linalg.norm(own - points[i], axis=1) <= np.linalg.norm(middle - points[i])
            off = np.where(first, _off_arc(own, points[i], along[i], middle), _off_arc(own, middle, turned, points[j]))
            furthest = max(furthest, float(off.max()))
            ends += [middle, points[j]]
        if furthest <= _DEVIATION:
            break
    return np.array(ends)


def _directions(points: Array) -> Array:
    """Directions of a curve at its points, of circles through three in a row; at both straight ends, theirs."""
    steps = np.diff(points, axis=0)
    long = np.linalg.norm(steps, axis=1, keepdims=True)
    inner = steps[:-1] / long[:-1] ** 2 + steps[1:] / long[1:] ** 2
    inner[0], inner[-1] = steps[0], steps[-1]
    along = np.vstack([steps[:1], inner, steps[-1:]])
    return np.asarray(along / np.linalg.norm(along, axis=1, keepdims=True))


def _joint(start: Array, along: Array, end: Array, towards: Array) -> Array:
    """Place where two arcs meet that leave a start along a direction and reach an end along another, (3,) mm."""
    across = end - start
    forwards, turn = float(across @ (along + towards)), 2 * (1 - float(along @ towards))
    handle = float(across @ across) / (forwards + np.sqrt(forwards**2 + turn * float(across @ across)))
    return np.asarray((start + end + handle * (along - towards)) / 2)


def _direction_at_end(start: Array, along: Array, end: Array) -> Array:
    """Direction at the end of the arc that leaves a start along a direction, (3,)."""
    across = end - start
    return np.asarray(2 * float(across @ along) / float(across @ across) * across - along)


def _off_arc(places: Array, start: Array, along: Array, end: Array) -> Array:
    """Distances of places (n, 3) from the circle through a start, along a direction there, and an end; (n,) mm."""
    chord, off = end - start, places - start
    out = chord - float(chord @ along) * along
    width = float(np.linalg.norm(out))
    if width < 1e-9:
        return np.asarray(np.linalg.norm(off - (off @ along)[:, None] * along, axis=1))
    out /= width
    radius = float(chord @ chord) / (2 * width)
    off = off - radius * out
    height = off @ np.cross(along, out)
    return np.asarray(np.hypot(np.linalg.norm(off - height[:, None] * np.cross(along, out), axis=1) - radius, height))
