"""Speed of the localizer: signals, features, training, one frame. ``python benchmarks/localizer.py [DESIGN]``.

Figures are for the threads torch takes here, printed with them; set OMP_NUM_THREADS=1 for one core.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from time import perf_counter

import numpy as np
import torch
from rich.console import Console
from rich.table import Table

import acoustic_fem
import geometry
import localize
from localize.dataset import SHARD, response_of
from localize.features import PairFeatures
from localize.frames import FRAME

FREQUENCY = np.arange(1.0, 501.0)
LATENCY_FRAMES = 300


def rate(job: Callable[[], int], seconds: float = 2.0) -> float:
    """Units per second of a job that returns how many it did; the first call is not counted."""
    job()
    done, start = 0, perf_counter()
    while perf_counter() - start < seconds:
        done += job()
    return done / (perf_counter() - start)


def latency(locate: Callable[[np.ndarray], np.ndarray], frames: np.ndarray) -> tuple[float, float]:
    """Median and 99th percentile of single frames, ms."""
    locate(frames[0])
    times = []
    for frame in frames:
        start = perf_counter()
        locate(frame)
        times.append(1e3 * (perf_counter() - start))
    return float(np.median(times)), float(np.percentile(times, 99))


def main(name: str) -> None:
    library = acoustic_fem.solve(geometry.prototype(name), FREQUENCY, fidelity="lumped")
    response = response_of(library)
    touches = localize.TouchGenerator(response, 0, "evaluation", 1e-3)
    frames = touches.samples(0, LATENCY_FRAMES).signals[..., :FRAME]

    table = Table(
        title=f"{name}: {response.point_count} points, {len(response.microphones)} microphones, "
        f"{torch.get_num_threads()} threads"
    )
    table.add_column("what")
    table.add_column("value", justify="right")
    table.add_column("unit")

    def row(what: str, value: str, unit: str) -> None:
        table.add_row(what, value, unit)

    speed = rate(lambda: len(touches.samples(0, SHARD).point))
    row("signals of one second, noise included", f"{speed:,.0f}", "samples/s")
    maps = PairFeatures(len(response.microphones))
    speed = rate(lambda: len(maps(frames[:SHARD])))
    row("features in batches", f"{speed:,.0f}", "frames/s")

    start = perf_counter()
    localizer = localize.train(library)
    seconds = perf_counter() - start
    row("training, default plan", f"{seconds:.1f}", "s")
    row("training, signals and features included", f"{localizer.training['touches'] / seconds:,.0f}", "samples/s")
    start = perf_counter()
    decoder = localize.BayesDecoder(library)
    row("tables of the model-based decoder", f"{perf_counter() - start:.2f}", "s")

    for title, locator in (("network", localizer), ("model-based", decoder)):
        middle, worst = latency(locator.locate, frames.numpy())
        row(f"{title}: one frame, median / 99 %", f"{middle:.2f} / {worst:.2f}", "ms")
        for noise in (0.0, 1e-3):
            result = localize.evaluate(locator, library, microphone_noise=noise)
            row(
                f"{title}: top-1 / top-2 / within one, noise {noise:g} Pa",
                f"{100 * result.top1:.2f} / {100 * result.top2:.2f} / {100 * result.within_one:.2f}",
                "%",
            )
    Console(width=110).print(table)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "array-2x6")
