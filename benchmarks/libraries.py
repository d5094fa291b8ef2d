"""Sweeps that keep libraries: ``python -m benchmarks.libraries [CASES]``.

Prints processor time, memory and size of a sweep of array-2x6 at 500 frequencies with its metrics alone and with
libraries in double and single precision, the time to read a library, and the time of a table of 10,000 cases. Each
sweep runs in a process of its own, in one thread.
"""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter, process_time

import studies

CASES = 1024
#: Time by that of metrics alone, and sizes of double and single precision in MB, that were asked for.
ASKED = (1.3, 350.0, 120.0)
_ROWS = (("metrics", "double"), ("libraries", "double"), ("libraries", "single"))


def sweep_of(cases: int, keep: str, precision: str) -> studies.Study:
    """Study of bores and tube lengths, with a metric of decoding and one of noise."""
    return studies.Study(
        base="array-2x6", vary={"tube.inner_diameter": (0.3, 0.6), "tube.length": (10.0, 20.0)}, sampling="sobol",
        cases=cases, fidelity="atlas", frequency="1:500:500", keep=keep, precision=precision,
        metrics=["predicted_top1", "noise_equivalent_force"],
    )  # fmt: skip


def size(folder: Path) -> float:
    """Bytes of the files of a folder, in MB."""
    return sum(file.stat().st_size for file in folder.rglob("*") if file.is_file()) / 1e6


def measure(cases: int, keep: str, precision: str, out: str) -> None:
    """Run one sweep, and print its processor time (s), peak memory (MB), size (MB) and time to read a library (s)."""
    warm = Path(out).with_suffix(".warm")
    studies.run_sweep(sweep_of(16, keep, precision), warm, workers=1)  # all modules are loaded
    start = process_time()
    sweep = studies.run_sweep(sweep_of(cases, keep, precision), out, workers=1)
    seconds, read = process_time() - start, 0.0
    if keep == "libraries":
        begun = process_time()
        for number in range(64):
            sweep.library(number)
        read = (process_time() - begun) / 64
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
    print(json.dumps([seconds, peak, size(Path(out)), read]))


def measured(cases: int, keep: str, precision: str) -> list[float]:
    """As :func:`measure`, in a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        given = [str(cases), keep, precision, f"{folder}/r.zarr"]
        line = [sys.executable, "-W", "ignore", "-m", "benchmarks.libraries", *given]
        done = subprocess.run(line, check=True, capture_output=True, text=True)
    found: list[float] = json.loads(done.stdout.splitlines()[-1])
    return found


def table_seconds(cases: int = 10_000) -> float:
    """Time in which the results of a sweep are opened and become a table, s."""
    study = studies.Study(
        base="line-3", vary={"tube.length": (10.0, 20.0), "tube.inner_diameter": (0.3, 0.6)}, sampling="random",
        cases=cases, fidelity="lumped", frequency="1:100:2", metrics=["volume"],
    )  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        studies.run_sweep(study, f"{folder}/r.zarr", workers=1)
        studies.open_sweep(f"{folder}/r.zarr").to_dataframe()
        start = perf_counter()
        table = studies.open_sweep(f"{folder}/r.zarr").to_dataframe()
        seconds = perf_counter() - start
    assert len(table) == cases
    return seconds


def main(cases: int = CASES) -> None:
    """Print the table."""
    found = {row: measured(cases, *row) for row in _ROWS}
    few = measured(cases // 4, "libraries", "double")
    alone = found["metrics", "double"][0]
    print(f"{cases} designs x 12 points x 2 microphones x 500 frequencies, one thread")
    print(
        f"{'kept':22} {'processor time (s)':>18} {'ratio':>6} {'memory (MB)':>12} {'store (MB)':>11} {'read (ms)':>10}"
    )
    for (keep, precision), (seconds, peak, stored, read) in found.items():
        name = keep if keep == "metrics" else f"{keep}, {precision}"
        print(f"{name:22} {seconds:18.1f} {seconds / alone:6.2f} {peak:12.0f} {stored:11.1f} {1e3 * read:10.2f}")
    print(f"memory of {cases // 4} designs with libraries, double: {few[1]:.0f} MB")
    print(f"asked: ratio {ASKED[0]}, double {ASKED[1]:g} MB, single {ASKED[2]:g} MB")
    print(f"table of 10,000 cases, opened and made: {table_seconds():.2f} s (asked: 1 s)")


if __name__ == "__main__":
    if len(sys.argv) == 5:
        measure(int(sys.argv[1]), *sys.argv[2:])
    else:
        main(*map(int, sys.argv[1:]))
