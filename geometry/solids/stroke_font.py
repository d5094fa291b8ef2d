"""Letters made of straight strokes of one width: they need no font, and they print where that width does.

Digits are those of a seven-stroke display; letters follow them, some in lower case, so that no two look the same.
Lengths in mm.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import cadquery as cq

Point = tuple[float, float]

#: Width of a letter and the space to the next, in its heights.
WIDTH, SPACE = 0.55, 0.2
#: Space between two lines, in heights.
_LINE_SPACE = 0.4
#: The nine places of a letter where strokes end, in units of its width and height: three above, amid and below.
_PLACES: dict[str, Point] = dict(zip("abcdefghi", ((x / 2, y / 2) for y in (2, 1, 0) for x in (0, 1, 2)), strict=True))
#: Each letter as chains of places.
_CHAINS = {
    "0": "aciga", "1": "ci", "2": "acfdgi", "3": "acig df", "4": "adf ci", "5": "cadfig", "6": "cagifd", "7": "aci",
    "8": "aciga df", "9": "fdacig",
    "A": "gaci df", "B": "agifd", "C": "cagi", "D": "cigdf", "E": "cagi df", "F": "cag df", "G": "cagife",
    "H": "ag ci df", "I": "bh", "J": "cigd", "K": "ag cdi", "L": "agi", "M": "gaeci", "N": "gaic", "O": "dfigd",
    "P": "gacfd", "Q": "icadf", "R": "gdf", "S": "caig", "T": "ac bh", "U": "agic", "V": "ahc", "W": "ageic",
    "X": "ai cg", "Y": "aec eh", "Z": "acgi", "-": "df", "+": "df be eh", ".": "hh",
}  # fmt: skip


def strokes(letter: str) -> list[tuple[Point, Point]]:
    """Ends of the strokes of a letter, in units of its width and height.

    Args:
        letter: a digit, a capital letter, a full stop, ``-`` or ``+``.
    """
    chains = _CHAINS[letter].split()
    return [(_PLACES[start], _PLACES[end]) for chain in chains for start, end in pairwise(chain)]


def text_size(lines: Sequence[str], height: float) -> Point:
    """Width and height of a text, mm, in letters of that height, mm."""
    longest = max(map(len, lines))
    return height * (longest * (WIDTH + SPACE) - SPACE), height * (len(lines) * (1 + _LINE_SPACE) - _LINE_SPACE)


def letters_within(width: float, depth: float, height: float) -> tuple[int, int]:
    """Numbers of letters of that height that fit on a line, and of lines, in a width and a depth, all mm."""
    letters = (width / height + SPACE) / (WIDTH + SPACE)
    lines = (depth / height + _LINE_SPACE) / (1 + _LINE_SPACE)
    return math.floor(letters + 1e-9), math.floor(lines + 1e-9)


def text_bars(lines: Sequence[str], height: float, width: float, depth: float) -> list[cq.Solid]:
    """A text as one bar for each stroke, from z = 0 to ``depth``, centred on the origin, to be read from above.

    Args:
        lines: of letters that :func:`strokes` knows, and spaces.
        height: of a letter, mm.
        width: of a stroke, mm.
        depth: of the bars, mm.
    """
    box = WIDTH * height - width, height - width
    top = text_size(lines, height)[1] / 2 - height
    bars = []
    for row, line in enumerate(lines):
        left, bottom = -text_size([line], height)[0] / 2, top - row * (1 + _LINE_SPACE) * height
        for place, letter in enumerate(line):
            if letter == " ":
                continue
            corner = left + place * (WIDTH + SPACE) * height + width / 2, bottom + width / 2
            for ends in strokes(letter):
                start, end = ((corner[0] + x * box[0], corner[1] + y * box[1]) for x, y in ends)
                bars.append(_bar(start, end, width, depth))
    return bars


def _bar(start: Point, end: Point, width: float, depth: float) -> cq.Solid:
    """A bar between two points; upright and level ones are half its width longer at both ends, to make corners."""
    import cadquery as cq

    length, angle = math.dist(start, end), math.atan2(end[1] - start[1], end[0] - start[0])
    spare = 0.0 if start[0] != end[0] and start[1] != end[1] else width / 2
    bar = cq.Solid.makeBox(length + 2 * spare, width, depth, cq.Vector(-spare, -width / 2, 0))
    return bar.rotate(cq.Vector(), cq.Vector(0, 0, 1), math.degrees(angle)).moved(cq.Location(cq.Vector(*start, 0)))
