"""Verdicts on random designs against independent signals, and remedies against what they give.

``python -m benchmarks.verdicts [--out FILE] [--designs 0 200] [--remedies 0 100] [--workers 2] [--prototypes]``.
Designs are drawn from fixed seeds and none is chosen: lines, areas and gloves of 4 to 40 points, with other bores of
the catalogue, tubes, cavities, membranes and numbers of microphones. Drawn values that are no valid design, or whose
parts overlap, are drawn again.

Each verdict is compared with sensors that are drawn with the tolerances of one that nobody calibrated, whose
microphones differ too, and touched by contacts of a finger
(:mod:`benchmarks.finger_touches`), with the force and the contact of the target. Membranes are linear.
Sensors are solved at the fidelity atlas where it covers the design, and decoded in full by the tolerance-aware decoder.
Neither the signals nor the sensors are those of the verdict. A remedy of an accuracy is compared with the same decoding
before and after it, one of the rule ``heard`` with the matched filter of a solved library, and one of a size with the
verdict on the changed design.

``FILE`` has a line of JSON for each design, so that a benchmark can be stopped, continued, and run in parts: ranges say
which numbers are computed if the file lacks them. The tables are those of all lines.
"""

from __future__ import annotations

import argparse
import json
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

import acoustic_fem
import localize
from acoustic_fem.atlas.fidelity_choice import outside_atlas
from acoustic_fem.library.noise_floor import gas_temperature, thermal_covariance
from acoustic_fem.network.microphone import noise_density
from benchmarks import finger_touches
from geometry import ArrayDesign, prototype
from geometry.design.design_file import prototype_names, read_design
from geometry.ground.refusal import Refusal
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps
from geometry.schema.field_errors import DesignError
from geometry.stock import catalogue
from localize.contacts.contact_shapes import FINGER, Tool
from localize.signals.array_response import ArrayResponse, response_of
from studies import Verdict
from studies.verdict.accuracies import accuracies
from studies.verdict.rules import ACCURACY_RULES, rule_named
from studies.verdict.tap_levels import TAP, covered_forces

SEED, REMEDY_SEED = 4040, 4041
#: As-built sensors of a design, fewer the more points it has, and touches of each kind on each point of a sensor.
SENSORS, TOUCHED_POINTS, EACH = (12, 30), 240, 2
FAMILIES = ("array-2x6", "large-area-64", "glove")
KINDS = {"taps": "taps", "presses": "presses", "multi-sines": "sines"}
#: Rules on sound; the others are of sizes, which decoding says nothing of.
SOUND = ("heard", "slow", *ACCURACY_RULES)
#: Grid of the library that the matched filter is computed from, finer than that of the verdict, Hz.
GRID = np.geomspace(1.0, 100.0, 161)


def random_design(seed: int, number: int) -> ArrayDesign:
    """A design of one seed: valid, but whether it works is not looked at."""
    random = np.random.default_rng((seed, number))
    while True:
        try:
            design = _drawn(random, number)
        except DesignError:
            continue
        if not overlaps(design, lay_out(design)):
            return design


def _drawn(random: np.random.Generator, number: int) -> ArrayDesign:
    base = prototype(FAMILIES[int(random.integers(len(FAMILIES)))])
    springs = catalogue().tubes
    spring = springs.enclosed[int(random.integers(len(springs.enclosed)))]
    tube = springs.around(spring, base.tube.sheath_wall)[0]
    cavity = float(np.exp(random.uniform(np.log(2.5), np.log(10.0))))
    least = tube.outer_diameter + 2 * (base.printing.glue_gap + 0.3)
    height = max(float(np.exp(random.uniform(np.log(1.5), np.log(6.0)))), least)
    sheets = [float(each) for each in catalogue().sizes("membrane.thickness")]
    silicones = catalogue().sizes("membrane.material")
    values: dict[str, Any] = {
        "name": f"random-{number}",
        "resonator.cavity_diameter": round(cavity, 1),
        "resonator.cavity_height": round(height + 0.05, 1),
        "microphone.chamber_height": round(max(1.3, least + 0.05), 1),
        "membrane.thickness": sheets[int(random.integers(len(sheets)))],
        "membrane.material": silicones[int(random.integers(len(silicones)))],
        "tube.length": round(float(np.exp(random.uniform(np.log(6.0), np.log(120.0)))), 1),
        "microphone_tube.length": round(float(np.exp(random.uniform(np.log(6.0), np.log(40.0)))), 1),
    }
    for table in ("tube", "microphone_tube"):
        values |= {f"{table}.{name}": value for name, value in tube.values.items()}
    if base.layout.kind == "hand":
        for index in range(len(base.lines)):
            values[f"lines.{index}.points"] = base.layout.columns * int(random.integers(1, 3))
    else:
        points = int(np.exp(random.uniform(np.log(4), np.log(41))))
        microphones = int(random.integers(2, 6))
        names = [chr(ord("A") + place) for place in range(microphones)]
        each, more = divmod(max(points, microphones - 1), microphones - 1)
        values |= {
            "microphones": names,
            "lines": [
                {"between": (names[place], names[place + 1]), "points": each + (place < more)}
                for place in range(microphones - 1)
            ],
            "layout.kind": "serpentine" if microphones == 2 else "area",
            "layout.columns": int(random.integers(2, 9)),
        }
    return base.with_values(values)


def judged(design: ArrayDesign) -> dict[str, float]:
    """Top-1 accuracies of as-built sensors by kind of touch, by full decoding of a finger's contacts."""
    grid = "1:500:500"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        fidelity = "lumped" if outside_atlas(design, grid) else "atlas"
        library = acoustic_fem.solve(design, grid, fidelity=fidelity)
        response = response_of(library)
        decoder = localize.TolerantDecoder(library)
        target = design.target
        radii = (0.8 * target.contact_radius, target.contact_radius)
        tool = replace(FINGER, contact_radius_mm=radii, force=(target.force, target.force))
        right: dict[str, list[float]] = {kind: [] for kind in KINDS}
        count = min(max(TOUCHED_POINTS // design.point_count, SENSORS[0]), SENSORS[1])
        for number, sensor in enumerate(finger_touches.as_built(library, response, count)):
            frames = _touched(sensor, finger_touches.SEED + number, tool)
            for kind, name in KINDS.items():
                signals, point = frames[name]
                right[kind].append(float((decoder.locate(signals).argmax(1) == point).mean()))
    return {kind: float(np.mean(values)) for kind, values in right.items()}


def _touched(sensor: ArrayResponse, seed: int, tool: Tool) -> finger_touches.Frames:
    finger_touches.EACH, kinds = EACH, ("taps", "presses")
    return finger_touches.touched(sensor, seed, tool, linear=True, edges=True, kinds=kinds)


def heard(design: ArrayDesign) -> float:
    """Signal-to-noise ratio of the rule ``heard``, dB, from a solved library on a finer grid of its own."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        library = acoustic_fem.solve(design, GRID, fidelity="lumped")
        response = library.touch_response("force").transpose("point", "microphone", "frequency").values
    mutual = library.microphone_impedance
    assert mutual is not None
    impedance = mutual.transpose("frequency", "microphone", "microphone_2").values
    thermal = np.einsum("fmm->mf", thermal_covariance(impedance, gas_temperature(library.medium))).real
    # The tap in time, sin^2 over its length, and its spectrum by the sum of its samples.
    time = (np.arange(2000) + 0.5) / 2000 * TAP
    tap = np.sin(np.pi * time / TAP) ** 2
    spectrum = np.abs((tap * np.exp(-2j * np.pi * GRID[:, None] * time)).sum(1)) * TAP / len(time)
    signal = np.abs(response * covered_forces(design)[:, None, None] * spectrum) ** 2
    power = signal / (thermal + noise_density(design.microphone, GRID) ** 2)
    snr = 10 * np.log10(4 * np.trapezoid(power, GRID, axis=-1))
    return float(np.sort(snr, axis=1)[:, -2].min())


def design_row(number: int) -> dict[str, Any]:
    """Verdict on a random design, and what decoding in full says of it."""
    design = random_design(SEED, number)
    start = process_time()
    verdict = Verdict(design)
    outcomes = {
        name: rule_named(name).outcome(found.value)
        for name, found in verdict.values.items()
        if found.value == found.value
    }
    seconds = process_time() - start
    rates = {name: verdict.values[name].value for name in KINDS}
    found = accuracies([design])[0]
    low = {} if isinstance(found, str) else {name: each.low for name, each in found.as_built.items()}
    return {
        "what": "design", "number": number, "points": design.point_count, "microphones": len(design.microphones),
        "outcome": verdict.outcome, "outcomes": outcomes, "stated": rates, "low": low, "decoded": judged(design),
        "seconds": seconds,
    }  # fmt: skip


def failing_design(number: int) -> ArrayDesign:
    """The random design of a seed, or the next one, that does not work."""
    for place in range(1000):
        design = random_design(REMEDY_SEED, 1000 * number + place)
        if Verdict(design).outcome != "works":
            return design
    raise AssertionError("no failing design")


def remedy_row(number: int) -> dict[str, Any]:
    """Promised gains and gains found of the remedies of a failing design."""
    design = failing_design(number)
    found = []
    start = process_time()
    reasons = Verdict(design).reasons
    seconds = process_time() - start
    before = lru_cache(maxsize=1)(lambda: judged(design))
    for reason in reasons:
        if reason.remedy is None:
            continue
        rule, changed = rule_named(reason.rule), design.with_values(reason.remedy.changes)
        promised = rule.gain(*reason.remedy.gain)
        found.append(
            {
                "rule": rule.name,
                "words": reason.remedy.words,
                "promised": promised,
                "gain": _gain(rule.name, design, changed, before),
            }
        )
    return {"what": "remedy", "number": number, "reasons": len(reasons), "remedies": found, "seconds": seconds}


def _gain(rule: str, design: ArrayDesign, changed: ArrayDesign, before: Callable[[], dict[str, float]]) -> float:
    if rule == "heard":
        return heard(changed) - heard(design)
    if rule in KINDS:
        return judged(changed)[rule] - before()[rule]
    values = [Verdict(each).values[rule].value for each in (design, changed)]
    return rule_named(rule).gain(*values)


# -- tables -----------------------------------------------------------------------------------------
def rows_of(path: Path | None) -> list[dict[str, Any]]:
    """Lines of the file, each once."""
    if path is None or not path.exists():
        return []
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def computed(
    what: str, make: Callable[[int], dict[str, Any]], span: tuple[int, int], known: list[dict[str, Any]], asked: Any
) -> Iterator[dict[str, Any]]:
    """Rows of a range of numbers that are not known yet, each written as soon as it is there."""
    there = {row["number"] for row in known if row["what"] == what}
    failed = list[BaseException]()
    with ProcessPoolExecutor(asked.workers) as pool:
        for row in as_completed([pool.submit(make, number) for number in range(*span) if number not in there]):
            if error := row.exception():  # once the others are written
                failed.append(error)
                continue
            if asked.out is not None:
                with asked.out.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(row.result()) + "\n")
            yield row.result()
    if failed:
        raise failed[0]


def show_designs(rows: list[dict[str, Any]]) -> None:
    """Table of verdicts against decoding in full."""
    table = Table(title=f"{len(rows)} random designs: verdict against as-built sensors decoded in full")
    for column in ("verdict", "designs", "what is counted", "share"):
        table.add_column(column)
    works = [row for row in rows if all(row["outcomes"].get(name) == "works" for name in SOUND)]
    whole = [row for row in works if row["outcome"] == "works"]
    bad = [row for row in rows if row["outcome"] == "does not work"]
    deaf = [row for row in bad if any(row["outcomes"].get(name) == "does not work" for name in SOUND)]
    for words, name, margin in (
        ("below the stated accuracy", "low", 0.0),
        ("below the middle of the interval by more than 1 point", "stated", 0.01),
        ("below the middle of the interval by more than 3 points", "stated", 0.03),
    ):
        below = [row for row in works if any(row["decoded"][kind] < row[name][kind] - margin for kind in KINDS)]
        table.add_row("works acoustically", str(len(works)), words, _share(len(below), len(works)))
    limit = [row for row in works if any(row["decoded"][kind] < rule_named(kind).works for kind in KINDS)]
    table.add_row(
        "works acoustically", str(len(works)), "below 95 %, the limit of works", _share(len(limit), len(works))
    )
    limit = [row for row in works if any(row["decoded"][kind] < rule_named(kind).marginal for kind in KINDS)]
    table.add_row(
        "works acoustically", str(len(works)), "below 80 %, the limit of marginal", _share(len(limit), len(works))
    )
    table.add_row("works by all rules", str(len(whole)), "", "")
    for name, group in (("does not work", bad), ("does not work acoustically", deaf)):
        above = [row for row in group if min(row["decoded"].values()) > 0.99]
        table.add_row(name, str(len(group)), "above 99 % of all touches", _share(len(above), len(group)))
    Console().print(table)


def show_remedies(rows: list[dict[str, Any]]) -> None:
    """Table of promised gains against gains found."""
    each = [remedy for row in rows for remedy in row["remedies"]]
    table = Table(title=f"remedies of {len(rows)} failing designs, of {sum(row['reasons'] for row in rows)} reasons")
    for column in ("rule", "remedies", "at least half of the promised gain", "median of found by promised"):
        table.add_column(column)
    for name in (*dict.fromkeys(remedy["rule"] for remedy in each), "all"):
        own = [remedy for remedy in each if name in (remedy["rule"], "all")]
        kept = [remedy for remedy in own if remedy["gain"] >= remedy["promised"] / 2]
        middle = np.median([remedy["gain"] / remedy["promised"] for remedy in own]) if own else np.nan
        table.add_row(name, str(len(own)), _share(len(kept), len(own)), f"{middle:.2f}")
    Console().print(table)


def _share(part: int, whole: int) -> str:
    return f"{part} of {whole} ({100 * part / whole:.1f} %)" if whole else "none"


def show_prototypes() -> None:
    """Table of the verdicts on the prototypes and on the examples of the docs."""
    table = Table(title="verdicts on the designs that come with the program")
    for column in ("design", "verdict", "taps", "broken rules"):
        table.add_column(column)
    examples = sorted((Path(__file__).parents[1] / "docs" / "examples").glob("*.toml"))
    designs = [prototype(name) for name in prototype_names()]
    for path in examples:
        try:
            designs.append(read_design(path.read_text(encoding="utf-8"), path.name))
        except Refusal:  # a study
            continue
    for design in designs:
        verdict = Verdict(design)
        broken = ", ".join(rule.name for rule in verdict.broken)
        table.add_row(design.name, verdict.outcome, f"{100 * verdict.figures.taps:.1f} %", broken)
    Console().print(table)


def main() -> None:
    """Compute what is asked for, and print the tables of all that is known."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, help="file of lines of JSON")
    parser.add_argument("--designs", type=int, nargs=2, default=(0, 0), metavar=("FIRST", "LAST"))
    parser.add_argument("--remedies", type=int, nargs=2, default=(0, 0), metavar=("FIRST", "LAST"))
    parser.add_argument("--workers", type=int, default=1, help="processes that compute side by side")
    parser.add_argument("--prototypes", action="store_true")
    asked = parser.parse_args()
    rows = rows_of(asked.out)
    rows += computed("design", design_row, tuple(asked.designs), rows, asked)
    rows += computed("remedy", remedy_row, tuple(asked.remedies), rows, asked)
    if designs := [row for row in rows if row["what"] == "design"]:
        show_designs(designs)
    if remedies := [row for row in rows if row["what"] == "remedy"]:
        show_remedies(remedies)
    if asked.prototypes:
        show_prototypes()


if __name__ == "__main__":
    main()
