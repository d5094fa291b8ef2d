"""The cost of a sweep is printed before any work, and workers are taken where they save more than their start."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from bores_study import TEXT
from typer.testing import CliRunner

from geometry.ground.refusal import Kind, Refusal
from studies.cli.app import app
from studies.study.cases import cases_of
from studies.study.study import read_study
from studies.sweep import block, cost, run
from studies.sweep.plan import plan_sweep
from studies.sweep.run import run_sweep
from studies.sweep.workers import Workers


def test_a_dry_run_says_what_it_will_cost_and_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cache"))
    (tmp_path / "study.toml").write_text(CELLS)
    result = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--dry-run", "--workers", "2"])
    assert result.exit_code == 0, result.output
    assert "cases: 24" in result.stdout
    cells = {cell for number in range(24) for cell in block.cells_of(cases_of(read_study(CELLS)).design(number))}
    assert f"distinct cells (navier-stokes): {len(cells)}, of which 0 are in the cache" in result.stdout
    assert re.search(r"expected time: \S+ (s|min|h) with 2 workers", result.stdout)
    assert {entry.name for entry in tmp_path.iterdir()} - {"cache"} == {"study.toml"}
    assert plan_sweep(read_study(CELLS)).cells_cached == 0  # discs may be there


@pytest.mark.parametrize(("count", "told"), [(40, True), (64, False)])
def test_a_dry_run_says_that_a_sobol_sample_is_not_balanced(count: int, told: bool, tmp_path: Path) -> None:
    text = TEXT.replace('"random"\ncases = 40', f'"sobol"\ncases = {count}')
    (tmp_path / "study.toml").write_text(text)
    result = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--dry-run"])
    assert result.exit_code == 0, result.output
    assert ("note: a Sobol sample of 40 cases is not balanced; one of 32 or 64 is" in result.stdout) == told


@pytest.mark.parametrize(("start_up", "workers"), [(10.0, 1), (0.0, 2)])
def test_a_sweep_and_its_plan_take_workers_where_they_save_more_than_their_start(
    start_up: float, workers: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = read_study(TEXT.replace("cases = 40", "cases = 600"))

    def asked(count: int | None, scheduler: str | None) -> Iterator[Workers]:
        raise _Asked(count)

    monkeypatch.setattr(cost, "cores", lambda: 2)
    monkeypatch.setattr(cost, "START_UP", start_up)
    monkeypatch.setattr(run, "open_workers", asked)
    plan = plan_sweep(study)
    assert plan.workers == workers
    assert plan.seconds >= start_up * (workers > 1)
    with pytest.raises(_Asked, match=f"^{workers}$"):
        run_sweep(study, tmp_path / "r.zarr")
    assert plan_sweep(study, 2).seconds > start_up
    with pytest.raises(_Asked, match=r"^2$"):
        run_sweep(study, tmp_path / "r.zarr", workers=2)


def test_a_case_that_cannot_be_timed_stops_no_plan(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(design: object) -> None:
        raise Refusal("no such membrane", kind=Kind.OUT_OF_RANGE)

    monkeypatch.setattr(cost, "design_disc", refused)
    assert plan_sweep(read_study(TEXT)).seconds >= 0


def test_costly_cases_are_worth_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "cores", lambda: 4)
    assert [cost.team_size(seconds) for seconds in (1.0, 10.0, 60.0, 1e5)] == [1, 1, 4, 4]
    monkeypatch.setattr(cost, "cores", lambda: 1)
    assert cost.team_size(1e5) == 1


class _Asked(Exception):
    """How many workers a sweep asked for."""


CELLS = """
base = "array-2x6"
fidelity = "navier-stokes"
frequency = "1:100:4"
metrics = ["distance_smallest"]
[vary]
"resonator.cavity_height" = [2.5, 3.0]
"tube.length" = [12.5, 14, 15, 16, 18, 20]
"membrane.thickness" = [0.5, 0.6]
"""
