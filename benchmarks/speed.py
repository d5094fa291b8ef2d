"""How fast everything is, each figure beside its peer and how it grows with the points; writes docs/evidence/speed.md.

    python -m benchmarks.speed

One thread, processor time, the least of several runs, so that a busy machine changes little. OpenWind and NGSolve come
with the extra ``verify``; where they are not, OpenWind's row says so and NGSolve's table stays. The sweep with all
metrics, in docs/evidence/sweeps.md, and NGSolve follow: half an hour in all.
"""

from __future__ import annotations

import os
from dataclasses import replace

os.environ.setdefault("OMP_NUM_THREADS", "1")

import platform
import resource
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from time import process_time
from unittest.mock import patch

import numpy as np
import torch

import acoustic_fem
import geometry
import localize
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.quantities.local_air import design_air
from benchmarks import ngsolve_cell
from benchmarks.frame_time import frame_time
from benchmarks.localizer import QUIET, rate, step_rate
from benchmarks.network import varied
from geometry import ArrayDesign
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.touch_generator import SHARD
from studies.metrics.batch_responses import Responses
from studies.study.metric_registry import metrics_named

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "speed.md"
FREQUENCY, WIDE = np.linspace(1, 100, 64), np.arange(1.0, 501.0)
NAMES = ("array-2x6", "line-2", "line-3", "line-4")
METRICS = ("distance_smallest", "predicted_top1", "noise_equivalent_force", "coverage")
NOISE, BATCH = 1e-3, 256
STUDY = """
name = "speed"
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:64"
sampling = "sobol"
cases = 64
seed = 1
metrics = ["sensitivity_force"]
stock = "off"
[vary]
"tube.inner_diameter" = { from = 0.3, to = 0.6 }
"""


def least(call: Callable[[int], object], runs: int = 20) -> float:
    """Least processor time of a call that is given its number, ms; the first is not counted."""
    times = []
    for run in range(runs + 1):
        start = process_time()
        call(run)
        times.append(process_time() - start)
    return 1e3 * min(times[1:])


def others(command: Sequence[str], runs: int = 3) -> float:
    """Least processor time of a program, ms; the first run, which fills caches, is not counted."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    times = []
    for _ in range(runs + 1):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return 1e3 * min(times[1:])


def unlike(design: ArrayDesign, run: int) -> ArrayDesign:
    """A design like that one of which no bore and no height was computed before."""
    bore, height = design.tube.inner_diameter - 1e-4 * (run + 1), design.resonator.cavity_height + 1e-3 * (run + 1)
    return design.with_values({"tube.inner_diameter": bore, "resonator.cavity_height": height})


def one_design(name: str, fidelity: str) -> float:
    """``solve`` of designs that were not solved before, ms."""
    design = geometry.prototype(name)
    designs = [unlike(design, run) for run in range(21)]
    return least(lambda run: acoustic_fem.solve(designs[run], FREQUENCY, fidelity))


def in_a_batch() -> float:
    """A lumped design among many, ms."""
    design = geometry.prototype("array-2x6")
    several = varied(ArrayParameters.from_design(design), BATCH)
    topology, air = Topology.of(design), design_air(design)
    return least(lambda run: batch_transfer_function(several, topology, FREQUENCY, air), 5) / BATCH


def openwind_ladder() -> str:
    """OpenWind's transfer matrices of the tubes and cavities of array-2x6 in a row, closed: one impedance, ms."""
    if find_spec("openwind") is None:
        return "not installed"
    from openwind import ImpedanceComputation

    design = geometry.prototype("array-2x6")
    tube, cavity = design.tube, design.resonator
    pieces = [(tube.length, tube.acoustic_diameter), (cavity.cavity_height, cavity.cavity_diameter)] * 12
    ends = np.cumsum([0.0, *(length for length, _ in pieces)]) * 1e-3
    bore = [[a, b, d * 5e-4, d * 5e-4, "linear"] for a, b, (_, d) in zip(ends, ends[1:], pieces, strict=False)]
    about = {"unit": "m", "temperature": 20.0, "losses": "bessel", "radiation_category": "closed"}
    options = {"discontinuity_mass": False, "compute_method": "TMM"}
    return f"{least(lambda run: ImpedanceComputation(FREQUENCY, bore, **about, **options), 5):.1f}"


def signals(response: ArrayResponse) -> float:
    """Time of a multi-sine touch of one second at the microphones, ms."""
    touches = localize.TouchGenerator(response, 0, "evaluation", 0.0)
    return 1e3 / rate(lambda: len(touches.samples(0, SHARD).point))


def cold_line() -> tuple[float, float]:
    """line-4 with 3-D cells, from nothing and from the cache, in all processes, s."""
    program = (
        "import sys, numpy, acoustic_fem, geometry\n"
        "acoustic_fem.solve(geometry.prototype('line-4'), numpy.linspace(1, 100, 64))"
    )
    with tempfile.TemporaryDirectory() as empty, patch.dict("os.environ", ACOUSTIC_FEM_CACHE=empty):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-W", "ignore", "-c", program], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cold = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return cold, others([sys.executable, "-W", "ignore", "-c", program], 1) / 1e3


#: Cell -> directions of its tubes, their height (1: the cavity's), relative error aimed at, highest frequency (Hz),
#: and what was wanted.
CELLS = {
    "a 3-D cell of two tubes in line, 1e-3": ((0, 180), 0.5, 1e-3, 500.0, "target: 4 s"),
    "at a right angle, 1e-3": ((0, 90), 0.5, 1e-3, 500.0, "target: 4 s"),
    "three tubes at half the height, 1e-3": ((0, 100, 220), 0.5, 1e-3, 500.0, "target: 7 s"),
    "three tubes lower, no mirror plane": ((0, 100, 220), 0.4, 1e-3, 500.0, "target: 7 s"),
    "three tubes lower, default accuracy": ((0, 100, 220), 0.4, None, 500.0, ""),
    "two tubes in line to 1 kHz, default accuracy": ((0, 180), 0.5, None, 1000.0, "target: 30 s, 1.07 GB"),
    "three, no mirror plane, to 1 kHz, default accuracy": ((0, 100, 220), 0.4, None, 1000.0, "target: 30 s, 1.07 GB"),
}
CELL_PROGRAM = """
import sys, time
from pathlib import Path
from acoustic_fem.cell import one_cell
from benchmarks.one_mesh import BORE, HEIGHT, RADIUS
from geometry.air.cells import Cell
from geometry.schema.ports import CellPort
from tests.support.reference_data import AIR
angles, part, accuracy, highest = eval(sys.argv[1])
one_cell.DESIGN_ACCURACY = accuracy or one_cell.DESIGN_ACCURACY
ports = tuple(CellPort(float(angle), BORE) for angle in angles)
cell = Cell("resonator", 2 * RADIUS, HEIGHT, part * HEIGHT, ports, 2 * RADIUS, 0.0)
start = time.process_time()
one_cell.solve_task(one_cell.CellTask(cell, AIR, (1.0, highest), "navier-stokes"), lambda done: None)
seconds = time.process_time() - start
# ru_maxrss would be at least that of the process that started this one
(peak,) = (line.split()[1] for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM"))
print(seconds, 1024 * int(peak))
"""


def cells() -> list[tuple[str, str, str]]:
    """Rows of single cells, each solved in a process of its own: the least time of two, s, and the memory, GB."""
    rows = []
    for name, (*asked, wanted) in CELLS.items():
        runs = []
        for _ in range(2):
            program = [sys.executable, "-W", "ignore", "-c", CELL_PROGRAM, repr(tuple(asked))]
            done = subprocess.run(program, check=True, capture_output=True, text=True)
            runs.append(tuple(map(float, done.stdout.split())))
        seconds, memory = min(runs)
        rows.append((f"{name} (s, peak memory)", f"{seconds:.1f}, {memory / 1e9:.2f} GB", wanted))
    return rows


def commands() -> dict[str, float]:
    """Processor time of what prints a few lines, ms, import and all."""
    ours = [sys.executable, "-m", "studies.cli"]
    with tempfile.TemporaryDirectory() as folder:
        study, store = Path(folder) / "study.toml", str(Path(folder) / "results.zarr")
        study.write_text(STUDY, encoding="utf-8")
        subprocess.run([*ours, "sweep", str(study), "--out", store], check=True, capture_output=True)
        verbs = {"--help": ["--help"], "prototypes": ["prototypes"], "best": ["best", store]}
        return {name: others([*ours, *words], 6) for name, words in verbs.items()}


def by_points(name: str) -> dict[str, float]:
    """Times that grow with the points, ms."""
    design = geometry.prototype(name)
    library = acoustic_fem.solve(design, WIDE, "lumped")
    response, coarse = response_of(library), Responses.of_library(acoustic_fem.solve(design, FREQUENCY, "lumped"))
    known, tolerant = localize.BayesDecoder(library, NOISE), localize.TolerantDecoder(library, microphone_noise=NOISE)
    frames = {
        "frame, known sensor": frame_time(known, response, 300).processor_median,
        "frame, not calibrated": frame_time(tolerant, response, 300).processor_median,
    }
    figures = {
        f"metric {metric.name}": least(lambda run, metric=metric: metric.of_batch(coarse), 3)
        for metric in metrics_named(METRICS)
    }
    return {
        "`solve`, lumped": one_design(name, "lumped"),
        "`solve`, atlas": one_design(name, "atlas"),
        "tables of the decoder": least(lambda run: localize.BayesDecoder(library, NOISE), 2),
        "tables, not calibrated": least(lambda run: localize.TolerantDecoder(library, microphone_noise=NOISE), 1),
        **frames,
        "signals of a touch": signals(response),
        "training, a touch": 1e3 / step_rate(response, replace(localize.TrainingPlan.on_maps(), microphone_noise=1e-3)),
        "training in silence, steps of 128": 1e3 / step_rate(response, QUIET),
        **figures,
    }


def figure(value: float) -> str:
    """A number of three digits."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """A table in Markdown."""
    return ["", *(f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *rows))]


def peers(of_line_2: dict[str, float]) -> list[str]:
    """Each figure beside its peer or what was wanted; ``of_line_2`` are figures of :func:`by_points`."""
    single, many = one_design("array-2x6", "lumped"), in_a_batch()
    cold, cached = cold_line()
    rows = [
        ("one design, 12 points, lumped (ms)", f"{single:.1f}", f"{openwind_ladder()}: OpenWind, one impedance"),
        ("one design, 12 points, atlas (ms)", f"{one_design('array-2x6', 'atlas'):.1f}", ""),
        (f"one design, 12 points, lumped, in a batch of {BATCH} (ms)", f"{many:.2f}", f"{single:.1f}: one at a time"),
        ("line-4 with 3-D cells (s)", f"{cold:.0f}", f"{cached:.1f}: cells from the cache"),
        *cells(),
        ("signals of touches, 36 points (a second)", f"{1e3 / of_line_2['signals of a touch']:,.0f}", "target: 20,000"),
        (
            "the network's training, 36 points, the usual plan (a second)",
            f"{1e3 / of_line_2['training, a touch']:,.0f}",
            "target: 2,500",
        ),
        (
            "the network's training, in silence, steps of 128 (a second)",
            f"{1e3 / of_line_2['training in silence, steps of 128']:,.0f}",
            "",
        ),
        *((f"`{name}`, import and all (ms)", f"{each:.0f}", "target: 500") for name, each in commands().items()),
    ]
    return table(("what", "here", "compared with"), rows)


def growth(found: Sequence[dict[str, float]]) -> list[str]:
    """Cost of the points, and the power of their number from 36 to 216 by which it grows."""
    counts = [geometry.prototype(name).point_count for name in NAMES]
    steps = np.log(counts[-1] / counts[1])
    rows = [
        (what, *(figure(each[what]) for each in found), f"{np.log(found[-1][what] / found[1][what]) / steps:.1f}")
        for what in found[0]
    ]
    return table(("ms", *map(str, counts), "power"), rows)


def main() -> None:
    torch.set_num_threads(1)
    warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: |.*: its library ends at", UserWarning)
    before = os.getloadavg()[0]
    found = [by_points(name) for name in NAMES]
    tables = [*peers(found[1]), *growth(found)]
    load = sorted((before, os.getloadavg()[0]))
    state = (
        f"Python {platform.python_version()}, numpy {np.__version__}, {platform.machine()}, {os.cpu_count()} cores, "
        f"{'idle' if load[1] < 1.5 else 'loaded'} (load {load[0]:.1f} to {load[1]:.1f}, one of it this program's)."
    )
    lines = [state, *tables]
    print("\n".join(lines))
    replace_section(PAGE, "<!-- speed: made by benchmarks/speed.py -->", "<!-- end speed -->", lines)
    # in a process of its own: what is in this one's memory is not the sweep's
    subprocess.run([sys.executable, "-m", "benchmarks.sweep", "--all-metrics"], check=True)
    if find_spec("ngsolve") is not None:
        ngsolve_cell.main()


if __name__ == "__main__":
    main()
