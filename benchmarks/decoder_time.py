"""Time of a frame of the decoders that need no training, and of the same by their formulas alone, in one run.

``python benchmarks/decoder_time.py``. Frames are pushed through the stream engine, one core, as in ``realtime.py``;
touches are loud. Some minutes.
"""

from __future__ import annotations

import argparse
import os
import warnings

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from frame_time import frame_time
from plain_decoding import PlainBayes, PlainTolerant

import acoustic_fem
import geometry
import localize
from localize.signals.array_response import response_of

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
    return rows


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--frames", type=int, default=1000)
    parser.add_argument("--designs", nargs="+", default=list(DESIGNS), choices=list(DESIGNS))
    chosen = parser.parse_args()
    print(
        "| points | microphones | decoder | formulas alone, p50 / p99 (ms) | decoder, p50 / p99 (ms) |\n"
        + "|---" * 5
        + "|"
    )
    for name in chosen.designs:
        for row in rows_of(name, chosen.frames):
            print(row, flush=True)


if __name__ == "__main__":
    main()
