"""Sweeps over real processes: workers and whole runs killed, and the store is still the same to the last bit."""

from __future__ import annotations

import contextlib
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from stores import assert_same_store

from geometry import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from studies.study.cases import Cases
from studies.study.parameter import StudyError
from studies.study.study import Study, load_study, read_study
from studies.sweep import processes, survey
from studies.sweep.cluster import WorkersLost
from studies.sweep.results import open_sweep
from studies.sweep.retries import ENDED_WORKERS
from studies.sweep.run import run_sweep
from studies.sweep.workers import open_workers

STUDY = """
base = "array-2x6"
fidelity = "lumped"
stock = "off"
metrics = ["distance_smallest", "predicted_top1_white_noise"]
sampling = "latin-hypercube"
cases = 160
seed = 5
keep = "responses"
[vary]
"tube.inner_diameter" = {from = 0.3, to = 0.76}
"tube.length" = {from = 8, to = 30}
"resonator.cavity_height" = {from = 1.8, to = 5}
"""
BLOCKS = 16
ROOT = Path(__file__).parents[3]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT)}
PATIENCE = 600  # s, on a machine that is busy with other tests


@pytest.fixture(scope="module")
def uninterrupted(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The study file, and its store made in one go by one process."""
    folder = tmp_path_factory.mktemp("uninterrupted")
    (folder / "study.toml").write_text(STUDY)
    summary = run_sweep(load_study(folder / "study.toml"), folder / "results.zarr", workers=1).summary
    assert 0 < sum(len(numbers) for numbers in summary.failures.values()) < 80
    return folder / "study.toml", folder / "results.zarr"


def start(*arguments: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-m", *arguments],
        env=ENVIRONMENT,
        cwd=ROOT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def blocks(out: Path) -> int:
    """Blocks that the runs so far have written."""
    log = out.with_name(out.name + ".log")
    if not log.exists():
        return 0
    return sum('"block"' in line for line in log.read_text().splitlines())


def wait_for(condition: Callable[[], object], process: subprocess.Popen[bytes] | None = None) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "waited too long"
        assert process is None or process.poll() is None, "the sweep ended by itself"
        time.sleep(0.02)


def start_and_kill(arguments: tuple[str, ...], out: Path, moment: int) -> None:
    """Kill a sweep of two workers when so many blocks are done, and wait until its workers have gone."""
    run = start(*arguments)
    wait_for(lambda: blocks(out) >= moment, run)
    helpers = psutil.Process(run.pid).children(recursive=True)
    run.send_signal(signal.SIGKILL)
    run.wait()
    assert len(helpers) >= 2
    assert (open_sweep(out).values["state"] == 0).any(), "the sweep was done before it was killed"
    wait_for(lambda: not any(alive(helper) for helper in helpers))


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """Address of a scheduler on loopback, and its two workers."""
    file = tmp_path / "scheduler.json"
    scheduler = start(
        "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
        "--scheduler-file", str(file),
    )  # fmt: skip
    workers: list[subprocess.Popen[bytes]] = []
    try:
        wait_for(file.exists, scheduler)
        address = json.loads(file.read_text())["address"]
        workers += [
            start("distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
                  "--host", "127.0.0.1", "--local-directory", str(tmp_path / f"worker-{number}"))
            for number in range(2)
        ]  # fmt: skip
        yield address, workers
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


@pytest.mark.slow
def test_a_worker_that_is_killed_in_mid_sweep_changes_nothing(
    uninterrupted: tuple[Path, Path], cluster: tuple[str, list[subprocess.Popen[bytes]]], tmp_path: Path
) -> None:
    study, expected = uninterrupted
    address, workers = cluster
    out = tmp_path / "results.zarr"
    run = start("studies.cli", "sweep", str(study), "--out", str(out), "--scheduler", address)
    try:
        wait_for(lambda: blocks(out) >= 2, run)
        workers[0].send_signal(signal.SIGKILL)
        workers[0].wait()
        assert blocks(out) < BLOCKS, "the sweep was done before the worker was killed"
        assert run.wait(PATIENCE) == 0
    finally:
        run.kill()
        run.wait()
    assert blocks(out) == BLOCKS
    assert_same_store(out, expected)


@pytest.mark.slow
def test_a_run_that_is_killed_twice_ends_in_the_same_store(uninterrupted: tuple[Path, Path], tmp_path: Path) -> None:
    study, expected = uninterrupted
    out = tmp_path / "results.zarr"
    arguments = ("studies.cli", "sweep", str(study), "--out", str(out), "--workers", "2")
    for moment in (1, 8):
        start_and_kill(arguments, out, moment)
    run = start(*arguments)
    assert run.wait(PATIENCE) == 0
    assert blocks(out) < BLOCKS + 2 * 2, "blocks that were done were computed again"
    assert_same_store(out, expected)


PAIRS = 7


def begin_together(folder: Path, barrier: Any, told: Any) -> None:
    """In a process of its own: a sweep into each of some stores, begun when the other process begins it too."""
    study = load_study(folder / "study.toml")
    for number in range(PAIRS):
        barrier.wait(PATIENCE)
        try:
            run_sweep(study, folder / f"{number}.zarr", workers=1)
        except StudyError as error:
            told.put((number, str(error)))
        except Exception as error:  # what a second sweep must never see
            told.put((number, repr(error)))
        else:
            told.put((number, "done"))


@pytest.mark.slow
def test_of_two_sweeps_that_begin_at_once_one_computes_and_the_other_is_refused(tmp_path: Path) -> None:
    text = STUDY.replace("cases = 160", "cases = 4").replace(', "predicted_top1_white_noise"', "")
    (tmp_path / "study.toml").write_text(text)
    processes = multiprocessing.get_context("spawn")
    barrier, told = processes.Barrier(2), processes.Queue()
    both = [processes.Process(target=begin_together, args=(tmp_path, barrier, told)) for _ in range(2)]
    for process in both:
        process.start()
    answers: list[list[str]] = [[] for _ in range(PAIRS)]
    for _ in range(2 * PAIRS):
        number, answer = told.get(timeout=PATIENCE)
        answers[number].append(answer)
    for process in both:
        process.join(PATIENCE)
    run_sweep(load_study(tmp_path / "study.toml"), tmp_path / "alone.zarr", workers=1)
    for number, pair in enumerate(answers):
        refused = f"{tmp_path / f'{number}.zarr'}: another sweep is writing to it"
        assert "done" in pair, pair
        assert set(pair) <= {"done", refused}, pair
        assert_same_store(tmp_path / f"{number}.zarr", tmp_path / "alone.zarr")
    assert any(pair != ["done", "done"] for pair in answers)


class DeadlyCases(Cases):
    """Cases of which one ends the worker that computes it; workers are started with ``-c``."""

    def part(self, first: int, stop: int) -> Cases:
        return DeadlyCases(self.base, self.names, tuple(column[first:stop] for column in self.columns))

    def design(self, number: int) -> ArrayDesign:
        if sys.argv[0] == "-c" and self.case(number)["tube.length"] == 13.0:
            os.kill(os.getpid(), signal.SIGKILL)
        return super().design(number)


@pytest.mark.slow
def test_a_case_that_ends_every_worker_fails_and_stops_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    grid = ", ".join(f"{10 + 0.25 * k}" for k in range(32))
    study = read_study(
        f'base = "array-2x6"\nfidelity = "lumped"\nmetrics = ["distance_smallest"]\n[vary]\n"tube.length" = [{grid}]\n'
    )
    run_sweep(study, tmp_path / "whole.zarr", workers=1)

    def deadly(study: Study, drawn: Cases, *_: object) -> Cases:
        return DeadlyCases(drawn.base, drawn.names, drawn.columns)

    monkeypatch.setattr(survey, "kept_cases", deadly)
    summary = run_sweep(study, tmp_path / "r.zarr", workers=2).summary
    assert summary.failures == {ENDED_WORKERS: [12]}
    whole, result = (open_sweep(tmp_path / f"{name}.zarr").to_xarray() for name in ("whole", "r"))
    others = np.arange(32) != 12
    np.testing.assert_allclose(result["distance_smallest"][others], whole["distance_smallest"][others], rtol=1e-12)
    assert run_sweep(study, tmp_path / "r.zarr", workers=2).summary.computed == 0


def alive(process: psutil.Process) -> bool:
    return process.is_running() and process.status() != psutil.STATUS_ZOMBIE


@pytest.mark.slow
def test_a_scheduler_that_does_not_answer_is_named(
    uninterrupted: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("studies.sweep.workers._ANSWER", 1)
    with pytest.raises(Refusal, match=r"no scheduler answers at tcp://127\.0\.0\.1:9"):
        run_sweep(load_study(uninterrupted[0]), tmp_path / "r.zarr", scheduler="tcp://127.0.0.1:9")
    run_sweep(load_study(uninterrupted[0]), tmp_path / "r.zarr", workers=1)
    assert_same_store(tmp_path / "r.zarr", uninterrupted[1])


def refuse(what: str) -> None:
    raise Refusal(f"{what} cannot be had here", kind=Kind.OUT_OF_RANGE)


@pytest.mark.slow
def test_what_a_worker_refuses_is_told_without_its_traceback(capfd: pytest.CaptureFixture[str]) -> None:
    with open_workers(2, None) as team, pytest.raises(Refusal, match=r"^gmsh cannot be had here$"):
        list(team.run(refuse, [("gmsh",)]))
    assert "Traceback" not in capfd.readouterr().err


def number_of_process(hold: str) -> int:
    """Number of the process that runs this, once no file holds it."""
    Path(f"{hold}-{os.getpid()}").touch()
    while Path(hold).exists():
        time.sleep(0.02)
    return os.getpid()


@pytest.mark.slow
def test_a_worker_that_stays_stopped_is_replaced_and_every_task_has_one_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(processes, "SILENCE", 1.0)
    hold = tmp_path / "hold"
    hold.touch()
    with open_workers(2, None) as team:
        results = team.run(number_of_process, ((str(hold),) for _ in range(6)))
        found: list[tuple[int, int]] = []
        reader = threading.Thread(target=lambda: found.extend(results))
        reader.start()
        wait_for(lambda: len(list(tmp_path.glob("hold-*"))) == 2)
        stopped = int(next(tmp_path.glob("hold-*")).name.partition("-")[2])
        os.kill(stopped, signal.SIGSTOP)
        wait_for(lambda: team.notes)
        hold.unlink()
        reader.join(60)
        assert list(team.notes) == [f"worker process {stopped} was stopped for 1 s: another took over its work"]
    assert sorted(number for number, _ in found) == list(range(6))
    assert stopped not in [process for _, process in found]


def end_first(folder: str, number: int) -> int:
    """The number; the first process that is asked ends."""
    with contextlib.suppress(FileExistsError):
        Path(folder, "ended").touch(exist_ok=False)
        os.kill(os.getpid(), signal.SIGKILL)
    return number


@pytest.mark.slow
def test_a_task_whose_worker_ends_is_given_to_another(tmp_path: Path) -> None:
    with open_workers(2, None) as team:
        found = dict(team.run(end_first, ((str(tmp_path), number) for number in range(20))))
    assert found == {number: number for number in range(20)}


def end_always(number: int) -> int:
    """The number; 3 ends its process."""
    if number == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


@pytest.mark.slow
def test_a_task_that_ends_two_workers_is_given_up() -> None:
    with open_workers(2, None) as team:
        found = dict(team.run(end_always, ((number,) for number in range(6)), lost=lambda number: -number))
        assert found == {0: 0, 1: 1, 2: 2, 3: -3, 4: 4, 5: 5}
        with pytest.raises(WorkersLost) as error:
            list(team.run(end_always, ((number,) for number in range(6))))
        assert error.value.kind is Kind.STOPPED


def slow(number: int) -> int:
    """The number, after a while unless it is 0."""
    time.sleep(60 * (number > 0))
    return number


@pytest.mark.slow
def test_a_run_that_is_left_early_keeps_no_worker_busy() -> None:
    begin = time.monotonic()
    with open_workers(2, None) as team:
        for _ in team.run(slow, ((number,) for number in range(5))):
            break
        assert list(team.run(slow, [(0,)])) == [(0, 0)]
    assert time.monotonic() - begin < 50


def cannot_start() -> None:
    raise SystemExit(3)


@pytest.mark.slow
def test_workers_that_cannot_start_end_the_run_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "_give_way", cannot_start)
    with (
        open_workers(2, None) as team,
        pytest.raises(WorkersLost, match=r"^3 workers in a row ended while they started"),
    ):
        list(team.run(slow, [(0,)]))


SCRIPT = """
import os, sys
import studies
from studies.sweep import open_workers

def own(number):
    return number, os.getpid()

with open_workers(2, None) as team:
    assert all(result[0] == number and result[1] != os.getpid() for number, result in team.run(own, [(0,), (1,)]))
summary = studies.run_sweep(studies.load_study(sys.argv[1]), sys.argv[2], workers=2).summary
print("computed", summary.computed)
"""


@pytest.mark.slow
def test_a_script_without_a_main_guard_may_use_workers(tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(
        'base = "array-2x6"\nfidelity = "lumped"\nfrequency = "1:100:12"\nmetrics = ["distance_smallest"]\n'
        '[vary]\n"tube.length" = [12, 13]\n'
    )
    (tmp_path / "script.py").write_text(SCRIPT)
    line = [sys.executable, "script.py", "study.toml", "r.zarr"]
    done = subprocess.run(line, cwd=tmp_path, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "computed 2\n", "")
