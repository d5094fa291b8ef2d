"""Where on an array a contact is felt at all: the share of its area in which one reaches a membrane."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.quantities.checks import in_range
from geometry.design.array_design import ArrayDesign
from geometry.layout.arrangement import lay_out
from geometry.layout.placement import ArrayLayout

Array = NDArray[np.float64]

FINGER = 5.0
"""Radius of the contact of a finger that presses lightly, mm; ours."""
_LINES = 720
_TURN = np.linspace(0, 2 * np.pi, 96, endpoint=False)
#: Corners of a disc of radius one, and the directions square to its sides, from each corner to the next.
_CORNER = np.stack([np.cos(_TURN), np.sin(_TURN)], -1)
_SIDE = _CORNER + np.roll(_CORNER, -1, axis=0)
_REACH = (_SIDE * _CORNER).sum(1)


def coverage(design: ArrayDesign, radius: float = FINGER, layout: ArrayLayout | None = None) -> float:
    """Share of an array's area in which the middle of a round contact may lie and it still touches a membrane.

    The area is the convex hull of all membranes, in plan; what lies between lines that are far apart counts, for
    whoever touches it is not felt. Summed over lines along x that are 1/720 of its height apart: within 1e-3.

    Args:
        design: the array.
        radius: of the contact's area, mm, 0 to 1000.
        layout: where its parts lie, where it is known already.

    Raises:
        Refusal: a radius out of range.
    """
    in_range("radius", radius, 0.0, 1000.0, "mm")
    layout = lay_out(design) if layout is None else layout
    place = np.array([point.position for point in layout.points])
    kinds = [design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds]
    own = np.array(kinds)[list(design.kind_of_point)]
    height, left, right = _hull(place, own)
    half = np.sqrt(np.maximum((own + radius) ** 2 - (height[:, None] - place[:, 1]) ** 2, 0.0))
    ends = np.stack([place[:, 0] - half, place[:, 0] + half])
    np.maximum(ends, left[:, None], out=ends)
    np.minimum(ends, right[:, None], out=ends)
    return min(float(_together(*ends) / (right - left).sum()), 1.0)


def _hull(place: Array, radius: Array) -> tuple[Array, Array, Array]:
    """Lines across the hull of discs, their height y and the ends of them inside it, each (n_line,) mm."""
    rim = _rim(place, radius)
    low, high = rim[:, 1].min(), rim[:, 1].max()
    height = low + (np.arange(_LINES) + 0.5) / _LINES * (high - low)
    start, stop = rim, np.roll(rim, -1, axis=0)
    # Anticlockwise: the edges that go up are the right side, those that go down the left one.
    sides = []
    for rising in (False, True):
        kept = (stop[:, 1] > start[:, 1]) == rising
        corners = np.concatenate([start[kept], stop[kept]])
        order = np.argsort(corners[:, 1], kind="stable")
        sides.append(np.interp(height, corners[order, 1], corners[order, 0]))
    return height, sides[0], sides[1]


def _rim(place: Array, radius: Array) -> Array:
    """Corners of the hull of discs, anticlockwise, (n, 2) mm."""
    # At a corner of the discs' polygon the hull goes on from the disc that reaches furthest square to the side before
    # it to that of the side after it: mostly the same, mostly straight.
    furthest = (place @ _SIDE.T + radius[:, None] * _REACH).argmax(axis=0)
    before = np.concatenate([furthest[-1:], furthest[:-1]])
    start, stop = (place[own] + radius[own, None] * _CORNER for own in (before, furthest))
    turns = np.flatnonzero(furthest != before)
    way = stop[turns] - start[turns]
    others = place[:, None] + radius[:, None, None] * _CORNER[turns] - start[turns]
    beyond = way[:, 1] * others[..., 0] - way[:, 0] * others[..., 1]
    if np.any(beyond > 1e-9 * (way**2).sum(1)):  # others reach past that way
        from scipy.spatial import ConvexHull

        every = (place[:, None] + radius[:, None, None] * _CORNER).reshape(-1, 2)
        return np.asarray(every[ConvexHull(every).vertices])
    return np.insert(stop, turns, start[turns], axis=0)


def _together(begin: Array, end: Array) -> float:
    """Length of the union of intervals (n_line, n_interval), summed over the lines.

    Between the first begin and the last end it leaves out where as many have ended as have begun.
    """
    begin, end = np.sort(begin, axis=1), np.sort(end, axis=1)
    between = np.maximum(begin[:, 1:] - end[:, :-1], 0.0)
    return float((end[:, -1] - begin[:, 0]).sum() - between.sum())
