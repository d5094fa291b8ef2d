"""Libraries in netCDF against the CF conventions, by the compliance checker of IOOS and its own tables, offline."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
from libraries import library_of, three_points

import acoustic_fem
from acoustic_fem.library.transfer_functions import MEASURED, VARIABLES, Library, library_from_arrays

runner = pytest.importorskip("compliance_checker.runner", reason="compliance-checker, of the extra dev, is missing")
pytestmark = pytest.mark.slow


def faults(path: Path) -> list[str]:
    """Messages of the checker about a file, of every severity."""
    suite = runner.CheckSuite()
    suite.load_all_available_checkers()
    file = suite.load_dataset(str(path))
    results, failed = suite.run_all(file, ["cf:1.11"], skip_checks=[])["cf:1.11"]
    file.close()
    assert not failed
    assert len(results) > 20
    # what passes has messages too
    return [
        message
        for result in results
        if isinstance(result.value, tuple) and result.value[0] < result.value[1]
        for message in result.msgs or [result.name]
    ]


def measured() -> Library:
    library = three_points()
    values = {name: getattr(library, name).values for name in VARIABLES}
    deviation = np.full(values["transfer_function"].shape, 0.1)
    return library_from_arrays(
        library.design, library.frequency, values, MEASURED, library.medium, library.provenance, deviation
    )


@pytest.mark.parametrize("kind", ["computed", "measured", "three microphones", "long text"])
def test_the_checker_finds_no_fault_in_a_library(kind: str, tmp_path: Path) -> None:
    library = {
        "computed": three_points,
        "measured": measured,
        "three microphones": lambda: library_of("fingertip-3x4"),
        "long text": lambda: replace(three_points(), provenance={**three_points().provenance, "note": "x" * 70_000}),
    }[kind]()
    acoustic_fem.save(library, tmp_path / "library.nc")
    assert faults(tmp_path / "library.nc") == []


@pytest.mark.parametrize(
    ("damage", "word"),
    [
        (lambda file: file["point_impedance_imag"].attrs.__delitem__("long_name"), "long_name"),
        (lambda file: file["transfer_function_real"].attrs.__setitem__("units", "decibels of fun"), "units"),
        (lambda file: file["frequency"].attrs.__setitem__("_FillValue", np.array([np.nan])), "_FillValue"),
        (lambda file: file.attrs.__setitem__("Conventions", "none"), "Conventions"),
    ],
    ids=["no name", "no such unit", "fill value of a coordinate", "no convention"],
)
def test_the_checker_finds_what_is_wrong(damage, word: str, tmp_path: Path) -> None:
    acoustic_fem.save(three_points(), tmp_path / "library.nc")
    with h5py.File(tmp_path / "library.nc", "r+") as file:
        damage(file)
    assert any(word in message for message in faults(tmp_path / "library.nc"))
