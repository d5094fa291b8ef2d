"""How fast a straight slide was, by the points that it passes."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from shared import solved

import localize
from localize.contacts import Contact, record
from localize.recognition import PROFILES, texture_force
from localize.signals import response_of
from localize.signals.array_response import ArrayResponse
from localize.tracking import straight_slide

NOISE = 1e-3


@cache
def array() -> ArrayResponse:
    """Two rows of six points, 18.5 mm apart."""
    return response_of(solved("array-2x6", np.arange(1.0, 501.0, 2.0)))


def slid(begin: int, end: int, speed: float, beside: float = 1.0) -> np.ndarray:
    """Signals of a pad that passes a ridged profile on its way from one point to another, (2, n) Pa."""
    place = array().position
    assert place is not None
    ends = place[[begin, end]] + [0.0, beside]
    time = np.arange(round(1e3 * np.linalg.norm(ends[1] - ends[0]) / speed)) / 1e3
    force = 5e-3 * texture_force(PROFILES[5], len(time), speed, np.random.default_rng(begin))
    path = ends[0] + (ends[1] - ends[0]) * (time / time[-1])[:, None]
    return record(Contact(time, path, force, 6.0), array(), microphone_noise=NOISE).signals


def found(signals: np.ndarray) -> localize.tracking.Slide | None:
    return straight_slide(array(), localize.BayesDecoder(array(), NOISE).locate, signals)


@pytest.mark.parametrize(("begin", "end", "speed"), [(0, 3, 10.0), (8, 11, 18.0), (2, 0, 40.0)])
def test_a_slide_tells_its_speed_and_the_points_that_it_passes(begin: int, end: int, speed: float) -> None:
    slide = found(slid(begin, end, speed))
    assert slide is not None
    assert slide.speed == pytest.approx(speed, rel=0.05)
    assert (slide.point - 1).tolist() == list(range(begin, end + 1) if end > begin else range(begin, end - 1, -1))
    np.testing.assert_allclose(np.diff(slide.time), 18.5 / speed, rtol=0.06)


def test_what_passes_two_points_or_turns_or_is_silent_is_no_slide() -> None:
    there, back = slid(0, 2, 30.0), slid(2, 0, 30.0)
    assert found(slid(0, 1, 20.0)) is None
    assert found(np.concatenate([there, back], axis=1)) is None
    assert found(NOISE * np.random.default_rng(0).standard_normal((2, 2000))) is None
