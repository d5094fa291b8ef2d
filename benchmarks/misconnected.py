"""Test that ``locate`` finds a microphone that is reversed, exchanged, late or at another level, and says nothing else.

``python benchmarks/misconnected.py`` writes the table of docs/evidence/streams.md anew, in half an hour of one core.
Signals are taps and friction that virtual rigs record, six points each, of seeds from ``FIRST`` on, of which no
constant was chosen; ``--first 7100 --sensors 4`` for those on which they were. Libraries are those of a calibration of
all points of the same rig, and of its design.
"""

from __future__ import annotations

import argparse
import tempfile
import warnings
from collections import defaultdict
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
import studies
from geometry import ArrayDesign
from geometry.ground.whole_files import replace_section
from localize import BayesDecoder, Locator, TolerantDecoder, TouchStream, read_recording
from localize.evaluation.connection_faults import ConnectionFault
from localize.evaluation.goodness_of_fit import MARGIN, LoudFrames, sensor_fit
from localize.live.stream_options import StreamOptions
from localize.signals.frames import FRAME
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import Recorder, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN, END = "<!-- misconnected: made by benchmarks/misconnected.py -->", "<!-- end of misconnected -->"
FIRST = 9800
DESIGNS = {"array-2x6": 40, "fingertip-4x6": 10, "glove": 20}
"""Number of rigs of each design."""
BY_DESIGN = {"array-2x6": 8, "fingertip-4x6": 8, "glove": 2}
"""Number of rigs of each design that are checked by the library of the design too, which takes most of the time."""
POINTS = 6
SESSION = TouchSession(takes=1, seconds=4.0, parts=("taps", "friction"))
KINDS = ("none", "reversed", "exchanged", "late", "level")
LATE, LEVEL = (3e-3, 0.09), (7.0, 20.0)
"""Ranges of the lateness, s, and of the level, dB, that are drawn, each with either sign."""
LATER = {"glove": 0.25}
"""Largest lateness for some designs, s: their figures are younger than the search for delays above 100 ms."""


class _Anyhow(Locator):
    """Locator that names no point: which one it is does not matter here, and takes the time."""

    def __init__(self, decoder: Locator) -> None:
        self.array = decoder.array

    def _probability(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.ones((len(batch), 1))


@dataclass(frozen=True)
class Found:
    """What the check made of one session."""

    right: bool
    """True if it found the fault that there is, or none where there is none."""
    accuracy: float
    """Fraction of the loud frames that are assigned to the correct point without a correction."""
    probability: float
    """Mean stated probability of these points, lowered by the trust."""


def fault_of(kind: str, design: ArrayDesign, random: np.random.Generator) -> ConnectionFault | None:
    """Fault of a kind at microphones that are drawn."""
    names, latest = design.microphones, LATER.get(design.name, LATE[1])
    chosen = sorted(random.choice(len(names), 2, replace=False).tolist())
    sign = float(random.choice([-1, 1]))
    if kind == "reversed":
        return ConnectionFault("reversed", (names[chosen[0]],))
    if kind == "exchanged":
        return ConnectionFault("exchanged", (names[chosen[0]], names[chosen[1]]))
    if kind == "late":
        return ConnectionFault(
            "late", (names[chosen[0]],), sign * float(np.exp(random.uniform(*np.log((LATE[0], latest)))))
        )
    return ConnectionFault("level", (names[chosen[0]],), sign * random.uniform(*LEVEL)) if kind == "level" else None


def is_found(fault: ConnectionFault | None, found: ConnectionFault | None, count: int) -> bool:
    """True if a fault was found: its kind, its microphones and its amount to 2 dB or 1 ms."""
    if fault is None or found is None:
        return fault is found
    amount = found.amount
    if count == 2 and found.microphones != fault.microphones:  # only the difference is known
        amount = -amount
    elif found.microphones != fault.microphones:
        return False
    return found.kind == fault.kind and abs(amount - fault.amount) < (1e-3 if fault.kind == "late" else 2.0)


def recorded(rig: Rig, folder: Path) -> list[tuple[int, NDArray[np.float64]]]:
    """Points and recordings, (n_microphone, n) Pa, of touches at some of a rig's points."""
    chosen = np.random.default_rng(rig.seed).choice(np.arange(1, rig.design.point_count + 1), POINTS, replace=False)
    recorder = Recorder(output="pressure")
    record_touches(rig, folder, sorted(chosen.tolist()), SESSION, recorder)
    names = rig.design.microphones
    return [
        (int(path.name.split("-")[1]), read_recording(path, names, recorder.full_scale).signals)
        for path in sorted(folder.glob("*.wav"))
    ]


def calibrated(rig: Rig, folder: Path) -> BayesDecoder:
    """Decoder of the library that a calibration of all points gives."""
    manifest = rig.record(folder / "recordings", range(1, rig.design.point_count + 1), Recorder(seconds=30.0))
    return BayesDecoder(studies.calibrate_sensor(manifest, folder / "made.nc", fidelity="lumped").library)


def checked(
    decoders: dict[str, Locator], heard: list[tuple[int, NDArray[np.float64]]], fault: ConnectionFault | None
) -> dict[str, Found]:
    """What the check makes of a session with a fault, by each decoder."""
    names = next(iter(decoders.values())).microphones
    # A fault is the correction of the opposite one.
    made = None if fault is None else replace(fault, amount=-fault.amount)
    frames, points = [], []
    for point, signals in heard:
        loud = LoudFrames()
        spoilt = signals if made is None else made.corrected(signals, names)
        stream = TouchStream(_Anyhow(decoders["calibration"]), options=StreamOptions(frames=True))
        loud.take(stream.push(spoilt))
        own = loud.frames()
        frames += own
        points += [point] * len(own)
    level = np.array([each.std(1).max() for each in frames])
    kept = np.argsort(-level, kind="stable")[:32]
    batch, truth = np.array(frames)[kept], np.array(points)[kept]
    results = {}
    for name, decoder in decoders.items():
        fit = sensor_fit(decoder, batch)
        assert fit is not None
        probability = decoder.locate(batch[..., MARGIN : MARGIN + FRAME])
        stated = fit.trust * probability.max(1).mean() + (1 - fit.trust) / decoder.point_count
        right = float((probability.argmax(1) + 1 == truth).mean())
        results[name] = Found(
            is_found(fault, fit.fault, len(names)) and (fault is not None or fit.warning is None), right, float(stated)
        )
        print(
            "  ", name, fault, "->", fit.fault, f"{fit.misfit:.3g} {fit.corrected_misfit} {results[name]}", flush=True
        )
    return results


def sessions(design: ArrayDesign, seed: int, nominal: TolerantDecoder | None) -> dict[tuple[str, str], Found]:
    """What the check makes of all sessions of a rig, by the library and the fault."""
    rig, random = Rig(design, seed, fidelity="lumped"), np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as folder:
        heard = recorded(rig, Path(folder) / "touches")
        decoders: dict[str, Locator] = {"calibration": calibrated(rig, Path(folder))}
    if nominal is not None:
        decoders["design"] = nominal
    found = {}
    for kind in KINDS:
        results = checked(decoders, heard, fault_of(kind, design, random))
        found.update({(name, kind): result for name, result in results.items()})
    return found


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=FIRST)
    parser.add_argument("--sensors", type=int, help="rigs of each design; by default 50 in all")
    parser.add_argument("--designs", nargs="*", default=list(DESIGNS))
    given = parser.parse_args()
    cells: dict[tuple[str, str, str], list[Found]] = defaultdict(list)
    for name in given.designs:
        design = geometry.prototype(name)
        nominal = TolerantDecoder(acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped"))
        for seed in range(given.first, given.first + (given.sensors or DESIGNS[name])):
            print(name, seed, flush=True)
            also = nominal if seed < given.first + BY_DESIGN[name] else None
            for (library, kind), found in sessions(design, seed, also).items():
                cells[name, library, kind].append(found)
    lines = ["| design | library | " + " | ".join(KINDS) + " | accuracy | stated probability |", "|---" * 9 + "|"]
    lines[1] = "|---" * (4 + len(KINDS)) + "|"
    for name in given.designs:
        for library in ("calibration", "design"):
            each = [cells[name, library, kind] for kind in KINDS]
            wrong = [found for of_kind in each[1:] for found in of_kind]
            counts = " | ".join(f"{sum(found.right for found in of_kind)}/{len(of_kind)}" for of_kind in each)
            accuracy, stated = (
                100 * np.mean([getattr(found, of) for found in wrong]) for of in ("accuracy", "probability")
            )
            lines.append(f"| {name} | {library} | {counts} | {accuracy:.0f} | {stated:.0f} |")
    if given.first == FIRST and given.sensors is None:
        replace_section(PAGE, BEGIN, END, lines)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
