"""Covered area: the fraction of an array's area in which a contact reaches a membrane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array
from geometry.layout.arrangement import point_axes
from geometry.layout.placement import ArrayLayout

_LINES = 720
#: Lines of the hull on which the points' own areas are sampled.
_SAMPLED = 120
_TURN = np.linspace(0, 2 * np.pi, 96, endpoint=False)
#: Corners of a disc of radius one, and the directions square to its sides, from each corner to the next.
_CORNER = np.stack([np.cos(_TURN), np.sin(_TURN)], -1)
_SIDE = _CORNER + np.roll(_CORNER, -1, axis=0)
_REACH = (_SIDE * _CORNER).sum(1)


@dataclass(frozen=True)
class Uncovered:
    """Place of a body's region that is furthest from a membrane."""

    place: tuple[float, float, float]
    """In the coordinates of the body, mm."""
    distance: float
    """From the rim of the nearest membrane along the body, mm."""

    @property
    def words(self) -> str:
        """Distance and place."""
        x, y, z = self.place
        return f"furthest from a membrane: {self.distance:.2g} mm, at ({x:.1f}, {y:.1f}, {z:.1f}) mm of the body"


def most_uncovered(design: ArrayDesign) -> Uncovered | None:
    """The place of a body that is furthest from a membrane; None unless a fit laid the array on it."""
    frozen = design.layout.frozen
    if frozen is None or frozen.furthest is None or not frozen.cells:
        return None
    return Uncovered(frozen.furthest, max(cell.distances[-1] for cell in frozen.cells))


def coverage(design: ArrayDesign, contact_radius_mm: float | None = None, layout: ArrayLayout | None = None) -> float:
    """Share of an array's area in which the middle of a round contact may lie and it still touches a membrane.

    The area is the convex hull of all membranes, in plan; what lies between lines that are far apart counts, for
    whoever touches it is not felt. Summed over lines along x that are 1/720 of its height apart, within 1e-3; where one
    half of the array is the mirror image of the other, over those of one half.

    The area of an array that was fitted to a body is the region of the body instead, and distances are along the body.

    Args:
        design: the array.
        contact_radius_mm: of the contact's area, mm, 0 to 1000; by default that of the design's target.
        layout: layout of the array, if you have it already.

    Raises:
        Refusal: a radius out of range.
    """
    if contact_radius_mm is None:
        contact_radius_mm = design.target.contact_radius
    check_range("contact_radius_mm", contact_radius_mm, 0.0, 1000.0, "mm")
    on_body = _cells_reached(design, contact_radius_mm)
    if on_body is not None:
        reached, area = on_body
        return float(reached @ area / area.sum())
    place = point_axes(design) if layout is None else np.array([point.position for point in layout.points])
    kinds = [design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds]
    own = np.array(kinds)[list(design.kind_of_point)]
    height, left, right = _hull(place, own, _LINES // 2 if _is_mirrored(place, own) else _LINES)
    # a row for each point: the long axis is the last one
    x, y, reach = place[:, :1], place[:, 1:], own[:, None] + contact_radius_mm
    half = np.sqrt(np.maximum(reach**2 - (height - y) ** 2, 0.0))
    begin, end = x - half, x + half
    for ends in (begin, end):
        np.clip(ends, left, right, out=ends)
    return min(float(_together(begin.T, end.T) / (right - left).sum()), 1.0)


def point_coverage(design: ArrayDesign, contact_radius_mm: float | None = None) -> Array:
    """Share of each point's own area in which the middle of a round contact may lie and it touches its membrane.

    The own area of a point is the part of the convex hull of all membranes that is nearer to the rim of its membrane
    than to that of any other. It is sampled on a grid of 1/120 of the hull's height. The mean over the points,
    weighted with their areas, is :func:`coverage`.

    Args:
        design: the array.
        contact_radius_mm: as of :func:`coverage`.

    Returns:
        (n_point,) float64 from 0 to 1.

    Raises:
        Refusal: a radius out of range.
    """
    if contact_radius_mm is None:
        contact_radius_mm = design.target.contact_radius
    check_range("contact_radius_mm", contact_radius_mm, 0.0, 1000.0, "mm")
    on_body = _cells_reached(design, contact_radius_mm)
    if on_body is not None:
        return on_body[0]
    place = point_axes(design)
    kinds = [design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds]
    own = np.array(kinds)[list(design.kind_of_point)]
    height, left, right = (each[:: _LINES // _SAMPLED] for each in _hull(place, own))
    step = float(height[1] - height[0])
    reached, area = np.zeros(len(place)), np.zeros(len(place))
    for y, begin, end in zip(height, left, right, strict=True):
        count = max(int((end - begin) / step), 1)
        x = begin + (np.arange(count) + 0.5) * (end - begin) / count
        away = np.hypot(x[:, None] - place[:, 0], y - place[:, 1]) - own
        nearest = away.argmin(axis=1)
        area += np.bincount(nearest, minlength=len(place)) * (end - begin) / count
        inside = nearest[away.min(axis=1) <= contact_radius_mm]
        reached += np.bincount(inside, minlength=len(place)) * (end - begin) / count
    return np.asarray(np.divide(reached, area, out=np.ones(len(place)), where=area > 0))


def _cells_reached(design: ArrayDesign, radius: float) -> tuple[Array, Array] | None:
    """Fraction of each cell of a body's region that a contact reaches, and its area, mm^2; both (n_point,)."""
    frozen = design.layout.frozen
    if frozen is None or sum(cell.area for cell in frozen.cells) <= 0:
        return None
    return (
        np.array([_fraction_within(np.array(cell.distances), radius) for cell in frozen.cells]),
        np.array([cell.area for cell in frozen.cells]),
    )


def _fraction_within(distances: Array, radius: float) -> float:
    """Fraction of an area up to a distance, by the (n,) distances of equal steps of it."""
    last = len(distances) - 1
    behind = int(np.searchsorted(distances, radius, side="right"))
    if behind == 0 or behind > last:
        return float(behind > last)
    low, high = distances[behind - 1 : behind + 1]
    return float((behind - 1 + (radius - low) / (high - low)) / last)


def _is_mirrored(place: Array, radius: Array) -> bool:
    """True if the lines of the lower half of the discs' hull cross it as those of the upper half do, to rounding."""
    seen = np.column_stack([place[:, 1], place[:, 0], radius])
    image = seen * (-1, 1, 1) + (place[:, 1].min() + place[:, 1].max(), 0, 0)
    one, other = (each[np.lexsort(each.T[::-1])] for each in (seen, image))
    return bool(np.abs(one - other).max() <= 1e-13 * np.abs(seen).max())


def _hull(place: Array, radius: Array, lines: int = _LINES) -> tuple[Array, Array, Array]:
    """The lowest of the lines across the hull of discs, their height y and the ends inside it, each (lines,) mm."""
    rim = _rim(place, radius)
    low, high = rim[:, 1].min(), rim[:, 1].max()
    height = low + (np.arange(lines) + 0.5) / _LINES * (high - low)
    # anticlockwise: what goes up from the lowest corner is the right side, what comes down to it again the left one
    lowest, highest = rim[:, 1].argmin(), rim[:, 1].argmax()
    right, left = (
        np.concatenate([rim, rim])[start : start + (stop - start) % len(rim) + 1].T
        for start, stop in ((lowest, highest), (highest, lowest))
    )
    return height, np.interp(height, *left[::-1, ::-1]), np.interp(height, *right[::-1])


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
    corners = np.repeat(stop, 1 + (furthest != before), axis=0)
    corners[turns + np.arange(len(turns))] = start[turns]
    return corners


def _together(begin: Array, end: Array) -> float:
    """Length of the union of intervals (n_line, n_interval), summed over the lines.

    Between the first begin and the last end it leaves out where as many have ended as have begun.
    """
    begin, end = np.sort(begin, axis=1), np.sort(end, axis=1)
    between = begin[:, 1:] - end[:, :-1]
    return float((end[:, -1] - begin[:, 0]).sum() - np.maximum(between, 0.0, out=between).sum())
