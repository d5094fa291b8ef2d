"""Rings of lines: a rectangle, two sides of which have tubes of their own, and a triangle."""

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


def triangle(**values: object) -> ArrayDesign:
    """Three lines of five points between three microphones, with the parts of the glove, flat."""
    lines = [{"between": list(pair), "points": 5} for pair in ("AB", "AC", "BC")]
    ring = {"name": "triangle", "lines": lines, "layout": {"kind": "ring"}, "microphone.chamber_diameter": 1.8}
    return geometry.prototype("glove").with_values({**ring, **values})
