"""The filter over frames is the exact posterior of a moving touch."""

from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given, strategies as st
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind

LINE, PLACE = [0, 0, 0, 1], [0, 1, 2, 0]


def by_enumeration(model, score):
    """Posterior of every frame from all paths, given the frames up to each and given all."""
    frames, points = score.shape
    causal, full = np.zeros(score.shape), np.zeros(score.shape)
    for last in range(frames):
        for path in product(range(points), repeat=last + 1):
            weight = np.exp(sum(score[k, p] for k, p in enumerate(path))) / points
            weight *= np.prod([model.transition[a, b] for a, b in pairwise(path)])
            causal[last, path[-1]] += weight
            if last == frames - 1:
                full[range(frames), path] += weight
    return causal / causal.sum(1, keepdims=True), full / full.sum(1, keepdims=True)


@given(seed=st.integers(0, 1000), stay=st.floats(0.05, 0.9), jump=st.floats(0.001, 0.1))
def test_forward_and_forward_backward_are_those_of_all_paths(seed, stay, jump):
    model = localize.TouchFilter(LINE, PLACE, stay, jump)
    score = 3 * np.random.default_rng(seed).standard_normal((5, 4))
    causal, full = by_enumeration(model, score)
    assert model.forward(score) == pytest.approx(causal, rel=1e-9, abs=1e-12)
    assert model.forward_backward(score) == pytest.approx(full, rel=1e-9, abs=1e-12)


def test_a_stream_gives_the_forward_result_and_can_be_started_again():
    model = localize.TouchFilter(LINE, PLACE)
    score = np.random.default_rng(0).standard_normal((6, 4))
    for _ in range(2):
        assert np.array([model.update(frame) for frame in score]) == pytest.approx(model.forward(score), rel=1e-12)
        model.reset()


def test_transitions_are_probabilities_and_go_to_neighbours_on_the_line_only():
    model = localize.TouchFilter(LINE, PLACE, stay=0.7, jump=0.04)
    assert model.transition.sum(1) == pytest.approx(1)
    assert model.transition[0] == pytest.approx([0.71, 0.27, 0.01, 0.01])
    assert model.transition[3] == pytest.approx([0.01, 0.01, 0.01, 0.97])  # alone on its line


def test_scores_far_below_the_smallest_number_do_no_harm():
    model = localize.TouchFilter(LINE, PLACE)
    score = np.array([[0.0, -1e6, -1e6, -1e6], [-1e6, -1e6, -1e6, 0.0]])
    assert model.forward_backward(score)[[0, 1], [0, 3]] == pytest.approx(1)


def test_a_sliding_touch_is_followed_where_single_frames_fail():
    array = rc_line(8)
    decoder = localize.BayesDecoder(array, 0.2)
    path = np.repeat(np.arange(8), 4)
    streams = localize.TouchGenerator(array, 4, "evaluation", 0.2)
    alone, filtered, smoothed = [], [], []
    for run in range(6):
        made = streams.samples(run * 256, 256)
        frames = np.stack([made.signals[8 * k + p, :, :250].double().numpy() for k, p in enumerate(path)])
        score = decoder.log_likelihood(frames)
        model = localize.TouchFilter(decoder.line, decoder.place)
        alone.append(score.argmax(1) == path)
        filtered.append(model.forward(score).argmax(1) == path)
        smoothed.append(model.forward_backward(score).argmax(1) == path)
    shares = [np.mean(right) for right in (alone, filtered, smoothed)]
    assert shares[0] < 0.95
    assert shares[1] > shares[0]
    assert shares[2] > shares[1]


def test_bad_arguments_are_refused():
    with refused(Kind.OUT_OF_RANGE, "stay", 0.99):
        localize.TouchFilter(LINE, PLACE, stay=0.99, jump=0.02)
    with refused(Kind.WRONG_TYPE, "place"):
        localize.TouchFilter(LINE, PLACE[:3])
    model = localize.TouchFilter(LINE, PLACE)
    with refused(Kind.WRONG_TYPE, "log_likelihood"):
        model.update(np.zeros(3))
    with refused(Kind.UNSUITABLE, "log_likelihood"):
        model.forward(np.full((2, 4), np.nan))
