"""Speed of data sets for training: ``python -m benchmarks.datasets``.

Puts on docs/evidence/sweeps.md: samples a second of one core for touches on one library and on many designs, as signals
and as maps, beside the naive route: a library solved and one touch made for each sample. And the time to read a shard
beside ``numpy.load``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from time import process_time

import numpy as np
import torch

import acoustic_fem
import localize
import studies
from benchmarks.sweep import PAGE, machine
from geometry.ground.whole_files import replace_section
from localize.datasets.touch_dataset import TouchBatch
from localize.signals.array_response import response_of

BEGIN, END = "<!-- data sets: made by benchmarks/datasets.py -->", "<!-- end data sets -->"
DESIGN, DESIGNS, GRID = "array-2x6", 1024, "1:500:500"
#: Processor time of each figure, s.
SECONDS = 8.0


def samples_per_second(batches: Iterable[TouchBatch], seconds: float = SECONDS) -> float:
    """Samples of a stream by processor time; the first batch, which opens what is needed, is left out."""
    stream = iter(batches)
    next(stream)
    start, count = process_time(), 0
    for batch in stream:
        count += len(batch["point"])
        if process_time() - start > seconds:
            break
    return count / (process_time() - start)


def one_by_one(seconds: float = SECONDS) -> float:
    """Samples a second where each design is solved and touched by itself."""
    start, count = process_time(), 0
    sensors = studies.as_built(DESIGN, DESIGNS, frequency=GRID)
    while process_time() - start < seconds:
        (array,) = sensors.arrays([count])
        localize.TouchGenerator(array, count, "training").samples(0, 1)
        count += 1
    return count / (process_time() - start)


def timed(work: Callable[[], object], repeats: int = 20) -> float:
    """Least processor time of several, s."""
    times = []
    for _ in range(repeats):
        start = process_time()
        work()
        times.append(process_time() - start)
    return min(times)


def reading() -> tuple[float, float]:
    """Speeds, by processor time, at which a shard of touches and an array of as many bytes are read, GB/s."""
    with tempfile.TemporaryDirectory() as folder:
        studies.export_dataset(DESIGN, Path(folder) / "set", as_built_sensors=40, touches=256)
        shard = Path(folder) / "set" / "train-00000.npz"
        np.save(Path(folder) / "plain.npy", np.zeros(shard.stat().st_size // 4, np.float32))

        def read() -> None:
            with np.load(shard) as found:
                for name in found.files:
                    found[name]

        size = shard.stat().st_size / 1e9
        return size / timed(read), size / timed(lambda: np.load(Path(folder) / "plain.npy"))


def main() -> None:
    """Print the table, and put it on the page."""
    torch.set_num_threads(1)
    lines = [f"{machine()}.", "", "| samples | samples a second of one core | target |", "|---|---|---|"]
    library = acoustic_fem.solve(DESIGN, GRID, "atlas")
    sensors = studies.as_built(DESIGN, DESIGNS, frequency=GRID)
    many = {"touches": 2**20, "batch_size": 256}
    rows = [
        ("one library, signals", 15_000, localize.TouchDataset(library, **many)),
        ("one library, signals, single samples", None, None),
        ("1,024 as-built sensors, signals", 8_000, localize.TouchDataset(sensors, touches=4096, batch_size=256)),
        ("one library, maps (phasors)", 5_000, localize.TouchDataset(library, features="phasors", **many)),
    ]
    for name, wanted, data in rows:
        if data is None:
            single = localize.TouchDataset(response_of(library), touches=2**20)
            found = samples_per_second(_as_batches(single))
        else:
            found = samples_per_second(data)
        lines.append(f"| {name} | {found:,.0f} | {'' if wanted is None else f'{wanted:,}'} |")
    lines.append(f"| each design solved, and one touch made on it | {one_by_one():,.0f} | |")
    shard, plain = reading()
    lines += [
        "",
        f"A shard of `npz` that lies in memory is read at {shard:.1f} GB/s, a plain array at {plain:.1f} GB/s.",
    ]
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)


def _as_batches(data: localize.TouchDataset) -> Iterable[TouchBatch]:
    for sample in data:
        yield {**sample, "point": sample["point"][None]}


if __name__ == "__main__":
    main()
