"""Time of one frame in the stream engine: one core, a batch of one. ``python benchmarks/realtime.py [DESIGN ...]``.

Each frame is pushed as a chunk of 16 samples into :class:`localize.TouchStream`, which cuts, checks and decodes it.
Median and 99th percentile are given of wall-clock time, to which other work on the machine adds waiting, and of the
processor time of the process, to which it adds only colder caches. The network is one of the default shape after a
moment of training: its speed does not depend on its weights. The paper gives 3.5 to 4.5 ms per frame.
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


def measured(locator: StreamLocator, signals: np.ndarray) -> list[float]:
    """Median and 99th percentile of a frame's wall-clock time, then of its processor time, ms."""
    stream = localize.TouchStream(locator)
    warm_up = 250 + 50 * HOP
    stream.push(signals[:, :warm_up])
    wall, processor = [], []
    for begin in range(warm_up, signals.shape[1] - HOP + 1, HOP):
        started, spent = perf_counter(), process_time()
        (event,) = stream.push(signals[:, begin : begin + HOP])
        processor.append(process_time() - spent)
        wall.append(perf_counter() - started)
        if not (isinstance(event, localize.Decision) and event.state == "touch"):
            raise RuntimeError("a frame was not decoded: its time says nothing")
    return [1e3 * float(np.percentile(times, share)) for times in (wall, processor) for share in (50, 99)]


def continuous(response: localize.ArrayResponse, frames: int) -> np.ndarray:
    """Touches of the first points one after the other, loud enough for every frame to be decoded."""
    seconds = -(-(250 + (frames + 51) * HOP) // 1000)
    touches = localize.TouchGenerator(response, 0, "evaluation", NOISE).samples(0, seconds)
    signals = touches.signals.double().numpy()
    signals /= signals.std((1, 2), keepdims=True)
    return np.concatenate(list(signals), axis=1)


def main(names: list[str]) -> None:
    table = Table(title="One frame in the stream engine, one core, batch of one (ms)")
    for column in (
        "design",
        "points",
        "microphones",
        "decoder",
        "runs in",
        "p50",
        "p99",
        "processor p50",
        "processor p99",
    ):
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
                    table.add_row(
                        name, title, runtime, str(response.point_count), str(len(response.microphones)), *times
                    )
    Console(width=120).print(table)


if __name__ == "__main__":
    main(sys.argv[1:] or list(DESIGNS))
