"""Fonts of pen strokes as alphabets: letters that others drew, each stroke in its order and direction.

The fonts are those of the package Hershey-Fonts (MIT licence), which the extra "fonts" installs. A. V. Hershey drew
them at the U.S. National Bureau of Standards (NBS Special Publication 424, 1976); they may be used and passed on with
that acknowledgement.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from geometry.ground.argument_checks import check_choice
from geometry.ground.extras import check_extras
from localize.recognition.letter_shapes import LETTERS, Alphabet, Stroke

FONTS = ("futural", "futuram", "timesr", "timesrb", "timesi", "timesib", "scripts", "scriptc")
"""Latin fonts of the package that differ: it has most under more names, futural as rowmans too, scripts as cursive."""


@cache
def alphabet_of(font: str) -> Alphabet:
    """Alphabet of a stroke font.

    Args:
        font: one of :data:`FONTS`.

    Returns:
        one shape of each letter, its strokes in heights of the letter, from 0 to 1, y upwards.

    Raises:
        Refusal: another name.
        MissingExtra: the package Hershey-Fonts is not installed.
    """
    check_choice("font", font, FONTS)
    check_extras("the package with stroke fonts", "fonts")
    from HersheyFonts import HersheyFonts

    package = HersheyFonts()
    package.load_default_font(font)
    return {letter: (scaled([list(each) for each in package.strokes_for_text(letter)]),) for letter in LETTERS}


def scaled(strokes: list[Stroke]) -> tuple[Stroke, ...]:
    """Strokes in heights of their letter, from 0 to 1, y upwards.

    Args:
        strokes: places in any unit, y downwards; strokes of fewer than two places are left out.
    """
    kept = [np.array(each, np.float64) * [1.0, -1.0] for each in strokes if len(each) > 1]
    corners = np.concatenate(kept)
    low, height = corners.min(0), np.ptp(corners[:, 1])
    return tuple([(float(x), float(y)) for x, y in (each - low) / height] for each in kept)
