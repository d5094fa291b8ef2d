"""Sweeps at fidelity atlas: what solve gives case by case, and cases outside the atlas fail by name."""

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.atlas import cell_atlas
from geometry.ground.refusal import Kind
from studies.findings.reporting import sweep_report
from studies.findings.result_table import table_of_sweep, with_base_metrics
from studies.study.differences import other_table
from studies.study.metric_registry import METRICS
from studies.study.parameter import StudyError
from studies.study.study import read_study
from studies.sweep.plan import plan_sweep
from studies.sweep.results import open_sweep
from studies.sweep.run import run_sweep

STUDY = """
base = "array-2x6"
fidelity = "atlas"
metrics = ["ild_smallest"]
frequency = "1:100:5"
keep = "responses"

[vary]
"resonator.cavity_height" = [2.0, 3.0, 7.2]
"air.temperature" = [10.0, 30.0]
"""


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    store = tmp_path_factory.mktemp("atlas") / "results.zarr"
    run_sweep(read_study(STUDY), store, workers=1)
    return open_sweep(store)


def test_cases_are_what_solve_gives(sweep):
    data, frequency = sweep.to_xarray(), read_study(STUDY).frequency
    kept = data["transfer_function"].values
    assert sweep.done.sum() == 4
    for number in np.flatnonzero(sweep.done):
        library = acoustic_fem.solve(sweep.design(int(number)), frequency, "atlas")
        np.testing.assert_allclose(kept[number], library.transfer_function.values, rtol=1e-8)
        assert METRICS["ild_smallest"].of_library(library) == pytest.approx(data["ild_smallest"].values[number])


def test_cases_outside_fail_by_name(sweep):
    reasons = sweep.to_xarray()["reason"].values[sweep.failed]
    assert len(reasons) == 2
    assert all("cavity height by radius = 2.4 must be 0.3 to 2.3 in the atlas of cells" in why for why in reasons)


def test_frequencies_above_those_of_touches_are_noted_once(tmp_path):
    text = STUDY.replace("1:100:5", "1:{}:25").replace("[2.0, 3.0, 7.2]", "[2.0, 3.0]")
    for last, notes in ((500, 0), (550, 1)):
        summary = run_sweep(read_study(text.format(last)), tmp_path / f"to-{last}.zarr", workers=1).summary
        assert sum("its errors were found up to 200 Hz" in note for note in summary.notes) == notes


def test_a_sweep_is_not_continued_with_another_table(tmp_path, monkeypatch):
    store, study = tmp_path / "results.zarr", read_study(STUDY)
    run_sweep(study, store, workers=1)
    assert run_sweep(study, store, workers=1).summary.computed == 0
    table = cell_atlas()
    monkeypatch.setattr("acoustic_fem.atlas.cell_atlas", lambda: replace(table, digest="0123456789ab"))
    with refused(Kind.MISMATCH, file=store, error=StudyError) as error:
        run_sweep(study, store, workers=1)
    assert f"its cells are of table {table.digest} of the atlas, not of 0123456789ab" in str(error.value)
    assert open_sweep(store).done.sum() == 4  # what is there can be read
    lumped = read_study(STUDY.replace('"atlas"', '"lumped"'))
    run_sweep(lumped, tmp_path / "lumped.zarr", workers=1)
    monkeypatch.undo()
    assert run_sweep(lumped, tmp_path / "lumped.zarr", workers=1).summary.computed == 0


def test_a_store_that_notes_no_table_is_not_continued():
    assert other_table("", "0123456789ab") == (
        "its cells are of a table without a digest of the atlas, not of 0123456789ab, which is installed"
    )
    assert other_table("", "") == ""


def test_it_asks_for_no_cell_in_3_d():
    assert plan_sweep(read_study(STUDY)).cells == 0


def test_the_base_beside_its_cases_is_of_the_atlas_too(sweep):
    table = with_base_metrics(table_of_sweep(sweep))
    library = acoustic_fem.solve(sweep.base, read_study(STUDY).frequency, "atlas")
    assert table.base_metrics["ild_smallest"] == pytest.approx(METRICS["ild_smallest"].of_library(library))


@pytest.mark.slow
def test_a_base_outside_has_no_figures_and_its_curves_say_that_they_are_of_3_d_cells(tmp_path):
    base = geometry.prototype("array-2x6").with_values({"resonator.cavity_height": 7.0})
    study = read_study(STUDY.replace("[2.0, 3.0, 7.2]", "[2.0, 3.0]"), base=base)
    run_sweep(study, tmp_path / "results.zarr", workers=1)
    table = sweep_report(tmp_path / "results.zarr", tmp_path / "report.html")
    assert table.base_metrics == {}
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "the base design (navier-stokes: resonator 6 x 7 mm" in page


def test_it_is_the_default_and_a_study_that_names_another_keeps_that():
    silent = STUDY.replace('fidelity = "atlas"\n', "")
    assert read_study(silent).digest() == read_study(STUDY).digest()
    assert read_study(STUDY.replace('"atlas"', '"navier-stokes"')).fidelity == "navier-stokes"


@pytest.mark.slow
def test_ten_random_cases_are_within_the_stated_error_of_3_d_where_closed_forms_are_not(tmp_path):
    """Wide bores in small cavities: what 3-D adds counts there."""
    base = geometry.prototype("array-2x6").with_values(
        {
            **{f"{tube}.inner_diameter": 0.7 for tube in ("tube", "microphone_tube")},
            **{f"{tube}.outer_diameter": 1.3 for tube in ("tube", "microphone_tube")},
            "resonator.cavity_diameter": 3.6,
        }
    )
    text = """
base = "array-2x6"
sampling = "random"
cases = 10
seed = 20
metrics = ["distance_smallest"]
frequency = "1:200:9"
keep = "responses"

[vary]
"resonator.cavity_height" = [2.0, 2.4]
"tube.length" = {from = 9, to = 25}
"membrane.thickness" = {from = 0.4, to = 1.2}
"""
    kept = {}
    for fidelity in ("lumped", "atlas", "navier-stokes"):
        store = tmp_path / f"{fidelity}.zarr"
        study = read_study(f'fidelity = "{fidelity}"\n{text}', base=base)
        assert run_sweep(study, store, workers=1).summary.computed == 10
        data = open_sweep(store).to_xarray()
        kept[fidelity] = data["transfer_function"].values
    exact = kept.pop("navier-stokes")
    off = {
        fidelity: (np.abs(found / exact - 1) / (1 + np.abs(np.log(np.abs(exact))))).max()
        for fidelity, found in kept.items()
    }
    assert 0 < off["atlas"] < cell_atlas().errors["transfer function by 1 + |ln H|"] < off["lumped"]
