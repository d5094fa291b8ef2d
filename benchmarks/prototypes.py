"""The paper's five prototypes: top-1 accuracy of nominal, as-built and calibrated sensors.

``python benchmarks/prototypes.py`` writes the table of docs/studies/paper_table/README.md, in some minutes of one core;
if you name
prototypes, only their rows are made.

As-built sensors are virtual rigs with all their hidden deviations. They are recorded to WAV files and calibrated from
these as the verb does. No constant was chosen on these seeds.
"""

from __future__ import annotations

import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np
import scipy.stats
from paper_table import with_interval

import acoustic_fem
import geometry
import localize
import studies
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import response_of

PAGE = Path(__file__).parents[1] / "docs" / "studies" / "paper_table" / "README.md"
BEGIN, END = "<!-- prototypes: made by benchmarks/prototypes.py -->", "<!-- end of the prototypes -->"
#: What the paper states of each, %.
STATED = {
    "array-2x6": "96.3",
    "fingertip-3x4": "> 98 (some others)",
    "fingertip-4x6": "> 98 (some others)",
    "glove": "> 98 (some others)",
    "large-area-64": "> 99",
}
FIRST, TOUCHES, NOISE = 9720, 240, 1e-3
#: Made sensors of each; of 64 points each takes minutes.
SENSORS = {**dict.fromkeys(STATED, 10), "large-area-64": 3}
#: One point of so many is recorded with a calibration microphone, for so many seconds. Of 64 points all are: fitted
#: from a quarter of them, the rest were named worse than by the design's library.
EVERY, SECONDS = {**dict.fromkeys(STATED, 4), "large-area-64": 1}, 30.0
GRID = np.arange(1.0, 161.0)
HEAD = (
    "| prototype | microphones, points | the paper (%) | nominal sensor (%) | as built, nominal decoder (%) | "
    "as built, tolerance-aware decoder (%) | as built, calibrated (%) | points recorded | sensors |"
)
COLUMNS = 9
#: The soft caps of the fingertips need less; none of the recordings may clip.
LEVEL = 0.25


def top1(decoder: localize.BayesDecoder, sensor: localize.ArrayResponse, touches: int, seed: int) -> float:
    return localize.evaluate(decoder, sensor, touches, NOISE, seed=seed).top1


def over_sensors(shares: list[float]) -> str:
    """Mean of sensors with its 95 % interval by Student's t, and the worst, %."""
    found = 100 * np.array(shares)
    half = scipy.stats.t.ppf(0.975, len(found) - 1) * found.std(ddof=1) / np.sqrt(len(found))
    return f"{found.mean():.1f} ± {half:.1f} ({found.min():.1f})"


def calibrated(rig: studies.Rig, measured: range) -> acoustic_fem.Library:
    """Library that ``calibrate`` makes from recordings of some points of an as-built sensor."""
    with tempfile.TemporaryDirectory() as folder:
        recorder = studies.Recorder(seconds=SECONDS, level=LEVEL)
        manifest = rig.record(Path(folder) / "calibration", measured, recorder)
        return studies.calibrate_sensor(manifest, Path(folder) / "made.nc", fidelity="lumped").library


def row_of(name: str, sensors: int) -> str:
    design = geometry.prototype(name)
    library = acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")
    response = response_of(library)
    touches = -(-TOUCHES // response.point_count)
    nominal, tolerant = localize.BayesDecoder(library, NOISE), localize.TolerantDecoder(library, microphone_noise=NOISE)
    measured = range(min(2, EVERY[name]), design.point_count + 1, EVERY[name])
    shares: dict[str, list[float]] = {"nominal": [], "tolerant": [], "calibrated": []}
    for seed in range(FIRST, FIRST + sensors):
        rig = studies.Rig(design, seed, fidelity="lumped")
        made = response.of_sensor(rig.transfer_function(GRID), GRID)
        known = localize.BayesDecoder(calibrated(rig, measured), NOISE)
        for key, decoder in (("nominal", nominal), ("tolerant", tolerant), ("calibrated", known)):
            shares[key].append(top1(decoder, made, touches, seed))
        print(name, seed, [f"{100 * each[-1]:.1f}" for each in shares.values()], file=sys.stderr, flush=True)
    own = with_interval(top1(nominal, response, 4 * touches, FIRST), 4 * touches * response.point_count)
    cells = [over_sensors(each) for each in shares.values()]
    counts = f"{len(response.microphones)}, {response.point_count}"
    return f"| {name} | {counts} | {STATED[name]} | {own} | {' | '.join(cells)} | {len(measured)} | {sensors} |"


def kept_rows() -> dict[str, str]:
    """Rows of the table as it stands on the page, by prototype."""
    table = PAGE.read_text(encoding="utf-8").split(BEGIN)[1].split(END)[0].strip().splitlines()
    return {line.strip("| ").split(" | ")[0]: line for line in table[2:] if line.count("|") == COLUMNS + 1}


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    rows = kept_rows()
    for name in sys.argv[1:] or list(STATED):
        rows[name] = row_of(name, SENSORS[name])
        print(rows[name], flush=True)
        lines = [HEAD, "|---" * COLUMNS + "|", *(rows[each] for each in STATED if each in rows)]
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
