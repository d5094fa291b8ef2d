"""One test of clipping for all recordings: flat tops at any level, and no false alarm on what only looks flat."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray
from refusals import refused

from acoustic_fem.calibration.recording_checks import RecordingFault, check_signals
from acoustic_fem.sound.clipping import FLAT, first_clipped
from acoustic_fem.sound.sound_file import write_wav
from geometry.ground.refusal import Kind
from localize import RecordingError, read_recording

Signal = NDArray[np.float64]

LIMIT = 1 - 2.0**-15
FORMATS = {
    "16 bit": lambda signal: np.clip(np.rint(signal * 2**15), -(2**15), 2**15 - 1) / 2**15,
    "24 bit": lambda signal: np.rint(signal * 2**23) / 2**23,
    "single": lambda signal: signal.astype(np.float32).astype(np.float64),
    "double": lambda signal: signal,
    "six digits": lambda signal: np.array([float(f"{value:.6g}") for value in signal]),
}
formats = st.sampled_from(sorted(FORMATS))
rates = st.sampled_from([1000, 8000, 48_000])


def sine(rate: int, frequency: float, phase: float, periods: float = 3.0) -> Signal:
    count = min(max(round(periods * rate / frequency), 300), 100_000)
    return np.sin(2 * np.pi * frequency * np.arange(count) / rate + phase)


@settings(max_examples=200)
@given(rates, st.floats(1, 100), st.floats(0, 6.3), st.floats(1e-4, 1.0), formats)
def test_a_sine_of_any_level_and_format_is_not_clipped(rate, frequency, phase, level, kind) -> None:
    """Slow ones stay on their highest step for hundreds of samples."""
    assert first_clipped(FORMATS[kind](level * sine(rate, frequency, phase))) is None


@given(rates, st.floats(1, 100), st.floats(0, 6.3))
def test_a_sine_that_fills_the_format_but_for_a_step_is_not_clipped(rate, frequency, phase) -> None:
    filled = FORMATS["16 bit"]((LIMIT - 2.0**-15) * sine(rate, frequency, phase))
    assert first_clipped(filled, LIMIT) is None


@settings(max_examples=200)
@given(st.integers(0, 2**32), st.integers(1, 400), st.floats(1e-4, 0.2), formats)
def test_noise_of_any_width_is_not_clipped(seed, smooth, level, kind) -> None:
    white = np.random.default_rng(seed).standard_normal(20_000 + smooth)
    noise = np.convolve(white, np.hanning(smooth + 2), "same")
    assert first_clipped(FORMATS[kind](level * noise / noise.std()), LIMIT) is None


@pytest.mark.parametrize("limit", [None, LIMIT])
def test_silence_and_a_pause_in_a_signal_of_one_sign_are_not_clipped(limit) -> None:
    assert first_clipped(np.zeros(1000), limit) is None
    assert first_clipped(np.full(1000, 0.3), limit) is None
    pulse = -np.hanning(200)
    assert first_clipped(np.concatenate([np.zeros(500), 0.5 * pulse, np.zeros(500)]), limit) is None


@settings(max_examples=200)
@given(rates, st.floats(1, 100), st.floats(0, 6.3), st.floats(0.01, 1.0), st.floats(0.1, 0.95), formats, st.booleans())
def test_a_sine_cut_flat_at_any_level_is_found_where_it_is_cut(rate, frequency, phase, level, cut, kind, below) -> None:
    whole = level * sine(rate, frequency, phase)
    flat = np.clip(whole, -cut * level, np.inf) if below else np.clip(whole, -np.inf, cut * level)
    clipped = FORMATS[kind](flat)
    at_cut = clipped == (clipped.min() if below else clipped.max())
    edges = np.flatnonzero(np.diff(np.concatenate([[False], at_cut, [False]]))).reshape(-1, 2)
    tops = [begin for begin, end in edges.tolist() if end - begin >= FLAT]
    found = first_clipped(clipped)
    # a top that the record cuts through is passed over; of three periods it is not the only one
    assert found in tops[:2] if tops else found is None


def test_the_sine_of_the_issue_is_refused_by_calibration_and_localization_alike(tmp_path: Path) -> None:
    """Cut flat at 0.3 of full scale in a file that states its full scale; localization once took it."""
    time = np.arange(20_000) / 1000
    whole = np.stack([np.sin(2 * np.pi * 7 * time), np.cos(2 * np.pi * 9 * time)])
    write_wav(tmp_path / "cut.wav", np.clip(whole, -0.3, 0.3), 1000)
    write_wav(tmp_path / "whole.wav", 0.3 * whole, 1000)
    with pytest.raises(RecordingError, match=r"channel left is clipped at 0\.3 Pa, first at 0\.0"):
        read_recording(tmp_path / "cut.wav", ("left", "right"))
    assert read_recording(tmp_path / "whole.wav", ("left", "right")).seconds == 20
    limits = {"left": LIMIT, "right": LIMIT}
    cut, fine = (
        dict(zip(limits, FORMATS["16 bit"](signals), strict=True)) for signals in (whole.clip(-0.3, 0.3), 0.3 * whole)
    )
    check_signals(fine, 1000.0, limits, 100.0)
    with refused(Kind.UNSUITABLE, "channels.left", error=RecordingFault):
        check_signals(cut, 1000.0, limits, 100.0)


def test_a_sample_at_the_limit_of_its_format_is_clipped_whatever_its_neighbours() -> None:
    signal = 0.5 * sine(1000, 20.0, 0.0)
    signal[123] = -1.0
    assert first_clipped(signal) is None
    assert first_clipped(signal, LIMIT) == 123
