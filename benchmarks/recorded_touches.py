"""Gain from recorded touches of an as-built sensor. ``python benchmarks/recorded_touches.py [SEED ...]``.

For each seed, a virtual rig of array-2x6 with a modulus 15 % below that of the design records touches of the paper's
four parts. Localizers are trained on simulated touches, on recorded ones, and on both. They are evaluated on held-out
recordings, and so is the Bayes decoder with the design's library and with the sensor's own transfer functions.
"""

from __future__ import annotations

import os
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

import acoustic_fem
import geometry
import localize
from localize.learned.recorded_frames import RecordedFrames
from localize.recordings.touch_manifest import PARTS
from localize.signals.array_response import response_of
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

NOISE = 1e-3
PLAN = replace(
    localize.TrainingPlan.on_maps(), epochs=6, microphone_noise=NOISE, stimuli=("multi-sines", "taps", "friction")
)
RECORDER = Recorder(hum=5e-4, drift=1e-3)


def main(seeds: list[int]) -> None:
    design = geometry.prototype("array-2x6")
    library = acoustic_fem.solve(design, np.arange(1.0, 201.0), fidelity="lumped")
    nominal = response_of(library)
    console = Console(width=120)
    for seed in seeds:
        table = Table(title=f"Frames of held-out recordings named right, sensor {seed} (%)")
        table.add_column("localizer")
        for part in (*PARTS, "mean"):
            table.add_column(part, justify="right")
        rig = Rig(design, seed, HiddenScatter(batch=0.0, modulus=0.85), fidelity="lumped")
        with tempfile.TemporaryDirectory() as folder:
            manifest = record_touches(rig, Path(folder), range(1, 13), TouchSession(), RECORDER)
            frames = RecordedFrames(manifest, nominal, NOISE, PLAN.seed)
            known = rig.transfer_function(np.minimum(nominal.frequency, 160.0))
            for name, locator in (
                ("Bayes decoder, of the design", localize.BayesDecoder(nominal, NOISE)),
                (
                    "Bayes decoder, of the made sensor",
                    localize.BayesDecoder(replace(nominal, transfer_function=known), NOISE),
                ),
                ("network, simulated only", localize.train(library, PLAN)),
                ("network, simulated and recorded", localize.train(library, PLAN, recordings=manifest)),
                (
                    "network, recorded only",
                    localize.train(library, replace(PLAN, recorded=1.0), recordings=manifest),
                ),
            ):
                found = frames.judge(locator)
                right = [100 * found[part].right for part in PARTS]
                table.add_row(name, *(f"{value:.1f}" for value in (*right, np.mean(right))))
        console.print(table)


if __name__ == "__main__":
    main([int(seed) for seed in sys.argv[1:]] or [1])
