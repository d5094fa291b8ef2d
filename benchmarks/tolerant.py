"""Decoders for a sensor that nobody calibrated: the nominal and the tolerance-aware decoder.

``python benchmarks/tolerant.py --write`` writes docs/evidence/tolerant.csv and the table of docs/evidence/decoder.md,
in a quarter of an hour of one core; ``--sensors 4 --designs line-2`` is a quick trial. Signals are those of virtual
rigs (:mod:`studies.test_rig.virtual_rig`), which deviate in more ways than the decoder models. Seeds begin at
``FIRST``, and no constant was chosen on them.
"""

from __future__ import annotations

import argparse
import csv
import io
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section, write_text
from localize.evaluation.accuracy import Evaluation
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.stimulus_kinds import STIMULI
from studies.test_rig.virtual_rig import HiddenScatter, Rig

EVIDENCE = Path(__file__).parents[1] / "docs" / "evidence"
PAGE, ROWS = EVIDENCE / "decoder.md", EVIDENCE / "tolerant.csv"
BEGIN, END = "<!-- tolerant: made by benchmarks/tolerant.py -->", "<!-- end tolerant -->"
FIRST, SENSORS, TOUCHES = 9500, 20, 144
NOISE = 1e-3
KINDS = ("multi-sines", "taps", "friction")
DECODERS = ("nominal", "tolerant")
FIGURES = ("top1", "5th_percentile", "error")
#: Columns of the file: figures of each decoder and kind of touches.
COLUMNS = [f"{decoder}_{figure}_{kind}" for decoder in DECODERS for figure in FIGURES for kind in KINDS]
HEAD = ["design", "sensor", *COLUMNS, "nominal_ms", "tolerant_ms"]
Record = dict[str, str]
UNIFORM: Mapping[str, Any] = {
    "tube.inner_diameter": 0.94,
    "tube.outer_diameter": 1.4,
    "tube.length": 9.35,
    "resonator.cavity_height": 4.7,
    "membrane.thickness": 1.66,
}
#: Found by docs/examples/ring-3x12-search.toml: between three microphones, twelve points on each line.
RING: Mapping[str, Any] = {
    "tube.inner_diameter": 0.9412,
    "tube.length": 29.17,
    "resonator.cavity_height": 5.609,
    "membrane.thickness": 1.836,
}
DESIGNS: Mapping[str, tuple[str, Mapping[str, Any]]] = {
    "line-2": ("line-2", {}),
    "best uniform 36": ("line-2", UNIFORM),
    "best uniform 3 x 12": ("docs/examples/ring-3x12.toml", RING),
    "graded 36 of stock parts": ("docs/examples/graded-line-36.toml", {}),
    "array-2x6": ("array-2x6", {}),
    "fingertip-4x6": ("fingertip-4x6", {}),
}
#: 5 % of bores and volumes, 10 % of membranes, and nothing else.
PARTS = HiddenScatter(
    batch=0.0, gain=0.0, corner=0.0, chamber=0.0, length=0.0, loss=0.0, temperature=0.0, pressure=0.0, slope=0.0
)
NONE = replace(PARTS, bore=0.0, volume=0.0, membrane=0.0)


@dataclass(frozen=True)
class Truth:
    """Kind of sensors that touches are of."""

    name: str
    scatter: HiddenScatter
    pressure: float | None = None
    """Pressure of the place, Pa, where it is not the design's."""
    is_told: bool = False
    """Whether the decoder is told that pressure."""

    @property
    def is_one(self) -> bool:
        """True if there is one such sensor only: nothing is drawn."""
        return self.scatter.bore == 0.0


TRUTHS = (
    Truth("as designed", NONE),
    Truth("parts deviate", PARTS),
    Truth("everything deviates", HiddenScatter()),
    Truth("2000 m, altitude not given", NONE, 79500.0),
    Truth("2000 m, altitude given", NONE, 79500.0, True),
    Truth("modulus -20 %", replace(NONE, modulus=0.8)),
    Truth("modulus +16 %", replace(NONE, modulus=1.16)),
    Truth("modulus +34 %", replace(NONE, modulus=1.34)),
)
#: In the table of the page; the file has all.
SHOWN = ("as designed", "everything deviates", "2000 m, altitude not given", "modulus -20 %")


def frame_time(decoder: localize.BayesDecoder, response: ArrayResponse) -> float:
    """Processor time of a frame that comes alone, ms."""
    frames = localize.TouchGenerator(response, 0, "evaluation", 1e-3).samples(0, 100).signals[..., -250:].numpy()
    begin = process_time()
    for frame in frames:
        decoder.locate(frame)
    return 1e3 * (process_time() - begin) / len(frames)


def judged(
    decoder: localize.BayesDecoder, sensors: list[ArrayResponse], kind: str
) -> tuple[NDArray[np.float64], float]:
    """Top-1 of each sensor, %, and the expected calibration error of all together."""
    touches = max(2, -(-TOUCHES // sensors[0].point_count) * (4 if len(sensors) == 1 else 1))
    found: list[Evaluation] = [
        localize.evaluate(decoder, sensor, touches, NOISE, seed=FIRST + k, stimuli=STIMULI[kind])
        for k, sensor in enumerate(sensors)
    ]
    return 100 * np.array([each.top1 for each in found]), _error(found)


def cells_of(decoder: localize.BayesDecoder, sensors: list[ArrayResponse]) -> list[str]:
    """Cells of a record: of all kinds the mean top-1, its 5th percentile over sensors, the calibration error."""
    found = [judged(decoder, sensors, kind) for kind in KINDS]
    means = [f"{top1.mean():.1f}" for top1, _ in found]
    low = [f"{np.quantile(top1, 0.05):.1f}" if len(sensors) > 1 else "" for top1, _ in found]
    return [*means, *low, *(f"{error:.2f}" for _, error in found)]


def _error(found: list[Evaluation]) -> float:
    """Expected calibration error of the touches of all evaluations, bin by bin."""
    total = sum(each.touches for each in found)
    error = 0.0
    for bins in zip(*(each.reliability.bins for each in found), strict=True):
        held = [(each.touches, each.right, each.stated) for each in bins if each.touches]
        error += abs(sum(count * (right - stated) for count, right, stated in held)) / total
    return error


def decoders_of(library: acoustic_fem.Library) -> tuple[localize.BayesDecoder, localize.TolerantDecoder]:
    """The nominal and the tolerance-aware decoder."""
    return localize.BayesDecoder(library, NOISE), localize.TolerantDecoder(library, microphone_noise=NOISE)


def records_of(name: str, sensors: int) -> list[Record]:
    """Records of one design."""
    base, values = DESIGNS[name]
    root = Path(__file__).parents[1]
    stated = geometry.load_design(root / base) if base.endswith(".toml") else geometry.prototype(base)
    design = stated.with_values(dict(values))
    library = acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")
    response, grid, records = response_of(library), np.arange(1.0, 161.0), []
    told_nothing = decoders_of(library)
    times = [f"{frame_time(each, response):.1f}" for each in told_nothing]
    for truth in TRUTHS:
        there = design if truth.pressure is None else design.with_values({"air.pressure": truth.pressure})
        rigs = [Rig(there, FIRST + k, truth.scatter, fidelity="lumped") for k in range(1 if truth.is_one else sensors)]
        made = [response.of_sensor(rig.transfer_function(grid), grid) for rig in rigs]
        decoders = decoders_of(library.in_air(pressure=truth.pressure)) if truth.is_told else told_nothing
        cells = [cell for each in decoders for cell in cells_of(each, made)]
        records.append(dict(zip(HEAD, (name, truth.name, *cells, *times), strict=True)))
        print(*records[-1].values(), sep=", ", flush=True)
    return records


def table_of(records: Sequence[Record]) -> list[str]:
    """The table of the page: a column for each design, nominal / tolerance-aware decoder, multi-sines and taps."""
    designs = list(dict.fromkeys(record["design"] for record in records))
    lines = [f"| sensor | {' | '.join(designs)} |", "|---" * (len(designs) + 1) + "|"]
    for kind in KINDS[:2]:
        for figure in FIGURES[:2]:
            for sensor in SHOWN:
                of_it = [record for record in records if record["sensor"] == sensor]
                cells = ["/".join(each[f"{decoder}_{figure}_{kind}"] for decoder in DECODERS) for each in of_it]
                if cells[0] != "/":
                    title = f"{sensor}, 5th percentile" if figure == FIGURES[1] else sensor
                    lines.append(f"| {kind}, {title} | {' | '.join(cells)} |")
    return lines


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--designs", nargs="+", default=list(DESIGNS), choices=list(DESIGNS))
    parser.add_argument("--write", action="store_true", help="into docs/evidence")
    chosen = parser.parse_args()
    records = [record for name in chosen.designs for record in records_of(name, chosen.sensors)]
    print("\n".join(table_of(records)))
    if chosen.write:
        text = io.StringIO()
        writer = csv.DictWriter(text, HEAD, lineterminator="\n")
        writer.writeheader()
        writer.writerows(records)
        write_text(ROWS, text.getvalue())
        replace_section(PAGE, BEGIN, END, table_of(records))


if __name__ == "__main__":
    main()
