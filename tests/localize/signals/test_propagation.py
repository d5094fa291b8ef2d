"""Touches reach the microphones by an exact linear convolution; the short-window route does not."""

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import refused
from scipy.signal import lfilter

import acoustic_fem
import geometry
from geometry import Kind
from localize import TouchGenerator
from localize.signals import finger_stimuli, propagation, stimulus
from localize.signals.array_response import response_of


def transient(rows: int) -> torch.Tensor:
    """Smooth pulses that begin and end within a second, (rows, 1000) float64, with nothing left above 400 Hz."""
    time = np.arange(stimulus.SAMPLE_LENGTH)
    draw = np.random.default_rng(0)
    centre, width = draw.uniform(100, 900, (rows, 6, 1)), draw.uniform(3, 10, (rows, 6, 1))
    return torch.from_numpy((draw.normal(size=(rows, 6, 1)) * np.exp(-0.5 * ((time - centre) / width) ** 2)).sum(1))


def lines_of(pressure: torch.Tensor) -> torch.Tensor:
    return torch.fft.rfft(pressure, n=stimulus.PERIOD, norm="forward")[:, : stimulus.LINE_COUNT]


@pytest.mark.parametrize("array", ["array-2x6", "line-2"])
def test_a_transient_is_convolved_with_the_impulse_response_of_the_array(array):
    response = response_of(acoustic_fem.solve(geometry.prototype(array), np.arange(1.0, 501.0), fidelity="lumped"))
    h = torch.from_numpy(response.at(stimulus.line_frequencies()))[[0, 5, response.point_count - 1]]
    pressure = transient(3)
    made = propagation.microphone_signals(lines_of(pressure), h).numpy()

    taps = propagation.impulse_response(h).numpy()
    assert np.isrealobj(taps)
    both_sides = np.concatenate([taps[..., -1000:], taps[..., :1000]], -1)
    for k in range(3):
        for m in range(2):
            direct = np.convolve(pressure[k].numpy(), both_sides[k, m])[1000:2000]
            assert np.abs(made[k, m] - direct).max() < 1e-9 * np.abs(direct).max()


@pytest.mark.parametrize("memory", [0.5, 0.99, 0.998], ids=["short", "100 ms", "500 ms"])
def test_a_transient_is_that_of_a_time_domain_recursion_that_starts_at_rest(memory):
    # y[n] = (1 - a) x[n] + a y[n-1], whose transfer function is known at every frequency.
    z = np.exp(2j * np.pi * stimulus.line_frequencies() / stimulus.SAMPLE_RATE)
    h = torch.from_numpy((1 - memory) / (1 - memory / z)).expand(3, 1, -1)
    pressure = transient(3)
    made = propagation.microphone_signals(lines_of(pressure), h)[:, 0].numpy()
    # 0.998 ** 3000 is 0.25 %: what is left after the period's silence meets the next pulse, here as there.
    repeated = np.tile(np.concatenate([pressure.numpy(), np.zeros((3, 3000))], 1), 8)
    direct = lfilter([1 - memory], [1, -memory], repeated, axis=1)[:, -4000:-3000]
    assert np.abs(made - direct).max() < 1e-9


def test_the_response_of_a_short_array_has_died_within_a_second_and_one_that_has_not_is_told():
    response = response_of(
        acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(1.0, 501.0), fidelity="lumped")
    )
    fade = finger_stimuli.top_faded((1.0, 500.0))
    h = torch.from_numpy(response.at(stimulus.line_frequencies())) * fade
    assert propagation.late_energy(h) < 1e-6
    z = torch.exp(2j * np.pi * torch.from_numpy(stimulus.line_frequencies()) / stimulus.SAMPLE_RATE)
    slow = fade * (1 - 0.999) / (1 - 0.999 / z)
    assert propagation.late_energy(slow) == pytest.approx(np.exp(-2 * 1000 * 1e-3), rel=0.1)


def test_the_generator_makes_the_convolution_of_the_tap():
    response = rc_line(4)
    made = TouchGenerator(response, 0, "evaluation", 0.0, stimuli=finger_stimuli.taps).samples(0, 4).signals.double()
    spectrum = finger_stimuli.taps(0, "evaluation", 0, 4, (1.0, 500.0), "cpu").spectrum.to(torch.complex128)
    h = torch.from_numpy(response.at(np.minimum(stimulus.line_frequencies(), 500.0)))
    assert torch.allclose(made, propagation.microphone_signals(spectrum, h), atol=1e-5)


def test_short_windows_are_exact_for_a_gain_and_far_off_for_an_array():
    spectrum = stimulus.multi_sines(0, "evaluation", 0, 36, (1.0, 499.75)).spectrum
    gain = torch.full((36, 2, stimulus.LINE_COUNT), 0.5, dtype=torch.complex64)
    through = propagation.short_window_signals(spectrum, gain)
    expected = 0.5 * stimulus.time_signal(spectrum)[:, None]
    assert (through - expected).std() < 0.01 * expected.std()

    exact, short = (
        TouchGenerator(rc_line(36), 0, "evaluation", 0.0, method=method).samples(0, 360).signals[..., 100:-100]
        for method in ("exact", "stft")
    )
    ratio = 10 * torch.log10(exact.square().sum((1, 2)) / (exact - short).square().sum((1, 2)))
    assert ratio.median() < 10


def test_an_unknown_method_is_refused():
    with refused(Kind.OUT_OF_RANGE, "method", "wavelet"):
        TouchGenerator(rc_line(3), 0, "training", 0.0, method="wavelet")


@pytest.mark.parametrize("choice", [{}, {"stimuli": finger_stimuli.taps}, {"stimuli": finger_stimuli.friction}])
def test_every_tensor_follows_the_device(choice):
    # The device without data refuses tensors of any other: no accelerator is needed to see that all of them move.
    made = TouchGenerator(rc_line(3), 0, "training", 1e-3, device="meta", **choice).samples(0, 6)
    assert made.signals.device.type == made.point.device.type == made.interval.device.type == "meta"
    assert made.signals.shape == (6, 2, 1000)
