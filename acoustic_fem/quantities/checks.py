"""Checks of numbers that come in from outside: one sentence with the name, the value and the range."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Refusal, counted

_BAND = (1e-3, 2e3)
"""Lowest and highest frequency of a grid, Hz."""


def numbers(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """The values as an array, same shape as given, float64, in their unit.

    Raises:
        Refusal: naming the field and what it holds instead: complex numbers, texts, rows of unequal length.
    """
    rule = f"{name} must be a real number or an array of them"
    try:
        array = np.asarray(values)
    except ValueError:
        raise Refusal(f"{rule}; its rows have different lengths") from None
    if array.dtype.kind not in "biuf":
        kind = {"c": "complex", "U": "text", "S": "text"}.get(array.dtype.kind, f"{array.dtype}")
        raise Refusal(f"{rule}; it is {kind}: {values!r:.60}")
    return np.asarray(array, dtype=np.float64)


MOST_PORTS = 50
"""Most ports of a cell: each takes a solve of its own at every frequency."""


def port_points(ports: Mapping[str, ArrayLike]) -> dict[str, tuple[float, float, float]]:
    """Point (x, y, z) in mm on each port by its name: ``ports`` as (3,) float64 each.

    Raises:
        Refusal: no mapping, no port or too many, a name that is no text, empty or ``wall`` (every face that is no
            port), or a point that is not three finite numbers.
    """
    if not isinstance(ports, Mapping):
        raise Refusal(f"ports must map names to points, not be a {type(ports).__name__}")
    if not 1 <= len(ports) <= MOST_PORTS:
        raise Refusal(f"ports has {counted(len(ports), 'port')}; it must have 1 to {MOST_PORTS}")
    points = {}
    for name, place in ports.items():
        if not isinstance(name, str) or name in ("", "wall"):
            raise Refusal(f"ports has the name {name!r}; it must be a text, not empty and not 'wall'")
        point = numbers(f"port {name!r}", place)
        if point.shape != (3,) or not np.isfinite(point).all():
            raise Refusal(f"port {name!r} = {place!r:.60} must be a point of three finite numbers, mm")
        points[name] = (float(point[0]), float(point[1]), float(point[2]))
    return points


def in_range(name: str, value: float, low: float, high: float, unit: str = "") -> float:
    """The value as a float if it is finite and within [low, high], all in the same unit.

    Raises:
        Refusal: naming the field, the value and the range.
    """
    unit = f" {unit}" if unit else ""
    if numbers(name, value).ndim:
        raise Refusal(f"{name} = {value!r:.60} must be one number")
    if not low <= float(value) <= high:
        raise Refusal(f"{name} = {float(value):g}{unit} must be between {low:g} and {high:g}{unit}")
    return float(value)


def positive(name: str, values: ArrayLike, unit: str) -> NDArray[np.float64]:
    """The values as an array, same shape as given, float64, in their unit, if all are finite and above 0.

    Raises:
        Refusal: naming the field, the first bad value and the range.
    """
    array = numbers(name, values)
    bad = ~(np.isfinite(array) & (array > 0))
    if bad.any():
        raise Refusal(f"{name} = {array[bad].flat[0]:g} {unit} must be finite and above 0 {unit}")
    return array


def stated_grid(text: str) -> NDArray[np.float64]:
    """Frequencies stated as FIRST:LAST:COUNT, evenly spaced; see :func:`frequency_grid` for their range.

    Returns:
        (n_freq,) float64, Hz.

    Raises:
        Refusal: not two numbers and a count.
    """
    rule = f"{text!r} must be FIRST:LAST:COUNT in Hz, such as 1:100:64, with COUNT from 1 to 100000"
    try:
        first, last, count = text.split(":")
        start, stop, number = float(first), float(last), int(count)
    except ValueError:
        raise Refusal(rule) from None
    if not 1 <= number <= 100_000:
        raise Refusal(rule)
    return np.linspace(start, stop, number)


def frequency_grid(frequency: ArrayLike) -> NDArray[np.float64]:
    """The grid as an array, (n_freq,) float64, if its frequency values (n_freq,) ascend within 0.001 to 2000 Hz.

    Frequency 0 is refused: a sealed network has no impedance there. All its pressures become equal as the
    frequency falls.

    Raises:
        Refusal: not real numbers, empty, not 1-D, not ascending, not finite or out of range, with the value.
    """
    grid = numbers("frequency", frequency)
    if grid.ndim != 1 or grid.size == 0:
        raise Refusal(f"frequency has shape {grid.shape}; it must be a 1-D array of at least one value in Hz")
    low, high = _BAND
    bad = ~((grid >= low) & (grid <= high))
    if bad.any():
        raise Refusal(f"frequency = {grid[bad][0]:g} Hz must be between {low:g} and {high:g} Hz")
    falling = np.flatnonzero(np.diff(grid) <= 0)
    if falling.size:
        first = falling[0]
        raise Refusal(f"frequency must ascend: {grid[first + 1]:g} Hz follows {grid[first]:g} Hz")
    return grid
