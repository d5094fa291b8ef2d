"""The microphone: corner, limits of its load, noise and sensitivity."""

import numpy as np
import pytest
from reference_data import AIR
from refusals import refused

from acoustic_fem.network import microphone
from geometry.design.design_file import prototype, prototype_names
from geometry.ground.refusal import Kind
from geometry.schema.part_fields import Microphone

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


def test_noise_behind_the_vent_is_worth_more_pressure_below_the_corner_and_the_same_above():
    front = microphone.noise_density(MEMS, [0.2, 2000.0])
    behind = microphone.noise_density_behind_vent(MEMS, [0.2, 2000.0], AIR)
    plateau = 2 / 2.05  # back volume over back volume and diaphragm
    assert behind[1] == pytest.approx(front[1] / plateau, rel=0.02, abs=0)
    assert 20 * np.log10(behind[0] / front[0]) == pytest.approx(20 * np.log10(MEMS.vent_corner / 0.2), abs=0.5)


def test_every_figure_of_the_microphone_of_every_prototype_has_a_source():
    for name in prototype_names():
        assert "assumed" in prototype(name).microphone.source


def test_a_frequency_of_zero_is_refused():
    with refused(Kind.OUT_OF_RANGE, "frequency", 0.0):
        microphone.load_admittance(MEMS, [0.0, 1.0], AIR)
