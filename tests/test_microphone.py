"""The microphone: corner, limits of its load, noise and sensitivity."""

import numpy as np
import pytest
from reference_data import AIR

from acoustic_fem import microphone
from geometry.design import Microphone

MEMS = Microphone(chamber_diameter=3.0, chamber_height=2.0)
BAND = np.logspace(-2, 3.3, 60)


def test_the_response_is_3_db_down_at_the_corner():
    plateau = abs(microphone.response(MEMS, 2000.0, AIR))
    at_corner = abs(microphone.response(MEMS, MEMS.vent_corner, AIR))
    assert 20 * np.log10(at_corner / plateau) == pytest.approx(-3.01, abs=0.35)


def test_below_the_corner_the_response_falls_20_db_per_decade():
    low = np.abs(microphone.response(MEMS, [0.02, 0.2], AIR))
    assert low[1] / low[0] == pytest.approx(10, rel=1e-3)


def test_at_low_frequency_the_load_is_the_isothermal_back_volume():
    load = microphone.load_admittance(MEMS, 0.01, AIR)
    assert load == pytest.approx(2j * np.pi * 0.01 * MEMS.back_volume * 1e-9 / AIR.pressure, rel=1e-3)


def test_at_high_frequency_the_load_is_the_diaphragm_in_series_with_the_back_volume():
    omega = 2 * np.pi * 2000
    diaphragm, back = (volume / (AIR.gamma * AIR.pressure) for volume in (0.05e-9, 2e-9))
    load = microphone.load_admittance(MEMS, 2000.0, AIR)
    assert load.imag == pytest.approx(omega * diaphragm * back / (diaphragm + back), rel=0.02)


def test_the_load_is_passive_at_every_frequency():
    assert np.all(microphone.load_admittance(MEMS, BAND, AIR).real > 0)


def test_noise_is_white_above_its_corner_and_one_over_f_in_power_below():
    noise = microphone.noise_density(MEMS, [1e6, MEMS.noise_corner, 0.1, 0.01])
    assert noise[0] == pytest.approx(MEMS.noise_density, rel=1e-4)
    assert noise[1] == pytest.approx(np.sqrt(2) * MEMS.noise_density, rel=1e-12)
    assert noise[3] / noise[2] == pytest.approx(np.sqrt(10), rel=1e-3)


def test_sensitivity_of_minus_38_db_is_12_6_millivolt_per_pascal():
    assert microphone.sensitivity(MEMS) == pytest.approx(12.589e-3, rel=1e-4)


def test_a_frequency_of_zero_is_refused():
    with pytest.raises(ValueError, match="frequency = 0 Hz must be finite and above 0 Hz"):
        microphone.load_admittance(MEMS, [0.0, 1.0], AIR)
