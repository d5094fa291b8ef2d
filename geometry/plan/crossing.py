"""Root finder of a plan, for lengths and angles that have no closed form."""

from __future__ import annotations

from collections.abc import Callable


def zero_crossing(excess: Callable[[float], float], low: float, high: float) -> float:
    """Argument between two others at which a continuous function is zero, to rounding.

    Args:
        excess: of different sign, or zero, at the two ends.
        low: the lower end.
        high: the higher end.
    """
    # scipy.optimize takes longer to load than most layouts to compute, and few of them come here
    from scipy.optimize import brentq

    return float(brentq(excess, low, high, xtol=1e-300, rtol=1e-15))
