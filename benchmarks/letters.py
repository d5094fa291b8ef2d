"""Letters A to Z written on arrays. ``python benchmarks/letters.py`` trains a recognizer for each array, prints the
table of docs/letters.md and writes it there, in a quarter of an hour of one core; names of arrays do those alone.

Simulated handwriting, the noise of the design's microphone, lumped fidelity. Made sensors are the virtual rig's, read
with the nominal library and with their own. No constant was chosen on these seeds.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from time import process_time

import numpy as np
from made_sensors import made_sensors

import acoustic_fem
import geometry
import localize
from geometry.files.writing import replace_section
from localize.contacts import FEATHER, FINGER, STYLUS
from localize.evaluation.accuracy import wilson_interval
from localize.recognition.letters import LETTERS, Hand
from localize.recognition.writing import LetterMaker, LineReader
from localize.signals.array_response import ArrayResponse, response_of
from studies.output.figures import draw_confusion

ROOT = Path(__file__).parents[1]
PAGE, PICTURE = ROOT / "docs" / "letters.md", ROOT / "docs" / "images" / "letters-confusion.png"
BEGIN, END = "<!-- letters: made by benchmarks/letters.py -->", "<!-- end letters -->"
DESIGNS, SEED, OF_EACH, SENSORS = ("large-area-64", "fingertip-4x6", "array-2x6"), 71, 6, range(340, 346)
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


def column(name: str) -> list[str]:
    """Figures of one array."""
    response = response_of(acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped"))
    begun = process_time()
    recognizer = localize.train_recognizer(response, "letters")
    took = process_time() - begun
    count = OF_EACH * len(LETTERS)
    confusion = np.zeros((len(LETTERS),) * 2, np.int64)

    def cell(readers: tuple[LineReader, ...], sensors: tuple[ArrayResponse, ...], hand: Hand) -> str:
        maps, kind = LetterMaker(readers, sensors, SEED, "design", hand).maps("evaluation", count)
        named = recognizer.of_maps(maps).argmax(1)
        if len(sensors) == 1 and hand is SLOW:
            np.add.at(confusion, (kind.numpy(), named), 1)
        share = float((named == kind.numpy()).mean())
        low, high = (100 * end for end in wilson_interval(share, count))
        return f"{100 * share:.1f} ({low:.1f} to {high:.1f})"

    reader = (LineReader(response, "design"),)
    cells = [cell(reader, (response,), hand) for hand in HANDS.values()]
    made = made_sensors(response, name, SENSORS)
    cells.append(cell(reader, made, SLOW))
    cells.append(cell(tuple(LineReader(each, "design") for each in made), made, SLOW))
    if name == DESIGNS[0]:
        draw_confusion(confusion, LETTERS, PICTURE, "letter")
    return [*cells, f"{took:.0f}"]


def main() -> None:
    names = tuple(sys.argv[1:]) or DESIGNS
    titles = [
        *HANDS,
        "made sensors, nominal library",
        "made sensors, their own libraries",
        "training, processor time of one core (s)",
    ]
    columns = [column(name) for name in names]
    lines = [f"| letters told right (%) | {' | '.join(names)} |", "|---" * (len(names) + 1) + "|"]
    lines += [f"| {title} | {' | '.join(cells)} |" for title, *cells in zip(titles, *columns, strict=True)]
    print("\n".join(lines))
    if names == DESIGNS:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
