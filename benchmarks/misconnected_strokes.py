"""Test that ``track`` finds a microphone that is reversed, exchanged, late or at another level while a finger writes.

``python benchmarks/misconnected_strokes.py`` writes the table of docs/evidence/streams.md. Each stroke of 5 s is on an
as-built sensor of its own, by the pen of benchmarks/tracks.py. Libraries are the sensor's own transfer functions, which
stand for a calibration of all points, and those of the design. ``--first`` and ``--sensors`` try others.
"""

from __future__ import annotations

import argparse
import warnings
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import numpy as np
from made_sensors import made_sensors
from misconnected import is_found
from tracks import SPEEDS, written

import acoustic_fem
import geometry
from acoustic_fem.library.transfer_functions import MEASURED
from geometry.ground.whole_files import replace_section
from localize import BayesDecoder, TouchStream
from localize.contacts import ContactRecorder
from localize.evaluation.connection_faults import ConnectionFault
from localize.evaluation.goodness_of_fit import LoudFrames, sensor_fit
from localize.live.stream_options import StreamOptions
from localize.signals import response_of

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN, END = "<!-- strokes: made by benchmarks/misconnected_strokes.py -->", "<!-- end of strokes -->"
DESIGN, FIRST, SENSORS, NOISE, PART = "array-2x6", 7500, 9, 1e-3, 1000
FAULTS = {
    "none": None,
    "reversed": ConnectionFault("reversed", ("A",)),
    "exchanged": ConnectionFault("exchanged", ("A", "B")),
    "5 ms late": ConnectionFault("late", ("A",), 0.005),
    "20 ms late": ConnectionFault("late", ("A",), 0.02),
    "100 ms early": ConnectionFault("late", ("A",), -0.1),
    "12 dB": ConnectionFault("level", ("A",), 12.0),
}


def found_by(decoder: BayesDecoder, signals: np.ndarray) -> ConnectionFault | None:
    """Fault that the check of ``track`` finds."""
    stream, loud = TouchStream(decoder, options=StreamOptions(frames=True)), LoudFrames()
    for first in range(0, signals.shape[1], PART):
        loud.take(stream.push(signals[:, first : first + PART]))
    fit = sensor_fit(decoder, loud.frames(), stream.noise, only_faults=True)
    assert fit is not None
    return fit.fault


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=FIRST)
    parser.add_argument("--sensors", type=int, default=SENSORS)
    given = parser.parse_args()
    nominal = response_of(acoustic_fem.solve(geometry.prototype(DESIGN), np.arange(0.5, 250.1, 0.5), "lumped"))
    assert nominal.position is not None
    box, names = (nominal.position.min(0), nominal.position.max(0)), nominal.microphones
    right: dict[tuple[str, int, str], list[bool]] = defaultdict(list)
    for number, made in enumerate(made_sensors(nominal, DESIGN, range(given.first, given.first + given.sensors))):
        speed = number % len(SPEEDS)
        contact = written(np.random.default_rng(number), SPEEDS[speed], box, number)
        signals = ContactRecorder(made, microphone_noise=NOISE, seed=number).take(contact, number).signals
        measured = replace(made, provenance={**made.provenance, "fidelity": MEASURED})
        for library, known in (("calibration", measured), ("design", nominal)):
            decoder = BayesDecoder(known, NOISE)
            for name, fault in FAULTS.items():
                # A fault is the correction of the opposite one.
                opposite = None if fault is None else replace(fault, amount=-fault.amount)
                found = found_by(decoder, signals if opposite is None else opposite.corrected(signals, names))
                right[library, speed, name].append(is_found(fault, found, len(names)))
                print(SPEEDS[speed], library, name, "->", found, flush=True)
    lines = ["| library | speed (mm/s) | " + " | ".join(FAULTS) + " |", "|---" * (2 + len(FAULTS)) + "|"]
    for library in ("calibration", "design"):
        for speed, (low, high) in enumerate(SPEEDS):
            cells = [right[library, speed, name] for name in FAULTS]
            counts = " | ".join(f"{sum(each)}/{len(each)}" for each in cells)
            lines.append(f"| {library} | {low:.0f} to {high:.0f} | {counts} |")
    if (given.first, given.sensors) == (FIRST, SENSORS):
        replace_section(PAGE, BEGIN, END, lines)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
