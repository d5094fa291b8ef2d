"""Where a quantity of a plan crosses zero: the one root finder of lengths and angles that have no closed form."""

from __future__ import annotations

import math
from collections.abc import Callable

#: An argument is found to this fraction of itself, and where it is zero to this size.
_PRECISION, _SMALLEST = 1e-15, 1e-300


def zero_crossing(excess: Callable[[float], float], low: float, high: float) -> float:
    """Argument between two others at which a continuous function is zero, to rounding.

    Brent, Algorithms for Minimization without Derivatives (1973), chapter 4, to the bit as ``scipy.optimize.brentq``
    has it: loading that takes longer than to compute most layouts.

    Args:
        excess: of different sign, or zero, at the two ends.
        low: the lower end.
        high: the higher end.

    Raises:
        ArithmeticError: the signs are the same.
    """
    before, here, across = low, high, low
    f_before, f_here = excess(low), excess(high)
    if f_before == 0:
        return low
    if (f_before < 0) == (f_here < 0) and f_here != 0:
        raise ArithmeticError(f"no change of sign between {low} and {high}")
    f_across, step_before, step = f_before, high - low, high - low
    while f_here != 0:
        if f_before != 0 and (f_before < 0) != (f_here < 0):
            across, f_across = before, f_before
            step_before = step = here - before
        if abs(f_across) < abs(f_here):
            before, here, across = here, across, here
            f_before, f_here, f_across = f_here, f_across, f_here
        least, half = (_SMALLEST + _PRECISION * abs(here)) / 2, (across - here) / 2
        if abs(half) < least:
            break
        guess = math.inf
        if abs(step_before) > least and abs(f_here) < abs(f_before):
            if before == across:
                guess = -f_here * (here - before) / (f_here - f_before)
            else:
                slope, other = (f_before - f_here) / (before - here), (f_across - f_here) / (across - here)
                guess = -f_here * (f_across * other - f_before * slope) / (other * slope * (f_across - f_before))
        if 2 * abs(guess) < min(abs(step_before), 3 * abs(half) - least):
            step_before, step = step, guess
        else:
            step_before = step = half
        before, f_before = here, f_here
        here += step if abs(step) > least else (least if half > 0 else -least)
        f_here = excess(here)
    return here
