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
_CORNERS = 96


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
    reach = own[:, None] + radius
    half = np.sqrt(np.maximum(reach**2 - (height - place[:, 1:]) ** 2, 0.0))
    begin = np.clip(place[:, :1] - half, left, right)
    end = np.clip(place[:, :1] + half, left, right)
    return min(float(_together(begin, end) / (right - left).sum()), 1.0)


def _hull(place: Array, radius: Array) -> tuple[Array, Array, Array]:
    """Lines across the hull of discs, their height y and the ends of them inside it, each (n_line,) mm."""
    from scipy.spatial import ConvexHull

    turn = np.linspace(0, 2 * np.pi, _CORNERS, endpoint=False)
    corner = np.stack([np.cos(turn), np.sin(turn)], -1)
    edge = place[:, None] + radius[:, None, None] * corner
    # Where one disc reaches furthest square to both edges beside a corner, it does so at that corner alone.
    side = corner + np.roll(corner, -1, axis=0)
    furthest = (place @ side.T + radius[:, None] * (side * corner).sum(1)).argmax(axis=0)
    only = furthest == np.roll(furthest, 1)
    rim = np.concatenate([edge[furthest[only], only], edge[:, ~only].reshape(-1, 2)])
    rim = rim[ConvexHull(rim).vertices]
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


def _together(begin: Array, end: Array) -> float:
    """Length of the union of intervals (n_interval, n_line), summed over the lines."""
    order = np.argsort(begin, axis=0)
    begin, end = np.take_along_axis(begin, order, 0), np.take_along_axis(end, order, 0)
    reached = np.maximum.accumulate(end, axis=0)
    before = np.vstack([begin[:1], reached[:-1]])
    return float(np.maximum(end - np.maximum(begin, before), 0.0).sum())
