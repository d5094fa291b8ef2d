"""Stimuli are those of the paper, and every sample can be made again alone."""

import numpy as np
import pytest
import torch
from scipy import stats

from localize.signals import stimulus

ABOVE_THE_SINES = (499.0, 499.5)
FULL = (0.25, 499.75)


def sines(count: int, seed: int = 0, start: int = 0) -> stimulus.Stimuli:
    """Stimuli whose noise lies where no sinusoid can be."""
    return stimulus.multi_sines(seed, "training", start, count, ABOVE_THE_SINES)


@pytest.mark.parametrize(("start", "count"), [(0, 1), (7, 3), (41, 2), (49, 1)])
def test_a_sample_made_alone_is_the_one_made_in_a_batch(start, count):
    whole = stimulus.multi_sines(5, "training", 0, 50, FULL)
    part = stimulus.multi_sines(5, "training", start, count, FULL)
    assert torch.equal(part.spectrum, whole.spectrum[start : start + count])
    assert torch.equal(part.components, whole.components[start : start + count])
    noise = stimulus.white_noise(5, "training", 0, 50, 3, 1.0)
    assert torch.equal(stimulus.white_noise(5, "training", start, count, 3, 1.0), noise[start : start + count])


def test_no_two_samples_seeds_or_purposes_share_random_words():
    drawn = [
        stimulus.random_words(seed, purpose, kind, 0, 100, 30)
        for seed in (0, 1)
        for purpose in ("training", "held-out", "evaluation")
        for kind in ("stimulus", "microphone")
    ]
    words = np.concatenate([d.ravel() for d in drawn])
    assert len(np.unique(words)) == len(words)


def test_the_number_of_sinusoids_comes_from_seven_intervals_equally_often():
    drawn = sines(7000)
    low, high = np.array(stimulus.COMPONENT_INTERVALS)[drawn.interval].T
    components = drawn.components.numpy()
    assert np.all((components >= low) & (components < high))
    assert stats.chisquare(np.bincount(drawn.interval, minlength=7)).pvalue > 1e-3
    first = components[drawn.interval == 0]
    assert stats.chisquare(np.bincount(first, minlength=4)[1:]).pvalue > 1e-3


def test_sinusoids_lie_between_1_and_100_hz_all_lines_alike():
    spectrum = sines(4000).spectrum
    frequency = stimulus.line_frequencies()
    count = (spectrum[:, : int(450 / stimulus.LINE_SPACING)] != 0).sum(0).numpy()
    used = np.flatnonzero(count)
    assert frequency[used[0]] == 1.0
    assert frequency[used[-1]] == 100.0
    assert len(used) == 397
    assert count[used].std() < 1.3 * np.sqrt(count[used].mean())


def test_a_single_sinusoid_has_an_amplitude_between_0_02_and_0_1():
    drawn = sines(3000)
    alone = drawn.spectrum[drawn.components == 1][:, :401]
    amplitude = 2 * alone.abs().amax(1).numpy()
    assert stats.kstest(amplitude, stats.uniform(0.02, 0.08).cdf).pvalue > 1e-3
    phase = alone.gather(1, alone.abs().argmax(1)[:, None])[:, 0].angle().numpy()
    assert stats.kstest(phase, stats.uniform(-np.pi, 2 * np.pi).cdf).pvalue > 1e-3


def test_sums_above_1_pa_are_scaled_to_a_peak_of_1_pa_and_weaker_ones_are_not():
    drawn = sines(1000)
    peak = stimulus.time_signal(drawn.spectrum[:, :401]).abs().amax(1)
    assert peak.max() < 1 + 1e-5
    strong = drawn.components > 80
    assert (peak[strong] > 1 - 1e-5).double().mean() > 0.8
    assert (peak[drawn.components < 4] < 0.4).all()


def test_the_noise_has_0_005_pa_over_500_hz_and_stays_in_its_band():
    quiet = stimulus.multi_sines(0, "training", 0, 400, (200.0, 300.0)).spectrum
    frequency = stimulus.line_frequencies()
    inside = (frequency >= 200) & (frequency <= 300)
    assert (quiet[:, ~inside & (frequency > 100)] == 0).all()
    power = 2 * (quiet[:, inside].abs() ** 2).sum(1).mean()
    assert power == pytest.approx(0.005**2 * 100 / 500, rel=0.02)


def test_the_sinusoids_of_a_sample_do_not_depend_on_the_noise_band():
    narrow = stimulus.multi_sines(0, "training", 0, 20, (200.0, 300.0)).spectrum
    wide = stimulus.multi_sines(0, "training", 0, 20, (150.0, 499.0)).spectrum
    assert torch.equal(narrow[:, :401], wide[:, :401])


def test_the_time_signal_is_the_sum_of_its_lines():
    generator = np.random.default_rng(0)
    spectrum = np.zeros(500, complex)
    spectrum[1:] = generator.normal(size=499) + 1j * generator.normal(size=499)
    time = np.arange(300) / stimulus.SAMPLE_RATE
    direct = 2 * np.real(spectrum @ np.exp(2j * np.pi * stimulus.line_frequencies()[:500, None] * time))
    signal = stimulus.time_signal(torch.from_numpy(spectrum), 300).numpy()
    assert np.abs(signal - direct).max() < 1e-11 * np.abs(direct).max()


def test_microphone_noise_is_white_gaussian_and_of_the_level_asked_for():
    noise = stimulus.white_noise(3, "training", 0, 100, 2, 1e-3).numpy()
    assert noise.shape == (100, 2, 1000)
    assert noise.std() == pytest.approx(1e-3, rel=0.01)
    assert stats.kstest(noise.ravel() / 1e-3, stats.norm.cdf).pvalue > 1e-3
    assert abs(np.mean(noise[..., 1:] * noise[..., :-1])) < 1e-8
    assert abs(np.mean(noise[:, 0] * noise[:, 1])) < 1e-8


def test_a_touch_that_is_too_weak_for_its_peak_can_be_made_alone():
    made = stimulus.multi_sines(0, "training", 0, 64, FULL)
    weak = int(made.components.argmin())
    alone = stimulus.multi_sines(0, "training", weak, 1, FULL).spectrum[0]
    assert torch.allclose(alone, made.spectrum[weak], atol=1e-7)
