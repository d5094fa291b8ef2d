"""Sweeps that keep libraries: ``python -m benchmarks.libraries [CASES]``.

Puts on docs/evidence/sweeps.md: processor time, memory and size of a sweep of array-2x6 at 500 frequencies with its
metrics alone and with libraries in double and single precision, the time to read a library, and the time of a table of
10,000 cases. Each sweep runs in a process of its own, in one thread.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter, process_time

import studies
from benchmarks.sweep import PAGE, machine
from geometry.ground.whole_files import replace_section

BEGIN, END = "<!-- libraries: made by benchmarks/libraries.py -->", "<!-- end libraries -->"
CASES = 1024
#: Time by that of metrics alone, and sizes of double and single precision in MB, that were asked for.
ASKED = (1.3, 350.0, 120.0)
#: What is kept, its precision, and what varies.
_ROWS = (
    ("metrics", "double", "tubes"),
    ("libraries", "double", "tubes"),
    ("libraries", "single", "tubes"),
    ("metrics", "double", "tubes and cavities"),
    ("libraries", "double", "tubes and cavities"),
    ("metrics", "double", "tubes and membranes"),
    ("libraries", "double", "tubes and membranes"),
)


def sweep_of(cases: int, keep: str, precision: str, varied: str = "tubes") -> studies.Study:
    """Study of bores, tube lengths and perhaps cavities or membranes, with a metric of decoding and one of noise."""
    vary = {"tube.inner_diameter": (0.3, 0.6), "tube.length": (10.0, 20.0)}
    if varied == "tubes and cavities":
        vary["resonator.cavity_height"] = (2.5, 3.5)
    if varied == "tubes and membranes":
        vary["membrane.thickness"] = (0.3, 1.0)
    return studies.Study(
        base="array-2x6", vary=vary, stock="off", sampling="sobol", cases=cases, fidelity="atlas",
        frequency="1:500:500", keep=keep, precision=precision, metrics=["predicted_top1", "noise_equivalent_force"],
    )  # fmt: skip


def size(folder: Path) -> float:
    """Bytes of the files of a folder, in MB."""
    return sum(file.stat().st_size for file in folder.rglob("*") if file.is_file()) / 1e6


def measure(cases: int, keep: str, precision: str, varied: str, out: str) -> None:
    """Run one sweep, and print its processor time (s), peak memory (MB), size (MB) and time to read a library (s)."""
    warm = Path(out).with_suffix(".warm")
    studies.run_sweep(sweep_of(16, keep, precision, varied), warm, workers=1)  # all modules are loaded
    start = process_time()
    sweep = studies.run_sweep(sweep_of(cases, keep, precision, varied), out, workers=1)
    seconds, read = process_time() - start, 0.0
    if keep == "libraries":
        begun = process_time()
        for number in range(64):
            sweep.library(number)
        read = (process_time() - begun) / 64
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
    print(json.dumps([seconds, peak, size(Path(out)), read]))


def measured(cases: int, keep: str, precision: str, varied: str) -> list[float]:
    """As :func:`measure`, in a process of its own that finds no membrane on disk."""
    with tempfile.TemporaryDirectory() as folder:
        own = {**os.environ, "ACOUSTIC_FEM_CACHE": f"{folder}/cache"}
        given = [str(cases), keep, precision, varied, f"{folder}/r.zarr"]
        line = [sys.executable, "-W", "ignore", "-m", "benchmarks.libraries", *given]
        done = subprocess.run(line, check=True, capture_output=True, text=True, env=own)
    found: list[float] = json.loads(done.stdout.splitlines()[-1])
    return found


def table_seconds(cases: int = 10_000) -> float:
    """Time in which the results of a sweep are opened and become a table, s."""
    study = studies.Study(
        base="array-2x6", vary={"tube.length": (10.0, 20.0), "tube.inner_diameter": (0.3, 0.6)}, sampling="random",
        stock="off", cases=cases, fidelity="lumped", frequency="1:100:2", metrics=["volume"],
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
    """Print the table, and put it on the page."""
    about = f"{machine()}; {cases:,} cases."
    found = {row: measured(cases, *row) for row in _ROWS}
    few = measured(cases // 4, "libraries", "double", "tubes")
    ratio, *sizes = ASKED
    targets = {"double": f"{sizes[0]:g}", "single": f"{sizes[1]:g}"}
    head = ("varied", "kept", "processor time (s)", "times metrics alone", "target", "memory (MB)", "store (MB)",
            "target", "read one (ms)")  # fmt: skip
    rows = [about, "", f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    for (keep, precision, varied), (seconds, peak, stored, read) in found.items():
        alone = found["metrics", "double", varied][0]
        kept, aims, reads = keep, ("", ""), ""
        if keep == "libraries":
            kept = f"{keep}, {precision} precision"
            aims, reads = (f"{ratio:g}", targets[precision]), f"{1e3 * read:.1f}"
        cells = (varied, kept, f"{seconds:.1f}", f"{seconds / alone:.2f}", aims[0], f"{peak:.0f}", f"{stored:.1f}",
                 aims[1], reads)  # fmt: skip
        rows.append(f"| {' | '.join(cells)} |")
    rows += [
        "",
        f"With a quarter of the cases, libraries in double precision take {few[1]:.0f} MB of memory.",
        f"`Sweep.to_dataframe` opens and makes a table of 10,000 cases in {table_seconds():.2f} s. The target is 1 s.",
    ]
    print("\n".join(rows))
    replace_section(PAGE, BEGIN, END, rows)


if __name__ == "__main__":
    if len(sys.argv) == 6:
        measure(int(sys.argv[1]), *sys.argv[2:])
    else:
        main(*map(int, sys.argv[1:]))
