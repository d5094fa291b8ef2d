"""Microphone signals are the exact steady state of the array, whatever the length of its response."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import refused
from scipy.signal import lfilter

import acoustic_fem
import geometry
import localize
from acoustic_fem.network import noise_density_behind_vent
from acoustic_fem.numerics.frequency_splines import from_zero, interpolated_from_zero, interpolation_from_zero
from geometry import Kind
from localize import ArrayResponse, TouchGenerator
from localize.signals import stimulus
from localize.signals.array_response import response_of
from localize.signals.noise_model import microphone_noise
from localize.signals.propagation import microphone_signals


def response(transfer_function, frequency) -> ArrayResponse:
    h = np.asarray(transfer_function, complex)
    return ArrayResponse(
        transfer_function=h,
        frequency=np.asarray(frequency, float),
        line=np.zeros(len(h), np.int64),
        place=np.arange(len(h)),
        microphones=tuple(f"m{k}" for k in range(h.shape[1])),
    )


@pytest.mark.parametrize("memory", [0.5, 0.99, 0.998], ids=["short", "100 ms", "500 ms"])
def test_signals_are_those_of_a_time_domain_recursion_in_its_steady_state(memory):
    # y[n] = (1 - a) x[n] + a y[n-1] has a closed transfer function; 0.998 forgets within half a second, which is
    # longer than any short window and than the frame itself.
    frequency = stimulus.line_frequencies()
    z = np.exp(2j * np.pi * frequency / stimulus.SAMPLE_RATE)
    h = (1 - memory) / (1 - memory / z)
    spectrum = stimulus.multi_sines(0, "training", 0, 3, (0.25, 499.75)).spectrum.to(torch.complex128)
    signals = microphone_signals(spectrum, torch.from_numpy(h).expand(3, 1, -1)).numpy()[:, 0]

    x = stimulus.time_signal(spectrum, stimulus.PERIOD).numpy()
    y = lfilter([1 - memory], [1, -memory], np.tile(x, 6), axis=1)
    assert np.abs(signals - y[:, -stimulus.PERIOD :][:, :1000]).max() < 1e-9


def test_a_pure_delay_delays_and_a_gain_scales():
    frequency = np.arange(1.0, 500.01, 0.25)
    delay = np.exp(-2j * np.pi * frequency * 0.003)
    generator = TouchGenerator(response([[np.ones_like(delay), 0.5 * delay]] * 2, frequency), 0, "training", 0.0)
    near, far = generator.samples(0, 8).signals.unbind(1)
    assert torch.allclose(far[:, 3:], 0.5 * near[:, :-3], atol=2e-6)
    assert near.std() > 0.05


def test_interpolation_is_exact_on_the_grid_and_good_to_1e_5_between_64_frequencies():
    coarse = rc_line(12, np.linspace(1, 100, 64))
    assert np.abs(coarse.at(coarse.frequency) - coarse.transfer_function).max() < 1e-14
    fine = np.arange(1.0, 100.01, 0.25)
    assert np.abs(coarse.at(fine) - rc_line(12, fine).transfer_function).max() < 1e-5


@pytest.mark.parametrize("sealed", [True, False])
def test_a_spline_through_values_is_the_one_of_the_matrices(sealed):
    grid, lines = np.linspace(0.7, 120.0, 40), np.linspace(0.0, 120.0, 333)
    values = rc_line(3, grid).transfer_function
    even, odd = interpolation_from_zero(grid, lines, sealed)
    known = from_zero(values, sealed)
    expected = known.real @ even.T + 1j * (known.imag @ odd.T)
    assert np.abs(interpolated_from_zero(values, grid, lines, sealed) - expected).max() < 1e-12


def test_touches_go_round_the_points_and_can_be_made_again_alone():
    generator = TouchGenerator(rc_line(5), 3, "training", microphone_noise=1e-3)
    whole = generator.samples(0, 23)
    assert whole.point.tolist() == [i % 5 + 1 for i in range(23)]
    again = TouchGenerator(rc_line(5), 3, "training", microphone_noise=1e-3).samples(11, 4)
    assert torch.allclose(again.signals, whole.signals[11:15], atol=1e-7)
    shards = torch.cat([part.signals for part in generator.stream(0, 23, shard=4)])
    assert torch.allclose(shards, whole.signals, atol=1e-7)


def test_held_out_touches_are_not_those_of_training():
    training, held_out = (
        TouchGenerator(rc_line(2), 0, purpose, 0.0).samples(0, 50).signals[:, 0] for purpose in ("training", "held-out")
    )
    normed = [s / s.norm(dim=1, keepdim=True) for s in (training, held_out)]
    assert (normed[0] @ normed[1].T).abs().max() < 0.999


def test_microphone_noise_is_added_to_every_microphone_independently():
    quiet, noisy = (TouchGenerator(rc_line(3), 0, "training", rms).samples(0, 60).signals for rms in (0.0, 1e-2))
    noise = (noisy - quiet).numpy()
    assert noise.std((0, 2)) == pytest.approx([1e-2, 1e-2], rel=0.03)
    assert abs(np.corrcoef(noise[:, 0].ravel(), noise[:, 1].ravel())[0, 1]) < 0.02


def test_nothing_is_made_up_beyond_the_range_of_the_library():
    signals = TouchGenerator(rc_line(3, np.linspace(1, 100, 100)), 0, "training", 0.0).samples(0, 20).signals.numpy()
    spectrum = np.abs(np.fft.rfft(signals * np.blackman(1000), axis=-1)) ** 2
    assert spectrum[..., 110:].sum() < 1e-8 * spectrum.sum()


@pytest.mark.parametrize(("first", "last"), [(2, 500), (1, 99), (10, 50)])
def test_a_library_that_does_not_cover_the_band_is_refused_with_its_range(first, last):
    with refused(Kind.OUT_OF_RANGE, "frequency"):
        rc_line(3, np.linspace(first, last, 60))


def test_values_that_are_not_finite_are_refused_by_point_microphone_and_frequency():
    good = rc_line(3)
    h = good.transfer_function.copy()
    h[1, 0, 9] = np.nan
    with refused(Kind.UNSUITABLE, "transfer_function") as found:
        replace(good, transfer_function=h)
    assert "point 2 at microphone left is not finite at 10 Hz" in str(found.value)


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        (lambda r: {"transfer_function": r.transfer_function[..., :-1]}, Kind.WRONG_TYPE),
        (
            lambda r: {"transfer_function": r.transfer_function[:1], "line": r.line[:1], "place": r.place[:1]},
            Kind.UNSUITABLE,
        ),
        (lambda r: {"line": r.line[:2]}, Kind.MISMATCH),
        (lambda r: {"frequency": r.frequency[::-1]}, Kind.OUT_OF_RANGE),
    ],
)
def test_arrays_that_do_not_fit_together_are_refused(change, kind):
    good = rc_line(3)
    with refused(kind):
        replace(good, **change(good))


def test_a_solved_library_gives_its_numbers_names_and_provenance():
    design = geometry.prototype("array-2x6")
    library = acoustic_fem.solve(design, np.linspace(1, 100, 30), fidelity="lumped")
    taken = response_of(library)
    assert np.array_equal(taken.transfer_function, library.transfer_function.values)
    assert taken.microphones == design.microphones
    assert taken.name == "array-2x6"
    assert taken.provenance["fidelity"] == "lumped"
    assert 'name = "array-2x6"' in taken.provenance["design"]


# -- noise of the design's microphone -------------------------------------------------------------------------------
def design_response(noise_density: float = 5e-6) -> ArrayResponse:
    design = geometry.prototype("array-2x6").with_values({"microphone.noise_density": noise_density})
    return response_of(acoustic_fem.solve(design, np.arange(1.0, 101.0), fidelity="lumped"))


def test_noise_as_a_pressure_in_the_chamber_is_that_of_the_microphone_over_its_response():
    microphone = geometry.prototype("array-2x6").microphone
    medium = acoustic_fem.Medium.at(20.0)
    # Far above vent (20 Hz) and 1/f corner (100 Hz) n (Cb + Cd) / Cb, nearly n; far below n sqrt(100 / f) 20 / f.
    density = noise_density_behind_vent(microphone, [1e4, 0.1], medium)
    assert density[0] == pytest.approx(5e-6, rel=0.05)
    assert density[1] == pytest.approx(5e-6 * np.sqrt(1000) * 200, rel=0.05)


def test_the_signals_carry_the_noise_of_the_design_with_its_spectrum():
    response = design_response()
    quiet, noisy = (TouchGenerator(response, 0, "training", n).samples(0, 600).signals for n in (0.0, "design"))
    noise = (noisy - quiet).double().numpy()
    assert noise.std((0, 2)) == pytest.approx([response.own_noise.rms] * 2, rel=0.1)
    assert abs(np.corrcoef(noise[:, 0].ravel(), noise[:, 1].ravel())[0, 1]) < 0.05
    # One second: lines of the transform are 1 Hz apart, and a mean square is twice that of one side.
    power = 2 * (np.abs(np.fft.rfft(noise, norm="forward")) ** 2).mean((0, 1))
    microphone, medium = geometry.prototype("array-2x6").microphone, acoustic_fem.Medium.at(20.0)
    for f in (2, 5, 20, 100, 400):
        inside = noise_density_behind_vent(microphone, np.linspace(f - 0.5, f + 0.5, 401), medium)
        assert power[f] == pytest.approx((inside**2).mean(), rel=0.15)
    assert power[0] < 1e-3 * power[1]


def test_rms_is_the_integral_of_the_density_from_1_to_500_hz():
    microphone, medium = geometry.prototype("array-2x6").microphone, acoustic_fem.Medium.at(20.0)
    f = np.geomspace(1, 500, 20001)
    expected = np.sqrt(np.trapezoid(noise_density_behind_vent(microphone, f, medium) ** 2, f))
    assert microphone_noise(microphone, medium).rms == pytest.approx(expected, rel=0.005)


def test_the_library_s_floor_has_the_same_noise_of_the_output():
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), np.geomspace(1, 500, 401), fidelity="lumped")
    floor = acoustic_fem.library.noise_density(library, noise_at="output")["own"].sel(microphone="A")
    rms = np.sqrt(np.trapezoid(floor.values**2, library.frequency))
    assert response_of(library).own_noise.rms == pytest.approx(rms, rel=1e-3)


def test_a_worse_microphone_lowers_the_accuracy():
    top1 = []
    for noise_density in (5e-6, 300 * 5e-6):
        response = design_response(noise_density)
        decoder = localize.BayesDecoder(response, microphone_noise="design")
        top1.append(localize.evaluate(decoder, response, 50, microphone_noise="design").top1)
    assert top1[0] > 0.98
    assert top1[1] < top1[0] - 0.03


def test_arrays_without_a_design_have_no_microphone():
    with refused(Kind.MISMATCH, "microphone_noise", "design"):
        TouchGenerator(rc_line(3), 0, "training", "design")
