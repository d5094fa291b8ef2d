"""The microphone: corner, limits of its load, noise and sensitivity."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from reference_data import AIR
from scipy.integrate import quad

from acoustic_fem.network import microphone
from geometry.design.design_file import prototype, prototype_names
from geometry.stated.parts import Microphone

MEMS = Microphone(chamber_diameter=3.0, chamber_height=2.0)
BAND = np.logspace(-2, 3.3, 60)


def test_the_response_is_3_db_down_at_the_corner():
    plateau = abs(microphone.response(MEMS, 2000.0, AIR))
    at_corner = abs(microphone.response(MEMS, MEMS.vent_corner, AIR))
    assert 20 * np.log10(at_corner / plateau) == pytest.approx(-3.01, abs=0.35)


def test_below_the_corner_the_response_falls_20_db_per_decade():
    low = np.abs(microphone.response(MEMS, [0.02, 0.2], AIR))
    assert low[1] / low[0] == pytest.approx(10, rel=1e-3, abs=0)


def test_the_vent_ratio_is_what_the_response_falls_by_and_follows_the_conductance():
    f = np.array([1.0, 20.0, 400.0])
    parts = prototype("array-2x6").microphone
    v = microphone.vent_ratio(parts, f, AIR)
    plateau = microphone.response(parts, f, AIR) * (1 + v) / v
    assert np.abs(plateau / plateau[2] - 1).max() < 0.02  # the back volume passes from isothermal to adiabatic
    assert np.abs(v[1]) == pytest.approx(1, abs=0.02)  # at the corner
    leaky = parts.model_copy(update={"vent_corner": 2 * parts.vent_corner})
    assert np.abs(microphone.vent_ratio(leaky, f, AIR) * 2 / v - 1).max() < 0.06  # Cb is that at its corner


def test_at_low_frequency_the_load_is_the_isothermal_back_volume():
    load = microphone.load_admittance(MEMS, 0.01, AIR)
    assert load == pytest.approx(2j * np.pi * 0.01 * MEMS.back_volume * 1e-9 / AIR.pressure, rel=1e-3, abs=0)


def test_at_high_frequency_the_load_is_the_diaphragm_in_series_with_the_back_volume():
    omega = 2 * np.pi * 2000
    diaphragm, back = (volume / (AIR.gamma * AIR.pressure) for volume in (0.05e-9, 2e-9))
    load = microphone.load_admittance(MEMS, 2000.0, AIR)
    assert load.imag == pytest.approx(omega * diaphragm * back / (diaphragm + back), rel=0.02, abs=0)


def test_the_load_is_passive_at_every_frequency():
    assert np.all(microphone.load_admittance(MEMS, BAND, AIR).real > 0)


def test_noise_is_white_above_its_corner_and_one_over_f_in_power_below():
    noise = microphone.noise_density(MEMS, [1e6, MEMS.noise_corner, 0.1, 0.01])
    assert noise[0] == pytest.approx(MEMS.noise_density, rel=1e-4, abs=0)
    assert noise[1] == pytest.approx(np.sqrt(2) * MEMS.noise_density, rel=1e-12, abs=0)
    assert noise[3] / noise[2] == pytest.approx(np.sqrt(10), rel=1e-3, abs=0)


@given(st.floats(1e-2, 1e3), st.floats(1.01, 1e3), st.floats(0, 1e4))
def test_noise_of_a_band_is_the_integral_of_its_density(low, ratio, corner):
    mems = MEMS.model_copy(update={"noise_corner": corner})
    power = quad(
        lambda x: float(microphone.noise_density(mems, np.exp(x))) ** 2 * np.exp(x), *np.log([low, low * ratio])
    )
    assert microphone.noise_rms(mems, low, low * ratio) == pytest.approx(np.sqrt(power[0]), rel=1e-7, abs=0)


def test_noise_of_the_assumed_microphone_from_1_to_100_hz_is_118_micropascal():
    # 5e-6 sqrt(99 + 100 ln 100)
    assert microphone.noise_rms(MEMS, 1, 100) == pytest.approx(1.1828e-4, rel=1e-4, abs=0)


def test_noise_of_two_bands_adds_in_power():
    parts = microphone.noise_rms(MEMS, 1, 10) ** 2 + microphone.noise_rms(MEMS, 10, 100) ** 2
    assert microphone.noise_rms(MEMS, 1, 100) == pytest.approx(np.sqrt(parts), rel=1e-12, abs=0)


def test_noise_behind_the_vent_is_worth_more_pressure_below_the_corner_and_the_same_above():
    front = microphone.noise_density(MEMS, [0.2, 2000.0])
    behind = microphone.noise_density_behind_vent(MEMS, [0.2, 2000.0], AIR)
    plateau = 2 / 2.05  # back volume over back volume and diaphragm
    assert behind[1] == pytest.approx(front[1] / plateau, rel=0.02, abs=0)
    assert 20 * np.log10(behind[0] / front[0]) == pytest.approx(20 * np.log10(MEMS.vent_corner / 0.2), abs=0.5)


@pytest.mark.parametrize(
    ("low", "high", "message"),
    [(0.0, 1.0, "low = 0 Hz"), (1.0, np.inf, "high = inf Hz"), (2.0, 2.0, "high = 2 Hz must be above low = 2 Hz")],
)
def test_a_band_that_is_none_is_refused(low, high, message):
    with pytest.raises(ValueError, match=message):
        microphone.noise_rms(MEMS, low, high)


def test_every_figure_of_the_microphone_of_every_prototype_has_a_source():
    for name in prototype_names():
        assert "assumed" in prototype(name).microphone.source


def test_sensitivity_of_minus_38_db_is_12_6_millivolt_per_pascal():
    assert microphone.sensitivity(MEMS) == pytest.approx(12.589e-3, rel=1e-4, abs=0)


def test_a_frequency_of_zero_is_refused():
    with pytest.raises(ValueError, match="frequency = 0 Hz must be finite and above 0 Hz"):
        microphone.load_admittance(MEMS, [0.0, 1.0], AIR)
