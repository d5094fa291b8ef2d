"""Letters of fonts that were not used in training. ``python benchmarks/letter_fonts.py`` trains a recognizer for
large-area-64 as ``train --kind letters`` does, lets fonts be written on the array stroke by stroke, prints the table of
docs/letters.md and writes it there, in about ten minutes of one core. ``--model FOLDER`` takes a trained recognizer.

The test fonts are the single-stroke Roman and script of the package Hershey-Fonts, futural and scripts. It has them
under further names (rowmans, mathupp, meteorology; cursive) and its futuram and rowmand are futural with double lines;
none of these is trained on. The mixture was tried on fonts of the npm package hersheytext 2.0.0 (EMS Tech, EMS
Readability, EMS Nixish, EMS Elfin; EMS Felix, EMS Allure) at seed 7200, and on none of the test fonts.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path
from time import process_time

import numpy as np

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section
from localize.evaluation.accuracy import wilson_interval
from localize.recognition.handwriting import LetterMaker, LineReader
from localize.recognition.letter_classifier import Hand
from localize.recognition.letter_shapes import LETTERS
from localize.recognition.stroke_fonts import alphabet_of
from localize.signals.array_response import response_of

PAGE = Path(__file__).parents[1] / "docs" / "letters.md"
BEGIN, END = "<!-- letter fonts: made by benchmarks/letter_fonts.py -->", "<!-- end letter fonts -->"
SEED, OF_EACH = 7451, 10
FONTS = {"Roman, single strokes (`futural`)": "futural", "script, single strokes (`scripts`)": "scripts"}
FREQUENCY = np.arange(0.5, 501.0, 1.5)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--model", type=Path, help="folder of a recognizer that is trained already")
    parser.add_argument("--keep", type=Path, help="folder that the trained recognizer is saved in")
    chosen = parser.parse_args()
    response = response_of(acoustic_fem.solve(geometry.prototype("large-area-64"), FREQUENCY, "lumped"))
    begun = process_time()
    if chosen.model:
        recognizer = localize.load_recognizer(chosen.model)
    else:
        recognizer = localize.train_recognizer(response, "letters")
        print(f"trained in {process_time() - begun:.0f} s of one core", file=sys.stderr)
        if chosen.keep:
            recognizer.save(chosen.keep)
    reader = LineReader(response, "design")
    hands = {"our own hand": Hand()} | {title: Hand(alphabets=(alphabet_of(font),)) for title, font in FONTS.items()}
    lines = ["| letters of | correct (%) | most frequent errors |", "|---|---|---|"]
    for title, hand in hands.items():
        maps, kind = LetterMaker((reader,), (response,), SEED, "design", (hand,)).maps(
            "evaluation", OF_EACH * len(LETTERS)
        )
        named = recognizer.of_maps(maps).argmax(1)
        right = float((named == kind.numpy()).mean())
        low, high = (100 * end for end in wilson_interval(right, len(kind)))
        wrong = Counter((LETTERS[k], LETTERS[n]) for k, n in zip(kind.tolist(), named.tolist(), strict=True) if k != n)
        errors = ", ".join(f"{one} as {other} ({count})" for (one, other), count in wrong.most_common(4))
        lines.append(f"| {title} | {100 * right:.1f} ({low:.1f} to {high:.1f}) | {errors} |")
        print(lines[-1], file=sys.stderr)
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
