"""Two touches at once on as-built sensors: both points found, and single touches taken for two.

``python benchmarks/two_touches.py --workers 16`` writes the table of docs/two-touches.md; parts of the names of cells
restrict it to these, and ``--sensors 4 --frames 5 --seed 900`` to fewer, other touches. Sensors are virtual rigs, whose
lengths, losses, relaxations, air and pressure the decoder does not know. Times are those of a process.
"""

from __future__ import annotations

import argparse
import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # a process a core, each with one thread

import warnings
from functools import lru_cache
from time import process_time

import numpy as np

import acoustic_fem
import geometry
from acoustic_fem import Library
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from acoustic_fem.scatter import UNCALIBRATED
from geometry.ground.whole_files import replace_section
from localize.evaluation import wilson_interval
from localize.signals.array_response import ArrayResponse, response_of
from localize.two_touches import TwoTouchDecoder, TwoTouchOptions
from studies.test_rig.touches_at_once import FrameRig
from studies.test_rig.virtual_rig import Rig

PAGE = Path(__file__).parents[1] / "docs" / "two-touches.md"
BEGIN, END = "<!-- two touches: made by benchmarks/two_touches.py -->", "<!-- end two touches -->"
SENSORS, FRAMES, SEED, APART = 20, 12, 46000, 0.05
ANY_SIZE = TwoTouchOptions(most_points=1000)


@dataclass(frozen=True)
class Cell:
    """One row of the table."""

    design: str
    calibrated: bool
    kind: str
    elsewhere: bool = False
    """True if the two points are on different lines."""

    @property
    def name(self) -> str:
        library = "own library, 1 %" if self.calibrated else "not calibrated"
        lines = ", other line" if self.elsewhere else ""
        return f"{self.design}, {library}, two {'taps' if self.kind == 'tap' else 'presses'}{lines}"


CELLS = (
    Cell("array-2x6", True, "tap"), Cell("array-2x6", False, "tap"),
    Cell("array-2x6", True, "press"), Cell("array-2x6", False, "press"),
    Cell("line-3", True, "tap", True), Cell("line-3", False, "tap", True),
    Cell("line-2", True, "tap"),
)  # fmt: skip


@lru_cache(maxsize=1)
def library_of(design: str) -> Library:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        return acoustic_fem.solve(geometry.prototype(design), np.arange(1.0, 501.0), "atlas")


@lru_cache(maxsize=1)
def uncalibrated(design: str) -> TwoTouchDecoder:
    return TwoTouchDecoder(library_of(design), tolerances=UNCALIBRATED, options=ANY_SIZE)


def drawn_pair(array: ArrayResponse, elsewhere: bool, random: np.random.Generator) -> list[int]:
    while True:
        one, other = random.choice(array.point_count, 2, replace=False)
        if not elsewhere or array.line[one] != array.line[other]:
            return [int(one) + 1, int(other) + 1]


def is_near(array: ArrayResponse, found: list[int], true: list[int]) -> bool:
    """True if each found point is a true one or beside it."""

    def beside(a: int, b: int) -> bool:
        return bool(array.line[a - 1] == array.line[b - 1] and abs(array.place[a - 1] - array.place[b - 1]) <= 1)

    (a, b), (c, d) = found, true
    return (beside(a, c) and beside(b, d)) or (beside(a, d) and beside(b, c))


def sensor_figures(given: tuple[Cell, int, int]) -> list[list[float]]:
    """Figures of each frame: exact, near, called two, single called two, single right, seconds of both."""
    cell, seed, frames = given
    warnings.simplefilter("ignore", ModelLimitWarning)
    rig = Rig(geometry.prototype(cell.design), seed, fidelity="atlas")
    generator, array = FrameRig(rig), response_of(library_of(cell.design))
    decoder = uncalibrated(cell.design)
    if cell.calibrated:
        decoder = TwoTouchDecoder(generator.measured_response(0.01, seed), options=ANY_SIZE)
    random, rows = np.random.default_rng([seed, 46]), []
    for _ in range(frames):
        true = drawn_pair(array, cell.elsewhere, random)
        both = generator.frame(true, random.uniform(0, APART), cell.kind, random)
        one = generator.frame(true[:1], 0.0, cell.kind, random)
        begun = process_time()
        found = decoder.locate(both.frame)
        between = process_time()
        single = decoder.locate(one.frame)
        ended = process_time()
        points = [touch.best for touch in found.touches]
        is_two = len(points) == 2
        near = is_two and is_near(array, points, true)
        rows.append([
            is_two and set(points) == set(true), near, is_two,
            len(single.touches) > 1, single.touches[0].best == true[0],
            between - begun, ended - between,
            float(np.mean([touch.probability for touch in found.touches])),
        ])  # fmt: skip
    return rows


def shown(values: np.ndarray) -> str:
    low, high = wilson_interval(values.mean(), len(values))
    return f"{100 * values.mean():.0f} ({100 * low:.0f} to {100 * high:.0f})"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cells", nargs="*", help="parts of the names of cells")
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--frames", type=int, default=FRAMES)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--workers", type=int, default=1)
    given = parser.parse_args()
    chosen = [cell for cell in CELLS if not given.cells or any(part in cell.name for part in given.cells)]
    lines = ["| sensor and touches | pairs | both points exact | within one place | called two | single called two | "
             "single: right point | mean probability | s a pair, a single |", "|---" * 9 + "|"]  # fmt: skip
    with ProcessPoolExecutor(given.workers) as pool:
        for cell in chosen:
            jobs = [(cell, given.seed + number, given.frames) for number in range(given.sensors)]
            rows = np.array([row for part in pool.map(sensor_figures, jobs) for row in part], np.float64)
            exact, near, two, single_two, single, pair_time, single_time, probability = rows.T
            lines.append(
                f"| {cell.name} | {len(rows)} | {shown(exact)} | {shown(near)} | {shown(two)} | {shown(single_two)} | "
                f"{shown(single)} | {100 * probability.mean():.0f} | {np.median(pair_time):.2f}, "
                f"{np.median(single_time):.2f} |"
            )
            print(lines[-1], flush=True)
    if (given.sensors, given.frames, given.seed, chosen) == (SENSORS, FRAMES, SEED, list(CELLS)):
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
