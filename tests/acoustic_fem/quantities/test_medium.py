"""Air: against published values, ideal-gas identities, bad input."""

import dataclasses
import math

import numpy as np
import pytest
from reference_data import AIR
from refusals import refused

import geometry
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.quantities.medium import GAS_CONSTANT, MOLAR_MASS_AIR, Medium, saturation_pressure
from geometry.ground.refusal import Kind


def test_reference_air_has_the_derived_values_of_the_reference_data():
    assert AIR.sound_speed == pytest.approx(343.2488418652865, rel=1e-14, abs=0)
    assert AIR.kinematic_viscosity == pytest.approx(1.51578073089701e-05, rel=1e-14, abs=0)
    assert AIR.thermal_diffusivity == pytest.approx(2.135855960582023e-05, rel=1e-14, abs=0)


def test_dry_air_at_20_degrees_agrees_with_published_values():
    # Lemmon, Jacobsen, Penoncello and Friend, J. Phys. Chem. Ref. Data 29 (2000) 331 and Lemmon and
    # Jacobsen (2004): 293.15 K, 101325 Pa
    air = Medium.at(20, humidity=0)
    assert air.density == pytest.approx(1.2045, rel=1e-3, abs=0)
    assert air.viscosity == pytest.approx(18.21e-6, rel=2e-3, abs=0)
    assert air.conductivity == pytest.approx(25.87e-3, rel=2e-3, abs=0)
    assert air.heat_capacity == pytest.approx(1006.1, rel=1e-3, abs=0)
    assert air.sound_speed == pytest.approx(343.4, rel=2e-3, abs=0)


#: Table F.1 of IEC 61094-2:2009: density, speed of sound, gamma, viscosity and thermal diffusivity of two states, SI.
_IEC = {
    (23.0, 0.5, 101325.0): (1.1860848, 345.86652, 1.4007573, 1.826566e-5, 2.115317e-5),
    (20.0, 0.65, 80000.0): (0.9441589, 344.38267, 1.4000266, 1.811295e-5, 2.627024e-5),
}


@pytest.mark.parametrize("state", _IEC)
def test_air_agrees_with_the_calibration_standard_as_far_as_its_documentation_says(state):
    air = Medium.at(*state)
    density, sound_speed, gamma, viscosity, thermal_diffusivity = _IEC[state]
    assert air.density == pytest.approx(density, rel=5e-4, abs=0)
    assert air.sound_speed == pytest.approx(sound_speed, rel=8e-4, abs=0)
    assert air.gamma == pytest.approx(gamma, rel=2.1e-3, abs=0)
    assert air.viscosity == pytest.approx(viscosity, rel=7e-3, abs=0)
    # Lemmon and Jacobsen (2004) give a larger conductivity than the fit in the annex of the standard
    assert 1.019 < air.thermal_diffusivity / thermal_diffusivity < 1.021


def test_the_air_of_the_calibration_standard_changes_an_array_by_less_than_a_tenth_of_a_decibel():
    state = (23.0, 0.5, 101325.0)
    density, _, gamma, viscosity, thermal_diffusivity = _IEC[state]
    capacity = gamma / (gamma - 1) * state[2] / (density * (state[0] + 273.15))
    standard = Medium(density, viscosity, thermal_diffusivity * density * capacity, capacity, gamma, state[2])
    design, frequency = geometry.prototype("array-2x6"), np.arange(1.0, 101.0)
    parameters, topology = ArrayParameters.from_design(design), Topology.of(design)
    own, other = (
        batch_transfer_function(parameters, topology, frequency, air)[0] for air in (Medium.at(*state), standard)
    )
    # 0.063 dB and 0.22 degrees
    assert np.abs(20 * np.log10(np.abs(other / own))).max() == pytest.approx(0.063, abs=2e-3)
    assert np.abs(np.degrees(np.angle(other / own))).max() == pytest.approx(0.22, abs=0.01)


@pytest.mark.parametrize(("celsius", "pascal"), [(0.01, 611.66), (20, 2339.3), (37, 6282), (60, 19946)])
def test_saturation_pressure_agrees_with_the_steam_tables(celsius, pascal):
    assert saturation_pressure(celsius + 273.15) == pytest.approx(pascal, rel=1e-3, abs=0)


def test_humid_air_is_lighter_and_carries_sound_faster():
    # O. Cramer, J. Acoust. Soc. Am. 93 (1993) 2510: 0.23 % faster at 20 degC and 50 %
    dry, humid = Medium.at(20, 0), Medium.at(20, 0.5)
    assert humid.density < dry.density
    assert humid.sound_speed / dry.sound_speed - 1 == pytest.approx(0.0020, abs=5e-4)
    assert humid.viscosity / dry.viscosity - 1 == pytest.approx(-0.005, abs=3e-3)


def test_dry_air_is_an_ideal_gas_consistent_in_density_and_gamma():
    air = Medium.at(35, 0, 9e4)
    gas_constant = GAS_CONSTANT / MOLAR_MASS_AIR
    assert air.density * gas_constant * (35 + 273.15) == pytest.approx(9e4, rel=1e-12, abs=0)
    assert air.heat_capacity * (1 - 1 / air.gamma) == pytest.approx(gas_constant, rel=1e-12, abs=0)


@pytest.mark.parametrize(
    ("field", "value"), [("temperature_c", -21), ("temperature_c", math.nan), ("humidity", 1.01), ("pressure", 1013.25)]
)
def test_a_state_outside_the_range_is_refused_by_name(field, value):
    with refused(Kind.OUT_OF_RANGE, field):
        Medium.at(**{field: value})


@pytest.mark.parametrize(
    ("field", "value"), [("density", 0), ("viscosity", -1e-5), ("conductivity", math.inf), ("gamma", 0.9)]
)
def test_an_impossible_gas_is_refused_by_name(field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        dataclasses.replace(AIR, **{field: value})
