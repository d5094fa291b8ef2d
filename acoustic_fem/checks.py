"""Checks of numbers that come in from outside: one sentence with the name, the value and the range."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


def in_range(name: str, value: float, low: float, high: float, unit: str = "") -> float:
    """The value as a float if it is finite and within [low, high].

    Raises:
        ValueError: naming the field, the value and the range.
    """
    unit = f" {unit}" if unit else ""
    if not low <= float(value) <= high:
        raise ValueError(f"{name} = {float(value):g}{unit} must be between {low:g} and {high:g}{unit}")
    return float(value)


def positive(name: str, values: ArrayLike, unit: str) -> NDArray[np.float64]:
    """The values as a float64 array if all are finite and above 0.

    Raises:
        ValueError: naming the field, the first bad value and the range.
    """
    array = np.asarray(values, dtype=np.float64)
    bad = ~(np.isfinite(array) & (array > 0))
    if bad.any():
        raise ValueError(f"{name} = {array[bad].flat[0]:g} {unit} must be finite and above 0 {unit}")
    return array


def frequency_grid(frequency: ArrayLike, low: float = 1e-3, high: float = 2e3) -> NDArray[np.float64]:
    """A 1-D grid of ascending frequencies within [low, high] Hz.

    Raises:
        ValueError: empty, not 1-D, not ascending, not finite or out of range, with the offending value.
    """
    grid = np.asarray(frequency, dtype=np.float64)
    if grid.ndim != 1 or grid.size == 0:
        raise ValueError(f"frequency has shape {grid.shape}; it must be a 1-D array of at least one value in Hz")
    bad = ~((grid >= low) & (grid <= high))
    if bad.any():
        raise ValueError(f"frequency = {grid[bad][0]:g} Hz must be between {low:g} and {high:g} Hz")
    falling = np.flatnonzero(np.diff(grid) <= 0)
    if falling.size:
        first = falling[0]
        raise ValueError(f"frequency must ascend: {grid[first + 1]:g} Hz follows {grid[first]:g} Hz")
    return grid
