"""Letters A to Z written on arrays. ``python benchmarks/letters.py`` trains a recognizer for each array, prints the
table of docs/evidence/moving-touches.md and writes it there, in three quarters of an hour of one core. If you name
arrays, only their columns are made.

The handwriting is simulated at lumped fidelity with the noise of the design's microphone. As-built sensors are virtual
rigs. They are decoded with the nominal library, with their own, and with libraries that `calibrate` makes from
recordings. No constant was chosen on these seeds. Constants were chosen on 7200 to 7206, with sensors 400 to 405.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from time import process_time

import numpy as np
from made_sensors import calibrated, made_sensors

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section
from localize.contacts import FEATHER, FINGER, STYLUS
from localize.evaluation.accuracy import wilson_interval
from localize.recognition.handwriting import LetterMaker, LineReader
from localize.recognition.letter_classifier import Hand
from localize.recognition.letter_shapes import LETTERS
from localize.signals.array_response import ArrayResponse, response_of
from studies.output.response_figures import draw_confusion

ROOT = Path(__file__).parents[1]
PAGE, PICTURE = ROOT / "docs" / "evidence" / "moving-touches.md", ROOT / "docs" / "images" / "letters-confusion.png"
BEGIN, END = "<!-- letters: made by benchmarks/letters.py -->", "<!-- end letters -->"
DESIGNS, SEED, SENSORS = ("large-area-64", "fingertip-4x6", "array-2x6"), 7421, range(7420, 7426)
OF_EACH, OF_TARGETS = 6, 36
"""Number of each letter, and where a target was set."""
FREQUENCY = np.arange(0.5, 501.0, 1.5)
SLOW = Hand()
HANDS = {
    "25 to 60 mm/s": SLOW,
    "60 to 120 mm/s": replace(SLOW, speed=(60.0, 120.0)),
    "120 to 200 mm/s": replace(SLOW, speed=(120.0, 200.0)),
    "a light finger, 3 to 6 mm": replace(SLOW, tool=FINGER),
    "a stylus": replace(SLOW, tool=STYLUS),
    "a feather": replace(SLOW, tool=FEATHER),
}
TARGETS = ("25 to 60 mm/s", "60 to 120 mm/s")


def column(name: str) -> list[str]:
    """Figures of one array."""
    response = response_of(acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped"))
    begun = process_time()
    recognizer = localize.train_recognizer(response, "letters")
    took = process_time() - begun
    confusion = np.zeros((len(LETTERS),) * 2, np.int64)
    of_targets = OF_TARGETS if name == DESIGNS[0] else OF_EACH

    def cell(readers: tuple[LineReader, ...], sensors: tuple[ArrayResponse, ...], hand: Hand, of_each: int) -> str:
        count = of_each * len(LETTERS)
        maps, kind = LetterMaker(readers, sensors, SEED, "design", (hand,)).maps("evaluation", count)
        named = recognizer.of_maps(maps).argmax(1)
        if len(sensors) == 1 and hand is SLOW:
            np.add.at(confusion, (kind.numpy(), named), 1)
        share = float((named == kind.numpy()).mean())
        low, high = (100 * end for end in wilson_interval(share, count))
        print(f"{name}: {hand.speed}, {hand.tool.name}, {len(sensors)} sensors: {100 * share:.1f}", file=sys.stderr)
        return f"{100 * share:.1f} ({low:.1f} to {high:.1f})"

    reader = (LineReader(response, "design"),)
    cells = []
    for title, hand in HANDS.items():
        cells.append(cell(reader, (response,), hand, of_targets if title in TARGETS else OF_EACH))
    made = made_sensors(response, name, SENSORS)
    cells.append(cell(reader, made, SLOW, OF_EACH))
    for known in (made, calibrated(name, SENSORS)):
        cells.append(cell(tuple(LineReader(each, "design") for each in known), made, SLOW, of_targets))
    if name == DESIGNS[0]:
        draw_confusion(confusion, LETTERS, PICTURE, "letter")
    return [*cells, f"{took:.0f}"]


def kept_columns() -> dict[str, list[str]]:
    """Columns of the table as it stands on the page, by array."""
    table = PAGE.read_text().split(BEGIN)[1].split(END)[0].strip().splitlines()
    head, _, *rows = [[each.strip() for each in line.strip("|").split("|")] for line in table]
    return {name: [row[k] for row in rows] for k, name in enumerate(head) if k}


def main() -> None:
    titles = [
        *HANDS,
        "as-built, nominal library",
        "as-built, their own libraries",
        "as-built, calibrated from recordings",
        "training, processor time of one core (s)",
    ]
    for name in sys.argv[1:] or DESIGNS:
        made = column(name)
        kept = {each: cells for each, cells in kept_columns().items() if len(cells) == len(titles)}  # else former ones
        columns = {**kept, name: made}
        lines = [f"| letters recognised correctly (%) | {' | '.join(columns)} |", "|---" * (len(columns) + 1) + "|"]
        lines += [f"| {title} | {' | '.join(cells)} |" for title, *cells in zip(titles, *columns.values(), strict=True)]
        print("\n".join(lines))
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
