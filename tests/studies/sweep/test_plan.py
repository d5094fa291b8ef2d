"""The cost of a sweep is printed before any work, and workers are taken where they save more than their start."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from bores_study import CELLS, TEXT
from refusals import refused
from typer.testing import CliRunner

from acoustic_fem.membrane.solved_discs import solved_disc
from geometry.ground.refusal import Kind, Refusal
from studies.cli.app import app
from studies.output.display import Display
from studies.study.cases import cases_of
from studies.study.study import read_study
from studies.sweep import block, cost, plan, run, survey
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
@pytest.mark.slow
def test_a_sweep_and_its_plan_take_workers_where_they_save_more_than_their_start(
    start_up: float, workers: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = read_study(TEXT.replace("cases = 40", "cases = 600"))

    def asked(count: int | None, scheduler: str | None) -> Iterator[Workers]:
        raise _Asked(count)

    monkeypatch.setattr(cost, "cores", lambda: 2)
    monkeypatch.setattr(cost, "START_UP", start_up)
    monkeypatch.setattr(run, "open_workers", asked)
    planned = plan_sweep(study)
    assert planned.workers == workers
    assert planned.seconds >= start_up * (workers > 1)
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


@pytest.mark.parametrize("fidelity", ["lumped", "navier-stokes"])
def test_a_dry_run_of_a_study_without_a_buildable_case_says_so(fidelity: str, tmp_path: Path) -> None:
    text = CELLS.replace("navier-stokes", fidelity).split("[vary]")[0]
    (tmp_path / "study.toml").write_text(text + '[vary]\n"tube.length" = [0.5, 0.6, 0.7]\n')
    result = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--dry-run"])
    assert result.exit_code == 0, result.output
    assert "not valid: 3, which" in result.stdout
    found = plan_sweep(tmp_path / "study.toml")
    assert (found.cases, sum(found.refused.values()), found.cells, found.sampled) == (3, 3, 0, 0)


LARGE = """
base = "array-2x6"
fidelity = "navier-stokes"
frequency = "1:100:4"
metrics = ["distance_smallest"]
stock = "off"
[vary]
"tube.length" = {from = 8, to = 40, step = 0.1}
"tube.inner_diameter" = [0.3, 0.35, 0.4, 0.45]
"""


@pytest.mark.parametrize("sampling", ["grid", "random", "sobol", "latin-hypercube"])
@pytest.mark.slow
def test_the_plan_of_a_large_study_is_estimated_from_a_sample(sampling: str, monkeypatch: pytest.MonkeyPatch) -> None:
    head = "" if sampling == "grid" else f'sampling = "{sampling}"\ncases = 1284\n'
    study = read_study(head + 'constraints = ["tube.length > 20 * tube.inner_diameter"]\n' + LARGE)
    whole = plan_sweep(study)
    monkeypatch.setattr(plan, "MOST_SURVEYED", 300)
    sampled = plan_sweep(study)
    assert (whole.sampled, sampled.sampled) == (0, 300)
    assert sampled.cases + sampled.left_out == whole.cases + whole.left_out == 1284
    assert sampled.cases == pytest.approx(whole.cases, rel=0.05)
    assert sum(sampled.refused.values()) == pytest.approx(sum(whole.refused.values()), rel=0.3)
    assert whole.cells <= sampled.cells <= 1.2 * whole.cells
    assert sampled.storage == pytest.approx(whole.storage, rel=0.05)


def test_a_plan_reports_how_far_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(survey, "_OFTEN", 0.0)
    study, told = read_study(CELLS), []
    survey.surveyed(study, every=True, progress=told.append)
    assert {(each.what, each.total) for each in told} == {("designs", 24)}
    assert [each.done for each in told] == list(range(24))
    shown = io.StringIO()
    plan_sweep(study, display=Display(shown))
    assert "Plan: 0 of 24 designs" in shown.getvalue()


def test_ten_million_cases_are_planned_without_drawing_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plan, "MOST_SURVEYED", 50)
    ranges = "\n".join(
        f'"{name}" = {{from = {low}, to = {high}, count = 100}}'
        for name, low, high in (("tube.length", 8, 40), ("membrane.rim_width", 1.0, 2.0))
    )
    text = f'{LARGE.split("[vary]")[0]}[vary]\n{ranges}\n"resonator.cavity_height" = '
    found = plan_sweep(read_study(text + "{from = 2.0, to = 12.0, count = 1000}\n"))
    assert (found.cases, found.sampled) == (10_000_000, 50)


def test_a_sample_without_a_case_that_meets_the_constraints_says_that_it_is_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(plan, "MOST_SURVEYED", 20)
    study = read_study('constraints = ["tube.length > 1000 * tube.inner_diameter"]\n' + LARGE)
    with refused(Kind.CONFLICT, "constraints") as found:
        plan_sweep(study)
    assert "none of 20 cases drawn at random from 1284" in str(found.value)


@pytest.mark.parametrize(("values", "said"), [("[9, 10]", True), ("{from = 9, to = 30}", False)])
def test_samples_with_equal_cases_are_said_by_plan_and_sweep(values: str, said: bool, tmp_path: Path) -> None:
    head = LARGE.split("[vary]")[0].replace("navier-stokes", "lumped").replace("1:100:4", "1:100:12")
    study = read_study(f'sampling = "random"\ncases = 6\n{head}[vary]\n"tube.length" = {values}\n')
    words = "4 of 6 cases repeat the values of an earlier one"
    assert (plan_sweep(study).note == words) == said
    assert (words in run_sweep(study, tmp_path / "r.zarr", workers=1).summary.notes) == said


class _Asked(Exception):
    """How many workers a sweep asked for."""


@pytest.mark.slow
def test_membranes_are_part_of_the_cost_unless_they_are_on_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All of them if libraries are kept, and otherwise those of a table."""
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    text = TEXT.split("[vary]")[0].replace("cases = 40", "cases = 128")
    text += '[vary]\n"membrane.thickness" = {from = 0.4, to = 0.8}\n'
    few = read_study(text.replace('keep = "responses"', 'keep = "metrics"'))
    every = read_study(text.replace('keep = "responses"', 'keep = "libraries"'))
    discs = survey.surveyed(every).discs
    count = len(discs)
    assert count > 120
    seconds = cost.seconds_of_discs(every, 128, discs)
    assert count * 0.01 < seconds < count * 0.5
    assert seconds == pytest.approx(2 * cost.seconds_of_discs(every, 64, discs[: count // 2]), rel=0.1)
    assert cost.seconds_of_discs(few, 128, discs) < seconds / 8
    assert cost.seconds_of_discs(every, 128, discs, 0.01) == pytest.approx(100 * seconds)
    assert cost.seconds_of_discs(every, 1000, discs, 0.01) == seconds  # the others have those too
    for disc in discs[:32]:
        solved_disc.__wrapped__(disc)
    assert cost.seconds_of_discs(every, 128, discs) == pytest.approx(seconds * (1 - 32 / count))
    assert cost.seconds_of_discs(every, 128, ()) == 0
