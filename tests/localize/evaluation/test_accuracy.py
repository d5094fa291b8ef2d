"""Evaluations count what they say."""

from __future__ import annotations

import json

import numpy as np
import pytest
import scipy.stats
from rc_line import rc_line

import localize
from localize.evaluation.accuracy import wilson_interval


class Guesser:
    """Names the touched point with a stated probability, and is right as often as it is told."""

    def __init__(self, array, right, stated):
        self.microphones, self.point_count = array.microphones, array.point_count
        self.right, self.stated = right, stated
        self.generator = np.random.default_rng(0)
        self.next = 0

    def locate(self, signals):
        point = (self.next + np.arange(len(signals))) % self.point_count
        self.next += len(signals)
        wrong = self.generator.random(len(signals)) >= self.right
        named = (point + wrong) % self.point_count
        probability = np.full((len(signals), self.point_count), (1 - self.stated) / (self.point_count - 1))
        probability[np.arange(len(signals)), named] = self.stated
        return probability


@pytest.mark.parametrize(("right", "stated"), [(0.8, 0.8), (0.5, 0.97), (0.95, 0.62), (1.0, 1.0)])
def test_the_calibration_error_is_the_distance_of_stated_and_true_shares(right, stated):
    array = rc_line(5)
    found = localize.evaluate(Guesser(array, right, stated), array, 400, 0.0)
    assert found.top1 == pytest.approx(right, abs=0.03)
    assert found.reliability.expected_error == pytest.approx(abs(found.top1 - stated))
    filled = [each for each in found.reliability.bins if each.touches]
    assert len(filled) == 1
    assert (filled[0].touches, filled[0].stated, filled[0].right) == (2000, pytest.approx(stated), found.top1)
    assert filled[0].low <= stated <= filled[0].high
    assert json.loads(json.dumps(found.to_dict()))["expected_calibration_error"] == found.reliability.expected_error


@pytest.mark.parametrize(("right", "touches"), [(0, 10), (1, 1), (15, 20), (300, 600), (2400, 2400)])
def test_intervals_are_those_of_wilson(right, touches):
    expected = scipy.stats.binomtest(right, touches).proportion_ci(method="wilson")
    found = wilson_interval(right / touches, touches)
    assert found == pytest.approx((expected.low, expected.high), abs=1e-12)
    assert found[0] <= right / touches <= found[1]
