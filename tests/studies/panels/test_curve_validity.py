"""What is said of the error of curves is what is known of their fidelity."""

from __future__ import annotations

import re

import numpy as np
import pytest

import acoustic_fem
from acoustic_fem.atlas import QuickFidelity, cell_atlas
from geometry import prototype
from studies.panels.curve_validity import validity
from studies.panels.curves import curve_frequencies, quick_library
from studies.panels.solved_curves import solve_curves

ARRAY = prototype("array-2x6")


def percent(words: str) -> float:
    found = re.search(r"([\d.]+) %", words)
    assert found
    return float(found[1])


def test_the_error_of_the_atlas_is_that_of_the_weakest_transfer_function() -> None:
    library, fidelity = quick_library(ARRAY)
    found = validity(library.transfer_function, fidelity)
    weakest = np.abs(library.transfer_function.values).min()
    off = cell_atlas().errors["transfer function by 1 + |ln H|"] * (1 - np.log(weakest))
    assert found.words.startswith("quick, \N{PLUS-MINUS SIGN}")
    assert percent(found.words) == pytest.approx(100 * off, rel=0.05)
    assert found.solves
    nearer = validity(library.transfer_function.isel(frequency=[0]), fidelity)
    assert percent(nearer.words) < percent(found.words)


def test_the_reason_for_another_fidelity_is_that_of_the_choice() -> None:
    transfer = quick_library(ARRAY)[0].transfer_function
    solid = validity(transfer, QuickFidelity("navier-stokes", "the bore is too wide"))
    assert (solid.words, solid.solves) == ("3-D", False)
    assert "the bore is too wide" in solid.reason
    rough = validity(transfer, QuickFidelity("lumped", "the bore is too wide", "its mesh is too large"))
    assert rough.words == "rough, \N{PLUS-MINUS SIGN}2 %"
    assert "the bore is too wide; its mesh is too large" in rough.reason
    assert not rough.solves


@pytest.mark.slow
def test_curves_in_3d_are_those_of_solve_and_the_quick_ones_are_as_near_as_is_said() -> None:
    told: list[str] = []
    found = solve_curves(ARRAY, told.append)
    solved = acoustic_fem.solve(ARRAY, curve_frequencies(), "navier-stokes").transfer_function
    np.testing.assert_array_equal(found.transfer_function.values, solved.values)
    library, fidelity = quick_library(ARRAY)
    off = 100 * np.abs(solved.values / library.transfer_function.values - 1).max()
    assert percent(found.validity.reason) == pytest.approx(off, rel=0.05)
    assert off < percent(validity(library.transfer_function, fidelity).words)
    assert not found.validity.solves
    assert told
