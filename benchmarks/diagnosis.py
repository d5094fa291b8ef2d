"""Faults named by a diagnosis, on as-built sensors of unseen seeds, and sound sensors that are accused.

``python benchmarks/diagnosis.py`` writes the tables of docs/diagnosis.md; names of designs restrict it to these, and
``--sensors 5 --seed 900`` to fewer, other sensors. Sensors are virtual rigs, whose lengths, losses, relaxations, air
and pressure the diagnosis does not know. Every fault of every sensor has an amount of its own, drawn between those that
are tried. A session is 24 taps and presses; with four known points, those of touches 1, 8, 14 and 21.
"""

from __future__ import annotations

import argparse
import warnings
from collections import Counter, defaultdict
from dataclasses import replace
from pathlib import Path
from time import process_time

import numpy as np

import acoustic_fem
import geometry
from geometry.ground.whole_files import replace_section
from localize.diagnosis import Diagnoser, Diagnosis, SensorFault, single_faults
from localize.evaluation import wilson_interval
from studies.test_rig.faulty_rig import DiagnosisSession, FaultyRig, diagnosis_session

PAGE = Path(__file__).parents[1] / "docs" / "diagnosis.md"
BEGIN, END = "<!-- diagnosis: made by benchmarks/diagnosis.py -->", "<!-- end diagnosis -->"
SENSORS, SEED, FAULTS = {"array-2x6": 20, "glove": 6, "line-2": 3}, 47000, 6
KNOWN = (0, 7, 13, 20)
AMOUNTS = {"blocked tube": (0.15, 0.45), "leak": (0.2, 0.5), "quiet microphone": (-20.0, -8.0)}
ROWS = ("inner tube blocked", "tube at a microphone blocked", "leak", "quiet microphone", "dead microphone",
        "reversed microphone", "exchanged microphones")  # fmt: skip


def drawn_faults(design: geometry.ArrayDesign, seed: int) -> list[SensorFault]:
    """Faults of a sensor: some tubes, some leaks and all of its microphones, each with an amount of its own."""
    random = np.random.default_rng([seed, 46])
    every = [part[0] for part in single_faults(design)]
    tubes, leaks = ([each for each in every if each.kind == kind] for kind in ("blocked tube", "leak"))
    chosen = [each for each in every if each not in tubes and each not in leaks]
    for some in (tubes, leaks):
        chosen += [some[k] for k in random.permutation(len(some))[:FAULTS]]
    chosen += [replace(each, amount=-60.0) for each in every if each.kind == "quiet microphone"]
    return [
        each if each.kind not in AMOUNTS or each.amount == -60.0
        else replace(each, amount=float(random.uniform(*AMOUNTS[each.kind])))
        for each in chosen
    ]  # fmt: skip


def row_of(design: geometry.ArrayDesign, fault: SensorFault) -> str:
    if fault.kind == "blocked tube":
        count, ends = 0, set()
        for line in design.lines:
            ends |= {count + 1, count + line.points + 1}
            count += line.points + 1
        return ROWS[1] if fault.part[0] in ends else ROWS[0]
    if fault.kind == "quiet microphone":
        return ROWS[4] if fault.amount <= -40 else ROWS[3]
    return fault.kind


def diagnosed(diagnoser: Diagnoser, session: DiagnosisSession, known: str) -> Diagnosis:
    """Diagnosis; a touch that is too quiet to be found is not given."""
    points = points_of(session, known)
    while True:
        try:
            return diagnoser.diagnose(session.signals, points)
        except geometry.Refusal as error:
            if not points or error.field != "points":
                raise
            points.popitem()


def points_of(session: DiagnosisSession, known: str) -> dict[float, int] | None:
    if known == "none":
        return None
    return {float(session.time[k]): int(session.point[k]) for k in KNOWN}


def verdict_of(found: Diagnosis, fault: SensorFault) -> str:
    if found.verdict == "fault" and found.faults[0].same_part(fault):
        return "named"
    if found.verdict == "one of several" and any(each.same_part(fault) for each in found.faults):
        return "among several"
    return {"sound": "missed", "unexplained": "unexplained"}.get(found.verdict, "wrong")


def figures(name: str, sensors: int, seed: int, verbose: bool) -> list[str]:
    design = geometry.prototype(name)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        library = acoustic_fem.solve(design, np.arange(1.0, 501.0), "atlas")
        begun = process_time()
        diagnoser = Diagnoser(library)
        _ = diagnoser.libraries.screening
    built, spent = process_time() - begun, []
    cells: defaultdict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    for number in range(sensors):
        todo: list[SensorFault | None] = [None, None, None, *drawn_faults(design, seed + number)]
        for kind, fault in enumerate(todo):
            rig = FaultyRig(design, seed + number, fault, fidelity="atlas")
            session = diagnosis_session(rig, 1000 * (seed + number) + kind)
            for known in ("none", "four"):
                begun = process_time()
                found = diagnosed(diagnoser, session, known)
                spent.append(process_time() - begun)
                if fault is None:
                    row, cell = "sound", {"sound": "named"}.get(found.verdict, "wrong")
                else:
                    row, cell = row_of(design, fault), verdict_of(found, fault)
                cells[row, known][cell] += 1
                if verbose and cell != "named":
                    how = f"gain {found.gain:.0f}, misfit {found.misfit:.2f}"
                    print(f"{seed + number} {known} {fault}: {cell}, {found.text}; {how}", flush=True)
    rows = []
    for row in ("sound", *ROWS):
        each = [cells[row, known] for known in ("none", "four")]
        if not each[0].total():
            continue
        text = [f"{100 * one['named'] / one.total():.0f} / {100 * one['among several'] / one.total():.0f} / "
                f"{100 * one['missed'] / one.total():.0f}" for one in each]  # fmt: skip
        rows.append(f"| {name} | {row} | {each[0].total()} | {text[0]} | {text[1]} |")
    for known in ("none", "four"):
        serious: Counter[str] = Counter()
        for row in ROWS:
            if row not in (ROWS[1], ROWS[6]):
                serious += cells[row, known]
        low, high = wilson_interval(serious["named"] / serious.total(), serious.total())
        print(f"{name}, points known: {known}: inner tubes, leaks, levels and signs named in "
              f"{100 * serious['named'] / serious.total():.1f} % ({100 * low:.1f} to {100 * high:.1f}) of "
              f"{serious.total()}; tables {built:.1f} s, a diagnosis {np.median(spent):.1f} s (90 % "
              f"{np.quantile(spent, 0.9):.1f})", flush=True)  # fmt: skip
    print("\n".join(rows), flush=True)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", nargs="*", default=list(SENSORS))
    parser.add_argument("--sensors", type=int)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--verbose", action="store_true")
    given = parser.parse_args()
    rows = ["| design | fault | sensors x faults | points not known | four points known |", "|---|---|---|---|---|"]
    for name in given.designs:
        rows += figures(name, given.sensors or SENSORS[name], given.seed, given.verbose)
    if given.sensors is None and given.seed == SEED and given.designs == list(SENSORS):
        replace_section(PAGE, BEGIN, END, rows)


if __name__ == "__main__":
    main()
