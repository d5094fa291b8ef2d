"""Where a pen is guessed to be: over what is heard, beside what is not, at the speed of the line."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from rc_line import rc_line
from refusals import refused

from geometry import Kind
from localize.recognition.pen_path import PenTracker
from localize.recognition.recognition_options import PenOptions

PITCH = 18.0
SIDE = 5


@pytest.fixture(scope="module")
def pen() -> PenTracker:
    """Of 5 x 5 points 18 mm apart."""
    array = rc_line(SIDE**2, np.arange(1.0, 501.0, 3.0))
    place = PITCH * np.array([(k % SIDE, k // SIDE) for k in range(SIDE**2)], np.float64)
    return PenTracker(replace(array, position=place, membrane_radius=np.full(SIDE**2, 3.0)))


def heard(pen: PenTracker, *stretches: tuple[int, float, float]) -> NDArray[np.float32]:
    """Probabilities of cells where points are heard one after the other: point, level (dB), seconds."""
    hops = [round(1000 * seconds / pen.hop) for _, _, seconds in stretches]
    point = np.repeat([each[0] for each in stretches], hops)
    level = np.repeat([each[1] for each in stretches], hops)
    # What names points in silence is noise.
    point = np.where(level > PenOptions.floor, point, np.random.default_rng(0).integers(SIDE**2, size=len(point)))
    return pen.probability(point, level, -60.0)


def test_the_pen_is_over_the_point_that_is_heard(pen: PenTracker) -> None:
    found = heard(pen, (12, 0.0, 0.5), (13, 0.0, 0.5))
    assert found.shape == (len(found), len(pen.place))
    assert found.min() >= 0
    assert found.sum(1).max() < 1 + 1e-5
    np.testing.assert_allclose(found[3] @ pen.place, [36, 36], atol=5)
    np.testing.assert_allclose(found[-4] @ pen.place, [54, 36], atol=5)


def test_where_nothing_is_heard_the_pen_is_beside_the_points(pen: PenTracker) -> None:
    silent = (10, PenOptions.floor, 1.5)
    found = heard(pen, (10, 0.0, 0.4), silent, (14, 0.0, 0.4))
    middle = found[len(found) // 2]
    away = np.linalg.norm(pen.place[:, None] - PITCH * np.array([[1, 2], [2, 2], [3, 2]]), axis=-1).min(1)
    assert middle[away < 4].sum() < 0.02
    assert middle @ pen.place[:, 0] / middle.sum() == pytest.approx(2 * PITCH, abs=8)  # half the way is done


def test_a_faint_point_is_passed_at_a_distance(pen: PenTracker) -> None:
    passed = [(k, level, 0.45) for k, level in ((10, 0.0), (11, -25.0), (12, -25.0), (13, -25.0), (14, 0.0))]
    loud = [(k, 0.0, 0.45) for k in range(10, 15)]
    off = []
    for stretches in (passed, loud):
        found = heard(pen, *stretches)
        middle = found[len(found) // 2]
        off.append(float(middle @ abs(pen.place[:, 1] - 2 * PITCH)) / float(middle.sum()))
    assert off[0] > 5 > off[1]


def test_a_pen_that_comes_back_far_away_was_lifted(pen: PenTracker) -> None:
    there, back = ([(k, 0.0, 0.3) for k in row] for row in ((0, 1, 2), (22, 23, 24)))
    found = heard(pen, *there, (2, PenOptions.floor, 0.3), *back).sum(1)
    assert PenOptions.speeds[-1] < 4 * PITCH / 0.3  # no pen is as fast
    middle = len(found) // 2
    assert found[middle - 1 : middle + 2].max() < 0.1
    assert min(found[4:12].min(), found[-12:-4].min()) > 0.9


def test_lines_of_any_length_are_judged(pen: PenTracker) -> None:
    short = heard(pen, (12, 0.0, 10.0))
    long = heard(pen, (12, 0.0, 60.0))
    assert len(long) > 600 > len(short)
    np.testing.assert_allclose(long[:100], short[:100], atol=1e-3)


def test_a_pen_needs_places() -> None:
    with refused(Kind.MISMATCH):
        PenTracker(rc_line(3, np.arange(1.0, 501.0, 3.0)))
