"""Letters of straight strokes: no two alike, sized as said."""

from __future__ import annotations

import string
from itertools import pairwise

import cadquery as cq
import pytest

from geometry.solids.stroke_font import strokes, text_bars, text_size

LETTERS = string.digits + string.ascii_uppercase + "-+."


def test_no_two_letters_look_the_same():
    # Long strokes are cut at the middle place, so that the same line drawn in one or in two strokes compares equal.
    drawn = {}
    for letter in LETTERS:
        halves = set()
        for (x0, y0), (x1, y1) in strokes(letter):
            middle = ((x0 + x1) / 2, (y0 + y1) / 2)
            long = max(abs(x1 - x0), abs(y1 - y0)) == 1 and {middle[0] * 2 % 1, middle[1] * 2 % 1} == {0}
            ends = [(x0, y0), middle, (x1, y1)] if long else [(x0, y0), (x1, y1)]
            halves |= {frozenset(pair) for pair in pairwise(ends)}
        drawn[letter] = frozenset(halves)
    assert len(set(drawn.values())) == len(LETTERS)


def test_a_text_has_the_stated_size_and_is_centred():
    lines = ["08", "H"]
    bars = text_bars(lines, 3.0, 0.5, 0.3)
    text = bars[0].fuse(*bars[1:])
    box = text.BoundingBox()
    width, height = text_size(lines, 3.0)
    assert (box.xlen, box.ylen, box.zlen) == pytest.approx((width, height, 0.3))
    assert (box.center.x, box.center.y, box.zmin) == pytest.approx((0, 0, 0), abs=1e-9)
    assert len(text.Solids()) == 3
    assert isinstance(text, cq.Shape)


def test_a_letter_of_one_bar_has_its_volume():
    (bar,) = text_bars(["I"], 3.0, 0.5, 0.3)
    assert bar.Volume() == pytest.approx(3.0 * 0.5 * 0.3)
