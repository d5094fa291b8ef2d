"""The curves of the page are the transfer functions that Python computes of the same design."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
from geometry import Kind, prototype
from studies.metrics.pairs import attenuation, microphone_ratios
from studies.panels.curves import CURVES, curve_frequencies, curves_of, quick_library

GLOVE = prototype("glove")


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return acoustic_fem.solve(GLOVE, curve_frequencies(), fidelity="atlas")


def test_the_library_is_of_the_atlas(library: acoustic_fem.Library) -> None:
    found, fidelity = quick_library(GLOVE)
    np.testing.assert_array_equal(found.transfer_function, library.transfer_function)
    assert fidelity.words == "atlas"


@pytest.mark.slow
def test_the_library_is_of_3d_where_the_atlas_does_not_cover_the_design() -> None:
    outside = GLOVE.with_values({"microphone.sound_hole_diameter": 2.0})
    found, fidelity = quick_library(outside)
    solid = acoustic_fem.solve(outside, curve_frequencies())
    np.testing.assert_array_equal(found.transfer_function, solid.transfer_function)
    assert fidelity.words.startswith("navier-stokes: microphone ")
    assert "sound hole by chamber diameter = " in fidelity.words


@pytest.mark.parametrize("quantity", CURVES)
def test_curves_are_those_of_the_transfer_functions(library: acoustic_fem.Library, quantity: str) -> None:
    found = curves_of(library.transfer_function, quantity)
    ratios, h = microphone_ratios(library.transfer_function), library.transfer_function.values
    of = ratios if quantity in ("ild", "ipd") else h
    assert found.heard_by == (("A / B", "A / C", "B / C") if of is ratios else ("A", "B", "C"))
    if found.unit == "dB":
        np.testing.assert_allclose(found.values, 20 * np.log10(np.abs(of)), rtol=1e-12)
    else:
        np.testing.assert_allclose(np.exp(1j * np.radians(found.values)), of / np.abs(of), rtol=1e-9)
        assert np.abs(np.diff(found.values)).max() < 180
    if quantity == "level":
        np.testing.assert_allclose(
            found.values[:, :, 0], attenuation(library.transfer_function, float(found.frequency[0])), rtol=1e-12
        )


def test_another_quantity_is_refused(library: acoustic_fem.Library) -> None:
    with refused(Kind.OUT_OF_RANGE, "quantity", value="loudness"):
        curves_of(library.transfer_function, "loudness")
