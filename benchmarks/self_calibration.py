"""Self-calibration of virtual rigs from unlabelled touches: its effect on the accuracy, and the cases that it rejects.

``python benchmarks/self_calibration.py sines`` and ``fingers`` write the two tables of docs/evidence/calibration.md,
in a quarter and half an hour of one core; with more arguments, such as ``sines 3 "2x36, soft"`` or
``fingers 2 line-2``, they print one row of so many rigs.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, replace

import numpy as np
from calibration import DESIGNS, GRID, NOISE, PAGE, TOUCHES
from natural_touches import NATURAL, SINES, touched

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import Library
from geometry.ground.whole_files import replace_section
from localize.live.stream_options import HIGH_PASS
from localize.recalibration.self_calibration import SelfCalibration, self_calibrate
from localize.signals.array_response import ArrayResponse, response_of
from studies.test_rig.virtual_rig import HiddenScatter, Rig

BEGIN, END = "<!-- self-calibration: made by benchmarks/self_calibration.py -->", "<!-- end of self-calibration -->"
COUNT, SENSORS = 200, 6
#: Rigs from here on, of which no constant was chosen.
FIRST = 9450


@dataclass(frozen=True)
class Kind:
    """Sensors and what is known of them."""

    design: str
    modulus: float = 1.0
    drift: bool = False
    """Calibrated before exactly; then gains drifted by 0.5 dB and the modulus by 5 %."""


KINDS = {
    "2x6, soft": Kind("2x6", 0.85),
    "2x36, soft": Kind("2x36", 0.85),
    "2x36 wide, soft": Kind("2x36 wide", 0.85),
    "2x36 wide, drifted": Kind("2x36 wide", drift=True),
}


#: Of the table of fingers: seeds from here on, of which no constant was chosen.
FINGERS_FIRST = 9400
FINGERS_GRID = np.geomspace(1.0, 150.0, 48)
FINGERS_BEGIN, FINGERS_END = "<!-- fingers: made by benchmarks/self_calibration.py -->", "<!-- end of fingers -->"
SOFT, STEEP = HiddenScatter(batch=0.0, modulus=0.85), HiddenScatter(slope=0.05)


@dataclass(frozen=True)
class Fingers:
    """Row of the table of fingers."""

    design: str
    touches: str
    count: int
    scatters: tuple[HiddenScatter, ...]
    """Of each rig."""


FINGERS = {
    "2x6: 10 soft, 5 steep, 5 neither": Fingers(
        "array-2x6", NATURAL, 300, (SOFT,) * 10 + (STEEP,) * 5 + (HiddenScatter(),) * 5
    ),
    "2x6, steep": Fingers("array-2x6", SINES, 300, (STEEP,) * 20),
    "line-2": Fingers("line-2", NATURAL, 1000, (SOFT, STEEP)),
}


def unlabelled(truth: ArrayResponse, count: int, seed: int) -> np.ndarray:
    """Frames of points drawn at random, (count, n_microphone, 250)."""
    points = truth.point_count
    made = points * -(-2 * count // points)
    signals = localize.TouchGenerator(truth, seed, "training", NOISE).samples(0, made).signals
    drawn = np.random.default_rng(seed).permutation(made)[:count]
    return signals[drawn, :, :250].double().numpy()


def sensor(kind: Kind, nominal: Library, seed: int) -> tuple[Library, np.ndarray]:
    """The library before, and the true transfer functions."""
    design = DESIGNS[kind.design]
    truth = Rig(design, seed, HiddenScatter(batch=0.0, modulus=kind.modulus), "navier-stokes").transfer_function(GRID)
    if not kind.drift:
        return nominal, truth
    known = nominal.transfer_function.copy(data=truth)
    random = np.random.default_rng(seed)
    signs = random.permutation([1.0, -1.0])
    softer = Rig(
        design, seed, HiddenScatter(batch=0.0, modulus=kind.modulus * 0.95), "navier-stokes"
    ).transfer_function(GRID)
    return replace(nominal, transfer_function=known), softer * 10 ** (0.25 * signs / 20)[:, None]


def accuracy(known: ArrayResponse, touched: ArrayResponse) -> float:
    return localize.evaluate(localize.BayesDecoder(known, NOISE), touched, TOUCHES, NOISE).top1


def row(name: str, rigs: int) -> str:
    kind = KINDS[name]
    nominal = acoustic_fem.solve(DESIGNS[kind.design], GRID, "lumped")
    plain = response_of(nominal)
    shares, refused, worse, seconds = [], 0, 0, 0.0
    for seed in range(FIRST, FIRST + rigs):
        before, h = sensor(kind, nominal, seed)
        truth = replace(plain, transfer_function=h)
        start = time.process_time()
        found = self_calibrate(before, unlabelled(truth, COUNT, seed), NOISE)
        seconds = max(seconds, time.process_time() - start)
        refused += not found.accepted
        shares.append([accuracy(each, truth) for each in (response_of(before), response_of(found.library()), truth)])
        worse += found.accepted and shares[-1][1] < shares[-1][0]
        print(name, seed, np.round(100 * np.array(shares[-1]), 1), figures(found), found.objection, file=sys.stderr)
    table = 100 * np.array(shares)
    cells = (f"{mean:.1f}/{worst:.1f}" for mean, worst in zip(table.mean(0), table.min(0), strict=True))
    print(f"{name}: refused {refused} of {rigs}, accepted and worse than before {worse}, slowest {seconds:.0f} s")
    return f"| {name} | {' | '.join(cells)} |"


def table(rigs: int, names: tuple[str, ...]) -> str:
    head = ["sensors", "before", "self-calibrated", "known exactly"]
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join([*lines, *(row(name, rigs) for name in names)])


def right(known: ArrayResponse, truth: ArrayResponse, seed: int) -> tuple[float, float]:
    """Top-1 accuracy of touches of fingers and of multi-sines after the high-pass of a stream, %."""
    decoder = localize.BayesDecoder(known, NOISE)
    shares = []
    for kind in (NATURAL, SINES):
        frames, points = touched(truth, kind, TOUCHES * truth.point_count, seed, "evaluation")
        shares.append(100 * float((decoder.locate(frames).argmax(1) == points).mean()))
    return shares[0], shares[1]


def finger_row(name: str, rigs: int | None = None) -> str:
    row = FINGERS[name]
    design = geometry.prototype(row.design)
    nominal = acoustic_fem.solve(design, FINGERS_GRID, "lumped")
    shares, refused, worse, seconds = [], 0, 0, 0.0
    for seed, scatter in enumerate(row.scatters[:rigs], FINGERS_FIRST):
        h = Rig(design, seed, scatter, "navier-stokes").transfer_function(FINGERS_GRID)
        truth = replace(response_of(nominal), transfer_function=h)
        start = time.process_time()
        found = self_calibrate(nominal, touched(truth, row.touches, row.count, seed)[0], NOISE, high_pass=HIGH_PASS)
        seconds = max(seconds, time.process_time() - start)
        known = (response_of(nominal), response_of(found.library()), truth)
        shares.append([right(each, truth, seed) for each in known])
        refused += not found.accepted
        worse += found.accepted and any(after < before for before, after in zip(*shares[-1][:2], strict=True))
        print(
            name, seed, np.round(shares[-1], 1).tolist(), figures(found), found.objection, file=sys.stderr, flush=True
        )
    table = np.array(shares)
    means, least = (["/".join(f"{x:.1f}" for x in each) for each in pick(0)] for pick in (table.mean, table.min))
    cells = (f"{mean} ({worst})" for mean, worst in zip(means, least, strict=True))
    print(f"{name}: refused {refused} of {len(shares)}, accepted and worse {worse}, slowest {seconds:.0f} s")
    touches = "fingers" if row.touches == NATURAL else row.touches
    return "| " + " | ".join((name, f"{row.count} {touches}", *cells)) + " |"


def figures(found: SelfCalibration) -> str:
    """Figures for and against a sensor, to look at."""
    return (
        f"gain {found.gain:.2f} +- {found.gain_error:.2f} rival {found.rival:.0f} {found.rival_held_out:.1f} explained "
        f"{found.explained:.2f} agreement {found.agreement:.2f} size {found.size:.0f}"
    )


def finger_table(rigs: int | None, names: tuple[str, ...]) -> str:
    head = ["sensors", "touches", "before", "self-calibrated", "known exactly"]
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join([*lines, *(finger_row(name, rigs) for name in names)])


def main() -> None:
    which, *rest = sys.argv[1:] or ["both"]
    rigs, names = int(rest[0]) if rest else None, tuple(rest[1:2])
    if which in ("sines", "both"):
        text = table(rigs or SENSORS, names or tuple(KINDS))
        print(text)
        if not rest:
            replace_section(PAGE, BEGIN, END, text.splitlines())
    if which in ("fingers", "both"):
        text = finger_table(rigs, names or tuple(FINGERS))
        print(text)
        if not rest:
            replace_section(PAGE, FINGERS_BEGIN, FINGERS_END, text.splitlines())


if __name__ == "__main__":
    main()
