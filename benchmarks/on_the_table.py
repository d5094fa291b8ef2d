"""Accuracy of a sensor in use: recorded, calibrated and aged, each step by the verbs that a designer uses.

``python benchmarks/on_the_table.py --write`` writes a table of docs/evidence/calibration.md, in half an hour of one
core; ``--designs array-2x6 --sensors 2`` is a quick trial. Sensors are virtual rigs at ``navier-stokes`` fidelity, each
with its own batch of rubber. Seeds begin at ``FIRST``, and no constant was chosen on them. The rigs record a
calibration and touches of fingers with hum and slow drift. No decoder is given the spectrum, hysteresis and slow
pressure of these touches. The decisions of ``locate`` with its defaults are evaluated, recording by recording.
"""

from __future__ import annotations

import argparse
import tempfile
import warnings
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
import studies
from geometry.ground.whole_files import replace_section
from localize import Decision, read_recording, touches_of
from localize.model.opening import opened as open_decoding
from localize.recordings.touch_manifest import Part, read_touch_manifest
from studies import Decoding
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import HiddenScatter, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "calibration.md"
BEGIN, END = "<!-- on the table: made by benchmarks/on_the_table.py -->", "<!-- end of on the table -->"
FIRST, SECONDS = 9700, 6.0
SENSORS = {"array-2x6": 6, "line-2": 2}
AGED = 0.8
"""Modulus of a batch after its sensors were calibrated, against before."""
KINDS: tuple[Part, ...] = ("taps", "friction")


@dataclass
class Counts:
    """Decisions about the touches of one sensor."""

    right: dict[str, list[bool]] = field(default_factory=lambda: {kind: [] for kind in KINDS})
    stated: list[float] = field(default_factory=list)
    touches: list[bool] = field(default_factory=list)

    @property
    def error(self) -> float:
        """Expected calibration error of the probabilities of frames, over tenths."""
        right = np.concatenate([np.array(self.right[kind], bool) for kind in KINDS])
        stated = np.array(self.stated)
        tenth = np.minimum((10 * stated).astype(int), 9)
        return float(sum(abs((right[tenth == k] - stated[tenth == k]).sum()) for k in range(10)) / len(stated))

    @property
    def cells(self) -> tuple[float, ...]:
        """Correct frames of each kind and correct touches, %, and the calibration error of the probabilities."""
        frames = (100 * float(np.mean(self.right[kind])) for kind in KINDS)
        return (*frames, 100 * float(np.mean(self.touches)), self.error)


@dataclass(frozen=True)
class Case:
    """One choice of library and options for decoding a session of touches."""

    name: str
    session: str
    library: str
    decoding: Decoding = field(default_factory=Decoding)


CASES = (
    Case("not calibrated", "new", "design.nc"),
    Case("calibrated", "new", "made.nc"),
    Case("aged", "aged", "made.nc"),
    Case("aged, followed", "aged", "made.nc", Decoding(follow_drift=True)),
    Case("calibrated, followed", "new", "made.nc", Decoding(follow_drift=True)),
)


def counted(manifest: Path, model: Path, decoding: Decoding, points: int) -> Counts:
    """Decisions on all recordings of a session, in an order that is drawn, by one decoder and a stream for each.

    Args:
        manifest: of the session.
        model: the library.
        decoding: as of the verb ``locate``.
        points: of the array.
    """
    session, counts = read_touch_manifest(manifest, points), Counts()
    opened = open_decoding(model, replace(decoding, microphone_output=session.output))
    array = opened.locator.array
    for k in np.random.default_rng(FIRST).permutation(len(session.recordings)):
        each = session.recordings[k]
        heard = read_recording(each.path, array.microphones, session.full_scale)
        decided = opened.stream().push(heard.signals)
        frames = [event for event in decided if isinstance(event, Decision) and event.point is not None]
        counts.right[each.part] += [frame.point == each.point for frame in frames]
        counts.stated += [float(frame.probability or 0.0) for frame in frames]
        counts.touches += [touch.point == each.point for touch in touches_of(decided, array)]
    return counts


def rows_of(name: str, sensors: int) -> list[str]:
    """Rows of the table of one design."""
    found: dict[str, list[Counts]] = {case.name: [] for case in CASES}
    design = geometry.prototype(name)
    session = TouchSession(takes=1, seconds=SECONDS, parts=KINDS)
    for seed in range(FIRST, FIRST + sensors):
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            made = studies.record_rig(design, folder / "new", seed=seed, fidelity="navier-stokes", session=session)
            aged = Rig(design, seed, HiddenScatter(modulus=AGED), "navier-stokes")
            points = range(1, design.point_count + 1)
            manifests = {"new": made.touches, "aged": record_touches(aged, folder / "aged", points, session)}
            acoustic_fem.save(acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped"), folder / "design.nc")
            studies.calibrate_sensor(made.calibration, folder / "made.nc", fidelity="lumped")
            for case in CASES:
                counts = counted(manifests[case.session], folder / case.library, case.decoding, design.point_count)
                found[case.name].append(counts)
                print(seed, case.name, *counts.cells, flush=True)
    return [f"| {name} | {case} | {_row(counts)} |" for case, counts in found.items()]


def _row(sensors: list[Counts]) -> str:
    table = np.array([each.cells for each in sensors])
    right = (f"{mean:.1f}/{least:.1f}" for mean, least in zip(table[:, :3].mean(0), table[:, :3].min(0), strict=True))
    return " | ".join([*right, f"{table[:, 3].mean():.2f}"])


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    parser = argparse.ArgumentParser()
    parser.add_argument("--sensors", type=int)
    parser.add_argument("--designs", nargs="+", default=list(SENSORS), choices=list(SENSORS))
    parser.add_argument("--write", action="store_true", help="into docs/evidence/calibration.md")
    chosen = parser.parse_args()
    lines = [
        "| design | library | frames of taps | frames of friction | touches | error |",
        "|---|---|---|---|---|---|",
    ]
    for name in chosen.designs:
        rows = rows_of(name, chosen.sensors or SENSORS[name])
        print("\n".join(rows), flush=True)
        lines += rows
    if chosen.write:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
