"""What is done with samples first: slow rests are taken away, hum and noise are found without being told."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refused

from geometry import Kind
from localize.live.events import HOP
from localize.live.front_end import HighPass, Hum, NoiseFloor
from localize.live.stream_options import StreamOptions
from localize.signals.stimulus import SAMPLE_RATE


def test_the_high_pass_takes_a_step_away_and_starts_from_what_there_is() -> None:
    step = np.full((2, 2000), 5.0)
    step[:, 1000:] = 7.0
    high_pass = HighPass(2, 3.0)
    passed = np.concatenate([high_pass.begin(step[:, :250]), high_pass(step[:, 250:])], axis=1)
    assert np.abs(passed[:, :1000]).max() < 1e-9
    assert passed[:, 1000:1005].min() > 1.7
    assert np.abs(passed[:, 1500:]).max() < 0.02


def test_the_delay_of_the_high_pass_is_that_of_a_slowly_swelling_tone() -> None:
    time = np.arange(4000) / SAMPLE_RATE
    swell = np.exp(-(((time - 2.0) / 0.3) ** 2))
    high_pass = HighPass(1, 3.0)
    passed = high_pass.begin((swell * np.cos(2 * np.pi * 20.0 * time))[None])[0]
    centre = (passed**2 @ time) / (passed**2).sum()
    assert centre - 2.0 == pytest.approx(high_pass.delay, abs=2e-4)
    assert HighPass(1, None).delay == 0.0


def heard_of(signals: np.ndarray, until: int) -> tuple[Hum, np.ndarray]:
    """Hum that is learned up to a sample, and what is left of the signals."""
    hum, left = Hum(len(signals), StreamOptions()), np.empty_like(signals)
    for first in range(0, signals.shape[1] - HOP + 1, HOP):
        here = slice(first, first + HOP)
        left[:, here] = signals[:, here] - hum.coming(HOP)
        if first < until:
            hum.learn(left[:, here])
    return hum, left


@pytest.mark.parametrize("mains", [49.95, 50.05, 60.03])
def test_hum_is_learned_with_its_frequency_and_goes_on_while_something_else_is_heard(mains) -> None:
    time = np.arange(12_000) / SAMPLE_RATE
    random = np.random.default_rng(0)
    wave = np.sin(2 * np.pi * mains * time + 1.0) + np.sin(6 * np.pi * mains * time) / 3
    signals = 2.8e-3 * wave * np.array([[1.0], [0.5]]) + 5e-4 * random.standard_normal((2, 12_000))
    hum, left = heard_of(signals, until=9000)
    assert hum.rms == pytest.approx(2.8e-3 * np.sqrt(0.5 * 10 / 9) * np.array([1.0, 0.5]), rel=0.15)
    assert left[:, 6000:9000].std() < 8e-4
    assert left[:, 9000:].std() < 1.3e-3  # three seconds of a touch, in which nothing is learned


def test_what_lies_on_the_lines_of_mains_alone_is_taken_out_of_a_frame() -> None:
    time = np.arange(250) / SAMPLE_RATE
    hum = np.sin(2 * np.pi * 50 * time) + np.cos(2 * np.pi * 180 * time)
    tap = np.exp(-(((time - 0.1) / 0.01) ** 2))
    beside = Hum(2, StreamOptions())
    assert np.abs(beside.beside(np.stack([hum, 2 * hum]))).max() < 1e-9
    assert beside.beside(np.stack([tap, tap])).std() > 0.8 * tap.std()


def test_the_noise_is_found_beside_touches_and_followed() -> None:
    random = np.random.default_rng(1)
    signals = 3e-3 * random.standard_normal((2, 12_000))
    signals[:, 6000:] *= np.array([[1.0], [4.0]])
    signals[:, 2000:2500] += np.sin(2 * np.pi * 20 * np.arange(500) / SAMPLE_RATE)
    floor, told = NoiseFloor(2, StreamOptions()), []
    for end in range(250, signals.shape[1], HOP):
        floor.take(signals[:, end - 250 : end])
        told.append(floor.rms.copy())
    at = {end: told[(end - 250) // HOP] for end in (250, 2506, 5994, 11_994)}
    assert at[250] == pytest.approx([3e-3, 3e-3], rel=0.25)
    assert at[2506] == pytest.approx([3e-3, 3e-3], rel=0.1)
    assert at[5994] == pytest.approx([3e-3, 3e-3], rel=0.1)
    assert at[11_994] == pytest.approx([3e-3, 12e-3], rel=0.1)


@pytest.mark.parametrize("corner", [0.4, 21.0, float("nan")])
def test_a_corner_out_of_range_is_refused(corner) -> None:
    with refused(Kind.OUT_OF_RANGE, "high_pass"):
        StreamOptions(high_pass=corner)


def test_what_all_microphones_hear_is_no_noise() -> None:
    random = np.random.default_rng(2)
    sound = 0.1 * random.standard_normal(4002)
    signals = np.stack([sound[2:], 0.8 * sound[1:-1]]) + 2e-3 * random.standard_normal((2, 4000))
    floor = NoiseFloor(2, StreamOptions())
    for end in range(250, 4000, HOP):
        floor.take(signals[:, end - 250 : end])
    assert (floor.rms < 0.02).all()
