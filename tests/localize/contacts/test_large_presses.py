"""Presses that are not small: light ones as before, no step between the laws, the pressed membrane's own stiffness."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.membrane import SoftPatch, design_disc, press_curve
from geometry import Kind
from localize.contacts import Contact, LargePresses, record
from localize.contacts.large_presses import LIGHT
from localize.signals import response_of

RATE = 1000.0
TIME = np.arange(2000) / RATE
HUMP = np.where((TIME > 0.3) & (TIME < 1.3), np.sin(np.pi * np.clip(TIME - 0.3, 0, 1)) ** 2, 0.0)
POINT = 4


@cache
def library():
    return acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(1, 100.01, 1.0), fidelity="lumped")


def contact(force):
    place = response_of(library()).position[POINT]
    return Contact(TIME, np.tile(place, (len(TIME), 1)), force * HUMP, 2.0)


def law_of(presses):
    design = presses._design
    assert design is not None
    return presses._law(design, POINT)


def on_one_membrane(force):
    every = np.zeros((len(TIME), 12))
    every[:, POINT] = force * HUMP
    return every


def test_a_light_press_is_linear_and_needs_no_solution(monkeypatch):
    monkeypatch.setattr(acoustic_fem.membrane, "press_curve", None)
    light = contact(9e-3)
    made, linear = (record(light, library(), microphone_noise=0.0, linear=each).signals for each in (False, True))
    assert np.array_equal(made, linear)


@pytest.mark.slow
def test_there_is_no_step_between_the_laws():
    presses = LargePresses(response_of(library()), RATE)
    law = law_of(presses)
    force = law.light * np.linspace(0.5, 3.0, 400)
    gain, yielding = law.at(force)
    assert (np.diff(force * gain) > 0).all()
    assert np.abs(np.diff(gain)).max() < 1e-3
    assert np.abs(np.diff(yielding)).max() < 1e-2 * yielding.max()
    assert (gain[force <= law.light] == 1).all()
    assert law.light == pytest.approx(LIGHT * 1.32e6 * 9e-6, rel=0.01)  # the modulus at 1 Hz, not at 0.1 Hz


@pytest.mark.parametrize("force", [0.1, 0.3])
def test_a_press_displaces_the_volume_of_the_nonlinear_membrane(force):
    """With p the cavity's pressure, the linear array moves V' F' - C' p; the membrane moves V(F) - C(F) p."""
    response = response_of(library())
    presses = LargePresses(response, RATE)
    equivalent = presses.light_forces(on_one_membrane(force))[:, POINT]
    through = presses._cavity(POINT, len(TIME))
    length = 2 * (len(through) - 1)
    pressure = np.fft.irfft(np.fft.rfft(equivalent, length) * through, length)[: len(TIME)]
    disc = design_disc("array-2x6")
    curve = law_of(presses).curve
    assert curve is not None
    pressed, relaxed = curve.response(force * HUMP), curve.response(0.0)
    softer = disc.modulus / curve.membrane.youngs_modulus
    moved = disc.volume_per_force * softer * equivalent - disc.static_compliance * softer * pressure
    expected = pressed.volume - pressed.compliance * pressure
    loud = force * HUMP > 2 * law_of(presses).light
    assert loud.any()
    assert moved[loud] == pytest.approx(expected[loud], rel=2e-3, abs=1e-3 * expected.max())
    assert relaxed.compliance == pytest.approx(disc.static_compliance * softer, rel=1e-3)


def test_a_large_press_is_recorded_far_below_the_linear_law():
    large, linear = (
        np.abs(record(contact(0.3), library(), microphone_noise=0.0, linear=each).signals).max()
        for each in (False, True)
    )
    fraction = press_curve(acoustic_fem.membrane.design_membrane("array-2x6"), SoftPatch()).volume_fraction(0.3)
    assert fraction < large / linear < 0.5  # stiffer at 1 Hz than the static modulus, and against the pressure


def test_a_short_blow_counts_by_its_mean():
    """A grain of sand gives 50 mN for a third of a millisecond: the membrane is no further in than under 3 mN."""
    blow = np.zeros((8000, 12))
    blow[1000:1003, POINT] = 0.05
    presses = LargePresses(response_of(library()), 8000.0)
    assert np.array_equal(presses.light_forces(blow), blow)
    blow[1000:1040, POINT] = 0.05
    assert presses.light_forces(blow)[:, POINT].max() != 0.05


def test_a_force_beyond_the_law_is_refused():
    with refused(Kind.OUT_OF_RANGE, "contact.force") as refusal:
        record(contact(10.0), library(), microphone_noise=0.0)
    assert refusal.value.value == pytest.approx(10.0, rel=1e-3)
    assert record(contact(10.0), library(), microphone_noise=0.0, linear=True).signals.max() > 0


def test_an_array_without_a_design_stays_linear():
    force = on_one_membrane(10.0)
    bare = replace(response_of(library()), provenance={})
    assert np.array_equal(LargePresses(bare, RATE).light_forces(force), force)


def test_a_stretched_membrane_stays_linear_with_a_warning():
    design = geometry.prototype("array-2x6").with_values({"membrane.stretch": 1.1})
    stretched = acoustic_fem.solve(design, np.arange(1, 100.01, 1.0), fidelity="lumped")
    with pytest.warns(UserWarning, match="membrane.stretch"):
        made = record(contact(0.1), stretched, microphone_noise=0.0).signals
    assert np.array_equal(made, record(contact(0.1), stretched, microphone_noise=0.0, linear=True).signals)
