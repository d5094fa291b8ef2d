"""Converters whose steps are larger than the noise of the microphone: what they do to it, and the warning."""

from __future__ import annotations

import warnings
from itertools import pairwise

import numpy as np
import pytest
from small_run import small_design

import acoustic_fem
import geometry
from acoustic_fem import network
from localize.embedded import CoarseConverterWarning, Converter, embed
from localize.embedded.converter import LARGEST_STEP, noise_at
from localize.embedded.decimator import FACTOR, decimator_taps
from localize.live.stream_options import StreamOptions
from localize.signals.stimulus import SAMPLE_RATE

RATE = FACTOR * SAMPLE_RATE


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 20), "lumped")


def microphone_noise(microphone, seconds):
    """Noise of a microphone at the converter, (seconds * RATE,) float64, Pa."""
    count = round(seconds * RATE)
    frequency = np.fft.rfftfreq(count, 1 / RATE)
    density = np.zeros(len(frequency))
    inside = frequency >= 1
    density[inside] = network.noise_density(microphone, frequency[inside])
    drawn = np.random.default_rng(1).normal(size=(2, len(frequency)))
    return np.fft.irfft((drawn[0] + 1j * drawn[1]) * density * np.sqrt(count * RATE) / 2, count)


def levels(samples, step):
    """Level of a channel behind the firmware's low-pass over that without steps, for ten levels at rest; (10,)."""

    def sampled(values):
        return np.convolve(values, decimator_taps(), "valid")[::FACTOR].std()

    offsets = np.arange(10) / 10
    return np.array([sampled(step * np.round(samples / step + offset)) for offset in offsets]) / sampled(samples)


def test_the_noise_of_samples_is_right_up_to_the_largest_step_and_may_vanish_above():
    microphone = geometry.prototype("array-2x6").microphone
    samples, noise = microphone_noise(microphone, 4.0), noise_at(microphone)
    assert samples.std() == pytest.approx(noise, rel=0.02)
    allowed = levels(samples, LARGEST_STEP * noise)
    assert 1 / 1.4 < allowed.min() < allowed.max() < 1.4
    assert levels(samples, 12 * noise).min() < StreamOptions.dead_fraction


def options_in(message):
    words = message.split()
    return [(word, float(value.rstrip(","))) for word, value in pairwise(words) if word[:2] == "--"]


@pytest.mark.parametrize(
    ("converter", "named"),
    [
        (Converter(volts=1.0, bits=12), ["--converter-volts", "--converter-bits", "--converter-volts"]),
        (Converter(bits=12), ["--full-scale", "--converter-bits"]),
        (Converter(bits=8, volts=0.2), ["--converter-volts", "--converter-bits"]),
        (Converter(full_scale=100.0), ["--full-scale"]),
    ],
)
def test_a_coarse_converter_is_warned_of_with_options_that_are_fine_enough(library, converter, named):
    with pytest.warns(CoarseConverterWarning) as told:
        embed(library, converter=converter)
    message = str(told[0].message)
    assert f"the microphone's noise is {1e3 * noise_at(small_design().microphone):.3g} mPa rms" in message
    found = options_in(message)
    assert [name for name, _ in found] == named
    assert "times the gain and --" in message
    keys = {"--converter-volts": "volts", "--converter-bits": "bits", "--full-scale": "full_scale"}
    for part in message.split("needs ")[1].split(", or "):
        given = {keys[name]: value for name, value in options_in(part)}
        given["bits"] = int(given.get("bits", converter.bits))
        if converter.volts is not None:
            given.setdefault("volts", converter.volts)
        with warnings.catch_warnings():
            warnings.simplefilter("error", CoarseConverterWarning)
            embed(library, converter=Converter(**given))


def test_a_digital_microphone_gets_no_gain_but_a_sensitivity(library):
    with pytest.warns(CoarseConverterWarning) as told:
        embed(library, converter=Converter(full_scale=200.0), board="zephyr")
    message = str(told[0].message)
    assert "gain" not in message
    assert "--converter" not in message
    ((name, full_scale),) = options_in(message)
    assert name == "--full-scale"
    sensitivity = float(message.split("at least ")[1].split()[0])
    assert 1.41 * 10 ** (-sensitivity / 20) < 1.13 * full_scale  # whole dB, rounded up
    with warnings.catch_warnings():
        warnings.simplefilter("error", CoarseConverterWarning)
        embed(library, converter=Converter(full_scale=full_scale), board="zephyr")
        embed(library, converter=Converter(full_scale=1.41 * 10 ** (-sensitivity / 20)), board="zephyr")


@pytest.mark.parametrize("converter", [Converter(), Converter(volts=0.5), Converter(full_scale=10.0)])
def test_a_converter_that_is_fine_enough_is_not_warned_of(library, converter):
    with warnings.catch_warnings():
        warnings.simplefilter("error", CoarseConverterWarning)
        embed(library, converter=converter)
