"""Probabilities are as sure as they are right, and what no point explains is called so."""

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.signals.finger_stimuli import taps


@pytest.fixture(scope="module")
def array():
    return rc_line(12)


@pytest.fixture(scope="module")
def decoder(array):
    return localize.BayesDecoder(array, 1e-3)


@pytest.fixture(scope="module")
def residuals(array):
    return localize.ResidualTest(array, 1e-3)


def frames_of(array, noise, count=2400, stimuli=None, seed=0):
    kind = {} if stimuli is None else {"stimuli": stimuli}
    made = localize.TouchGenerator(array, seed, "evaluation", noise, **kind).samples(0, count)
    return made.signals, made.point.numpy() - 1


@pytest.mark.slow
@pytest.mark.parametrize("noise", [0.03, 0.1, 0.2])
def test_probabilities_agree_with_how_often_the_decoder_is_right(array, noise):
    signals, point = frames_of(array, noise)
    probability = localize.BayesDecoder(array, noise).locate(signals[..., :250])
    sure, right = probability.max(1), probability.argmax(1) == point
    edges = np.quantile(sure, np.linspace(0, 1, 11))
    group = np.clip(np.searchsorted(edges, sure, "right") - 1, 0, 9)
    gap = [abs(sure[group == k].mean() - right[group == k].mean()) for k in np.unique(group)]
    assert np.average(gap, weights=np.bincount(group)[np.unique(group)]) < 0.05


@pytest.mark.parametrize(("samples", "stimuli"), [(250, None), (1000, None), (1000, taps)])
def test_true_touches_are_refused_as_rarely_as_stated(array, decoder, residuals, samples, stimuli):
    signals, _ = frames_of(array, 1e-3, 1200, stimuli)
    for rate in (0.1, 0.01):
        rejected = ~localize.judge(decoder, residuals, signals[..., :samples], false_alarm=rate).explained
        assert rejected.mean() < 1.5 * rate + 0.012


def test_noise_alone_has_uniform_p_values(array, residuals):
    noise = 1e-3 * np.random.default_rng(0).standard_normal((4000, 2, 250))
    p_value = residuals.p_value(noise, np.arange(4000) % 12 + 1)
    assert np.mean(p_value) == pytest.approx(0.5, abs=0.02)
    assert np.mean(p_value < 0.05) == pytest.approx(0.05, abs=0.012)


def test_what_no_point_explains_is_refused(array, decoder, residuals):
    one, two = (frames_of(array, 7e-4, 240, seed=seed)[0][..., :250] for seed in (0, 1))
    both = one + two.roll(5, 0)
    assert localize.judge(decoder, residuals, both).explained.mean() < 0.05
    elsewhere = frames_of(rc_line(12, spread=1.3), 1e-3, 240)[0][..., :250]
    assert localize.judge(decoder, residuals, elsewhere).explained.mean() < 0.5
    independent = 0.1 * np.random.default_rng(0).standard_normal((100, 2, 250))
    assert not localize.judge(decoder, residuals, independent).explained.any()


def test_points_probabilities_and_margins_belong_together(array, residuals):
    decoder = localize.BayesDecoder(array, 0.1)
    signals, _ = frames_of(array, 0.1, 24)
    judged = localize.judge(decoder, residuals, signals[..., :250], top=12)
    probability = decoder.locate(signals[..., :250])
    assert np.take_along_axis(probability, judged.points - 1, 1) == pytest.approx(judged.probability, abs=1e-9)
    assert (np.diff(judged.probability, axis=1) <= 0).all()
    assert (judged.margin >= 0).all()
    assert np.isfinite(judged.margin).all()
    unsure = judged.probability[:, 1] > 1e-100
    assert unsure.any()
    ratio = np.log(judged.probability[unsure, 0] / judged.probability[unsure, 1])
    assert judged.margin[unsure] == pytest.approx(ratio, rel=1e-6)


def test_bad_arguments_are_refused(array, decoder, residuals):
    signals = np.random.default_rng(0).standard_normal((2, 2, 250))
    with refused(Kind.OUT_OF_RANGE, "top", 13):
        localize.judge(decoder, residuals, signals, top=13)
    with refused(Kind.OUT_OF_RANGE, "false_alarm", 0):
        localize.judge(decoder, residuals, signals, false_alarm=0)
    with refused(Kind.OUT_OF_RANGE, "point", [0, 12]):
        residuals.p_value(signals, [0, 12])
    with refused(Kind.OUT_OF_RANGE, "loudest_touch_pa", 0):
        localize.ResidualTest(array, 1e-3, loudest_touch_pa=0)
    with refused(Kind.CONFLICT, "loudest_touch_pa", 1e3):
        localize.ResidualTest(array, 1e-9, loudest_touch_pa=1e3)
