"""Kinds of contacts: the same whenever they are made, others for other samples, and what each is said to be."""

from pathlib import Path

import numpy as np
import pytest
from refusals import check_messages, refused

from geometry import Kind
from localize import contacts

PATH = [(0.0, 0.0), (30.0, 0.0), (30.0, 10.0)]
KINDS = {
    **{
        name: (lambda make: lambda **stream: make(PATH, 50.0, **stream))(getattr(contacts, name))
        for name in ("finger", "stylus", "feather", "brush", "rolling_ball", "insect", "stroke")
    },
    **{
        name: (lambda make: lambda **stream: make((3.0, 4.0), **stream))(getattr(contacts, name))
        for name in ("falling_grain", "air_puff", "tap", "double_tap", "press", "pulse_wave")
    },
    "slide": lambda **stream: contacts.slide((0.0, 0.0), (20.0, 0.0), 40.0, **stream),
}


@pytest.mark.parametrize("name", KINDS)
def test_every_contact_is_the_same_again_and_unlike_its_neighbours(name):
    one, again = (KINDS[name](seed=2, sample=7) for _ in range(2))
    assert np.array_equal(one.force, again.force)
    assert np.array_equal(one.path, again.path)
    assert one.time[0] == 0
    assert (one.contact_radius_mm, one.roughness, one.label) == (again.contact_radius_mm, again.roughness, again.label)
    for other in (
        KINDS[name](seed=2, sample=8),
        KINDS[name](seed=3, sample=7),
        KINDS[name](seed=2, purpose="training", sample=7),
    ):
        assert other.force.max() != one.force.max()
    assert one.force[0] == one.force[-1] == 0 or name == "falling_grain"
    assert 0 < one.force.max() < 0.1
    assert one.label


def test_strokes_keep_to_their_path_and_speed():
    made = contacts.finger(PATH, 50.0)
    pressed = made.force > 0
    assert made.time[pressed].max() - made.time[pressed].min() == pytest.approx(0.8, abs=0.003)
    step = np.hypot(*np.diff(made.path[pressed], axis=0).T)
    assert np.median(step) == pytest.approx(0.05, rel=1e-6)
    assert made.path[0] == pytest.approx(PATH[0])
    assert made.path[-1] == pytest.approx(PATH[-1])
    slower = contacts.finger(PATH, [50.0, 25.0])
    assert slower.seconds - made.seconds == pytest.approx(0.2, abs=2e-3)


def test_a_grain_brings_the_momentum_of_its_fall():
    made = contacts.falling_grain((0.0, 0.0), sample=1)
    weight = made.force[-1]
    first = made.time < 0.1 + 3.1e-3
    momentum = np.trapezoid(made.force[first], made.time[first])
    speed = momentum / (weight / 9.81)
    assert np.sqrt(2 * 9.81 * 5e-3) * 1.3 < speed < np.sqrt(2 * 9.81 * 20e-3) * 1.6


@pytest.mark.parametrize("rate", [50.0, 100.0])
def test_a_pulse_has_as_many_beats_as_it_should(rate):
    made = contacts.pulse_wave((0.0, 0.0), rate, 12.0, sample=3)
    spectrum = np.abs(np.fft.rfft(made.force - made.force.mean()))
    hertz = np.fft.rfftfreq(len(made.force), 1e-3)
    heard = (hertz > 0.7) & (hertz < 1.3 * rate / 60)
    assert 60 * hertz[heard][spectrum[heard].argmax()] == pytest.approx(rate, rel=0.08)


def test_joined_contacts_follow_each_other():
    one, two = contacts.tap((0, 0), sample=1), contacts.tap((9, 0), sample=2)
    both = contacts.joined([one, two], "A")
    assert both.label == "A"
    assert both.seconds == pytest.approx(one.seconds + two.seconds + 1e-3)
    assert both.force.max() == max(one.force.max(), two.force.max())


IMPOSSIBLE = {
    "speed": (lambda: contacts.finger(PATH, 0.0), Kind.OUT_OF_RANGE),
    "path": (lambda: contacts.stylus([(1, 1), (1, 1)], 10.0), Kind.UNSUITABLE),
    "path of one place": (lambda: contacts.brush([(1, 1)], 10.0), Kind.WRONG_TYPE),
    "speed of each piece": (lambda: contacts.feather(PATH, [1.0, 2.0, 3.0]), Kind.WRONG_TYPE),
    "place": (lambda: contacts.tap((1, 2, 3)), Kind.WRONG_TYPE),
    "rate": (lambda: contacts.pulse_wave((0, 0), 300.0), Kind.OUT_OF_RANGE),
    "shape": (lambda: contacts.pulse_wave((0, 0), shape="square"), Kind.OUT_OF_RANGE),
    "rhythm": (lambda: contacts.pulse_wave((0, 0), rhythm="waltz"), Kind.OUT_OF_RANGE),
    "contacts": (lambda: contacts.joined([]), Kind.MISSING),
}


def test_impossible_kinds_are_refused():
    for name, (call, kind) in IMPOSSIBLE.items():
        with refused(kind, name.split(" ")[0]):
            call()
    check_messages(Path(__file__).parent / "messages.txt", {name: call for name, (call, _) in IMPOSSIBLE.items()})
