"""A ring of four lines, two of them with tubes of their own: a rectangle with a microphone at each corner."""

from __future__ import annotations

import geometry
from geometry import ArrayDesign


def rectangle(points: int = 16) -> ArrayDesign:
    """Parts of the large area, laid out in a ring: lines 1 and 3 with its tubes, 2 and 4 with those of its rows."""
    area = geometry.prototype("large-area-64")
    names = "ABCD"
    lines = [{"between": [names[k], names[(k + 1) % 4]], "points": points} for k in range(4)]
    for line in lines[1::2]:
        line["tube"] = area.tube_kinds["across"]
    return area.with_values({"lines": lines, "tube_kinds": {}, "layout": {"kind": "ring"}})
