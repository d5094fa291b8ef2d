"""Speed of data sets for training: ``python -m benchmarks.datasets``.

Prints samples a second of one core for touches on one library and on many designs, as signals and as maps, beside the
naive route: a library solved and one touch made for each sample. And the time to read a shard beside ``numpy.load``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from time import perf_counter, process_time

import numpy as np
import torch

import acoustic_fem
import localize
import studies
from localize.datasets.touch_dataset import TouchBatch
from localize.signals.array_response import response_of

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


def timed(work: Callable[[], object], repeats: int = 5) -> float:
    """Least time of several, s."""
    times = []
    for _ in range(repeats):
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return min(times)


def reading() -> tuple[float, float]:
    """Times to read a shard of touches and an array of as many bytes by ``numpy.load``, s."""
    with tempfile.TemporaryDirectory() as folder:
        studies.export_dataset(DESIGN, Path(folder) / "set", as_built_sensors=40, touches=256)
        shard = Path(folder) / "set" / "train-00000.npz"
        np.save(Path(folder) / "plain.npy", np.zeros(shard.stat().st_size // 4, np.float32))

        def read() -> None:
            with np.load(shard) as found:
                for name in found.files:
                    found[name]

        return timed(read), timed(lambda: np.load(Path(folder) / "plain.npy"))


def main() -> None:
    """Print the table."""
    torch.set_num_threads(1)
    library = acoustic_fem.solve(DESIGN, GRID, "atlas")
    sensors = studies.as_built(DESIGN, DESIGNS, frequency=GRID)
    many = {"touches": 2**20, "batch_size": 256}
    rows = [
        ("one library, signals", 15_000, localize.TouchDataset(library, **many)),
        ("one library, single samples", None, None),
        ("1,024 designs, signals", 8_000, localize.TouchDataset(sensors, touches=4096, batch_size=256)),
        ("one library, maps (phasors)", 5_000, localize.TouchDataset(library, features="phasors", **many)),
    ]
    print(f"{'samples a second of one core':34} {'measured':>9} {'wanted':>8}")
    for name, wanted, data in rows:
        if data is None:
            single = localize.TouchDataset(response_of(library), touches=2**20)
            found = samples_per_second(_as_batches(single))
        else:
            found = samples_per_second(data)
        print(f"{name:34} {found:9,.0f} {'' if wanted is None else f'{wanted:,}':>8}")
    print(f"{'each design and touch by itself':34} {one_by_one():9,.0f}")
    shard, plain = reading()
    print(f"{'read a shard, times numpy.load':34} {shard / plain:9.2f}")


def _as_batches(data: localize.TouchDataset) -> Iterable[TouchBatch]:
    for sample in data:
        yield {**sample, "point": sample["point"][None]}


if __name__ == "__main__":
    main()
