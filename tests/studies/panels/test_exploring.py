"""Ranges around a design become a study that the verbs take, and its figures are those of its results."""

from __future__ import annotations

import tomllib
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest
from refusals import refused

from geometry import Kind, Refusal, load_design, prototype
from studies.findings.reporting import best_designs
from studies.findings.result_table import Column, ResultTable, effect, table_of_sweep
from studies.panels.exploring import (
    FailedDesign,
    FoundDesigns,
    limits_of,
    run_study,
    study_figures,
    study_file,
    study_folder,
    study_so_far,
    write_study,
)
from studies.study import load_study
from studies.sweep import open_sweep

ARRAY = prototype("array-2x6")
RANGES = {
    "tube.length": [9, 18.5],
    "lines.0.points": [4, 6],
    "membrane.material": ["silicone-shore-a-30", "silicone-shore-a-10"],
}
FIGURES = ["distance_smallest", "volume"]


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of its own for solved cells and studies."""
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    return tmp_path


def test_ranges_become_a_study_file_that_the_verbs_read(tmp_path: Path) -> None:
    mine = ARRAY.with_values({"name": "mine"})
    write_study(mine, study_file(mine, RANGES, FIGURES, designs=128), tmp_path / "study.zip")
    with ZipFile(tmp_path / "study.zip") as archive:
        archive.extractall(tmp_path)
    study = load_study(tmp_path / "study.toml")
    assert load_design(tmp_path / "mine.toml") == mine == study.base
    assert [each.name for each in study.parameters] == list(RANGES)
    length, points, material = study.parameters
    assert (length.low, length.high, points.whole) == (9, 18.5, True)
    assert material.values == tuple(RANGES["membrane.material"])
    assert (study.sampling, study.cases, study.metrics, study.fidelity) == ("sobol", 128, tuple(FIGURES), "atlas")


def test_a_search_wants_the_best_of_its_figures(tmp_path: Path) -> None:
    from studies.optimization import load_optimization

    write_study(ARRAY, study_file(ARRAY, RANGES, FIGURES, search=True, designs=100), tmp_path / "study.zip")
    with ZipFile(tmp_path / "study.zip") as archive:
        archive.extractall(tmp_path)
    problem = load_optimization(tmp_path / "study.toml")
    assert [(each.metric.name, each.better) for each in problem.objectives] == [
        ("distance_smallest", "larger"),
        ("volume", "smaller"),
    ]
    assert problem.trials == 100


@pytest.mark.parametrize(
    ("ranges", "metrics", "designs", "field"),
    [
        ({}, FIGURES, 8, "vary"),
        ({"tube.width": [1, 2]}, FIGURES, 8, "tube.width"),
        ({"tube.length": [1, 5000]}, FIGURES, 8, "tube.length"),
        ({"tube.length": [20, 10]}, FIGURES, 8, "tube.length"),
        ({"tube.length": [20]}, FIGURES, 8, "a range"),
        ({"tube.length": ["long"]}, FIGURES, 8, "tube.length"),
        (RANGES, ["beauty"], 8, "beauty"),
        (RANGES, [], 8, "metrics"),
        (RANGES, FIGURES, 0, "designs"),
    ],
)
def test_what_is_no_study_is_refused_in_one_line(
    ranges: dict[str, list[float]], metrics: list[str], designs: int, field: str
) -> None:
    with pytest.raises(Refusal) as found:
        study_file(ARRAY, ranges, metrics, designs=designs)
    assert field in str(found.value)
    assert "\n" not in str(found.value)


def test_limits_are_kept_by_a_search_and_computed_by_a_sweep() -> None:
    limits = {"cost": 5.0, "verdict": 1.0}
    found = tomllib.loads(study_file(ARRAY, RANGES, FIGURES, search=True, designs=8, limits=limits))
    assert found["optimize"]["limits"] == [{"metric": "cost", "most": 5.0}, {"metric": "verdict", "least": 1.0}]
    swept = tomllib.loads(study_file(ARRAY, RANGES, FIGURES, designs=8, limits={**limits, "volume": 1.0}))
    assert swept["metrics"] == [*FIGURES, "cost", "verdict"]
    with refused(Kind.UNKNOWN, "metrics", value="beauty"):
        limits_of({"beauty": 1.0})
    with refused(Kind.OUT_OF_RANGE, "limit of cost"):
        limits_of({"cost": float("nan")})


def test_designs_that_break_a_limit_are_on_no_front_and_failed_ones_have_their_place() -> None:
    values = np.array([1.0, 2.0, 3.0, 4.0])
    table = ResultTable(
        title="mine",
        description="",
        source="sweep",
        fidelity="atlas",
        frequency=np.array([1.0]),
        open_base=lambda: ARRAY,
        number=np.arange(4),
        parameters=(
            Column("tube.length", "tube.length", "mm", 10 * values),
            Column("membrane.material", "membrane.material", "", np.array([0.0, 1.0, 0.0, 1.0]), ("soft", "hard")),
        ),
        metrics=(
            Column("bandwidth", "bandwidth", "Hz", values, better="larger"),
            Column("cost", "cost", "USD", values, better="smaller"),
        ),
        failures=(("too long", 2),),
        waiting=0,
        base_metrics={},
    )
    failed = (
        FailedDesign(7, "too long", {"tube.length": 55, "membrane.material": "hard"}),
        FailedDesign(8, "too long", {"tube.length": 66, "membrane.material": "glass"}),
    )
    shown = study_figures(FoundDesigns(table, failed), {"cost": 3.0})
    assert shown["kept"] == [True, True, True, False]
    assert shown["limits"] == ["cost at most 3 USD"]
    assert shown["fronts"] == [{"first": 0, "second": 1, "rows": [0, 1, 2]}]
    assert [each["values"] for each in shown["failed"]] == [[55.0, 1.0], [66.0, None]]
    everything = study_figures(FoundDesigns(table))
    assert (everything["kept"], everything["limits"], everything["failed"]) == ([True] * 4, [], [])


@pytest.mark.slow
def test_a_sweep_that_was_stopped_goes_on_and_its_figures_are_those_of_its_store(kept: Path) -> None:
    text = study_file(ARRAY, RANGES, FIGURES, designs=32)
    with pytest.raises(Refusal):
        study_so_far(ARRAY, text)

    def stop(line: str) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(ARRAY, text, stop)
    told: list[str] = []
    found = run_study(ARRAY, text, told.append)
    assert told[0].endswith(" of 32 cases")
    store = study_folder(ARRAY, text) / "results.zarr"
    assert store.is_relative_to(kept)
    table, shown = table_of_sweep(open_sweep(store)), study_figures(found)
    for kind, columns in (("parameters", table.parameters), ("metrics", table.metrics)):
        for column, own in zip(columns, shown[kind], strict=True):
            np.testing.assert_allclose(own["values"], column.values, rtol=1e-4)
            assert (own["name"], own["labels"]) == (column.name, list(column.labels))
    for metric, row in zip(table.metrics, shown["effects"], strict=True):
        for parameter, own in zip(table.parameters, row, strict=True):
            assert own["share"] == effect(parameter, metric).share
    (front,) = shown["fronts"]
    far, small = (np.array(each["values"]) for each in shown["metrics"])
    beaten = [
        bool(((far >= f) & (small <= s) & ((far > f) | (small < s))).any()) for f, s in zip(far, small, strict=True)
    ]
    assert front["rows"] == np.flatnonzero(~np.array(beaten)).tolist()
    best = best_designs(store, "distance_smallest", 1)
    design = found.design(int(table.number[best.rows[0]]))
    assert design.tube.length == table.values(best.rows[0])["tube.length"]
    assert isinstance(design.lines[0].points, int)
    with refused(Kind.UNKNOWN, "design", value=99):
        found.design(99)


@pytest.mark.slow
def test_a_search_ends_with_its_best_design(kept: Path) -> None:
    text = study_file(ARRAY, {"tube.length": [9, 18]}, ["distance_smallest"], search=True, designs=4)
    found = run_study(ARRAY, text)
    assert found.table.source == "search"
    best = found.table.best("distance_smallest", 1)[0]
    assert found.design(int(found.table.number[best])).tube.length == found.table.values(best)["tube.length"]
