"""Speed of sweeps: against a plain loop and joblib, scaling over workers, cost per case as studies grow.

    python benchmarks/sweep.py [--quick] [--all-metrics]

Lumped designs of 12 points x 64 frequencies with ten metrics of distance, sensitivity and size. With ``--all-metrics``
these tables stay as they are. Instead, sweeps of some hundred designs with every metric are timed, and what each metric
takes. Sweeps over workers are timed on workers that have started and have computed once. The start of workers has a row
of its own. Processor time is that of all processes together, which a busy machine changes less than time. Every row is
printed when it is measured. Writes the tables of docs/evidence/sweeps.md.
"""

from __future__ import annotations

import argparse
import platform
import resource
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from unittest.mock import patch

import joblib
import numpy as np
import psutil
from numpy.typing import NDArray

import acoustic_fem
from geometry import ArrayDesign
from geometry.ground.whole_files import replace_section
from studies.metrics.batch_responses import Responses
from studies.metrics.shared import SharedFigures
from studies.study.cases import Cases, cases_of
from studies.study.metric_registry import METRICS, Metric, metrics_named
from studies.study.study import Study, read_study
from studies.sweep import run
from studies.sweep.block import Job, solve_block
from studies.sweep.processes import Processes
from studies.sweep.results import open_sweep
from studies.sweep.run import run_sweep
from studies.sweep.workers import Workers, cores, open_workers

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "sweeps.md"
BEGIN, END = "<!-- speed: made by benchmarks/sweep.py -->", "<!-- end speed -->"
BEGIN_ALL, END_ALL = "<!-- all metrics: made by benchmarks/sweep.py --all-metrics -->", "<!-- end all metrics -->"
METRICS_OF_STUDY = (
    "distance_smallest", "distance_mean", "ild_smallest", "ipd_smallest", "sensitivity_force", "noise_equivalent_force",
    "bandwidth", "volume", "cost", "smallest_wall",
)  # fmt: skip
TOGETHER = ("as_built", "predicted", "confused_pair", "distance", "ild", "ipd")
"""Beginnings of the names of metrics that are computed together; the first that is asked for takes the time of all."""


def study_of(cases: int, metrics: Sequence[str] = METRICS_OF_STUDY) -> Study:
    names = ", ".join(f'"{name}"' for name in metrics)
    return read_study(
        f'base = "array-2x6"\nfidelity = "lumped"\nsampling = "sobol"\ncases = {cases}\nmetrics = [{names}]\n'
        'stock = "off"\n[vary]\n"tube.inner_diameter" = {from = 0.3, to = 0.5}\n"tube.length" = {from = 9, to = 30}\n'
        '"resonator.cavity_height" = {from = 1.5, to = 5}\n'
    )


def one_by_one(design: ArrayDesign, frequency: np.ndarray) -> list[float]:
    """Work of a script without the runner for each design."""
    library = acoustic_fem.solve(design, frequency, "lumped")
    return [metric.of_library(library) for metric in metrics_named(METRICS_OF_STUDY)]


class Clock:
    """Wall-clock and processor time of this process and of those it started, s; memory of all, bytes."""

    wall = 0.0
    processor = 0.0
    memory = 0.0


@contextmanager
def clock() -> Iterator[Clock]:
    found = Clock()
    start, used = time.perf_counter(), _processor_time()
    yield found
    found.wall, found.processor = time.perf_counter() - start, _processor_time() - used


def _processor_time() -> float:
    """Sum over this process, its ended children and those that live."""
    own, ended = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    alive = [child.cpu_times() for child in psutil.Process().children(recursive=True)]
    return own.ru_utime + own.ru_stime + ended.ru_utime + ended.ru_stime + sum(t.user + t.system for t in alive)


def _memory() -> float:
    here = psutil.Process()
    return float(sum(process.memory_info().rss for process in (here, *here.children(recursive=True))))


def swept(study: Study, team: Workers | None = None, check: Callable[[Path], None] | None = None) -> Clock:
    """A sweep in this process, or on workers that run."""

    @contextmanager
    def running(count: int | None, scheduler: str | None) -> Iterator[Workers]:
        assert team is not None
        yield team

    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "results.zarr"
        most = 0.0

        def watch(_: object) -> None:
            nonlocal most
            most = max(most, _memory())

        opened = open_workers if team is None else running
        with clock() as found, patch.object(run, "open_workers", opened):
            run_sweep(study, out, workers=1 if team is None else None, progress=watch)
        found.memory = most
        if check is not None:
            check(out)
    return found


@contextmanager
def started(workers: int) -> Iterator[Workers]:
    """Worker processes of this machine that have computed a small sweep: all modules are loaded."""
    processes = Processes(workers)
    try:
        swept(study_of(128), processes)
        yield processes
    finally:
        processes.close()


def table(first: str) -> list[str]:
    return [f"| {first} | cases | s | cases/s | CPU ms per case | memory (MB) |", "|---|---|---|---|---|---|"]


def row(name: str, cases: int, taken: Clock) -> str:
    figures = taken.wall, cases / taken.wall, taken.processor / cases * 1e3
    line = f"| {name} | {cases} | {figures[0]:.2f} | {figures[1]:.0f} | {figures[2]:.2f} | {taken.memory / 1e6:.0f} |"
    print(line, flush=True)
    return line


def against_others(cases: int) -> list[str]:
    study = study_of(cases)
    designs = [design_of(cases_of(study), number) for number in range(cases)]
    one_by_one(designs[0], study.frequency)  # all modules are loaded
    with clock() as loop:
        expected = np.array([one_by_one(design, study.frequency) for design in designs])
    loop.memory = _memory()
    lines = [*table("the same cases by"), row("a plain Python loop over `solve`", cases, loop)]
    executor = joblib.Parallel(n_jobs=2)
    executor(joblib.delayed(one_by_one)(design, study.frequency) for design in designs[:8])
    with clock() as parallel:
        executor(joblib.delayed(one_by_one)(design, study.frequency) for design in designs)
    parallel.memory = _memory()
    lines.append(row("joblib, 2 processes that have started", cases, parallel))
    from joblib.externals.loky import get_reusable_executor

    get_reusable_executor().shutdown()

    def same(out: Path) -> None:
        result = open_sweep(out).to_xarray()
        values = np.stack([result[name].values for name in METRICS_OF_STUDY], axis=1)
        worst = float(np.abs(values / expected - 1).max())
        print(f"largest relative difference to the loop: {worst:.1e}")

    lines.append(row("`sweep`, the calling process", cases, swept(study, check=same)))
    with started(2) as team:
        lines.append(row("`sweep`, 2 workers that have started", cases, swept(study, team)))
    return lines


def design_of(cases: Cases, number: int) -> ArrayDesign:
    return cases.design(number)


def scaling(cases: int) -> list[str]:
    study = study_of(cases)
    lines = [*table("`sweep` by"), row("the calling process", cases, swept(study))]
    for workers in (1, 2):
        with started(workers) as team:
            name = f"{workers} worker{'s' * (workers > 1)} that ha{'ve' if workers > 1 else 's'} started"
            lines.append(row(name, cases, swept(study, team)))
    return lines


def growth(sizes: list[int]) -> list[str]:
    lines = table("size of the study")
    with started(2) as team:
        lines += [row("2 workers that have started", cases, swept(study_of(cases), team)) for cases in sizes]
    return lines


def each_metric(cases: int) -> list[str]:
    """Processor time of each metric in a sweep by this process."""
    spent: dict[str, float] = {}
    measure = Metric.of_batch

    def timed(metric: Metric, responses: Responses, figures: SharedFigures | None = None) -> NDArray[np.float64]:
        begin = time.process_time()
        values = measure(metric, responses, figures)
        spent[metric.name] = spent.get(metric.name, 0.0) + time.process_time() - begin
        return values

    with patch.object(Metric, "of_batch", timed):
        whole = swept(study_of(cases, tuple(METRICS)))
    groups: dict[str, float] = {}
    for name, seconds in spent.items():
        first = next((f"{begin}*" for begin in TOGETHER if name.startswith(begin)), name)
        groups[f"`{first}`"] = groups.get(f"`{first}`", 0.0) + seconds
    groups["designs, responses and store"] = whole.processor - sum(spent.values())
    lines = ["| metric | CPU ms per case |", "|---|---|"]
    for name, seconds in sorted(groups.items(), key=lambda each: -each[1]):
        lines.append(f"| {name} | {seconds / cases * 1e3:.2f} |")
        print(lines[-1], flush=True)
    return lines


def all_metrics(cases: int) -> list[str]:
    study = study_of(cases, tuple(METRICS))
    swept(study_of(16, tuple(METRICS)))  # all modules are loaded
    lines = [*each_metric(cases), "", *table("all metrics by"), row("the calling process", cases, swept(study))]
    with started(2) as team:
        swept(study_of(32, tuple(METRICS)), team)
        found = swept(study, team)
        lines.append(row("2 workers that have started", cases, found))
    lines += [
        "",
        f"At this processor time 10,000 designs take {10_000 / cases * found.processor / 2:.0f} s of two cores.",
    ]
    print(lines[-1], flush=True)
    return lines


def overhead(tasks: int) -> list[str]:
    """Overhead of the runner: the start of workers, and the time of a task that does nothing."""
    lines = ["| overhead | start and end (s) | per block of cases (ms) |", "|---|---|---|"]
    for workers in (1, 2):
        study = study_of(128)
        cases, job = cases_of(study), Job(study.fidelity, study.frequency, study.metrics)
        begin = time.perf_counter()
        with open_workers(workers, None) as team:
            for _ in team.run(solve_block, ((job, cases.part(k, k + 16), k, {}) for k in range(0, 128, 16))):
                pass
            middle = time.perf_counter()
            for _ in team.run(_nothing, ((k,) for k in range(tasks))):
                pass
            taken = time.perf_counter() - middle
        start = "none" if workers == 1 else f"{time.perf_counter() - begin - taken:.1f}"
        who = "the calling process" if workers == 1 else f"{workers} workers of this machine"
        lines.append(f"| {who} | {start} | {taken / tasks * 1e3:.2f} |")
        print(lines[-1], flush=True)
    return lines


def _nothing(number: int) -> int:
    return number


def machine() -> str:
    """Running processes, and how busy they are."""
    versions = f"Python {platform.python_version()}, numpy {np.__version__}, {platform.machine()}"
    return f"{versions}, {cores()} cores, load {psutil.getloadavg()[0]:.1f} at the start"


def with_all_metrics(cases: int) -> None:
    """Sweeps with all metrics, printed and put on the page."""
    about = f"{machine()}, {cases:,} cases."
    print(about)
    replace_section(PAGE, BEGIN_ALL, END_ALL, [about, "", *all_metrics(cases)])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="smaller studies")
    parser.add_argument("--all-metrics", action="store_true", help="sweeps with every metric instead")
    arguments = parser.parse_args()
    quick = arguments.quick
    assert set(METRICS_OF_STUDY) <= set(METRICS)
    if arguments.all_metrics:
        with_all_metrics(64 if quick else 256)
        return
    lines = [machine() + ", smaller studies (`--quick`)" * quick + "."]
    print(lines[0])
    for part in (
        against_others(64 if quick else 256),
        scaling(1000 if quick else 10_000),
        growth([100, 1000] if quick else [100, 1000, 10_000, 100_000]),
        overhead(64 if quick else 256),
    ):
        lines += ["", *part]
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
