"""Root finder of a plan, for lengths and angles that have no closed form."""

from __future__ import annotations

from collections.abc import Callable


def zero_crossing(excess: Callable[[float], float], low: float, high: float) -> float:
    """Argument between two others at which a continuous function is zero, to rounding, by bisection.

    The root finders of SciPy take longer to load than a layout to compute.

    Args:
        excess: of different sign, or zero, at the two ends.
        low: the lower end.
        high: the higher end.
    """
    first = excess(low)
    if first == 0.0:
        return low
    while low < (middle := (low + high) / 2) < high:
        if (excess(middle) > 0.0) == (first > 0.0):
            low = middle
        else:
            high = middle
    return high
