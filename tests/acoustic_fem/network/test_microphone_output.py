"""Outputs of microphones and the pressures in front of them, against the exact response of the circuit."""

import numpy as np
import pytest
from refusals import refused

import geometry
from acoustic_fem.network import Equaliser, output_response, response
from acoustic_fem.quantities.local_air import design_air
from geometry import Kind

DESIGN = geometry.prototype("array-2x6")
MICROPHONE, AIR = DESIGN.microphone, design_air(DESIGN)
FREQUENCY = np.array([1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 125.0])


def with_corner(corner):
    return MICROPHONE.model_copy(update={"vent_corner": corner})


def high_pass(frequency, corner):
    """Butterworth of second order."""
    s = 1j * frequency / corner
    return s**2 / (s**2 + np.sqrt(2) * s + 1)


def test_an_output_is_the_pressure_at_1_khz_and_falls_below_the_corner_of_the_vent():
    at = output_response(MICROPHONE, np.array([0.5, 1.0, 20.0, 1000.0]), AIR)
    assert np.abs(at[3]) == pytest.approx(1.0, rel=1e-12)
    assert np.abs(at[2]) == pytest.approx(np.abs(response(MICROPHONE, 20.0, AIR) / response(MICROPHONE, 1e3, AIR)))
    assert np.abs(at[0] / at[1]) == pytest.approx(0.5, rel=2e-3)  # 6 dB per octave
    assert 20 * np.log10(np.abs(at[1])) == pytest.approx(-25.8, abs=0.1)


@pytest.mark.parametrize("corner", [1.0, 5.0, 20.0])
@pytest.mark.parametrize("lowest", [0.2, 1.0, 3.0])
def test_the_equaliser_is_the_inverse_of_the_response_behind_a_high_pass(corner, lowest):
    microphone = with_corner(corner)
    equaliser = Equaliser(microphone, AIR, 1000.0, lowest)
    exact = high_pass(FREQUENCY, lowest) / output_response(microphone, FREQUENCY, AIR)
    error = np.abs(equaliser.gain(FREQUENCY) / exact - 1)
    assert error[FREQUENCY <= 20].max() < 1.2e-3
    assert error.max() < 9e-3


def test_the_error_falls_with_the_square_of_the_sample_rate():
    def error(rate):
        exact = high_pass(100.0, 1.0) / output_response(MICROPHONE, 100.0, AIR)
        return abs(Equaliser(MICROPHONE, AIR, rate).gain(np.array([100.0]))[0] / exact - 1)

    assert error(1000.0) / error(2000.0) == pytest.approx(4.0, rel=0.2)


def test_chunks_are_equalised_as_the_whole_and_give_the_pressure_back():
    random, count = np.random.default_rng(3), 20_000
    grid = np.fft.rfftfreq(count, 1e-3)
    spectrum = np.fft.rfft(random.standard_normal((2, count)))
    spectrum[:, (grid < 5) | (grid > 100)] = 0
    pressure = np.fft.irfft(spectrum, count)
    output = np.fft.irfft(spectrum * output_response(MICROPHONE, np.maximum(grid, 1e-3), AIR), count)
    equaliser = Equaliser(MICROPHONE, AIR, 1000.0, 0.5)
    whole = equaliser.begin(output)
    parts = [equaliser.begin(output[:, :777]), *(equaliser(part) for part in np.split(output[:, 777:], [1, 5000], 1))]
    np.testing.assert_allclose(np.concatenate(parts, axis=1), whole, atol=1e-12)
    settled = slice(8000, 20_000)
    passed = np.fft.irfft(spectrum * high_pass(grid + 1e-9, 0.5), count)
    assert np.std(whole[:, settled] - passed[:, settled]) < 0.006 * np.std(pressure)
    assert np.std(output) < 0.95 * np.std(pressure)


def test_equalising_down_to_1_hz_costs_five_times_the_noise_and_less_above():
    down_to = {lowest: Equaliser(MICROPHONE, AIR, 1000.0, lowest).noise(125.0) for lowest in (0.5, 1.0, 3.0)}
    before, behind = down_to[1.0]
    assert before == pytest.approx(5e-6 * np.sqrt(124 + 100 * np.log(125)), rel=1e-3)
    assert behind / before == pytest.approx(5.1, abs=0.1)
    ratio = [behind / before for before, behind in down_to.values()]
    assert ratio == sorted(ratio, reverse=True)


def test_a_lowest_frequency_out_of_range_is_refused():
    with refused(Kind.OUT_OF_RANGE, "lowest", 0.01):
        Equaliser(MICROPHONE, AIR, 1000.0, 0.01)
