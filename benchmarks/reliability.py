"""Figures of reliability: bad inputs, damaged files, killed sweeps, and two runs of one design compared.

``PYTHONPATH=.:tests/support python benchmarks/reliability.py`` prints the table of docs/reliability.md; --inputs,
--flips and --kills say how often each is tried.
"""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from damage import damaged
from hostile.cases import all_cases, sample
from hostile.commands import Commands, commands
from hostile.good_files import make
from hostile.judge import judged
from small_run import PLAN, small_design

import studies
from geometry.ground.stated_times import VARIABLE

#: What is tried, how often, and how often it ended badly.
Row = tuple[str, int, int]
#: Groups of the inputs by what is bad about them.
DAMAGED, STORES = "damaged ", "damaged results.zarr"


def inputs(count: int, good: Path, work: Path, runner: Commands) -> Iterator[Row]:
    """Bad inputs of every group about its fraction; bad is a traceback, a hang, 2 GB, or a silent change."""
    cases = all_cases()
    tried: Counter[str] = Counter()
    bad: Counter[str] = Counter()
    for verdict in judged(cases if count >= len(cases) else sample(cases, count), good, work, runner):
        group = verdict.case.group
        name = "stores" if group.startswith(STORES) else "other files" if group.startswith(DAMAGED) else "inputs"
        tried[name] += 1
        bad[name] += bool(verdict.fault)
        if verdict.fault:
            print(f"{verdict.fault}: {group}: {verdict.case.name}: {verdict.told}", file=sys.stderr, flush=True)
    yield "bad files, options, fields, recordings and environments", tried["inputs"], bad["inputs"]
    yield "bits, blocks and ends of stores changed", tried["stores"], bad["stores"]
    yield "bits, blocks and ends of other files changed", tried["other files"], bad["other files"]


def kills(count: int, good: Path, work: Path) -> Row:
    """Sweeps killed at a random moment and begun again; bad is one that then differs from a sweep left alone."""
    alone = studies.open_sweep(good / "results.zarr").to_xarray().load()
    draw = np.random.default_rng(0)
    study, bad = good / "study.toml", 0
    command = [sys.executable, "-m", "studies.cli", "sweep", str(study), "--workers", "1", "--out"]

    def begun(store: Path) -> subprocess.Popen[bytes]:
        quiet = subprocess.DEVNULL
        return subprocess.Popen([*command, str(store)], cwd=good, stdout=quiet, stderr=quiet, start_new_session=True)

    began = time.perf_counter()
    if begun(work / "timed.zarr").wait() != 0:
        raise RuntimeError("the sweep that is timed has failed")
    whole = time.perf_counter() - began
    for number in range(count):
        store = work / f"killed-{number}.zarr"
        process = begun(store)
        time.sleep(draw.uniform(0.2, 1.0) * whole)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        survived = begun(store).wait() == 0
        bad += not (survived and studies.open_sweep(store).to_xarray().load().equals(alone))
    return "sweeps killed at a random moment and begun again", count, bad


def runs(flips: int, work: Path) -> Iterator[Row]:
    """Two runs of a design with the clock stopped, file by file, and changes of one that ``verify`` finds."""
    os.environ[VARIABLE] = "1700000000"
    for name in ("first", "second"):
        studies.run_design(small_design(), work / name, fidelity="lumped", plan=PLAN)
    del os.environ[VARIABLE]
    first, second = work / "first", work / "second"
    names = studies.verify_run(first).unchanged
    differing = sum((first / name).read_bytes() != (second / name).read_bytes() for name in names)
    yield "files of two runs with `SOURCE_DATE_EPOCH` compared", len(names), differing
    silent = sum(_is_unnoticed(first) for _ in damaged(first, flips, seed=0))
    yield "files of a run changed before `verify`", flips, silent


def _is_unnoticed(folder: Path) -> bool:
    try:
        return studies.verify_run(folder).complete
    except ValueError:  # the list itself
        return False


def main() -> int:
    """Exit code: 1 where anything ended badly."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inputs", type=int, default=10**6, help="bad inputs; all where there are fewer")
    parser.add_argument("--flips", type=int, default=500)
    parser.add_argument("--kills", type=int, default=20)
    options = parser.parse_args()
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder, commands() as runner:
        good, work = Path(folder) / "good", Path(folder) / "work"
        good.mkdir()
        work.mkdir()
        make(good, runner)
        rows += runs(options.flips, work)
        rows.append(kills(options.kills, good, work))
        rows += inputs(options.inputs, good, work, runner)
    print("| tried | how often | ended badly |\n|---|---|---|")
    for name, count, bad in rows:
        print(f"| {name} | {count} | {bad} |")
    return int(any(bad for _, _, bad in rows))


if __name__ == "__main__":
    sys.exit(main())
