"""Paths of tubes between cavities in plan: straight, bowed to an exact length, or drawn for the eye only."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.plan.crossing import zero_crossing

#: Chords per arc; the polyline of a half circle is then shorter than the arc by 1e-4.
_CHORDS = 64
#: Length of a Bezier curve's handles by its chord, at which it bends evenly.
_HANDLE = 0.36


def bow_angle(length: float, distance: float, cavity_radius: float, outer_radius: float) -> float:
    """Angle between the line of two axes and a tube that is longer than a straight tube between them.

    The tube runs radially through both walls and between the shells along one circular arc, to which the
    radial parts are tangents: length = 2 w + (d - 2 R cos t) t / sin t, with the walls' thickness w, the
    distance of the axes d and the shells' outer radius R. The length grows with t, so the root is unique.

    Args:
        length: bore from cavity wall to cavity wall, mm.
        distance: between the two axes, mm.
        cavity_radius: of the cavities, mm.
        outer_radius: of the shells, mm.

    Returns:
        The angle t in degrees, 0 for a straight tube.

    Raises:
        Refusal: the tube is shorter than a straight one.
    """
    straight = distance - 2 * cavity_radius
    if length < straight - 1e-9:
        allowed = f"at least {straight:g} mm, a straight tube"
        raise Refusal(kind=Kind.CONFLICT, field="length", value=length, unit="mm", allowed=allowed)
    if length <= straight + 1e-9:
        return 0.0
    walls = 2 * (outer_radius - cavity_radius)

    def excess(angle: float) -> float:
        along = angle / math.sin(angle) if angle else 1.0
        return walls + (distance - 2 * outer_radius * math.cos(angle)) * along - length

    return math.degrees(zero_crossing(excess, 0.0, math.pi))


def bow_radius(angle: float, distance: float, outer_radius: float) -> float:
    """Radius of the arc of a tube bowed by ``angle`` degrees, mm; infinite when it lies straight."""
    if angle == 0:
        return math.inf
    turn = math.radians(angle)
    return (distance - 2 * outer_radius * math.cos(turn)) / (2 * math.sin(turn))


def bowed_path(start: Array, end: Array, angle: float, side: int, cavity_radius: float, outer_radius: float) -> Array:
    """Axis of a tube from cavity wall to cavity wall.

    Args:
        start: axis of the first shell in plan, (2,) float64, mm.
        end: axis of the second shell in plan, (2,) float64, mm.
        angle: from :func:`bow_angle`, degrees.
        side: +1 when it bulges to the left of the line from start to end, -1 to the right.
        cavity_radius: of the cavities, mm.
        outer_radius: of the shells, mm.

    Returns:
        (n, 2) float64, mm: 2 points when it is straight.
    """
    across = (end - start).tolist()
    distance = math.hypot(*across)
    x, y = across[0] / distance, across[1] / distance
    shape = _bowed(angle, distance, cavity_radius, outer_radius)
    return np.asarray(start + shape @ np.array([[x, y], [-side * y, side * x]]))


@lru_cache(maxsize=256)
def _bowed(angle: float, distance: float, cavity_radius: float, outer_radius: float) -> Array:
    """The path of :func:`bowed_path` along the line of the axes and beside it, from the first axis on."""
    if angle == 0:
        return np.array([[cavity_radius, 0.0], [distance - cavity_radius, 0.0]])
    turn = math.radians(angle)
    radius = bow_radius(angle, distance, outer_radius)
    turns = np.linspace(-turn, turn, _CHORDS + 1)
    # The chord lies R sin t beside the line of axes, the arc's centre r cos t behind the chord.
    height = outer_radius * math.sin(turn) + radius * (np.cos(turns) - math.cos(turn))
    arc = np.column_stack([distance / 2 + radius * np.sin(turns), height])
    wall = cavity_radius * math.cos(turn), cavity_radius * math.sin(turn)
    return np.vstack([wall, arc, (distance - wall[0], wall[1])])


def directions(ends: tuple[Array, Array], first: float | None, second: float | None) -> tuple[float, float]:
    """Directions in which a tube leaves two shells, degrees, where a line runs straight through them.

    Args:
        ends: axes of the shells in plan, (2,) float64, mm.
        first: direction of the line through the first shell, degrees; None: the tube leaves towards the second.
        second: the same for the second.
    """
    direct = bearing(*ends)
    return direct if first is None else first, direct + 180 if second is None else second + 180


def routed_path(
    start: tuple[Array, float], end: tuple[Array, float], cavity_radius: float, outer_radius: float, length: float
) -> Array:
    """Axis of a tube of exact length that leaves two shells in stated directions: a smooth curve between the walls.

    Args:
        start: axis of the first shell in plan, (2,) float64, mm, and direction of the tube from there, degrees.
        end: the same for the second shell.
        cavity_radius: of the cavities, mm.
        outer_radius: of the shells, mm.
        length: bore from cavity wall to cavity wall, mm.

    Returns:
        (n, 2) float64, mm, from cavity wall to cavity wall.

    Raises:
        Refusal: the tube is shorter than the chord between the walls and the two walls.
    """
    (first, leaving), (second, arriving) = start, end
    out, back = unit(leaving), unit(arriving)
    p0, p3 = first + outer_radius * out, second + outer_radius * back
    between = length - 2 * (outer_radius - cavity_radius)
    chord = float(np.linalg.norm(p3 - p0))
    if between < chord - 1e-9:
        allowed = f"at least {chord + length - between:.4g} mm"
        raise Refusal(kind=Kind.CONFLICT, field="length", value=length, unit="mm", allowed=allowed)
    s = np.linspace(0, 1, 2 * _CHORDS + 1)[:, None]
    left = np.array([p0[1] - p3[1], p3[0] - p0[0]]) / chord

    def curve(reach: float, bulge: float = 0.0) -> Array:
        """A Bezier curve with handles of that length; a bulge to the left that is flat at both ends makes it longer."""
        p1, p2 = p0 + reach * out, p3 + reach * back
        bezier = (1 - s) ** 3 * p0 + 3 * s * (1 - s) ** 2 * p1 + 3 * s**2 * (1 - s) * p2 + s**3 * p3
        return np.asarray(bezier + bulge * np.sin(np.pi * s) ** 2 * left)

    smooth = _HANDLE * chord
    spare = between - path_length(curve(smooth))
    if abs(spare) < 1e-9 * between:
        course = curve(smooth)
    elif spare < 0:
        course = curve(zero_crossing(lambda reach: path_length(curve(reach)) - between, 0.0, smooth))
    else:
        course = curve(smooth, zero_crossing(lambda bulge: path_length(curve(smooth, bulge)) - between, 0.0, between))
    return np.vstack([first + cavity_radius * out, course, second + cavity_radius * back])


def drawn_path(
    start: Array,
    start_angle: float,
    start_radii: tuple[float, float],
    end: Array,
    end_angle: float,
    end_radii: tuple[float, float],
) -> Array:
    """A smooth curve (cubic Bezier) that leaves two housings radially: for the eye only, of no given length.

    Args:
        start: axis of the first housing in plan, (2,) float64, mm.
        start_angle: direction in which the tube leaves it, degrees.
        start_radii: its inner and outer radius, mm.
        end: axis of the second housing in plan, (2,) float64, mm.
        end_angle: direction in which the tube leaves it, degrees.
        end_radii: its inner and outer radius, mm.

    Returns:
        (n, 2) float64, mm, from cavity wall to cavity wall.
    """
    out, back = unit(start_angle), unit(end_angle)
    p0, p3 = start + start_radii[1] * out, end + end_radii[1] * back
    reach = 0.4 * float(np.linalg.norm(p3 - p0))
    s = np.linspace(0, 1, _CHORDS + 1)[:, None]
    curve = (
        (1 - s) ** 3 * p0
        + 3 * s * (1 - s) ** 2 * (p0 + reach * out)
        + 3 * s**2 * (1 - s) * (p3 + reach * back)
        + s**3 * p3
    )
    return np.vstack([start + start_radii[0] * out, curve, end + end_radii[0] * back])


def unit(angle: float) -> Array:
    """Unit vector in plan, (2,) float64, of the angle of a direction, degrees."""
    return np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])


def bearing(start: Sequence[float] | Array, end: Sequence[float] | Array) -> float:
    """Direction in plan from a start (2,) to an end (2,), both (x, y) in mm; degrees in [0, 360)."""
    return tidy(math.degrees(math.atan2(end[1] - start[1], end[0] - start[0])))


def tidy(angle: float) -> float:
    """The angle, degrees, in [0, 360), free of rounding noise, so that equal cells and parts are seen to be equal."""
    return round(round(angle, 6) % 360.0, 6)


def path_length(path: Array) -> float:
    """Length of a path, mm: a polyline (n, 2) or (n, 3) float64, mm."""
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def tightest_bend(path: Array) -> float:
    """Smallest radius of a path, mm: of the circles through three points in a row of a polyline (n, 2) or (n, 3), mm.

    Exact where the points lie on an arc; infinite where the path is straight.
    """
    a, b = path[1:-1] - path[:-2], path[2:] - path[1:-1]
    product = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1) * np.linalg.norm(a + b, axis=1)
    area = np.sqrt(np.maximum(np.sum(a**2, axis=1) * np.sum(b**2, axis=1) - np.sum(a * b, axis=1) ** 2, 0.0))
    bent = area > 1e-9 * np.maximum(np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1), 1e-300)
    return float((product[bent] / (2 * area[bent])).min()) if bent.any() else math.inf


def turning(path: Array) -> float:
    """Angle by which the direction of a path, (n, 2) or (n, 3) float64 in mm, turns along its length, radians."""
    steps = np.diff(path, axis=0)
    along = steps / np.linalg.norm(steps, axis=1, keepdims=True)
    # By the chord of the unit vectors: exact for small angles, where an arc cosine is not.
    return float(2 * np.arcsin(np.minimum(np.linalg.norm(np.diff(along, axis=0), axis=1) / 2, 1.0)).sum())


def trimmed(path: Array, length: float) -> Array:
    """A polyline without the ends of its first and of its last segment.

    Args:
        path: (n, 2) or (n, 3) float64, mm.
        length: taken from each end, mm, less than the first and the last segment.

    Returns:
        Same shape as the path, float64, mm.
    """
    ends = path.copy()
    for end, inwards in ((0, 1), (-1, -2)):
        step = path[inwards] - path[end]
        ends[end] = path[end] + length * step / np.linalg.norm(step)
    return ends


def resampled(path: Array, step: float, trim: tuple[float, float] = (0.0, 0.0)) -> Array:
    """Points of a polyline no further apart than a step.

    Args:
        path: (n, 2) or (n, 3) float64, mm.
        step: largest distance along the polyline, mm.
        trim: lengths left out at both ends, mm.

    Returns:
        (m, 2) or (m, 3) float64, mm.
    """
    at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    count = max(2, math.ceil((at[-1] - sum(trim)) / step) + 1)
    where = np.linspace(trim[0], at[-1] - trim[1], count)
    return np.column_stack([np.interp(where, at, path[:, k]) for k in range(path.shape[1])])
