"""Handwriting: letters keep to the surface, lines are read where they are, letters are learnt and told."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from localize.contacts import ContactRecorder
from localize.recognition import LETTERS, Hand, LetterMaker, LineReader, letter_maps, written
from localize.recognition.filter_bank import FilterBank
from localize.recognition.handwriting import varied
from localize.recognition.letter_classifier import strokes_of
from localize.recognition.letter_shapes import HAND
from localize.recognition.recognition_options import VariantOptions
from localize.signals.array_response import ArrayResponse


@pytest.fixture(scope="module")
def surface() -> ArrayResponse:
    """Twelve points of one line, laid over 3 x 4 places 10 mm apart."""
    line = rc_line(12, np.arange(1.0, 501.0, 3.0))
    place = np.array([(10.0 * (k % 3), 10.0 * (k // 3)) for k in range(12)])
    return replace(
        line,
        position=place,
        membrane_radius=np.full(12, 4.0),
        cavity_response=np.full((12, len(line.frequency)), 100.0 + 0j),
    )


@pytest.mark.parametrize("letter", LETTERS)
def test_a_letter_keeps_to_the_surface_and_is_drawn_anew(letter: str, surface: ArrayResponse) -> None:
    one, again, other = (written(letter, surface, Hand(), seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.path, again.path)
    assert one.path.shape != other.path.shape or not np.allclose(one.path, other.path)
    assert one.path.min() > -1.0
    assert one.path[:, 0].max() < 21.0
    assert one.path[:, 1].max() < 31.0
    assert one.label == letter
    strokes = strokes_of(letter, Hand(), np.random.default_rng(0))
    pressed = np.diff((one.force > 0).astype(int))
    assert (pressed == 1).sum() == len(strokes)  # lifted between them


def test_speeds_are_kept(surface: ArrayResponse) -> None:
    contact = written("L", surface, Hand(speed=(40.0, 40.0)))
    pressing = contact.force > 0.5 * contact.force.max()
    speed = np.hypot(*np.gradient(contact.path[pressing], axis=0).T) / np.median(np.diff(contact.time))
    assert np.median(speed) == pytest.approx(40, rel=0.25)


def test_a_line_is_read_where_the_finger_is(surface: ArrayResponse) -> None:
    contact = written("I", surface, Hand(size=(0.9, 0.9)), seed=4)
    take = ContactRecorder(surface, microphone_noise=1e-4).take(contact)
    line = LineReader(surface, 1e-4).line(take.signals)
    assert line.shape[1] == 4
    time, begin = np.unique(line[:, 0], return_index=True)
    down = np.add.reduceat(line[:, 3], begin)
    assert down.max() < 1 + 1e-5
    place = np.add.reduceat(line[:, 1:3] * line[:, 3:], begin) / down[:, None]
    sample = np.round(time * take.signals.shape[1]).astype(int)
    distance = np.linalg.norm(place - take.path[sample], axis=1)[take.force[sample] > 0]
    assert np.median(distance) < 5.0  # half the distance from point to point
    assert place[-1, 1] < place[0, 1] - 10  # from the top down


def test_a_picture_does_not_know_place_and_size() -> None:
    line = np.array([[0.1, 0.0, 0.0, 1.0], [0.5, 5.0, 10.0, 1.0], [0.9, 10.0, 0.0, 1.0]])
    moved = line * [1.0, 3.0, 3.0, 1.0] + [0.0, 40.0, -7.0, 0.0]
    maps = letter_maps(line)
    np.testing.assert_allclose(maps, letter_maps(moved), atol=1e-6)
    rows = np.flatnonzero(maps[0].numpy().max(1) > 0.9)
    assert maps[0, rows[0]].argmax() in (15, 16)  # the tip is above, and in the middle
    assert maps[1, rows[-1], 3:6].min() < -0.5 < 0.5 < maps[1, rows[-1], 26:29].max()  # left first
    assert not letter_maps(np.zeros((0, 4))).any()
    assert not np.allclose(maps, letter_maps(line, np.random.default_rng(0)))


def test_variants_lean_turn_run_backwards_and_lose_parts() -> None:
    along = np.linspace(0, 1, 50)
    line = np.column_stack([along, 10 * along, 20 * along, np.ones(50)])
    still = {"slant": 0.0, "turn": 0.0, "width": 0.0, "bend": 0.0}
    random = np.random.default_rng(0)
    np.testing.assert_allclose(varied(line, random, VariantOptions(**still))[:, 3], line[:, 3])
    leaning = varied(line, random, VariantOptions(**still | {"slant": 0.3}))
    np.testing.assert_allclose(np.diff(leaning[:, 2]), np.diff(line[:, 2]), atol=1e-9)  # heights stay
    assert abs(np.ptp(leaning[:, 1]) - 10) > 0.1
    back = varied(line, random, VariantOptions(**still, backwards=1.0))
    assert np.all(np.diff(back[:, 0]) > 0)
    assert back[0, 2] > back[-1, 2]
    gap = varied(line, random, VariantOptions(**still, with_gap=1.0))
    assert 40 <= len(gap) < 50
    assert np.diff(gap[:, 0]).max() > 1.5 / 49


@pytest.mark.slow
def test_makers_take_hands_in_turn(surface: ArrayResponse) -> None:
    mirrored = {letter: [[[(-x, y) for x, y in each] for each in shapes[0]]] for letter, shapes in HAND.items()}
    hands = (Hand(), Hand(alphabets=(mirrored,)))
    reader = LineReader(surface, 1e-4)
    maker = LetterMaker((reader,), (surface,), 5, 1e-4, hands)
    plain = LetterMaker((reader,), (surface,), 5, 1e-4)
    both, one = maker.lines("evaluation", 38), plain.lines("evaluation", 38)
    assert all(np.array_equal(a, b) for a, b in zip(both[:26], one[:26], strict=True))
    assert not np.array_equal(both[26 + 11], one[26 + 11])  # an L, mirrored


def test_letters_need_places() -> None:
    with refused(Kind.MISMATCH):
        LineReader(rc_line(3, np.arange(1.0, 501.0, 3.0)), 1e-3)


def test_a_font_that_is_not_known_is_refused_before_any_work(surface: ArrayResponse) -> None:
    plan = replace(localize.RecognitionPlan.of("letters"), letter_fonts=("comic",))
    with refused(Kind.OUT_OF_RANGE, "font", "comic"):
        localize.train_recognizer(surface, "letters", plan)


@pytest.mark.slow
def test_a_recognizer_of_letters_learns_and_tells(surface: ArrayResponse) -> None:
    plan = replace(
        localize.RecognitionPlan.of("letters"), takes=18, epochs=12, letter_variants=4, microphone_noise=1e-4
    )
    own = localize.train_recognizer(surface, "letters", plan)
    assert own.labels == LETTERS
    assert own.training["held_out_accuracy"][-1] > 0.12  # a few takes of many hands; by chance it is 0.04
    maker = LetterMaker((LineReader(surface, 1e-4),), (surface,), 5, 1e-4)
    maps, kind = maker.maps("evaluation", 26)
    assert (own.of_maps(maps).argmax(1) == kind.numpy()).mean() > 0.2
    quiet = 1e-4 * np.random.default_rng(0).standard_normal((2, 2500))
    common = []
    for letter in LETTERS[::4]:
        take = ContactRecorder(surface, microphone_noise=1e-4).take(written(letter, surface, Hand(), seed=8))
        signals = np.concatenate([quiet, take.signals, quiet, take.signals, quiet], axis=1)
        first, second = FilterBank(surface, own).touches(signals, None, None, localize.BayesDecoder(surface, 1e-4))
        assert first.end < second.start
        likeliest = [set(each.probability.argsort()[-3:].tolist()) for each in (first, second)]
        common.append(len(likeliest[0] & likeliest[1]))
    # The same letter twice, cut elsewhere into frames. So short a training changes its mind about a letter or two;
    # of three letters drawn by chance 0.35 would be common.
    assert np.mean(common) > 1.5


@pytest.mark.slow
def test_signs_of_ones_own_are_learnt_from_recordings(surface: ArrayResponse, tmp_path: Path) -> None:
    lines, number = ["full_scale = 50.0"], 0
    for letter in "LO":
        for _ in range(2):
            take = ContactRecorder(surface, microphone_noise=1e-4).take(
                written(letter, surface, Hand(), 6, sample=number)
            )
            quiet = 1e-4 * np.random.default_rng(number).standard_normal((2, 2500))
            name = f"{number}.wav"
            write_wav(tmp_path / name, np.concatenate([quiet, take.signals, quiet], axis=1) / 50, 1000, 32)
            lines += ["[[recordings]]", f'file = "{name}"', "point = 1", f'label = "{letter}"']
            number += 1
    (tmp_path / "mine.toml").write_text("\n".join(lines))
    plan = replace(localize.RecognitionPlan.of("letters"), epochs=2, batch=4, letter_variants=6, microphone_noise=1e-4)
    own = localize.train_recognizer(surface, "letters", plan, recordings=tmp_path / "mine.toml")
    assert own.labels == ("L", "O")
    assert own.training["takes"] == 12  # six pictures of each
    assert own.training["held_out_takes"] == 2  # as they are told
