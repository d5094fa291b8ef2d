"""Sweeps: right values, whole stores, the same ones after an interruption; failures that stop nothing."""

from __future__ import annotations

import errno
import gc
import json
import re
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from bores_study import CELLS, METRICS_OF_STUDY, TEXT
from refusals import refused
from stores import assert_same_store
from typer.testing import CliRunner

import acoustic_fem
from acoustic_fem.cell import design_cells, one_cell
from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.numerics import disk_cache
from acoustic_fem.quantities.medium import Medium
from geometry.air.cells import Cell
from geometry.ground.refusal import Kind, Refusal
from studies.cli.app import app
from studies.metrics.shared import SharedFigures
from studies.study.cases import Cases, by_kind, cases_of
from studies.study.metric_registry import METRICS
from studies.study.parameter import StudyError
from studies.study.study import Study, read_study
from studies.sweep import block, records, run
from studies.sweep.one_design import design_metrics
from studies.sweep.progress import Progress
from studies.sweep.records import BlockResult, Records, block_size
from studies.sweep.results import open_sweep
from studies.sweep.retries import ENDED_WORKERS, solved_blocks
from studies.sweep.run import run_sweep
from studies.sweep.summary import Summary
from studies.sweep.workers import Workers, open_workers


@pytest.fixture(scope="module")
def finished(study: Study, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Summary]:
    out = tmp_path_factory.mktemp("sweep") / "results.zarr"
    return out, run_sweep(study, out, workers=1).summary


# -- values -----------------------------------------------------------------------------------------
def test_every_case_has_the_metrics_of_its_design_solved_alone(study: Study, finished: tuple[Path, Summary]) -> None:
    result = open_sweep(finished[0])
    assert result.metrics == METRICS_OF_STUDY
    for number in np.flatnonzero(result.done)[:6]:
        library = acoustic_fem.solve(result.design(number), study.frequency, "lumped")
        for name in METRICS_OF_STUDY:
            assert float(result.to_xarray()[name][number]) == pytest.approx(
                METRICS[name].of_library(library), rel=1e-6, abs=0
            )
        count = library.design.point_count
        stored = result.to_xarray()["transfer_function"][number]
        np.testing.assert_allclose(stored[:count], library.transfer_function, rtol=1e-7)
        assert np.isnan(stored[count:]).all()


def test_a_case_that_is_no_design_is_kept_as_failed_with_its_reason(finished: tuple[Path, Summary]) -> None:
    out, summary = finished
    result = open_sweep(out)
    failed = np.flatnonzero(result.failed)
    assert 0 < len(failed) < 40
    assert result.done.sum() + len(failed) == 40
    for number in failed:
        case = result.case(int(number))
        assert case["tube.inner_diameter"] > 0.74
        assert re.search(r"tube\.\w+ = .* mm must be", str(result.to_xarray()["reason"].values[number]))
        for name in METRICS_OF_STUDY:
            assert np.isnan(result.to_xarray()[name].values[number])
    assert sorted(number for numbers in summary.failures.values() for number in numbers) == list(failed)
    for number in np.flatnonzero(result.done):
        assert result.to_xarray()["reason"].values[number] == ""


def test_the_store_opens_in_xarray_with_units_and_carries_its_study(
    finished: tuple[Path, Summary], study: Study
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        dataset = xr.open_zarr(finished[0])
        responses = xr.open_zarr(finished[0], group="responses")
    assert dict(dataset.sizes) == {"case": 40}
    assert set(dataset.coords) == {"case", "split", *cases_of(study).names}
    assert len(dataset.to_dataframe()) == 40
    assert dict(responses.sizes) == {"case": 40, "point": 12, "microphone": 2, "frequency": 12}
    assert dataset["tube.length"].attrs["units"] == "mm"
    assert dataset["distance_smallest"].attrs == {
        "kind": "metric",
        "units": METRICS["distance_smallest"].unit,
        "long_name": METRICS["distance_smallest"].long_name,
    }
    assert dataset.attrs["study"] == TEXT
    assert dataset.attrs["seed"] == 0
    assert open_sweep(finished[0]).base == study.base.completed()
    np.testing.assert_array_equal(dataset["tube.length"].values, cases_of(study).columns[1])


def test_the_store_and_what_is_read_from_it_can_be_written_as_netcdf(
    finished: tuple[Path, Summary], tmp_path: Path
) -> None:
    for name, dataset in (("store", xr.open_zarr(finished[0])), ("read", open_sweep(finished[0]).to_xarray())):
        assert all(isinstance(value, (str, int, float)) for value in dataset.attrs.values())
        path = tmp_path / f"{name}.nc"
        dataset.to_netcdf(path, engine="h5netcdf", invalid_netcdf=False)
        again = xr.open_dataset(path, engine="h5netcdf")
        assert again.attrs == dataset.attrs
        np.testing.assert_array_equal(again["distance_smallest"], dataset["distance_smallest"])
        assert name == "read" or "numpy" in json.loads(again.attrs["libraries"])


def test_air_that_differs_from_case_to_case_is_each_cases_own(tmp_path: Path) -> None:
    text = TEXT.split("[vary]")[0].replace("cases = 40", "cases = 5") + (
        '[vary]\n"air.temperature" = [0, 20, 40]\n"tube.length" = {from = 12, to = 20}\n'
    )
    study = read_study(text)
    run_sweep(study, tmp_path / "r.zarr", workers=1)
    result = open_sweep(tmp_path / "r.zarr")
    for number in range(5):
        library = acoustic_fem.solve(result.design(number), study.frequency, "lumped")
        expected = METRICS["distance_smallest"].of_library(library)
        assert float(result.to_xarray()["distance_smallest"][number]) == pytest.approx(expected, rel=1e-6, abs=0)


def test_a_stretched_membrane_with_loss_is_computed_alone(tmp_path: Path) -> None:
    """The batch cannot hold it; the sweep does not mind."""
    text = TEXT.split("[vary]")[0].replace('"random"\ncases = 40', '"grid"') + (
        '[vary]\n"membrane.stretch" = [1.0, 1.2]\n'
    )
    study = read_study(text)
    run_sweep(study, tmp_path / "r.zarr", workers=1)
    result = open_sweep(tmp_path / "r.zarr")
    assert result.done.all()
    library = acoustic_fem.solve(result.design(1), study.frequency, "lumped")
    expected = METRICS["distance_smallest"].of_library(library)
    assert float(result.to_xarray()["distance_smallest"][1]) == pytest.approx(expected, rel=1e-9, abs=0)


# -- interruptions ----------------------------------------------------------------------------------
class _Killed(BaseException):
    pass


@pytest.mark.slow
@pytest.mark.parametrize("after", [0, 1, 5])
def test_a_sweep_that_was_cut_off_goes_on_to_the_same_store(
    after: int, study: Study, finished: tuple[Path, Summary], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "results.zarr"
    write = Records.write
    written = 0

    def write_some(self: Records, result: BlockResult, sums: Mapping[str, str]) -> None:
        nonlocal written
        if written == after:  # the block's transfer functions are there, its metrics are not
            raise _Killed
        written += 1
        write(self, result, sums)

    monkeypatch.setattr(Records, "write", write_some)
    with pytest.raises(_Killed):
        run_sweep(study, out, workers=1)
    # files that were being written
    (out / "volume" / "c").mkdir(exist_ok=True)
    for half in (out / "volume" / "c" / "0.partial", out / "records" / ".000003.1.metrics"):
        half.write_bytes(b"half")
    monkeypatch.setattr(Records, "write", write)
    assert (open_sweep(out).values["state"] == 0).sum() == 40 - after * block_size(study, cases_of(study))
    summary = run_sweep(study, out, workers=1).summary
    assert summary.computed == 40 - after * block_size(study, cases_of(study))
    assert_same_store(out, finished[0])


def test_a_finished_sweep_is_not_computed_again(study: Study, finished: tuple[Path, Summary]) -> None:
    summary = run_sweep(study, finished[0], workers=1).summary
    assert (summary.computed, summary.cases) == (0, 40)
    assert summary.failures == finished[1].failures


def test_nobody_elses_folder_is_touched(study: Study, tmp_path: Path) -> None:
    (tmp_path / "mine.zarr").mkdir()
    (tmp_path / "mine.zarr" / "letter.txt").write_text("dear")
    with pytest.raises(StudyError) as refused:
        run_sweep(study, tmp_path / "mine.zarr", workers=1)
    assert (refused.value.kind, refused.value.file) == (Kind.MISMATCH, str(tmp_path / "mine.zarr"))
    (tmp_path / "file").write_text("")
    with pytest.raises(Refusal, match="out must be a folder"):
        run_sweep(study, tmp_path / "file", workers=1)
    assert [entry.name for entry in (tmp_path / "mine.zarr").iterdir()] == ["letter.txt"]


def test_two_sweeps_do_not_write_to_one_store(study: Study, tmp_path: Path) -> None:
    def start_another(_: Progress) -> None:
        with pytest.raises(StudyError, match="another sweep is writing"):
            run_sweep(study, tmp_path / "r.zarr", workers=1)

    run_sweep(study, tmp_path / "r.zarr", workers=1, progress=start_another)
    assert open_sweep(tmp_path / "r.zarr").done.any()


# -- failures ---------------------------------------------------------------------------------------
def test_a_metric_that_fails_for_one_design_fails_that_case_only(
    study: Study, finished: tuple[Path, Summary], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = open_sweep(finished[0])
    victim = int(np.flatnonzero(whole.done)[7])
    length = whole.case(victim)["tube.length"]
    volume = METRICS["volume"]

    def picky(figures: SharedFigures) -> np.ndarray:
        if any(design.tube.length == length for design in figures.responses.designs or ()):
            raise ArithmeticError("too long")
        return volume.compute(figures)

    monkeypatch.setitem(METRICS, "volume", replace(volume, compute=picky))
    run_sweep(study, tmp_path / "r.zarr", workers=1)
    result = open_sweep(tmp_path / "r.zarr")
    assert result.done.sum() == whole.done.sum() - 1
    assert str(result.to_xarray()["reason"].values[victim]) == "metric volume: ArithmeticError: too long"
    others = result.done
    np.testing.assert_array_equal(
        result.to_xarray()["volume"].values[others], whole.to_xarray()["volume"].values[others]
    )


def test_a_mistake_of_the_program_is_no_property_of_a_design(
    tmp_path: Path, finished: tuple[Path, Summary], monkeypatch: pytest.MonkeyPatch
) -> None:
    volume = METRICS["volume"]

    def mistaken(figures: SharedFigures) -> np.ndarray:
        if any(design.point_count == 6 for design in figures.responses.designs or ()):
            raise KeyError("six")
        return volume.compute(figures)

    monkeypatch.setitem(METRICS, "volume", replace(volume, compute=mistaken))
    (tmp_path / "study.toml").write_text(TEXT)
    out = tmp_path / "r.zarr"
    told = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--out", str(out)])
    whole, result = open_sweep(finished[0]), open_sweep(out)
    wrong = whole.done & (whole.to_xarray()["lines.0.points"].values == 6)
    assert 0 < wrong.sum() < whole.done.sum()
    np.testing.assert_array_equal(result.done, whole.done & ~wrong)
    for reason in result.to_xarray()["reason"].values[wrong]:
        here = re.escape(Path(__file__).name)
        assert re.fullmatch(rf"program error: metric volume: KeyError in {here}:\d+: 'six'", str(reason))
    assert told.exit_code == 1
    assert isinstance(told.exception, run.SweepError)
    assert f"{wrong.sum()} cases (the first is {np.flatnonzero(wrong)[0]}) failed by a mistake" in str(told.exception)
    assert "x program error: metric volume: KeyError" in told.stdout
    told_once = [event for event in events(out) if event["event"] == "mistake"]
    assert 0 < len(told_once) <= 16  # blocks
    for event in told_once:
        assert event["traceback"].startswith("Traceback (most recent call last):\n")
        assert f'{Path(__file__).name}", line ' in event["traceback"]
        assert event["traceback"].endswith("KeyError: 'six'\n")
    with open_workers(1, None) as team, pytest.raises(RuntimeError, match="program error: metric volume: KeyError"):
        design_metrics([{"lines.0.points": 6}], read_study(TEXT), (METRICS["volume"],), team)


def events(out: Path) -> list[dict[str, Any]]:
    """Entries of the log."""
    return [json.loads(line) for line in out.with_name(f"{out.name}.log").read_text().splitlines()]


@pytest.mark.parametrize("workers", [1, pytest.param(2, marks=pytest.mark.slow)])
@pytest.mark.parametrize("lack", [OSError(errno.ENOSPC, "No space left on device"), MemoryError("Unable to allocate")])
def test_a_machine_that_lacks_disk_or_memory_fails_no_case_and_ends_the_sweep_in_one_line(
    lack: Exception, workers: int, study: Study, finished: tuple[Path, Summary], tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    out, full = tmp_path / "results.zarr", tmp_path / "full"
    full.touch()
    monkeypatch.setattr(run, "solved_blocks", partial(lacking, full, lack))
    with pytest.raises(run.SweepError) as ended:
        run_sweep(study, out, workers=workers)
    assert (ended.value.kind, ended.value.file) == (Kind.STOPPED, str(out))
    assert "No space left" in str(ended.value) or "not enough memory (Unable to allocate)" in str(ended.value)
    assert str(ended.value).endswith("finished cases are kept, run again to continue")
    state = open_sweep(out).values["state"]
    assert 0 < (state == 0).sum() < 40
    assert not open_sweep(out).failed[(state != 0) & ~open_sweep(finished[0]).failed].any()
    assert "Traceback" in next(event for event in events(out) if event["event"] == "stopped")["traceback"]
    full.unlink()
    assert run_sweep(study, out, workers=1).summary.computed == (state == 0).sum()
    assert_same_store(out, finished[0])


def lacking(full: Path, lack: Exception, team: Workers, job: block.Job, cases: Cases, *rest: Any) -> Iterator[Any]:
    """Blocks of a machine that lacks something from the tenth case on, for as long as a file is there."""
    starved = Starved(cases.base, cases.names, cases.columns)
    starved.full, starved.lack = full, lack
    return solved_blocks(team, job, starved, *rest)


class Starved(Cases):
    """Cases whose designs are built where disk or memory does not suffice."""

    full: Path
    lack: Exception

    def part(self, first: int, stop: int) -> Cases:
        found = Starved(self.base, self.names, tuple(column[first:stop] for column in self.columns))
        found.full, found.lack = self.full, self.lack
        return found if first >= 10 else Cases(found.base, found.names, found.columns)

    def design(self, number: int) -> Any:
        if self.full.exists():
            raise self.lack
        return super().design(number)


def test_metrics_that_the_frequencies_cannot_give_are_refused_before_any_work(tmp_path: Path) -> None:
    text = TEXT.replace('"1:100:12"', '"150:200:5"')
    with refused(Kind.UNSUITABLE, "frequency", file="study.toml", error=StudyError):
        run_sweep(read_study(text), tmp_path / "r.zarr", workers=1)
    assert list(tmp_path.iterdir()) == []


# -- 3-D cells --------------------------------------------------------------------------------------


def test_every_distinct_cell_is_solved_once_and_one_that_fails_takes_its_own_cases_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The 3-D solution is replaced: what is tested is who asks for it, and how often."""
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cache"))
    asked: list[Cell] = []

    def solve_cells(
        cells: list[Cell], frequency: np.ndarray, medium: Medium, fidelity: str, *, apart: bool
    ) -> dict[Cell, object]:
        from acoustic_fem.cell.lumped import lumped_admittance

        assert apart  # a crash of the solver is that cell's alone
        (cell,) = cells
        asked.append(cell)
        if cell.kind == "resonator" and cell.height == 3.0 and len({port.bore_diameter for port in cell.ports}) == 1:
            raise one_cell.CellError(f"{cell.label}: no mesh", kind=Kind.OUT_OF_RANGE)
        admittance = lumped_admittance(cell, frequency, medium)
        return {cell: one_cell.CellSolution(admittance, fidelity, 1, (), 0.0, 0.0, 1.0, cached=False)}

    monkeypatch.setattr(block, "solve_cells", solve_cells)
    study = read_study(CELLS)
    summary = run_sweep(study, tmp_path / "r.zarr", workers=1).summary
    assert len(asked) == len(set(asked)) == summary.cells
    assert summary.cells_solved == sum(1 for cell in asked if cell.height != 3.0)
    result = open_sweep(tmp_path / "r.zarr")
    tall = result.to_xarray()["resonator.cavity_height"].values == 3.0
    np.testing.assert_array_equal(result.failed, tall)
    assert all("no mesh" in str(reason) for reason in result.to_xarray()["reason"].values[tall])
    lumped = acoustic_fem.solve(result.design(0), study.frequency, "lumped")
    expected = METRICS["distance_smallest"].of_library(lumped)
    assert float(result.to_xarray()["distance_smallest"][0]) == pytest.approx(expected, rel=1e-6, abs=0)


# -- command line -----------------------------------------------------------------------------------


def test_the_verb_says_what_it_did_and_goes_on(tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(TEXT)
    out = tmp_path / "results.zarr"
    first = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--out", str(out)])
    assert first.exit_code == 0, first.output
    assert "40 cases, 40 computed now" in first.stdout
    assert re.search(r"\d+ failed, the first of each kind:\n +\d+ x array-2x6: ", first.stdout)
    assert "40 of 40 cases" in first.stderr
    again = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--out", str(out)])
    assert "40 cases, 0 computed now" in again.stdout
    assert "40 by earlier runs" in again.stdout
    events = [json.loads(line)["event"] for line in (tmp_path / "results.zarr.log").read_text().splitlines()]
    assert events.count("start") == events.count("end") == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "--out is missing"),
        (["--out", "r.zarr", "--workers", "0"], "--workers 0 must be between 1 and 1024"),
        (["--out", "r.zarr", "--workers", "2", "--scheduler", "tcp://x:1"], "cannot be given with --scheduler"),
    ],
)
def test_a_wrong_command_line_is_refused(arguments: list[str], message: str, tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(TEXT)
    result = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), *arguments])
    assert result.exit_code == 2
    assert message in " ".join(result.output.replace("│", " ").split())


def test_a_block_leaves_no_circles_of_objects_and_the_search_for_them_as_it_was(study: Study) -> None:
    cases, job = cases_of(study), block.Job("lumped", study.frequency, study.metrics, "responses")
    block.solve_block(job, cases, 0, {})  # all modules are loaded
    gc.collect()
    gc.disable()
    try:
        block.solve_block(job, cases, 0, {})
        assert not gc.isenabled()
        assert gc.collect() < len(cases)  # else they would pile up while a block is computed
    finally:
        gc.enable()
    block.solve_block(job, cases.part(0, 1), 0, {})
    assert gc.isenabled()


@pytest.mark.parametrize(("cases", "blocks"), [(10_000, 40), (100_000, 388), (4096, 16)])
def test_blocks_can_be_shared_by_two_or_four_workers(study: Study, cases: int, blocks: int) -> None:
    many = read_study(TEXT.replace("cases = 40", f"cases = {cases}").replace("1:100:12", "1:100:64"))
    size = block_size(many, cases_of(many))
    assert -(-cases // size) == blocks
    assert blocks % 4 == 0


def test_blocks_depend_on_the_study_alone(study: Study) -> None:
    cases = cases_of(study)
    size = block_size(study, cases)
    assert size == block_size(read_study("# the same\n" + TEXT), cases)
    assert 1 <= size <= 1024


def test_reasons_that_differ_in_numbers_alone_are_one_kind() -> None:
    reasons = [
        "a: bore = 0.7 mm must be below 0.5 mm",
        "program error: x in a.py:3: y",
        "a: bore = 0.8 mm must be below 0.5 mm",
        "program error: x in a.py:4: y",
        "no mesh",
    ]
    assert by_kind(enumerate(reasons, 10)) == {
        reasons[0]: [10, 12],
        reasons[1]: [11],
        reasons[3]: [13],
        "no mesh": [14],
    }


def test_failures_of_one_kind_are_told_in_one_line(finished: tuple[Path, Summary]) -> None:
    result = open_sweep(finished[0])
    failed = np.flatnonzero(result.failed)
    assert len(set(result.to_xarray()["reason"].values[failed])) == len(failed) == 2
    assert len(finished[1].failures) == 1
    for reason, numbers in finished[1].failures.items():
        assert reason == result.to_xarray()["reason"].values[numbers[0]]


class _Fragile:
    """Workers that end over blocks with certain cases in them, as a dask cluster tells it."""

    notes: Iterable[str] = ()

    def __init__(self, deadly: set[int]) -> None:
        self.deadly = deadly

    def run(
        self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]], lost: Callable[..., Any] | None = None
    ) -> Iterator[tuple[int, Any]]:
        for number, (job, cases, first, cells) in enumerate(tasks):
            if self.deadly & set(range(first, first + len(cases))):
                assert lost is not None
                yield number, lost(job, cases, first, cells)
            else:
                yield number, function(job, cases, first, cells)


@pytest.mark.parametrize("deadly", [{5}, {0, 1, 2, 3}, {4, 6, 39}])
def test_a_case_that_ends_workers_fails_alone(
    deadly: set[int], study: Study, finished: tuple[Path, Summary], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    @contextmanager
    def fragile(count: int | None, scheduler: str | None) -> Iterator[Workers]:
        yield _Fragile(deadly)

    monkeypatch.setattr(run, "open_workers", fragile)
    monkeypatch.setattr(run, "disc_tables", lambda discs, solve: ())
    monkeypatch.setattr(records, "block_size", lambda study, cases: 8)
    summary = run_sweep(study, tmp_path / "r.zarr", workers=2).summary
    whole, result = open_sweep(finished[0]), open_sweep(tmp_path / "r.zarr")
    assert summary.failures[ENDED_WORKERS] == sorted(deadly)
    others = np.array([number not in deadly for number in range(40)])
    np.testing.assert_array_equal(result.done, whole.done & others)
    for name in ("distance_smallest", "transfer_function"):
        np.testing.assert_allclose(
            result.to_xarray()[name].values[others], whole.to_xarray()[name].values[others], rtol=1e-9, atol=1e-15
        )
    assert run_sweep(study, tmp_path / "r.zarr", workers=2).summary.computed == 0


def test_a_cell_in_the_cache_is_known_without_reading_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    (cell, air), *_ = block.cells_of(read_study(TEXT).base)
    assert not design_cells.is_cached(cell, [10.0, 20.0], air)
    key = one_cell.CellTask(cell, air, one_cell.DESIGN_BAND, "navier-stokes").key
    disk_cache.store(key, {}, {})
    assert design_cells.is_cached(cell, [10.0, 20.0], air)
    assert not design_cells.is_cached(cell, [10.0, 20.0], air, "helmholtz")


@pytest.mark.slow
def test_many_membranes_are_interpolated_between_few_that_are_solved(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = TEXT.split("[vary]")[0].replace("cases = 40", "cases = 120") + (
        '[vary]\n"membrane.thickness" = {from = 0.4, to = 0.6}\n'
    )
    study = read_study(text)
    solved: list[object] = []

    def counted(shape: DiscShape) -> ElasticDisc:
        solved.append(shape)
        return solve_dimensionless(shape)

    monkeypatch.setattr(run, "solve_dimensionless", counted)
    run_sweep(study, tmp_path / "r.zarr", workers=1)
    assert 0 < len(solved) < 12
    result = open_sweep(tmp_path / "r.zarr")
    assert result.done.all()
    for number in (0, 119):
        library = acoustic_fem.solve(result.design(number), study.frequency, "lumped")
        for name, accuracy in (("distance_smallest", 2e-4), ("sensitivity_force", 4e-4)):
            expected = METRICS[name].of_library(library)
            assert float(result.to_xarray()[name][number]) == pytest.approx(expected, rel=accuracy, abs=0)
