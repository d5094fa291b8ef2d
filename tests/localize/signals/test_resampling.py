"""A stream is resampled to what the whole recording gives, to the last bit, however it is cut up."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import scipy.signal
from hypothesis import given, settings, strategies as st

from localize.signals.resampling import StreamResampler, at_one_kilohertz

RATES = [250.0, 999.0, 1000.0, 1024.0, 4000.0, 8000.0, 11025.0, 16000.0, 22050.0, 44100.0, 44101.3, 48000.0, 96000.0]


def whole(samples: np.ndarray, rate: float) -> np.ndarray:
    ratio = Fraction(1000 / rate).limit_denominator(10_000)
    return scipy.signal.resample_poly(samples, ratio.numerator, ratio.denominator, axis=1, padtype="edge")


def streamed(resampler: StreamResampler, samples: np.ndarray, cuts: list[int]) -> np.ndarray:
    parts = [resampler.push(part) for part in np.split(samples, sorted(cuts), axis=1)]
    return np.concatenate([*parts, resampler.finish()], axis=1)


@settings(max_examples=80, deadline=None)
@given(
    rate=st.sampled_from(RATES),
    seconds=st.floats(0.02, 0.4),
    cuts=st.lists(st.floats(0, 1), max_size=30),
)
def test_a_stream_is_resampled_as_the_whole_recording(rate: float, seconds: float, cuts: list[float]) -> None:
    count = max(1, round(seconds * rate))
    samples = np.random.default_rng(count).standard_normal((2, count)) + 3
    made = streamed(StreamResampler(rate, 2), samples, [round(cut * count) for cut in cuts])
    np.testing.assert_array_equal(made, whole(samples, rate))


@settings(max_examples=20, deadline=None)
@given(rate=st.sampled_from([8000.0, 11025.0, 44100.0, 48000.0]), block=st.integers(1, 1200))
def test_blocks_of_any_size_and_no_memory_that_grows(rate: float, block: int) -> None:
    samples = np.random.default_rng(block).standard_normal((1, 20 * block + 3000))
    resampler = StreamResampler(rate, 1)
    parts = []
    for first in range(0, samples.shape[1], block):
        parts.append(resampler.push(samples[:, first : first + block]))
        # the filter's length, a period of its phases, and what comes at once
        assert resampler._kept.shape[1] <= 2 * 10 * rate / 1000 + 2 * resampler.down + block + 2
    made = np.concatenate([*parts, resampler.finish()], axis=1)
    np.testing.assert_array_equal(made, whole(samples, rate))


@pytest.mark.parametrize("rate", [8000.0, 44100.0, 48000.0])
def test_output_comes_ten_milliseconds_after_its_input(rate: float) -> None:
    resampler = StreamResampler(rate, 1)
    samples = np.random.default_rng(0).standard_normal((1, round(rate)))
    for first in range(0, samples.shape[1], 50):
        resampler.push(samples[:, first : first + 50])
        newest = (min(first + 50, samples.shape[1]) - 1) / rate
        assert resampler.next - 1 == pytest.approx(max(-1, 1000 * newest - 10), abs=1.001)


@pytest.mark.parametrize("rate", RATES)
def test_a_whole_recording_is_resampled_as_by_scipy(rate: float) -> None:
    samples = np.random.default_rng(0).standard_normal((2, 5000))
    np.testing.assert_array_equal(at_one_kilohertz(samples, rate), whole(samples, rate))


def test_a_tone_keeps_its_time_and_size_over_a_gap() -> None:
    time = np.arange(96_000) / 48_000
    tone = np.sin(2 * np.pi * 30 * time)[None]
    resampler = StreamResampler(48_000.0, 1)
    before = resampler.push(tone[:, :30_000])
    resampler.skip(40_011, resampler.next + 1)
    first = resampler.next
    after = np.concatenate([resampler.push(tone[:, 40_011:]), resampler.finish()], axis=1)
    assert first == np.ceil(40_011 / 48)
    assert before.shape[1] == 615  # 10 ms less than 625
    number = np.arange(first, first + after.shape[1])
    # at its ends the tone is continued by a constant
    error = (after[0] - np.sin(2 * np.pi * 30 * number / 1000))[12:-12]
    assert np.abs(error).max() < 3e-3


def test_a_gap_of_a_single_sample_leaves_out_an_output_sample_too() -> None:
    resampler = StreamResampler(48_000.0, 1)
    resampler.push(np.zeros((1, 4800)))
    due = resampler.next
    resampler.skip(4801, due + 1)
    assert resampler.next > due


@pytest.mark.parametrize("rate", [1000.0, 44100.0, 500.0])
def test_samples_at_the_limit_stay_at_it(rate: float) -> None:
    samples = 0.1 * np.random.default_rng(0).standard_normal((2, round(2 * rate)))
    samples[1, round(0.7 * rate)] = -1.0
    made = streamed(StreamResampler(rate, 2, limit=1.0), samples, list(range(0, samples.shape[1], 37)))
    assert np.argwhere(np.abs(made) >= 1).tolist() == [[1, 700]]
    assert made[1, 700] == -1.0
    assert np.abs(np.delete(made - whole(samples, rate), 700, axis=1)).max() == 0
