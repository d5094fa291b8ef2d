"""The polygon of a ring: its sides are the lines at their true length, its corners the microphones."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.crossing import zero_crossing
from geometry.schema.array_fields import StatedArray


def side_lengths(design: StatedArray) -> tuple[float | None, ...]:
    """Distance from each microphone to the next while all tubes of the line between them lie as designed, mm.

    Returns:
        One length per microphone; None where no line joins it to the next.
    """
    place = {name: index for index, name in enumerate(design.microphones)}
    sides: list[float | None] = [None] * len(place)
    for line in design.lines:
        first, second = (place[name] for name in line.between)
        start = first if (second - first) % len(place) == 1 else second
        sides[start] = design.span_of(line) + sum(design.microphone_reach_of(line, end) for end in (0, 1))
    return tuple(sides)


def corners(sides: Sequence[float | None]) -> Array:
    """Corners of the convex polygon with these sides in this order whose corners lie on one circle.

    There is exactly one: three sides make their triangle, four with equal opposite sides a rectangle, equal
    sides a regular polygon. One side may be None: it is then as long as the longest.

    Args:
        sides: lengths from each corner to the next, mm; the longest below the sum of the others.

    Returns:
        (n, 2) float64, mm, anticlockwise around their mean at (0, 0), the first side along +x.
    """
    longest = max(side for side in sides if side is not None)
    lengths = np.array([longest if side is None else side for side in sides])
    # Start behind the longest side: it closes the polygon.
    start = (int(np.argmax(lengths)) + 1) % len(lengths)
    others = np.roll(lengths, -start)[:-1]
    diameter = _circle_diameter(others, longest)
    turns = np.concatenate([[0.0], 2 * np.cumsum(np.arcsin(others / diameter))])
    points = np.roll(diameter / 2 * np.column_stack([np.cos(turns), np.sin(turns)]), start, axis=0)
    points -= points.mean(axis=0)
    x, y = (points[1] - points[0]) / np.linalg.norm(points[1] - points[0])
    return np.asarray(points @ np.array([[x, -y], [y, x]]))


def corner_angles(points: Array) -> Array:
    """Angles between the two sides at each corner (n, 2) of a convex polygon, (n,) float64, degrees."""
    after, before = np.roll(points, -1, axis=0) - points, np.roll(points, 1, axis=0) - points
    cross = after[:, 0] * before[:, 1] - after[:, 1] * before[:, 0]
    return np.degrees(np.arctan2(cross, np.sum(after * before, axis=1)))


def _circle_diameter(others: Array, longest: float) -> float:
    """Diameter of the circle around a polygon: a side s takes the arc 2 asin(s / diameter).

    With the centre inside, all arcs make a full turn; outside, the arc of the longest side is that of the
    others together.
    """
    fractions = others / longest
    inside = float(np.arcsin(fractions).sum()) >= math.pi / 2

    def excess(fraction: float) -> float:
        """Half arcs beyond those that close the polygon, where the longest side is that fraction of the diameter."""
        half_turns, own = float(np.arcsin(fractions * fraction).sum()), math.asin(fraction)
        if inside:
            return (half_turns - math.pi / 2) + (own - math.pi / 2)
        # on an endless circle all sides lie straight, which closes nothing: divided by the fraction, there is no root
        return (half_turns - own) / fraction if fraction else float(fractions.sum()) - 1

    return longest / zero_crossing(excess, 0.0, 1.0)
