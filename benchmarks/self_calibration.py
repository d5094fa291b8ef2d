"""Self-calibration of virtual rigs from unlabelled touches: what it does to decoding, and what it refuses.

``python benchmarks/self_calibration.py`` writes the table of docs/calibration.md anew; with arguments, such as ``3 "2 x
36, modulus x 0.85" 200``, it prints that of so many rigs, of one kind, from so many touches.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, replace

import numpy as np
from calibration import DESIGNS, GRID, NOISE, PAGE, RIGS, TOUCHES

import acoustic_fem
import localize
from acoustic_fem.library.result import Library
from geometry.files.writing import replace_section
from localize.recalibration.self_calibration import self_calibrate
from localize.signals.array_response import ArrayResponse, response_of
from studies.made_sensor.rig import HiddenScatter, Rig

BEGIN, END = "<!-- self-calibration: made by benchmarks/self_calibration.py -->", "<!-- end of self-calibration -->"
COUNTS = (200, 1000)
#: Rigs from here on: the constants of self-calibration were chosen on some before.
FIRST = 10


@dataclass(frozen=True)
class Kind:
    """Sensors and what is known of them."""

    design: str
    modulus: float = 1.0
    drift: bool = False
    """Calibrated before exactly; then gains drifted by 0.5 dB and the modulus by 5 %."""


KINDS = {
    "2 x 6": Kind("2 x 6"),
    "2 x 6, modulus x 0.85": Kind("2 x 6", 0.85),
    "2 x 36": Kind("2 x 36"),
    "2 x 36, modulus x 0.85": Kind("2 x 36", 0.85),
    "2 x 36, drifted": Kind("2 x 36", drift=True),
    "2 x 36, bores of 0.8 mm": Kind("2 x 36, bores of 0.8 mm"),
    "2 x 36, bores of 0.8 mm, modulus x 0.85": Kind("2 x 36, bores of 0.8 mm", 0.85),
    "2 x 36, bores of 0.8 mm, drifted": Kind("2 x 36, bores of 0.8 mm", drift=True),
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
    truth = Rig(design, seed, HiddenScatter(modulus=kind.modulus), "navier-stokes").transfer_function(GRID)
    if not kind.drift:
        return nominal, truth
    known = nominal.transfer_function.copy(data=truth)
    random = np.random.default_rng(seed)
    signs = random.permutation([1.0, -1.0])
    softer = Rig(design, seed, HiddenScatter(modulus=kind.modulus * 0.95), "navier-stokes").transfer_function(GRID)
    return replace(nominal, transfer_function=known), softer * 10 ** (0.25 * signs / 20)[:, None]


def accuracy(known: ArrayResponse, touched: ArrayResponse) -> float:
    return localize.evaluate(localize.BayesDecoder(known, NOISE), touched, TOUCHES, NOISE).top1


def row(name: str, counts: tuple[int, ...], rigs: int) -> str:
    kind = KINDS[name]
    nominal = acoustic_fem.solve(DESIGNS[kind.design], GRID, "lumped")
    plain = response_of(nominal)
    shares, refused, worse, seconds = [], np.zeros(len(counts), int), 0, 0.0
    for seed in range(FIRST, FIRST + rigs):
        before, h = sensor(kind, nominal, seed)
        truth = replace(plain, transfer_function=h)
        values = [accuracy(response_of(before), truth), accuracy(truth, truth)]
        for place, count in enumerate(counts):
            start = time.process_time()
            found = self_calibrate(before, unlabelled(truth, count, seed), NOISE)
            seconds = max(seconds, time.process_time() - start)
            refused[place] += not found.accepted
            values.append(accuracy(response_of(found.library()), truth))
            worse += found.accepted and values[-1] < values[0]
            figures = (
                f"gain {found.gain:.2f} +- {found.gain_error:.2f} rival {found.rival:.0f} {found.rival_held_out:.1f}"
            )
            figures += f" explained {found.explained:.2f} agreement {found.agreement:.2f} size {found.size:.0f}"
            print(name, seed, count, np.round(100 * np.array(values), 1), figures, found.objection, file=sys.stderr)
        shares.append(values)
    table = 100 * np.array(shares)
    cells = (f"{mean:.1f} ({worst:.1f})" for mean, worst in zip(table.mean(0), table.min(0), strict=True))
    rest = (" and ".join(f"{n} of {rigs}" for n in refused), f"{worse}", f"{seconds:.0f}")
    return "| " + " | ".join((name, *cells, *rest)) + " |"


def table(rigs: int, names: tuple[str, ...], counts: tuple[int, ...]) -> str:
    head = ["sensors", "before", "known exactly", *(f"{count} touches" for count in counts)]
    head += ["refused", "accepted and worse than before", "slowest (s)"]
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join([*lines, *(row(name, counts, rigs) for name in names)])


def main() -> None:
    given = sys.argv[1:]
    counts = (int(given[2]),) if len(given) > 2 else COUNTS
    text = table(int(given[0]) if given else RIGS, (given[1],) if len(given) > 1 else tuple(KINDS), counts)
    print(text)
    if not given:
        replace_section(PAGE, BEGIN, END, text.splitlines())


if __name__ == "__main__":
    main()
