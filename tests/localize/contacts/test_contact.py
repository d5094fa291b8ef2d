"""Shares of a Hertz pressure, what is refused, and roughness."""

from itertools import pairwise

import numpy as np
import pytest
from refusals import refused

from geometry import Kind
from localize.contacts import Contact, hertz_fraction


def by_squares(distance, contact, membrane, steps=800):
    """The share by plain summation over the plane."""
    along = (np.arange(steps) + 0.5) / steps * 2 * contact - contact
    x, y = np.meshgrid(along, along)
    pressure = np.sqrt(np.maximum(1 - (x**2 + y**2) / contact**2, 0))
    inside = (x - distance) ** 2 + y**2 < membrane**2
    return (pressure * inside).sum() / pressure.sum()


@pytest.mark.parametrize(("contact", "membrane"), [(5.0, 3.0), (1.0, 4.0), (3.0, 3.0)])
def test_the_share_is_the_sum_of_the_pressure_over_the_membrane(contact, membrane):
    distance = np.array([0.0, 0.3, 1.9, 2.1, 3.5, 4.6, 7.9])
    expected = [by_squares(each, contact, membrane) for each in distance]
    assert hertz_fraction(distance, contact, membrane) == pytest.approx(expected, abs=5e-4)


def test_a_contact_inside_a_membrane_gives_it_all_and_one_beyond_its_edge_nothing():
    assert hertz_fraction(np.array([0.0, 1.0, 2.0]), 1.0, 3.0) == pytest.approx(1.0, abs=1e-12)
    assert hertz_fraction(np.array([4.0, 50.0]), 1.0, 3.0) == pytest.approx(0.0, abs=1e-12)


def test_membranes_that_tile_a_contact_share_all_of_it():
    # A wide membrane is a half plane: what is left of its edge and what is right of it make the whole.
    distance = np.linspace(-0.9, 0.9, 7) + 1e5
    left, right = hertz_fraction(distance, 1.0, 1e5), hertz_fraction(2e5 - distance, 1.0, 1e5)
    assert left + right == pytest.approx(1.0, abs=1e-5)


def test_the_rule_is_good_to_1e_9():
    from scipy.integrate import quad

    def exact(distance, contact, membrane):
        def ring(r):
            reach = (r**2 + distance**2 - membrane**2) / (2 * r * distance)
            return 3 * r / contact**2 * np.sqrt(1 - (r / contact) ** 2) * np.arccos(np.clip(reach, -1, 1)) / np.pi

        edges = sorted({0.0, *np.clip([abs(membrane - distance), membrane + distance], 0, contact), contact})
        return sum(quad(ring, *pair, epsabs=1e-13, epsrel=1e-12, limit=400)[0] for pair in pairwise(edges))

    for case in [(2.0, 5.0, 3.0), (4.0, 2.0, 3.5), (0.5, 3.0, 3.0)]:
        assert float(hertz_fraction(np.array(case[0]), *case[1:])) == pytest.approx(exact(*case), abs=1e-9)


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        ({"time": [0.0]}, Kind.WRONG_TYPE),
        ({"time": [0.0, 0.0]}, Kind.WRONG_TYPE),
        ({"path": [[0.0, 0.0]]}, Kind.WRONG_TYPE),
        ({"force": [0.0, -1.0]}, Kind.OUT_OF_RANGE),
        ({"force": [0.0, np.nan]}, Kind.UNSUITABLE),
        ({"contact_radius_mm": 0.0}, Kind.OUT_OF_RANGE),
        ({"roughness": 3.0}, Kind.OUT_OF_RANGE),
    ],
)
def test_contacts_that_cannot_be_are_refused(change, kind):
    values = {"time": [0.0, 1.0], "path": [[0.0, 0.0], [1.0, 0.0]], "force": [1.0, 1.0], "contact_radius_mm": 1.0}
    with refused(kind, f"contact.{next(iter(change))}"):
        Contact(**{**values, **change})


def test_roughness_sounds_while_the_contact_moves_and_its_pitch_rises_with_the_speed():
    def fluctuation(speed):
        time = np.arange(4000) / 1000
        path = np.column_stack([speed * time, np.zeros(4000)])
        return Contact(time, path, np.ones(4000), 1.0, 0.2).roughened(5).force - 1

    def pitch(signal):
        power = np.abs(np.fft.rfft(signal)) ** 2
        return (power[1:] * np.fft.rfftfreq(4000, 1e-3)[1:]).sum() / power[1:].sum()

    assert np.abs(fluctuation(0.0)).max() == 0
    assert fluctuation(100.0).std() == pytest.approx(0.2, rel=0.25)
    assert pitch(fluctuation(100.0)) == pytest.approx(4 * pitch(fluctuation(25.0)), rel=0.1)
