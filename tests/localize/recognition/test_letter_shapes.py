"""Alphabets: every letter, in heights, written in the orders and directions of others, and those of fonts."""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

from geometry import Kind
from geometry.ground.extras import MissingExtra
from localize.recognition import LETTERS, Hand
from localize.recognition.letter_classifier import strokes_of, training_hands
from localize.recognition.letter_shapes import HAND, PRINT, SCRIPT, Alphabet
from localize.recognition.stroke_fonts import FONTS, alphabet_of


@pytest.mark.parametrize("alphabet", [HAND, PRINT, SCRIPT], ids=["hand", "print", "script"])
def test_alphabets_have_all_letters_and_their_shapes_differ(alphabet: Alphabet) -> None:
    assert tuple(sorted(alphabet)) == LETTERS
    shapes = [shape for letter in LETTERS for shape in alphabet[letter]]
    for shape in shapes:
        places = np.concatenate([np.array(stroke) for stroke in shape])
        assert all(len(stroke) > 1 for stroke in shape)
        assert 0.85 < np.ptp(places[:, 1]) < 1.6
        assert np.ptp(places[:, 0]) < 1.2
    assert len({str(shape) for shape in shapes}) == len(shapes)


def test_letters_of_fonts_stand_upright_and_are_as_high_as_ours() -> None:
    pytest.importorskip("HersheyFonts")
    for font in FONTS:
        alphabet = alphabet_of(font)
        assert tuple(sorted(alphabet)) == LETTERS
        for shape in (alphabet[letter][0] for letter in LETTERS):
            height = np.concatenate([np.array(stroke)[:, 1] for stroke in shape])
            assert (height.min(), height.max()) == pytest.approx((0, 1))
    top, bottom = np.array(alphabet_of("futural")["T"][0][1]), np.array(alphabet_of("futural")["L"][0][-1])
    assert top[:, 1].min() > 0.9 > 0.1 > bottom[:, 1].max()
    assert len({str(alphabet_of(font)["A"]) for font in FONTS}) == len(FONTS)


def test_unknown_fonts_and_a_missing_package_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with refused(Kind.OUT_OF_RANGE, "font", "comic"):
        alphabet_of("comic")
    alphabet_of.cache_clear()
    monkeypatch.setitem(sys.modules, "HersheyFonts", None)
    monkeypatch.setattr("geometry.ground.extras.find_spec", lambda _: None)
    with pytest.raises(MissingExtra, match=r"pip install 'acoustic-fem\[fonts\]'"):
        training_hands((25.0, 60.0), ("timesr",))
    assert training_hands((25.0, 60.0), ())  # our shapes alone need no package


def test_orders_directions_and_joined_strokes_are_drawn() -> None:
    still = Hand(slant=0, turn=0, wobble=0)
    begun = []
    for hand in (still, replace(still, reordered=1.0)):
        drawn = [strokes_of("H", hand, np.random.default_rng(k))[0][0] for k in range(30)]
        begun.append({(x > 0, round(float(y), 1)) for x, y in drawn})
    assert begun[0] == {(False, 0.5)}  # the left stroke, from above
    assert len(begun[1]) == 6  # either end of three strokes
    assert [len(strokes_of("H", Hand(connected=1.0), np.random.default_rng(k))) for k in range(3)] == [1, 1, 1]
    plain, hooked = (strokes_of("L", Hand(hooks=share, wobble=0), np.random.default_rng(0))[0] for share in (0.0, 1.0))
    assert len(hooked) > len(plain)
    straight, bent = (strokes_of("L", Hand(bend=share, wobble=0), np.random.default_rng(0))[0] for share in (0.0, 0.1))
    assert straight.shape == bent.shape
    assert not np.allclose(straight, bent)
