"""Loudest outputs of microphones under taps, against the pressures of the library and the response of a microphone."""

from __future__ import annotations

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused
from small_run import small_design

import acoustic_fem
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.network import output_response
from acoustic_fem.quantities.local_air import design_air
from geometry import Kind
from localize.contacts import loudest_outputs
from localize.contacts.contact import hertz_fraction

#: A contact far inside the membrane and a light force, so that the patch of the library is pressed as it is.
RADIUS, FORCE = 0.5, 1e-4


@pytest.fixture(scope="module")
def library() -> Library:
    return acoustic_fem.solve(small_design(), np.arange(0.5, 300.1, 0.5), "lumped")


def test_a_tap_is_the_response_to_its_force_through_the_high_pass(library: Library) -> None:
    seconds = 0.1
    time = np.arange(4000) / 1e3
    force = np.where(time <= seconds, FORCE * np.sin(np.pi * time / seconds) ** 2, 0.0)
    grid = np.fft.rfftfreq(len(time), 1e-3)
    inside = (grid >= 0.5) & (grid <= 300)
    design = library.design
    per_force = library.touch_response("force").transpose("point", "microphone", "frequency").values
    covered = hertz_fraction(np.zeros(1), RADIUS, design.resonator.cavity_diameter / 2)[0]
    known = output_response(design.microphone, grid[inside], design_air(design))
    spectrum = np.zeros((*per_force.shape[:2], len(grid)), np.complex128)
    at = np.rint(grid[inside] / 0.5).astype(int) - 1
    spectrum[..., inside] = np.fft.rfft(force)[inside] * covered * per_force[..., at] * known
    expected = np.abs(np.fft.irfft(spectrum, len(time))).max(axis=2)
    found = loudest_outputs(library, FORCE, contact_radius_mm=RADIUS, seconds=seconds)
    np.testing.assert_allclose(found, expected, rtol=0.03)


def test_fast_taps_are_louder_and_light_ones_proportional(library: Library) -> None:
    slow, fast = (loudest_outputs(library, FORCE, seconds=seconds) for seconds in (0.5, 0.02))
    assert (fast > 5 * slow).all()
    np.testing.assert_allclose(loudest_outputs(library, 2 * FORCE, seconds=0.02), 2 * fast, rtol=1e-3)


@pytest.mark.slow
def test_a_large_press_displaces_less_than_the_linear_law_says(library: Library) -> None:
    light, large = (loudest_outputs(library, force, seconds=0.1) for force in (FORCE, 1e4 * FORCE))
    assert (large < 1e4 * light).all()


def test_what_has_no_design_or_is_out_of_range_is_refused(library: Library) -> None:
    with refused(Kind.UNSUITABLE, "array"):
        loudest_outputs(rc_line(3), FORCE)
    for field, value in (("force", 0.0), ("seconds", 0.001)):
        with refused(Kind.OUT_OF_RANGE, field, value):
            loudest_outputs(library, **{"force": FORCE, field: value})
