"""The model-based decoder computes the Gaussian likelihood it promises and names the point without training."""

import numpy as np
import pytest
import scipy.linalg
import scipy.special
import torch
from rc_line import rc_line
from refusals import refused
from threadpoolctl import threadpool_info, threadpool_limits

import acoustic_fem
import geometry
import localize
from geometry import Kind, Refusal
from localize.decoders import likelihood
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import HUM, INTEGRATION_STEP, SOURCE_RMS, frame_noise_covariance, low_pass
from localize.signals import stimulus, threads
from localize.signals.array_response import response_of
from localize.signals.finger_stimuli import taps
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.propagation import microphone_signals


@pytest.fixture(scope="module")
def array():
    return rc_line(8)


@pytest.fixture(scope="module")
def decoder(array):
    return localize.BayesDecoder(array, microphone_noise=1e-2)


def dense_covariances(array, noise):
    """C_i and N with its hum on the decimated samples, by way of the covariance of all 250 samples of a microphone."""
    frequency = np.arange(1, 500.01, INTEGRATION_STEP)
    density = np.where(frequency <= 100, SOURCE_RMS**2 / 99, stimulus.NOISE**2 / 500) * INTEGRATION_STEP
    lag = (np.arange(250)[:, None] - np.arange(250)[None, :]) / 1000
    filtered = np.kron(np.eye(2), low_pass())
    hum = sum(HUM**2 * np.cos(2 * np.pi * line * lag) for line in (50.0, 60.0, 100.0, 120.0))
    noise_part = filtered @ (noise**2 * np.eye(500) + np.kron(np.eye(2), hum)) @ filtered.T
    touched = []
    for h in array.at(frequency):
        full = np.zeros((2, 250, 2, 250))
        for a in range(2):
            for b in range(2):
                cross = density * h[a] * h[b].conj()
                by_lag = (cross @ np.exp(2j * np.pi * frequency[:, None] * np.arange(-249, 250) / 1000)).real
                full[a, :, b, :] = by_lag[np.rint(lag * 1000).astype(int) + 249]
        touched.append(filtered @ full.reshape(500, 500) @ filtered.T)
    return touched, noise_part, filtered


def test_the_log_likelihood_is_that_of_the_dense_gaussian_at_its_best_power(array):
    decoder = localize.BayesDecoder(array, 1e-2 / DecoderOptions.noise_fraction)
    covariances, noise, filtered = dense_covariances(array, 1e-2)
    frames = localize.TouchGenerator(array, 0, "evaluation", 1e-2).samples(0, 3).signals[..., :250].double().numpy()
    x = filtered @ frames.reshape(3, 500).T
    powers = 10 ** np.arange(-2, 2, 0.04)
    dense = np.empty((3, 3, len(powers)))
    for point in range(3):
        for k, power in enumerate(powers):
            covariance = power * covariances[point] + noise
            energy = (x * np.linalg.solve(covariance, x)).sum(0)
            dense[:, point, k] = -0.5 * (energy + np.linalg.slogdet(covariance)[1])
    fast = DecoderOptions().temperature * decoder.log_likelihood(frames)[:, :3]
    best = dense.argmax(-1)
    # A far point may fit best at a power beyond these: points and their neighbours are compared.
    compared = (best > 0) & (best < len(powers) - 1) & (abs(np.subtract.outer(range(3), range(3))) <= 1)
    assert compared.diagonal().all()
    assert compared.sum() >= 6
    expected, found = (v - v.diagonal()[:, None] for v in (dense.max(-1), fast))
    assert np.abs(found - expected)[compared].max() < 0.5
    assert np.abs(expected[compared]).max() > 100


def test_filtered_noise_has_the_covariance_that_is_assumed():
    filtered = low_pass()
    expected = 0.3**2 * filtered @ filtered.T
    assert scipy.linalg.toeplitz(frame_noise_covariance(0.3)) == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("noise", [0.0, 1e-3])
def test_every_point_is_named_from_one_frame_of_multi_sines(noise):
    array = rc_line(12)
    result = localize.evaluate(localize.BayesDecoder(array, 1e-3), array, touches_per_point=30, microphone_noise=noise)
    assert result.top1 > 0.99
    assert result.hardest_pair is None or result.hardest_pair[2] < 0.1


def test_taps_are_named_although_nothing_was_trained_on_them(array):
    # A smooth pulse of 30 ms in a quiet period of 4 s, through the exact response.
    time = np.arange(stimulus.PERIOD) / stimulus.SAMPLE_RATE
    pulse = np.exp(-0.5 * ((time - 0.1) / 0.012) ** 2)
    spectrum = np.fft.rfft(pulse, norm="forward")[: stimulus.LINE_COUNT]
    frequency = stimulus.line_frequencies()
    h = np.zeros((8, 2, len(frequency)), complex)
    band = stimulus.lines_within((1.0, 499.75))
    h[..., band] = array.at(frequency[band])
    signals = microphone_signals(torch.from_numpy(np.tile(spectrum, (8, 1))), torch.from_numpy(h), 250)
    signals = signals + 1e-3 * torch.from_numpy(np.random.default_rng(0).standard_normal(signals.shape))
    named = localize.BayesDecoder(array, 1e-3).locate(signals).argmax(1)
    assert named.tolist() == list(range(8))


def test_exchanging_the_microphones_of_a_symmetric_line_mirrors_the_answer(array, decoder):
    signals = localize.TouchGenerator(array, 1, "evaluation", 0.05).samples(0, 16).signals[..., :250].numpy()
    assert decoder.locate(signals[:, ::-1]) == pytest.approx(decoder.locate(signals)[:, ::-1], abs=1e-6)


def test_more_noise_makes_the_answer_less_certain_never_undefined(array):
    decoder = localize.BayesDecoder(array, microphone_noise=0.1)
    results = [localize.evaluate(decoder, array, 30, microphone_noise=rms) for rms in (0.0, 0.1, 1.0)]
    assert results[0].top1 > results[1].top1 > results[2].top1
    noise = np.random.default_rng(0).standard_normal((2, 250))
    for level in (1e-12, 1.0, 1e6):
        probability = decoder.locate(level * noise)
        assert np.isfinite(probability).all()
        assert probability.sum() == pytest.approx(1)


def test_a_batch_gives_what_its_signals_give_alone(array, decoder):
    signals = localize.TouchGenerator(array, 2, "evaluation", 0.05).samples(0, 100).signals[..., :300].numpy()
    batch = decoder.locate(signals)
    assert batch.shape == (100, 8)
    assert decoder.locate(signals[77]) == pytest.approx(batch[77], abs=1e-9)


@pytest.mark.parametrize("noise", [0.0, -1e-3, 11.0, float("nan")])
def test_a_noise_floor_outside_its_range_is_refused(array, noise):
    with refused(Kind.OUT_OF_RANGE, "microphone_noise"):
        localize.BayesDecoder(array, microphone_noise=noise)


def test_bad_signals_and_libraries_are_refused(decoder):
    with pytest.raises(ValueError, match="249 samples, must have at least 250"):
        decoder.locate(np.ones((2, 249)))
    with pytest.raises(ValueError, match="channel left is silent"):
        decoder.locate(np.stack([np.zeros(250), np.sin(np.arange(250))]))
    with pytest.raises(ValueError, match="must cover 1 to 100 Hz"):
        localize.BayesDecoder(rc_line(3, np.linspace(5, 100, 50)), 1e-3)


def test_coloured_noise_has_the_covariance_that_is_assumed():
    power = np.zeros(500)
    power[1:] = 1e-6 / np.arange(1.0, 500.0) ** 2
    noise = stimulus.coloured_noise(0, "evaluation", 0, 4000, 1, power)[:, 0, -250:].double().numpy()
    filtered = noise @ low_pass().T
    found = filtered.T @ filtered / len(filtered)
    expected = scipy.linalg.toeplitz(frame_noise_covariance(NoiseSpectrum(power, "a test")))
    assert np.abs(found - expected).max() < 0.06 * expected[0, 0]
    white = NoiseSpectrum(np.full(500, 1e-6 / 500), "a test")
    assert frame_noise_covariance(white) == pytest.approx(frame_noise_covariance(1e-3), abs=0.01 * 1e-6)


def test_decoding_and_evaluation_run_on_one_thread_and_leave_the_setting_alone(array, decoder, monkeypatch):
    seen = []
    original = likelihood.vertex

    def spied(values):
        seen.append({torch.get_num_threads(), *(lib["num_threads"] for lib in blas_of_this_process())})
        return original(values)

    monkeypatch.setattr(likelihood, "vertex", spied)
    threads._libraries.cache_clear()  # other tests may have loaded more libraries since it was made
    before = torch.get_num_threads()
    torch.set_num_threads(2)
    try:
        with threadpool_limits(2, user_api="blas"):
            decoder.locate(np.random.default_rng(0).standard_normal((2, 250)))
            localize.evaluate(decoder, array, 1, 0.0)
            assert {lib["num_threads"] for lib in blas_of_this_process()} == {2}
            assert torch.get_num_threads() == 2
    finally:
        torch.set_num_threads(before)
    assert len(seen) >= 2
    assert all(threads == {1} for threads in seen)


def blas_of_this_process():
    return [lib for lib in threadpool_info() if lib["user_api"] == "blas"]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["line-2", "line-3", "line-4"])
def test_the_published_lines_of_36_points_are_decoded_with_and_without_noise_and_on_taps(name):
    library = acoustic_fem.solve(geometry.prototype(name), np.arange(1.0, 501.0), "lumped")
    array, decoder = response_of(library), localize.BayesDecoder(library, 1e-3)
    touches = 60 if name == "line-2" else 15
    assert localize.evaluate(decoder, array, touches, 0.0).top1 >= 0.995
    assert localize.evaluate(decoder, array, touches, 1e-3).top1 >= 0.98
    made = localize.TouchGenerator(array, 0, "evaluation", 1e-3, stimuli=taps).samples(0, 8 * array.point_count)
    assert (decoder.locate(made.signals).argmax(1) == made.point.numpy() - 1).mean() >= 0.95


@pytest.fixture(scope="module")
def in_a_room():
    return response_of(acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(1.0, 201.0), "lumped"))


@pytest.mark.parametrize("level", [None, 60.0, 80.0])
def test_sound_of_a_room_is_told_from_touches_and_costs_nothing_in_quiet(in_a_room, level):
    sound = {} if level is None else {"ambient": (level, level)}
    made = localize.TouchGenerator(in_a_room, 0, "evaluation", 1e-3, **sound).samples(0, 240)
    point, frames = made.point.numpy() - 1, made.signals[..., -250:]
    alone, heard = (
        localize.BayesDecoder(in_a_room, 1e-3, ambient).locate(frames) for ambient in (None, (None, 60.0, 80.0))
    )
    right = (heard.argmax(1) == point).mean()
    assert right > (0.99 if level is None else 0.9)
    assert abs(heard.max(1).mean() - right) < 0.05
    assert (alone.argmax(1) == point).mean() < 0.6 or level != 80.0


def test_single_precision_leaves_no_trace_in_the_probabilities(in_a_room):
    decoder = localize.BayesDecoder(in_a_room, 1e-3)
    (tables,) = decoder.tables
    frames = localize.TouchGenerator(in_a_room, 1, "evaluation", 1e-3).samples(0, 60).signals[..., -250:].double()
    for scale in (1e-3, 1.0, 1e3):
        x = scale * frames.numpy().reshape(60, -1) @ tables.reduce
        exact = likelihood.vertex(
            -0.5 * ((x @ tables.vectors) ** 2 @ tables.weight + tables.log_determinant[:, None, :])
        )
        assert np.abs(decoder.locate(scale * frames) - scipy.special.softmax(exact.T, 1)).max() < 1e-7


@pytest.mark.parametrize(("ambient", "kind"), [(200.0, Kind.OUT_OF_RANGE), ((), Kind.MISSING)])
def test_sound_out_of_range_is_refused(in_a_room, ambient, kind):
    with refused(kind, "ambient"):
        localize.BayesDecoder(in_a_room, 1e-3, ambient)


def test_sound_needs_a_design(array):
    with refused(Kind.UNSUITABLE, "ambient", 60.0):
        localize.BayesDecoder(array, 1e-3, 60.0)
    with pytest.raises(Refusal):
        localize.BayesDecoder(array)  # the noise of a design
