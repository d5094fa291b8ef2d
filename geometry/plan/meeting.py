"""Place at which two straight tubes of given length meet: a microphone that joins two line ends lies there."""

from __future__ import annotations

import math

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.routing import bearing


def meetings(first: Array, second: Array, first_reach: float, second_reach: float) -> list[Array]:
    """The two places at given distances from two points: left and right of the way from the first to the second.

    Args:
        first: (2,) float64, mm.
        second: (2,) float64, mm.
        first_reach: distance from the first, mm.
        second_reach: distance from the second, mm.

    Returns:
        Two of (2,) float64, mm; none where no place is so near to both, or only one.
    """
    apart = float(np.linalg.norm(second - first))
    if not abs(first_reach - second_reach) < apart < first_reach + second_reach:
        return []
    along = (second - first) / apart
    foot = (apart**2 + first_reach**2 - second_reach**2) / (2 * apart)
    height = math.sqrt(first_reach**2 - foot**2)
    across = np.array([-along[1], along[0]])
    return [first + foot * along + side * height * across for side in (1, -1)]


def angle_between(place: Array, first: Array, second: Array) -> float:
    """Angle between the directions from a place to two points, all (2,) float64, mm: 0 to 180 degrees."""
    return abs((bearing(place, first) - bearing(place, second) + 180) % 360 - 180)
