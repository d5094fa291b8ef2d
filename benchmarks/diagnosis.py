"""Faults named by a diagnosis, on as-built sensors of unseen seeds, and sound sensors that are accused.

``python benchmarks/diagnosis.py --workers 16`` writes the tables of docs/diagnosis.md; names of designs restrict it to
these, and ``--sensors 5 --faults 20 --seed 900`` to fewer, other sensors and to fewer faults of each. Sensors are
virtual rigs, whose lengths, losses, relaxations, air and pressure the diagnosis does not know. Every fault of every
sensor has an amount of its own, drawn between those that are tried. A session is 24 taps and presses. It is diagnosed
without known points; with one known touch of the point that the diagnosis asked for, where it did not name one fault;
and with four known points, those of touches 1, 8, 14 and 21.
"""

from __future__ import annotations

import argparse
import warnings
from collections import Counter, defaultdict
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import cache
from pathlib import Path
from time import process_time

import numpy as np

import acoustic_fem
import geometry
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.whole_files import replace_section
from localize.diagnosis import Diagnoser, Diagnosis, SensorFault, single_faults
from localize.evaluation import wilson_interval
from studies.test_rig.faulty_rig import DiagnosisSession, FaultyRig, diagnosis_session

PAGE = Path(__file__).parents[1] / "docs" / "diagnosis.md"
BEGIN, END = "<!-- diagnosis: made by benchmarks/diagnosis.py -->", "<!-- end diagnosis -->"
#: Sensors of each design, and faults of each sensor.
SENSORS, FAULTS = {"array-2x6": 20, "glove": 5, "line-2": 5}, 40
SEED, SOUND = 47000, 4
KNOWN = (0, 7, 13, 20)
WAYS = ("none", "asked", "four")
AMOUNTS = {"blocked tube": (0.15, 0.45), "leak": (0.2, 0.5), "quiet microphone": (-20.0, -8.0)}
ROWS = ("inner tube blocked", "tube at a microphone blocked", "leak", "quiet microphone", "dead microphone",
        "reversed microphone", "exchanged microphones")  # fmt: skip


def drawn_faults(design: geometry.ArrayDesign, seed: int, count: int) -> list[SensorFault]:
    """Faults of a sensor: those of its microphones, then tubes and leaks in turn, each with an amount of its own."""
    random = np.random.default_rng([seed, 46])
    every = [part[0] for part in single_faults(design)]
    tubes, leaks = ([each for each in every if each.kind == kind] for kind in ("blocked tube", "leak"))
    chosen = [each for each in every if each not in tubes and each not in leaks]
    chosen += [replace(each, amount=-60.0) for each in every if each.kind == "quiet microphone"]
    orders = [list(random.permutation(len(some))) for some in (tubes, leaks)]
    for number in range(max(0, count - len(chosen))):
        some, order = (tubes, leaks)[number % 2], orders[number % 2]
        chosen.append(some[order[number // 2 % len(order)]])
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


def diagnosed(diagnoser: Diagnoser, session: DiagnosisSession, known: dict[float, int] | None) -> Diagnosis:
    """Diagnosis; a touch that is too quiet to be found is not given."""
    points = dict(known or {})
    while True:
        try:
            return diagnoser.diagnose(session.signals, points)
        except geometry.Refusal as error:
            if not points or error.field != "points":
                raise
            points.popitem()


def touches_of(session: DiagnosisSession, numbers: Iterator[int] | tuple[int, ...]) -> dict[float, int]:
    return {float(session.time[k]): int(session.point[k]) for k in numbers}


def verdict_of(found: Diagnosis, fault: SensorFault) -> str:
    if found.verdict == "fault" and found.faults[0].same_part(fault):
        return "named"
    if found.verdict == "one of several" and any(each.same_part(fault) for each in found.faults):
        return "among several"
    return {"sound": "missed", "unexplained": "unexplained"}.get(found.verdict, "wrong")


@cache
def diagnoser_of(name: str) -> tuple[Diagnoser, float]:
    """Diagnoser with its tables, and the time that these took, s."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        library = acoustic_fem.solve(geometry.prototype(name), np.arange(1.0, 501.0), "atlas")
        begun = process_time()
        diagnoser = Diagnoser(library)
        _ = diagnoser.libraries.screening
    return diagnoser, process_time() - begun


def outcomes(task: tuple[str, int, int, SensorFault | None]) -> list[tuple[str, str, str, float, str]]:
    """Row, known points, outcome, time and what was found of a sensor with a fault."""
    name, seed, number, fault = task
    design, (diagnoser, _) = geometry.prototype(name), diagnoser_of(name)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        session = diagnosis_session(FaultyRig(design, seed, fault, fidelity="atlas"), 1000 * seed + number)
    rows: list[tuple[str, str, str, float, str]] = []
    first: Diagnosis | None = None
    for way in WAYS:
        known = touches_of(session, KNOWN) if way == "four" else None
        found, spent = first, 0.0
        if way == "asked" and first is not None and first.verdict != "fault" and first.next_point is not None:
            known = touches_of(session, tuple(np.flatnonzero(session.point == first.next_point)[:1].tolist()))
        if known or first is None:
            begun = process_time()
            found = diagnosed(diagnoser, session, known)
            spent = process_time() - begun
        assert found is not None
        first = first or found
        if fault is None:
            row, cell = "sound", {"sound": "named"}.get(found.verdict, "wrong")
        else:
            row, cell = row_of(design, fault), verdict_of(found, fault)
        about = f"{seed} {way} {fault}: {cell}, {found.text}; gain {found.gain:.0f}, misfit {found.misfit:.2f}"
        rows.append((row, way, cell, spent, about))
    return rows


def figures(name: str, sensors: int, faults: int, seed: int, workers: int, verbose: bool) -> list[str]:
    design, spent = geometry.prototype(name), []
    tasks = [
        (name, number, kind, fault)
        for number in range(seed, seed + sensors)
        for kind, fault in enumerate([*[None] * SOUND, *drawn_faults(design, number, faults)])
    ]
    cells: defaultdict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    with ProcessPoolExecutor(workers) as pool:
        for several in pool.map(outcomes, tasks):
            for row, way, cell, seconds, about in several:
                cells[row, way][cell] += 1
                spent += [seconds] if seconds else []
                if verbose and cell != "named":
                    print(about, flush=True)
    rows = []
    for row in ("sound", *ROWS):
        each = [cells[row, way] for way in WAYS]
        if each[0].total():
            text = " | ".join(
                f"{100 * one['named'] / one.total():.0f} / {100 * one['among several'] / one.total():.0f} / "
                f"{100 * one['missed'] / one.total():.0f}" for one in each
            )  # fmt: skip
            rows.append(f"| {name} | {row} | {each[0].total()} | {text} |")
    built = diagnoser_of(name)[1]
    for way in WAYS:
        serious: Counter[str] = Counter()
        for row in ROWS:
            if row not in (ROWS[1], ROWS[6]):
                serious += cells[row, way]
        low, high = wilson_interval(serious["named"] / serious.total(), serious.total())
        print(f"{name}, points known: {way}: inner tubes, leaks, levels and signs named in "
              f"{100 * serious['named'] / serious.total():.1f} % ({100 * low:.1f} to {100 * high:.1f}) of "
              f"{serious.total()}, among several in {100 * serious['among several'] / serious.total():.1f} %; tables "
              f"{built:.1f} s, a diagnosis {np.median(spent):.1f} s (90 % {np.quantile(spent, 0.9):.1f})",
              flush=True)  # fmt: skip
    print("\n".join(rows), flush=True)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", nargs="*", default=list(SENSORS))
    parser.add_argument("--sensors", type=int)
    parser.add_argument("--faults", type=int, default=FAULTS)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--verbose", action="store_true")
    given = parser.parse_args()
    rows = [
        "| design | fault | sensors x faults | no point known | the touch asked for known | four points known |",
        "|---|---|---|---|---|---|",
    ]
    for name in given.designs:
        sensors = given.sensors or SENSORS[name]
        rows += figures(name, sensors, given.faults, given.seed, given.workers, given.verbose)
    whole = given.sensors is None and given.faults == FAULTS and given.seed == SEED
    if whole and given.designs == list(SENSORS):
        replace_section(PAGE, BEGIN, END, rows)


if __name__ == "__main__":
    main()
