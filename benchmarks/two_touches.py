"""Resolution of two touches at once, by distance along the line and by level.

``python benchmarks/two_touches.py`` writes the table of docs/evidence/decoder.md, with some minutes of one core and
2 GB of memory. Signals are the exact steady states of two multi-sines of
different seeds, the second scaled to its level below the first, plus microphone noise.
"""

from __future__ import annotations

import warnings
from pathlib import Path
from time import process_time

import numpy as np

import acoustic_fem
import geometry
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import replace_section
from localize import ArrayResponse, TwoTouchDecoder
from localize.signals.array_response import response_of
from localize.signals.stimulus import multi_sines, time_signal
from localize.signals.touch_generator import TouchGenerator

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "decoder.md"
BEGIN, END = "<!-- two touches: made by benchmarks/two_touches.py -->", "<!-- end two touches -->"
FREQUENCY = np.arange(1.0, 501.0)
NOISE, FRAME, PER_CELL = 1e-3, 250, 60
DISTANCES = ((1, 1), (2, 2), (3, 4), (5, 11))
LEVELS = (0.0, 10.0, 20.0)
LINES = {2: (("A", "B"),), 3: (("A", "B"), ("A", "C"), ("B", "C")), 4: (("A", "B"), ("B", "C"), ("C", "D"))}


def design(microphones: int) -> ArrayDesign:
    """The prototype line-2 with 12 points on each of one or three lines."""
    base = geometry.prototype("line-2")
    lines = [{"between": between, "points": 12} for between in LINES[microphones]]
    return type(base).model_validate(
        {**base.model_dump(exclude_unset=True), "name": f"line-{microphones}-of-12",
         "microphones": list("ABCD"[:microphones]), "lines": lines, "layout": {"kind": "serpentine", "columns": 12}}
    )  # fmt: skip


class Touches:
    """Sources and what they give at the microphones, for points in turn."""

    def __init__(self, response: ArrayResponse, seed: int, count: int) -> None:
        stimuli = multi_sines(seed, "evaluation", 0, count, (float(FREQUENCY[0]), float(FREQUENCY[-1])))
        source = time_signal(stimuli.spectrum).double().numpy()[:, -FRAME:]
        self.rms = np.sqrt((source**2).mean(1))
        made = TouchGenerator(response, seed, "evaluation", 0.0).samples(0, count)
        self.signals = made.signals[..., -FRAME:].double().numpy()


def pairs_at(response: ArrayResponse, low: int, high: int) -> list[tuple[int, int]]:
    """Pairs on one line, ``low`` to ``high`` places apart; of different lines where ``low`` is 0."""
    points = range(response.point_count)
    line, place = response.line, response.place
    if low == 0:
        return [(i, j) for i in points for j in points if line[i] != line[j]]
    return [(i, j) for i in points for j in points if line[i] == line[j] and low <= abs(place[i] - place[j]) <= high]


def near(response: ArrayResponse, found: np.ndarray, true: np.ndarray) -> np.ndarray:
    """For each found pair, true if it is the true one or has one or both points beside it on the line."""

    def beside(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return (response.line[a] == response.line[b]) & (abs(response.place[a] - response.place[b]) <= 1)

    straight = beside(found[:, 0], true[:, 0]) & beside(found[:, 1], true[:, 1])
    crossed = beside(found[:, 0], true[:, 1]) & beside(found[:, 1], true[:, 0])
    return straight | crossed


def rows(microphones: int, rng: np.random.Generator) -> list[str]:
    with warnings.catch_warnings():
        # Entrances beyond the range of the closed form: nothing hangs on it below 100 Hz.
        warnings.filterwarnings("ignore", "entrance loss of a tube", UserWarning)
        response = response_of(acoustic_fem.solve(design(microphones), FREQUENCY, "lumped"))
    points = response.point_count
    start = process_time()
    decoder = TwoTouchDecoder(response, NOISE)
    built = process_time() - start
    turns = 8
    first, second = (Touches(response, seed, turns * points) for seed in (0, 1))

    def pick(point: np.ndarray) -> np.ndarray:
        return point + points * rng.integers(turns, size=len(point))

    def noisy(signals: np.ndarray) -> np.ndarray:
        return signals + NOISE * rng.standard_normal(signals.shape)

    single = decoder.locate(noisy(first.signals))
    truth = np.arange(turns * points) % points
    start = process_time()
    decoder.locate(noisy(first.signals[:64]))
    frame = (process_time() - start) / 64
    right = 100 * (single.point == truth + 1).mean()
    print(
        f"{microphones} microphones, {points} points: tables {built:.0f} s, frame {1e3 * frame:.1f} ms, single "
        f"touches: top-1 {right:.1f} %, called two {100 * single.is_two.mean():.2f} %, "
        f"gain 99 % {np.quantile(single.gain, 0.99):.2f}, 99.9 % {np.quantile(single.gain, 0.999):.2f}"
    )
    cells: dict[float, list[str]] = {level: [] for level in LEVELS}
    for low, high in (*DISTANCES, (0, 0)):
        choice = pairs_at(response, low, high)
        for level in LEVELS:
            if not choice:
                cells[level].append("-")
                continue
            true = np.array(choice)[rng.integers(len(choice), size=PER_CELL)]
            a, b = pick(true[:, 0]), pick(true[:, 1])
            scale = 10 ** (-level / 20) * first.rms[a] / second.rms[b]
            found = decoder.locate(noisy(first.signals[a] + scale[:, None, None] * second.signals[b]))
            pair = found.pair - 1
            right = (pair == np.sort(true, 1)).all(1)
            cells[level].append(
                f"{100 * right.mean():.0f}/{100 * near(response, pair, true).mean():.0f}/"
                f"{100 * found.is_two.mean():.0f}"
            )
    result = [f"| {microphones} x {points} | {level:.0f} | {' | '.join(each)} |" for level, each in cells.items()]
    print("\n".join(result), flush=True)
    return result


def main() -> None:
    rng = np.random.default_rng(0)
    places = (*(f"{low}" if low == high else f"{low} to {high}" for low, high in DISTANCES), "other line")
    lines = [f"| microphones x points | dB apart | {' | '.join(places)} |", "|---" * (2 + len(places)) + "|"]
    for microphones in LINES:
        lines += rows(microphones, rng)
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
