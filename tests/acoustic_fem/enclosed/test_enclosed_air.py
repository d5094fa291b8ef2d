"""Enclosed air: limits in closed form, the law of its gas, permeation, vents, bad input."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
from acoustic_fem import LocalAir
from acoustic_fem.enclosed import SealedSensor, design_vent, enclosed_air, suggested_vent
from acoustic_fem.membrane import bulge, design_bulge_ratio, design_disc, design_membrane
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import GAS_CONSTANT, saturation_pressure
from geometry import Kind, prototype

ARRAY = prototype("array-2x6")
OUTSIDE, KELVIN = 101325.0, 293.15
#: A wall of the design is 2 mm, and so is the vent.
VENTED = ARRAY.with_values(
    {
        "resonator.leak_length": 2.0,
        "point_kinds": {"vented": {"leak_diameter": 0.05}, "tight": {}},
        "lines.0.pattern": {"points": ["vented", *["tight"] * 11]},
    }
)


def linear_fraction() -> float:
    """Part of a change of pressure that flat membranes leave: V / (V + p C)."""
    sensor = SealedSensor.of(ARRAY)
    return sensor.volume / (sensor.volume + OUTSIDE * sensor.compliance)


# -- equilibrium ----------------------------------------------------------------------------------------------
def test_small_changes_follow_the_closed_form_of_flat_membranes() -> None:
    warmer = enclosed_air(ARRAY, LocalAir(temperature_c=20.05)).overpressure
    assert warmer == pytest.approx(OUTSIDE * 0.05 / KELVIN * linear_fraction(), rel=2e-3)
    lower = enclosed_air(ARRAY, LocalAir(pressure=OUTSIDE - 20)).overpressure
    assert lower == pytest.approx(20 * linear_fraction(), rel=2e-3)


@pytest.mark.parametrize("air", [LocalAir(temperature_c=32.0), LocalAir(altitude=1000.0)], ids=["worn", "climb"])
def test_pressure_times_volume_is_that_of_the_gas_in_the_bulged_sensor(air: LocalAir) -> None:
    found = enclosed_air(ARRAY, air)
    there = ARRAY.with_values(air.design_values).air
    swept = 12 * float(bulge(design_membrane(ARRAY), found.overpressure).volume)
    assert found.bulge == pytest.approx(swept, rel=1e-9)
    inside = (there.pressure + found.overpressure) * (found.volume + swept)
    before = OUTSIDE * found.volume * (there.temperature + 273.15) / KELVIN
    assert inside == pytest.approx(before, rel=1e-9)


def test_a_worn_and_a_carried_sensor_have_the_pressures_of_the_audit_while_their_membranes_are_flat() -> None:
    """The audit took flat membranes: 1.5 kPa at 12 K, 4.1 kPa at 1000 m; bulged ones let the pressure rise further."""
    warmer = OUTSIDE * 12 / KELVIN * linear_fraction()
    higher = (OUTSIDE - ARRAY.with_values(LocalAir(altitude=1000.0).design_values).air.pressure) * linear_fraction()
    assert warmer == pytest.approx(1.5e3, rel=0.03)
    assert higher == pytest.approx(4.1e3, rel=0.04)
    assert warmer < enclosed_air(ARRAY, LocalAir(temperature_c=32.0)).overpressure < 1.1 * warmer
    assert higher < enclosed_air(ARRAY, LocalAir(altitude=1000.0)).overpressure < 1.4 * higher


def test_a_membrane_that_warming_presses_together_makes_more_room() -> None:
    air = LocalAir(temperature_c=32.0)
    glued = ARRAY.with_values({"membrane.gluing_temperature": 20.0})
    pressed, free = (enclosed_air(each, air).overpressure for each in (glued, ARRAY))
    assert 0.85 * free < pressed < 0.97 * free


def test_a_stiffer_membrane_holds_more_pressure() -> None:
    air = LocalAir(temperature_c=32.0)
    soft, stiff = (enclosed_air(ARRAY, air, stiffness=factor) for factor in (0.8, 1.25))
    assert soft.overpressure < stiff.overpressure
    assert soft.compliance_ratio < stiff.compliance_ratio


def test_the_volume_is_that_of_cavities_tubes_chambers_and_microphones() -> None:
    cavities = 12 * math.pi * 3**2 * 2.5
    rest = SealedSensor.of(ARRAY).volume * 1e9 - cavities
    tubes = math.pi * 0.22**2 * 12.5 * 13
    microphones = 2 * (math.pi * 0.95**2 * 1.8 + math.pi * 0.25**2 * 0.4 + 2.0)
    assert rest == pytest.approx(tubes + microphones, rel=0.1)


# -- time -----------------------------------------------------------------------------------------------------
def test_air_leaves_through_the_silicone_in_the_hours_of_its_permeability() -> None:
    sensor = SealedSensor.of(ARRAY)
    constant = (sensor.volume / OUTSIDE + sensor.compliance) * OUTSIDE / (GAS_CONSTANT * KELVIN)
    hours = constant / sensor.permeance("air") / 3600
    assert hours == pytest.approx(3.5, rel=0.05)
    dry = ARRAY.with_values({"air.humidity": 0.0})
    air = LocalAir(pressure=OUTSIDE - 30)
    first, later = (enclosed_air(dry, air, hours=each).overpressure for each in (0.0, hours))
    assert later / first == pytest.approx(math.exp(-1), rel=5e-3)
    assert enclosed_air(dry, air, hours=math.inf).overpressure == 0


def test_vapour_enters_within_minutes_and_condenses_above_saturation() -> None:
    sweat = LocalAir(temperature_c=32.0, humidity=0.9)
    saturated = saturation_pressure(305.15)
    found = enclosed_air(ARRAY, sweat, hours=0.25)
    assert found.vapour == pytest.approx(0.9 * saturated, rel=0.01)
    assert found.overpressure > enclosed_air(ARRAY, LocalAir(temperature_c=32.0)).overpressure + 500
    cold = enclosed_air(ARRAY.with_values({"air.humidity": 1.0}), LocalAir(temperature_c=5.0))
    assert cold.vapour == saturation_pressure(278.15)


def test_a_vent_lets_a_pressure_out_in_its_time() -> None:
    seconds = design_vent(VENTED)
    assert 1 < seconds < 10
    dry = VENTED.with_values({"air.humidity": 0.0})
    air = LocalAir(pressure=OUTSIDE - 30)
    first, later = (enclosed_air(dry, air, hours=each / 3600).overpressure for each in (0.0, seconds))
    assert later / first == pytest.approx(math.exp(-1), rel=0.01)
    assert design_vent(ARRAY) == math.inf


# -- vents ----------------------------------------------------------------------------------------------------
def test_one_vent_costs_what_a_high_pass_of_its_time_costs() -> None:
    slow = np.array([0.01, 0.03, 0.1])
    rubber = ARRAY.material(ARRAY.membrane.material).model_copy(update={"loss_factor": 0.0})
    elastic = {"materials": {"elastic": rubber}, "membrane.material": "elastic"}
    tight, vented = (
        acoustic_fem.solve(each.with_values(elastic), slow, "lumped").cavity_response for each in (ARRAY, VENTED)
    )
    rate = 2j * np.pi * slow * design_vent(VENTED)
    lost = (vented / tight).transpose("point", "frequency").values
    assert np.abs(lost - rate / (1 + rate)).max() < 0.02


def test_a_suggested_vent_lasts_as_long_as_asked() -> None:
    vent = suggested_vent(ARRAY, 5.0)
    assert vent.time_constant == pytest.approx(5.0)
    as_built = VENTED.with_values({"point_kinds.vented.leak_diameter": vent.diameter})
    assert design_vent(as_built) == pytest.approx(5.0)
    assert vent.level(vent.corner) == pytest.approx(-10 * math.log10(2))
    assert suggested_vent(ARRAY, 1000.0).diameter == 0.02


# -- what a design and a library make of it -------------------------------------------------------------------
def test_a_bulged_membrane_is_stiffer_in_every_response() -> None:
    bulged = ARRAY.with_values({"air.overpressure": 1500.0})
    ratio = float(design_bulge_ratio(ARRAY, 1500.0))
    assert 0.75 < ratio < 0.85
    flat, stiff = design_disc(ARRAY), design_disc(bulged)
    assert stiff.static_compliance == pytest.approx(flat.static_compliance * ratio)
    assert stiff.volume_per_force == pytest.approx(flat.volume_per_force * ratio)
    assert stiff.first_frequency == pytest.approx(flat.first_frequency / math.sqrt(ratio))
    assert design_air(bulged).pressure == OUTSIDE + 1500.0


def test_the_incremental_volume_per_force_falls_as_the_compliance_does() -> None:
    """By reciprocity it is the displacement in the middle per pressure, here from two bulges."""
    membrane = design_membrane(ARRAY)
    middle = bulge(membrane, [10.0, 1490.0, 1510.0]).deepest
    own = (middle[2] - middle[1]) / 20 / (middle[0] / 10)
    assert own == pytest.approx(float(design_bulge_ratio(ARRAY, 1500.0)), rel=0.03)


def test_a_library_brought_into_other_air_in_no_time_is_that_of_the_bulged_sensor() -> None:
    frequency = np.linspace(1.0, 100.0, 6)
    library = acoustic_fem.solve(ARRAY, frequency, "lumped")
    worn = library.in_air(temperature_c=32.0, hours=0.0)
    assert worn.design.air.overpressure == enclosed_air(ARRAY, LocalAir(temperature_c=32.0)).overpressure
    solved = acoustic_fem.solve(worn.design, frequency, "lumped")
    for name in ("transfer_function", "force_response"):
        assert np.allclose(getattr(worn, name), getattr(solved, name), rtol=1e-12)
    rested, gas = library.in_air(temperature_c=32.0, hours=math.inf), library.in_air(temperature_c=32.0)
    assert np.allclose(rested.transfer_function, gas.transfer_function, rtol=1e-12)
    change = [float(abs(each.transfer_function / library.transfer_function - 1).max()) for each in (worn, gas)]
    assert change[0] > 4 * change[1]


@pytest.mark.parametrize(
    ("call", "kind", "field"),
    [
        (lambda: enclosed_air(ARRAY, hours=-1.0), Kind.OUT_OF_RANGE, "hours"),
        (lambda: enclosed_air(ARRAY, stiffness=0.0), Kind.OUT_OF_RANGE, "stiffness"),
        (lambda: enclosed_air(ARRAY, "32 degC"), Kind.WRONG_TYPE, "air"),  # type: ignore[arg-type]
        (
            lambda: enclosed_air(ARRAY.with_values({"membrane.stretch": 1.1}), LocalAir(temperature_c=32.0)),
            Kind.OUT_OF_RANGE,
            "membrane.stretch",
        ),
        (lambda: suggested_vent(ARRAY, 0.0), Kind.OUT_OF_RANGE, "time_constant"),
        (lambda: suggested_vent(ARRAY).level(0.0), Kind.OUT_OF_RANGE, "frequency"),
        (lambda: LocalAir(overpressure=3e4), Kind.OUT_OF_RANGE, "overpressure"),
        (lambda: design_bulge_ratio(ARRAY, 2e5), Kind.OUT_OF_RANGE, "overpressure"),
        (lambda: SealedSensor.of(ARRAY).overpressure(1.0, KELVIN, OUTSIDE), Kind.NO_RESULT, "overpressure"),
        (
            lambda: acoustic_fem.solve(ARRAY, [10.0], "lumped").in_air(overpressure=10.0, hours=0.0),
            Kind.CONFLICT,
            "hours",
        ),
    ],
)
def test_bad_input_is_refused_by_its_name(call: Callable[[], Any], kind: Kind, field: str) -> None:
    with refused(kind, field):
        call()
