"""Two touches at once are found among all pairs, and one touch stays one."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.linalg
from rc_line import rc_line
from refusals import refused
from shared import solved

import localize
from acoustic_fem.scatter import UNCALIBRATED, ScatteredDesign, Tolerance, scatter_factors
from geometry import Kind
from localize.decoders import frame_covariance as moments
from localize.decoders.decoder_options import HypothesisOptions, TwoTouchOptions
from localize.decoders.hypotheses import as_built_covariances
from localize.signals.array_response import response_of


@pytest.fixture(scope="module")
def array():
    """Two lines of three points, each between microphones of its own."""
    one = rc_line(3)
    h = np.zeros((6, 4, len(one.frequency)), complex)
    h[:3, :2] = h[3:, 2:] = one.transfer_function
    return localize.ArrayResponse(h, one.frequency, np.repeat([0, 1], 3), np.tile([0, 1, 2], 2), ("a", "b", "c", "d"))


@pytest.fixture(scope="module")
def decoder(array):
    return localize.TwoTouchDecoder(array, 1e-3)


def drawn(array, powers, count, rng):
    """Frames drawn from the model itself: independent Gaussian sources at the given points, and noise of 1 mPa."""
    touched = moments.touch_covariances(array, np.eye(moments.SAMPLES))
    noise = np.kron(np.eye(4), scipy.linalg.toeplitz(moments.frame_noise_covariance(1e-3)))
    factor = np.linalg.cholesky(sum(power * touched[point - 1] for point, power in powers.items()) + noise)
    wanted = (rng.standard_normal((count, len(noise))) @ factor.T).reshape(count, 4, moments.SAMPLES)
    # Any signal with these decimated samples will do.
    return wanted @ np.linalg.pinv(moments.low_pass()).T


@pytest.mark.parametrize("level", [0, 10])
def test_pairs_drawn_from_the_model_are_found_with_their_level(array, decoder, level):
    rng = np.random.default_rng(level)
    for i, j in decoder.pairs:
        found = decoder.locate(drawn(array, {i: 1.0, j: 10 ** (level / 10)}, 12, rng))
        assert found.is_two.all()
        # Any two points of one line can make the signals of its two microphones: only their spectra differ.
        exact = array.line[i - 1] != array.line[j - 1]
        assert (found.pair == (i, j)).all(1).mean() > (0.9 if exact else 0.4)
        assert not exact or abs(np.median(found.level) - level) < 10


def test_single_touches_are_not_called_two(array, decoder):
    touches = localize.TouchGenerator(array, 3, "evaluation", 1e-3).samples(0, 400)
    found = decoder.locate(touches.signals[..., :250])
    assert (found.point == touches.point.numpy()).mean() > 0.99
    assert found.is_two.mean() < 0.01


def test_the_likelihood_of_a_pair_is_that_of_the_summed_covariances(array, decoder):
    frames = drawn(array, {1: 1.0, 5: 0.1}, 3, np.random.default_rng(0))
    touched = moments.touch_covariances(array, np.eye(moments.SAMPLES))
    noise = np.kron(np.eye(4), scipy.linalg.toeplitz(moments.frame_noise_covariance(1e-3)))
    x = (frames @ moments.low_pass().T).reshape(3, -1)
    # The same term is left out for all covariances of a frame.
    of_noise = np.linalg.slogdet(noise)[1]
    constant = 0.5 * of_noise + 0.5 * (x.T * np.linalg.solve(noise, x.T)).sum(0)
    _, pairs = decoder.log_likelihood(frames)
    number = decoder.pairs.tolist().index([1, 5])
    for k, level in enumerate(TwoTouchOptions.level_differences):
        ratio = 10 ** (level / 10)
        shape = (touched[0] + ratio * touched[4]) / (1 + ratio)
        # power * shape + noise is diagonal in the generalised eigenvectors, whatever the power
        values, vectors = scipy.linalg.eigh(shape, noise)
        squares, scores = (x @ vectors) ** 2, []
        for power in 10 ** np.arange(-2.5, 2.5, 0.02):
            gain = 1 + power * values
            scores.append(constant - 0.5 * ((squares / gain).sum(1) + np.log(gain).sum() + of_noise))
        assert pairs[:, number, k] == pytest.approx(np.max(scores, 0), abs=4.0)  # of 1e7: powers 4 dB apart


def test_bad_arguments_are_refused(array, decoder):
    with refused(Kind.OUT_OF_RANGE, "threshold", -1):
        localize.TwoTouchDecoder(array, 1e-3, threshold=-1)
    with refused(Kind.OUT_OF_RANGE, "microphone_noise", 0.0):
        localize.TwoTouchDecoder(array, 0.0)
    with refused(Kind.UNSUITABLE, "library"):
        localize.TwoTouchDecoder(rc_line(65, np.arange(1.0, 101.0)), 1e-3)
    with pytest.raises(ValueError, match="3 channels"):
        decoder.locate(np.random.default_rng(0).standard_normal((1, 3, 250)))


def test_covariances_of_sensors_that_do_not_deviate_are_those_of_the_design():
    library = solved("array-2x6", np.arange(1.0, 161.0))
    none = [Tolerance("bore", 0.0, "relative", "a test")]
    whiten = moments.whitening(1e-3)
    known = moments.touch_covariances(response_of(library), whiten)
    found = as_built_covariances(library, none, whiten, options=HypothesisOptions(air_and_rubber=None))
    assert np.abs(found - known).max() < 1e-5 * np.abs(known).max()  # of interpolation


def test_with_tolerances_single_touches_of_a_made_sensor_are_not_called_two():
    library = solved("array-2x6", np.arange(1.0, 161.0))
    nominal, noise = response_of(library), 1e-3
    factors = scatter_factors(ScatteredDesign(library.design), library.medium, nominal.frequency, 3, seed=4)
    known, tolerant = (localize.TwoTouchDecoder(library, noise, tolerances=each) for each in (None, UNCALIBRATED))
    called, told = [], []
    for factor in factors:
        made = replace(nominal, transfer_function=nominal.transfer_function * factor)
        touches = localize.TouchGenerator(made, 5, "evaluation", 0.0).samples(0, 60).signals[:, :, 250:500].numpy()
        signals = np.concatenate([touches, touches + np.roll(touches, 5, axis=0)])
        signals = signals + noise * np.random.default_rng(6).standard_normal(signals.shape)
        called += [[decoder.locate(signals[:60]).is_two.mean() for decoder in (known, tolerant)]]
        told += [tolerant.locate(signals[60:]).is_two.mean()]
    assert np.mean(called, axis=0)[0] > 0.5
    assert np.mean(called, axis=0)[1] < 0.03
    assert np.mean(told) > 0.5


def test_tolerances_of_bare_transfer_functions_are_refused(array):
    with refused(Kind.UNSUITABLE, "library"):
        localize.TwoTouchDecoder(array, 1e-3, tolerances=UNCALIBRATED)
