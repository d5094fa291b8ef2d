"""Places between the points."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
import localize
from geometry import Kind
from localize.contacts import Contact, record
from localize.signals import response_of
from localize.signals.array_response import ArrayResponse
from localize.tracking.footprints import footprints_over, fractions_at, pitch_of

PITCH = 4.0


@pytest.fixture(scope="module")
def array() -> ArrayResponse:
    """Six points of a fingertip, three in a row."""
    design = geometry.prototype("fingertip-4x6").with_values({"lines.0.points": 6, "layout.columns": 3})
    return response_of(acoustic_fem.solve(design, np.arange(1.0, 501.0, 2.0), "lumped"))


@pytest.fixture(scope="module")
def decoder(array: ArrayResponse) -> localize.PositionDecoder:
    return localize.PositionDecoder(array, contact_radius_mm=3.5)


def tapped(array: ArrayResponse, places: np.ndarray, radius: float) -> np.ndarray:
    """Frames of taps of 20 ms, (n, 2, 250) Pa."""
    time = np.arange(250) / 1e3
    force = 5e-3 * np.where((time > 0.1) & (time < 0.12), np.sin(np.pi * (time - 0.1) / 0.02) ** 2, 0.0)
    taps = [Contact(time, np.tile(place, (250, 1)), force, radius) for place in places]
    return np.stack(
        [record(each, array, microphone_noise=1e-3, sample=k, linear=True).signals for k, each in enumerate(taps)]
    )


@pytest.fixture(scope="module")
def between(array: ArrayResponse) -> np.ndarray:
    """Two places between the first two points, (2, 2) mm."""
    assert array.position is not None
    first, second = array.position[:2]
    return np.asarray(first + np.array([[0.3], [0.7]]) * (second - first))


@pytest.mark.slow
def test_taps_between_two_points_are_told_where(
    array: ArrayResponse, decoder: localize.PositionDecoder, between: np.ndarray
) -> None:
    found = decoder.position(tapped(array, between, 3.5))
    error = np.linalg.norm(found.place - between, axis=1)
    assert np.sqrt((error**2).mean()) < 0.02 * PITCH  # of the nearest points it is 0.3
    assert (error < 4 * found.deviation + 1e-3).all()
    assert array.position is not None
    assert (found.point - 1).tolist() == np.linalg.norm(between[:, None] - array.position, axis=-1).argmin(1).tolist()


@pytest.mark.slow
def test_of_a_sensor_that_is_not_the_librarys_a_place_is_not_sure(
    array: ArrayResponse, decoder: localize.PositionDecoder, between: np.ndarray
) -> None:
    off = np.random.default_rng(1).normal(0, 0.1, (*array.transfer_function.shape[:2], 1))
    made = replace(array, transfer_function=array.transfer_function * np.exp(off))
    found = decoder.position(tapped(made, between, 3.5))
    assert (np.linalg.norm(found.place - between, axis=1) < 4 * found.deviation).all()
    assert (found.deviation > 10 * decoder.position(tapped(array, between, 3.5)).deviation).all()


@pytest.mark.slow
def test_on_a_line_that_is_known_a_tap_is_told_to_a_hundredth(
    array: ArrayResponse, decoder: localize.PositionDecoder, between: np.ndarray
) -> None:
    assert array.position is not None
    first, second = array.position[:2]
    share = np.linspace(0, 1, 101)[:, None]
    signals = tapped(array, between, 3.5)
    found = decoder.log_likelihood_of(signals, first + share * (second - first))
    assert found.shape == (2, 101)
    assert np.allclose(share[found.argmax(1), 0], [0.3, 0.7], atol=0.02)
    with refused(Kind.WRONG_TYPE, "place"):
        decoder.log_likelihood_of(signals, [first])


def test_points_are_named_by_the_places_around_them(array: ArrayResponse, decoder: localize.PositionDecoder) -> None:
    assert array.position is not None
    probability = decoder.locate(tapped(array, array.position, 3.5))
    assert probability.shape == (6, 6)
    assert np.allclose(probability.sum(1), 1)
    assert (probability.argmax(1) == np.arange(6)).mean() > 0.8


def test_a_contact_that_reaches_one_membrane_is_as_far_off_as_it_reaches(array: ArrayResponse) -> None:
    assert array.position is not None
    narrow = localize.PositionDecoder(array, 0.5, 1e-3)
    found = narrow.position(tapped(array, array.position[[4]], 0.5))
    assert found.point.tolist() == [5]
    assert np.linalg.norm(found.place[0] - array.position[4]) < 0.1
    # Evenly over a disc of 1.3 mm: half its radius in each direction.
    assert found.deviation[0] == pytest.approx(1.3 / 2, rel=0.15)


def test_footprints_of_a_grid_are_no_more_than_asked_for(array: ArrayResponse) -> None:
    assert pitch_of(array) == pytest.approx(PITCH)
    fine, coarse = (footprints_over(array, 3.5, most) for most in (2000, 100))
    assert fine.step == pytest.approx(0.1 * PITCH)
    assert len(coarse.fraction) <= 100 < len(fine.fraction)
    assert np.allclose(np.linalg.norm(fine.fraction, axis=1), 1)
    own = fractions_at(array, 3.5, fine.place[:5])
    assert np.allclose(own / np.linalg.norm(own, axis=1, keepdims=True), fine.fraction[fine.footprint[:5]], atol=2e-3)


def test_bare_transfer_functions_have_no_places(array: ArrayResponse) -> None:
    bare = replace(array, position=None, membrane_radius=None, cavity_response=None, name="bare")
    with refused(Kind.MISMATCH):
        localize.PositionDecoder(bare)
    with refused(Kind.OUT_OF_RANGE, "contact_radius_mm", 0.0):
        localize.PositionDecoder(array, contact_radius_mm=0.0)
