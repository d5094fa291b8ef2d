"""Sides of an array at which its microphones lie, and rows that are turned so that a line ends there."""

from __future__ import annotations

import numpy as np

from geometry.ground.typed import Array
from geometry.schema.array_fields import StatedArray

#: Directions of the sides in plan, degrees.
SIDES = {"left": 180.0, "right": 0.0, "front": 270.0, "back": 90.0}
#: Turns of a plan whose line ends at the left, as (cos, sin), which are exact.
_TURNS = {180.0: (1, 0), 270.0: (0, 1), 0.0: (-1, 0), 90.0: (0, -1)}


def grid_of_line(design: StatedArray) -> tuple[int, int]:
    """Columns and rows of the first line of a serpentine; the last row need not be full."""
    points = design.lines[0].points
    columns = min(design.layout.columns, points)
    return columns, -(-points // columns)


def has_turned_rows(design: StatedArray) -> bool:
    """True where the rows of a serpentine are turned to the side of the microphones.

    A single row needs no turn if the side is along it, because both of its ends are there already; nor do the rows of
    a cylinder, which run around it.
    """
    columns, rows = grid_of_line(design)
    across = design.layout.microphone_side in ("front", "back")
    return design.layout.kind == "serpentine" and (rows if across else columns) > 1


def turned_to(positions: Array, side: float) -> Array:
    """Positions, (n, 2) float64, mm, of a line that ends at the left, turned so that it ends at a side, degrees."""
    cos, sin = _TURNS[side]
    return np.asarray(positions @ np.array([[cos, sin], [-sin, cos]], np.float64) + 0.0)
