"""Time of a frame of the decoders that need no training, and of the same by their formulas alone, in one run.

``python benchmarks/decoder_time.py --write`` writes the table of docs/realtime.md anew. Frames are pushed through the
stream engine, one core, as in ``realtime.py``; touches are loud. Some minutes.
"""

from __future__ import annotations

import argparse
import os
import warnings
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from frame_time import frame_time
from plain_decoding import PlainBayes, PlainTolerant

import acoustic_fem
import geometry
import localize
from geometry.files.writing import replace_section
from localize.signals.array_response import response_of

PAGE = Path(__file__).parents[1] / "docs" / "realtime.md"
BEGIN, END = "<!-- decoder time: made by benchmarks/decoder_time.py -->", "<!-- end decoder time -->"
DESIGNS, NOISE = ("array-2x6", "line-2", "line-3", "line-4"), 1e-3


def rows_of(name: str, frames: int) -> list[str]:
    """Rows of the table of one prototype."""
    library = acoustic_fem.solve(geometry.prototype(name), np.arange(1.0, 501.0), "lumped")
    response, rows = response_of(library), []
    known, tolerant = localize.BayesDecoder(library, NOISE), localize.TolerantDecoder(library, microphone_noise=NOISE)
    pairs = (
        ("known sensor", known, PlainBayes(known)),
        ("not calibrated", tolerant, PlainTolerant(tolerant, response)),
    )
    for title, decoder, plain in pairs:
        # In turns, so that other work on the machine meets both.
        times = [[frame_time(each, response, frames // 4) for each in (plain, decoder)] for _ in range(4)]
        cells = [
            f"{np.median([each[k].processor_median for each in times]):.2f} / "
            f"{np.median([each[k].processor_worst for each in times]):.2f}"
            for k in (0, 1)
        ]
        rows.append(f"| {response.point_count} | {len(response.microphones)} | {title} | {' | '.join(cells)} |")
        print(rows[-1], flush=True)
    return rows


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--frames", type=int, default=1000)
    parser.add_argument("--designs", nargs="+", default=list(DESIGNS), choices=list(DESIGNS))
    parser.add_argument("--write", action="store_true", help="into docs/realtime.md")
    chosen = parser.parse_args()
    lines = ["| points | microphones | decoder | formulas alone (ms) | decoder (ms) |", "|---" * 5 + "|"]
    for name in chosen.designs:
        lines += rows_of(name, chosen.frames)
    if chosen.write:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
