"""Checks of frequencies and ports that come in from outside."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from geometry.ground.argument_checks import check_range, positive_numbers, real_numbers, wrong_type
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array

_BAND = (1e-3, 2e3)
"""Lowest and highest frequency of a grid, Hz."""


MOST_PORTS = 50
"""Most ports of a cell: each takes a solve of its own at every frequency."""


def port_points(ports: Mapping[str, ArrayLike]) -> dict[str, tuple[float, float, float]]:
    """Point (x, y, z) in mm on each port by its name: ``ports`` as (3,) float64 each.

    Raises:
        Refusal: no mapping, no port or too many, a name that is not a text, empty or ``wall`` (every face that is no
            port), or a point that is not three finite numbers.
    """
    if not isinstance(ports, Mapping):
        raise Refusal(f"must map names to points, not be a {type(ports).__name__}", kind=Kind.WRONG_TYPE, field="ports")
    if not 1 <= len(ports) <= MOST_PORTS:
        problem = f"has {counted(len(ports), 'port')}; it must have 1 to {MOST_PORTS}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="ports")
    points = {}
    for name, place in ports.items():
        if not isinstance(name, str) or name in ("", "wall"):
            raise Refusal(
                f"has the name {name!r}; it must be a text, not empty and not 'wall'",
                kind=Kind.WRONG_TYPE if not isinstance(name, str) else Kind.OUT_OF_RANGE,
                field="ports",
            )
        point = real_numbers(f"ports.{name}", place)
        if point.shape != (3,) or not np.isfinite(point).all():
            raise Refusal(
                kind=Kind.WRONG_TYPE if point.shape != (3,) else Kind.OUT_OF_RANGE,
                field=f"ports.{name}",
                value=place,
                allowed="a point of three finite numbers, mm",
            )
        points[name] = (float(point[0]), float(point[1]), float(point[2]))
    return points


FrequencyLike: TypeAlias = ArrayLike | str
"""An argument ``frequency``: numbers in Hz, or the text ``FIRST:LAST:COUNT`` for evenly spaced ones."""


def frequencies(frequency: FrequencyLike) -> Array:
    """The frequencies as an array, same shape as given, float64, Hz, in any order; those of a text are evenly spaced.

    Raises:
        Refusal: not real numbers, not finite or not above 0; a text of another form.
    """
    given = _evenly_spaced(frequency) if isinstance(frequency, str) else frequency
    return positive_numbers("frequency", given, "Hz")


def frequency_grid(frequency: FrequencyLike) -> Array:
    """The grid as an array, (n_freq,) float64, Hz, ascending within 0.001 to 2000 Hz.

    Frequency 0 is refused: a sealed network has no impedance there. All its pressures become equal as the
    frequency falls.

    Args:
        frequency: (n_freq,) Hz, or the text ``FIRST:LAST:COUNT`` for evenly spaced ones, such as ``"1:500:500"``.

    Raises:
        Refusal: not real numbers, empty, not 1-D, not ascending, not finite or out of range, with the value; a text of
            another form.
    """
    grid = _evenly_spaced(frequency) if isinstance(frequency, str) else real_numbers("frequency", frequency)
    if grid.ndim != 1 or grid.size == 0:
        raise wrong_type("frequency", f"has shape {grid.shape}; it must be a 1-D array of at least one value in Hz")
    low, high = _BAND
    for value in grid[~((grid >= low) & (grid <= high))]:
        check_range("frequency", float(value), low, high, "Hz")
    falling = np.flatnonzero(np.diff(grid) <= 0)
    if falling.size:
        problem = f"must ascend: {grid[falling[0] + 1]:g} Hz follows {grid[falling[0]]:g} Hz"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="frequency")
    return grid


def _evenly_spaced(text: str) -> Array:
    allowed = "FIRST:LAST:COUNT in Hz, such as 1:100:64, with COUNT from 1 to 100000"
    try:
        first, last, count = text.split(":")
        start, stop, number = float(first), float(last), int(count)
    except ValueError:
        raise Refusal(kind=Kind.WRONG_TYPE, field="frequency", value=text, allowed=allowed) from None
    if not 1 <= number <= 100_000:
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="frequency", value=text, allowed=allowed)
    return np.linspace(start, stop, number)
