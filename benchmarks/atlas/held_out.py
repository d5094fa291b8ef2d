"""Random designs on which the errors of the atlas are measured: solved in 3-D, and not used to make the atlas.

``python -m benchmarks.atlas.held_out`` solves their cells. The cache keeps them, so a stopped run continues where it
was.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

import geometry
from acoustic_fem.atlas.cell_in_atlas import check_cell
from acoustic_fem.atlas.cell_table import cell_atlas
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.quantities.local_air import design_air
from benchmarks.atlas.fitting import BOUNDS
from geometry import ArrayDesign
from geometry.air.cells import cell_catalogue
from geometry.ground.refusal import Refusal
from geometry.layout.arrangement import lay_out

FIRST_SEED = 2600
COUNT = 40
#: Hz.
FREQUENCY = np.geomspace(1.0, 200.0, 24)
_BASES = tuple(geometry.prototype(name) for name in ("array-2x6", "line-3"))


def random_design(seed: int) -> ArrayDesign:
    """A design of 2 to 12 points with sizes drawn from all of the bounds, membranes, air and wiring at random.

    One of four designs has two points and bores of two widths, one has ports out of the middle, one has points so close
    that tubes leave corners at other angles, also where they overlap. One of three has three microphones, whose
    chambers have two tubes each.
    """
    random = np.random.default_rng(seed)
    while True:
        try:
            design = _BASES[seed // 4 % 3 == 2].with_values(_sizes(random, seed))
            for cell in cell_catalogue(design, lay_out(design)).distinct:
                check_cell(cell_atlas(), cell, FREQUENCY, design_air(design))
        except Refusal:
            continue
        return design


def _between(random: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def _sizes(random: np.random.Generator, seed: int) -> dict[str, Any]:
    kind, ring = seed % 4, seed // 4 % 3 == 2
    other = _between(random, 0.2, 1.1)
    bore = other * random.uniform(0.5, 1.6) if kind == 1 else other
    shells, rooms = BOUNDS["resonator"], BOUNDS["microphone"]
    wide = max(bore, other) / 2
    radius = wide / _between(random, *shells["bore by cavity diameter"])
    above = wide / _between(random, *shells["bore radius by distance of its axis from the ceiling"])
    floor = _between(random, *shells["bore radius by height of its axis above the floor"])
    below = wide / floor if kind == 2 else above
    chamber = other / 2 / _between(random, *rooms["bore by cavity diameter"])
    tall = other / _between(random, *rooms["bore radius by height of its axis above the floor"])
    hole = chamber * _between(random, *rooms["sound hole by chamber diameter"])
    points = 2 if kind == 1 else int(random.integers(6 if kind == 3 else 2, 13))
    length = _between(random, 6.0, 30.0)
    values = {
        "name": f"held-out-{seed}",
        "resonator.cavity_diameter": 2 * radius,
        "resonator.cavity_height": above + below,
        "resonator.port_height": below,
        "membrane.thickness": 2 * radius * _between(random, 0.05, 0.2),
        "tube.inner_diameter": bore,
        "tube.outer_diameter": bore + 0.3,
        "tube.length": length,
        "microphone_tube.inner_diameter": other,
        "microphone_tube.outer_diameter": other + 0.3,
        "microphone_tube.length": _between(random, 6.0, 30.0),
        "microphone.chamber_diameter": 2 * chamber,
        "microphone.chamber_height": tall,
        "microphone.sound_hole_diameter": 2 * hole,
        "microphone.sound_hole_length": 2 * hole * random.uniform(0.4, 1.2),
        "air.temperature": random.uniform(0, 40),
        "air.pressure": random.uniform(7e4, 1.05e5),
    }
    values = {name: round(float(v), 3) if name != "name" else v for name, v in values.items()}
    if ring:
        return values | {f"lines.{k}.points": max(2, points // 3) for k in range(3)}
    rows = {"lines.0.points": points, "layout.columns": -(-points // 2) if kind == 3 else points}
    if kind == 3:
        straight = 2 * radius + length
        rows["layout.pitch"] = round(straight * random.uniform(0.45, 1.0), 3)
    return values | rows


def main() -> None:
    """Solve the cells of all held-out designs, one after the other."""
    for seed in range(FIRST_SEED, FIRST_SEED + COUNT):
        design = random_design(seed)
        for cell in cell_catalogue(design, lay_out(design)).distinct:
            with warnings.catch_warnings():
                warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
                solved = solve_cells([cell], FREQUENCY, design_air(design))[cell]
            print(f"{seed} {cell.label}: {solved.seconds:.1f} s, mesh error {solved.mesh_error:.1e}", flush=True)


if __name__ == "__main__":
    main()
