"""What motion of the sensor adds to its signals."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.library.acceleration import areal_mass
from geometry.ground.refusal import Kind
from localize.signals import motion_signals, without_motion

FREQUENCY = np.array([0.5, 1.0, 3.0, 10.0, 30.0, 100.0])


def solved(name: str) -> acoustic_fem.Library:
    return acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped")


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return solved("array-2x6")


@pytest.mark.parametrize(("name", "pressure"), [("array-2x6", 0.31), ("fingertip-3x4", 0.11), ("line-2", 0.42)])
def test_a_flat_array_hears_what_an_independent_network_gave(name: str, pressure: float) -> None:
    response = solved(name).acceleration_response.sel(frequency=10.0)
    assert np.abs(response.sel(axis="z").values) == pytest.approx(pressure, abs=0.01)
    assert np.abs(response.sel(axis=["x", "y"]).values).max() < 1e-12


def test_the_load_is_that_of_the_mass_and_the_air_takes_a_part_of_it(library: acoustic_fem.Library) -> None:
    design = library.design
    assert areal_mass(design) == pytest.approx(1070 * 0.5e-3)
    # at low frequency nothing flows: the pressure of the load times the part that the membranes have of the compliance
    disc = acoustic_fem.membrane.design_disc(design).response(FREQUENCY, acoustic_fem.membrane.design_rubber(design))
    softness = np.abs(disc.volume_per_pressure[1])
    cell = np.pi * (design.resonator.cavity_diameter / 2e3) ** 2 * design.resonator.cavity_height / 1e3 / 101325
    expected = 1070 * 0.5e-3 * softness / (softness + cell)
    heard = np.abs(library.acceleration_response.sel(axis="z", frequency=1.0).values)
    # what tubes and chambers hold of air, and the leak of the vents, is left out of the estimate
    assert heard == pytest.approx(expected, rel=0.15)
    assert (heard < expected).all()


def test_membranes_around_a_wrist_are_not_shaken_along_it_and_partly_cancel_across_it() -> None:
    design = geometry.load_design(Path(__file__).parents[3] / "docs" / "examples" / "wristband-16.toml")
    response = acoustic_fem.solve(design, FREQUENCY, "lumped").acceleration_response.sel(frequency=10.0)
    x, y, z = np.abs(response.values).max(axis=0)
    assert y < 1e-12
    assert 0 < x < z
    assert np.hypot(x, z) < 0.8 * areal_mass(design)[0]


def test_signals_follow_the_response_and_are_taken_out_again(library: acoustic_fem.Library) -> None:
    rate, hertz = 1000.0, 10.0
    time = np.arange(3000) / rate
    moved = np.zeros((3, len(time)))
    moved[2] = np.sin(2 * np.pi * hertz * time)
    heard = motion_signals(library, moved, rate)
    late = slice(1000, 2000)  # whole periods, long after the start
    found = 2 * (heard[:, late] * np.exp(-2j * np.pi * hertz * time[late])).mean(axis=1) * 1j
    expected = library.acceleration_response.sel(axis="z", frequency=hertz).values
    assert found == pytest.approx(expected, rel=0.02)
    touch = 1e-3 * np.random.default_rng(0).standard_normal(heard.shape)
    touch[:, 1500:1600] += 1.0
    assert without_motion(library, heard + touch, moved, rate) == pytest.approx(touch, abs=2e-3)


def test_bad_input_is_named(library: acoustic_fem.Library) -> None:
    with refused(Kind.WRONG_TYPE, "acceleration"):
        motion_signals(library, np.zeros((2, 10)))
    with refused(Kind.MISMATCH, "signals"):
        without_motion(library, np.zeros((3, 10)), np.zeros((3, 10)))
