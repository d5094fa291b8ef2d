"""Time and memory of the decoder as C on a microcontroller. ``python benchmarks/embed.py`` writes the tables of
docs/evidence/embed.md in some minutes: the chips that fit each prototype, then differences from Python and counts of
instructions on the emulated board.

Touches are simulated with the library that decodes them, on seeds on which no constant was chosen. Libraries are
lumped. "Calibrated" ones are the exact libraries of a random as-built sensor with the workshop's tolerances.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

import geometry
from benchmarks.boards import run_on_board
from benchmarks.embedded_touches import LIMIT, STATES, array_of, decided_of, in_the_wake
from geometry.ground.whole_files import replace_section
from localize.embedded import Cost, cost_of, embed
from localize.embedded.decoder_tables import PRECISIONS, embedded_tables

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "embed.md"
SEED, TAKES = 2077, 100
#: Classes of chips: name, flash in KiB, clock in MHz.
CHIPS = (
    ("256 KiB, 80 MHz", 256, 80),
    ("512 KiB, 64 MHz", 512, 64),
    ("512 KiB, 170 MHz", 512, 170),
    ("1 MiB, 168 MHz", 1024, 168),
    ("2 MiB, 480 MHz", 2048, 480),
    ("16 MiB outside, 150 MHz", 16384, 150),
)
#: Flash for everything else, KiB, and cycles for an instruction: divisions and waits for flash.
REST, CYCLES = 32, 1.5


def sizes() -> None:
    """The table of what fits where."""
    rows = ["| array | flash (KiB) | RAM (B) | stack (B) | instructions (k) | smallest chip |", "|" + "---|" * 6]
    for name in geometry.prototype_names():
        found = []
        for is_calibrated in (False, True):
            tables = [embedded_tables(array_of(name, is_calibrated), precision) for precision in PRECISIONS]
            costs = [cost_of(each) for each in tables]
            cells = (
                f"{name} ({tables[0].point_count}, {len(tables[0].microphones)})",
                *(", ".join(f"{cost.flash / 1024:.0f}" for cost in costs), f"{max(cost.ram for cost in costs)}"),
                ", ".join(str(cost.stack) for cost in costs),
                ", ".join(f"{cost.instructions / 1e3:.0f}" for cost in costs),
                "; ".join(dict.fromkeys(smallest(cost) for cost in costs)),
            )
            found.append(f"| {' | '.join(cells)} |")
        if len(set(found)) > 1:
            raise RuntimeError(f"{name}: a calibrated sensor takes more, which the page denies: {found}")
        rows.append(found[0])
        print(rows[-1], flush=True)
    replace_section(PAGE, "<!-- sizes: made by benchmarks/embed.py -->", "<!-- end sizes -->", rows)


def frames() -> None:
    """The table of differences and counts."""
    rows = [
        "| array, library, tables | frames | largest difference | 99 % below "
        "| instructions (k): median | 99 % below | most | bound |",
        "|" + "---|" * 8,
    ]
    for name in ("array-2x6", "line-2"):
        for is_calibrated in (False, True):
            for precision in PRECISIONS:
                rows.append(measured(name, is_calibrated, precision))
                print(rows[-1], flush=True)
    replace_section(PAGE, "<!-- frames: made by benchmarks/embed.py -->", "<!-- end frames -->", rows)


def smallest(cost: Cost) -> str:
    """The smallest class of chips that has room and time for a decoder."""
    for name, flash, clock in CHIPS:
        fits = cost.flash / 1024 + REST <= flash
        if fits and cost.instructions * CYCLES <= 0.016 * clock * 1e6:
            return name
    return "none"


def measured(name: str, is_calibrated: bool, precision: str) -> str:
    """A row of the second table: on a Cortex-M4F."""
    samples, expected = decided_of(name, is_calibrated, TAKES, seed=SEED)
    decoder = embed(array_of(name, is_calibrated), precision)
    with tempfile.TemporaryDirectory() as folder:
        for file, text in decoder.files.items():
            Path(folder, file).write_text(text, encoding="utf-8")
        found = run_on_board(Path(folder), samples.T, limit=LIMIT)
    state = np.array(expected.state)
    if tuple(STATES[number] for number in found.state) != expected.state:
        raise RuntimeError(f"{name}: states differ")
    touched, wake = state == "touch", in_the_wake(samples, expected)
    difference = np.abs(found.posterior - expected.posterior).max(1)
    same = (found.point == expected.point)[touched].mean()
    # The first decision of a take filters its whole frame, and is told apart.
    begun = (np.diff(expected.sample, prepend=0) == 16) & touched
    begun[1:] &= state[:-1] != "unreadable"
    spent = found.instructions[begun] / 1e3
    clear, after = difference[touched & ~wake], difference[touched & wake]
    kind = "calibrated" if is_calibrated else "nominal"
    if same < 1 or after.max(initial=0.0) > 1e-12:
        raise RuntimeError(f"{name}, {kind}: points or frames in the wake of clipping differ, which the page denies")
    return (
        f"| {name}, {kind}, {precision} | {len(clear)} + {len(after)} | {clear.max():.1e} | "
        f"{np.quantile(clear, 0.99):.1e} | {np.median(spent):.0f} | {np.quantile(spent, 0.99):.0f} | "
        f"{spent.max():.0f} | {decoder.cost.instructions / 1e3:.0f} |"
    )


if __name__ == "__main__":
    sizes()
    frames()
