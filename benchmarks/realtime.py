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
from dataclasses import astuple
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from frame_time import frame_time
from rich.console import Console
from rich.table import Table

import acoustic_fem
import geometry
import localize
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.locator import Locator

DESIGNS = ("line-2", "line-3", "line-4")
FREQUENCY = np.arange(1.0, 201.0)
NOISE = 1e-3
PLAN = localize.TrainingPlan(seconds_per_point=1, epochs=1, microphone_noise=NOISE)


def cells_of(locator: Locator, response: ArrayResponse) -> tuple[str, ...]:
    """Points, microphones and times of a row."""
    times = (f"{value:.3f}" for value in astuple(frame_time(locator, response)))
    return str(response.point_count), str(len(response.microphones)), *times


def main(names: list[str]) -> None:
    table = Table(title="One frame in the stream engine, one core, batch of one (ms)")
    for column in ("design", "decoder", "runs in"):
        table.add_column(column)
    for column in ("points", "microphones", "p50", "p99", "processor p50", "processor p99"):
        table.add_column(column, justify="right")
    for name in names:
        library = acoustic_fem.solve(geometry.prototype(name), FREQUENCY, fidelity="lumped")
        response = response_of(library)
        with tempfile.TemporaryDirectory() as folder:
            for title, own, locator in (
                ("Bayes decoder", "NumPy", localize.BayesDecoder(response, NOISE)),
                ("network", "torch", localize.train(response, PLAN)),
            ):
                path = Path(folder) / "localizer.onnx"
                localize.export_onnx(locator, path)
                for runtime, each in ((own, locator), ("ONNX Runtime", localize.OnnxLocalizer(path))):
                    table.add_row(name, title, runtime, *cells_of(each, response))
        tolerant = localize.TolerantDecoder(library, microphone_noise=NOISE)
        table.add_row(name, "not calibrated", "NumPy", *cells_of(tolerant, response))
    Console(width=120).print(table)


if __name__ == "__main__":
    main(sys.argv[1:] or list(DESIGNS))
