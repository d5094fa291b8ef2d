"""Speed of sweeps: against a plain loop and joblib, scaling over workers, cost per case as studies grow.

    python benchmarks/sweep.py [--quick]

Lumped designs of 12 points x 64 frequencies with all metrics of distance, sensitivity and size. Rates are per second
of wall-clock time and, in brackets, per second of processor time of all processes together, which a busy machine
changes less.
"""

from __future__ import annotations

import argparse
import platform
import resource
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import joblib
import numpy as np
import psutil

import acoustic_fem
from geometry import ArrayDesign
from studies.cases import Cases, cases_of
from studies.metric_registry import METRICS, metrics_named
from studies.study import Study
from studies.study_file import read_study
from studies.sweep import run_sweep
from studies.sweep_store import open_sweep
from studies.sweep_workers import open_workers

METRICS_OF_STUDY = (
    "distance_smallest", "distance_mean", "ild_smallest", "ipd_smallest", "sensitivity_force", "noise_equivalent_force",
    "bandwidth", "volume", "cost", "smallest_wall",
)  # fmt: skip


def study_of(cases: int) -> Study:
    names = ", ".join(f'"{name}"' for name in METRICS_OF_STUDY)
    return read_study(
        f'base = "array-2x6"\nfidelity = "lumped"\nsampling = "sobol"\ncases = {cases}\nmetrics = [{names}]\n'
        '[parameters]\n"tube.inner_diameter" = {from = 0.3, to = 0.5}\n"tube.length" = {from = 9, to = 30}\n'
        '"resonator.cavity_height" = {from = 1.5, to = 5}\n'
    )


def one_by_one(design: ArrayDesign, frequency: np.ndarray) -> list[float]:
    """What a script without the runner does for each design."""
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
    own, ended = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + ended.ru_utime + ended.ru_stime


def _memory() -> float:
    here = psutil.Process()
    return float(sum(process.memory_info().rss for process in (here, *here.children(recursive=True))))


def swept(study: Study, workers: int, check: Callable[[Path], None] | None = None) -> Clock:
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "results.zarr"
        most = 0.0

        def watch(_: object) -> None:
            nonlocal most
            most = max(most, _memory())

        with clock() as found:
            run_sweep(study, out, workers=workers, progress=watch)
        found.memory = most
        if check is not None:
            check(out)
    return found


def row(name: str, cases: int, taken: Clock) -> None:
    print(
        f"{name:<34}{cases:>8}{taken.wall:>9.2f}{cases / taken.wall:>10.0f} ({cases / taken.processor:>6.0f})"
        f"{taken.processor / cases * 1e3:>12.3f}{taken.memory / 1e6:>10.0f}"
    )


def heading(text: str) -> None:
    print(f"\n{text}\n{'':<34}{'cases':>8}{'s':>9}{'cases/s':>10}{'':>9}{'CPU ms/case':>12}{'MB':>10}")


def against_others(cases: int) -> None:
    study = study_of(cases)
    designs = [design_of(cases_of(study), number) for number in range(cases)]
    heading("the same cases by other means")
    with clock() as loop:
        expected = np.array([one_by_one(design, study.frequency) for design in designs])
    loop.memory = _memory()
    row("plain Python loop over solve()", cases, loop)
    with clock() as parallel:
        joblib.Parallel(n_jobs=2)(joblib.delayed(one_by_one)(design, study.frequency) for design in designs)
        parallel.memory = _memory()
        from joblib.externals.loky import get_reusable_executor

        get_reusable_executor().shutdown()
    row("joblib, 2 processes", cases, parallel)

    def same(out: Path) -> None:
        result = open_sweep(out).dataset
        values = np.stack([result[name].values for name in METRICS_OF_STUDY], axis=1)
        worst = float(np.abs(values / expected - 1).max())
        print(f"largest relative difference to the loop: {worst:.1e}")

    row("sweep, this process", cases, swept(study, 1, same))
    row("sweep, 2 workers", cases, swept(study, 2))


def design_of(cases: Cases, number: int) -> ArrayDesign:
    return cases.design(number)


def scaling(cases: int) -> None:
    study = study_of(cases)
    heading("workers")
    for workers in (1, 2):
        row(f"{workers} worker{'s' * (workers > 1)}", cases, swept(study, workers))


def growth(sizes: list[int]) -> None:
    heading("size of the study, 2 workers")
    for cases in sizes:
        row("", cases, swept(study_of(cases), 2))


def overhead(cases: int) -> None:
    """What the runner adds to a task that does nothing."""
    print("\noverhead of the workers, tasks that do nothing")
    for workers in (1, 2):
        with open_workers(workers, None) as team:
            for _ in team.run(_nothing, ((k,) for k in range(8))):
                pass
            start = time.perf_counter()
            for _ in team.run(_nothing, ((k,) for k in range(cases))):
                pass
            taken = time.perf_counter() - start
        print(f"{workers} worker{'s' * (workers > 1)}: {taken / cases * 1e3:.2f} ms per task (a block of cases)")


def _nothing(number: int) -> int:
    return number


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="smaller studies")
    quick = parser.parse_args().quick
    print(
        f"Python {platform.python_version()}, numpy {np.__version__}, {platform.machine()}; load {psutil.getloadavg()}"
    )
    assert set(METRICS_OF_STUDY) <= set(METRICS)
    against_others(64 if quick else 256)
    overhead(64 if quick else 256)
    scaling(1000 if quick else 10_000)
    growth([100, 1000] if quick else [100, 1000, 10_000, 100_000])


if __name__ == "__main__":
    main()
