"""Sweeps that keep libraries: what is read back is what solving the design alone gives, and tables are plain."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from coarse_discs import coarse_discs
from joined_cells import library_of_cells
from refusals import refused
from typer.testing import CliRunner

import acoustic_fem
import localize
import studies
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.library.transfer_functions import VARIABLES
from acoustic_fem.membrane.design_discs import design_shape
from geometry.ground.refusal import Kind
from localize.datasets.splits import SPLITS
from studies.cli.app import app
from studies.sweep import block
from studies.sweep.survey import surveyed

STUDY: dict[str, Any] = {
    "base": "array-2x6",
    "vary": {"tube.inner_diameter": (0.3, 0.9), "lines.0.points": (11, 12)},
    "sampling": "random",
    "stock": "off",
    "cases": 12,
    "fidelity": "atlas",
    "frequency": "1:100:8",
    "metrics": ["distance_smallest", "volume"],
    "keep": "libraries",
}


@pytest.fixture(scope="module")
def sweep(tmp_path_factory: pytest.TempPathFactory) -> studies.Sweep:
    return studies.run_sweep(studies.Study(**STUDY), tmp_path_factory.mktemp("sweep") / "results.zarr", workers=1)


def test_a_library_of_a_sweep_is_what_solve_gives_to_the_last_bit(sweep: studies.Sweep, tmp_path: Path) -> None:
    done = np.flatnonzero(sweep.done)
    assert {sweep.design(number).point_count for number in done} == {11, 12}
    for number in done:
        library = sweep.library(number)
        solved = acoustic_fem.solve(sweep.design(number), sweep.frequency, "atlas")
        for name in VARIABLES:
            assert getattr(library, name).identical(getattr(solved, name)), name
        assert (library.design, library.medium, library.fidelity) == (solved.design, solved.medium, "atlas")
        assert library.provenance["cells"] == solved.provenance["cells"]
        assert library.provenance["frequency_sha256"] == solved.provenance["frequency_sha256"]
        assert library.provenance["sweep"] == {"title": "study", "case": number}
    path = tmp_path / "libraries" / "best.nc"
    library.save(path)
    assert acoustic_fem.load(path).transfer_function.identical(library.transfer_function)


@pytest.fixture
def _coarse() -> Iterator[None]:
    with coarse_discs():
        yield


@pytest.mark.usefixtures("_coarse")
@pytest.mark.slow
def test_a_library_is_what_solve_gives_where_every_case_has_a_membrane_of_its_own(tmp_path: Path) -> None:
    """The study of docs/training-libraries.md with more cases than a table of membranes is worth, and with fewer
    frequencies: by default no library has an interpolated membrane.
    """
    study = studies.Study(
        base="array-2x6",
        vary={"tube.inner_diameter": (0.3, 0.6), "membrane.thickness": (0.3, 1.0)},
        stock="off",
        sampling="sobol",
        cases=64,
        fidelity="atlas",
        frequency="1:500:20",
        keep="libraries",
        metrics=["predicted_top1", "noise_equivalent_force"],
    )
    sweep = studies.run_sweep(study, tmp_path / "bores.zarr", workers=1)
    assert sweep.done.all()
    assert len({design_shape(sweep.design(case)) for case in range(64)}) == 64
    for case in sweep.best("predicted_top1", 8):
        library = sweep.library(case)
        solved = acoustic_fem.solve(sweep.design(case), sweep.frequency, "atlas")
        for name in VARIABLES:
            assert getattr(library, name).identical(getattr(solved, name)), (case, name)
        assert "membranes" not in library.provenance


def test_in_single_precision_it_is_that_to_seven_digits_in_half_the_space(tmp_path: Path, sweep: studies.Sweep) -> None:
    short = studies.run_sweep(studies.Study(**STUDY, precision="single"), tmp_path / "single.zarr", workers=1)
    number = short.best("volume", 1)[0]
    for name in VARIABLES:
        found, exact = (getattr(each.library(number), name).values for each in (short, sweep))
        np.testing.assert_allclose(found, exact, rtol=3e-7)

    def size(store: Path) -> int:
        return sum(file.stat().st_size for file in (store / "responses").rglob("c/*/*/*/*"))

    assert size(short.records.path) < 0.7 * size(sweep.records.path)


def test_the_tables_of_a_sweep_have_one_row_a_case(sweep: studies.Sweep) -> None:
    table = sweep.to_dataframe()
    assert list(table.columns) == [*sweep.parameters, *sweep.metrics, "status", "reason"]
    assert len(table) == len(sweep) == 12
    assert set(table["status"]) == {"done", "failed"}
    assert table["reason"][table["status"] == "done"].eq("").all()
    assert table["reason"][table["status"] == "failed"].str.len().min() > 10
    store = sweep.records.path
    plain = xr.open_zarr(store)
    assert set(plain.coords) == {"case", "split", *sweep.parameters}
    assert len(plain.to_dataframe()) == 12
    data = sweep.to_xarray()
    assert set(data.coords) >= {"case", *sweep.parameters}
    assert data["transfer_function"].dtype == np.complex128
    kept = xr.open_zarr(store, group="responses")
    np.testing.assert_array_equal(kept["point_impedance_real"], data["point_impedance"].real)


def test_the_split_of_each_case_is_a_coordinate_of_the_store_and_that_of_data_sets(tmp_path: Path) -> None:
    vary = {"tube.inner_diameter": (0.3, 0.6), "microphone_tube.bore": ["smooth", "coil"]}
    study = studies.Study(**{**STUDY, "vary": vary, "cases": 40})
    sweep = studies.run_sweep(study, tmp_path / "r.zarr", workers=1)
    for found in (
        xr.open_zarr(tmp_path / "r.zarr"),
        xr.open_zarr(tmp_path / "r.zarr", group="responses").set_coords("split"),
        sweep.to_xarray(),
    ):
        assert "split" in found.coords
        assert found["split"].dims == ("case",)
        for split in SPLITS:
            cases = localize.TouchDataset(sweep, split=split, touches=1).cases
            assert len(cases)
            np.testing.assert_array_equal(np.flatnonzero((found["split"] == split) & sweep.done), cases)
    np.testing.assert_array_equal(sweep.splits, xr.open_zarr(tmp_path / "r.zarr")["split"])


def test_the_best_cases_come_first_and_failed_ones_not_at_all(sweep: studies.Sweep) -> None:
    values = sweep.values["volume"]
    best = sweep.best("volume", 100)
    assert best == sorted(np.flatnonzero(sweep.done), key=lambda number: values[number])
    assert sweep.best("distance_smallest", 1) == [int(np.nanargmax(sweep.values["distance_smallest"]))]
    with refused(Kind.UNKNOWN, "metric", "mass"):
        sweep.best("mass", 1)
    with refused(Kind.OUT_OF_RANGE, "count", 0):
        sweep.best("volume", 0)


def test_a_case_without_a_library_is_refused_by_name(sweep: studies.Sweep, tmp_path: Path) -> None:
    failed = int(np.flatnonzero(sweep.failed)[0])
    with refused(Kind.NO_RESULT, "case", failed):
        sweep.library(failed)
    for wrong in (-1, 12):
        with refused(Kind.OUT_OF_RANGE, "case", wrong):
            sweep.library(wrong)
    with refused(Kind.MISSING):
        _ = studies.open_sweep(sweep.records.path).summary
    short = studies.Study(**{**STUDY, "keep": "responses", "cases": 2})
    with refused(Kind.MISMATCH, "keep", "responses"):
        studies.run_sweep(short, tmp_path / "r.zarr", workers=1).library(0)


OUTSIDE = {
    **STUDY,
    "vary": {"resonator.cavity_height": [2.5, 7.2]},
    "sampling": "grid",
    "cases": None,
}


def test_cases_outside_the_atlas_are_counted_beforehand_with_the_reason(tmp_path: Path) -> None:
    studies.Study(**OUTSIDE).save(tmp_path / "study.toml")
    plan = studies.plan_sweep(tmp_path / "study.toml", workers=1)
    ((reason, count),) = plan.outside.items()
    assert count == 1
    assert "cavity height by radius = 2.4" in reason
    assert plan.cells == 0
    shown = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--dry-run"])
    assert "outside the atlas: 1, which will be stored as failed" in shown.stdout
    assert "cavity height by radius = 2.4" in shown.stdout
    solid = studies.plan_sweep(studies.Study(**OUTSIDE, outside="navier-stokes"), workers=1)
    assert solid.cells > 0


def test_a_survey_of_many_designs_finds_those_outside_that_each_is_by_itself() -> None:
    vary = {"resonator.cavity_height": (2.5, 7.5), "tube.inner_diameter": (0.3, 1.2), "air.pressure": [1e5, 7e4]}
    study = studies.Study(**{**STUDY, "vary": vary, "cases": 24})
    survey = surveyed(study, every=True)
    one_by_one = {
        number: acoustic_fem.atlas.quick_fidelity(survey.cases.design(number), study.frequency).outside
        for number in range(24)
        if number not in survey.refused
    }
    assert survey.outside == {number: why for number, why in one_by_one.items() if why}
    assert 0 < len(survey.outside) < len(one_by_one)


def test_cases_outside_the_atlas_are_solved_in_3d_if_the_study_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The 3-D solution is replaced by the closed form: what is tested is who asks for it and what becomes of it."""
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cache"))
    asked = []

    def solve_cells(cells: list[Any], frequency: Any, medium: Any, fidelity: str, *, apart: bool) -> dict[Any, Any]:
        assert (fidelity, apart) == ("navier-stokes", True)
        (cell,) = cells
        asked.append(cell)
        admittance = lumped_admittance(cell, frequency, medium)
        return {cell: block.CellSolution(admittance, fidelity, 7, (), 0.0, 0.0, 1.0, cached=False)}

    monkeypatch.setattr(block, "solve_cells", solve_cells)
    sweep = studies.run_sweep(studies.Study(**OUTSIDE, outside="navier-stokes"), tmp_path / "r.zarr", workers=1)
    assert sweep.done.all()
    assert {cell.height for cell in asked if cell.kind == "resonator"} == {7.2}
    assert sweep.solid == {1}
    inside, outside = sweep.library(0), sweep.library(1)
    assert (inside.fidelity, outside.fidelity) == ("atlas", "navier-stokes")
    assert all(cell["unknowns"] == 7 and "seconds" not in cell for cell in outside.provenance["cells"])
    lumped = library_of_cells(sweep.design(1), sweep.frequency)
    assert outside.transfer_function.identical(lumped.transfer_function)
