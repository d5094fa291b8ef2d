"""The baseline that the decoder is compared with is a fair one."""

from __future__ import annotations

import pytest
from rc_line import rc_line

import localize
from benchmarks.ratio_baseline import RatioBaseline

FRAME = 250


def test_the_baseline_names_points_of_steady_signals_only_a_little_worse_than_the_decoder():
    array = rc_line(8)
    touches = localize.TouchGenerator(array, 0, "evaluation", 1e-3).samples(0, 160)
    frames, point = touches.signals[..., -FRAME:].double().numpy(), touches.point.numpy() - 1
    baseline = (RatioBaseline(array, 1e-3).locate(frames) == point).mean()
    decoder = (localize.BayesDecoder(array, 1e-3).locate(frames).argmax(1) == point).mean()
    assert 0.93 < baseline <= decoder


def test_the_baseline_does_not_care_how_loud_the_touch_is():
    array = rc_line(8)
    frames = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 20).signals[..., :FRAME].double().numpy()
    quiet, loud = (RatioBaseline(array, 1e-9).log_likelihood(scale * frames) for scale in (1, 100))
    between = [score - score[:, :1] for score in (quiet, loud)]
    assert between[1] == pytest.approx(between[0], abs=1e-4)
