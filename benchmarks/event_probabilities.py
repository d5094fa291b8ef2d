"""Calibration of the stated probabilities: of the reports ``down`` and ``up``, and of the touches that ``locate``
prints.

``python benchmarks/event_probabilities.py --write`` writes the table of docs/evidence/streams.md, without the rows in
which every answer was correct. Signals are those of ``streams.py``: taps and presses of 1 to 10 Pa on sensors as
designed and as built. Seeds begin at ``FIRST``; constants were chosen on 9100 to 9102.
"""

from __future__ import annotations

import argparse
import warnings
from collections import defaultdict
from pathlib import Path

import numpy as np
from streams import FREQUENCY, PERIOD, Sensor, session

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import response_of

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN = "<!-- event probabilities: made by benchmarks/event_probabilities.py -->"
END = "<!-- end event probabilities -->"
DESIGNS, FIRST, BINS = ("array-2x6", "line-2"), 9600, 10
KINDS = ("tap", "press")


def events_of(decoder: localize.BayesDecoder, sensor: Sensor, kind: str) -> list[tuple[str, float, bool]]:
    """Kind, stated probability and whether the point was right of the events, and the touches, of a record."""
    random = np.random.default_rng([sensor.seed, 5, len(kind)])
    made = session(kind, sensor.design.point_count, random)
    signals = sensor.heard(made) + sensor.own_noise(PERIOD, random)
    sound = localize.SoundTest(response_of(sensor.library), "design")
    stream = localize.TouchStream(decoder, sound_test=sound)
    tracker = localize.TouchTracker(decoder, stream.delay)
    events = stream.push(signals)
    told = [each for event in events for each in tracker.take(event)] + tracker.finish()
    begins, points = [touch.begin for touch, _ in made], [touch.point for touch, _ in made]
    # A touch is of what was touched when it came down: it may go up when the next one has begun.
    came = {event.touch: event.time for event in told if event.kind == "down"}
    of = [int(np.searchsorted(begins, 1000 * came[event.touch], side="right")) - 1 for event in told]
    found = [(each.kind, each.probability, each.point == points[k]) for each, k in zip(told, of, strict=True) if k >= 0]
    for touch in localize.touches_of(events, decoder):
        k = int(np.searchsorted(begins, 1000 * touch.start, side="right")) - 1
        found += [("touch", touch.probability, touch.point == points[k])] if k >= 0 else []
    return found


def cell_of(found: list[tuple[float, bool]]) -> str:
    """Number of events, fraction that is correct, mean stated probability and expected calibration error."""
    stated, right = (np.array(each, float) for each in zip(*found, strict=True))
    bins = np.minimum((stated * BINS).astype(int), BINS - 1)
    error = sum(abs((right - stated)[bins == k].sum()) for k in range(BINS)) / len(stated)
    return f"{len(stated)}/{right.mean():.2f}/{stated.mean():.2f}/{error:.2f}"


def rows_of(name: str, sensors: int, options: localize.TolerantOptions) -> list[str]:
    """Rows of the table of one prototype."""
    library, rows = acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped"), []
    tolerant = localize.TolerantDecoder(library, microphone_noise="design", options=options)
    for title in ("as designed", "as built, not calibrated", "as built, calibrated"):
        for kind in KINDS:
            told = defaultdict[str, list[tuple[float, bool]]](list)
            for number in range(sensors):
                sensor = Sensor(library, number, FIRST, title == "as designed")
                known = title == "as built, calibrated"
                decoder = localize.BayesDecoder(sensor.calibrated, "design") if known else tolerant
                for what, stated, right in events_of(decoder, sensor, kind):
                    told[what].append((stated, right))
            cells = " | ".join(cell_of(told[what]) for what in ("down", "up", "touch"))
            rows.append(f"| {name} | {title} | {kind} | {cells} |")
            print(rows[-1], flush=True)
            if all(right for each in told.values() for _, right in each):
                rows.pop()
    return rows


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--sensors", type=int, default=2)
    parser.add_argument("--air-of-design", action="store_true", help="no other air and rubber is considered")
    parser.add_argument("--write", action="store_true", help="into docs/evidence/streams.md")
    chosen = parser.parse_args()
    options = localize.TolerantOptions()
    if chosen.air_of_design:
        options = localize.TolerantOptions(hypotheses=localize.HypothesisOptions(air_and_rubber=None))
    lines = ["| design | sensor | touches | `down` | `up` | touch |", "|---" * 6 + "|"]
    for name in DESIGNS:
        lines += rows_of(name, chosen.sensors, options)
    if chosen.write:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
