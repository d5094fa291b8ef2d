"""Time of one frame in the stream engine: one core, a batch of one. ``python benchmarks/realtime.py``.

Each frame is pushed as a chunk of 16 samples into :class:`localize.TouchStream`, which cuts, checks and decodes it;
percentiles are of wall-clock time, and the mean processor time stands beside them, which other work on the machine
does not change. The network is one of the default shape after a moment of training: its speed does not depend on its
weights. The paper gives 3.5 to 4.5 ms per frame.
"""

from __future__ import annotations

import os
import sys
import tempfile
import warnings
from pathlib import Path
from time import perf_counter, process_time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

import acoustic_fem
import geometry
import localize
from localize.dataset import response_of
from localize.stream import HOP, StreamLocator

DESIGNS = ("line-2", "line-3", "line-4")
FREQUENCY = np.arange(1.0, 501.0)
NOISE = 1e-3
FRAMES = 3000
PLAN = localize.TrainingPlan(seconds_per_point=1, epochs=1, microphone_noise=NOISE)


def measured(locator: StreamLocator, signals: np.ndarray) -> tuple[float, float, float]:
    """Median, 99th percentile and mean processor time of a frame, ms."""
    stream = localize.TouchStream(locator)
    stream.push(signals[:, : 250 + 50 * HOP])  # not counted
    wall, processor = [], process_time()
    for begin in range(250 + 50 * HOP, signals.shape[1] - HOP + 1, HOP):
        started = perf_counter()
        (event,) = stream.push(signals[:, begin : begin + HOP])
        wall.append(perf_counter() - started)
        if not (isinstance(event, localize.Decision) and event.state == "touch"):
            raise RuntimeError("a frame was not decoded: its time says nothing")
    spent = process_time() - processor
    return 1e3 * float(np.median(wall)), 1e3 * float(np.percentile(wall, 99)), 1e3 * spent / len(wall)


def continuous(response: localize.ArrayResponse, frames: int) -> np.ndarray:
    """Touches of the first points one after the other, loud enough for every frame to be decoded."""
    seconds = -(-(250 + (frames + 51) * HOP) // 1000)
    touches = localize.TouchGenerator(response, 0, "evaluation", NOISE).samples(0, seconds)
    signals = touches.signals.double().numpy()
    signals /= signals.std((1, 2), keepdims=True)
    return np.concatenate(list(signals), axis=1)


def main(names: list[str]) -> None:
    table = Table(title="One frame in the stream engine, one core, batch of one (ms)")
    for column in ("design", "points", "microphones", "decoder", "runs in", "p50", "p99", "processor, mean"):
        table.add_column(column, justify="left" if column in ("design", "decoder", "runs in") else "right")
    for name in names:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            library = acoustic_fem.solve(geometry.prototype(name), FREQUENCY, fidelity="lumped")
        response = response_of(library)
        signals = continuous(response, FRAMES)
        with tempfile.TemporaryDirectory() as folder:
            for title, locator in (
                ("model-based", localize.BayesDecoder(response, NOISE)),
                ("network", localize.train(response, PLAN)),
            ):
                path = Path(folder) / "localizer.onnx"
                localize.export_onnx(locator, path)
                own = "NumPy" if title == "model-based" else "torch"
                for runtime, each in ((own, locator), ("ONNX Runtime", localize.OnnxLocalizer(path))):
                    times = (f"{value:.3f}" for value in measured(each, signals))
                    row = (name, str(response.point_count), str(len(response.microphones)), title, runtime, *times)
                    table.add_row(*row)
    Console(width=120).print(table)


if __name__ == "__main__":
    main(sys.argv[1:] or list(DESIGNS))
